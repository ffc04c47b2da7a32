"""The colours of the instruments: red, green and blue (0..255)."""

Colour = tuple[int, int, int]
WHITE: Colour = (255, 255, 255)
DIM: Colour = (205, 212, 220)
LEFT: Colour = (255, 84, 84)  # the pilot's left, A₊, as on the kite
RIGHT: Colour = (104, 156, 255)
GOOD: Colour = (120, 220, 120)
BAD: Colour = (255, 70, 60)
ALARM: Colour = (176, 24, 20)
CALL: Colour = (255, 214, 60)
TROUGH: Colour = (40, 46, 54)
INK: Colour = (20, 22, 26)
