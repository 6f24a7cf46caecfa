"""What commands remember must not reach the user's own folder."""

from pathlib import Path

import pytest


@pytest.fixture(autouse=True)
def own_folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """Data folder of the commands of one test."""
    monkeypatch.setenv("PNEUSTUDIO_DATA", str(tmp_path / "data"))
    return tmp_path / "data"
