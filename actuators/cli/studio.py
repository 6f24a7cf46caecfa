"""The command group: one place where errors become messages and exit codes.

Answers go to standard output, all else to standard error. Exit 0 on an answer, also one that did
not converge, which is 3 with ``--strict``; 2 on bad input; 130 after Ctrl-C.
"""

import json
import sys
from collections.abc import Sequence
from typing import Any

import click

from actuators.errors import InputError
from actuators.mechanics.response import Outcome


class Studio(click.Group):
    """Group whose bad input is told in one sentence, as JSON where ``--json`` is among the
    arguments."""

    def main(self, args: Sequence[str] | None = None, *rest: Any, **extra: Any) -> Any:
        arguments = list(sys.argv[1:] if args is None else args)
        extra["standalone_mode"] = False
        as_json = "--json" in arguments
        try:
            result = super().main(arguments, *rest, **extra)
        except InputError as error:
            _report(str(error), error.field, error.value, error.mend, as_json=as_json)
            sys.exit(2)
        except click.exceptions.NoArgsIsHelpError as error:
            error.show()
            sys.exit(2)
        except click.UsageError as error:
            _report(*_usage(error), as_json=as_json)
            sys.exit(2)
        except click.ClickException as error:
            _report(error.format_message(), "", "", "", as_json=as_json)
            sys.exit(error.exit_code)
        except click.Abort:
            click.echo("Stopped.", err=True)
            sys.exit(130)
        sys.exit(result if isinstance(result, int) else 0)


def _usage(error: click.UsageError) -> tuple[str, str, str, str]:
    """Message, field, value and mend of a command line that click cannot read."""
    field = ""
    if isinstance(error, click.BadParameter) and error.param is not None:
        field = error.param.name or ""
    if isinstance(error, click.NoSuchOption):
        field = error.option_name
    mend = "" if error.ctx is None else f"See {error.ctx.command_path} --help."
    return error.format_message(), field, "", mend


def _report(message: str, field: str, value: str, mend: str, *, as_json: bool) -> None:
    if as_json:
        error = {"message": message, "field": field, "value": value, "mend": mend}
        click.echo(json.dumps({"error": error}, ensure_ascii=False), err=True)
        return
    said = mend.rstrip(".").casefold() in message.casefold()
    tail = "" if said else f" {mend}"
    click.echo(f"pneustudio: {message}{tail}", err=True)


def answer(document: Any) -> None:
    """One JSON document on standard output."""
    click.echo(json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False))


json_option = click.option(
    "--json", "as_json", is_flag=True, help="Print one JSON document instead of text."
)

ENDED_EARLY = 3
strict_option = click.option(
    "--strict", is_flag=True, help=f"Exit with code {ENDED_EARLY} where the path ended before what "
    "was asked for (limit_point, stalled, cancelled, budget_spent).",
)  # fmt: skip


def exit_code(outcome: Outcome, *, strict: bool) -> int:
    """Of an answer: not reaching the end is one as well, unless the caller wants it told apart."""
    return ENDED_EARLY if strict and outcome is not Outcome.CONVERGED else 0
