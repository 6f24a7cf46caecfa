"""What finished jobs tell about the next one."""

from storage import Store, VersionRow
from storage.question import science_version
from tests.storage.conftest import SCENE, SLAB


def answered(
    store: Store, version: VersionRow, seconds: float, *, accuracy: float = 0.05,
    worker: str = "w1@bench", outcome: str = "converged", mesh: str | None = None, **more: object,
) -> None:  # fmt: skip
    job = store.submit(version.id, SCENE, "fe", accuracy, "ada", mesh=mesh)
    taken = store.claim(job.id, worker=worker, science_version=science_version())
    assert taken is not None
    document = {
        "design": taken.design, "scene": taken.scene, "wall_s": seconds, "outcome": outcome,
        "advice": None, "path": [], **more,
    }  # fmt: skip
    store.finish(job.id, taken.attempt, document, b"arrays")


def test_timings_are_those_of_jobs_that_were_computed_to_an_end_or_stopped(
    store: Store, version: VersionRow
) -> None:
    answered(store, version, 3.0, accuracy=0.1)
    answered(store, version, 7.0, accuracy=0.05, mesh="coarse")
    answered(store, version, 60.0, accuracy=0.01, outcome="budget_spent")
    twin = store.create_design("Twin", "ada", SLAB, SCENE, "")[1]
    assert store.submit(twin.id, SCENE, "fe", 0.1, "ada").from_store
    found = store.recent_timings("fe")
    assert [(t.seconds, t.accuracy, t.mesh, t.stopped) for t in found] == [
        (60.0, 0.01, None, True), (7.0, 0.05, "coarse", False), (3.0, 0.1, None, False)
    ]  # fmt: skip
    assert found[0].design == SLAB
    assert found[0].scene["pressure_kPa"]["to"] == 30
    assert store.recent_timings("energy") == []
    assert [t.seconds for t in store.recent_timings("fe", limit=1)] == [60.0]


def test_of_clock_and_processor_the_fewer_seconds_count(store: Store, version: VersionRow) -> None:
    answered(store, version, 9.0, accuracy=0.1, cpu_s=3.0, unknowns=5000,
             error_estimates_percent={"tip": 2.0, "force": None})  # fmt: skip
    answered(store, version, 4.0, accuracy=0.05, cpu_s=7.5)
    answered(store, version, 5.0, accuracy=0.02, cpu_s=None)
    newest, between, first = store.recent_timings("fe")
    assert [newest.seconds, between.seconds, first.seconds] == [5.0, 4.0, 3.0]
    assert (first.unknowns, first.estimates_percent["tip"]) == (5000, 2.0)
    assert (newest.unknowns, newest.estimates_percent) == (0, {})


def test_a_job_that_somebody_stopped_tells_how_long_it_had_run(
    store: Store, version: VersionRow
) -> None:
    """Once; asked again and answered, the answer alone."""
    job = store.submit(version.id, SCENE, "fe", 0.1, "ada")
    taken = store.claim(job.id, worker="w1@bench", science_version=science_version())
    assert taken is not None
    store.cancel(job.id)
    document = {
        "design": taken.design, "scene": taken.scene, "wall_s": 40.0, "cpu_s": 30.0,
        "outcome": "cancelled", "advice": None, "path": [],
    }  # fmt: skip
    store.finish(job.id, taken.attempt, document, b"arrays")
    for host in (None, "bench"):
        found = store.recent_timings("fe", host=host)
        assert [(t.seconds, t.stopped) for t in found] == [(30.0, True)]
    answered(store, version, 90.0, accuracy=0.1)
    assert [(t.seconds, t.stopped) for t in store.recent_timings("fe")] == [(90.0, False)]


def test_timings_can_be_those_of_one_machine(store: Store, version: VersionRow) -> None:
    answered(store, version, 3.0, accuracy=0.1, worker="w1@bench")
    answered(store, version, 1.0, accuracy=0.05, worker="w1@fast_bench")
    assert [t.seconds for t in store.recent_timings("fe", host="bench")] == [3.0]
    assert store.recent_timings("fe", host="fast%") == []


def test_every_answer_to_a_question_is_found(store: Store, version: VersionRow) -> None:
    answered(store, version, 3.0, accuracy=0.1)
    answered(store, version, 7.0, accuracy=0.02)
    found = store.results_of(SLAB, SCENE)
    assert [r.accuracy for r in found] == [0.02, 0.1]
    assert store.results_of(SLAB, {"pressure_kPa": {"to": 31}}) == []
