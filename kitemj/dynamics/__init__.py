"""How the kite moves: formulations that never import one another."""
