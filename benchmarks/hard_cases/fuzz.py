"""``python -m benchmarks.hard_cases.fuzz RUNG COUNT [--seed N]``: random designs within the limits,
all of them judged, what went wrong collected.

How many ran, how they ended and what they took is added to docs/hard_cases_fuzz.json, which the
page quotes; each question that did not end as it must stands there with its design and scene.
"""

import argparse
import json
import resource
import signal
import time
import warnings
from collections import Counter
from pathlib import Path
from typing import Any

from hypothesis import HealthCheck, Phase, given, seed, settings

from actuators.design import Design
from actuators.errors import InputError
from actuators.hard_cases.case import Budget
from actuators.hard_cases.verdict import always
from actuators.mechanics.continuum.memory import memory_in_use
from actuators.mechanics.continuum.progress import Budget as Allowance
from actuators.mechanics.continuum.progress import Monitor
from actuators.mechanics.continuum.solve import solve_with_states
from actuators.mechanics.predict import predict
from actuators.mechanics.response import Response
from actuators.mechanics.scene import Scene
from tests.hard_cases.wild import full_scenes, plain_scenes, wild_designs

DATA = Path("docs/hard_cases_fuzz.json")
BUDGETS = {
    # iterations of a rod take 50 us each
    "closed-form": Budget(seconds=5.0, iterations=20000),
    "energy": Budget(seconds=5.0, iterations=20000),
    "cell-rod": Budget(seconds=30.0, iterations=20000),
    "fe": Budget(seconds=60.0, iterations=250),
}
HANGS = 4.0
"""Of the budget's processor time: what takes longer is ended."""


class Hang(Exception):
    """Raised where an answer takes far more processor time than it may."""


def _hang(number: int, frame: object) -> None:
    raise Hang("took too long and was ended")


def ask(design: Design, scene: Scene, rung: str) -> Response:
    """The answer of a rung; of the 3D one on a coarse mesh, within its budget."""
    if rung != "fe":
        return predict(design, scene, rung=rung)
    budget = BUDGETS[rung]
    allowed = Allowance(8 * budget.seconds, budget.iterations, budget.memory_mib * 2**20)
    return solve_with_states(design, scene, Monitor(budget=allowed), mesh="coarse").response


class Tally:
    """What came out of the questions asked so far."""

    def __init__(self, rung: str) -> None:
        self.rung, self.ran, self.slowest = rung, 0, 0.0
        self.outcomes: Counter[str] = Counter()
        self.failures: list[dict[str, Any]] = []
        self.memory: list[float] = []

    def ask(self, design: Design, scene: Scene) -> None:
        """Ask, judge, count."""
        budget, begun = BUDGETS[self.rung], time.process_time()
        wrong: list[str] = []
        signal.setitimer(signal.ITIMER_PROF, HANGS * budget.seconds)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                answer = ask(design, scene, self.rung)
            outcome = answer.outcome.value
            wrong += always(answer, time.process_time() - begun, budget)
        except InputError as refused:
            outcome = f"refused {refused.field}"
            wrong += [] if refused.mend else [f"refused without a mend: {refused}"]
        except Exception as broken:  # noqa: BLE001  collecting what goes wrong is the purpose
            outcome = "broken"
            wrong.append(f"{type(broken).__name__}: {broken}")
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0.0)
        self.ran += 1
        self.outcomes[outcome] += 1
        self.slowest = max(self.slowest, time.process_time() - begun)
        if self.ran % 50 == 0:
            self.memory.append(round(memory_in_use() / 2**20))
        if wrong:
            self.failures.append({"rung": self.rung, "wrong": wrong,
                                  "design": design.to_document(),
                                  "scene": scene.to_document()})  # fmt: skip
            print(json.dumps(self.failures[-1]), flush=True)

    def keep(self, number: int) -> None:
        """Add this slice to the file."""
        stored = json.loads(DATA.read_text()) if DATA.exists() else []
        stored = [s for s in stored if (s["rung"], s["seed"]) != (self.rung, number)]
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        stored.append(
            {"rung": self.rung, "seed": number, "ran": self.ran,
             "outcomes": dict(self.outcomes.most_common()), "slowest_s": round(self.slowest, 2),
             "memory_MiB": self.memory, "peak_MiB": round(peak), "failures": self.failures}
        )  # fmt: skip
        stored.sort(key=lambda s: (s["rung"], s["seed"]))
        DATA.write_text(json.dumps(stored, indent=1) + "\n")


def main() -> None:
    """Run one slice."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.hard_cases.fuzz")
    parser.add_argument("rung", choices=tuple(BUDGETS))
    parser.add_argument("count", type=int)
    parser.add_argument("--seed", type=int, default=1)
    wanted = parser.parse_args()
    signal.signal(signal.SIGPROF, _hang)
    tally = Tally(wanted.rung)
    solid, whole = wanted.rung == "fe", wanted.rung in ("fe", "cell-rod")

    @seed(wanted.seed)
    @settings(
        max_examples=wanted.count, database=None, deadline=None, phases=[Phase.generate],
        suppress_health_check=list(HealthCheck), derandomize=False,
    )  # fmt: skip
    @given(
        design=wild_designs(most_chambers=3 if solid else 60),
        scene=full_scenes() if whole else plain_scenes(),
    )
    def run(design: Design, scene: Scene) -> None:
        tally.ask(design, scene)

    run()
    tally.keep(wanted.seed)
    print(tally.rung, tally.ran, dict(tally.outcomes), f"slowest {tally.slowest:.3g} s",
          f"{len(tally.failures)} not as they must", flush=True)  # fmt: skip


if __name__ == "__main__":
    main()
