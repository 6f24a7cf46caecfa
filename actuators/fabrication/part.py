"""What a laser cuts from one sheet: outlines to cut, lines to engrave, a label to read."""

from dataclasses import dataclass

from shapely.geometry import LinearRing, Polygon


@dataclass(frozen=True)
class Label:
    """Text to engrave or read. ``x``, ``y`` is the middle of its baseline [mm]."""

    text: str
    x: float
    y: float
    height: float


@dataclass(frozen=True)
class Part:
    """A flat piece. Coordinates in mm, x along the actuator, y across.

    ``cut``: the material that stays, its outline and holes are cut; ``engraved``: closed lines to
    mark on its surface; ``label_engraved``: False where a mark would print into the rubber, so that
    the label only stands beside the part.
    """

    name: str
    thickness: float
    cut: Polygon
    label: Label
    label_engraved: bool = True
    engraved: tuple[LinearRing, ...] = ()

    @property
    def box(self) -> tuple[float, float, float, float]:
        """Bounds with the label: left, bottom, right, top [mm]."""
        left, bottom, right, top = self.cut.bounds
        half = LETTER_WIDTH * self.label.height * len(self.label.text) / 2
        return (
            min(left, self.label.x - half),
            min(bottom, self.label.y - 0.3 * self.label.height),
            max(right, self.label.x + half),
            max(top, self.label.y + self.label.height),
        )


LETTER_WIDTH = 0.62
"""Mean width of a letter over the text's height, for sans-serif fonts."""
