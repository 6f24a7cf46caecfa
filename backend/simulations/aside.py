"""Answers that take longer than a slider waits, computed beside the web process.

The cell and rod takes some tenths of a second and the 3D solver's kernels. Both stay out of the web
process: one helper process computes one question after the other, at a lower priority. It is
started by the first question and ended when the studio ends, when it takes too long, or by a crash;
the next question starts another.
"""

import asyncio
import logging
import multiprocessing
import os
import signal
import threading
from collections import OrderedDict
from collections.abc import Awaitable, Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import Any

from actuators.design import PRESETS
from actuators.errors import DesignError, InputError, QuestionError, SceneError
from backend.designs.question import read_design, read_scene
from backend.problems import Busy
from backend.simulations import service
from backend.simulations.schemas import Prediction, PredictRequest
from storage.response_arrays import pack

PATIENCE_S = 60.0
"""For one answer; what takes longer belongs into the queue."""
_FIRST = 10
"""Times as long for a helper's first answer: it loads, and compiles kernels where they are new."""
_NICE = 5
_KEEP = 64
_REFUSALS: Mapping[str, type[InputError]] = {
    each.__name__: each for each in (DesignError, SceneError, QuestionError)
}

log = logging.getLogger(__name__)


@dataclass(frozen=True, eq=False)
class Kept:
    """What came of a question: an answer and its shape (`storage.response_arrays`), or why it has
    none."""

    prediction: Prediction | None
    refusal: InputError | None
    arrays: bytes = b""

    def given(self) -> Prediction:
        """The answer; raises the refusal."""
        if self.refusal is not None:
            raise self.refusal
        if self.prediction is None:
            raise RuntimeError("neither an answer nor a refusal")
        return self.prediction


class Aside:
    """One helper process and the latest answers it gave."""

    def __init__(self, patience_s: float = PATIENCE_S) -> None:
        self._patience_s = patience_s
        self._helper: _Helper | None = None
        self._turn = asyncio.Lock()
        self._kept: OrderedDict[str, Kept] = OrderedDict()
        self._lock = threading.Lock()

    @property
    def process(self) -> int | None:
        """Number of the helper's process; None while there is none."""
        return None if self._helper is None else self._helper.pid

    def kept(self, body: PredictRequest) -> Kept | None:
        """What came of the same question before; None where it was not asked lately."""
        with self._lock:
            return self._kept.get(_digest(body))

    async def answer(self, body: PredictRequest, is_gone: Callable[[], Awaitable[bool]]) -> Kept:
        """The helper's answer. Questions wait for their turn; one whose asker is gone by then (its
        page has asked something newer) is dropped. Raises :class:`Busy` where the helper takes too
        long or ends."""
        async with self._turn:
            found = self.kept(body)
            if found is not None:
                return found
            if await is_gone():
                raise Busy("Nobody waits for this answer any more.", mend="Ask again.")
            reply = await asyncio.to_thread(self._ask, body)
        found = _read(reply)
        with self._lock:
            self._kept[_digest(body)] = found
            while len(self._kept) > _KEEP:
                self._kept.popitem(last=False)
        return found

    def close(self) -> None:
        """End the helper."""
        helper, self._helper = self._helper, None
        if helper is not None:
            helper.end()

    def _ask(self, body: PredictRequest) -> dict[str, Any]:
        helper = self._helper
        if helper is None or not helper.alive:
            helper = self._helper = _Helper()
        try:
            return helper.ask(body.model_dump(), self._patience_s)
        except TimeoutError as late:
            self.close()
            raise Busy(
                f"{body.rung} takes longer than {self._patience_s:g} s here.",
                mend="Run 3D FE for this design, or ask again when the machine is less busy.",
            ) from late
        except (EOFError, OSError) as gone:
            self.close()
            log.warning("the helper process of %s ended while it computed", body.rung)
            raise Busy(
                f"The process that computes {body.rung} ended.", mend="Ask again, or run 3D FE."
            ) from gone


class _Helper:
    """A process that answers what comes through a pipe, until the pipe closes."""

    def __init__(self) -> None:
        context = multiprocessing.get_context("spawn")
        self._answered = False
        self._pipe, far = context.Pipe()
        self._process = context.Process(target=_serve, args=(far,), daemon=True)
        self._process.start()
        far.close()

    @property
    def alive(self) -> bool:
        return self._process.is_alive()

    @property
    def pid(self) -> int | None:
        return self._process.pid

    def ask(self, body: dict[str, Any], patience_s: float) -> dict[str, Any]:
        self._pipe.send(body)
        if not self._pipe.poll(patience_s if self._answered else _FIRST * patience_s):
            raise TimeoutError
        self._answered = True
        return self._pipe.recv()

    def end(self) -> None:
        self._process.kill()
        self._process.join(5)
        self._pipe.close()


def _serve(pipe: Connection) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the studio, which closes the pipe
    with suppress(OSError):
        os.nice(_NICE)
    _warm()
    with suppress(EOFError, KeyboardInterrupt):
        while True:
            pipe.send(_solve(PredictRequest.model_validate(pipe.recv())))


def _warm() -> None:
    """Load the kernels: no answer's own time holds that."""
    first = next(iter(PRESETS.values()))
    scene = {"pressure_kPa": {"to": first.pressure_to * 1e-3}}
    design = first.design.to_document()
    _solve(PredictRequest(design=design, scene=scene, rung="cell-rod"))


def _solve(body: PredictRequest) -> dict[str, Any]:
    """As data: what an exception carries besides its words does not survive the way back."""
    try:
        prediction, response = service.answered(body)
        return {"prediction": prediction.model_dump(), "arrays": pack(response)}
    except InputError as refusal:
        named = type(refusal).__name__
        return {
            "refused": named if named in _REFUSALS else QuestionError.__name__,
            "message": str(refusal), "field": refusal.field, "value": refusal.value,
            "mend": refusal.mend,
        }  # fmt: skip


def _read(reply: Mapping[str, Any]) -> Kept:
    if "prediction" in reply:
        return Kept(Prediction.model_validate(reply["prediction"]), None, reply["arrays"])
    refusal = _REFUSALS[reply["refused"]](
        reply["message"], field=reply["field"], value=reply["value"], mend=reply["mend"]
    )
    return Kept(None, refusal)


def _digest(body: PredictRequest) -> str:
    design, scene = read_design(body.design), read_scene(body.scene)
    return f"{design.digest}:{scene.digest}:{body.rung}:{body.c}:{body.beyond}"
