"""How far a guided flight is from instability: the loop opened at the stick, and laps in a row."""
