"""Where things are, and the name of a question."""

from pathlib import Path

from storage.deployment import celery_settings, deployment
from storage.question import question_digest, science_version


def test_an_embedded_studio_keeps_everything_in_its_folder(tmp_path: Path) -> None:
    folder = tmp_path / "my studio"
    places = deployment({"PNEUSTUDIO_DATA": str(folder)})
    assert places.embedded
    assert places.database == f"sqlite:///{folder}/pneustudio.sqlite"
    options = celery_settings(places.broker)["broker_transport_options"]
    assert Path(options["data_folder_in"]) == folder / "queue" / "messages"
    assert (folder / "queue" / "control").is_dir()
    assert deployment(places.environment) == places


def test_a_team_names_its_servers() -> None:
    places = deployment(
        {"PNEUSTUDIO_DATABASE": "postgresql://db/pneu", "PNEUSTUDIO_BROKER": "redis://broker/0"}
    )
    assert not places.embedded
    assert celery_settings(places.broker)["broker_url"] == "redis://broker/0"


def test_every_part_of_a_question_changes_its_digest() -> None:
    base = ("d" * 64, "s" * 64, "fe", 0.05, "v" * 64)
    others = [("e" * 64, *base[1:]), (base[0], "t" * 64, *base[2:]),
              (*base[:2], "energy", *base[3:]),
              (*base[:3], 0.02, base[4]), (*base[:4], "w" * 64), (*base, "fine"),
              (*base, "1,0,1")]  # fmt: skip
    digests = {question_digest(*each) for each in [base, *others]}
    assert len(digests) == 8
    assert question_digest(*base) == question_digest(*base)
    assert len(science_version()) == 64
