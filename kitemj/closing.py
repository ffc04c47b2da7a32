"""What holds something of the system gives it back at the end of a ``with``."""

from typing import Self


class Closing:
    """A context manager whose end, however it comes, is `close`."""

    def close(self) -> None:
        """Gives back what is held; may be called twice."""
        raise NotImplementedError

    def __enter__(self) -> Self:
        """The thing itself."""
        return self

    def __exit__(self, *error: object) -> None:
        """Closes it."""
        self.close()
