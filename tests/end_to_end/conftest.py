"""A running studio and a page in the browser."""

import os
import re
import signal
import time
from collections.abc import Generator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.running_studio import ROOT, Run
from tests.worker.processes import processes_of

PICTURES = ROOT / "test-artifacts"
PATIENCE_MS = 30_000
"""A busy machine takes its time for the first answer."""

expect.set_options(timeout=PATIENCE_MS)


@pytest.fixture(scope="session")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Generator[Run]:
    """One for all: a page has its own bench, and what others saved only stands in the history."""
    run = Run(tmp_path_factory.mktemp("studio") / "studio", "--port", "8791")
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
    page.set_default_timeout(PATIENCE_MS)
    yield page
    context.close()


def picture(page: Page, name: str) -> None:
    """Keep a screenshot where people look for it."""
    expect(page.get_by_test_id("viewer-stage").get_by_label("Updating")).to_have_count(0)
    PICTURES.mkdir(exist_ok=True)
    page.screenshot(path=PICTURES / f"{name}.png")


def jobs(page: Page) -> int:
    """How many jobs the list holds."""
    return page.locator("[data-testid^=job-]").count()


def number(page: Page, name: str) -> float:
    """What the table of numbers shows, once it shows one."""
    cell = page.get_by_test_id(f"number-{name}")
    end = time.monotonic() + 20
    while True:
        text = cell.inner_text()
        found = re.search(r"-?\d+(\.\d+)?", text.replace("\u2212", "-"))
        if found:
            return float(found[0])
        assert time.monotonic() < end, f"{name} shows {text!r}"
        page.wait_for_timeout(100)


def set_number(page: Page, parameter: str, value: str) -> None:
    """Type into a parameter's field."""
    field = page.get_by_test_id(f"parameter-{parameter}").locator("input:not([type=range])")
    field.fill(value)
    field.press("Enter")


def downloaded(page: Page, what: str) -> bytes:
    """A file of the menu of files."""
    page.get_by_test_id("open-downloads").click()
    with page.expect_download() as waiting:
        page.get_by_test_id(f"download-{what}").click()
    return Path(waiting.value.path()).read_bytes()
