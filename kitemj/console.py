"""Standard output and error: any letter can be printed, and what they refuse shows in time."""

import codecs
import io
import os
import sys
import unicodedata

SPELLING = "kitemj.spelling"
"""Python's name for our way with letters that an encoding lacks."""
SPELT = {
    **{"µ": "u", "\N{MINUS SIGN}": "-", "─": "-", "·": ".", "×": "x", "→": "->", "°": " deg"},
    **{"±": "+-", "≤": "<=", "≥": ">=", "≈": "~", "∞": "inf", "₋": "-", "√": "sqrt "},
    **{"\N{COMBINING DOT ABOVE}": "_dot", "\N{COMBINING DIAERESIS}": "_ddot"},
}
"""What neither the letter's decomposition nor its name says in ASCII."""
LONGEST = 1000
"""Characters of a complaint; a value that makes it longer tells nobody anything."""


def take_any_letter() -> None:
    """From now on a letter that the streams' encoding lacks, ASCII or cp1252, is spelt out."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors=SPELLING)


def printable(text: str) -> str:
    """`text` as standard output shows it."""
    encoding = getattr(sys.stdout, "encoding", None) or "utf-8"
    return text.encode(encoding, SPELLING).decode(encoding)


def complain(text: str) -> None:
    """One line on standard error, whatever is in `text`."""
    line = " ".join(text.split())
    if len(line) > LONGEST:
        line = f"{line[: LONGEST // 2]} ... {line[-LONGEST // 2 :]}"
    if sys.stderr is not None:
        print(f"kitemj: {line}", file=sys.stderr)


def flush() -> None:
    """Raises the OSError for what standard output could not take, not only when Python ends."""
    if sys.stdout is not None:
        sys.stdout.flush()


def let_go() -> None:
    """What standard output still does not take goes nowhere: the end of Python is silent."""
    try:
        flush()
    except (OSError, ValueError):  # refused, or closed
        try:
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        except (OSError, ValueError):
            sys.stdout = None


def _spelling(error: UnicodeError) -> tuple[str, int]:
    """The letters that cannot be encoded in ASCII, and where to go on."""
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return "".join(map(_spelt, error.object[error.start : error.end])), error.end


def _spelt(letter: str) -> str:
    """α is alpha, ₂ is 2, and what nobody can spell is a question mark."""
    if letter in SPELT:
        return SPELT[letter]
    plain = unicodedata.normalize("NFKD", letter).encode("ascii", "ignore").decode()
    name = unicodedata.name(letter, "")
    if not plain and name.startswith("GREEK"):
        plain = name.split()[-1].capitalize() if "CAPITAL" in name else name.split()[-1].lower()
    return plain or "?"


codecs.register_error(SPELLING, _spelling)
