"""What the page shows while an answer is on its way, and where an answer means little."""

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, Route, expect

from tests.end_to_end.conftest import PICTURES, picture, set_number
from tests.running_studio import Run

pytestmark = [pytest.mark.browser, pytest.mark.timeout(600)]

KERNELS_MS = 400_000
"""The first answer of the cell and rod compiles its kernels where they are new."""
AT_ONCE_MS = 1000
"""Before anything is answered: an answer is held back for longer."""


def held(page: Page, address: str) -> Callable[[], None]:
    """Holds back what the page asks at an address, until the function returned is called."""
    routes: list[Route] = []
    pattern = re.compile(f"{address}$")

    def hold(route: Route) -> None:
        routes.append(route)

    def let_go() -> None:
        for route in routes:
            route.continue_()
        page.unroute(pattern)

    page.route(pattern, hold)
    return let_go


def at_rest(page: Page, studio: Run) -> None:
    """The first preset, answered by every instant model."""
    page.goto(studio.address())
    drawn = page.get_by_test_id("drawn-model")
    expect(drawn).to_have_attribute("data-rung", "cell-rod", timeout=KERNELS_MS)
    cell_rod = page.get_by_test_id("ladder-cell-rod")
    expect(cell_rod).to_have_attribute("data-state", "measured")
    expect(page.get_by_test_id("ladder")).to_have_attribute("data-asking", "false")


def test_the_ladder_of_an_earlier_question_is_pale_and_picks_nothing(
    studio: Run, page: Page
) -> None:
    at_rest(page, studio)
    let_go = held(page, "/api/ladder")
    set_number(page, "roof_thickness", "7")
    chart = page.get_by_test_id("ladder-chart")
    expect(chart).to_have_attribute("data-stale", "true", timeout=AT_ONCE_MS)
    expect(page.get_by_test_id("ladder-stale")).to_contain_text("Of the earlier question")
    expect(page.get_by_test_id("take-percent")).to_be_disabled()
    expect(page.get_by_test_id("ladder-fe10")).to_have_accessible_name(re.compile("earlier"))
    picture(page, "10-earlier-question")
    let_go()
    expect(chart).to_have_attribute("data-stale", "false")
    expect(page.get_by_test_id("ladder-stale")).to_have_count(0)
    expect(page.get_by_test_id("take-percent")).to_be_enabled()


def test_limits_say_what_they_can_be_and_that_an_answer_is_there(studio: Run, page: Page) -> None:
    at_rest(page, studio)
    field = page.get_by_test_id("limit-seconds")
    row = page.get_by_test_id("pick-seconds")
    for text in ("0", "-3"):
        field.fill(text)
        field.press("Enter")
        expect(row.get_by_role("alert")).to_contain_text("Must be above 0")
        expect(field).to_have_value(text)
        # a limit is no part of the design: it hinders no run
        expect(page.get_by_test_id("run-fe")).to_be_enabled()
    picture(page, "10-limit")
    field.fill("0.001")
    field.press("Enter")
    expect(row.get_by_role("alert")).to_have_count(0)
    expect(row).to_contain_text(re.compile(r"there.already"))
    expect(page.get_by_test_id("take-seconds")).to_have_attribute(
        "title", re.compile("is there already and costs nothing more .took")
    )


def test_a_refused_pressure_is_no_mark_to_correct_once_a_volume_ends_the_path(
    studio: Run, page: Page
) -> None:
    at_rest(page, studio)
    set_number(page, "pressure", "99999")
    expect(page.get_by_test_id("problem-pressure")).to_be_visible()
    expect(page.get_by_test_id("ladder-problem")).to_contain_text("Correct the marked parameter")
    let_go = held(page, "/api/predict")
    page.get_by_test_id("choice-control").get_by_text("Volume").click()
    run = page.get_by_test_id("run-fe")
    expect(run).to_have_attribute("title", "The change is being checked.", timeout=AT_ONCE_MS)
    expect(page.get_by_test_id("ladder-problem")).to_have_count(0, timeout=AT_ONCE_MS)
    expect(page.get_by_test_id("problem-elsewhere")).to_have_count(0)
    # the places of the body in view are those of a pressure: no number is told at such a volume
    expect(page.get_by_test_id("at-pressure")).to_have_count(0)
    expect(page.get_by_test_id("scrub-pressure")).to_have_class(re.compile("stale"))
    page.screenshot(path=PICTURES / "10-switched.png")
    let_go()
    expect(run).to_be_enabled()
    expect(page.get_by_test_id("at-pressure")).to_contain_text("ml")
    expect(page.get_by_test_id("scrub-pressure")).not_to_have_class(re.compile("stale"))
    set_number(page, "volume", "0")
    expect(page.get_by_test_id("problem-volume")).to_contain_text("above 0")


def test_numbers_beyond_a_models_range_are_pale_and_known_mismatches_named(
    studio: Run, page: Page
) -> None:
    at_rest(page, studio)
    page.get_by_test_id("ladder-energy").focus()
    page.keyboard.press("Enter")
    set_number(page, "pressure", "40")
    volume = page.get_by_test_id("number-cavity_volume")
    expect(volume).to_have_class("faded")
    expect(volume).to_have_attribute("title", re.compile("^Beyond the range of energy"))
    expect(page.get_by_test_id("beyond-range")).to_be_visible()
    expect(page.get_by_test_id("typical-error")).to_have_count(0)
    picture(page, "10-beyond-range")
    set_number(page, "pressure", "1")
    expect(volume).not_to_have_class("faded")
    page.get_by_test_id("open-presets").click()
    page.get_by_test_id("preset-printed-14").click()
    mismatch = page.get_by_test_id("known-mismatch")
    expect(mismatch).to_contain_text("bodies that were measured")
    expect(mismatch).to_have_attribute("title", re.compile("0.56 to 0.81 times"))
