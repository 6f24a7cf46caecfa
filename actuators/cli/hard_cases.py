"""The command that runs the catalogue of hard cases."""

from typing import TYPE_CHECKING

import click

from actuators.cli.studio import answer, json_option
from actuators.cli.tables import table

if TYPE_CHECKING:
    from actuators.hard_cases import Result


@click.command("hard-cases")
@click.option("--only", metavar="PATTERN", help="Cases of this topic, or with this in their name; "
              "* stands for anything.")  # fmt: skip
@click.option("--fast", is_flag=True, help="Leave out the slow ones.")
@json_option
def hard_cases(only: str | None, *, fast: bool, as_json: bool) -> int:
    """Run the catalogue of hard cases and print what came out.

    Exit code 0 where all came out as they must, 1 where one did not.
    """
    from actuators.hard_cases import read_cases, run_case, selected

    cases = selected(read_cases(), only=only, fast=fast)
    results: list[Result] = []
    for number, case in enumerate(cases, 1):
        click.echo(f"{number}/{len(cases)}  {case.topic}: {case.title}", nl=False, err=True)
        results.append(found := run_case(case))
        click.echo(
            f"  {found.outcome}, {found.seconds:.3g} s" + ("" if found.passed else ", FAILED"),
            err=True,
        )
    if as_json:
        answer([result.to_document() for result in results])
    else:
        _print(results)
    return int(any(not result.passed for result in results))


def _print(results: "list[Result]") -> None:
    headings = ("topic", "case", "rung", "outcome", "error", "iterations", "seconds", "")
    rows = [
        (r.case.topic, r.case.name, r.case.rung, r.outcome, r.error, r.iterations,
         round(r.seconds, 3), "" if r.passed else "FAILED")
        for r in results
    ]  # fmt: skip
    click.echo(table(headings, rows))
    failed = [r for r in results if not r.passed]
    for result in failed:
        click.echo(f"\n{result.case.topic}: {result.case.title}")
        for sentence in result.failures:
            click.echo(f"  {sentence}")
    click.echo(f"\n{len(results) - len(failed)} of {len(results)} came out as they must.")
