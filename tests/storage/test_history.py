"""Designs and their history."""

import pytest

from actuators.design import preset
from actuators.errors import DesignError, SceneError
from storage import HistoryError, NotFoundError, Store, VersionRow
from tests.storage.conftest import SCENE, SLAB

THICKER = preset("slab-rectangle-low").design.changed(bottom_thickness=3.1).to_document()
OBLIQUE = preset("oblique-45").design.to_document()


def test_a_design_starts_with_its_first_version(store: Store) -> None:
    design, first = store.create_design(" Long   finger ", "ada", SLAB, SCENE, "as moulded")
    assert (design.name, design.family, design.version_count) == ("Long finger", "slab", 1)
    assert (first.number, first.parent_id, first.author) == (1, None, "ada")
    assert first.document == SLAB
    assert first.scene["pressure_kPa"]["to"] == 30
    assert store.get_design(design.id) == design
    assert store.get_version(first.id) == first


def test_every_version_keeps_who_when_what_and_its_parent(
    store: Store, version: VersionRow
) -> None:
    second = store.add_version(version.design_id, None, "bob", THICKER, SCENE, "stiffer")
    branch = store.add_version(version.design_id, version.id, "eve", OBLIQUE, SCENE, "")
    history = store.list_versions(version.design_id)
    assert [v.number for v in history] == [1, 2, 3]
    assert [v.author for v in history] == ["ada", "bob", "eve"]
    assert (second.parent_id, branch.parent_id) == (version.id, version.id)
    assert history[0].created_at < history[1].created_at < history[2].created_at
    assert store.get_design(version.design_id).latest_version_id == branch.id
    assert store.get_design(version.design_id).updated_at == branch.created_at


def test_saving_the_same_twice_makes_no_second_version(store: Store, version: VersionRow) -> None:
    unchanged = store.add_version(version.design_id, version.id, "ada", SLAB, SCENE, "again")
    assert unchanged == version
    first_click = store.add_version(version.design_id, version.id, "ada", THICKER, SCENE, "")
    second_click = store.add_version(version.design_id, version.id, "ada", THICKER, SCENE, "")
    assert second_click == first_click
    assert len(store.list_versions(version.design_id)) == 2


def test_a_change_of_the_scene_alone_is_a_version(store: Store, version: VersionRow) -> None:
    other = {"pressure_kPa": {"to": 12}}
    assert store.add_version(version.design_id, None, "ada", SLAB, other, "").number == 2


def test_going_back_to_an_earlier_state_is_a_version(store: Store, version: VersionRow) -> None:
    thicker = store.add_version(version.design_id, version.id, "ada", THICKER, SCENE, "")
    back = store.add_version(version.design_id, thicker.id, "ada", SLAB, SCENE, "")
    assert back.number == 3
    assert back.design_digest == version.design_digest


def test_bad_input_stores_nothing(store: Store) -> None:
    with pytest.raises(DesignError):
        store.create_design("A", "ada", {**SLAB, "bottom_thickness_mm": -1}, SCENE, "")
    with pytest.raises(SceneError):
        store.create_design("A", "ada", SLAB, {"pressure_kPa": {"to": -300}}, "")
    for name in ("", "   ", "x" * 201):
        with pytest.raises(HistoryError) as refusal:
            store.create_design(name, "ada", SLAB, SCENE, "")
        assert refusal.value.field == "name"
    assert store.list_designs() == []
    assert store.last_event_seq() == 0


def test_a_version_of_another_design_is_no_parent(store: Store, version: VersionRow) -> None:
    other, _ = store.create_design("Other", "ada", OBLIQUE, SCENE, "")
    with pytest.raises(HistoryError) as refusal:
        store.add_version(other.id, version.id, "ada", THICKER, SCENE, "")
    assert refusal.value.field == "parent_version_id"
    assert len(store.list_versions(other.id)) == 1


def test_a_fork_is_a_new_design_that_knows_its_origin(store: Store, version: VersionRow) -> None:
    design, first = store.fork(version.id, "Variant", "bob")
    assert design.forked_from == version.id
    assert (first.number, first.parent_id, first.author) == (1, None, "bob")
    assert (first.document, first.scene) == (version.document, version.scene)
    store.add_version(design.id, None, "bob", THICKER, SCENE, "")
    assert len(store.list_versions(version.design_id)) == 1


def test_designs_are_found_by_words_of_name_and_author(store: Store) -> None:
    for name, author in (("Long finger", "ada"), ("Short finger", "bob"), ("100% Thumb", "ada")):
        store.create_design(name, author, SLAB, SCENE, "")

    def found(search: str) -> set[str]:
        return {d.name for d in store.list_designs(search)}

    assert found("FINGER") == {"Long finger", "Short finger"}
    assert found("finger ada") == {"Long finger"}
    assert found("%") == {"100% Thumb"}
    assert store.list_designs()[0].name == "100% Thumb"  # last changed first


def test_archiving_hides_a_design_and_restoring_brings_it_back(
    store: Store, version: VersionRow
) -> None:
    assert store.archive(version.design_id).archived
    assert store.list_designs() == []
    assert [d.id for d in store.list_designs(archived=True)] == [version.design_id]
    assert not store.archive(version.design_id, archived=False).archived
    assert len(store.list_versions(version.design_id)) == 1


def test_names_and_labels_can_be_changed(store: Store, version: VersionRow) -> None:
    assert store.rename(version.design_id, "Thumb").name == "Thumb"
    assert store.name_version(version.id, "moulded in March").label == "moulded in March"
    assert store.name_version(version.id, " ").label is None
    with pytest.raises(HistoryError):
        store.rename(version.design_id, " ")


def test_unknown_ids_are_said_to_be_unknown(store: Store) -> None:
    for ask in (
        store.get_design, store.get_version, store.list_versions, store.get_job, store.get_result,
        store.get_artifact, store.archive, store.cancel,
    ):  # fmt: skip
        with pytest.raises(NotFoundError, match="nowhere"):
            ask("nowhere")


def test_every_change_of_the_history_leaves_an_event(store: Store, version: VersionRow) -> None:
    start = store.last_event_seq()
    store.add_version(version.design_id, None, "bob", THICKER, SCENE, "")
    store.rename(version.design_id, "Thumb")
    store.name_version(version.id, "first")
    store.archive(version.design_id)
    events = store.events_after(start)
    assert [e.data["what"] for e in events] == ["version", "renamed", "labelled", "archived"]
    assert {e.subject for e in events} == {version.design_id}
    assert {e.kind for e in events} == {"history"}
