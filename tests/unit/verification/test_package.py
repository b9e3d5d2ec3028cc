"""The table of codes in the documentation of the package."""

from __future__ import annotations

import re
from pathlib import Path

import knifetip.verification as package

CODE = re.compile(r'"(verify\.[a-z0-9-]+)"')
ROW = re.compile(r"^(verify\.[a-z0-9-]+) +(\S.*)$", re.MULTILINE)
#: An error about an argument of ``verify``, not a finding.
ERROR = "verify.bad-tolerance"


def test_the_table_of_codes_has_the_modules_that_report_them() -> None:
    root = Path(str(package.__file__)).parent
    used: dict[str, set[str]] = {}
    for path in root.rglob("*.py"):
        if path.name != "__init__.py":
            module = ".".join(path.relative_to(root).with_suffix("").parts)
            for code in CODE.findall(path.read_text()):
                used.setdefault(code, set()).add(module)
    del used[ERROR]
    listed = {
        code: set(modules.split(", ")) for code, modules in ROW.findall(package.__doc__ or "")
    }
    assert listed == used
