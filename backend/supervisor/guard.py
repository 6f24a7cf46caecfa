"""Stands between the supervisor and one child, so that neither can leave the other's processes.

Run by path, with the standard library alone: ``guard.py LIFELINE GRACE NICE COMMAND...``. LIFELINE
is the reading end of a pipe whose writing end only the supervisor holds. When an "e" comes, or the
pipe closes for whatever reason, the command gets SIGTERM, GRACE seconds, then SIGKILL together with
everything it started; a "k" means SIGKILL at once. When the command ends by itself, what it started
is killed before the guard ends with the same code.
"""

import os
import select
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from contextlib import suppress

_POLL_S = 0.1


def main(arguments: Sequence[str]) -> int:
    """Exit code of the command; negative signals as 128 + number."""
    lifeline, grace_s, nice = int(arguments[0]), float(arguments[1]), int(arguments[2])
    # a handler, not SIG_IGN: the command must not inherit deafness
    for each in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        signal.signal(each, lambda *_: None)
    os.nice(nice)
    # a group of its own, so that it can be killed with all it started and the guard stays
    command = subprocess.Popen(arguments[3:], stdin=subprocess.DEVNULL, process_group=0)
    try:
        while command.poll() is None:
            if _readable(lifeline, _POLL_S):
                _end(command, lifeline, grace_s)
                break
    finally:
        _kill_group(command.pid)
    code = command.wait()
    return code if code >= 0 else 128 - code


def _end(command: subprocess.Popen[bytes], lifeline: int, grace_s: float) -> None:
    deadline = time.monotonic() + grace_s
    order = os.read(lifeline, 1)
    with suppress(ProcessLookupError):
        os.kill(command.pid, signal.SIGTERM)
    while order != b"k" and command.poll() is None and time.monotonic() < deadline:
        if order == b"":  # the supervisor is gone, no further order can come
            time.sleep(_POLL_S)
        elif _readable(lifeline, _POLL_S):
            order = os.read(lifeline, 1)


def _readable(descriptor: int, timeout_s: float) -> bool:
    return bool(select.select([descriptor], [], [], timeout_s)[0])


def _kill_group(group: int) -> None:
    with suppress(ProcessLookupError, PermissionError):
        os.killpg(group, signal.SIGKILL)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
