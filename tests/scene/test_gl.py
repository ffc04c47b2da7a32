"""OpenGL is found, or one sentence says how to get it."""

import platform
import subprocess
import sys
from pathlib import Path

import pytest

from kitemj.scene import gl
from kitemj.scene.gl import NoGraphics, candidates


def test_mujoco_gl_is_respected_and_explained() -> None:
    assert candidates("", "Linux") == ["egl", "osmesa"]
    assert candidates("osmesa", "Linux") == ["osmesa"]
    assert candidates("", "Darwin") == ["cgl"]
    assert candidates("", "Windows") == ["glfw"]
    with pytest.raises(NoGraphics, match="switched off by MUJOCO_GL=off"):
        candidates("off", "Linux")
    with pytest.raises(NoGraphics, match="MUJOCO_GL=vulkan is not known"):
        candidates("vulkan", "Linux")


@pytest.mark.parametrize(
    ("family", "command"),
    [
        ({"ID": "debian"}, "apt-get install -y libegl1 libgl1"),
        ({"ID": "mint", "ID_LIKE": "ubuntu debian"}, "apt-get install -y libegl1 libgl1"),
        ({"ID": "fedora"}, "dnf install -y mesa-libEGL mesa-libGL"),
        ({}, "install Mesa's EGL and GL libraries"),
    ],
)
def test_without_opengl_one_sentence_names_the_remedy(
    monkeypatch: pytest.MonkeyPatch, family: dict[str, str], command: str
) -> None:
    monkeypatch.delenv("MUJOCO_GL", raising=False)
    monkeypatch.setattr(platform, "system", lambda: "Linux")
    monkeypatch.setattr(platform, "freedesktop_os_release", lambda: family)
    monkeypatch.setattr(gl, "_renderer", lambda backend: None)
    with pytest.raises(NoGraphics, match=command) as raised:
        gl.open_graphics(640, 360)
    assert "\n" not in str(raised.value)


def test_a_good_answer_is_kept_and_a_bad_one_asked_again(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    answers = iter([None, "a card", "another card"])
    monkeypatch.setattr(gl, "user_cache_path", lambda name: tmp_path / name)
    monkeypatch.setattr(gl, "_probe", lambda backend: next(answers))
    assert gl._renderer("egl") is None
    assert gl._renderer("egl") == "a card"
    assert gl._renderer("egl") == "a card"
    monkeypatch.setenv("LIBGL_ALWAYS_SOFTWARE", "1")
    assert gl._renderer("egl") == "another card"


def test_an_answer_that_has_become_wrong_is_forgotten(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(gl, "user_cache_path", lambda name: tmp_path / name)
    monkeypatch.setattr(gl, "_probe", lambda backend: "a card" if backend == "egl" else None)
    monkeypatch.setattr(platform, "system", lambda: "Linux")
    monkeypatch.delenv("MUJOCO_GL", raising=False)

    def gone(name: str) -> None:
        raise ImportError(f"{name} is not there any more")

    monkeypatch.setattr(gl, "import_module", gone)
    with pytest.raises(NoGraphics):
        gl.open_graphics(640, 360)
    assert not list(tmp_path.rglob("graphics.json"))


def test_physics_imports_mujoco_where_mujoco_gl_names_what_is_missing() -> None:
    code = (
        "import os; os.environ['MUJOCO_GL'] = 'nonsense'\n"
        "from kitemj.mujoco_import import mujoco\n"
        "assert os.environ['MUJOCO_GL'] == 'nonsense'; mujoco.MjSpec()"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
