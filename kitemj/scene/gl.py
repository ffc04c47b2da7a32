"""OpenGL contexts: the first that works, or one sentence that says how to get one.

A broken driver may abort the whole process, so each candidate is tried in a process of its
own first. A good answer is kept on disk, keyed by whatever could change it; a bad one is
never kept, so that installing the missing library is all that is needed.
"""

import hashlib
import json
import os
import platform
import subprocess
import sys
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

from platformdirs import user_cache_path

from kitemj.errors import NoGraphics

PROBE = """
from importlib import import_module
import sys
context = import_module(sys.argv[1]).GLContext(16, 16)
context.make_current()
from OpenGL import GL
print("renderer:", GL.glGetString(GL.GL_RENDERER).decode())
context.free()
"""
PROBE_TIMEOUT = 20.0  # s, a cold start from a slow disk
SOFTWARE = ("llvmpipe", "softpipe", "swrast", "software", "gdi generic")
VARIABLES = (
    *("DISPLAY", "WAYLAND_DISPLAY", "MUJOCO_EGL_DEVICE_ID", "PYOPENGL_PLATFORM"),
    *("LIBGL_ALWAYS_SOFTWARE", "LIBGL_DRIVERS_PATH", "GALLIUM_DRIVER"),
    *("MESA_LOADER_DRIVER_OVERRIDE", "__EGL_VENDOR_LIBRARY_FILENAMES"),
    *("LD_LIBRARY_PATH", "LD_PRELOAD"),
)
OFF = ("disable", "disabled", "off", "false", "0")
ALIASES = {"glx": "glfw", "wgl": "glfw", "": "", "enable": "", "on": "", "true": "", "1": ""}


class Graphics(NamedTuple):
    """A context of OpenGL, not yet current, and what draws in it."""

    context: Any
    renderer: str

    @property
    def software(self) -> bool:
        """Whether the processor draws, so that every pixel's cost counts."""
        return any(name in self.renderer.lower() for name in SOFTWARE)


def open_graphics(width: int, height: int) -> Graphics:
    """The first context that works, of this size in pixels; NoGraphics when none does."""
    failures = []
    for backend in candidates(os.environ.get("MUJOCO_GL", ""), platform.system()):
        renderer = _renderer(backend)
        if renderer is not None:
            try:
                context = import_module(f"mujoco.{backend}").GLContext(width, height)
            except Exception:  # PyOpenGL raises what it likes; the kept answer was wrong
                _cache_file().unlink(missing_ok=True)
            else:
                return Graphics(context, renderer)
        failures.append(backend)
    asked = os.environ.get("MUJOCO_GL", "")
    what = f"MUJOCO_GL={asked}" if asked else f"OpenGL ({' and '.join(failures)})"
    raise NoGraphics(
        f"cannot draw: {what} does not work on this machine; {_remedy(failures)}{_limit()}"
    )


def candidates(asked: str, system: str) -> list[str]:
    """Names of the modules of mujoco to try, for the value of MUJOCO_GL and the system."""
    asked = asked.lower().strip()
    if asked in OFF:
        again = "run again with: env -u MUJOCO_GL"
        raise NoGraphics(f"drawing is switched off by MUJOCO_GL={asked}; {again}")
    chosen = ALIASES.get(asked, asked)
    known = {"Linux": ["egl", "osmesa", "glfw"], "Darwin": ["cgl", "glfw"]}.get(system, ["glfw"])
    if chosen and chosen not in known:
        use = f"use one of: {', '.join(known)}, or unset it"
        raise NoGraphics(f"MUJOCO_GL={asked} is not known on {system}; {use}")
    return [chosen] if chosen else known[: 2 if system == "Linux" else 1]


def _renderer(backend: str) -> str | None:
    """Name of what draws (GL_RENDERER), or None where this backend does not work."""
    cache, key, known = _cache_file(), _key(backend), None
    with suppress(OSError, ValueError):
        known = json.loads(cache.read_text())
    if isinstance(known, dict) and isinstance(known.get(key), str):
        return str(known[key])
    renderer = _probe(backend)
    if renderer is not None:
        with suppress(OSError):  # a home that cannot be written only costs the probe every time
            cache.parent.mkdir(parents=True, exist_ok=True)
            cache.write_text(json.dumps({key: renderer}))
    return renderer


def _cache_file() -> Path:
    return user_cache_path("kitemj") / "graphics.json"


def _probe(backend: str) -> str | None:
    env = {name: value for name, value in os.environ.items() if name != "MUJOCO_GL"}
    words = [sys.executable, "-c", PROBE, f"mujoco.{backend}"]
    try:
        done = subprocess.run(words, capture_output=True, text=True, timeout=PROBE_TIMEOUT, env=env)
    except (OSError, subprocess.TimeoutExpired):
        return None
    lines = [line for line in done.stdout.splitlines() if line.startswith("renderer: ")]
    return lines[0].removeprefix("renderer: ") if done.returncode == 0 and lines else None


def _key(backend: str) -> str:
    """A text that changes with the installed libraries, the graphics card and the display."""
    places = ("/etc/ld.so.cache", "/dev/dri", "/usr/share/glvnd/egl_vendor.d", sys.executable)
    stamps = []
    for place in places:
        try:
            stamps.append(Path(place).stat().st_mtime_ns)
        except OSError:
            stamps.append(0)
    facts = [backend, platform.node(), platform.release(), sys.prefix, *stamps]
    facts += [os.environ.get(name) for name in VARIABLES]
    return hashlib.sha256(repr(facts).encode()).hexdigest()[:16]


def _limit() -> str:
    """A word on the memory that this program may have, if limited: OpenGL gives no reason."""
    if sys.platform != "win32":
        import resource

        most, _ = resource.getrlimit(resource.RLIMIT_AS)
        if most != resource.RLIM_INFINITY:
            return f"; or {most / 1e9:.2g} GB of memory, the limit here (ulimit -v), are too little"
    return ""


def _remedy(failures: list[str]) -> str:
    """The command that installs what is missing on this system."""
    if platform.system() != "Linux":
        return "install the graphics driver of this computer, or fly without a picture"
    if failures == ["glfw"]:
        return "it needs a display: run with env -u MUJOCO_GL to draw without one"
    try:
        release = platform.freedesktop_os_release()
    except OSError:
        release = {}
    family = f"{release.get('ID', '')} {release.get('ID_LIKE', '')}".split()
    mesa = failures == ["osmesa"]
    if {"debian", "ubuntu"} & set(family):
        return f"run: apt-get install -y {'libosmesa6' if mesa else 'libegl1 libgl1'}"
    if {"fedora", "rhel"} & set(family):
        return f"run: dnf install -y {'mesa-libOSMesa' if mesa else 'mesa-libEGL mesa-libGL'}"
    return "install Mesa's EGL and GL libraries (libEGL.so.1 and libGL.so.1)"
