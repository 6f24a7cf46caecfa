"""Files of a design: one format per module, all bytes in memory."""

from collections.abc import Callable, Mapping

from actuators.design.base import Design
from actuators.design.slab import SlabDesign
from actuators.errors import QuestionError
from actuators.export.actuator_stl import actuator_stl
from actuators.export.mould_svg import mould_svg
from actuators.fabrication.slab_mould import slab_moulds


def _moulds(design: Design) -> dict[str, bytes]:
    if not isinstance(design, SlabDesign):
        raise QuestionError(
            f"mould-svg is not available for the family {design.family}: its chambers stand apart "
            "and need a moulded shape that flat sheets cannot give; only slab moulds are cut from "
            "sheet. Export actuator-stl instead.",
            field="what", value="mould-svg", mend="Export actuator-stl instead.",
        )  # fmt: skip
    return mould_svg(design)


_WRITERS: Mapping[str, Callable[[Design], dict[str, bytes]]] = {
    "mould-svg": _moulds,
    "actuator-stl": actuator_stl,
}

KINDS: tuple[str, ...] = tuple(_WRITERS)


def available(design: Design) -> tuple[str, ...]:
    """Kinds of files that this design has."""
    return KINDS if isinstance(design, SlabDesign) else ("actuator-stl",)


def write(design: Design, what: str) -> dict[str, bytes]:
    """Files of one kind by name. Raises :class:`QuestionError` for an unknown kind, or one that the
    design's family does not have."""
    if what not in _WRITERS:
        raise QuestionError(
            f"what is {what!r}; this version writes {' and '.join(KINDS)}.",
            field="what", value=what, mend=f"Use {' or '.join(KINDS)}.",
        )  # fmt: skip
    return _WRITERS[what](design)


def notes(design: Design, what: str) -> tuple[str, ...]:
    """What a maker must know about these files before cutting, as sentences."""
    if what == "mould-svg" and isinstance(design, SlabDesign):
        return slab_moulds(design).notes
    return ()


__all__ = ["KINDS", "available", "notes", "write"]
