from __future__ import annotations

import stat
from pathlib import Path

import pytest

from knifetip.api import keys
from knifetip.errors import SettingsError


def test_a_key_file_is_made_once_with_a_random_key_for_its_owner_only(tmp_path: Path) -> None:
    file = tmp_path / "deep" / "key"
    first = keys.chosen("", file)
    assert len(first) >= 32
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert keys.chosen("", file) == first
    assert keys.chosen("", tmp_path / "other") != first


def test_no_key_is_an_empty_one_and_a_given_one_is_kept() -> None:
    assert keys.chosen("", None) == ""
    assert keys.chosen("long-enough", None) == "long-enough"


@pytest.mark.parametrize("key", ["short", "with space in it", "ä" * 20, "x" * 201, "line\nbreak-1"])
def test_what_is_no_key_is_refused(key: str, tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="key"):
        keys.chosen(key, None)
    file = tmp_path / "key"
    file.write_text(key, "utf-8")
    with pytest.raises(SettingsError, match="key"):
        keys.chosen("", file)


def test_an_empty_file_a_folder_and_two_keys_are_refused(tmp_path: Path) -> None:
    empty = tmp_path / "empty"
    empty.touch()
    for wrong in (empty, tmp_path):
        with pytest.raises(SettingsError, match=str(wrong)):
            keys.chosen("", wrong)
    with pytest.raises(SettingsError, match="Both"):
        keys.chosen("long-enough", tmp_path / "key")
    assert not (tmp_path / "key").exists()


@pytest.mark.parametrize("host", ["", "a b", "http://a", "a/b", "[::1", "a:b"])
def test_what_is_no_host_is_refused(host: str) -> None:
    assert keys.checked_hosts(["shop.example", "shop:80", "[::1]:8080"])
    with pytest.raises(SettingsError, match="host"):
        keys.checked_hosts(["shop", host])
