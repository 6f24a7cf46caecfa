"""Parts laid out on sheets in rows, tallest first: simple, and enough for a handful of frames."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from actuators.fabrication.part import Part

SHEET_MM = (600.0, 400.0)
GAP_MM = 5.0


@dataclass(frozen=True)
class Placed:
    """A part moved by (``dx``, ``dy``) mm onto its sheet."""

    part: Part
    dx: float
    dy: float


@dataclass(frozen=True)
class Sheet:
    """One sheet to cut; the origin is its lower left corner, lengths in mm."""

    thickness: float
    width: float
    height: float
    placed: tuple[Placed, ...]


def lay_out(
    parts: Iterable[Part], sheet: tuple[float, float] = SHEET_MM, gap: float = GAP_MM
) -> list[Sheet]:
    """Sheets by thickness, with ``gap`` between parts and to the edge [mm]. A sheet too small for
    a part grows to hold it."""
    by_thickness: dict[float, list[Part]] = {}
    for part in parts:
        by_thickness.setdefault(part.thickness, []).append(part)
    return [
        laid
        for thickness in sorted(by_thickness)
        for laid in _rows(thickness, by_thickness[thickness], sheet, gap)
    ]


def _rows(
    thickness: float, parts: Sequence[Part], sheet: tuple[float, float], gap: float
) -> list[Sheet]:
    sizes = [(p.box[2] - p.box[0], p.box[3] - p.box[1]) for p in parts]
    width = max(sheet[0], *(w + 2 * gap for w, _ in sizes))
    height = max(sheet[1], *(h + 2 * gap for _, h in sizes))
    full: list[list[Placed]] = [[]]
    x = y = gap
    row_height = 0.0
    for k in sorted(range(len(parts)), key=lambda k: -sizes[k][1]):
        part_width, part_height = sizes[k]
        if x + part_width + gap > width:
            x, y, row_height = gap, y + row_height + gap, 0.0
        if y + part_height + gap > height:
            full.append([])
            x, y, row_height = gap, gap, 0.0
        left, _, _, top = parts[k].box
        # rows run down from the upper left corner, where laser cutters have their origin
        full[-1].append(Placed(parts[k], x - left, height - y - top))
        x += part_width + gap
        row_height = max(row_height, part_height)
    return [Sheet(thickness, width, height, tuple(placed)) for placed in full]
