"""What runs in the flight's own process."""

from collections.abc import Iterator
from functools import partial
from multiprocessing.connection import Connection
from typing import Any

from kitemj.errors import InputError
from kitemj.realtime.autopilots import autopilots
from kitemj.realtime.messages import Begin, End, Ready, Stop, Wish
from kitemj.realtime.outbox import Outbox
from kitemj.realtime.pacer import Pacer, go_first
from kitemj.recording.live import FlightSetup


def fly(link: Connection) -> None:
    """All that the process does, from the setup on, which comes through `link`."""
    setup = _received(link)
    if not isinstance(setup, FlightSetup):
        return
    told = Outbox(link)
    try:
        end = _flown(setup, link, told)
    except InputError as error:
        end = End("none", error.args[0], bad_input=True)
    except Exception as error:
        end = End("none", str(error))
    told.put(end)
    told.close()


def _flown(setup: FlightSetup, link: Connection, told: Outbox) -> End:
    first = setup._replace(record=None).flight()
    first.warm_up()
    pilots, offers = autopilots(first)
    go_first()  # and with it all threads that begin from here on
    told.put(Ready(first.restart(setup.start), offers))
    if not isinstance(_received(link), Begin):
        return End("none")
    flight = setup.flight()
    try:
        ending, error = Pacer(flight, partial(_wishes, link), told.put, pilots).run(setup.past), ""
    except Exception as reason:  # whoever paints is told
        ending = error = str(getattr(reason, "reason", reason))
    return End(flight.close(ending), error, cut=flight.cut)


def _wishes(link: Connection) -> Iterator[Wish]:
    """Those that wait."""
    while link.poll():
        yield _received(link)


def _received(link: Connection) -> Any:
    """Waits for what comes next."""
    try:
        return link.recv()
    except (EOFError, OSError):  # whoever painted is gone
        return Stop("the program that showed it was ended")
