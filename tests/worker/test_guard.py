"""The guard between the supervisor and a child."""

import os
import signal
import sys
import time
from pathlib import Path

import pytest

from backend.supervisor.child import Child

# deaf to SIGTERM, with a child of its own that is deaf too
DEAF = """
import os, signal, sys, time
signal.signal(signal.SIGTERM, signal.SIG_IGN)
pid = os.fork()
if pid:
    open(sys.argv[1], "w").write(f"{os.getpid()} {pid}")
time.sleep(float(sys.argv[2]) if pid else 60)
"""


def start(folder: Path, *, lives_s: float, grace_s: float) -> tuple[Child, list[int]]:
    note = folder / "pids"
    command = [sys.executable, "-c", DEAF, str(note), str(lives_s)]
    child = Child("deaf", command, {}, folder / "deaf.log", grace_s)
    child.start()
    deadline = time.monotonic() + 20
    while not (note.exists() and " " in note.read_text()):
        assert time.monotonic() < deadline
        time.sleep(0.02)
    return child, [int(pid) for pid in note.read_text().split()]


def alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    # a zombie that nobody has collected yet is dead
    return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"


def wait_until_dead(pids: list[int]) -> None:
    deadline = time.monotonic() + 5
    while any(alive(pid) for pid in pids):
        assert time.monotonic() < deadline, "an orphan is left"
        time.sleep(0.02)


def test_what_does_not_end_in_its_grace_is_killed_with_its_children(tmp_path: Path) -> None:
    child, pids = start(tmp_path, lives_s=60, grace_s=0.5)
    child.ask_to_end()
    assert child.wait(10)
    wait_until_dead(pids)


def test_a_second_order_does_not_wait_for_the_grace(tmp_path: Path) -> None:
    child, pids = start(tmp_path, lives_s=60, grace_s=50)
    child.ask_to_end()
    assert not child.wait(0.5)
    child.kill()
    assert child.wait(5)
    wait_until_dead(pids)


def test_a_command_that_ends_takes_what_it_started_with_it(tmp_path: Path) -> None:
    child, pids = start(tmp_path, lives_s=0.1, grace_s=50)
    assert child.wait(10)
    wait_until_dead(pids)


@pytest.mark.parametrize("code", [0, 3])
def test_the_lifeline_closes_when_its_owner_is_killed(tmp_path: Path, code: int) -> None:
    owner = os.fork()
    if owner == 0:  # a supervisor that dies without a word
        start(tmp_path, lives_s=60, grace_s=0.3)
        os._exit(code) if code else os.kill(os.getpid(), signal.SIGKILL)
    os.waitpid(owner, 0)
    wait_until_dead([int(pid) for pid in (tmp_path / "pids").read_text().split()])
