"""What acts on the kite: pure functions; no state, no engine."""
