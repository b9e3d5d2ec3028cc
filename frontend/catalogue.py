"""catalogue: writes the page's English catalogue from that of the backend.

    knifetip.messages -> src/messages/en.gen.ts          catalogue.py

Both then have the same texts.  A further language is a file like it, written by a translator.
"""

from __future__ import annotations

import json
from pathlib import Path

from knifetip.messages import english
from knifetip.messages.codes import CODES

TARGET = Path(__file__).resolve().parent / "src" / "messages" / "en.gen.ts"
HEADER = """/** English texts and hints of all messages. Written by frontend/catalogue.py: do not edit. */

import type { Catalogue } from "./catalogue";
"""


def catalogue() -> str:
    """Return the TypeScript source of the English catalogue."""
    entries = {
        code: {"text": english.TEXTS[code], "hint": english.HINTS.get(code, "")}
        for code in CODES
    }
    return (
        f"{HEADER}\n"
        f"export const TEXTS = {_literal(entries)} as const satisfies Catalogue;\n\n"
        f"export const UNITS: Readonly<Record<string, string>> = {_literal(english.UNITS)};\n\n"
        f"export const TOOLS: Readonly<Record<string, string>> = {_literal(english.TOOLS)};\n"
    )


def _literal(data: object) -> str:
    return json.dumps(data, indent=2, ensure_ascii=False, default=dict)


if __name__ == "__main__":
    TARGET.write_text(catalogue(), encoding="utf-8")
