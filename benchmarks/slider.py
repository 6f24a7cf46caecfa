"""From slider input to the drawn plot: ``python -m benchmarks.slider ADDRESS`` of a running studio
(``make run``), in headless Chromium.

Every slider is dragged by 25 steps, one each 120 ms, as a hand moves it; the page itself measures
each from the input to the curve that answers it (User Timing, ``pneu:input-to-plot``). The ladder,
the effects and the cell and rod are asked for as they are when a designer drags: in the rests.
Times are those of whatever else the machine is doing.
"""

import argparse
import shutil
import sys
from statistics import median, quantiles

from playwright.sync_api import Page, sync_playwright

SLIDERS = (
    ("slab-rectangle-low", "pressure"),
    ("slab-rectangle-low", "bottom_thickness"),
    ("slab-rectangle-low", "chamber_count"),
    ("oblique-45", "pressure"),
    ("oblique-45", "length"),
    ("oblique-45", "wall_height"),
    ("bellows-9-2.0", "pressure"),
)
STEPS, PAUSE_MS = 25, 120
FLAGS = [
    "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--ignore-gpu-blocklist",
]  # fmt: skip


def drag(page: Page, slider: str) -> list[float]:
    """Milliseconds of every step that was drawn; steps overtaken by the next one are drawn once."""
    page.evaluate("performance.clearMeasures()")
    handle = page.get_by_test_id(f"slider-{slider}")
    handle.focus()
    for step in range(STEPS):
        handle.press("ArrowLeft" if step < STEPS // 2 else "ArrowRight")
        page.wait_for_timeout(PAUSE_MS)
    page.wait_for_timeout(3000)
    entries = "performance.getEntriesByName('pneu:input-to-plot').map((entry) => entry.duration)"
    return list(page.evaluate(entries))


def main() -> None:
    """Print a table of medians and 95th percentiles."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.slider")
    parser.add_argument("address", help="of a running studio, such as http://127.0.0.1:8123")
    address = parser.parse_args().address
    executable = shutil.which("chromium")
    if executable is None:
        sys.exit("chromium is not installed")
    print("| preset | slider | drawn | median, ms | 95th percentile, ms |")
    print("| --- | --- | --- | --- | --- |")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=executable, args=FLAGS)
        page = browser.new_page(viewport={"width": 1440, "height": 900})
        page.set_default_timeout(60_000)
        page.goto(address)
        for preset, slider in SLIDERS:
            page.get_by_test_id("open-presets").click()
            page.get_by_test_id(f"preset-{preset}").click()
            page.get_by_test_id("drawn-model").and_(page.locator("[data-rung=cell-rod]")).wait_for()
            page.wait_for_timeout(2000)
            took = drag(page, slider)
            print(
                f"| {preset} | {slider} | {len(took)} | {median(took):.0f} "
                f"| {quantiles(took, n=20)[-1]:.0f} |",
                flush=True,
            )
        browser.close()


if __name__ == "__main__":
    main()
