"""The page's plots, small PNGs in docs/pictures/validation."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

FOLDER = Path("docs/pictures/validation")


@contextmanager
def figure(name: str, columns: int = 1, *, height: float = 3.2) -> Iterator[Any]:
    """Axes (one, or an array of them) of a picture saved as ``name``.png."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    drawn, axes = plt.subplots(1, columns, figsize=(4.6 * columns, height), dpi=90)
    yield axes
    for ax in drawn.axes:
        ax.grid(alpha=0.3)
        if ax.get_legend_handles_labels()[0]:
            ax.legend(fontsize=7, framealpha=0.7)
    drawn.tight_layout()
    drawn.savefig(FOLDER / f"{name}.png", metadata={"Software": None})
    plt.close(drawn)


def picture(name: str, says: str) -> str:
    """Markdown that shows it."""
    return f"![{says}](pictures/validation/{name}.png)"
