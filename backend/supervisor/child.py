"""One supervised command: started behind a guard, started again when it ends, ended for good."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

_GUARD = Path(__file__).with_name("guard.py")
_FIRST_PAUSE_S, _LONGEST_PAUSE_S = 0.2, 10.0
_SETTLED_S = 60.0  # a child that lived this long starts with a clean record
_MOST_ENDINGS = 6  # in a row, none of them settled
_KILLED = 128 + signal.SIGKILL  # by a person, or by a machine without memory: it can live
_LOG_BYTES = 5_000_000


class ChildGaveUpError(Exception):
    """A child ended too often; the message names it and quotes its log."""


@dataclass
class Child:
    """``command`` with extra ``environment``, writing to ``log``. ``grace_s``: time to end in
    order; ``ended`` is called after each unasked end; ``inherit``: descriptors the guard keeps."""

    name: str
    command: Sequence[str]
    environment: Mapping[str, str]
    log: Path
    grace_s: float
    nice: int = 0
    inherit: tuple[int, ...] = ()
    ended: Callable[[], None] = lambda: None
    say: Callable[[str], None] = print
    _guard: subprocess.Popen[bytes] | None = None
    _lifeline: int | None = None
    _started_at: float = 0.0
    _start_at: float = 0.0
    _endings: list[int] = field(default_factory=list[int])

    def start(self) -> None:
        """Start the command behind its guard."""
        self.log.parent.mkdir(parents=True, exist_ok=True)
        if self.log.exists() and self.log.stat().st_size > _LOG_BYTES:
            self.log.replace(self.log.with_suffix(".log.1"))
        reading, self._lifeline = os.pipe()
        try:
            with self.log.open("ab") as log:
                self._guard = subprocess.Popen(
                    [sys.executable, "-I", str(_GUARD), str(reading), str(self.grace_s),
                     str(self.nice), *self.command],
                    env={**os.environ, **self.environment}, stdin=subprocess.DEVNULL,
                    stdout=log, stderr=log, start_new_session=True,
                    pass_fds=(reading, *self.inherit),
                )  # fmt: skip
        finally:
            os.close(reading)
        self._started_at = time.monotonic()

    def tend(self) -> None:
        """Start again what has ended, with growing pauses. Raises ChildGaveUpError at last."""
        now = time.monotonic()
        if self._guard is None:
            if now >= self._start_at:
                self.start()
            return
        code = self._guard.poll()
        if code is None:
            return
        self._forget()
        if now - self._started_at > _SETTLED_S:
            self._endings.clear()
        self._endings.append(code)
        self.ended()
        failures = [each for each in self._endings if each != _KILLED]
        if len(failures) >= _MOST_ENDINGS:
            raise ChildGaveUpError(
                f"{self.name} ended {len(failures)} times, last with code {failures[-1]}. "
                f"The end of {self.log}:\n{self._tail()}"
            )
        pause = min(_FIRST_PAUSE_S * 2 ** min(len(self._endings) - 1, 20), _LONGEST_PAUSE_S)
        self._start_at = now + pause
        self.say(f"{self.name} ended with code {code}; starting it again (log: {self.log})")

    def ask_to_end(self) -> None:
        """Begin an orderly end."""
        self._order(b"e")

    def kill(self) -> None:
        """End at once, also in the middle of an orderly end."""
        self._order(b"k")

    def wait(self, timeout_s: float) -> bool:
        """Whether it has ended within the time."""
        if self._guard is None:
            return True
        try:
            self._guard.wait(timeout_s)
        except subprocess.TimeoutExpired:
            return False
        self._forget()
        return True

    def _order(self, order: bytes) -> None:
        if self._lifeline is not None:
            with suppress(BrokenPipeError):  # the guard has just ended by itself
                os.write(self._lifeline, order)

    def _forget(self) -> None:
        self._guard = None
        if self._lifeline is not None:
            os.close(self._lifeline)
            self._lifeline = None

    def _tail(self) -> str:
        with self.log.open("rb") as log:
            log.seek(max(0, self.log.stat().st_size - 2000))
            return log.read().decode(errors="replace")
