"""Make docs/validation.md and its plots.

    python -m benchmarks.validation               # the page, from docs/validation_data.json
    python -m benchmarks.validation --compute     # solve what has no answer yet; then all of it
    python -m benchmarks.validation --compute --only theta --fresh
    python -m benchmarks.validation --collect     # all of it from the answers there are

Answers are kept in .cache/validation, one file a case: a study goes on where it was stopped.
"""

import argparse

from benchmarks.validation.data import collect, read, write
from benchmarks.validation.page import make_page
from benchmarks.validation.store import compute
from benchmarks.validation.studies import all_cases


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--compute", action="store_true")
    parser.add_argument("--collect", action="store_true")
    parser.add_argument("--only", help="group or key of the cases to solve; no page is made")
    parser.add_argument("--fresh", action="store_true", help="solve again what has an answer")
    given = parser.parse_args()
    if given.compute:
        wanted = [c for c in all_cases() if given.only in (None, c.group, c.key)]
        compute(wanted, fresh=given.fresh)
    if given.only is not None:
        return
    if given.compute or given.collect:
        write(collect(all_cases()))
    make_page(*read())


if __name__ == "__main__":
    main()
