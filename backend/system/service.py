"""Whether the studio works."""

from pathlib import Path

from actuators import __version__
from backend.system.schemas import Health, WorkerState
from storage import Store


def health(store: Store, page: Path) -> Health:
    """Health of web, database and workers."""
    alive = store.worker_alive()
    workers = store.list_workers()
    return Health(
        status="ok" if alive else "degraded",
        version=__version__,
        page_built=(page / "index.html").is_file(),
        worker=WorkerState(alive=alive, last_seen=workers[0].last_seen if workers else None),
    )
