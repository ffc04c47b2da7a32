"""Starts the flight's process before anything heavy is loaded, so that both load side by side."""

from multiprocessing.connection import Connection

from kitemj.child import Child
from kitemj.physics.code_folder import code_folder
from kitemj.registry import own_modules, use


def launch() -> Child:
    """A process that waits for a `FlightSetup`, and then sends the news of that flight."""
    code_folder()  # settled here, not by both
    return Child(_run, own_modules())


def _run(link: Connection, modules: tuple[str, ...]) -> None:
    from kitemj.dynamics import lagrange_kite, mujoco_kite  # noqa: F401  while nobody waits yet
    from kitemj.realtime.worker import fly

    for module in modules:
        use(module)
    fly(link)
