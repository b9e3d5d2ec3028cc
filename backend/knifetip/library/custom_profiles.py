"""custom_profiles: parse and write the profiles of customers, which are stored as TOML text.

A profile is a list of rules that give edges their line type.  ``parse_text`` returns the rules in a
TOML text; ``profile_text`` writes the fields of a form as TOML text.  The text comes from users and
is not trusted: its size is limited, it cannot refer to files, and it is either valid or refused.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from knifetip.errors import ProfileError
from knifetip.library import load
from knifetip.library.definition import is_name
from knifetip.library.toml_text import read_toml
from knifetip.model.profile import LineRules

MAX_BYTES = 256 << 10  #: largest size of the text of a profile


def check_name(name: str) -> str:
    """Return the name of a profile unchanged if it is valid.

    A valid name has at most 64 characters: lower-case letters, digits, hyphens and underscores.

    Raises
    ------
    ProfileError
        The name is not valid.
    """
    if not is_name(name):
        raise ProfileError("library.bad-name", shelf="profile", name=name[:80], source=("name",))
    return name


def parse_text(name: str, text: str) -> LineRules:
    """Return the profile that a TOML text describes, with the name ``name``.

    Raises
    ------
    ProfileError
        The text is too long, is not TOML or is not a profile.  If a field is wrong, the attribute
        ``source`` of the error is the path of the field.
    """
    # The size is checked first, so that large texts do not enter the cache.
    if len(text) > MAX_BYTES or len(text.encode("utf-8", "replace")) > MAX_BYTES:
        raise ProfileError(
            "profile.too-long", name=name, size=len(text) >> 10, limit=MAX_BYTES >> 10
        )
    return _parse_cached(name, text)


@lru_cache(maxsize=64)
def _parse_cached(name: str, text: str) -> LineRules:
    try:
        return load.parse_profile(name, read_toml(text))
    except ValueError as reason:
        raise ProfileError("profile.not-toml", name=name, reason=reason) from reason
    except RecursionError as reason:
        raise ProfileError("profile.nested-too-deep", name=name) from reason


def profile_text(name: str, fields: Mapping[str, Any]) -> str:
    """Return the TOML text of a profile from its fields.

    Parameters
    ----------
    name
        Name of the profile, for error messages.
    fields
        ``title``, ``extends`` (name of a profile of the library, or None), ``overrules`` (whether
        the rules of the profile come before those of the extended profile), and ``rule``: a list of
        tables, each with a line type ``type`` and the conditions of the rule.

    Raises
    ------
    ProfileError
        The fields are not a valid profile; the attribute ``source`` of the error is the path of the
        wrong field.
    """
    return load.profile_toml(load.parse_profile(name, fields), fields.get("extends"))


def parse_fields(text: str) -> dict[str, Any]:
    """Return the fields in the TOML text of a profile, in the form that ``profile_text`` takes.

    ``text`` must be valid TOML, otherwise ``tomllib.TOMLDecodeError`` is raised.  The fields are
    not checked.
    """
    return read_toml(text)


def inherited_rules(fields: Mapping[str, Any], rules: LineRules) -> list[bool]:
    """Return for each rule of a profile whether the rule is inherited from an extended profile.

    The result has one entry per rule, in the order of ``rules``.

    Parameters
    ----------
    fields
        Fields of the profile, as in ``profile_text``.  Their ``rule`` lists only the rules that the
        profile adds itself.
    rules
        The complete profile: its own rules and the inherited ones.
    """
    own = [False] * len(fields["rule"])
    base = [True] * (len(rules.rules) - len(own))
    return own + base if fields.get("overrules") else base + own
