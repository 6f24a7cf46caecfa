"""Fields in the whole body come with a finite-element answer, and an answer comes without them."""

import io
import json
import zipfile
from pathlib import Path
from typing import Any

import meshio
import numpy as np
import pytest

from actuators.design import preset
from actuators.export import ModelQuestion, write
from actuators.mechanics.predict import predict
from actuators.mechanics.scene import Scene
from storage import JobRow, Store, open_store
from storage.body_files import BODY_FILES_AT_MOST
from worker.rungs import RUNGS, Solved
from worker.solving import solve_job

SLAB = preset("slab-rectangle-low").design
SCENE = {"pressure_kPa": {"to": 1, "steps": 2}}


@pytest.fixture
def store(tmp_path: Path) -> Store:
    opened = open_store(f"sqlite:///{tmp_path / 'studio.sqlite'}")
    opened.migrate()
    return opened


def solved(store: Store, mesh: str | None = None) -> JobRow:
    _, version = store.create_design("Finger", "ada", SLAB.to_document(), SCENE, "")
    job = store.submit(version.id, SCENE, "fe", 0.05, "ada", mesh=mesh)
    solve_job(store, job.id, worker="w")
    return store.get_job(job.id)


def fields(data: bytes, folder: Path) -> dict[str, np.ndarray]:
    file = folder / "read.vtu"
    file.write_bytes(data)
    read = meshio.read(file)
    return {"points": read.points, "cells": read.cells[0].data, **read.point_data}


def test_they_are_the_files_that_an_export_writes(store: Store, tmp_path: Path) -> None:
    result = store.get_result(solved(store, mesh="coarse").digest)
    assert result.body_files_sha256 is not None
    kept = zipfile.ZipFile(io.BytesIO(store.get_artifact(result.body_files_sha256)))
    exported = write(SLAB, "vtu", ModelQuestion(Scene.from_document(SCENE), mesh="coarse"))
    assert sorted(kept.namelist()) == sorted(exported)
    assert result.body_files_points == len(result.document["path"])
    for name in (name for name in kept.namelist() if name.endswith(".vtu")):
        ours, theirs = (fields(data, tmp_path) for data in (kept.read(name), exported[name]))
        assert set(ours) == set(theirs)
        for field, values in ours.items():
            # two solves differ in what their threads add up first
            scale = max(1e-9, float(np.abs(theirs[field]).max()))
            np.testing.assert_allclose(values, theirs[field], atol=1e-4 * scale, err_msg=field)
    assert json.loads(kept.read("answer.json"))["path"] == result.document["path"]


def test_an_answer_is_stored_where_they_are_too_large_or_cannot_be_made(
    store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[int] = []

    def too_large(at_most: int) -> None:
        asked.append(at_most)

    def broken(at_most: int) -> None:
        raise MemoryError

    for make, pressure in ((too_large, 1.0), (broken, 2.0)):

        def answer(design: Any, scene: Scene, make: Any = make, **_: Any) -> Solved:
            return Solved(predict(design, scene), make)

        monkeypatch.setitem(RUNGS, "fe", answer)
        monkeypatch.setitem(SCENE, "pressure_kPa", {"to": pressure, "steps": 2})
        row = solved(store)
        assert (row.state, row.outcome) == ("done", "converged")
        assert store.get_result(row.digest).body_files_sha256 is None
    assert asked == [BODY_FILES_AT_MOST]
