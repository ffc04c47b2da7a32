"""The action of each key of the keyboard."""

import pygame

from kitemj.controls.actions import INSTRUMENTS

DIGITS_AND_L = (*range(pygame.K_1, pygame.K_9 + 1), pygame.K_0, pygame.K_l)
TOGGLES = {key: f"toggle {name}" for key, name in zip(DIGITS_AND_L, INSTRUMENTS, strict=True)}
"""Keys that show or hide one instrument, in their order on the screen."""

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
    pygame.K_v: "view",
    pygame.K_i: "instruments",
    **dict.fromkeys((pygame.K_F11, pygame.K_f), "full screen"),
    pygame.K_n: "next lesson",
    pygame.K_b: "begin lesson",
    **dict.fromkeys((pygame.K_F1, pygame.K_SLASH, pygame.K_QUESTION), "help"),
    pygame.K_ESCAPE: "leave",
    **TOGGLES,
}
