"""How a kite turns: the law of turning, its identification, the gains and hands that follow."""
