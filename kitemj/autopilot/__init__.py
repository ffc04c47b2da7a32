"""A machine that flies the kite: sensors, observer, guidance, phases."""
