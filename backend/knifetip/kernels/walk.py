"""walk: list the kernels in packages, to compile or to count them."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Iterator

from knifetip.kernels.dispatch import Kernel


def kernels_of(*packages: str) -> Iterator[Kernel]:
    """Yield each kernel that is defined in the given packages, ordered by module.

    Parameters
    ----------
    packages
        Full names of packages or modules, such as ``"knifetip.geometry"``; they are imported.
    """
    for package in packages:
        imported = importlib.import_module(package)
        modules = [package]
        for found in pkgutil.walk_packages(getattr(imported, "__path__", []), f"{package}."):
            # Importing a ``__main__`` or a migration would run it.
            if not found.name.endswith(".__main__") and ".migrations" not in found.name:
                modules.append(found.name)
        for name in modules:
            for value in vars(importlib.import_module(name)).values():
                if isinstance(value, Kernel) and value.py_func.__module__ == name:
                    yield value
