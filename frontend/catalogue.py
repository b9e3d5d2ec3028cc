"""catalogue: writes the page's texts of the server's messages from those of the backend.

    knifetip.messages -> src/messages/en.gen.ts, de.gen.ts …          catalogue.py

The texts are written in ICU MessageFormat, which the page renders all its texts with.  What the
format cannot express is an argument of its own: ``{error__hint}`` is the hint of a message,
``{names__or}`` a list with "or" before its last item, ``{size__mm}`` a length with useful decimals.
``src/messages/translateMessage.ts`` derives these from the arguments that the server sends.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path
from string import Formatter
from typing import Final

from knifetip.messages.codes import CODES
from knifetip.messages.entry import Kind
from knifetip.messages.language import Language
from knifetip.messages.languages import LANGUAGES, language
from knifetip.messages.numbers import ALL_DIGITS, FIXED, PLAIN_DIGITS, SIGNIFICANT
from knifetip.messages.render import NAMED

FOLDER = Path(__file__).resolve().parent / "src" / "messages"
HEADER = """/**
 * Texts and hints of all messages in the language "{tag}", in ICU MessageFormat.
 * Written by frontend/catalogue.py: do not edit.
 */

import type {{ Catalogue, Names }} from "./catalogue";
"""
#: Formats whose result is an argument of its own, by the name of that argument's ending.
DERIVED: Final = {
    "hint": "hint",
    "or": "or",
    "; ": "semicolon",
    " ": "space",
    "mm": "mm",
    **dict(zip(NAMED, NAMED, strict=True)),
}
#: Kinds of arguments that are coordinates, and that are numbers with decimals.
COORDINATES: Final = ("x", "y")
DECIMALS: Final = ("number", *COORDINATES)


def catalogue(tag: str) -> str:
    """Return the TypeScript source of the catalogue of a language."""
    found = language(tag)
    entries = {
        code: {
            "text": to_icu(text.text, CODES[code], found),
            "hint": to_icu(text.hint, CODES[code], found),
        }
        for code, text in sorted(found.texts.items())
    }
    return (
        f"{HEADER.format(tag=tag)}\n"
        f"export const TEXTS = {_literal(entries)} as const satisfies Catalogue;\n\n"
        f"export const NAMES: Names = {_literal(found.names)};\n\n"
        f"export const AND = {_literal(found.conjunction)};\n\n"
        f"export const OR = {_literal(found.alternative)};\n"
    )


def to_icu(template: str, kinds: Mapping[str, Kind], language: Language) -> str:
    """Return a template of ``knifetip.messages.render`` in ICU MessageFormat."""
    parts = []
    for literal, name, spec, conversion in Formatter().parse(template):
        parts.append(_quoted(literal))
        if name is not None:
            # An apostrophe before a brace would begin a literal text: two are one apostrophe.
            before = "''" if conversion == "r" else "'" if literal.endswith("'") else ""
            after = "''" if conversion == "r" else ""
            argument = _argument(name, spec or "", kinds[name], language)
            parts.append(f"{before}{argument}{after}")
    return "".join(parts)


def _argument(name: str, spec: str, kind: Kind, language: Language) -> str:
    """Return the argument of a template with its format; an unknown format is an error."""
    if spec == ", " or (spec == "" and kind not in DECIMALS):
        return f"{{{name}}}"
    if spec in DERIVED:
        return f"{{{name}__{DERIVED[spec]}}}"
    if spec == f" {language.conjunction} ":
        return f"{{{name}__and}}"
    if spec == f" {language.alternative} ":
        return f"{{{name}__each_or}}"
    if "|" in spec:
        one, many = spec.split("|")
        return f"{{{name}, plural, one {{{_quoted(one)}}} other {{{_quoted(many)}}}}}"
    style = _style(spec)
    if kind in COORDINATES and not spec.startswith(","):
        style += " group-off"
    return f"{{{name}, number{style}}}"


def _style(spec: str) -> str:
    """Return the number style of a format of ``messages.numbers``."""
    if spec == ",":
        return ""
    if spec == "d":
        return ", ::precision-integer"
    if spec == "MB":
        return f", ::scale/{1 / 2**20:.20f} .0"
    if found := FIXED.fullmatch(spec):
        digits = int(found["digits"])
        return f", ::.{'0' * digits}" if digits else ", ::precision-integer"
    if spec == "":
        return f", ::@{'#' * (ALL_DIGITS - 1)}"
    if found := SIGNIFICANT.fullmatch(spec):
        return f", ::@{'#' * (int(found['digits'] or PLAIN_DIGITS) - 1)}"
    raise ValueError(f"the format {spec!r} has no counterpart in ICU MessageFormat")


def _quoted(literal: str) -> str:
    """Return a text with its braces quoted."""
    return re.sub(r"[{}]+", lambda found: f"'{found[0]}'", literal)


def _literal(data: object) -> str:
    return json.dumps(data, indent=2, ensure_ascii=False, default=dict)


if __name__ == "__main__":
    for tag in LANGUAGES:
        written = catalogue(tag)
        target = FOLDER / f"{tag}.gen.ts"
        if not target.is_file() or target.read_text(encoding="utf-8") != written:
            target.write_text(written, encoding="utf-8")
