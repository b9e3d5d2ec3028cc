"""The access key of a server, as an option or in a file."""

from __future__ import annotations

from pathlib import Path

import pytest

from knifetip.cli.access_key import KeyOptions
from knifetip.errors import SettingsError


def test_the_key_is_sent_as_a_bearer_token(tmp_path: Path) -> None:
    file = tmp_path / "key"
    file.write_text("a-long-key\n")
    assert KeyOptions().headers == {}
    assert KeyOptions("another").headers == {"Authorization": "Bearer another"}
    assert KeyOptions(key_file=file).headers == {"Authorization": "Bearer a-long-key"}


def test_two_keys_or_no_file_are_refused(tmp_path: Path) -> None:
    for options in (KeyOptions("key", tmp_path / "key"), KeyOptions(key_file=tmp_path / "key")):
        with pytest.raises(SettingsError):
            assert options.headers
