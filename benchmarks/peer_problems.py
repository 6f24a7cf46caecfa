"""Three problems that every engine of the comparison can carry: neo-Hookean rubber, boxes parallel
to the axes, follower pressure and weight; no contact, which none of the others has as we do."""

from collections.abc import Callable
from dataclasses import dataclass

from actuators.design import preset
from actuators.geometry import Body, build_body
from actuators.materials import Material, material
from benchmarks.mini_pneu_net import MATERIALS, PRESSURE, mini_pneu_net

Layers = tuple[int, int, int]


@dataclass(frozen=True)
class PeerProblem:
    """``half``: what is computed; ``materials`` one per region; ``pressure`` [Pa]; ``ladder``: the
    meshes, coarsest first; ``reference``: the mesh of the reference answer."""

    title: str
    half: Callable[[], Body]
    materials: tuple[Material, ...]
    pressure: float
    ladder: tuple[Layers, ...]
    reference: Layers


def _slab() -> Body:
    return build_body(preset("slab-rectangle-low").design).half()


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
    "printed": PeerProblem(
        "printed pneu-net, 4 free-standing chambers, 150 kPa", _printed, (_PRINTED, _PRINTED),
        150e3, _BY_WALLS, (1, 1, 1),
    ),
}  # fmt: skip
