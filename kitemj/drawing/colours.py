"""The colours of the instruments: red, green and blue (0..255).

All text has a contrast of at least 4.5 : 1 (WCAG 2) on a plate over any picture. Left and right
have letters and places as well: no colour is the only sign of anything.
"""

Colour = tuple[int, int, int]
WHITE: Colour = (255, 255, 255)
DIM: Colour = (206, 214, 224)
LEFT: Colour = (255, 128, 116)  # the pilot's left, A₊, as on the kite
RIGHT: Colour = (128, 180, 255)
GOOD: Colour = (134, 226, 144)
BAD: Colour = (255, 84, 70)
ALARM: Colour = (164, 24, 22)
CALL: Colour = (255, 214, 84)
TROUGH: Colour = (100, 112, 128)
INK: Colour = (12, 17, 26)
