"""What is sent while a flight goes on, which never waits for whoever is told."""

import queue
from contextlib import suppress
from multiprocessing.connection import Connection
from threading import Thread

from kitemj.realtime.messages import Alive, End, News

BEAT = 0.5
"""s; a process that goes on is heard of this often."""


class Outbox:
    """A thread that sends what is put here, in order, until the `End`, or nobody is there."""

    def __init__(self, link: Connection) -> None:
        self._link, self._waiting = link, queue.SimpleQueue[News]()
        self._thread = Thread(target=self._run, name="outbox", daemon=True)

    def put(self, news: News) -> None:
        """Sends `news` soon; the thread begins with the first, as urgent as this one is by then."""
        self._waiting.put(news)
        if self._thread.ident is None:
            self._thread.start()

    def close(self) -> None:
        """Waits until all is sent, the `End` too."""
        self._thread.join()

    def _run(self) -> None:
        news: News = Alive()
        with suppress(OSError):  # nobody is left to hear
            while not isinstance(news, End):
                try:
                    news = self._waiting.get(timeout=BEAT)
                except queue.Empty:
                    news = Alive()
                self._link.send(news)
