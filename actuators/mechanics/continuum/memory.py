"""Memory: what a mesh will take before it is built, and what there is.

Measured on slabs, oblique bodies and bellows of 3,500 to 52,000 unknowns, assembled and factorised:
60 MiB and 8 kB an unknown; 322,000 unknowns of an oblique half took 4 GB. The factor grows faster
than the unknowns.
"""

import os
from pathlib import Path

from actuators.errors import QuestionError

FEW = 5e4
"""Unknowns above which the factor's growth shows."""
PER_UNKNOWN, ALWAYS = 9e3, 6e7
_IN_USE = Path("/proc/self/statm")
_MACHINE = Path("/proc/meminfo")
_ROOM = Path("/sys/fs/cgroup/memory.max")
_ROOM_IN_USE = Path("/sys/fs/cgroup/memory.stat")


def memory_needed(unknowns: int) -> float:
    """Memory [bytes] that a mesh of so many condensed unknowns takes once it is factorised."""
    return ALWAYS + PER_UNKNOWN * unknowns * max(1.0, unknowns / FEW) ** 0.25


def memory_in_use() -> float:
    """Memory of this process that is in use now [bytes]; 0 where the system does not tell."""
    try:
        pages = int(_IN_USE.read_text().split()[1])
    except (OSError, ValueError, IndexError):
        return 0.0
    return float(pages * os.sysconf("SC_PAGE_SIZE"))


def memory_free() -> float:
    """What the machine, or the container around this process, has left [bytes]; infinite where the
    system does not tell."""
    return min(_machine_free(), _container_free())


def refuse_what_does_not_fit(unknowns: int, room: float) -> None:
    """Raises :class:`QuestionError` where not even the coarsest mesh fits into ``room`` [bytes]."""
    needed = memory_needed(unknowns)
    if needed > room:
        raise QuestionError(
            f"the coarsest mesh of this body has {unknowns} unknowns and takes about "
            f"{needed / 2**20:.0f} MiB of memory; {max(room, 0.0) / 2**20:.0f} MiB may be used.",
            field="memory", value=f"{room / 2**20:.0f} MiB",
            mend="Use fewer chambers, a faster rung, or a machine with more free memory.",
        )  # fmt: skip


def _machine_free() -> float:
    try:
        lines = _MACHINE.read_text().splitlines()
        kib = next(line.split()[1] for line in lines if line.startswith("MemAvailable:"))
        return 1024.0 * int(kib)
    except (OSError, ValueError, StopIteration, IndexError):
        return float("inf")


def _container_free() -> float:
    """What a control group (version 2) leaves; what it can drop, files read, counts as free."""
    try:
        most = float(_ROOM.read_text())  # "max" is no number: no limit
        used = dict(line.split() for line in _ROOM_IN_USE.read_text().splitlines())
        return most - float(used["anon"])
    except (OSError, ValueError, KeyError):
        return float("inf")
