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

log = logging.getLogger(__name__)
_outlooks: OrderedDict[str, Outlook | None] = OrderedDict()
_lock = Lock()


def cost_model(store: Store) -> CostModel:
    """Prediction from the package's record and the store's latest jobs: of the one machine whose
    workers have reported, of all of them where there are several."""
    hosts = {row.name.rpartition("@")[2] for row in store.list_workers()}
    host = hosts.pop() if len(hosts) == 1 else None
    end = time.monotonic() + _PATIENCE_S
    jobs: list[PastJob] = []
    for row in store.recent_timings("fe", host=host, limit=LATEST):
        found = _known(row) if row.digest in _outlooks or time.monotonic() < end else None
        if found is not None:
            estimates = {n: e / 100 for n, e in row.estimates_percent.items() if e is not None}
            jobs.append(
                PastJob.of(found, row.seconds, row.unknowns, estimates, stopped=row.stopped)
            )
    return cost_record().model(jobs[::-1])


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
