"""While the solver works: progress on standard error, and Ctrl-C."""

import signal
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from actuators.mechanics.continuum import Progress


class Interruptible:
    """While it lasts, the first Ctrl-C asks the solver to end with the path found so far; a second
    one stops at once."""

    def __enter__(self) -> Callable[[], bool]:
        self._asked = False
        self._before = signal.signal(signal.SIGINT, self._note)
        return lambda: self._asked

    def __exit__(self, *_: object) -> None:
        signal.signal(signal.SIGINT, self._before)

    def _note(self, *_: object) -> None:
        if self._asked:
            raise KeyboardInterrupt
        self._asked = True
        click.echo("Ending with what there is; Ctrl-C again stops at once.", err=True)


def show_progress() -> "Callable[[Progress], None]":
    """Progress on standard error: one line that changes on a terminal, else a line per percent."""
    on_terminal = sys.stderr.isatty()
    last = -1

    def tell(progress: "Progress") -> None:
        nonlocal last
        percent = int(100 * progress.fraction)
        text = f"{percent:3d} %  {progress.message}"
        if on_terminal:
            click.echo(f"\r\033[K{text}", nl=percent >= 100, err=True)
        elif percent > last:
            click.echo(text, err=True)
        last = percent

    return tell
