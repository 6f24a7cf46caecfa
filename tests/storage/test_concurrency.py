"""Many writers: no lock errors, no job claimed twice, no event missed by a reader of numbers."""

import subprocess
import sys
import threading
import time
from pathlib import Path

from storage import Store, VersionRow, open_store
from storage.question import science_version
from tests.storage.conftest import SCENE, SLAB

WRITER = """
import sys, time
from storage import open_store
store = open_store(sys.argv[1])
done = 0
end = time.monotonic() + 1
while time.monotonic() < end:
    store.worker_seen(sys.argv[2], "a" * 64)
    store.rename(sys.argv[3], f"{sys.argv[2]} {done}")
    done += 1
print(done)
"""


def test_four_processes_write_to_one_sqlite_file_without_a_lock_error(tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path / 'studio.sqlite'}"
    store = open_store(url)
    store.migrate()
    design, _ = store.create_design("Finger", "ada", SLAB, SCENE, "")
    writers = [
        subprocess.Popen(
            [sys.executable, "-c", WRITER, url, f"w{i}", design.id],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        )
        for i in range(4)
    ]  # fmt: skip
    written = 0
    for writer in writers:
        out, err = writer.communicate(timeout=60)
        assert writer.returncode == 0, err
        assert int(out) > 0, "a writer starved"
        written += int(out)
    assert store.last_event_seq() == written + 1
    store.close()


def test_a_job_wanted_by_many_is_claimed_once(store: Store, version: VersionRow) -> None:
    jobs = [store.submit(version.id, SCENE, "fe", 0.01 * k, "ada").id for k in range(1, 11)]
    claimed: list[str] = []

    def take_all() -> None:
        for job_id in jobs:
            if store.claim(job_id, worker="w", science_version=science_version()):
                claimed.append(job_id)

    threads = [threading.Thread(target=take_all) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sorted(claimed) == sorted(jobs)


def test_a_reader_of_numbers_misses_no_event_of_concurrent_writers(
    store: Store, version: VersionRow
) -> None:
    start = store.last_event_seq()
    count, writers = 25, 4

    def write(who: int) -> None:
        for i in range(count):
            store.name_version(version.id, f"{who} {i}")

    threads = [threading.Thread(target=write, args=(who,)) for who in range(writers)]
    for thread in threads:
        thread.start()
    seen: list[int] = []
    last = start
    deadline = time.monotonic() + 60
    while len(seen) < count * writers and time.monotonic() < deadline:
        new = store.events_after(last)
        seen += [e.seq for e in new]
        last = seen[-1] if seen else last
    for thread in threads:
        thread.join()
    assert seen == [e.seq for e in store.events_after(start)]
    assert len(seen) == count * writers
