"""The one browser of all tests: Debian's Chromium, headless, drawing WebGL in software; and which
tests one process runs, where two share the work."""

import shutil
from collections.abc import Generator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, sync_playwright
from xdist.scheduler import LoadScopeScheduling

CHROMIUM_FLAGS = [
    "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--ignore-gpu-blocklist", "--disable-background-networking", "--disable-component-update",
    "--disable-sync", "--no-first-run",
]  # fmt: skip

# one database, one Redis, one browser, one set of studios at a time
ROOMS_OF_THE_STUDIO = {"backend", "end_to_end", "storage", "worker"}


class Shares(LoadScopeScheduling):
    """All tests of the running studio in one process; of the rest, each file in either."""

    def _split_scope(self, nodeid: str) -> str:
        file = nodeid.split("::")[0]
        return "studio" if ROOMS_OF_THE_STUDIO & set(Path(file).parts) else file


def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Shares:
    return Shares(config, log)


# per module: while playwright's loop runs in this thread, no other test may start one
@pytest.fixture(scope="module")
def browser() -> Generator[Browser]:
    executable = shutil.which("chromium")
    if executable is None:
        pytest.fail("chromium is not installed: `make chromium` installs it")
    with sync_playwright() as playwright:
        opened = playwright.chromium.launch(executable_path=executable, args=CHROMIUM_FLAGS)
        yield opened
        opened.close()
