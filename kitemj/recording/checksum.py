"""Checksums that run through a recording, so that damage is noticed, and from where on.

The file stays an Arrow IPC stream, which other programs read as ever. Each batch says in its
custom metadata a CRC-32 of all its bytes, framing and padding too (its own eight digits taken as
zeros), begun with that of the batch before; the first one is of the header and the schema too.
"""

from itertools import pairwise
from typing import NamedTuple
from zlib import crc32

import pyarrow as pa

ABOUT = {b"checksum": b"crc32=00000000"}
"""Metadata that a batch is made with, before its bytes are known; first of all, so that it stands
last in them, after any text that looks like it."""
NAME = b"crc32="
MARK = b"\x0e\x00\x00\x00" + NAME
"""How Arrow writes that: its length, then the text."""
ZEROS = b"00000000"
END = b"\xff\xff\xff\xff\x00\x00\x00\x00"
"""How a stream that was closed ends."""


class Sound(NamedTuple):
    """How many bytes of a file are sound, up to the end of a batch; whether damage follows.

    Half a batch that follows was cut, which is no damage.
    """

    size: int
    damaged: bool


def sealed(message: bytes, before: int) -> tuple[bytes, int]:
    """`message` with its checksum in it, and that checksum; `before` is the previous one, or 0."""
    seal = crc32(message, before)
    at = message.rfind(MARK) + len(MARK)
    return b"%b%08x%b" % (message[:at], seal, message[at + len(ZEROS) :]), seal


def sound_part(data: bytes) -> Sound:
    """What of a file's bytes can be trusted; a file without any checksum is taken at its word."""
    ends = [0, *_ends(data)]
    if MARK not in data:
        return Sound(ends[-1], damaged=False)
    seal = 0
    for start, end in pairwise(ends):
        at = data.rfind(MARK, start, end) + len(MARK)
        first, last = at, at + len(ZEROS)
        seal = crc32(data[last:end], crc32(ZEROS, crc32(data[start:first], seal)))
        if data[first:last] != b"%08x" % seal:
            return Sound(start, damaged=True)
    rest = data[ends[-1] :]
    # what was cut is one batch at most, and has no end
    more = rest.count(NAME) > 1 or (rest != END and END in (rest[:8], rest[-8:]))
    return Sound(ends[-1], damaged=more)


def _ends(data: bytes) -> list[int]:
    """Where each whole batch ends."""
    stream, ends = pa.BufferReader(data), []
    try:
        pa.ipc.read_message(stream)  # the schema
        while True:
            pa.ipc.read_message(stream)
            ends.append(stream.tell())
    except (EOFError, pa.ArrowException, OSError):
        return ends
