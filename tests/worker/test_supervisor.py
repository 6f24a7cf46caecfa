"""One command: starts everything, ends everything, whatever happens to it."""

import json
import os
import re
import signal
import socket
import sys
import time
import urllib.request
from collections.abc import Generator
from pathlib import Path

import pytest

from backend.supervisor.__main__ import main
from backend.supervisor.child import Child, ChildGaveUpError
from storage import open_store
from tests.running_studio import Run
from tests.worker.processes import processes_of


@pytest.fixture
def data(tmp_path: Path) -> Generator[Path]:
    folder = tmp_path / "studio"
    yield folder
    for line in processes_of(folder):
        os.kill(int(line.split()[0]), signal.SIGKILL)


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def wait_until_gone(data: Path, timeout_s: float) -> None:
    deadline = time.monotonic() + timeout_s
    while processes_of(data) and time.monotonic() < deadline:
        time.sleep(0.05)
    assert processes_of(data) == []


def health(address: str) -> dict[str, object]:
    with urllib.request.urlopen(f"{address}/api/health", timeout=5) as reply:
        return json.load(reply)


def test_it_starts_serves_refuses_a_second_and_leaves_nothing_behind(data: Path) -> None:
    port = free_port()
    with socket.create_server(("127.0.0.1", port)):
        run = Run(data, "--port", str(port))
        address = run.address()
        assert address != f"http://127.0.0.1:{port}"
        assert f"Port {port} is taken" in run.said()
        assert health(address)["status"] == "ok"
        assert len(processes_of(data)) >= 5  # two guards, web, worker and its child

        second = Run(data)
        assert second.process.wait(20) == 1
        assert f"already runs on {data} at {address}" in second.said()

        run.process.send_signal(signal.SIGINT)
        assert run.process.wait(15) == 0
    assert processes_of(data) == []
    assert "Stopped." in run.said()


def test_killed_children_come_back_and_a_killed_supervisor_leaves_the_folder_free(
    data: Path,
) -> None:
    run = Run(data, "--port", "0")
    address = run.address()
    victims = [line for line in processes_of(data) if "guard.py" not in line]
    for line in victims:
        os.kill(int(line.split()[0]), signal.SIGKILL)
    deadline = time.monotonic() + 60
    while not {"web ended", "worker-1 ended"} <= set(re.findall(r"\S+ ended", run.said())):
        assert time.monotonic() < deadline, run.said()
        time.sleep(0.05)
    store = open_store(f"sqlite:///{data / 'pneustudio.sqlite'}")
    slab = {"family": "slab"}
    _, version = store.create_design("Finger", "ada", slab, {"pressure_kPa": {"to": 20}}, "")
    job = store.submit(version.id, {"pressure_kPa": {"to": 20}}, "energy", 0.05, "ada")
    while store.get_job(job.id).state != "done":
        assert time.monotonic() < deadline, store.get_job(job.id)
        time.sleep(0.05)
    store.close()
    assert health(address)["status"] == "ok"

    run.process.kill()
    again = Run(data, "--port", "0")  # waits for the first one's guards
    assert health(again.address())["status"] == "ok"
    again.process.send_signal(signal.SIGTERM)
    assert again.process.wait(15) == 0
    wait_until_gone(data, 1)


@pytest.mark.parametrize("host", ["0.0.0.0", "192.168.1.5", "example.org", "::"])
def test_it_serves_this_machine_only(
    tmp_path: Path, host: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PNEUSTUDIO_DATA", "")  # what --data sets is taken back with it
    assert main(["--data", str(tmp_path / "studio"), "--host", host]) == 1
    assert "this machine only" in capsys.readouterr().err
    assert not (tmp_path / "studio").exists()


def test_a_child_that_cannot_live_is_given_up_with_the_end_of_its_log(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("backend.supervisor.child._LONGEST_PAUSE_S", 0.1)
    ended: list[int] = []
    command = [sys.executable, "-c", "raise SystemExit('no page')"]
    child = Child("web", command, {}, tmp_path / "web.log", 1.0, ended=lambda: ended.append(1))

    def tend_for_ever() -> None:
        while True:
            child.tend()
            time.sleep(0.01)

    with pytest.raises(ChildGaveUpError, match=r"(?s)web ended 6 times.*code 1.*no page"):
        tend_for_ever()
    assert len(ended) == 6


def test_a_child_that_is_killed_again_and_again_is_started_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("backend.supervisor.child._LONGEST_PAUSE_S", 0.1)
    said: list[str] = []
    command = [sys.executable, "-c", "import os, signal; os.kill(os.getpid(), signal.SIGKILL)"]
    child = Child("worker-1", command, {}, tmp_path / "worker.log", 1.0, say=said.append)
    end = time.monotonic() + 60
    while len(said) < 8:
        assert time.monotonic() < end, said
        child.tend()
        time.sleep(0.01)
    assert all("ended with code 137; starting it again" in each for each in said)
    child.kill()
    child.wait(10)
