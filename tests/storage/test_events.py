"""Numbers of events, and forgetting them."""

from datetime import timedelta

from storage import Store, VersionRow


def test_pruning_forgets_old_events_and_never_gives_a_number_twice(
    store: Store, version: VersionRow
) -> None:
    last = store.last_event_seq()
    assert store.prune_events() == 0
    assert store.prune_events(timedelta(seconds=-1)) >= 1
    assert store.events_after(0) == []
    store.rename(version.design_id, "Thumb")
    assert store.events_after(0)[0].seq > last


def test_a_page_of_events_can_be_limited(store: Store, version: VersionRow) -> None:
    for i in range(5):
        store.rename(version.design_id, f"Name {i}")
    first = store.events_after(0, limit=3)
    rest = store.events_after(first[-1].seq)
    assert len(first) == 3
    assert len(rest) == 3  # the design itself left one


def test_workers_report_and_leave(store: Store) -> None:
    assert not store.worker_alive()
    store.worker_seen("w1@here", "a" * 64)
    store.worker_seen("w1@here", "b" * 64)
    (worker,) = store.list_workers()
    assert (worker.name, worker.science_version) == ("w1@here", "b" * 64)
    assert store.worker_alive()
    store.worker_left("w1@here")
    assert not store.worker_alive()
