"""How long the instant model takes: a 20-point sweep with its cell kept and with a new cell, and
energy-model designs per second. ``python benchmarks/instant.py``

Aims: below 5 ms with the cell kept, below 60 ms with a new one. Times are the best and the median
of the repetitions, on whatever else the machine is doing.
"""

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")

import time
from collections.abc import Callable
from statistics import median

import numpy as np

from actuators.design import PRESETS, Design, preset
from actuators.mechanics.cell.cache import forget_cells
from actuators.mechanics.energy_model import oblique_layers, rod_strains
from actuators.mechanics.predict import predict
from actuators.mechanics.scene import Scene

REPEATS = 15


def milliseconds(work: Callable[[], object], before: Callable[[], None] = lambda: None) -> str:
    """Best and median wall time of ``work``, as a table cell."""
    times: list[float] = []
    for _ in range(REPEATS):
        before()
        start = time.perf_counter()
        work()
        times.append(1e3 * (time.perf_counter() - start))
    return f"{min(times):7.2f} {median(times):7.2f}"


def sweep(design: Design, rung: str = "energy") -> Callable[[], object]:
    """A 20-point pressure sweep under gravity."""
    scene = Scene(30e3, steps=20)
    return lambda: predict(design, scene, rung=rung)


def designs_per_second(count: int = 100_000) -> float:
    """Energy model of ``count`` random oblique designs at once."""
    rng = np.random.default_rng(1)

    def mm(low: float, high: float) -> np.ndarray:
        return rng.uniform(low, high, count) * 1e-3

    layers = {
        "theta": np.radians(rng.uniform(15, 90, count)), "half_gap": mm(0.5, 3),
        "wall_thickness": mm(0.5, 3), "half_chamber": mm(0.5, 3), "width": mm(14, 25),
        "chamber_width": mm(5, 12), "bottom_thickness": mm(1, 5), "foot_height": mm(1, 3),
        "wall_height": mm(2, 10), "roof_thickness": mm(1, 4),
        "bottom_shear": rng.uniform(1e4, 2e5, count), "top_shear": rng.uniform(1e4, 2e5, count),
    }  # fmt: skip
    start = time.perf_counter()
    rod_strains(oblique_layers(**layers))
    return count / (time.perf_counter() - start)


def main() -> None:
    """Print the table."""
    sweep(preset("oblique-45").design)()  # compiled code and numberings are there from set-up on
    print("20-point sweep under gravity, ms (best, median)")
    print(f"{'preset':22s} {'cell kept':>15s} {'new cell':>15s} {'closed form':>15s}")
    for name in PRESETS:
        design = preset(name).design
        sweep(design)()
        kept = milliseconds(sweep(design))
        new = milliseconds(sweep(design), forget_cells)
        closed = milliseconds(sweep(design, "closed-form"))
        print(f"{name:22s} {kept} {new} {closed}")
    print(f"energy model, vectorised: {designs_per_second():,.0f} designs per second")


if __name__ == "__main__":
    main()
