"""The cell and rod over HTTP: computed by a process of its own, which may hang or die."""

import asyncio
import os
import signal
from typing import Any

import numpy as np
import pytest
from fastapi.testclient import TestClient

from actuators.design import parse_design
from actuators.mechanics.predict import predict
from actuators.mechanics.scene import Scene
from backend.problems import Busy
from backend.simulations.aside import Aside
from backend.simulations.schemas import PredictRequest
from tests.backend.conftest import SLAB

QUESTION: dict[str, Any] = {"pressure_kPa": {"to": 2.0, "steps": 4}}
BODY = {"design": SLAB, "scene": QUESTION, "rung": "cell-rod"}


async def waiting() -> bool:
    return False


async def gone() -> bool:
    return True


def test_the_helper_gives_the_answer_of_the_science_and_the_ladder_has_it_measured(
    client: TestClient,
) -> None:
    answer = client.post("/api/predict", json=BODY)
    assert answer.status_code == 200, answer.text
    result = answer.json()["result"]
    wanted = predict(parse_design(SLAB), Scene.from_document(QUESTION), rung="cell-rod")
    tip = wanted.to_document()["path"][-1]["tip_mm"]
    assert result["rung"] == "cell-rod"
    assert result["path"][-1]["tip_mm"] == pytest.approx(tip, abs=1e-6)
    asked = {"design": SLAB, "scene": QUESTION, "run": ["energy"]}
    points = client.post("/api/ladder", json=asked).json()["points"]
    state = {point["rung"]: point["state"] for point in points}
    assert (state["cell-rod"], state["closed-form"]) == ("measured", "predicted")


def test_the_3d_view_bends_the_body_along_the_answers_own_line(client: TestClient) -> None:
    view = client.post("/api/views", json={}).json()["view_id"]
    source = {"kind": "instant", "design": SLAB, "scene": QUESTION}
    path = client.post("/api/predict", json=BODY).json()["result"]["path"]

    def shown(rung: str) -> Any:
        body = {"source": {**source, "rung": rung}}
        answer = client.put(f"/api/views/{view}/content", json=body)
        assert answer.status_code == 200, answer.text
        return answer.json()

    content = shown("cell-rod")
    assert content["rung"] == "cell-rod"
    assert content["pressures_kPa"] == [point["pressure_kPa"] for point in path]
    # nothing moves farther than the end face, which is as high as the tip's middle is far off
    moved = float(np.linalg.norm(path[-1]["tip_displacement_mm"]))
    assert content["legend"]["upper"] == pytest.approx(moved, rel=0.15)
    assert shown("energy")["legend"]["upper"] != content["legend"]["upper"]


def test_a_refusal_comes_back_with_its_field_and_mend(client: TestClient) -> None:
    scene = {**QUESTION, "effects": {"plate_contact": "on"}}
    refused = client.post("/api/predict", json={**BODY, "scene": scene})
    assert refused.status_code == 422
    assert refused.json()["detail"]["field"] == "effects.plate_contact"
    assert refused.json()["detail"]["mend"]


def test_a_question_whose_asker_is_gone_starts_no_process() -> None:
    aside = Aside()
    with pytest.raises(Busy):
        asyncio.run(aside.answer(PredictRequest.model_validate(BODY), gone))
    assert aside.process is None


def test_a_helper_that_takes_too_long_is_ended_and_the_asker_told() -> None:
    aside = Aside(patience_s=0.01)
    with pytest.raises(Busy, match="takes longer"):
        asyncio.run(aside.answer(PredictRequest.model_validate(BODY), waiting))
    assert aside.process is None


def test_a_helper_that_dies_is_replaced() -> None:
    aside = Aside()
    question = PredictRequest.model_validate(BODY)

    async def kill_then_ask() -> Any:
        asked = asyncio.create_task(aside.answer(question, waiting))
        while aside.process is None:
            await asyncio.sleep(0.02)
        os.kill(aside.process, signal.SIGKILL)
        with pytest.raises(Busy, match="ended"):
            await asked
        return await aside.answer(question, waiting)

    try:
        assert asyncio.run(kill_then_ask()).given().result.outcome == "converged"
    finally:
        aside.close()
