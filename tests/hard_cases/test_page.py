"""The page of hard cases is what was stored, and what was stored came out as it must."""

from actuators.hard_cases import read_cases
from benchmarks.hard_cases import page, store


def test_the_page_is_written_from_what_is_stored() -> None:
    assert page.PAGE.read_text() == page.text(store.load()), (
        "docs/hard_cases.md is not what is stored: run `python -m benchmarks.hard_cases`."
    )


def test_every_stored_run_is_of_a_case_and_came_out_as_it_must() -> None:
    known = {case.title for case in read_cases()}
    stored = store.load()
    assert set(stored) <= known
    assert [title for title, found in stored.items() if not found["passed"]] == []
