"""The profiles of customers by which drawings are classified."""

from __future__ import annotations

from knifetip.errors import LibraryError, WrongState
from knifetip.library import load
from knifetip.service.components import Service
from knifetip.service.database.acting import acting_limits


def customer_rules(service: Service, name: str) -> str:
    """Return the TOML text of a customer's profile, or "" for a profile of the library.

    Raises
    ------
    LibraryError
        There is no profile with this name.
    """
    row = service.store.profiles.get(name)
    if row is not None:
        return row.text
    known = load.names("profiles")
    if name not in known:
        if not acting_limits().customer:
            known = [*(row.name for row in service.store.profiles.all()), *known]
        raise LibraryError("library.unknown", name=name[:80], known=known[:40], shelf="profile")
    return ""


def require_customer_profile(service: Service, name: str) -> None:
    """Raise WrongState if the profile ``name`` belongs to the library and so cannot be changed."""
    if name in load.names("profiles") and service.store.profiles.get(name) is None:
        raise WrongState("library.shipped", shelf="profile", name=name)
