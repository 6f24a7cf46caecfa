"""The ladder of graded meshes, and its rungs by name."""

from actuators.errors import QuestionError
from actuators.geometry import Body
from actuators.geometry.body import OUTSIDE

Layers = tuple[int, int, int]
MeshChoice = str | Layers
LEVELS: tuple[Layers, ...] = ((0, 0, 0), (1, 0, 0), (1, 0, 1), (1, 1, 1), (2, 2, 2))
"""Thin layers at the block borders, per direction; each level's lines contain the one's before."""
LEVELS_WITH_GAPS: tuple[Layers, ...] = ((0, 0, 0), (0, 1, 0), (0, 1, 1), (1, 1, 1))
"""Free-standing chambers have lines enough along the body; their side walls come first (measured:
2.8 % of the tip, layers along the body 0.3 %). So do those of bellows (4.2 %; further layers in the
height then 0.7 %)."""
NAMES = ("coarse", "medium", "fine", "finest")
MOST_LAYERS = 3


def levels_of(body: Body) -> tuple[Layers, ...]:
    """The meshes that a body is refined through."""
    stand_apart = body.curved or bool((body.fill == OUTSIDE).any())
    return LEVELS_WITH_GAPS if stand_apart else LEVELS


def layers_of(body: Body, mesh: MeshChoice) -> Layers:
    """Layers of a mesh by name, by text such as ``1,1,1``, or as they are.

    Raises :class:`QuestionError` for anything else.
    """
    ladder = levels_of(body)
    if isinstance(mesh, str):
        if mesh in NAMES:
            return {"coarse": ladder[0], "medium": ladder[1], "fine": ladder[-2],
                    "finest": ladder[-1]}[mesh]  # fmt: skip
        parts = mesh.split(",")
        if len(parts) == 3 and all(part.strip().isdigit() for part in parts):
            return layers_of(body, (int(parts[0]), int(parts[1]), int(parts[2])))
    elif len(mesh) == 3 and all(0 <= n <= MOST_LAYERS for n in mesh):
        return mesh
    mend = f"Use {', '.join(NAMES)}, or layers along X1, X2, X3 such as 1,0,1."
    raise QuestionError(
        f"mesh is {mesh!r}; it is a name or three numbers of thin layers from 0 to "
        f"{MOST_LAYERS}. {mend}",
        field="mesh", value=str(mesh), mend=mend,
    )  # fmt: skip
