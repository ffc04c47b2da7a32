"""What a person steers with: sticks, pads, keys, tables, and what each asks for."""

import os

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")  # read when pygame is first imported
