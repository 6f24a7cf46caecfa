"""What finished jobs teach about the next one's seconds, kept between requests."""

import logging
import time
from collections import OrderedDict
from threading import Lock

import numpy as np

from actuators.errors import InputError
from actuators.mechanics.ladder import CostModel, Timings, cost_record, features
from backend.designs.question import read_design, read_scene
from storage import Store, TimingRow

LATEST = 100
_PATIENCE_S = 0.3
"""Features of a job take some milliseconds: those not known yet are made up to here, latest first;
the next request goes on."""
_KEEP = 1000

log = logging.getLogger(__name__)
_features: OrderedDict[str, np.ndarray | None] = OrderedDict()
_lock = Lock()


def cost_model(store: Store) -> CostModel:
    """Prediction from the package's record and the store's latest jobs: of the one machine whose
    workers have reported, of all of them where there are several."""
    hosts = {row.name.rpartition("@")[2] for row in store.list_workers()}
    host = hosts.pop() if len(hosts) == 1 else None
    end = time.monotonic() + _PATIENCE_S
    jobs: list[tuple[np.ndarray, float]] = []
    for row in store.recent_timings("fe", host=host, limit=LATEST):
        found = _known(row) if row.digest in _features or time.monotonic() < end else None
        if found is not None:
            jobs.append((found, row.seconds))
    record = cost_record()
    return CostModel(record.timings, Timings.of(jobs[::-1]), record.spread)


def _known(row: TimingRow) -> np.ndarray | None:
    """Features of a job; None where its question can no longer be read."""
    with _lock:
        if row.digest in _features:
            _features.move_to_end(row.digest)
            return _features[row.digest]
    try:
        made = features(
            read_design(row.design), read_scene(row.scene), accuracy=row.accuracy, mesh=row.mesh,
            errors=cost_record().level_errors,
        )  # fmt: skip
    except InputError as error:
        log.info("no timing from result %s: %s", row.digest, error)
        made = None
    with _lock:
        _features[row.digest] = made
        while len(_features) > _KEEP:
            _features.popitem(last=False)
    return made
