"""Where the studio and the command line keep what they remember."""

import os
from collections.abc import Mapping
from pathlib import Path

from platformdirs import user_data_path


def data_folder(environment: Mapping[str, str] | None = None) -> Path:
    """PNEUSTUDIO_DATA, else the user's own data folder for this program; need not exist."""
    env = os.environ if environment is None else environment
    folder = Path(env.get("PNEUSTUDIO_DATA") or user_data_path("pneustudio", appauthor=False))
    return folder.expanduser().resolve()
