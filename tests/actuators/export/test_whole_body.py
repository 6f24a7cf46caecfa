"""Fields in the whole body as one archive of bounded size."""

import io
import json
import re
import xml.etree.ElementTree as ET
import zipfile

import pytest

from actuators.design import preset
from actuators.export.whole_body import WholeBody
from actuators.mechanics.continuum.progress import Monitor
from actuators.mechanics.continuum.solve import solve_with_states
from actuators.mechanics.scene import Scene

STEPS = 6


@pytest.fixture(scope="module")
def body() -> WholeBody:
    design = preset("slab-rectangle-low").design
    monitor = Monitor(None, None, None)
    return WholeBody(solve_with_states(design, Scene(1e3, steps=STEPS), monitor, mesh="coarse"))


def size_of_one(body: WholeBody) -> int:
    whole = body.archive(at_most=10**9)
    assert whole is not None
    return len(whole.zipped) // len(whole.points)


def test_all_points_where_they_fit(body: WholeBody) -> None:
    whole = body.archive(at_most=10**9)
    assert whole is not None
    assert whole.points == tuple(range(STEPS + 1))
    archive = zipfile.ZipFile(io.BytesIO(whole.zipped))
    files = body.files()
    assert {name: archive.read(name) for name in archive.namelist()} == files


def test_fewer_points_are_spread_and_hold_the_last_one(body: WholeBody) -> None:
    room = round(3.5 * size_of_one(body))
    part = body.archive(at_most=room)
    assert part is not None
    assert part.points == (0, 3, STEPS)
    assert len(part.zipped) < 1.1 * room
    archive = zipfile.ZipFile(io.BytesIO(part.zipped))
    entries = list(ET.parse(io.BytesIO(archive.read("answer.pvd"))).iter("DataSet"))
    assert [e.attrib["file"] for e in entries] == [f"answer-{k:03d}.vtu" for k in part.points]
    pressures = [p["pressure_kPa"] for p in json.loads(archive.read("answer.json"))["path"]]
    assert [float(e.attrib["timestep"]) for e in entries] == pytest.approx(
        [pressures[k] for k in part.points]
    )
    alone = body.archive(at_most=round(1.2 * size_of_one(body)))
    assert alone is not None
    assert alone.points == (STEPS,)
    names = zipfile.ZipFile(io.BytesIO(alone.zipped)).namelist()
    assert [n for n in names if re.search(r"vtu$", n)] == [f"answer-{STEPS:03d}.vtu"]


def test_none_where_not_even_the_last_one_fits(body: WholeBody) -> None:
    assert body.archive(at_most=1000) is None
