"""Settings come from the command line, the environment and a file, in this order."""

from __future__ import annotations

from pathlib import Path
from typing import Any, cast

import click
import pytest
from click.testing import CliRunner

from knifetip.cli import service
from knifetip.cli.main import app, load_command
from knifetip.errors import SettingsError
from knifetip.logs import LogLevel
from knifetip.server import embedded
from knifetip.service.settings import Settings, WorkerSettings, load_settings
from tests.support.scripts import load_script

tables = load_script("field_tables")


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "knifetip.toml"
    path.write_text('max_rate = 10\nmax_burst = 20\nname = "hall"\nallow_host = ["a.example"]\n')
    return path


def test_the_command_line_precedes_the_environment_which_precedes_the_file(
    file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("KNIFETIP_MAX_BURST", "30")
    monkeypatch.setenv("KNIFETIP_MAX_LISTENERS", "40")
    found = load_settings(Settings, settings=file, max_listeners=50)
    assert (found.max_rate, found.max_burst, found.max_listeners) == (10, 30, 50)
    assert (found.max_connections, found.allow_host) == (256, ("a.example",))
    # All clients together may have eight times as many.
    assert (found.all_listeners, found.all_connections) == (400, 2048)


def test_the_environment_names_the_file_and_separates_values_by_spaces(
    file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("KNIFETIP_SETTINGS", str(file))
    monkeypatch.setenv("KNIFETIP_ALLOW_HOST", "b.example c.example:81")
    monkeypatch.setenv("KNIFETIP_NAME", "")  # as if it were not set
    found = load_settings(Settings)
    assert found.allow_host == ("b.example", "c.example:81")
    assert found.name == "hall"


def test_a_worker_skips_the_settings_of_the_server_in_the_same_file(file: Path) -> None:
    found = load_settings(WorkerSettings, settings=file)
    assert (found.name, found.processes) == ("hall", 1)


@pytest.mark.parametrize(
    ("text", "code", "words"),
    [
        ("max_rate = -1", "settings.invalid", "max_rate is -1"),
        ("max_rat = 1", "settings.invalid", "max_rat.*max_rate"),
        ("max_rate =", "settings.bad-file", "knifetip.toml"),
    ],
    ids=["limit", "misspelt", "no-toml"],
)
def test_an_invalid_file_is_refused_with_its_fault(
    tmp_path: Path, text: str, code: str, words: str
) -> None:
    path = tmp_path / "knifetip.toml"
    path.write_text(text)
    with pytest.raises(SettingsError, match=words) as caught:
        load_settings(Settings, settings=path)
    assert caught.value.message.code == code


def _served(monkeypatch: pytest.MonkeyPatch, *words: str) -> Settings:
    """Return the settings with which ``knifetip serve`` starts a server."""
    found: list[Settings] = []
    monkeypatch.setattr(embedded, "serve", lambda settings, _announce: found.append(settings))
    monkeypatch.setattr(service, "_prepare", lambda *_: None)
    done = CliRunner().invoke(cast(click.Command, app), ["serve", *words])
    assert done.exit_code == 0, done.output
    return found[0]


def test_options_and_variables_that_had_another_name_are_kept(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert _served(monkeypatch, "--keep-history", "7").keep_jobs == 7
    monkeypatch.setenv("KNIFETIP_KEEP_HISTORY", "8")
    assert _served(monkeypatch).keep_jobs == 8
    monkeypatch.setenv("KNIFETIP_KEEP_JOBS", "9")
    assert _served(monkeypatch).keep_jobs == 9


def test_switches_and_lists_of_the_command_line(monkeypatch: pytest.MonkeyPatch) -> None:
    words = ["--no-simulator", "--no-webhook-private", "--log-level", "info"]
    found = _served(monkeypatch, *words, "--allow-host", "a", "--allow-host", "b:8")
    assert (found.simulator, found.samples, found.webhook_private) == (False, True, False)
    assert (found.allow_host, found.log_level) == (("a", "b:8"), LogLevel.INFO)


def test_the_help_names_the_variable_and_the_default_of_an_option() -> None:
    command: Any = load_command("serve")
    options = {one.name: one for one in command.params}
    assert options["max_rate"].envvar == ["KNIFETIP_MAX_RATE"]
    assert "Default: 200." in options["max_rate"].help
    # These are set in the file or the environment only.
    assert not {"page", "processes", "max_body"} & options.keys()


def test_the_pages_of_settings_and_of_machine_files_follow_the_declarations() -> None:
    for path, text in tables.pages().items():
        assert path.read_text("utf-8") == text, "run: make tables"
