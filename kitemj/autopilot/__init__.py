"""A machine that flies the kite: its turning identified, paths on the sphere, sensors, phases."""
