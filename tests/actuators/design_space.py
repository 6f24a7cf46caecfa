"""Hypothesis strategies for designs that can be built, across all families."""

from hypothesis import strategies as st

from actuators.design import (
    BellowsDesign,
    Design,
    DesignError,
    ObliqueDesign,
    PrintedDesign,
    SlabDesign,
    parse_design,
)


def _sampled(lower: float, upper: float) -> st.SearchStrategy[float]:
    """Lengths as a designer types them, to 0.01 mm."""
    return st.integers(round(lower * 100), round(upper * 100)).map(lambda n: n / 100)


_SLAB = st.fixed_dictionaries(
    {
        "family": st.just("slab"),
        "planform": st.sampled_from(["rectangle", "triangle", "ellipse"]),
        "length_mm": _sampled(20, 200),
        "width_mm": _sampled(8, 80),
        "tip_width_mm": _sampled(1, 40),
        "side_radius_mm": _sampled(15, 400),
        "chamber_count": st.integers(1, 14),
        "root_wall_mm": _sampled(0.5, 15),
        "tip_wall_mm": _sampled(0.5, 15),
        "wall_ratio": st.sampled_from([0.3, 0.5, 1.0, 1.7]),
        "channel_width_mm": _sampled(0.4, 6),
        "side_wall_mm": _sampled(0.5, 5),
        "bottom_thickness_mm": _sampled(0.5, 8),
        "chamber_height_mm": _sampled(1, 12),
        "roof_thickness_mm": _sampled(0.5, 8),
    }
)

_OBLIQUE = st.fixed_dictionaries(
    {
        "family": st.just("oblique"),
        "theta_deg": st.sampled_from([15.0, 22.5, 30.0, 45.0, 61.3, 75.0, 90.0]),
        "chamber_count": st.integers(1, 9),
        "length_mm": _sampled(30, 200),
        "width_mm": _sampled(4, 25),
        "chamber_width_mm": _sampled(2, 20),
        "half_gap_mm": _sampled(0.3, 3),
        "wall_thickness_mm": _sampled(0.5, 3),
        "half_chamber_mm": _sampled(0.5, 3),
        "channel_width_mm": st.one_of(st.just(0.0), _sampled(0.4, 3)),
        "channel_height_mm": _sampled(0.3, 2),
        "bottom_thickness_mm": _sampled(0.5, 6),
        "foot_height_mm": _sampled(0.7, 4),
        "wall_height_mm": _sampled(1, 12),
        "roof_thickness_mm": _sampled(0.5, 4),
    }
)

_PRINTED = st.fixed_dictionaries(
    {
        "family": st.just("printed"),
        "chamber_count": st.integers(1, 9),
        "length_mm": _sampled(30, 150),
        "width_mm": _sampled(5, 30),
        "gap_mm": _sampled(0.3, 3),
        "wall_thickness_mm": _sampled(0.5, 3),
        "chamber_length_mm": _sampled(1, 6),
        "side_wall_mm": _sampled(0.5, 3),
        "channel_width_mm": st.one_of(st.just(0.0), _sampled(0.4, 3)),
        "channel_height_mm": _sampled(0.3, 2),
        "bottom_thickness_mm": _sampled(0.5, 6),
        "foot_height_mm": _sampled(0.7, 4),
        "wall_height_mm": _sampled(1, 12),
        "roof_thickness_mm": _sampled(0.5, 4),
        "layer": st.sampled_from(["inextensible", "none"]),
        "layer_height_mm": st.one_of(st.just(0.0), _sampled(0.1, 2)),
    }
)


def _bellows_document(numbers: dict[str, float]) -> dict[str, object]:
    """Bellows from the sizes that must be positive rather than from those that a designer gives."""
    crown, straight = numbers.pop("crown"), numbers.pop("straight")
    wall, gap, end = (numbers[f"{k}_mm"] for k in ("wall_thickness", "gap", "end_length"))
    valley = gap / 2 + wall
    below = numbers["bottom_thickness_mm"] + numbers["channel_height_mm"]
    height = below + valley + straight + crown + wall
    length = 2 * end + numbers["chamber_count"] * 2 * (crown + valley)
    inner = numbers.pop("inner_width")
    return {
        "family": "bellows",
        "length_mm": round(length, 6),
        "total_height_mm": round(height, 6),
        "width_mm": round(inner + 2 * wall, 6),
        **numbers,
    }


_BELLOWS = st.fixed_dictionaries(
    {
        "chamber_count": st.integers(1, 9),
        "crown": _sampled(0.4, 6),
        "straight": _sampled(0.4, 12),
        "inner_width": _sampled(0.5, 20),
        "wall_thickness_mm": _sampled(0.3, 4),
        "gap_mm": _sampled(0.1, 3),
        "channel_height_mm": _sampled(0.3, 5),
        "end_length_mm": _sampled(0.3, 10),
        "bottom_thickness_mm": _sampled(0.3, 5),
    }
).map(_bellows_document)


def _buildable(documents: st.SearchStrategy[dict[str, object]]) -> st.SearchStrategy[Design]:
    def attempt(document: dict[str, object]) -> Design | None:
        try:
            return parse_design(document)
        except DesignError:
            return None

    return documents.map(attempt).filter(lambda d: d is not None)  # pyright: ignore[reportReturnType]


def slabs() -> st.SearchStrategy[SlabDesign]:
    """Slabs of all three planforms."""
    return _buildable(_SLAB)  # pyright: ignore[reportReturnType]


def obliques() -> st.SearchStrategy[ObliqueDesign]:
    """Oblique bars from 15 to 90 degrees."""
    return _buildable(_OBLIQUE)  # pyright: ignore[reportReturnType]


def printed() -> st.SearchStrategy[PrintedDesign]:
    """Printed pneu-nets with and without their layer."""
    return _buildable(_PRINTED)  # pyright: ignore[reportReturnType]


def bellows() -> st.SearchStrategy[BellowsDesign]:
    """Bellows from nearly round to slender."""
    return _buildable(_BELLOWS)  # pyright: ignore[reportReturnType]


def designs() -> st.SearchStrategy[Design]:
    """Any family."""
    return st.one_of(slabs(), obliques(), printed(), bellows())
