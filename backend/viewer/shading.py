"""Light baked into vertex colours, so that what the screen shows is the legend's colour.

viser draws lit materials under its own lamps and sends everything through a film-like tone curve
(three.js' ACES filmic), which no colour scale survives. Bodies are therefore drawn unlit; the light
is computed here, and the tone curve undone beforehand.
"""

from functools import cache

import numpy as np

from backend.viewer.colour_maps import SIZE, table

SHADES = 32
"""Steps of brightness from turned away to facing the light."""
DARKEST, BRIGHTEST = 0.45, 0.95
"""Linear brightness of a face turned away from the light, and of one that faces it; above 0.95 the
tone curve cannot show the brightest yellows."""
LIGHT = np.array([0.35, -0.6, 0.72]) / np.linalg.norm([0.35, -0.6, 0.72])
"""Direction towards the light: from above, the viewer's left shoulder."""
FULL = 32767
"""What stands for 1 in vertex colours."""
PLAIN = "plain"
"""Name of the uncoloured grey."""

# three.js, tonemapping_pars_fragment: ACESFilmicToneMapping, exposure 1 (its matrices, transposed
# there to columns), after S. Hill's fit of the ACES output transform
_ACES_IN = np.array(
    [[0.59719, 0.35458, 0.04823], [0.07600, 0.90834, 0.01566], [0.02840, 0.13383, 0.83777]]
)
_ACES_OUT = np.array(
    [[1.60475, -0.53108, -0.07367], [-0.10208, 1.10813, -0.00605], [-0.00327, -0.07276, 1.07602]]
)
_ACES_GAIN = 0.6


def tone_curve(linear: np.ndarray) -> np.ndarray:
    """What three.js does to linear colours (..., 3) before it encodes them as sRGB."""
    v = (linear / _ACES_GAIN) @ _ACES_IN.T
    v = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081)
    return np.clip(v @ _ACES_OUT.T, 0.0, 1.0)


def before_tone_curve(shown: np.ndarray) -> np.ndarray:
    """Linear colours (..., 3) that :func:`tone_curve` turns into ``shown`` (linear, 0..0.95).
    Saturated colours need a little less than nothing of one primary; three.js lets that pass."""
    v = np.clip(shown @ np.linalg.inv(_ACES_OUT).T, -0.001, 0.985)
    # v (0.983729 x2 + 0.432951 x + 0.238081) = x2 + 0.0245786 x - 0.000090537, solved for x
    a, b, c = 1 - 0.983729 * v, 0.0245786 - 0.4329510 * v, -0.000090537 - 0.238081 * v
    x = (-b + np.sqrt(np.maximum(b * b - 4 * a * c, 0.0))) / (2 * a)
    return (x @ np.linalg.inv(_ACES_IN).T) * _ACES_GAIN


def to_linear(srgb: np.ndarray) -> np.ndarray:
    """sRGB (0..1) to linear light."""
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


@cache
def palette(name: str) -> tuple[np.ndarray, float]:
    """Colours to write into vertices: (SHADES, SIZE, 4) int16 of which 32767 stands for the
    returned factor, to be put into the material."""
    srgb = np.full((SIZE, 3), 0.72) if name == PLAIN else table(name)
    shades = np.linspace(DARKEST, BRIGHTEST, SHADES)[:, None, None]
    linear = before_tone_curve(to_linear(srgb)[None] * shades)
    factor = float(np.abs(linear).max())
    colours = np.full((SHADES, SIZE, 4), FULL, dtype=np.int16)
    colours[..., :3] = np.round(linear / factor * FULL)
    return colours, factor


def vertex_colours(name: str, position: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """Colours (..., 4) int16 of vertices at ``position`` (...) of the map, 0..1, with outward
    ``normals`` (..., 3)."""
    colours, _ = palette(name)
    facing = 0.5 + 0.5 * (normals @ LIGHT.astype(normals.dtype))
    shade = np.clip(facing * (SHADES - 1) + 0.5, 0, SHADES - 1).astype(np.int32)
    index = np.clip(position * (SIZE - 1) + 0.5, 0, SIZE - 1).astype(np.int32)
    return colours.reshape(-1, 4)[shade * SIZE + index]
