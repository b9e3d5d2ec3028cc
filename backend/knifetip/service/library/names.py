"""Names of entries of the library."""

from __future__ import annotations

from knifetip.errors import LibraryError
from knifetip.library import load


def check_library_name(shelf: str, name: str) -> str:
    """Return ``name`` unchanged if the library has an entry with this name.

    Parameters
    ----------
    shelf
        Kind of the entry: "machines", "boards" or "profiles".
    name
        Name of the entry; the path of a file is not accepted as a name.

    Raises
    ------
    LibraryError
        The library has no entry of this kind with this name.
    """
    known = load.names(shelf)
    if name not in known:
        raise LibraryError(
            "library.unknown", shelf=shelf.removesuffix("s"), name=name[:80], known=known
        )
    return name
