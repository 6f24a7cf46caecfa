"""A designer's first half hour, in a real browser on the real studio."""

import io
import os
import re
import signal
import time
import xml.etree.ElementTree as ElementTree
import zipfile

import pytest
import trimesh
from playwright.sync_api import ConsoleMessage, Page, expect

from tests.end_to_end.conftest import downloaded, jobs, number, picture, set_number
from tests.running_studio import Run
from tests.worker.processes import processes_of

pytestmark = [pytest.mark.browser, pytest.mark.timeout(600)]


def test_edit_predict_solve_keep_look_and_cut(studio: Run, page: Page) -> None:
    errors: list[str] = []

    def listen(message: ConsoleMessage) -> None:
        if message.type == "error":
            errors.append(message.text)

    page.on("console", listen)

    # First run: a preset, already answered.
    page.goto(studio.address())
    expect(page.get_by_test_id("numbers")).to_be_visible()
    expect(page.get_by_test_id("number-bending_angle")).to_contain_text(re.compile(r"\d"))
    before = number(page, "bending_angle")
    picture(page, "1-first-run")

    # Edit: slider keys change the plotted answer; nonsense is refused in place.
    slider = page.get_by_test_id("parameter-bottom_thickness").locator("input[type=range]")
    slider.focus()
    for _ in range(5):
        slider.press("ArrowLeft")
    expect(page.get_by_test_id("undo")).to_be_enabled()
    end = time.monotonic() + 30  # no wait_for_function: its second look would need unsafe-eval
    while page.evaluate("performance.getEntriesByName('pneu:input-to-plot').length") == 0:
        assert time.monotonic() < end
        page.wait_for_timeout(100)
    page.wait_for_timeout(500)
    assert number(page, "bending_angle") != before
    set_number(page, "side_wall", "30")
    expect(page.get_by_test_id("problem-side_wall")).to_contain_text("Reduce side wall")
    picture(page, "2-refused")
    page.get_by_test_id("undo").click()
    expect(page.get_by_test_id("problem-side_wall")).to_have_count(0)
    set_number(page, "roof_thickness", "7")
    set_number(page, "pressure", "4")

    # Keep it.
    page.get_by_test_id("save").click()
    page.get_by_test_id("save-name").fill("Thick roof")
    page.get_by_test_id("save-note").fill("first try")
    page.get_by_test_id("save-confirm").click()
    expect(page).to_have_url(re.compile(r"/v/"))

    # Solve: 3D finite elements in the worker, which is killed on the way; the job finishes once.
    page.get_by_test_id("accuracy").get_by_text("10 %").click()
    page.get_by_test_id("run-fe").click()
    job = page.locator("[data-testid^=job-]").first
    expect(job).to_have_attribute("data-state", "running", timeout=60_000)
    asked = jobs(page)
    picture(page, "3-running")
    for line in processes_of(studio.data):
        if "worker" in line and "supervisor" not in line:
            os.kill(int(line.split()[0]), signal.SIGKILL)
    expect(job).to_have_attribute("data-state", "done", timeout=300_000)
    assert jobs(page) == asked
    expect(page.get_by_test_id("number-fe-bending_angle")).to_contain_text(re.compile(r"\d"))
    page.get_by_test_id("viewer-source").get_by_text("FE").click()
    expect(page.get_by_test_id("viewer-legend")).to_be_visible()
    picture(page, "4-solved")

    # Nothing is lost on reload.
    page.reload()
    expect(page.get_by_test_id("version-label")).to_be_visible()
    expect(page.get_by_test_id("number-fe-bending_angle")).to_contain_text(re.compile(r"\d"))

    # Find it again.
    page.get_by_test_id("open-history").click()
    history = page.get_by_test_id("history")
    expect(history.get_by_label("Design name").first).to_have_value("Thick roof")
    expect(history).to_contain_text("first try")
    expect(history).to_contain_text(re.compile(r"FE \d"))
    picture(page, "5-history")
    page.keyboard.press("Escape")

    # Cut and print.
    moulds = zipfile.ZipFile(io.BytesIO(downloaded(page, "mould-svg")))
    sheets = [name for name in moulds.namelist() if name.endswith(".svg")]
    assert sheets
    for name in sheets:
        sheet = ElementTree.fromstring(moulds.read(name))
        assert sheet.attrib["width"].endswith("mm")
    body = trimesh.load_mesh(io.BytesIO(downloaded(page, "actuator-stl")), file_type="stl")
    assert body.is_watertight
    assert body.extents[0] == pytest.approx(89.0, abs=1e-3)
    assert not errors, errors
