"""``python -m benchmarks.hard_cases [--run] [--only PATTERN] [--fast] [--again]``."""

import argparse

from actuators.hard_cases import read_cases, run_case, selected
from benchmarks.hard_cases import page, store
from benchmarks.hard_cases.pictures import FOLDER, draw


def main() -> None:
    """Run what is asked for, then write the page."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.hard_cases")
    parser.add_argument("--run", action="store_true", help="run cases without a stored result")
    parser.add_argument("--again", action="store_true", help="run also those that have one")
    parser.add_argument("--only", help="cases of this topic, or with this in their name")
    parser.add_argument("--fast", action="store_true", help="without the slow ones")
    parser.add_argument("--pictures", action="store_true", help="draw the hardest anew")
    given = parser.parse_args()
    if given.run or given.again:
        cases = selected(read_cases(), only=given.only, fast=given.fast)
        for case in cases if given.again else store.lacking(cases):
            result = run_case(case)
            store.keep(result)
            print(f"{case.title}: {result.outcome} {result.seconds:.3g} s {result.failures or ''}")
    if given.pictures:
        hardest = page.worst(store.load())
        for old in FOLDER.glob("*.png"):
            old.unlink()
        for case in read_cases():
            if case.title in hardest:
                answer = run_case(case).answer
                if answer is not None:
                    draw(case.name, answer)
    page.write()


if __name__ == "__main__":
    main()
