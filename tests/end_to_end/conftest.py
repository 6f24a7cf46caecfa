"""A running studio and a page in the browser."""

import os
import signal
from collections.abc import Generator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page

from tests.running_studio import ROOT, Run
from tests.worker.processes import processes_of

PICTURES = ROOT / "test-artifacts"


@pytest.fixture
def studio(tmp_path: Path) -> Generator[Run]:
    run = Run(tmp_path / "studio", "--port", "8791")
    run.address()
    yield run
    run.process.send_signal(signal.SIGINT)
    run.process.wait(20)
    for line in processes_of(run.data):
        os.kill(int(line.split()[0]), signal.SIGKILL)


@pytest.fixture
def page(browser: Browser) -> Generator[Page]:
    context = browser.new_context(viewport={"width": 1440, "height": 900}, accept_downloads=True)
    page = context.new_page()
    page.set_default_timeout(30_000)
    yield page
    context.close()


def picture(page: Page, name: str) -> None:
    """Keep a screenshot where people look for it."""
    PICTURES.mkdir(exist_ok=True)
    page.screenshot(path=PICTURES / f"{name}.png")
