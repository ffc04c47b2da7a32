"""Starts the flight's process before anything heavy is loaded, so that both load side by side."""

from multiprocessing import get_context
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from typing import Any, NamedTuple

from kitemj.physics.code_folder import code_folder
from kitemj.registry import own_modules, use


class Launched(NamedTuple):
    """A process that waits for a `FlightSetup` through `link`; its news come through `told`."""

    process: BaseProcess
    link: Connection
    told: Any


def launch() -> Launched:
    """A new one; it ends by itself when this program does, or forgets it."""
    code_folder()  # settled here, not by both
    context = get_context("spawn")
    link, theirs = context.Pipe()
    told = context.Queue()
    given = (theirs, told, own_modules())
    process = context.Process(target=_run, args=given, name="physics", daemon=True)
    process.start()
    theirs.close()
    return Launched(process, link, told)


def _run(link: Connection, told: Any, modules: tuple[str, ...]) -> None:
    from kitemj.dynamics import lagrange_kite, mujoco_kite  # noqa: F401  while nobody waits yet
    from kitemj.realtime.worker import fly

    for module in modules:
        use(module)
    fly(link, told)
