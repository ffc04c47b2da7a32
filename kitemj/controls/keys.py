"""The action of each key of the keyboard, in flight and while a recording is shown."""

import pygame

from kitemj.controls.actions import INSTRUMENTS

DIGITS_AND_L = (*range(pygame.K_1, pygame.K_9 + 1), pygame.K_0, pygame.K_l)
TOGGLES = {key: f"toggle {name}" for key, name in zip(DIGITS_AND_L, INSTRUMENTS, strict=True)}
"""Keys that show or hide one instrument, in their order on the screen."""

HELP_KEYS = (pygame.K_F1, pygame.K_SLASH, pygame.K_QUESTION)

KEYS = {
    pygame.K_r: "restart",
    pygame.K_BACKSPACE: "rewind",
    pygame.K_F5: "save",
    pygame.K_F9: "load",
    pygame.K_SPACE: "pause",
    pygame.K_PERIOD: "step",
    **dict.fromkeys((pygame.K_MINUS, pygame.K_KP_MINUS), "slower"),
    **dict.fromkeys((pygame.K_EQUALS, pygame.K_PLUS, pygame.K_KP_PLUS), "faster"),
    pygame.K_t: "law",
    pygame.K_y: "two sticks",
    pygame.K_h: "assist",
    pygame.K_p: "autopilot",
    pygame.K_o: "figure",
    pygame.K_v: "view",
    pygame.K_i: "instruments",
    **dict.fromkeys((pygame.K_F11, pygame.K_f), "full screen"),
    pygame.K_m: "sound",
    pygame.K_g: "watch",
    pygame.K_n: "next lesson",
    pygame.K_b: "begin lesson",
    **dict.fromkeys(HELP_KEYS, "help"),
    pygame.K_ESCAPE: "leave",
    **TOGGLES,
}

REPLAY_KEYS = {
    **dict.fromkeys(HELP_KEYS, "help"),
    pygame.K_SPACE: "play",
    pygame.K_LEFT: "back",
    pygame.K_RIGHT: "on",
    pygame.K_UP: "faster",
    pygame.K_DOWN: "slower",
    pygame.K_HOME: "start",
    pygame.K_END: "end",
    pygame.K_v: "view",
    pygame.K_i: "instruments",
    pygame.K_m: "sound",
    **dict.fromkeys((pygame.K_F11, pygame.K_f), "full screen"),
    pygame.K_ESCAPE: "leave",
}
"""While a recording is shown."""

MENU_KEYS = {
    **dict.fromkeys((pygame.K_UP, pygame.K_w), "up"),
    **dict.fromkeys((pygame.K_DOWN, pygame.K_s), "down"),
    **dict.fromkeys((pygame.K_LEFT, pygame.K_a), "left"),
    **dict.fromkeys((pygame.K_RIGHT, pygame.K_d), "right"),
    **dict.fromkeys((pygame.K_RETURN, pygame.K_KP_ENTER, pygame.K_SPACE), "choose"),
    pygame.K_m: "sound",
    **dict.fromkeys((pygame.K_F11, pygame.K_f), "full screen"),
    pygame.K_ESCAPE: "leave",
}
"""On the title page."""
