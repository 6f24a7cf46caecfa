"""Files of a design: one format per module, all bytes in memory."""

from collections.abc import Callable, Mapping

from actuators.design.base import Design
from actuators.design.slab import SlabDesign
from actuators.errors import QuestionError
from actuators.export.actuator_stl import actuator_stl
from actuators.export.models import MODEL_KINDS, ModelQuestion, write_model
from actuators.export.mould_svg import mould_svg
from actuators.fabrication.slab_mould import slab_moulds


def _moulds(design: Design) -> dict[str, bytes]:
    if not isinstance(design, SlabDesign):
        printed = len(set(design.layer_materials)) == 1
        reason = (
            "it is printed in one piece, not cast"
            if printed
            else "its chambers stand apart and need a moulded shape that flat sheets cannot give; "
            "only slab moulds are cut from sheet"
        )
        raise QuestionError(
            f"mould-svg is not available for the family {design.family}: {reason}. Export "
            "actuator-stl instead.",
            field="what", value="mould-svg", mend="Export actuator-stl instead.",
        )  # fmt: skip
    return mould_svg(design)


_WRITERS: Mapping[str, Callable[[Design], dict[str, bytes]]] = {
    "mould-svg": _moulds,
    "actuator-stl": actuator_stl,
}

KINDS: tuple[str, ...] = (*_WRITERS, *MODEL_KINDS)
"""All kinds; those of :data:`MODEL_KINDS` need a question."""


def available(design: Design) -> tuple[str, ...]:
    """Kinds of files that this design has by itself, without a scene."""
    return tuple(_WRITERS) if isinstance(design, SlabDesign) else ("actuator-stl",)


def write(design: Design, what: str, question: ModelQuestion | None = None) -> dict[str, bytes]:
    """Files of one kind by name. Raises :class:`QuestionError` for an unknown kind, one that the
    design's family does not have, or one that needs a ``question`` and has none."""
    if what in _WRITERS:
        return _WRITERS[what](design)
    if what not in MODEL_KINDS:
        raise QuestionError(
            f"what is {what!r}; this version writes {', '.join(KINDS[:-1])} and {KINDS[-1]}.",
            field="what", value=what, mend=f"Use one of {', '.join(KINDS)}.",
        )  # fmt: skip
    if question is None:
        raise QuestionError(
            f"what is {what!r}, which is made for one scene. Give a pressure or a scene.",
            field="pressure", value="", mend="Give --pressure 30kPa or --scene FILE.",
        )  # fmt: skip
    return write_model(design, what, question)


def notes(design: Design, what: str) -> tuple[str, ...]:
    """What a maker must know about these files before cutting, as sentences."""
    if what == "mould-svg" and isinstance(design, SlabDesign):
        return slab_moulds(design).notes
    return ()


__all__ = ["KINDS", "MODEL_KINDS", "ModelQuestion", "available", "notes", "write"]
