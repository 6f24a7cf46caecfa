"""Command line ``pneustudio``: the studio's core without a browser."""

import click

from actuators import __version__
from actuators.cli.exporting import export
from actuators.cli.hard_cases import hard_cases
from actuators.cli.laddering import ladder
from actuators.cli.listings import materials, presets, show
from actuators.cli.predicting import predict
from actuators.cli.serving import serve
from actuators.cli.studio import Studio


@click.group(cls=Studio, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="pneustudio")
def main() -> None:
    """Design soft pneumatic actuators.

    DESIGN is a preset's name or a JSON file; quantities carry their units: 30kPa, 4mm, 45deg.
    """


for _command in (presets, materials, show, predict, ladder, export, hard_cases, serve):
    main.add_command(_command)

__all__ = ["main"]
