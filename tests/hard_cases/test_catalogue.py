"""The catalogue of hard cases: what comes out of each, and that the catalogue itself is sound."""

from pathlib import Path

import pytest

from actuators.hard_cases import Case, read_cases, run_case, selected

CASES = read_cases()
TOPICS = {
    "incompressibility", "slender", "contrast", "large_deformation", "limit_points", "angles",
    "laws", "contact", "gravity", "units", "numerics",
}  # fmt: skip


@pytest.mark.parametrize(
    "case",
    [
        pytest.param(case, id=case.title.replace(" ", ""),
                     marks=[pytest.mark.slow] if case.slow else [])
        for case in CASES
    ],
)  # fmt: skip
@pytest.mark.timeout(3000)
def test_hard_case_comes_out_as_it_must(case: Case) -> None:
    assert run_case(case).failures == ()


def test_there_are_at_least_120_cases_over_every_topic() -> None:
    assert len({(case.topic, case.name) for case in CASES}) >= 120
    assert {case.topic for case in CASES} == TOPICS


def test_120_cases_are_fast_on_a_rung() -> None:
    assert len({(case.topic, case.name) for case in CASES if not case.slow}) >= 120


def test_an_entry_that_means_nothing_is_refused(tmp_path: Path) -> None:
    entry = '[[case]]\nname = "a"\nhard = "x"\nrungs = ["energy"]\ndesign = {}\nscene = {}\n'
    for more, said in (("bugdet = 3", "bugdet"), ('check = [{quantity = "x"}]', "expects nothing")):
        (tmp_path / "topic.toml").write_text(entry + more)
        with pytest.raises(ValueError, match=said):
            read_cases(tmp_path)
    (tmp_path / "topic.toml").write_text(entry + entry)
    with pytest.raises(ValueError, match="twice"):
        read_cases(tmp_path)


def test_cases_are_chosen_by_topic_part_of_a_name_and_pattern() -> None:
    assert {c.topic for c in selected(CASES, only="gravity")} >= {"gravity"}
    assert all(c.name.startswith("theta-") for c in selected(CASES, only="theta-*"))
    assert not any(c.slow for c in selected(CASES, fast=True))
