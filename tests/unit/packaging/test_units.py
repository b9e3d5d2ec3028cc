"""The systemd units of the how-to page are valid, and their commands exist."""

from __future__ import annotations

import re
import shlex
import shutil
import subprocess
from pathlib import Path

import pytest

from knifetip.cli.main import load_command

PAGE = Path(__file__).resolve().parents[3] / "backend" / "docs" / "howto" / "run-a-shop.md"
UNITS: dict[str, str] = dict(
    re.findall(
        r"^`/etc/systemd/system/(\S+\.service)`.*?^```ini\n(.*?)^```", PAGE.read_text(), re.M | re.S
    )
)


def test_the_page_has_a_unit_for_each_part() -> None:
    assert list(UNITS) == [
        "knifetip.service", "knifetip-worker@.service", "knifetip-gateway@.service",
    ]  # fmt: skip


@pytest.mark.parametrize("name", UNITS)
def test_systemd_accepts_the_unit(name: str, tmp_path: Path) -> None:
    analyze = shutil.which("systemd-analyze")
    if analyze is None:
        pytest.skip("systemd-analyze is not installed")
    # The command must exist where the unit is verified.
    file = tmp_path / name.replace("@", "@one")
    file.write_text(UNITS[name].replace("/opt/knifetip/bin/knifetip", "/bin/true"))
    done = subprocess.run(
        [analyze, "verify", "--man=no", file], capture_output=True, text=True, check=False
    )
    complaints = [line for line in done.stderr.splitlines() if name.split("@")[0] in line]
    assert not complaints, done.stderr


@pytest.mark.parametrize("name", UNITS)
def test_the_command_of_a_unit_is_one_that_the_command_line_takes(name: str) -> None:
    (line,) = re.findall(r"^ExecStart=\S+ (.*)$", UNITS[name], re.M)
    words = shlex.split(line)
    with load_command(words[0]).make_context(words[0], words[1:]) as context:
        assert context.params


@pytest.mark.parametrize("name", UNITS)
def test_a_unit_keeps_secrets_in_credentials_and_its_user_is_not_root(name: str) -> None:
    unit = UNITS[name]
    assert "DynamicUser=yes" in unit
    assert "LoadCredential=" in unit
    assert not re.search(r"--key |KNIFETIP_KEY=|PASSWORD=", unit)
    assert "MemoryDenyWriteExecute" not in unit  # kernels are compiled at run time
