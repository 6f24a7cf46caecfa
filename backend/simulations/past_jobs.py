"""What past jobs teach about the next one's seconds, kept between requests."""

import logging
import time
from collections import OrderedDict
from threading import Lock

from actuators.errors import InputError
from actuators.mechanics.ladder import CostModel, Outlook, PastJob, cost_record, outlook
from backend.designs.question import read_design, read_scene
from storage import Store, TimingRow

LATEST = 100
_PATIENCE_S = 0.3
"""What can be told of a job beforehand takes some milliseconds: those not known yet are made up to
here, latest first; the next request goes on."""
_KEEP = 1000
_KEEP_MODELS = 4
"""Of some megabytes each."""

log = logging.getLogger(__name__)
_outlooks: OrderedDict[str, Outlook | None] = OrderedDict()
_models: OrderedDict[tuple[tuple[str, float, bool], ...], CostModel] = OrderedDict()
_lock = Lock()


def read_record() -> None:
    """Work out what the package's record says (half a second), before somebody asks."""
    log.debug("jobs of the package's record: %d", cost_record().known.count)


def cost_model(store: Store) -> CostModel:
    """Prediction from the package's record and the store's latest jobs: of the one machine whose
    workers have reported, of all of them where there are several."""
    hosts = {row.name.rpartition("@")[2] for row in store.list_workers()}
    host = hosts.pop() if len(hosts) == 1 else None
    end = time.monotonic() + _PATIENCE_S
    jobs: list[PastJob] = []
    names: list[tuple[str, float, bool]] = []
    for row in store.recent_timings("fe", host=host, limit=LATEST):
        found = _known(row) if row.digest in _outlooks or time.monotonic() < end else None
        if found is not None:
            estimates = {n: e / 100 for n, e in row.estimates_percent.items() if e is not None}
            names.append((row.digest, row.seconds, row.stopped))
            jobs.append(
                PastJob.of(found, row.seconds, row.unknowns, estimates, stopped=row.stopped)
            )
    return _learnt(tuple(names), jobs[::-1])


def _learnt(names: tuple[tuple[str, float, bool], ...], jobs: list[PastJob]) -> CostModel:
    """What these jobs teach, worked out once for as long as they are the latest."""
    with _lock:
        if names in _models:
            _models.move_to_end(names)
            return _models[names]
    made = cost_record().model(jobs)
    with _lock:
        _models[names] = made
        while len(_models) > _KEEP_MODELS:
            _models.popitem(last=False)
    return made


def _known(row: TimingRow) -> Outlook | None:
    """What can be told of a job's question; None where it can no longer be read."""
    with _lock:
        if row.digest in _outlooks:
            _outlooks.move_to_end(row.digest)
            return _outlooks[row.digest]
    try:
        made = outlook(
            read_design(row.design), read_scene(row.scene), accuracy=row.accuracy, mesh=row.mesh
        )
    except InputError as error:
        log.info("no timing from result %s: %s", row.digest, error)
        made = None
    with _lock:
        _outlooks[row.digest] = made
        while len(_outlooks) > _KEEP:
            _outlooks.popitem(last=False)
    return made
