"""Error against time and memory, our engine beside NGSolve, FElupe and CalculiX.

    python -m benchmarks.peers [--to FOLDER] [--cap 600] [--only mini,slab]

Every entry runs in a process of its own, one after the other, on one thread; one that spends more
than the cap of processor seconds is stopped and stands as such. Answers go to ``peers.jsonl``
in the folder; a run that finds some there goes on with the others. Then the table is printed and
``docs/pictures/peers.svg`` drawn. FElupe (GPL) is installed by hand: ``pip install felupe``;
CalculiX is Debian's ``calculix-ccx``. What is compared is processor time, which other work on the
machine disturbs little.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.peer_problems import PROBLEMS, Layers

THREADS = ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS", "OPENBLAS_NUM_THREADS")
ENGINES = ("ours", "NGSolve", "FElupe", "CalculiX")
COLOURS = {"ours": "#0b6e99", "NGSolve": "#c4622d", "FElupe": "#5b8c3e", "CalculiX": "#7a5195"}
PICTURE = Path(__file__).parent.parent / "docs" / "pictures" / "peers.svg"
MESHES = {
    "mini": {"NGSolve": 4, "FElupe": 3, "CalculiX": 4},
    "slab": {"NGSolve": 2, "FElupe": 2, "CalculiX": 4},
    "bellows": {"NGSolve": 3, "FElupe": 3, "CalculiX": 4},
    "printed": {"NGSolve": 1, "FElupe": 1, "CalculiX": 3},
}
"""How many meshes of a problem's ladder the others are asked for; ours gets all. CalculiX gets as
many as it needs to come within 1 %, if the cap lets it."""


@dataclass(frozen=True)
class Entry:
    """One engine on one mesh of one problem."""

    engine: str
    problem: str
    layers: Layers

    @property
    def arguments(self) -> list[str]:
        return [self.engine, self.problem, ",".join(map(str, self.layers))]


def entries(names: Sequence[str]) -> list[Entry]:
    """Small meshes first, so that a run cut short has all engines at one size."""
    out: list[Entry] = []
    for name in names:
        problem = PROBLEMS[name]
        for number, layers in enumerate(problem.ladder):
            wanted = [e for e in ENGINES if number < MESHES[name].get(e, len(problem.ladder))]
            out += [Entry(e, name, layers) for e in wanted]
        out.append(Entry("ours", name, problem.reference))
    return out


def limited(cap: float) -> Callable[[], None]:
    seconds = int(cap) + 20  # loading packages and compiled kernels is not part of the entry

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))

    return limit


def run(entry: Entry, cap: float) -> dict[str, Any]:
    found: dict[str, Any] = {
        "engine": entry.engine, "problem": entry.problem, "layers": entry.layers
    }  # fmt: skip
    # the reference answers are ours and may take their time
    cap = 1e4 if entry.layers == PROBLEMS[entry.problem].reference else cap
    try:
        done = subprocess.run(
            [sys.executable, "-m", "benchmarks.peer_entry", *entry.arguments],
            capture_output=True, text=True, check=False, timeout=20 * cap,
            preexec_fn=limited(cap), env={**os.environ, **dict.fromkeys(THREADS, "1")},
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return {**found, "failed": f"over {20 * cap:.0f} s of wall time"}
    if done.returncode == 0:
        return json.loads(done.stdout.splitlines()[-1])
    if done.returncode < 0:
        return {**found, "failed": f"over {cap:.0f} s"}
    last = (done.stderr.strip().splitlines() or ["no answer"])[-1]
    return {**found, "failed": last[-120:]}


def key(row: dict[str, Any]) -> tuple[str, str, Layers]:
    return row["engine"], row["problem"], tuple(row["layers"])


def collect(store: Path, names: Sequence[str], cap: float) -> list[dict[str, Any]]:
    rows = [json.loads(line) for line in store.read_text().splitlines()] if store.exists() else []
    known = {key(row) for row in rows}
    for entry in entries(names):
        if (entry.engine, entry.problem, entry.layers) in known:
            continue
        row = run(entry, cap)
        rows.append(row)
        with store.open("a") as file:
            file.write(json.dumps(row) + "\n")
        print(row.get("failed") or f"{row['cpu_s']:.2f} s", *entry.arguments, flush=True)
    return sorted(rows, key=order)


def order(row: dict[str, Any]) -> tuple[int, int, int]:
    """Problem, mesh, engine, as they are listed."""
    problem = PROBLEMS[row["problem"]]
    ladder = (*problem.ladder, problem.reference)
    place = ladder.index(tuple(row["layers"]))
    return list(PROBLEMS).index(row["problem"]), place, ENGINES.index(row["engine"])


def errors(rows: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """Answers with their error against the reference mesh of our own engine."""
    out: list[dict[str, Any]] = []
    for row in rows:
        problem = PROBLEMS[row["problem"]]
        wanted = ("ours", row["problem"], problem.reference)
        reference = next((r for r in rows if key(r) == wanted and "tip_mm" in r), None)
        if "tip_mm" not in row or reference is None:
            continue
        exact = np.array(reference["tip_mm"])
        off = float(np.linalg.norm(np.array(row["tip_mm"]) - exact) / np.linalg.norm(exact))
        found = {**row, "tip_error": off, "error": off}
        if row.get("plate_N") is not None:
            # the plate holds the tip, so that its force says more of the mesh
            found["force_error"] = abs(row["plate_N"] / reference["plate_N"] - 1)
            found["error"] = max(off, found["force_error"])
        out.append(found)
    return out


def table(rows: Sequence[dict[str, Any]], done: Sequence[dict[str, Any]]) -> str:
    lines = [
        "| problem | elements | engine | unknowns | iterations | tip error | force error | cpu s "
        "| MB |",
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |",
    ]
    by_key = {key(row): row for row in done}
    for row in rows:
        title = PROBLEMS[row["problem"]].title
        found = by_key.get(key(row))
        if found is None:
            lines.append(f"| {title} | layers {tuple(row['layers'])} | {row['engine']} | - | - | "
                         f"{row.get('failed', '-')} | - | - | - |")  # fmt: skip
            continue
        reference = tuple(row["layers"]) == PROBLEMS[row["problem"]].reference
        error = "reference" if reference else f"{100 * found['tip_error']:.2f} %"
        force = f"{100 * found['force_error']:.2f} %" if "force_error" in found else ""
        lines.append(
            f"| {title} | {found['elements']} | {found['engine']} | {found['unknowns']:,} | "
            f"{found['iterations']} | {error} | {force} | {found['cpu_s']:.2f} | "
            f"{found['peak_MB']:.0f} |"
        )
    return "\n".join(lines)


def exponents(done: Sequence[dict[str, Any]]) -> list[str]:
    """Growth of processor time with unknowns, engine by engine, over all problems: the slope of a
    straight line in logarithms, one offset per problem."""
    out: list[str] = []
    for engine in ENGINES:
        x: list[float] = []
        y: list[float] = []
        for name in PROBLEMS:
            own = [r for r in done if r["engine"] == engine and r["problem"] == name]
            if len(own) < 2:
                continue
            logs = np.log([[r["unknowns"], r["cpu_s"]] for r in own])
            x += list(logs[:, 0] - logs[:, 0].mean())
            y += list(logs[:, 1] - logs[:, 1].mean())
        if x:
            slope = float(np.dot(x, y) / np.dot(x, x))
            out.append(f"{engine}: seconds grow with unknowns to the power {slope:.2f}")
    for name, problem in PROBLEMS.items():
        own = [r for r in done if r["engine"] == "ours" and r["problem"] == name]
        if len(own) > 1:
            (small, quick), (large, slow) = sorted((r["unknowns"], r["cpu_s"]) for r in own)[-2:]
            slope = np.log(slow / quick) / np.log(large / small)
            out.append(f"ours, two largest meshes, {problem.title}: to the power {slope:.2f}")
    return out


def time_for(done: Sequence[dict[str, Any]], name: str, engine: str, error: float) -> float | None:
    """Least processor time of an answer at least this good."""
    good = [
        r["cpu_s"] for r in done
        if r["problem"] == name and r["engine"] == engine and r["error"] <= error
        and tuple(r["layers"]) != PROBLEMS[name].reference
    ]  # fmt: skip
    return min(good, default=None)


def ratios(done: Sequence[dict[str, Any]]) -> list[str]:
    out: list[str] = []
    for name, problem in PROBLEMS.items():
        for wanted in (0.05, 0.02, 0.01):
            mine = time_for(done, name, "ours", wanted)
            if mine is None:
                continue
            parts = [f"ours {mine:.2f} s"]
            for engine in ENGINES[1:]:
                theirs = time_for(done, name, engine, wanted)
                parts.append(f"{engine} " + (
                    "not reached" if theirs is None else f"{theirs:.1f} s ({theirs / mine:.0f} x)"
                ))  # fmt: skip
            out.append(f"{problem.title}, tip within {100 * wanted:g} %: {', '.join(parts)}")
    return out


def same_mesh(done: Sequence[dict[str, Any]]) -> list[str]:
    """Largest distance from ours on equal meshes."""
    mine = {key(r)[1:]: np.array(r["tip_mm"]) for r in done if r["engine"] == "ours"}
    out: list[str] = []
    for engine in ENGINES[1:]:
        off = [
            np.linalg.norm(np.array(r["tip_mm"]) - mine[key(r)[1:]])
            / np.linalg.norm(mine[key(r)[1:]])
            for r in done
            if r["engine"] == engine and key(r)[1:] in mine
        ]
        if off:
            out.append(f"{engine} against ours on equal meshes: at most {max(off):.1e} of the tip")
    return out


def draw(done: Sequence[dict[str, Any]], target: Path) -> None:
    import matplotlib

    matplotlib.use("svg")
    import matplotlib.pyplot as plt

    names = [name for name in PROBLEMS if any(r["problem"] == name for r in done)]
    figure, axes = plt.subplots(1, len(names), figsize=(4.2 * len(names), 3.6), squeeze=False)
    for axis, name in zip(axes[0], names, strict=True):
        for engine in ENGINES:
            own = sorted(
                (r["cpu_s"], 100 * r["error"]) for r in done
                if r["problem"] == name and r["engine"] == engine
                and tuple(r["layers"]) != PROBLEMS[name].reference
            )  # fmt: skip
            if own:
                axis.loglog(*zip(*own, strict=True), "o-", color=COLOURS[engine], label=engine)
        axis.axhline(1.0, color="0.7", lw=0.8)
        axis.set_title(PROBLEMS[name].title, fontsize=9)
        axis.set_xlabel("processor time, s")
        axis.grid(visible=True, which="both", lw=0.3)
    axes[0][0].set_ylabel("error of the tip (on the plate: or of its force), %")
    axes[0][0].legend(fontsize=8)
    figure.tight_layout()
    target.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(target, metadata={"Date": None})


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--to", type=Path, default=Path("build/peers"))
    parser.add_argument("--cap", type=float, default=600.0)
    parser.add_argument("--only", default=",".join(PROBLEMS))
    arguments = parser.parse_args()
    arguments.to.mkdir(parents=True, exist_ok=True)
    rows = collect(arguments.to / "peers.jsonl", arguments.only.split(","), arguments.cap)
    done = errors(rows)
    print(table(rows, done))
    for sentence in (*ratios(done), *exponents(done), *same_mesh(done)):
        print(sentence)
    draw(done, PICTURE)


if __name__ == "__main__":
    main()
