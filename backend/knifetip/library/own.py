"""own: profiles that customers keep, as the TOML text that they wrote or the page wrote for them.

    name, TOML text -> LineRules                 fields of a form -> TOML text

The text comes from anywhere: it is short, names nothing outside the library, and is read whole or
refused with the rule and the field that are wrong.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from functools import lru_cache
from importlib import resources
from typing import Any

from knifetip.errors import ProfileError
from knifetip.library import load
from knifetip.model.profile import LineRules

LONGEST = 256 << 10  #: bytes of a profile's text

#: No dots: a name that ends in .toml is a file's, on the command line and in an address.
_NAME = re.compile(r"[a-z0-9][a-z0-9_-]{0,63}")


def checked_name(name: str) -> str:
    """Return a name that a profile may have.

    Raises
    ------
    ProfileError
        It is none.
    """
    if not _NAME.fullmatch(name):
        raise ProfileError("profile.bad-name", name=name[:80], source=("name",))
    return name


def parsed(name: str, text: str) -> LineRules:
    """Return the profile that a TOML text says.

    Raises
    ------
    ProfileError
        It says none; ``source`` names the rule and its field.
    """
    # Measured before it is kept in mind, so that what is huge is not.
    if len(text) > LONGEST or len(text.encode("utf-8", "replace")) > LONGEST:
        raise ProfileError("profile.too-long", name=name, size=len(text) >> 10, limit=LONGEST >> 10)
    return _parsed(name, text)


@lru_cache(maxsize=64)
def _parsed(name: str, text: str) -> LineRules:
    try:
        return load.parse_profile(name, tomllib.loads(text))
    except tomllib.TOMLDecodeError as reason:
        raise ProfileError("profile.not-toml", name=name, reason=reason) from reason
    except RecursionError as reason:
        raise ProfileError("profile.nested-too-deep", name=name) from reason


def written(name: str, fields: Mapping[str, Any]) -> str:
    """Return the TOML text of a profile that was given as plain data.

    Parameters
    ----------
    fields
        ``title``, ``extends`` (a shipped profile or None), ``overrules``, and ``rule``: a list of
        tables, each with ``type`` and its conditions.

    Raises
    ------
    ProfileError
        It is no profile; ``source`` names the rule and its field.
    """
    return load.profile_toml(load.parse_profile(name, fields), fields.get("extends"))


def text_of(name: str) -> str:
    """Return the TOML text of a profile that is shipped."""
    return (resources.files(__package__) / "profiles" / f"{name}.toml").read_text("utf-8")


def parts(text: str) -> dict[str, Any]:
    """Return the fields of a profile's text as ``written`` takes them."""
    return tomllib.loads(text)


def inherited(fields: Mapping[str, Any], rules: LineRules) -> list[bool]:
    """Return which of a profile's rules are those of the profile that it extends."""
    mine = len(fields["rule"])
    theirs = [True] * (len(rules.rules) - mine)
    return [False] * mine + theirs if fields.get("overrules") else theirs + [False] * mine
