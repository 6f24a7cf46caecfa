"""Do threads help? Wall and processor time of our engine with 1 and 2 threads in the kernels
(numba) and in the direct solver (MKL), over those with one thread in both, on the peers' problems.

    python -m benchmarks.threads [--repeat 2]

Every entry in a process of its own, the settings of one problem in turn, the least of the repeats.
Meant for a machine that does nothing else: wall time beside other work says nothing.
"""

import argparse
import json
import os
import subprocess
import sys

SETTINGS = ((1, 1), (2, 1), (1, 2), (2, 2))
"""Threads of the kernels, of the solver."""
MESHES = {"mini": "1,1,1", "slab": "1,1,1", "bellows": "0,1,1", "printed": "0,1,1"}


def seconds(problem: str, kernels: int, solver: int) -> tuple[float, float]:
    """Wall and processor time [s]."""
    done = subprocess.run(
        [sys.executable, "-m", "benchmarks.peer_entry", "ours", problem, MESHES[problem]],
        capture_output=True, text=True, check=True,
        env={**os.environ, "NUMBA_NUM_THREADS": str(kernels), "MKL_NUM_THREADS": str(solver),
             "OMP_NUM_THREADS": "1"},
    )  # fmt: skip
    found = json.loads(done.stdout.splitlines()[-1])
    return found["wall_s"], found["cpu_s"]


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--repeat", type=int, default=2)
    repeat = parser.parse_args().repeat
    print("| problem | kernels, solver | wall s | of 1, 1 | cpu s | of 1, 1 |")
    print("| --- | --- | --- | --- | --- | --- |")
    for problem in MESHES:
        runs = [[seconds(problem, *s) for s in SETTINGS] for _ in range(repeat)]
        best = [tuple(min(run[k][i] for run in runs) for i in (0, 1)) for k in range(len(SETTINGS))]
        for (kernels, solver), (wall, cpu) in zip(SETTINGS, best, strict=True):
            print(f"| {problem} | {kernels}, {solver} | {wall:.2f} | {wall / best[0][0]:.2f} | "
                  f"{cpu:.2f} | {cpu / best[0][1]:.2f} |", flush=True)  # fmt: skip


if __name__ == "__main__":
    main()
