"""A designer's job ends early, or without any answer, and the page says how, why and what to do."""

import os
import re
import signal
import time
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from actuators.design import preset
from storage import JobRow, Store, open_store
from tests.end_to_end.conftest import picture
from tests.running_studio import Run
from tests.worker.processes import processes_of

pytestmark = [pytest.mark.browser, pytest.mark.timeout(600)]

TWISTING = preset("oblique-45").design.to_document()
LONG = {"pressure_kPa": {"to": 20, "steps": 40}}
"""Some twenty seconds on the coarsest mesh."""


def asked(
    store: Store, name: str, scene: dict[str, Any], *, budget_s: float = 7200.0, **changes: Any
) -> JobRow:
    """A job of a design of its own, as a script may ask for it."""
    _, version = store.create_design(name, "ada", {**TWISTING, **changes}, scene, "")
    return store.submit(version.id, scene, "fe", 0.05, "ada", budget_s=budget_s, mesh="coarse")


def opened(page: Page, studio: Run, job: JobRow) -> Any:
    page.goto(f"{studio.address()}/v/{job.version_id}")
    return page.get_by_test_id(f"job-{job.id}")


@pytest.fixture
def store(studio: Run) -> Store:
    return open_store(f"sqlite:///{studio.data / 'pneustudio.sqlite'}")


def test_a_cancelled_job_shows_how_far_it_came(studio: Run, page: Page, store: Store) -> None:
    job = asked(store, "Cancelled", LONG, length_mm=120)
    row = opened(page, studio, job)
    expect(row).to_have_attribute("data-state", "running", timeout=60_000)
    expect(row).to_contain_text(re.compile(r"\d of 20"), timeout=120_000)
    page.get_by_test_id(f"cancel-{job.id}").click()
    expect(row).to_have_attribute("data-state", "cancelled")
    page.get_by_test_id("viewer-source").get_by_text("FE").click()
    end = page.get_by_test_id("path-end")
    expect(end).to_have_attribute("data-outcome", "cancelled")
    expect(end).to_contain_text(re.compile(r"found up to \d+\.\d+ of 20\.0 kPa \(cancelled\)"))
    expect(end).to_contain_text("last good shape. Run it again")
    picture(page, "9-cancelled")


def test_a_spent_budget_shows_how_far_it_came(studio: Run, page: Page, store: Store) -> None:
    job = asked(store, "Budget", LONG, budget_s=6, length_mm=121)
    row = opened(page, studio, job)
    expect(row).to_have_attribute("data-state", "done", timeout=120_000)
    expect(row).to_contain_text("Ended early")
    page.get_by_test_id("viewer-source").get_by_text("FE").click()
    end = page.get_by_test_id("path-end")
    expect(end).to_have_attribute("data-outcome", "budget_spent")
    expect(end).to_contain_text(re.compile(r"found up to .* of 20\.0 kPa \(time used up\)"))
    expect(end).to_contain_text("coarser accuracy")
    picture(page, "9-budget")


def test_a_job_whose_worker_is_lost_again_and_again_is_given_up(
    studio: Run, page: Page, store: Store
) -> None:
    job = asked(store, "Lost", LONG, length_mm=122)
    row = opened(page, studio, job)
    for attempt in (1, 2, 3):
        end = time.monotonic() + 60
        while (now := store.get_job(job.id)).attempt < attempt or now.fraction == 0:
            assert time.monotonic() < end, now
            page.wait_for_timeout(100)
        for line in processes_of(studio.data):
            if "worker" in line and "supervisor" not in line:
                os.kill(int(line.split()[0]), signal.SIGKILL)
    expect(row).to_have_attribute("data-state", "failed", timeout=60_000)
    expect(row).to_contain_text("Worker lost")
    end = page.get_by_test_id("path-end")
    expect(end).to_have_attribute("data-outcome", "worker_lost")
    expect(end).to_contain_text("given up, its worker was lost again and again")
    expect(end).to_contain_text("Ask for a coarser accuracy or mesh")
    expect(end).to_contain_text("The shape in view is that of")
    picture(page, "9-worker-lost")
    page.get_by_test_id("path-end-close").click()
    expect(end).to_have_count(0)


def test_a_refused_job_says_what_to_mend(studio: Run, page: Page, store: Store) -> None:
    job = asked(store, "Refused", LONG, length_mm=123)
    claimed = store.claim(job.id, worker="nobody", science_version=job.science_version)
    row = opened(page, studio, job)
    assert claimed is None or store.fail(
        job.id, claimed.attempt, "The roof is too thin. Thicken it.", why="refused",
        advice="Thicken it.",
    )  # fmt: skip
    expect(row).to_contain_text("Refused")
    end = page.get_by_test_id("path-end")
    expect(end).to_have_attribute("data-outcome", "refused")
    expect(end).to_contain_text("cannot be solved as it stands")
    expect(end).to_contain_text("Thicken it.")
    picture(page, "9-refused")
