"""A designer puts a plate under an actuator and reads the force, in a real browser."""

import io
import re
import sqlite3
import zipfile
from contextlib import closing

import pytest
from playwright.sync_api import Page, expect

from tests.end_to_end.conftest import downloaded, jobs, number, picture, set_number
from tests.running_studio import Run

pytestmark = [pytest.mark.browser, pytest.mark.timeout(600)]


def test_add_a_plate_solve_and_see_its_force(studio: Run, page: Page) -> None:
    page.goto(studio.address())
    expect(page.get_by_test_id("number-bending_angle")).to_contain_text(re.compile(r"\d"))
    page.get_by_test_id("choice-gravity").select_option("none")
    set_number(page, "pressure", "5")
    expect(page.get_by_test_id("at-pressure")).to_contain_text("at 5 kPa")
    free = number(page, "bending_angle")

    # A plate: the instant answer says that it is without it, nonsense is refused at its field.
    page.get_by_test_id("add-load").click()
    page.get_by_test_id("add-plate").click()
    expect(page.get_by_test_id("left-out")).to_contain_text("without plate")
    set_number(page, "plate.gap", "-1")
    expect(page.get_by_test_id("problem-plate.gap")).to_contain_text("between 0 and")
    expect(page.get_by_test_id("run-fe")).to_be_disabled()
    # What cannot be read is no value: only that is said, and nothing is kept or computed meanwhile.
    set_number(page, "plate.gap", "abc")
    expect(page.get_by_test_id("parameter-plate.gap").get_by_role("alert")).to_have_text(
        "Write a number in mm."
    )
    page.get_by_test_id("undo").click()
    expect(page.get_by_test_id("problem-plate.gap")).to_have_count(0)
    expect(page.get_by_test_id("field-plate.gap")).to_have_value("5")
    set_number(page, "plate.gap", "abc")
    for button in ("run-fe", "save"):
        expect(page.get_by_test_id(button)).to_be_disabled()
        expect(page.get_by_test_id(button)).to_have_attribute("title", re.compile("^Gap cannot"))
    set_number(page, "plate.gap", "1")

    # Solved on the coarsest mesh, which the accuracy then has no say in.
    page.get_by_test_id("mesh").select_option("coarse")
    page.get_by_test_id("run-fe").click()
    job = page.locator("[data-testid^=job-]").first
    expect(job).to_have_attribute("data-state", "done", timeout=300_000)
    expect(job).to_contain_text("coarse mesh")
    expect(page.get_by_test_id("number-fe-plate_force")).to_contain_text(re.compile(r"\d"))
    assert number(page, "fe-plate_force") > 0
    # what stands on a plate bends less than what is free
    assert number(page, "fe-bending_angle") < free
    expect(page.get_by_test_id("chart-force")).to_be_visible()
    # the view has turned to the answer, which the instant one leaves the plate out of
    expect(page.get_by_test_id("viewer-source").get_by_label("FE")).to_be_checked()
    page.get_by_test_id("viewer-colour").get_by_text("Contact").click()
    expect(page.get_by_test_id("viewer-legend")).to_contain_text("Contact pressure")
    picture(page, "6-plate")

    solved = jobs(page)

    # A fork has the answer of its origin at once.
    page.get_by_test_id("open-history").click()
    page.locator("[data-testid^=fork-]").click()
    expect(page.get_by_test_id("design-name")).to_have_value(re.compile("fork of v1"))
    expect(page.get_by_test_id("number-fe-plate_force")).to_contain_text(re.compile(r"\d"))
    assert jobs(page) == solved

    for what, cells in (("result-vtu", b"largest_principal_stress"), ("result-body", b"region")):
        fields = zipfile.ZipFile(io.BytesIO(downloaded(page, what)))
        assert "answer.pvd" in fields.namelist()
        assert b"contact_pressure_kPa" in fields.read("answer-001.vtu")
        assert cells in fields.read("answer-001.vtu")

    # Where the fields in the whole body are not kept, the page has the command that solves again.
    with closing(sqlite3.connect(studio.data / "pneustudio.sqlite")) as database:
        database.execute("UPDATE result SET body_files_sha256 = NULL, body_files_points = NULL")
        database.commit()
    page.reload()
    expect(page.get_by_test_id("number-fe-plate_force")).to_contain_text(re.compile(r"\d"))
    page.get_by_test_id("open-downloads").click()
    command = page.get_by_test_id("copy-whole-body")
    expect(command).to_be_enabled()
    expect(command).to_have_attribute("title", re.compile("--mesh coarse --what vtu"))
    expect(page.get_by_test_id("download-result-body")).to_have_count(0)
