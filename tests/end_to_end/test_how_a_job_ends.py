"""A designer's job ends early, or without any answer, and the page says how, why and what to do."""

import os
import re
import signal
import sqlite3
import time
from contextlib import closing
from datetime import timedelta
from typing import Any

import pytest
from playwright.sync_api import Page, WebSocketRoute, expect

from actuators.design import preset
from storage import ClaimedJob, JobRow, Store, open_store
from tests.end_to_end.conftest import downloaded, number, picture
from tests.running_studio import Run
from tests.worker.processes import processes_of

pytestmark = [pytest.mark.browser, pytest.mark.timeout(600)]

TWISTING = preset("oblique-45").design.to_document()
LONG = {"pressure_kPa": {"to": 20, "steps": 40}}
"""Some twenty seconds on the coarsest mesh."""


def asked(
    store: Store,
    name: str,
    scene: dict[str, Any],
    *,
    budget_s: float = 7200.0,
    mesh: str | None = "coarse",
    **changes: Any,
) -> JobRow:
    """A job of a design of its own, as a script may ask for it."""
    _, version = store.create_design(name, "ada", {**TWISTING, **changes}, scene, "")
    return store.submit(version.id, scene, "fe", 0.05, "ada", budget_s=budget_s, mesh=mesh)


def opened(page: Page, studio: Run, job: JobRow) -> Any:
    page.goto(f"{studio.address()}/v/{job.version_id}")
    return page.get_by_test_id(f"job-{job.id}")


def wait_for_attempt(page: Page, store: Store, job: JobRow, attempt: int) -> None:
    """Until a worker computes a job for the so-manieth time."""
    end = time.monotonic() + 120
    while (now := store.get_job(job.id)).attempt < attempt or now.state != "running":
        assert time.monotonic() < end, now
        page.wait_for_timeout(50)


def kill_worker(studio: Run) -> None:
    for line in processes_of(studio.data):
        if "worker" in line and "supervisor" not in line:
            os.kill(int(line.split()[0]), signal.SIGKILL)


def farthest_kept(studio: Run) -> float:
    """How far running jobs had come when a part of their path was kept last, 0 where none is."""
    with closing(sqlite3.connect(studio.data / "pneustudio.sqlite")) as connection:
        return connection.execute("SELECT max(fraction) FROM part").fetchone()[0] or 0.0


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
        wait_for_attempt(page, store, job, attempt)
        kill_worker(studio)
    expect(row).to_have_attribute("data-state", "failed", timeout=60_000)
    expect(row).to_contain_text("Worker lost")
    end = page.get_by_test_id("path-end")
    expect(end).to_have_attribute("data-outcome", "worker_lost")
    expect(end).to_contain_text("given up, its worker was lost again and again")
    expect(end).to_contain_text("Ask for a coarser accuracy or mesh")
    expect(end).to_contain_text("The shape in view is that of")
    expect(page.get_by_test_id("show-part")).to_have_count(0)
    expect(page.get_by_test_id(f"attempts-{job.id}")).to_have_text("in 3 attempts")
    picture(page, "9-worker-lost")
    page.get_by_test_id("path-end-close").click()
    expect(end).to_have_count(0)


def test_a_job_that_is_lost_shows_the_last_good_shape_of_the_part_found(
    studio: Run, page: Page, store: Store
) -> None:
    job = asked(store, "Lost later", LONG, length_mm=124)
    row = opened(page, studio, job)
    end = time.monotonic() + 240
    while farthest_kept(studio) < 0.03:  # of the bar, whose first two fifths are the coarse path
        assert time.monotonic() < end, store.get_job(job.id)
        page.wait_for_timeout(200)
    for attempt in (1, 2, 3):
        wait_for_attempt(page, store, job, attempt)
        kill_worker(studio)
    expect(row).to_have_attribute("data-state", "failed", timeout=60_000)
    expect(row).to_contain_text(re.compile(r"up to \S+ of 20 kPa, is kept"))
    end_of_path = page.get_by_test_id("path-end")
    expect(end_of_path).to_contain_text("given up, its worker was lost again and again")
    # whoever comes to this address later has one click to it as well
    page.reload()
    page.get_by_test_id("show-part").click()
    expect(page.get_by_test_id("viewer-source").get_by_label("FE")).to_be_checked()
    expect(end_of_path).to_have_attribute("data-outcome", "worker_lost")
    expect(end_of_path).to_contain_text(re.compile(r"3D FE: found up to \S+ of 20\.0 kPa"))
    expect(end_of_path).to_contain_text("The last point of the slider is the last good shape")
    expect(end_of_path).to_contain_text("Ask for a coarser accuracy or mesh")
    assert number(page, "fe-bending_angle") != 0
    picture(page, "9-worker-lost-later")
    assert farthest_kept(studio) == 0, "it is the job's result now"


def held_by_nobody(
    store: Store, name: str, scene: dict[str, Any] = LONG, mesh: str | None = "coarse"
) -> tuple[JobRow, ClaimedJob]:
    """A job that no worker of the studio can take, for it has been taken."""
    for length_mm in range(130, 160):
        job = asked(store, name, scene, mesh=mesh, length_mm=length_mm)
        claimed = store.claim(job.id, worker="nobody", science_version=job.science_version)
        if claimed is not None:
            store.heartbeat(job.id, claimed.attempt, lease=timedelta(minutes=10))
            return job, claimed
    raise AssertionError("the studio's worker was faster thirty times")


def refuse(store: Store, claimed: ClaimedJob) -> None:
    assert store.fail(
        claimed.id, claimed.attempt, "The roof is too thin. Thicken it.", why="refused",
        advice="Thicken it.",
    )  # fmt: skip


def test_a_refused_job_says_what_to_mend(studio: Run, page: Page, store: Store) -> None:
    job, claimed = held_by_nobody(store, "Not solvable")
    row = opened(page, studio, job)
    refuse(store, claimed)
    expect(row).to_contain_text("Refused")
    end = page.get_by_test_id("path-end")
    expect(end).to_have_attribute("data-outcome", "refused")
    expect(end).to_contain_text("cannot be solved as it stands")
    expect(end).to_contain_text("Thicken it.")
    picture(page, "9-refused")


def test_a_job_that_takes_longer_than_expected_says_so(
    studio: Run, page: Page, store: Store
) -> None:
    told = {"value": 0.2, "low": 0.1, "high": 1.5}
    page.route(re.compile("/expected$"), lambda route: route.fulfill(json=told))
    job, claimed = held_by_nobody(store, "Late", {"pressure_kPa": {"to": 20}}, mesh=None)
    row = opened(page, studio, job)
    late = page.get_by_test_id(f"late-{job.id}")
    expect(late).to_contain_text("Longer than expected (0.2 s)")
    expect(row.locator(".job-elapsed")).to_have_attribute("title", re.compile("0.1 s and 1.5 s"))
    point = page.get_by_test_id("ladder-fe5")
    expect(point).to_have_accessible_name(re.compile("Longer than expected .* Is being computed"))
    picture(page, "9-late")
    refuse(store, claimed)
    expect(late).to_have_count(0)


def test_an_end_between_the_first_list_and_the_live_channel_is_not_missed(
    studio: Run, page: Page, store: Store
) -> None:
    job, claimed = held_by_nobody(store, "In between")

    def late(channel: WebSocketRoute) -> None:
        time.sleep(2)  # the page has its list of jobs by now, and the channel does not stand yet
        refuse(store, claimed)
        channel.connect_to_server()

    page.route_web_socket(re.compile("/api/live"), late)
    row = opened(page, studio, job)
    expect(row).to_have_attribute("data-state", "failed")


def test_a_deck_of_a_volume_comes_with_the_answer_that_says_its_pressures(
    studio: Run, page: Page, store: Store
) -> None:
    job = asked(
        store, "Filled", {"volume_ml": {"to": 2.5, "steps": 2}}, chamber_count=2, length_mm=40
    )
    row = opened(page, studio, job)
    expect(row).to_have_attribute("data-state", "done", timeout=120_000)
    page.get_by_test_id("viewer-source").get_by_text("FE").click()
    assert b"*AMPLITUDE, NAME=INFLATION" in downloaded(page, "inp")
