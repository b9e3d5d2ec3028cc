"""library: messages about machines, boards, tools and profiles of customers."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "library.bad-if-match": entry(
        "The header If-Match is {match!r}, which is not a version number.",
        'Send the ETag of the entry in If-Match, for example "3".',
        match="text",
    ),
    "library.acting-text": entry(
        "The field {field} of the {shelf} {name} contains an invisible control character: "
        "{text!r}.",
        "Type the text again without control characters and marks of the writing direction.",
        shelf="text",
        name="text",
        field="text",
        text="text",
    ),
    "library.long-text": entry(
        "The field {field} of the {shelf} {name} is longer than {limit} characters: {text!r}.",
        "Use at most {limit} characters.",
        shelf="text",
        name="text",
        field="text",
        text="text",
        limit="count",
    ),
    "library.bad-name": entry(
        "{name!r} is not a valid name of a {shelf}.",
        "Use up to 64 lower-case letters, digits, hyphens and underscores. Write other "
        "characters into the title of the {shelf}.",
        shelf="text",
        name="text",
    ),
    "library.changed-since": entry(
        "it was made for version {version} of the {shelf} {name}, whose newest version is {newest}",
        shelf="text",
        name="text",
        version="count",
        newest="count",
    ),
    "library.deleted": entry(
        "The {shelf} {name} was deleted.",
        "Order a new job with another {shelf}, or create the {shelf} again.",
        shelf="text",
        name="text",
    ),
    "library.deleted-since": entry(
        "it was made for version {version} of the {shelf} {name}, which was deleted",
        shelf="text",
        name="text",
        version="count",
    ),
    "library.exists": entry(
        "A {shelf} with the name {name} already exists, at version {version}.",
        'Send If-Match: "{version}" to replace this {shelf}, or choose another name.',
        shelf="text",
        name="text",
        version="count",
    ),
    "library.in-use": entry(
        "The {shelf} {name} cannot be deleted: {count:# job|# jobs} that have not ended use it, "
        "for example {jobs:, }.",
        "Wait until these jobs have ended, or cancel them. Then delete the {shelf}.",
        shelf="text",
        name="text",
        count="count",
        jobs="texts",
    ),
    "library.invalid": entry(
        "The {shelf} {name!r} cannot be used: {faults:; }.",
        "{faults:hint} Correct the TOML file of the {shelf}. The command knifetip schema {shelf} "
        "describes all fields.",
        shelf="text",
        name="text",
        faults="messages",
    ),
    "library.large-integer": entry(
        "An integer in the document has more than 64 bits.",
        "Correct the number, or write it with a decimal point.",
    ),
    "library.nested-too-deep": entry(
        "The tables of the {shelf} {name!r} are nested too deeply.",
        "Write only the fields that knifetip schema {shelf} describes.",
        shelf="text",
        name="text",
    ),
    "library.no-settings": entry(
        "The controller of {machine} has no settings that knifetip knows.",
        "Set up the controller as its maker describes.",
        machine="text",
    ),
    "library.not-an-object": entry(
        "The JSON document of the {shelf} {name!r} is not an object.",
        "Send an object with the fields that GET /api/schemas/{shelf}s describes.",
        shelf="text",
        name="text",
    ),
    "library.null-in-list": entry(
        "A list in the {shelf} {name!r} contains null.",
        "Remove null from the list, or replace it by a value.",
        shelf="text",
        name="text",
    ),
    "library.not-json": entry(
        "The {shelf} {name!r} is not valid JSON: {reason}.",
        "Send an object with the fields that GET /api/schemas/{shelf}s describes.",
        shelf="text",
        name="text",
        reason="text",
    ),
    "library.not-stored": entry(
        "The server has no user-defined {shelf} with the name {name}.",
        "Choose an entry that GET /api/library lists with shipped: false.",
        shelf="text",
        name="text",
    ),
    "library.not-toml": entry(
        "The {shelf} {name!r} is not valid TOML: {reason}.",
        "Correct the TOML syntax at this position.",
        shelf="text",
        name="text",
        reason="text",
    ),
    "library.not-utf8": entry(
        "The {shelf} {name!r} is not UTF-8 text: byte {byte} is invalid.",
        "Save the file as UTF-8.",
        shelf="text",
        name="text",
        byte="count",
    ),
    "library.shipped": entry(
        "The {shelf} {name!r} is part of knifetip and cannot be changed.",
        "Save a copy of it under another name, and change the copy.",
        shelf="text",
        name="text",
    ),
    "library.stale": entry(
        "Another user has changed the {shelf} {name}: it is now at version {version}, but your "
        "change is based on version {given}.",
        'Load the {shelf} again and check it. Then send your change with If-Match: "{version}".',
        shelf="text",
        name="text",
        version="count",
        given="count",
    ),
    "library.too-long": entry(
        "The {shelf} {name!r} has a size of {size} kB, but the limit is {limit} kB.",
        "Remove comments and fields that are not needed.",
        shelf="text",
        name="text",
        size="count",
        limit="count",
    ),
    "library.too-many": entry(
        "The server already has {limit} user-defined machines, boards and tools, which is the "
        "largest number allowed.",
        "Delete entries that are not used.",
        limit="count",
    ),
    "library.unknown": entry(
        "The {shelf} {name!r} does not exist.",
        "Choose one of {known:, }.",
        shelf="text",
        name="text",
        known="texts",
    ),
    "library.unknown-file": entry(
        "The {shelf} {name!r} does not exist: {reason}.",
        "Check the path of the file, or choose one of {known:, }.",
        shelf="text",
        name="text",
        reason="text",
        known="texts",
    ),
    "library.unknown-version": entry(
        "The {shelf} {name} has no version {version}; its newest version is {newest}.",
        "Choose one of the versions that GET /api/{shelf}s/{name}/versions lists.",
        shelf="text",
        name="text",
        version="count",
        newest="count",
    ),
    "library.unreadable": entry(
        "The {shelf} {name!r} cannot be read: {detail}.",
        "Correct the TOML file of the {shelf}.",
        shelf="text",
        name="text",
        detail="text",
    ),
    "profile.invalid-field": entry(
        "The profile cannot be read: {fault}.",
        "See ProfileIn in /api/openapi.json for the expected fields.",
        fault="message",
    ),
    "profile.nested-too-deep": entry(
        "The tables of the profile {name!r} are nested too deeply.",
        "Write only a title and a list of [[rule]] tables.",
        name="text",
    ),
    "profile.not-an-extension": entry(
        "The profile {name!r} cannot be saved as an extension of {extends!r}, because it lacks "
        "some rules of {extends!r}.",
        "Save the profile without the field extends.",
        name="text",
        extends="text",
    ),
    "profile.not-kept": entry(
        "The server has no user-defined profile with the name {name}.",
        "Choose one of the profiles that GET /api/profiles lists.",
        name="text",
    ),
    "profile.not-toml": entry(
        "The profile {name!r} is not valid TOML: {reason}.",
        "Correct the TOML syntax at this position.",
        name="text",
        reason="text",
    ),
    "profile.not-utf8": entry(
        "The file {name} is not UTF-8 text.",
        "Save the file as UTF-8.",
        name="text",
    ),
    "profile.too-long": entry(
        "The profile {name!r} has a size of {size} kB, but the limit is {limit} kB.",
        "Combine rules of the profile: one rule can list many layers, and * matches any "
        "characters.",
        name="text",
        size="count",
        limit="count",
    ),
    "profile.too-many": entry(
        "The server already has {limit} profiles, which is the largest number allowed.",
        "Delete a profile that is not used.",
        limit="count",
    ),
    "rule.block": entry(
        "inside the block {patterns:or}",
        patterns="texts",
    ),
    "rule.colour": entry("colour {colours:or}", colours="texts"),
    "rule.conditions": entry("{conditions:, }", conditions="messages"),
    "rule.entity": entry("object type {kinds:or}", kinds="texts"),
    "rule.everything": entry(
        "every edge of the drawing",
    ),
    "rule.layer": entry("layer {patterns:or}", patterns="texts"),
    "rule.linetype": entry(
        "line style {patterns:or}",
        patterns="texts",
    ),
}
