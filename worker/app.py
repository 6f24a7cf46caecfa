"""The Celery app and its one task. The job table is the truth; a message only wakes a worker."""

from typing import Any

from celery import Celery

from storage import Store, open_store
from storage.deployment import TASK, celery_settings, deployment
from worker.solving import solve_job

_DEPLOYMENT = deployment()

app = Celery("pneustudio")
app.conf.update(
    celery_settings(_DEPLOYMENT.broker),
    task_acks_late=False,  # lost with its worker, a message is sent again by the sweep
    worker_prefetch_multiplier=1,
    worker_max_tasks_per_child=200,
    worker_proc_alive_timeout=120,  # a child loads the solver before it reports itself
    worker_hijack_root_logger=False,
    worker_enable_remote_control=False,
    worker_send_task_events=False,
)

_opened: list[Store] = []


def child_store() -> Store:
    """This process's store, opened at first use: connections must not cross a fork."""
    if not _opened:
        _opened.append(open_store(_DEPLOYMENT.database))
    return _opened[0]


@app.task(name=TASK, bind=True)
def solve(self: Any, job_id: str) -> None:
    """Compute the job ``job_id``, if it is still to be computed."""
    solve_job(child_store(), job_id, worker=self.request.hostname)
