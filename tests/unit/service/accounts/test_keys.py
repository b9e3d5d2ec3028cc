from __future__ import annotations

import stat
from pathlib import Path

import pytest

from knifetip.errors import SettingsError
from knifetip.service.accounts import server_key as keys


def test_a_key_file_is_made_once_with_a_random_key_for_its_owner_only(tmp_path: Path) -> None:
    file = tmp_path / "deep" / "key"
    first = keys.load_key("", file)
    assert len(first) >= 32
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert keys.load_key("", file) == first
    assert keys.load_key("", tmp_path / "other") != first


def test_a_missing_key_is_empty_and_a_given_one_is_used() -> None:
    assert keys.load_key("", None) == ""
    assert keys.load_key("long-enough", None) == "long-enough"


@pytest.mark.parametrize("key", ["short", "with space in it", "ä" * 20, "x" * 201, "line\nbreak-1"])
def test_invalid_keys_are_refused(key: str, tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="key"):
        keys.load_key(key, None)
    file = tmp_path / "key"
    file.write_text(key, "utf-8")
    with pytest.raises(SettingsError, match="key"):
        keys.load_key("", file)


def test_an_empty_file_a_folder_and_two_keys_are_refused(tmp_path: Path) -> None:
    empty = tmp_path / "empty"
    empty.touch()
    for wrong in (empty, tmp_path):
        with pytest.raises(SettingsError, match=str(wrong)):
            keys.load_key("", wrong)
    with pytest.raises(SettingsError, match="both"):
        keys.load_key("long-enough", tmp_path / "key")
    assert not (tmp_path / "key").exists()


@pytest.mark.parametrize("host", ["", "a b", "http://a", "a/b", "[::1", "a:b"])
def test_invalid_hosts_are_refused(host: str) -> None:
    assert keys.check_hosts(["shop.example", "shop:80", "[::1]:8080"])
    with pytest.raises(SettingsError, match="host"):
        keys.check_hosts(["shop", host])
