"""The viewer in a real Chromium: the page draws the body, scrubs without a gap, leaks nothing."""

import io
import time
from collections.abc import Generator, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, BrowserContext, Page

from backend.viewer import shading
from tests.backend.conftest import SCENE, SLAB, Served
from tests.backend.test_viewer_pictures import srgb

CALL = """async ([method, path, body]) => {
  const answer = await fetch(path, {method, headers: {'content-type': 'application/json'},
                                    body: JSON.stringify(body)});
  if (!answer.ok) throw new Error(await answer.text());
  return answer.status === 204 ? null : await answer.json();
}"""
# the number of coloured pixels of the viewer's canvas, at every drawn frame
WATCH = """() => {
  const source = document.querySelector('canvas[data-engine]');
  const copy = document.createElement('canvas');
  copy.width = 100; copy.height = 80;
  const context = copy.getContext('2d', {willReadFrequently: true});
  window.coloured = [];
  const look = () => {
    context.clearRect(0, 0, 100, 80);
    context.drawImage(source, 0, 0, 100, 80);
    const d = context.getImageData(0, 0, 100, 80).data;
    let n = 0;
    for (let i = 0; i < d.length; i += 4)
      if (Math.max(d[i], d[i + 1], d[i + 2]) - Math.min(d[i], d[i + 1], d[i + 2]) > 40) n++;
    window.coloured.push(n);
    requestAnimationFrame(look);
  };
  look();
}"""

# 0.4 s pass between frames, in which much arrives that otherwise comes one after the other
STALL = """() => {
  window.stall = setInterval(() => {
    const end = performance.now() + 400;
    while (performance.now() < end);
  }, 410);
}"""

QUICK_CHANGES = 40
# how many takes are visible at every drawn frame
COUNT_TAKES = """
let tools;
const scenes = new Set();
Object.defineProperty(window, "__THREE_DEVTOOLS__", {
  get: () => tools,
  set: (given) => {
    tools = given;
    tools.addEventListener("observe", ({detail}) => { if (detail.isScene) scenes.add(detail); });
  },
});
window.takes = [];
const look = () => {
  const shown = new Set();
  const walk = (node, visible) => {
    const on = visible && node.visible;
    if (on && node.userData.take) shown.add(node.userData.take);
    for (const child of node.children) walk(child, on);
  };
  for (const scene of scenes) walk(scene, true);
  window.takes.push(shown.size);
  requestAnimationFrame(look);
};
look();
"""

pytestmark = pytest.mark.browser


class Studio:
    """A tab that drives the API, and one that shows the view."""

    def __init__(self, context: BrowserContext, base: str) -> None:
        self.driver = context.new_page()
        self.driver.goto(f"{base}/")
        self.view = self.call("POST", "/api/views", {"dark": False})
        self.content()
        self.messages: list[str] = []
        self.page: Page = context.new_page()
        self.page.add_init_script(COUNT_TAKES)
        self.page.on("console", lambda m: self.messages.append(f"{m.type}: {m.text}"))
        self.page.on("pageerror", lambda e: self.messages.append(f"error: {e}"))
        self.page.goto(base + self.view["url"])
        self.page.wait_for_selector("canvas[data-engine]")
        self.page.evaluate(WATCH)
        self._drawn(60.0)

    def _drawn(self, seconds: float) -> None:
        # wait_for_function would evaluate text in the page, which its security policy forbids
        end = time.monotonic() + seconds
        while not self.page.evaluate("() => window.coloured.at(-1) > 100"):
            assert time.monotonic() < end, "the viewer has drawn no body"
            self.page.wait_for_timeout(100)

    def call(self, method: str, path: str, body: Any) -> Any:
        return self.driver.evaluate(CALL, [method, path, body])

    def content(self, scene: Any = SCENE, frame: int = 20, **change: Any) -> Any:
        source = {"kind": "instant", "design": {**SLAB, **change}, "scene": scene}
        body = {"source": source, "undeformed": scene is SCENE, "frame": frame}
        return self.call("PUT", f"/api/views/{self.view['view_id']}/content", body)

    def frame(self, index: int) -> None:
        self.call("PUT", f"/api/views/{self.view['view_id']}/frame", {"index": index})

    @contextmanager
    def stalled(self) -> Generator[None]:
        """The page's thread as on a machine that leaves it little time."""
        self.page.evaluate(STALL)
        yield
        self.page.evaluate("() => clearInterval(window.stall)")

    def picture(self) -> np.ndarray:
        return np.asarray(Image.open(io.BytesIO(self.page.screenshot())).convert("RGB")).astype(int)


@pytest.fixture(scope="module")
def studio(browser: Browser, served: Served) -> Iterator[Studio]:
    context = browser.new_context(viewport={"width": 500, "height": 400})
    yield Studio(context, served.base)
    context.close()


def test_the_view_shows_the_body_and_hides_visers_own_panel(studio: Studio, tmp_path: Path) -> None:
    studio.page.screenshot(path=tmp_path / "view.png")
    for panel in studio.page.query_selector_all("[data-floating-window], .mantine-Paper-root"):
        assert not panel.is_visible()
    refused = [m for m in studio.messages if "Content Security Policy" in m or "error:" in m]
    assert not refused, refused


def test_the_screen_shows_the_legends_colour_exactly(studio: Studio) -> None:
    weightless = {**SCENE, "gravity_m_s2": None}
    legend = studio.content(weightless, frame=0)["legend"]
    studio.page.wait_for_timeout(1000)
    # nothing has moved at zero pressure: every face has the lowest colour, under its own light
    lowest = [int(legend["stops"][0][1][k : k + 2], 16) / 255 for k in (1, 3, 5)]
    top = round((0.5 + 0.5 * shading.LIGHT[2]) * (shading.SHADES - 1))
    light = np.linspace(shading.DARKEST, shading.BRIGHTEST, shading.SHADES)[top]
    wanted = srgb(shading.to_linear(np.array(lowest)) * light)
    near = np.abs(studio.picture() - wanted).max(axis=-1) < 2.5
    studio.content()
    studio.page.wait_for_timeout(1000)
    assert near.mean() > 0.02, "the top face is not in the picture"


def test_new_content_replaces_the_old_without_a_gap_on_a_slow_machine(
    studio: Studio, served: Served
) -> None:
    room = served.app.state.rooms._rooms[studio.view["view_id"]]
    studio.page.evaluate("() => { window.coloured.length = 0 }")
    with studio.stalled():
        for k in range(4):
            before = room._take.name
            studio.content(roof_thickness_mm=5 + 0.3 * k)
            end = time.monotonic() + 60
            while room._take.name == before:
                assert time.monotonic() < end, "new content is not shown"
                studio.page.wait_for_timeout(50)
    studio.page.wait_for_timeout(200)
    counts = studio.page.evaluate("() => window.coloured")
    assert len(counts) > 10
    # bodies of nearly one shape: a gap, or old and new at once, would show
    assert min(counts) > 0.85 * max(counts)


def test_after_many_quick_changes_one_body_is_left(studio: Studio, served: Served) -> None:
    room = served.app.state.rooms._rooms[studio.view["view_id"]]
    studio.page.evaluate("() => { window.takes.length = 0 }")
    with studio.stalled():
        for k in range(QUICK_CHANGES):
            studio.content(roof_thickness_mm=5 + 0.02 * (k % 50), frame=k % 21)
            studio.page.wait_for_timeout(20 * (k % 4))
    end = time.monotonic() + 30
    while room._waiting is not None or room._next is not None:
        assert time.monotonic() < end, "the last content is not shown"
        studio.page.wait_for_timeout(50)
    studio.page.wait_for_timeout(1500)
    counts = studio.page.evaluate("() => window.takes")
    print(f"takes in view: {[(n, counts.count(n)) for n in sorted(set(counts))]}")
    # never two at once: what viser's page has yet to take away is not drawn
    assert max(counts) == 1
    assert counts[-1] == 1
    assert len(counts) > QUICK_CHANGES / 4


def test_scrubbing_moves_the_body_without_a_gap(studio: Studio) -> None:
    studio.frame(20)
    studio.page.wait_for_timeout(500)
    bent = studio.picture()
    studio.page.evaluate("() => { window.coloured.length = 0 }")
    for index in range(20, -1, -1):
        studio.frame(index)
    studio.page.wait_for_timeout(500)
    assert min(studio.page.evaluate("() => window.coloured")) > 100
    straight = studio.picture()
    assert (np.abs(straight - bent).max(axis=-1) > 40).mean() > 0.03


def test_the_camera_and_the_background_follow_their_buttons(studio: Studio) -> None:
    path = f"/api/views/{studio.view['view_id']}/appearance"
    before = studio.picture()
    studio.call("PUT", path, {"camera": "top"})
    studio.page.wait_for_timeout(800)
    assert (np.abs(studio.picture() - before).max(axis=-1) > 40).mean() > 0.05
    studio.call("PUT", path, {"dark": True})
    studio.page.wait_for_timeout(800)
    assert studio.picture()[5, 5].max() < 60


def test_a_page_whose_room_was_closed_says_nothing_to_a_new_one(studio: Studio) -> None:
    studio.call("DELETE", f"/api/views/{studio.view['view_id']}", {})
    studio.page.wait_for_timeout(500)
    answer = studio.page.goto(studio.page.url)
    assert answer is not None
    assert answer.status == 404
