"""knifetip profile: list, show, export to a file and import from a file."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from knifetip.library import load
from tests.support.command import Command

ACME = """title = "Acme"
[[rule]]
type = "crease"
layer = "CUT"
"""


@pytest.fixture
def knifetip(knifetip: Command, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Command:
    """Return the function that runs ``knifetip``; it runs in a temporary folder."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("KNIFETIP_DATABASE", raising=False)
    return knifetip


def test_list_and_show_print_the_profiles_of_the_library(knifetip: Command) -> None:
    code, out, _ = knifetip("profile", "list", "--json")
    assert code == 0
    assert [row["name"] for row in json.loads(out)] == load.names("profiles")
    code, out, _ = knifetip("profile", "show", "german")
    assert code == 0
    assert 'crease       colour 5, line style "*DASH*"' in out


def test_an_exported_profile_can_be_used_as_a_file(knifetip: Command, tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    assert knifetip("profile", "export", "german", "-o", file)[0] == 0
    code, out, _ = knifetip("profile", "show", file, "--json")
    assert code == 0
    assert json.loads(out)["title"] == load.profile("german").title


def test_an_imported_profile_is_stored_and_found_by_name(knifetip: Command, tmp_path: Path) -> None:
    file, database = tmp_path / "Acme.toml", f"sqlite:///{tmp_path}/shop.sqlite"
    file.write_text(ACME)
    words = ("profile", "import", file, "--database", database)
    code, out, _ = knifetip(*words)
    assert (code, "stored as version 1" in out) == (0, True)
    code, _, err = knifetip(*words)
    assert (code, "already exists, at version 1" in err) == (3, True)
    assert "version 2" in knifetip(*words, "--replace")[1]
    assert knifetip("profile", "export", "acme", "--database", database)[1] == ACME
    assert "acme" in knifetip("profile", "list", "--database", database)[1]


def test_every_command_finds_a_stored_profile(
    knifetip: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    database = f"sqlite:///{tmp_path}/shop.sqlite"
    monkeypatch.setenv("KNIFETIP_DATABASE", database)
    (tmp_path / "acme.toml").write_text(ACME)
    assert knifetip("profile", "import", "acme.toml")[0] == 0
    assert knifetip("samples", tmp_path)[0] == 0
    code, out, _ = knifetip(
        "classify", tmp_path / "tuck-end-carton.dxf", "--profile", "acme", "--json"
    )
    # This profile has no rule for the folds.
    assert (code, json.loads(out)["questions"] != []) == (2, True)
    assert {edge["rule"] for edge in json.loads(out)["edges"] if edge["layer"] == "CUT"} != set()
    code, _, err = knifetip("classify", tmp_path / "tuck-end-carton.dxf", "--profile", "nobody")
    assert (code, "Choose one of acme, boxes-py" in err) == (3, True)


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("wrong.toml", "title = 'x'\n[[rule]]\ntype = 'glue'", "rule 1 → type is 'glue'"),
        ("latin.toml", "title = 'M\xfcller'", "not UTF-8 text"),
        ("a b.toml", ACME, "is not a valid name of a profile"),
    ],
)
def test_an_invalid_profile_is_refused(
    knifetip: Command, tmp_path: Path, name: str, text: str, words: str
) -> None:
    (tmp_path / name).write_bytes(text.encode("latin-1"))
    code, _, err = knifetip("profile", "import", tmp_path / name)
    assert code == 3
    assert words in err


def test_import_without_a_database_only_checks_the_file(knifetip: Command, tmp_path: Path) -> None:
    (tmp_path / "acme.toml").write_text(ACME)
    code, out, _ = knifetip("profile", "import", tmp_path / "acme.toml")
    assert (code, "the profile was not stored" in out) == (0, True)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["acme.toml"]
