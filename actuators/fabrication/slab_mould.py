"""Moulds of a slab from laser-cut sheet: two trays of stacked layers, one with a core.

Mould A casts the bottom layer: a base plate and frames whose window is the planform. Mould B casts
the layer with the chambers and the roof upside down: the core stands on the base where the
chambers open, the roof is poured over it. The cast parts are bonded face to face; a slab equals its
own mirror image, so turning the upper part over needs no mirrored mould.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from shapely.geometry import LinearRing, Point, Polygon

from actuators.design.slab import SlabDesign
from actuators.fabrication.part import Label, Part
from actuators.fabrication.sheet_stack import STOCK_MM, stack
from actuators.fabrication.slab_outline import cavity_outline, planform_outline

MARGIN_MM = 14.0
DOWEL_MM = 4.0
CHAMFER_MM = 4.0
BASE_MM = 5.0
LETTERS_MM = 4.0
SAME_MM = 0.005
FRAGILE_MM = 1.0
"""A laser's kerf takes 0.1 to 0.3 mm; what is left of a thinner link does not bear handling."""


@dataclass(frozen=True)
class Mould:
    """Parts of one tray, from the base up, then the core. ``pour_ml``: rubber that fills it."""

    name: str
    casts: str
    pour_ml: float
    parts: tuple[Part, ...]


@dataclass(frozen=True)
class SlabMoulds:
    """Everything to cut for one slab. ``notes`` say where the stock forces another thickness."""

    moulds: tuple[Mould, ...]
    bottom_thickness: float
    chamber_height: float
    roof_thickness: float
    notes: tuple[str, ...]

    @property
    def parts(self) -> tuple[Part, ...]:
        """All parts of both moulds."""
        return tuple(part for mould in self.moulds for part in mould.parts)


def slab_moulds(design: SlabDesign, stock: Sequence[float] = STOCK_MM) -> SlabMoulds:
    """Both moulds of a slab, cut from sheets of the ``stock`` thicknesses [mm]."""
    bottom, chamber, roof = (
        design.bottom_thickness * 1e3, design.chamber_height * 1e3, design.roof_thickness * 1e3,
    )  # fmt: skip
    bottom_sheets = stack(bottom, stock)
    core_sheets = stack(chamber, stock)
    # the roof bends the actuator: keep it rather than the outer height
    top_sheets = stack(sum(core_sheets) + roof, stock, above=sum(core_sheets))
    base = min(stock, key=lambda t: abs(t - BASE_MM))
    window, core = planform_outline(design), cavity_outline(design)
    return SlabMoulds(
        moulds=(
            _tray("A", "bottom layer", window, base, bottom_sheets),
            _tray(
                "B", "chambers and roof, upside down", window, base, top_sheets, core, core_sheets
            ),
        ),
        bottom_thickness=sum(bottom_sheets),
        chamber_height=sum(core_sheets),
        roof_thickness=round(sum(top_sheets) - sum(core_sheets), 2),
        notes=(
            *_stock_notes("bottom_thickness", bottom, bottom_sheets),
            *_stock_notes("chamber_height", chamber, core_sheets),
            *_stock_notes("roof_thickness", roof, top_sheets, core_sheets),
            *_core_notes(design),
        ),
    )


def _stock_notes(
    name: str, wanted: float, sheets: Sequence[float], under: Sequence[float] = ()
) -> list[str]:
    """What stock sheets make of a thickness, if not the one wanted; ``under``: sheets of the core
    that the frames reach past."""
    made = sum(sheets) - sum(under)
    if abs(made - wanted) <= SAME_MM:
        return []
    pile = " + ".join(f"{t:g}" for t in sheets)
    core = f" over a core of {sum(under):g} mm" if under else ""
    return [f"{name} is {wanted:.4g} mm; stock sheets make {made:.4g} mm ({pile}{core})."]


def _core_notes(design: SlabDesign) -> list[str]:
    link = design.channel_width * 1e3
    if design.chamber_count == 1 or link >= FRAGILE_MM:
        return []
    return [
        f"channel_width is {link:.4g} mm: links of the core narrower than {FRAGILE_MM:g} mm break "
        "easily. Widen channel_width, or glue the pieces at their engraved places."
    ]


def _tray(
    name: str,
    casts: str,
    window: Polygon,
    base: float,
    frames: Sequence[float],
    core: Polygon | None = None,
    core_sheets: Sequence[float] = (),
) -> Mould:
    plate = _plate(window)
    # only the core is marked: a groove along the window would print a fin on the part's edge
    marks = () if core is None else (LinearRing(core.exterior.coords),)
    parts = [_plate_part(f"{name}1 base {base:g} mm", base, plate, marks)]
    for thickness in frames:
        label = f"{name}{len(parts) + 1} frame {thickness:g} mm"
        frame = Polygon(plate.exterior, [*plate.interiors, window.exterior])
        parts.append(_plate_part(label, thickness, frame))
    for thickness in core_sheets if core is not None else ():
        assert core is not None
        label = f"{name}{len(parts) + 1} core {thickness:g} mm"
        parts.append(_core_part(label, thickness, core))
    volume = window.area * sum(frames) - (0.0 if core is None else core.area * sum(core_sheets))
    return Mould(name, casts, volume * 1e-3, tuple(parts))


def _plate(window: Polygon) -> Polygon:
    """Rectangle around the window with dowel holes; one corner is cut off, so that no layer can be
    laid the wrong way round."""
    left, bottom, right, top = window.bounds
    left, bottom, right, top = (
        left - MARGIN_MM, bottom - MARGIN_MM, right + MARGIN_MM, top + MARGIN_MM,
    )  # fmt: skip
    inset = MARGIN_MM / 2
    return Polygon(
        [(left, bottom), (right, bottom), (right, top), (left + CHAMFER_MM, top),
         (left, top - CHAMFER_MM)],
        [
            Point(x, y).buffer(DOWEL_MM / 2, quad_segs=32).exterior
            for x in (left + inset, right - inset)
            for y in (bottom + inset, top - inset)
        ],
    )  # fmt: skip


def _plate_part(
    label: str, thickness: float, cut: Polygon, marks: tuple[LinearRing, ...] = ()
) -> Part:
    left, bottom, right, _ = cut.bounds
    text = Label(label, (left + right) / 2, bottom + (MARGIN_MM - LETTERS_MM) / 2, LETTERS_MM)
    return Part(label, thickness, cut, text, engraved=marks)


def _core_part(label: str, thickness: float, core: Polygon) -> Part:
    left, bottom, right, _ = core.bounds
    text = Label(label, (left + right) / 2, bottom - 1.5 * LETTERS_MM, LETTERS_MM)
    return Part(label, thickness, core, text, label_engraved=False)
