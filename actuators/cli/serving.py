"""The command that starts the studio itself."""

import os
import sys

import click


@click.command(context_settings={"ignore_unknown_options": True}, add_help_option=False)
@click.argument("arguments", nargs=-1, type=click.UNPROCESSED)
def serve(arguments: tuple[str, ...]) -> None:
    """Start the studio: page, workers and data folder (see serve --help)."""
    # the science does not import the web: the supervisor takes this process over
    sys.stdout.flush()
    sys.stderr.flush()
    os.execv(sys.executable, [sys.executable, "-m", "backend.supervisor", *arguments])
