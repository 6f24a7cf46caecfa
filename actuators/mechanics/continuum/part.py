"""The path found so far as an answer: what is left of a computation that does not come to its end.

An answer's points cost a tenth of solving them. Here each is made once, and not every state becomes
one: whoever asks chooses when.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from actuators.design.base import Design
from actuators.mechanics.continuum.findings import effects
from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.path import Path
from actuators.mechanics.continuum.recovery import Answer, recover
from actuators.mechanics.continuum.system import ContinuumSystem
from actuators.mechanics.effects import EffectPlan
from actuators.mechanics.response import Centreline, Outcome, Response, SurfaceFields
from actuators.mechanics.scene import Scene

MOST_POINTS = 24
"""Where there would be more, every second one leaves."""
UNFINISHED = (
    "This is the part of an answer that was never finished. Nobody has looked yet for walls that "
    "overlap, or for materials stretched beyond what was tested."
)


@dataclass(frozen=True, eq=False)
class _Piece:
    """A state, and the answer that has this state alone."""

    found: Equilibrium
    answer: Response


class PathPart:
    """Of one question: grows with the path, on one mesh."""

    def __init__(self, design: Design, scene: Scene, accuracy: float) -> None:
        self._design, self._scene, self._accuracy = design, scene, accuracy
        self._first: Equilibrium | None = None
        self._pieces: list[_Piece] = []

    def go_on_from(self, points: Sequence[Equilibrium]) -> None:
        """The path goes on after ``points``: what else was found is none of it."""
        self._pieces = [p for p in self._pieces if any(p.found is point for point in points)]
        if not points:
            self._first = None

    def up_to(
        self, system: ContinuumSystem, found: Equilibrium, plan: EffectPlan
    ) -> Callable[[], Response]:
        """What makes an answer of the path up to the state ``found``, its latest: its first state,
        those asked for before, and this one."""
        if self._first is None:
            self._first = found
        first, pieces = self._first, self._pieces

        def made() -> Response:
            for each in (first, found):
                if not any(piece.found is each for piece in pieces):
                    pieces.append(_Piece(each, self._alone(system, each, plan)))
            if len(pieces) > MOST_POINTS:
                pieces[:] = [*pieces[:-1:2], pieces[-1]]
            return _joined([piece.answer for piece in pieces], plan)

        return made

    def _alone(self, system: ContinuumSystem, found: Equilibrium, plan: EffectPlan) -> Response:
        path = Path(points=[found], outcome=Outcome.CANCELLED)
        answer = Answer(system, path, {}, found.iterations, None, 1)
        return recover(self._design, self._scene, answer, self._accuracy, plan=plan)


def _joined(answers: Sequence[Response], plan: EffectPlan) -> Response:
    points = tuple(point for answer in answers for point in answer.path)
    return replace(
        answers[-1],
        path=points,
        advice=None,
        centreline=_centreline([a.centreline for a in answers if a.centreline is not None]),
        surface=_surface([a.surface for a in answers if a.surface is not None]),
        newton_iterations=sum(answer.newton_iterations for answer in answers),
        effects=effects(plan, points, {}, 0.0),
        notes=(UNFINISHED,),
    )


def _centreline(parts: Sequence[Centreline]) -> Centreline:
    return Centreline(
        parts[-1].stations,
        np.concatenate([part.positions for part in parts]),
        np.concatenate([part.frames for part in parts]),
    )


def _surface(parts: Sequence[SurfaceFields]) -> SurfaceFields:
    """Where contact was switched on along the path, there was none in the states before."""
    touching = [part.contact_pressure for part in parts]
    pressed = None
    if any(pressure is not None for pressure in touching):
        pressed = np.concatenate(
            [
                np.zeros_like(part.stretch) if pressure is None else pressure
                for part, pressure in zip(parts, touching, strict=True)
            ]
        )
    return SurfaceFields(
        parts[-1].vertices,
        parts[-1].triangles,
        np.concatenate([part.displacement for part in parts]),
        np.concatenate([part.stretch for part in parts]),
        np.concatenate([part.stress for part in parts]),
        pressed,
    )
