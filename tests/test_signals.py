"""Signals end the program in order; its children and what it has not completed end with it."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from kitemj.cli import main
from kitemj.commands import reach
from kitemj.last_resort import reporting
from kitemj.signals import held, orderly

ROOT = Path(__file__).parents[1]
PATIENCE = 30.0
"""s; for what takes milliseconds on a machine that has nothing else to do."""

pytestmark = [
    pytest.mark.skipif(os.name == "nt", reason="Windows has no such signals"),
    pytest.mark.usefixtures("obeyed"),
]


def send(*numbers: int) -> None:
    for number in numbers:
        os.kill(os.getpid(), number)


@pytest.mark.parametrize(("number", "status"), [("INT", 130), ("TERM", 143), ("HUP", 129)])
def test_a_signal_interrupts_and_the_status_tells_which(
    number: str, status: int, capsys: pytest.CaptureFixture[str]
) -> None:
    before = signal.getsignal(signal.SIGTERM)
    completed = []

    @orderly
    def main(words: object) -> int:
        try:
            send(getattr(signal, f"SIG{number}"))
        finally:
            completed.append(words)
        raise AssertionError("it went on")

    assert main("words") == status
    assert completed == ["words"]
    assert capsys.readouterr().err == "kitemj: interrupted; nothing was written\n"
    assert signal.getsignal(signal.SIGTERM) is before


def test_what_follows_a_signal_does_not_disturb_the_end() -> None:
    """A closed terminal hangs up twice, and a system that shuts down terminates besides."""

    @orderly
    def main(words: object) -> int:
        try:
            send(signal.SIGHUP)
        except KeyboardInterrupt:
            send(signal.SIGHUP, signal.SIGTERM)
        return 0

    assert main() == 129


def test_a_program_that_is_to_survive_the_terminal_does() -> None:
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:

        @orderly
        def main(words: object) -> int:
            send(signal.SIGHUP)
            return 0

        assert main() == 0
    finally:
        signal.signal(signal.SIGHUP, before)


def test_what_must_not_be_cut_is_done_before_the_interrupt() -> None:
    done = []

    @orderly
    def main(words: object) -> int:
        try:
            with held():
                with held():
                    send(signal.SIGTERM)
                done.append("whole")
            done.append("beyond")
        except KeyboardInterrupt:
            done.append("interrupted")
        return 0

    assert main() == 143
    assert done == ["whole", "interrupted"]


def test_an_interrupt_while_something_is_thrown_away_is_not_lost() -> None:
    """Python itself passes over whatever is raised there."""

    class Thrown:
        def __del__(self) -> None:
            send(signal.SIGTERM)

    signal.signal(signal.SIGINT, signal.SIG_IGN)  # as of a program in the background

    @orderly
    def main(words: object) -> int:
        with reporting([]):
            thrown: Thrown | None = Thrown()
            del thrown
            time.sleep(PATIENCE)
        raise AssertionError("it went on")

    assert main() == 143


def test_a_lost_interrupt_does_not_come_when_all_is_over() -> None:
    class Thrown:
        def __del__(self) -> None:
            send(signal.SIGTERM)

    @orderly
    def main(words: object) -> int:
        with reporting([]):
            thrown: Thrown | None = Thrown()
            del thrown
            return 0

    try:
        assert main() == 143
        time.sleep(0.1)
    except KeyboardInterrupt:
        pytest.fail("it came too late")


def test_what_an_interrupt_became_is_no_fault_of_the_program(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def run(words: object) -> int:
        try:
            send(signal.SIGTERM)
        except KeyboardInterrupt:
            raise RuntimeError("a callback failed") from None
        return 0

    monkeypatch.setattr(reach, "run", run)
    assert main(["reach"]) == 143
    assert capsys.readouterr().err == "kitemj: interrupted; nothing was written\n"


EXECUTING = """
import sys
from kitemj.signals import orderly
@orderly
def main(words):
    exec("import os, signal; os.kill(os.getpid(), signal.SIGTERM); os.getpid()")
sys.exit(main())
"""


def test_an_interrupt_while_text_is_executed_gives_the_same_status(tmp_path: Path) -> None:
    """As in imports, which make tuples and data classes of it; Python looks at it after -m."""
    (tmp_path / "executing.py").write_text(EXECUTING, encoding="utf-8")
    words = [sys.executable, "-m", "executing"]
    found = {**os.environ, "PYTHONPATH": os.pathsep.join(map(str, (tmp_path, ROOT)))}
    assert subprocess.run(words, env=found, check=False).returncode == 143


INTERRUPTED = """
import os, signal, sys, threading
from thesis.forced_response import ForcedLagrange, SineSteering, trimmed
from kitemj.physics.parameter_files import parameter_set
from kitemj.signals import orderly
@orderly
def main(words):
    parameters, swing = parameter_set("thesis"), SineSteering(0.05, 1.0)
    kite, x = ForcedLagrange(parameters, swing), trimmed(parameters)[0]
    kite.flow(x, None, swing.period, 200)
    threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGTERM)).start()
    while True:
        kite.flow(x, None, swing.period, 5000)
sys.exit(main())
"""


def test_a_signal_during_compiled_code_is_as_any_other() -> None:
    """There Python code runs first where a named tuple is made of the result."""
    paths = f"{ROOT}{os.pathsep}{ROOT / 'scripts'}"
    done = subprocess.run(
        [sys.executable, "-c", INTERRUPTED], env=os.environ | {"PYTHONPATH": paths}, timeout=120
    )
    assert done.returncode == 128 + signal.SIGTERM


def killed(script: str, folder: Path) -> str:
    """What a program says that kills itself."""
    path = folder.parent / "killed.py"
    path.write_text(f"import os, sys, time\n{script}")
    done = subprocess.run(
        [sys.executable, path],
        cwd=folder,
        stdout=subprocess.PIPE,
        text=True,
        timeout=PATIENCE,
        env=os.environ | {"PYTHONPATH": f"{ROOT}{os.pathsep}{ROOT / 'scripts'}"},
    )
    assert done.returncode == -signal.SIGKILL
    return done.stdout


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    folder = tmp_path / "folder"
    folder.mkdir()
    return folder


@pytest.mark.skipif(not hasattr(os, "O_TMPFILE"), reason="files need a name on this system")
def test_of_a_file_that_a_killed_program_wrote_nothing_is_left(folder: Path) -> None:
    killed(
        """
from pathlib import Path
from kitemj.files import new_file
with new_file(Path("a.csv")) as part:
    part.write_text("t,x")
    os.kill(os.getpid(), 9)
""",
        folder,
    )
    assert list(folder.iterdir()) == []


def test_a_folder_of_a_killed_program_goes_with_it(folder: Path) -> None:
    killed(
        """
from pathlib import Path
from thesis.folder import new_folder
with new_folder(Path("report")) as part:
    (part / "index.html").touch()
    os.kill(os.getpid(), 9)
""",
        folder,
    )
    until = time.monotonic() + PATIENCE
    while list(folder.iterdir()) and time.monotonic() < until:
        time.sleep(0.02)
    assert list(folder.iterdir()) == []


def test_a_child_ends_with_a_killed_program_though_it_never_listens(folder: Path) -> None:
    said = killed(
        """
import kitemj.child
kitemj.child.GRACE = 0.1
def work(link):
    kitemj.child.end_with_parent(0.1)
    link.send("begun")
    time.sleep(60)
if __name__ == "__main__":
    child = kitemj.child.Child(work)
    child.link.recv()
    print(child.pid, flush=True)
    os.kill(os.getpid(), 9)
""",
        folder,
    )
    until = time.monotonic() + PATIENCE
    while Path(f"/proc/{int(said)}").exists() and time.monotonic() < until:
        time.sleep(0.02)
    assert not Path(f"/proc/{int(said)}").exists()
