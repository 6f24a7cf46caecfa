"""The data folder: prepared for one owner, and used by one supervisor at a time."""

import fcntl
import os
import time
from pathlib import Path

_WAIT_S = 12.0  # what a killed supervisor's guards need to end their children


class FolderInUseError(Exception):
    """Another supervisor runs on this data folder."""


class DataFolder:
    """Locked from :meth:`lock` on, for as long as this process or one of its guards lives.

    The lock is the open file's, so it needs no cleaning up after a crash.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.logs = path / "logs"
        self.queue = path / "queue"

    def lock(self) -> int:
        """Prepare and lock the folder; the descriptor is for the guards to keep open."""
        self.path.mkdir(mode=0o700, parents=True, exist_ok=True)
        descriptor = os.open(self.path / "supervisor.lock", os.O_RDWR | os.O_CREAT, 0o600)
        deadline = time.monotonic() + _WAIT_S
        while True:
            try:
                fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                owner = os.pread(descriptor, 200, 0).decode(errors="replace").split()
                if not _abandoned(owner) or time.monotonic() > deadline:
                    os.close(descriptor)
                    raise FolderInUseError(_refusal(self.path, owner)) from None
                time.sleep(0.1)
            else:
                self._descriptor = descriptor
                self.sign("")
                return descriptor

    def sign(self, address: str) -> None:
        """Leave this process and its address for whoever finds the folder locked."""
        os.ftruncate(self._descriptor, 0)
        os.pwrite(self._descriptor, f"{os.getpid()} {address}\n".encode(), 0)


def _abandoned(owner: list[str]) -> bool:
    """The process that took the lock is gone; only its guards still hold it."""
    if not owner:
        return False
    try:
        os.kill(int(owner[0]), 0)
    except ProcessLookupError:
        return True
    except PermissionError:
        return False
    return False


def _refusal(path: Path, owner: list[str]) -> str:
    where = f" at {owner[1]}" if len(owner) > 1 else ""
    who = f" (process {owner[0]})" if owner else ""
    return (
        f"Pneustudio already runs on {path}{where}{who}. "
        "Open that address, end it with Ctrl-C, or give another folder with --data."
    )
