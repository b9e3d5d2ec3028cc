"""Checks of the computer: Python, packages and their native parts, compiled kernels, disks."""

from __future__ import annotations

import re
import shutil
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from importlib import import_module, metadata
from pathlib import Path
from typing import Final

from knifetip.cli.checks.check_result import CheckResult, ok, problem, warning
from knifetip.formats import FORMATS
from knifetip.messages import Message

_OLDEST: Final = (3, 11)
#: Modules with compiled code, which another processor or system library may not be able to load.
_NATIVE: Final = (
    *(
        "numpy",
        "llvmlite.binding",
        "pydantic_core",
        "sqlalchemy",
        "psycopg",
        "_argon2_cffi_bindings",
    ),
)
_REQUIREMENT: Final = re.compile(r"([A-Za-z0-9._-]+)(?:\[[^]]*\])?\s*([^;]*)(;.*)?")
_FULL: Final = 256 << 20  # bytes below which a server refuses uploads
_LITTLE: Final = 2 << 30


def check_python(found: Sequence[int] = tuple(sys.version_info[:3])) -> Iterator[CheckResult]:
    """Check the version of Python."""
    text = ".".join(map(str, found[:3]))
    if tuple(found[:2]) < _OLDEST:
        yield problem("python", Message("doctor.python-old", version=text))
    else:
        yield ok("python", Message("doctor.python", version=text, path=sys.executable))


def check_packages(
    requirements: Sequence[str] | None = None, load: Callable[[str], object] = import_module
) -> Iterator[CheckResult]:
    """Check that all packages have a permitted version, and that their native parts load.

    Parameters
    ----------
    requirements
        Requirements as in the metadata of a package; None for those of knifetip.
    load
        Imports a module.
    """
    needed = metadata.requires("knifetip") if requirements is None else requirements
    faults = [fault for text in needed or () if (fault := _fault_of_package(text)) is not None]
    for module in _NATIVE:
        try:
            load(module)
        except Exception as reason:  # of the loader, of the package, or of the system
            faults.append(Message("doctor.package-unloadable", module=module, reason=str(reason)))
    if faults:
        yield problem("packages", Message("doctor.packages-faulty", faults=faults))
    else:
        version = metadata.version("knifetip")
        yield ok("packages", Message("doctor.packages", version=version))


def check_converters() -> Iterator[CheckResult]:
    """Report the optional programs that convert files before they are read."""
    for one in FORMATS:
        if one.converter is None:
            continue
        found = one.converter.find()
        program = one.converter.title
        message = Message("doctor.converter-missing", program=program, format=one.title)
        if found is not None:
            message = Message(
                "doctor.converter",
                program=f"{program} {found.version}".strip(),
                path=str(found.path),
                format=one.title,
            )
        yield ok("converters", message)


def _fault_of_package(requirement: str) -> Message | None:
    """Return what is wrong with the package that a requirement names; None for nothing."""
    match = _REQUIREMENT.match(requirement)
    if match is None or match[3] is not None:
        return None  # an extra, or a package for another system
    name, bounds = match[1], match[2].strip()
    try:
        version = metadata.version(name)
    except metadata.PackageNotFoundError:
        return Message("doctor.package-missing", name=name)
    if all(_meets_bound(version, bound) for bound in bounds.split(",") if bound):
        return None
    return Message("doctor.package-version", name=name, version=version, bounds=bounds)


def _meets_bound(version: str, bound: str) -> bool:
    """Return whether a version meets a bound; true for bounds other than ``>=`` and ``<``."""
    match = re.match(r"(>=|<)\s*([0-9.]+)$", bound.strip())
    if match is None:
        return True
    one, other = (
        tuple(int(part) for part in re.findall(r"\d+", text)[:3]) for text in (version, match[2])
    )
    width = max(len(one), len(other))
    padded = [part + (0,) * (width - len(part)) for part in (one, other)]
    return padded[0] >= padded[1] if match[1] == ">=" else padded[0] < padded[1]


def check_kernels() -> Iterator[CheckResult]:
    """Check that the compiled functions have machine code of this version on the disk."""
    from knifetip.service.processes.kernel_groups import missing_parts

    missing = missing_parts()
    if not missing:
        yield ok("kernels", Message("doctor.kernels"))
        return
    count = sum(part.kernels for part in missing)
    message = Message("doctor.kernels-missing", count=count, modules=len(missing))
    yield warning("kernels", message)


def check_disks(
    folders: Sequence[Path], free: Callable[[Path], int] | None = None
) -> Iterator[CheckResult]:
    """Check the free space of folders and of the folder of temporary files, and write to them.

    Parameters
    ----------
    folders
        Folders in which a server stores data.
    free
        Returns the free bytes of a folder; None for those of the system.
    """
    for folder in dict.fromkeys([*folders, Path(tempfile.gettempdir())]):
        yield _check_disk(folder, free or _free_bytes)


def _free_bytes(folder: Path) -> int:
    return shutil.disk_usage(folder).free


def _check_disk(folder: Path, free: Callable[[Path], int]) -> CheckResult:
    try:
        with tempfile.TemporaryFile(dir=folder) as file:
            file.write(b"knifetip")
            file.flush()
        space = free(folder)
    except OSError as reason:
        cause = str(reason.strerror or reason)
        return problem("disk", Message("doctor.disk-unwritable", folder=str(folder), reason=cause))
    megabytes = space >> 20
    if space < _FULL:
        return problem("disk", Message("doctor.disk-full", folder=str(folder), free=megabytes))
    if space < _LITTLE:
        return warning("disk", Message("doctor.disk-low", folder=str(folder), free=megabytes))
    return ok("disk", Message("doctor.disk", folder=str(folder), free=megabytes))
