"""Colour maps: perceptually uniform, readable for colour-blind eyes and in grey."""

from collections.abc import Mapping

import numpy as np

# 33 equidistant stops of matplotlib's maps of these names (lib/matplotlib/_cm_listed.py, released
# under CC0): viridis and inferno by S. van der Walt and N. Smith, cividis by J. Nunez, C. Anderton
# and R. Renslow. Between stops sRGB is interpolated; that differs by at most 6 of 255 levels.
_STOPS: Mapping[str, str] = {
    "viridis": (
        "440154 470d60 48186a 482374 472d7b 453781 424086 3e4989 3b528b 375b8d 33638d 2f6b8e "
        "2c728e 297a8e 26828e 23898e 21918c 1f978b 1f9f88 21a685 27ad81 31b57b 3dbc74 4cc26c "
        "5cc863 6ece58 81d34d 95d840 aadc32 c0df25 d5e21a eae51a fde725"
    ),
    "cividis": (
        "00224e 00285b 002e6a 053371 1a386f 273e6e 32436d 3b496c 434e6c 4b546c 535a6d 5a5f6e "
        "61656f 686a71 6f7073 767676 7d7c78 838179 8b8778 928d78 9a9376 a29975 aaa073 b3a670 "
        "bbad6d c3b369 ccba64 d4c15f ddc858 e6d051 efd748 f8df3c fee838"
    ),
    "inferno": (
        "000004 040312 0b0724 150b37 210c4a 2f0a5b 3d0965 4a0c6b 57106e 64156e 71196e 7d1e6d "
        "8a226a 972766 a32c61 b0315b bc3754 c63d4d d04545 da4e3c e35933 eb6429 f1711f f67e14 "
        "f98c0a fb9b06 fcaa0f fbba1f f9c932 f5d949 f2e865 f3f586 fcffa4"
    ),
}

SIZE = 256


def stops(name: str) -> list[tuple[float, str]]:
    """Stops as [position 0..1, '#rrggbb'], for legends."""
    colours = _STOPS[name].split()
    return [(k / (len(colours) - 1), f"#{colour}") for k, colour in enumerate(colours)]


def table(name: str) -> np.ndarray:
    """The map at :data:`SIZE` equidistant positions: (SIZE, 3), sRGB 0..1."""
    given = np.array(
        [[int(colour[k : k + 2], 16) / 255 for k in (0, 2, 4)] for colour in _STOPS[name].split()]
    )
    at = np.linspace(0, len(given) - 1, SIZE)
    return np.stack([np.interp(at, np.arange(len(given)), given[:, c]) for c in range(3)], axis=-1)
