"""``python -m actuators.hard_cases.apart NAME RUNG``: a case's answer as JSON, in a process of its
own."""

import json
import sys

from actuators.hard_cases.asking import ask
from actuators.hard_cases.entries import read_cases
from actuators.hard_cases.question import question


def main() -> None:
    """Print the answer's document."""
    name, rung = sys.argv[1:]
    (case,) = (c for c in read_cases() if (c.name, c.rung) == (name, rung))
    print(json.dumps(ask(question(case), case.budget).to_document(), allow_nan=False))


if __name__ == "__main__":
    main()
