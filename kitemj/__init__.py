"""kitemj: a two-line kite in MuJoCo, flown in real time beside a Lagrangian reference."""
