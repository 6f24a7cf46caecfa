"""The answer of a 3D solve in the whole body: a series of ``.vtu``, and how the path ended."""

import io
import json
import zipfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from actuators.export.vtu import collection, unstructured_grid
from actuators.mechanics.continuum.solve import Solution
from actuators.mechanics.continuum.volume_fields import VolumeFields

_QUICK = 1
"""zlib's level: the arrays inside are compressed, this takes back what their base64 adds."""


@dataclass(frozen=True)
class BodyArchive:
    """``zipped``: files of :class:`WholeBody` as one zip; ``points``: numbers of the path points
    that it holds, in order."""

    zipped: bytes
    points: tuple[int, ...]


class WholeBody:
    """``answer.pvd``, ``answer-000.vtu`` onwards, and ``answer.json``: how the path ended."""

    def __init__(self, solution: Solution) -> None:
        self._response, answer = solution.response, solution.answer
        self._path = answer.path.points
        self._fields = VolumeFields(answer.system)
        self._regions = [region.name for region in answer.system.mesh.regions]
        design, scene = self._response.design, self._response.scene
        self._title = f"{design.title}, design {design.digest[:12]}, scene {scene.digest[:12]}"

    def files(self) -> dict[str, bytes]:
        """All of them by name."""
        numbers = range(len(self._path))
        fields = {_name(number): self._field(number) for number in numbers}
        return {"answer.pvd": self._series(numbers), **fields, "answer.json": self._document()}

    def archive(self, *, at_most: int) -> BodyArchive | None:
        """As one zip of about ``at_most`` bytes, which holds all points, or as many as fit: the
        last one, and others spread evenly. None where the last one does not fit."""
        if not self._path:
            return None
        target, last = io.BytesIO(), len(self._path) - 1
        held = [last]
        with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED, compresslevel=_QUICK) as archive:
            _add(archive, _name(last), self._field(last))
            each = target.tell()
            if each > at_most:
                return None
            for number in _spread(last, at_most // each - 1):
                _add(archive, _name(number), self._field(number))
                held.append(number)
                if target.tell() + each > at_most:
                    break
            held.sort()
            _add(archive, "answer.pvd", self._series(held))
            _add(archive, "answer.json", self._document())
        return BodyArchive(target.getvalue(), tuple(held))

    def _field(self, number: int) -> bytes:
        [state] = self._fields.states([self._path[number]])
        return unstructured_grid(self._fields.mesh, self._regions, state, self._title)

    def _series(self, numbers: Sequence[int]) -> bytes:
        pressures = [self._path[number].pressure for number in numbers]
        return collection([_name(number) for number in numbers], pressures)

    def _document(self) -> bytes:
        return json.dumps(self._response.to_document(), indent=2).encode() + b"\n"


def _name(number: int) -> str:
    return f"answer-{number:03d}.vtu"


def _spread(last: int, count: int) -> Iterator[int]:
    """At most ``count`` whole numbers from 0 to ``last - 1``, evenly spread."""
    if count >= last:
        yield from range(last)
    elif count > 0:
        yield from np.linspace(0, last, count + 1)[:-1].round().astype(int).tolist()


def _add(archive: zipfile.ZipFile, name: str, data: bytes) -> None:
    # a fixed date: equal files, equal bytes
    member = zipfile.ZipInfo(name, date_time=(1980, 1, 1, 0, 0, 0))
    member.compress_type = zipfile.ZIP_DEFLATED
    archive.writestr(member, data, compresslevel=_QUICK)
