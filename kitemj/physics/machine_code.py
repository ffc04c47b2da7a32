"""Machine code on disk, a file for each formula and signature: current, whole, ours, or a miss.

numba's own cache notices a change in a formula's own file only, keeps machine code beside the
sources where its folder cannot be written, and breaks off where a file of it is damaged.
"""

import hashlib
import os
import pickle
import sys
import tempfile
from contextlib import suppress
from pathlib import Path
from typing import Any

import numba
from numba.core.caching import NullCache
from numba.core.compiler import CompileResult
from numba.core.serialize import dumps

from kitemj.physics.code_folder import code_folder, complain, owner
from kitemj.physics.fingerprint import classes_of, fingerprint

_rebuilt: Any = CompileResult._rebuild
_pickled: Any = dumps
DIGEST = hashlib.sha256().digest_size


class MachineCode(NullCache):  # the verbs that a formula's compiler calls
    """What was kept of `formula`, and where the compiler's work on it is kept."""

    def __init__(self, formula: Any) -> None:
        self._formula, self._folder = formula, code_folder()

    def load_overload(self, signature: Any, context: Any) -> Any:
        """The compiled formula for `signature`; None where it has to be compiled."""
        context.refresh()
        if self._folder is None:
            return None
        try:
            kept = _read(self._file(self._folder, signature, context.codegen()))
            return _rebuilt(context, *pickle.loads(kept))
        except Exception:  # whatever is wrong with a file: it is written anew
            return None

    def save_overload(self, signature: Any, result: Any) -> None:
        """Keeps a compiled formula, unless it is made of what the next process will not have."""
        ours = classes_of((*result.signature.args, result.signature.return_type))
        passing = result.library.has_dynamic_globals or not all(map(_lasts, ours))
        if self._folder is None or result.lifted or passing:
            return
        file = self._file(self._folder, signature, result.codegen)
        try:
            _write(file, _pickled(result._reduce()))
        except OSError as error:
            complain(self._folder, error.strerror or str(error))
            self._folder = None

    def _file(self, folder: Path, signature: Any, codegen: Any) -> Path:
        machine = (sys.version, numba.__version__, codegen.magic_tuple())
        code = fingerprint(self._formula, signature)
        key = hashlib.sha256(repr((machine, code)).encode()).hexdigest()
        return folder / f"{self._formula.__name__}-{key[:32]}"


def _lasts(kind: type) -> bool:
    """Whether a process that imports the same finds this very class: not one of a notebook."""
    module = sys.modules.get(kind.__module__)
    return kind.__module__ != "__main__" and getattr(module, kind.__qualname__, None) is kind


def _read(file: Path) -> bytes:
    """What `_write` wrote; raises OSError or ValueError where that is not what is there."""
    with file.open("rb") as stream:
        if os.fstat(stream.fileno()).st_uid != owner():
            raise ValueError("somebody else's")
        digest, content = stream.read(DIGEST), stream.read()
    if digest != hashlib.sha256(content).digest():
        raise ValueError("damaged")
    return content


def _write(file: Path, content: bytes) -> None:
    descriptor, name = tempfile.mkstemp(dir=file.parent)
    part = Path(name)
    try:
        with os.fdopen(descriptor, "wb") as stream:
            stream.write(hashlib.sha256(content).digest() + content)
        part.replace(file)
    except BaseException:
        with suppress(OSError):
            part.unlink()
        raise
