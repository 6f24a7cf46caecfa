"""A designer asks what accuracy costs, and which effects the answer holds, in a real browser."""

import re

import pytest
from playwright.sync_api import Page, expect

from tests.end_to_end.conftest import number, picture, set_number
from tests.running_studio import Run

pytestmark = [pytest.mark.browser, pytest.mark.timeout(900)]

KERNELS_MS = 400_000
"""The first answer of the cell and rod compiles its kernels where they are new."""


def test_pick_a_model_by_error_and_time_and_force_an_effect(studio: Run, page: Page) -> None:
    page.goto(studio.address())
    set_number(page, "pressure", "4")
    drawn = page.get_by_test_id("drawn-model")

    # The hand rests: the cell and rod takes over, the energy curve stays, and the ladder has both.
    expect(drawn).to_have_attribute("data-rung", "cell-rod", timeout=KERNELS_MS)
    expect(page.get_by_test_id("typical-error")).to_contain_text(re.compile(r"within|measured"))
    expect(page.get_by_test_id("ladder-cell-rod")).to_have_attribute("data-state", "measured")
    expect(page.get_by_test_id("ladder-fe10")).to_have_attribute("data-state", "predicted")
    refined = number(page, "bending_angle")
    # the body in 3D is bent as its curve says
    shape = page.get_by_test_id("viewer-model")
    expect(shape).to_have_attribute("data-rung", "cell-rod")

    # A slider moves: energy answers at once. A click on its point keeps it.
    slider = page.get_by_test_id("slider-pressure")
    slider.focus()
    slider.press("ArrowRight")
    expect(drawn).to_have_attribute("data-rung", "energy")
    expect(shape).to_have_attribute("data-rung", "energy")
    page.get_by_test_id("undo").click()
    page.get_by_test_id("ladder-energy").focus()
    expect(page.get_by_test_id("ladder-card")).to_contain_text("Leaves out: large strain")
    page.keyboard.press("Enter")
    expect(drawn).to_have_attribute("data-rung", "energy")
    assert number(page, "bending_angle") != refined
    page.get_by_test_id("ladder-closed-form").locator(".hit").click()
    expect(drawn).to_have_attribute("data-rung", "closed-form")
    page.get_by_test_id("ladder-cell-rod").locator(".hit").click()
    expect(drawn).to_have_attribute("data-rung", "cell-rod", timeout=KERNELS_MS)
    picture(page, "7-ladder")

    # A limit picks a rung; a wider one a cheaper rung.
    picked = page.get_by_test_id("pick-percent")
    page.get_by_test_id("limit-percent").fill("10")
    page.get_by_test_id("limit-percent").press("Enter")
    expect(picked).to_have_attribute("data-rung", re.compile(r"\w"))
    page.get_by_test_id("limit-percent").fill("500")
    page.get_by_test_id("limit-percent").press("Enter")
    expect(picked).to_have_attribute("data-rung", re.compile("closed-form|energy|cell-rod"))

    # An effect by hand: it goes into the scene, marks the answer, and can be undone.
    gravity = page.get_by_test_id("effect-gravity")
    expect(gravity).to_have_attribute("data-choice", "auto")
    before = number(page, "bending_angle")
    gravity.click()
    page.get_by_test_id("choice-effect-gravity").get_by_text("Off").click()
    page.keyboard.press("Escape")
    expect(gravity).to_have_attribute("data-state", "off")
    expect(page.get_by_test_id("forced-effects")).to_contain_text("gravity off")
    expect(page.get_by_test_id("number-bending_angle")).not_to_contain_text(f"{before:.2f}")
    page.get_by_test_id("undo").click()
    expect(gravity).to_have_attribute("data-choice", "auto")
    expect(page.get_by_test_id("forced-effects")).to_have_count(0)

    # A point that has not run is run by a click, and is measured then.
    page.get_by_test_id("ladder-fe10").locator(".hit").click()
    job = page.locator("[data-testid^=job-]").first
    expect(job).to_have_attribute("data-state", "done", timeout=300_000)
    expect(page.get_by_test_id("ladder-fe10")).to_have_attribute("data-state", "measured")
    expect(page.get_by_test_id("viewer-source").get_by_label("FE")).to_be_checked()
    # the answer is in view already: the message offers nothing more
    expect(page.get_by_test_id("toasts")).not_to_contain_text("Show in 3D")
    # what its notes say of one number stands beside that number
    stretch = page.get_by_test_id("caveat-fe-max_stretch")
    expect(stretch).to_have_attribute("title", re.compile("inner edges .* grows with finer meshes"))

    # More pressure than there is an equilibrium for: the view says how far the path was found and
    # what to do, the ladder keeps the run as a point of the mesh that it was asked on.
    set_number(page, "pressure", "40")
    page.get_by_test_id("mesh").select_option("coarse")
    page.get_by_test_id("run-fe").click()
    end = page.get_by_test_id("path-end")
    expect(end).to_contain_text(
        re.compile(r"3D FE: found up to 12\.\d of 40\.0 kPa \(limit point\)"), timeout=300_000
    )
    expect(end).to_contain_text(re.compile("Stay below it, thicken roof and walls"))
    coarse = page.get_by_test_id("ladder-fecoarsemesh")
    expect(coarse).to_have_attribute("data-state", "measured")
    expect(coarse).to_have_accessible_name(re.compile(r"measured, up to its limit at 12\.\d kPa"))


def test_a_refused_design_is_mended_by_a_click(studio: Run, page: Page) -> None:
    page.goto(studio.address())
    page.get_by_test_id("open-presets").click()
    page.get_by_test_id("preset-oblique-45").click()
    set_number(page, "theta", "35")
    problem = page.get_by_test_id("problem-length")
    expect(problem).to_contain_text("need 110.4 mm")
    # the body in view is not that of the bench
    stage = page.get_by_test_id("viewer-stage")
    expect(stage).to_have_attribute("data-stale", "true")
    page.get_by_test_id("mend-length").click()
    expect(page.get_by_test_id("field-length")).to_have_value("110.5")
    expect(problem).to_have_count(0)
    expect(stage).to_have_attribute("data-stale", "false", timeout=KERNELS_MS)
    page.get_by_test_id("undo").click()
    expect(page.get_by_test_id("field-length")).to_have_value("107")
    expect(problem).to_be_visible()


def test_what_a_scene_forbids_is_said_where_it_is_offered(studio: Run, page: Page) -> None:
    page.goto(studio.address())
    # by then the 3D view has been drawn, in software, and the page has its thread to itself
    drawn = page.get_by_test_id("drawn-model")
    expect(drawn).to_have_attribute("data-rung", "cell-rod", timeout=KERNELS_MS)
    page.get_by_test_id("add-load").click()
    page.get_by_test_id("add-plate").click()
    # an instant model cannot carry it
    expect(page.get_by_test_id("ladder-unplotted")).to_contain_text("Plate is 5 mm away")
    expect(page.get_by_test_id("effect-plate_contact")).to_be_visible()
    # what does not go together is refused at the effects, and one click mends it
    for name, choice in (("plate_contact", "On"), ("finite_strain", "Off")):
        page.get_by_test_id(f"effect-{name}").click()
        page.get_by_test_id(f"choice-effect-{name}").get_by_text(choice, exact=True).click()
        page.keyboard.press("Escape")
    expect(page.get_by_test_id("problem-effects")).to_contain_text("Plate contact is switched on")
    expect(page.get_by_test_id("run-fe")).to_be_disabled()
    picture(page, "8-refused-effect")
    page.get_by_test_id("effects-auto").click()
    expect(page.get_by_test_id("problem-effects")).to_have_count(0)
    expect(page.get_by_test_id("run-fe")).to_be_enabled()
    # a deck of a volume would need a solve first
    page.get_by_test_id("choice-control").get_by_text("Volume").click()
    page.get_by_test_id("open-downloads").click()
    expect(page.get_by_test_id("download-inp")).to_be_disabled()
    expect(page.get_by_test_id("download-inp")).to_contain_text("A deck for a volume needs a solve")
