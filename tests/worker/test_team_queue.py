"""The team deployment for real: PostgreSQL, Redis, two workers."""

import os
import secrets
from collections.abc import Generator
from pathlib import Path

import pytest
import redis

from tests.storage.databases import database
from tests.worker.processes import Queue, kill_group

REDIS = os.environ.get("PNEUSTUDIO_TEST_REDIS", "redis://127.0.0.1:6379/15")


@pytest.fixture
def queue(tmp_path: Path) -> Generator[Queue]:
    broker = redis.Redis.from_url(REDIS)
    try:
        broker.ping()
    except redis.ConnectionError as error:
        pytest.skip(f"NOT TESTED ON REDIS: {REDIS} does not answer ({error})")
    name = f"pneustudio-test-{secrets.token_hex(6)}"
    with database("postgresql", tmp_path) as url:
        opened = Queue(
            {"PNEUSTUDIO_DATABASE": url, "PNEUSTUDIO_BROKER": REDIS, "PNEUSTUDIO_QUEUE": name},
            tmp_path,
        )
        try:
            yield opened
        finally:
            opened.close()
            # with what the killed worker had taken and never acknowledged
            broker.delete(name, *broker.scan_iter(f"*{name}*"), "unacked", "unacked_index")


def test_two_workers_share_the_jobs_and_the_death_of_one_loses_none(queue: Queue) -> None:
    doomed = queue.start_worker("w1")
    first = queue.ask(1)
    queue.wait_for_progress(first)
    queue.start_worker("w2")
    others = [queue.ask(k) for k in (2, 3)]
    kill_group(doomed)
    row = queue.wait(first)
    assert (row.state, row.attempt, row.lost) == ("done", 2, 1)
    rows = [queue.wait(job) for job in others]
    assert {r.state for r in rows} == {"done"}
    assert {r.attempt for r in rows} == {1}
    assert row.worker == "w2@test"
    cancelled = queue.ask(4)
    queue.wait_for_progress(cancelled, 0.05)
    queue.store.cancel(cancelled.id)
    assert queue.wait(cancelled).state == "cancelled"
