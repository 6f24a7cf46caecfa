"""How far the instant rungs are from the cell and rod: random designs of every family, at every
strain and pressure that they come to.

    python -m benchmarks.instant_error measure FILE [--designs 200] [--seconds 240] [--seed 21]
                                                    [--part 0/2]
    python -m benchmarks.instant_error write FILE...
    python -m benchmarks.instant_error draw FILE...      # needs matplotlib

``measure`` adds one line of JSON per design to FILE and leaves out those that stand there already,
so that it can be stopped and begun again, or run in parts side by side. ``write`` puts quantiles of
the error of the tip's displacement, by family, by the largest strain of the linear cell and by one
trait of the design, into the package (``typical_errors.json``) and docs/ladder.md, and prints them;
 ``draw`` puts the map over strain and pressure into docs/pictures. Designs are random ones
(``benchmarks/random_questions.py``) of 5 to 9 chambers, inflated under gravity.
"""

import argparse
import json
import math
import signal
import time
from collections.abc import Sequence
from datetime import date
from pathlib import Path
from typing import Any

import numpy as np

from actuators.design import FAMILIES, Design, parse_design
from actuators.errors import QuestionError
from actuators.mechanics.cell.row import chamber_row
from actuators.mechanics.ladder import typical as typical_module
from actuators.mechanics.ladder.answer import STILL
from actuators.mechanics.ladder.typical import TRAITS
from actuators.mechanics.predict import predict
from actuators.mechanics.response import Response
from actuators.mechanics.scene import STRONGEST, Scene
from benchmarks.random_questions import STRAINS, random_design

TABLE = Path(typical_module.__file__).parent / typical_module.FILE
DOCS = Path(__file__).parent.parent / "docs"
PICTURE, PAGE = DOCS / "pictures" / "error_map.png", DOCS / "ladder.md"
BEGIN, END = "<!-- instant errors: begin -->", "<!-- instant errors: end -->"
REFERENCE = "cell-rod"
CHAMBERS = (5, 9)
"""Fewer than five, and the reference misses the ends of the body itself."""
LEVELS = 7
STEPS = 12
FEWEST = 10
"""Designs that a level needs before it is written down."""
JUDGED = ("closed-form", "energy")
TRAIT = {"slab": "length_over_width", "printed": "meeting_strain"}
"""What designs are parted by; where nothing is said, by the pressure that a strain takes. Of
the traits that were tried the one that tells most of the error at a strain (correlation of the
logarithms: slab -0.84, printed -0.8, bellows -0.8, oblique 0.6 at small strain, then nothing)."""
GROUPS = {2: 28, 3: 60}
"""Into how many groups the designs of a family are parted, from so many on."""
PATIENCE_S = 40.0
"""Processor seconds that the reference may take; it usually answers in two."""

Entry = dict[str, Any]


def levels(family: str) -> np.ndarray:
    """Strains at which errors are read off, (LEVELS,)."""
    low, high = STRAINS[family]
    return np.geomspace(low / 2, high, LEVELS)


def design_of(seed: int, family: str, number: int) -> Design:
    """The same design for the same three, whatever was drawn before."""
    rng = np.random.default_rng([seed, list(FAMILIES).index(family), number])
    return random_design(rng, family, CHAMBERS)


def compared(design: Design) -> Entry:
    """Errors of each judged rung on the path of the reference, as far as that is to be trusted:
    ``pressure_kPa``, ``strain`` of the linear cell and ``errors`` (fractions of the tip's way), k
    each; only ``refused`` where the reference has no answer."""
    begun = time.process_time()
    per_pressure = chamber_row(design).largest_strain
    last = min(float(levels(design.family)[-1]) / per_pressure, STRONGEST)
    scene = Scene(last, steps=STEPS)
    signal.signal(signal.SIGPROF, _give_up)
    signal.setitimer(signal.ITIMER_PROF, PATIENCE_S)
    try:
        best = predict(design, scene, rung=REFERENCE)
    except QuestionError as refusal:
        return {"refused": str(refusal)}
    except TimeoutError:
        return {"refused": f"no answer within {PATIENCE_S:g} s of the processor"}
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
    pressure = np.array([p.pressure for p in best.path])
    trusted = pressure <= (math.inf if best.trusted_to is None else best.trusted_to)
    pressure = pressure[trusted]
    return {
        "outcome": best.outcome.value,
        "asked_kPa": _short(last / 1e3),
        "pressure_kPa": [_short(p / 1e3) for p in pressure],
        "strain": [_short(per_pressure * p) for p in pressure],
        "errors": {
            rung: [_short(e) for e in _errors(predict(design, scene, rung=rung), best, trusted)]
            for rung in JUDGED
        },
        "cpu": round(time.process_time() - begun, 2),
    }


def _give_up(*_: object) -> None:
    raise TimeoutError


def _errors(answer: Response, best: Response, at: np.ndarray) -> np.ndarray:
    pressure = np.array([p.pressure for p in best.path])[at]
    wanted = np.array([p.tip_displacement for p in best.path])[at]
    tried = np.array([p.pressure for p in answer.path])
    moved = np.array([p.tip_displacement for p in answer.path])
    moved = np.stack([np.interp(pressure, tried, column) for column in moved.T], axis=1)
    way = np.maximum(np.linalg.norm(wanted, axis=1), STILL * answer.design.length)
    return np.linalg.norm(moved - wanted, axis=1) / way


def measure(file: Path, seed: int, designs: int, seconds: float, part: tuple[int, int]) -> None:
    """Add designs to ``file`` until it holds ``designs`` of each family, or for so many seconds on
    the clock; of the numbers only those that leave ``part[0]`` divided by ``part[1]``."""
    there = {(e["seed"], e["family"], e["number"]) for e in read([file])} if file.exists() else ()
    end = time.monotonic() + seconds
    for number in range(part[0], designs, part[1]):
        for family in FAMILIES:
            if (seed, family, number) in there:
                continue
            if time.monotonic() > end:
                return
            design = design_of(seed, family, number)
            entry = {"seed": seed, "family": family, "number": number,
                     "design": design.to_document(), **compared(design)}  # fmt: skip
            with file.open("a") as out:
                out.write(json.dumps(entry) + "\n")
            told = f"{entry['outcome']}, {entry['cpu']} s" if "cpu" in entry else entry["refused"]
            print(number, family, told, flush=True)


def read(files: Sequence[Path]) -> list[Entry]:
    """Entries of files that :func:`measure` wrote."""
    return [json.loads(line) for file in files for line in file.read_text().splitlines()]


def read_off(entry: Entry, rung: str) -> np.ndarray:
    """Errors of ``rung`` at the family's levels, (LEVELS,), not a number beyond where the reference
    ends."""
    strain = np.array(entry["strain"])
    if len(strain) < 2:
        return np.full(LEVELS, np.nan)
    return np.interp(levels(entry["family"]), strain, entry["errors"][rung], right=np.nan)


def quantiles(
    family: str, rung: str, entries: Sequence[Entry], source: str
) -> dict[str, Any] | None:
    """Half and four fifths of the designs at each level that enough of them came to, in groups of
    designs by a trait."""
    trait = TRAIT.get(family, "pressure_per_strain_kPa")
    values = [TRAITS[trait](parse_design(entry["design"])) for entry in entries]
    order = np.argsort(values)
    count = max((n for n, least in GROUPS.items() if len(entries) >= least), default=1)
    found = [
        _group(family, rung, [(values[k], entries[k]) for k in part.tolist()])
        for part in np.array_split(order, count)
    ]
    known = [group for group in found if group is not None]
    if len(known) < count:
        return None
    source = f"{len(entries)} random designs against {source}"
    return {"source": source, "trait": trait, "groups": known}


def _group(family: str, rung: str, designs: Sequence[tuple[float, Entry]]) -> dict[str, Any] | None:
    if not designs:
        return None
    table = np.array([read_off(entry, rung) for _, entry in designs])
    there = np.isfinite(table).sum(axis=0) >= FEWEST
    if there.sum() < 2:
        return None
    half, most = np.nanquantile(table[:, there], [0.5, 0.8], axis=0)
    return {
        "middle": _short(float(np.median([value for value, _ in designs])), 3),
        "strain": [_short(x, 2) for x in levels(family)[there]],
        "half_below_percent": [_short(100 * x, 2) for x in half],
        "four_of_five_below_percent": [_short(100 * x, 2) for x in most],
    }


def _short(value: float, digits: int = 4) -> float:
    return float(f"{value:.{digits}g}")


def write(entries: Sequence[Entry]) -> None:
    """Put the quantiles into the package and print them."""
    document = json.loads(TABLE.read_text(encoding="utf-8"))
    source = f"{REFERENCE}, {date.today()}"
    for rung in JUDGED:
        for family in FAMILIES:
            known = [e for e in entries if e["family"] == family and len(e.get("strain", ())) > 1]
            entry = quantiles(family, rung, known, source)
            if entry is None:
                print(f"{rung}, {family}: too few answers ({len(known)})")
                continue
            document["rungs"][rung][family] = entry
            _print(rung, family, entry)
    TABLE.write_text(_compact(document) + "\n", encoding="utf-8")
    head, _, rest = PAGE.read_text().partition(BEGIN)
    _, _, tail = rest.partition(END)
    PAGE.write_text(f"{head}{BEGIN}\n{markdown(entries, document['rungs']['energy'])}{END}{tail}")


def markdown(entries: Sequence[Entry], families: dict[str, dict[str, Any]]) -> str:
    """What the energy rung is off by, as a table for docs/ladder.md."""
    lines = [
        "| energy rung | designs | about | at a strain of | half below | four of five below |",
        "| --- | --- | --- | --- | --- | --- |",
    ]
    for family in FAMILIES:
        count = sum(e["family"] == family and len(e.get("strain", ())) > 1 for e in entries)
        for group in families[family]["groups"]:
            shown = (0, len(group["strain"]) // 2, len(group["strain"]) - 1)
            cells = [
                " / ".join(f"{scale * group[name][k]:.2g}" for k in shown) + " %"
                for name, scale in (
                    ("strain", 100), ("half_below_percent", 1), ("four_of_five_below_percent", 1)
                )
            ]  # fmt: skip
            about = _about(families[family]["trait"], group["middle"])
            lines.append(f"| {family} | {count} | {about} | {' | '.join(cells)} |")
    passed = [e for e in entries if len(e.get("strain", ())) < 2]
    lines.append(f"\nPassed over, because cell-rod gave no answer: {len(passed)} designs.")
    return "\n".join(lines) + "\n"


def _about(trait: str, value: float) -> str:
    if trait == "length_over_width":
        return f"{value:.2g} times as long as wide"
    if trait == "meeting_strain":
        return f"walls meet at {100 * value:.2g} %"
    return f"{value:.3g} kPa over the strain"


def _print(rung: str, family: str, entry: dict[str, Any]) -> None:
    columns = ("strain", "half_below_percent", "four_of_five_below_percent")
    print(f"{rung}, {family} ({entry['source']})")
    for group in entry["groups"]:
        rows = zip(*(group[name] for name in columns), strict=True)
        cells = "; ".join(f"{100 * s:.3g} %: {h:.2g} / {m:.2g} %" for s, h, m in rows)
        print(f"  {entry['trait']} {group['middle']:.3g}: {cells}")


def _compact(document: dict[str, Any]) -> str:
    """One line per group."""
    rungs = []
    for rung, families in document["rungs"].items():
        told = []
        for family, entry in families.items():
            groups = ",\n     ".join(json.dumps(group) for group in entry["groups"])
            source = json.dumps(entry["source"])
            told.append(
                f'   "{family}": {{\n    "source": {source},\n    "trait": "{entry["trait"]}",\n'
                f'    "groups": [\n     {groups}\n    ]\n   }}'
            )
        rungs.append(f'  "{rung}": {{\n' + ",\n".join(told) + "\n  }")
    return '{\n "rungs": {\n' + ",\n".join(rungs) + "\n }\n}"


def draw(entries: Sequence[Entry]) -> None:
    """The map of the energy rung: every design a line over strain and pressure, coloured by its
    error."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot
    from matplotlib.collections import LineCollection
    from matplotlib.colors import LogNorm
    from matplotlib.ticker import LogLocator, NullFormatter

    figure, axes = pyplot.subplots(2, 2, figsize=(10, 7.5), layout="constrained")
    shades = LogNorm(0.01, 1.0)
    drawn = None
    for axis, family in zip(axes.flat, FAMILIES, strict=True):
        own = [e for e in entries if e["family"] == family and len(e.get("strain", ())) > 2]
        pieces, colours = [], []
        for entry in own:
            at = np.stack([entry["strain"], entry["pressure_kPa"]], axis=1)[1:]
            errors = np.array(entry["errors"]["energy"])[1:]
            pieces.append(np.stack([at[:-1], at[1:]], axis=1))
            colours.append(np.maximum(np.sqrt(errors[:-1] * errors[1:]), 0.01))
        drawn = LineCollection(
            list(np.concatenate(pieces)), array=np.concatenate(colours), norm=shades,
            cmap="turbo", linewidths=1.2,
        )  # fmt: skip
        axis.add_collection(drawn)
        axis.set(xscale="log", yscale="log", title=f"{family}, {len(own)} designs")
        axis.autoscale()
        axis.set(xlabel="largest strain of the linear cell", ylabel="pressure, kPa")
        for each, shown in ((axis.xaxis, lambda x, _: f"{100 * x:.2g} %"),
                            (axis.yaxis, lambda x, _: f"{x:g}")):  # fmt: skip
            each.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
            each.set_major_formatter(shown)
            each.set_minor_formatter(NullFormatter())
    assert drawn is not None
    bar = figure.colorbar(drawn, ax=axes, label="error of the tip's displacement", shrink=0.8)
    bar.set_ticks([0.01, 0.03, 0.1, 0.3, 1.0], labels=["1 %", "3 %", "10 %", "30 %", "100 %"])
    figure.savefig(PICTURE, dpi=80)


def _part(text: str) -> tuple[int, int]:
    which, of = text.split("/")
    return int(which), int(of)


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("what", choices=("measure", "write", "draw"))
    parser.add_argument("files", nargs="+", type=Path)
    parser.add_argument("--designs", type=int, default=200)
    parser.add_argument("--seconds", type=float, default=math.inf)
    parser.add_argument("--seed", type=int, default=21)
    parser.add_argument("--part", type=_part, default=(0, 1))
    asked = parser.parse_args()
    if asked.what == "measure":
        measure(asked.files[0], asked.seed, asked.designs, asked.seconds, asked.part)
    elif asked.what == "write":
        write(read(asked.files))
    else:
        draw(read(asked.files))


if __name__ == "__main__":
    main()
