"""backend/Dockerfile and docker-compose.yml are consistent with the command line and the page."""

from __future__ import annotations

import json
import re
from pathlib import Path

import yaml

from knifetip.cli.main import load_command

ROOT = Path(__file__).resolve().parents[3]
DOCKERFILE = (ROOT / "backend" / "Dockerfile").read_text()
COMPOSE = yaml.safe_load((ROOT / "docker-compose.yml").read_text())


def test_the_start_command_is_one_that_the_command_line_takes() -> None:
    words = json.loads(re.findall(r"^CMD (\[.*\])$", DOCKERFILE, re.M)[-1])
    command = load_command(words[0])
    with command.make_context(words[0], words[1:]) as context:
        assert context.params["host"] == "0.0.0.0"
        assert context.params["database"].startswith("sqlite:////data/")


def test_kernels_are_compiled_for_the_processor_that_they_run_on() -> None:
    # The cache of machine code depends on these variables, so both stages must set the same.
    settings = re.findall(r"NUMBA_CPU_NAME=(\S+) NUMBA_CPU_FEATURES=(\S*)", DOCKERFILE)
    assert len(settings) == 2
    assert settings[0] == settings[1]


def test_the_image_has_the_extras() -> None:
    # Nothing can be installed into a container whose file system is read-only.
    assert re.findall(r"--require-hashes \\\n +-r (\S+)", DOCKERFILE) == [
        "backend/requirements-extras.lock"
    ]


def test_whatever_the_image_copies_is_sent_to_the_build() -> None:
    allowed = {
        line.removeprefix("!").rstrip("/")
        for line in (ROOT / ".dockerignore").read_text().splitlines()
        if line.startswith("!")
    }
    copies = re.findall(r"^COPY (?!--from)(.+) \S+$", DOCKERFILE, re.M)
    sources = [source for line in copies for source in line.split()]
    assert len(sources) > 5
    for source in sources:
        assert (ROOT / source).exists(), source
        assert any(source == entry or source.startswith(f"{entry}/") for entry in allowed), source


def test_compose_keeps_the_data_and_gives_the_machine_time_to_stop() -> None:
    service = COMPOSE["services"]["knifetip"]
    assert [volume.split(":")[1] for volume in service["volumes"]] == ["/data"]
    assert int(service["stop_grace_period"].removesuffix("s")) >= 10
    # The port is published to this machine only.
    assert all(port.startswith("127.0.0.1:") for port in service["ports"])
