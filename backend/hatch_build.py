"""hatch_build: add the licence and the page to a package of knifetip.

The licence lies in the folder above in a clone, and beside this file in a source distribution.  The
page is built before (`make page`); a package without it is built only if KNIFETIP_WITHOUT_PAGE is
set, as in the container image, which gets the page later.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

_PAGE = "knifetip/service/page/index.html"


class PackageContent(BuildHookInterface):  # type: ignore[misc]  # not installed where types are checked
    """Adds the licence to a package, and requires the page."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Add the licence and check that the page is there, before a package is built."""
        if version == "editable":
            return
        root = Path(self.root)
        if not (root / _PAGE).is_file() and not os.environ.get("KNIFETIP_WITHOUT_PAGE"):
            raise FileNotFoundError(f"{root / _PAGE} is missing. Build the page first: make page")
        place = "LICENSE" if self.target_name == "sdist" else "knifetip/LICENSE"
        for folder in (root, root.parent):
            if (folder / "LICENSE").is_file():
                build_data["force_include"][str(folder / "LICENSE")] = place
                return
