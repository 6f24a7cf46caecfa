"""Four problems that every engine of the comparison can carry: neo-Hookean rubber under follower
pressure and weight. One of them presses on a rigid plate, without friction: contact that all four
programs have."""

from collections.abc import Callable
from dataclasses import dataclass

from actuators.design import preset
from actuators.geometry import Body, build_body
from actuators.materials import Material, material
from actuators.mechanics.obstacles import Plate
from benchmarks.mini_pneu_net import MATERIALS, PRESSURE, mini_pneu_net

Layers = tuple[int, int, int]


@dataclass(frozen=True)
class PeerProblem:
    """``half``: what is computed; ``materials`` one per region; ``pressure`` [Pa]; ``ladder``: the
    meshes, coarsest first; ``reference``: the mesh of the reference answer. With a ``plate`` its
    force counts as well as the tip."""

    title: str
    half: Callable[[], Body]
    materials: tuple[Material, ...]
    pressure: float
    ladder: tuple[Layers, ...]
    reference: Layers
    plate: Plate | None = None


def _slab() -> Body:
    return build_body(preset("slab-rectangle-low").design).half()


def _bellows() -> Body:
    """Three of the bellows of ``bellows-9-1.6``, far enough apart not to meet."""
    design = preset("bellows-9-1.6").design.changed(
        chamber_count=3, length=43.7, gap=1.5, material="ninjaflex-linear"
    )
    return build_body(design).half()


def _printed() -> Body:
    design = preset("printed-14").design.changed(chamber_count=4, length=33.0, layer="none")
    return build_body(design).half()


_BY_LENGTH = ((0, 0, 0), (1, 0, 0), (1, 0, 1), (1, 1, 1))
_BY_WALLS = ((0, 0, 0), (0, 1, 0), (0, 1, 1))
_PRINTED = material("ninjaflex-linear")

PROBLEMS = {
    "mini": PeerProblem(
        "mini pneu-net, 12 kPa", lambda: mini_pneu_net().half(), MATERIALS, PRESSURE,
        _BY_LENGTH, (2, 2, 2),
    ),
    "slab": PeerProblem(
        "slab-rectangle-low, neo-Hookean, 4 kPa", _slab,
        (material("elastosil-m4601"), material("ecoflex-00-30-neo-hooke")), 4e3,
        _BY_LENGTH, (2, 2, 2),
    ),
    "bellows": PeerProblem(
        "3 bellows on a plate 5 mm below, 120 kPa", _bellows, (_PRINTED, _PRINTED), 120e3,
        ((0, 0, 0), (0, 1, 0), (0, 1, 1), (1, 1, 1)), (2, 2, 2), Plate(gap=5e-3),
    ),
    "printed": PeerProblem(
        "printed pneu-net, 4 free-standing chambers, 150 kPa", _printed, (_PRINTED, _PRINTED),
        150e3, _BY_WALLS, (1, 1, 1),
    ),
}  # fmt: skip
