"""library: machines, boards, tools and profiles, and the fields of their TOML files."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "library.invalid": entry(
        "The {shelf} {name!r} cannot be used: {faults:; }.",
        "Correct it; knifetip schema {shelf} describes all fields.",
        shelf="text",
        name="text",
        faults="messages",
    ),
    "library.unknown": entry(
        "There is no {shelf} {name!r}.",
        "Available: {known:, }.",
        shelf="text",
        name="text",
        known="texts",
    ),
    "library.unknown-file": entry(
        "There is no {shelf} {name!r}: {reason}.",
        "Available: {known:, }.",
        shelf="text",
        name="text",
        reason="text",
        known="texts",
    ),
    "library.unreadable": entry(
        "The {shelf} {name!r} cannot be read: {detail}.",
        "Fix the TOML file.",
        shelf="text",
        name="text",
        detail="text",
    ),
    "field.invalid": entry("{path} {fault}", path="text", fault="text"),
    "field.missing": entry("{path} is missing", path="text"),
    "field.misspelt": entry(
        "{path} is not a field; did you mean {near}?",
        path="text",
        near="text",
    ),
    "field.unknown": entry("{path} is not a field", path="text"),
    "profile.bad-if-match": entry(
        "If-Match is {match!r}, which is not a version.",
        'Send the ETag of the profile, for example "3".',
        match="text",
    ),
    "profile.bad-name": entry(
        "{name!r} is not a valid profile name.",
        "Use up to 64 lower-case letters, digits, - and _; the page shows the title.",
        name="text",
    ),
    "profile.exists": entry(
        "There is a profile {name} already, at version {version}.",
        'To replace it, send If-Match: "{version}"; or choose another name.',
        name="text",
        version="count",
    ),
    "profile.invalid-field": entry(
        "The profile cannot be read: {place}: {fault}.",
        "See ProfileIn in /api/openapi.json for the expected fields.",
        place="text",
        fault="text",
    ),
    "profile.nested-too-deep": entry(
        "The profile {name!r} is nested too deeply.",
        "A profile is a title and a list of [[rule]].",
        name="text",
    ),
    "profile.not-an-extension": entry(
        "The rules of {name!r} are not those of {extends!r} with additions.",
        "Write it out without extends.",
        name="text",
        extends="text",
    ),
    "profile.not-kept": entry(
        "There is no custom profile {name}.",
        "GET /api/profiles lists them.",
        name="text",
    ),
    "profile.not-toml": entry(
        "The profile {name!r} is not TOML: {reason}.",
        "Fix that line.",
        name="text",
        reason="text",
    ),
    "profile.not-utf8": entry("{name} is not UTF-8 text.", "Save it as UTF-8.", name="text"),
    "profile.not-utf8-byte": entry(
        "The profile {name!r} is not UTF-8 text: byte {byte} is invalid.",
        "Save it as UTF-8.",
        name="text",
        byte="count",
    ),
    "profile.shipped": entry(
        "The profile {name!r} is part of knifetip and cannot be changed.",
        "Save yours under another name; it can extend this one.",
        name="text",
    ),
    "profile.shipped-command": entry(
        "The profile {name!r} is part of knifetip and cannot be changed.",
        "Save yours under another --name.",
        name="text",
    ),
    "profile.stale": entry(
        "Profile {name} is at version {version}, and this change was made from version {given}: "
        "another user changed it in between.",
        'Check it again, then send your change with If-Match: "{version}".',
        name="text",
        version="count",
        given="count",
    ),
    "profile.too-long": entry(
        "The profile {name!r} is {size} kB long; the limit is {limit} kB.",
        "One rule can take many layers, and * matches any letters.",
        name="text",
        size="count",
        limit="count",
    ),
    "profile.too-many": entry(
        "There are {limit} profiles already.",
        "Delete one that is not used.",
        limit="count",
    ),
    "board.named": entry(
        "{name} ({caliper:g} mm)",
        name="text",
        caliper="number",
    ),
    "board.not-in-library": entry(
        "{name}",
        name="text",
    ),
}
