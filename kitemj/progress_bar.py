"""A bar while something long is done: on a terminal or in a notebook, and nowhere else."""

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import TypeVar

T = TypeVar("T")


@contextmanager
def progress_bar(label: str, total: float, done: float = 0) -> Iterator[Callable[[float], None]]:
    """What is called with how much of `total` is done; the bar, on stderr, ends with the block."""
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TimeRemainingColumn

    console = Console(stderr=True)
    watched = console.is_terminal or console.is_jupyter
    if console.is_jupyter:  # rich asks for a package of widgets there; one line needs none
        console = Console(stderr=True, force_jupyter=False, force_terminal=True, width=80)
    if not watched:
        yield lambda amount: None
        return
    columns = (label, MofNCompleteColumn(), BarColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task("", total=total, completed=int(done))
        yield lambda amount: bar.update(task, completed=amount)


def with_progress(label: str, things: Iterable[T], total: int) -> Iterator[T]:
    """`things`, of which there are `total`, one after the other."""
    with progress_bar(label, total) as tell:
        for number, thing in enumerate(things):
            tell(number)
            yield thing
