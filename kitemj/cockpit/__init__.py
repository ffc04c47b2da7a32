"""The programs: fly, film, the replay window, the measurement of real time."""

import os

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")  # read when pygame is first imported
