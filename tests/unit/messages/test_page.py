"""The page has the same messages and stages as the backend."""

from __future__ import annotations

import importlib.util
import json
import re
from pathlib import Path
from typing import Any

from knifetip.messages import english
from knifetip.messages.codes import CODES
from knifetip.model.stage import Stage

FRONTEND = Path(__file__).resolve().parents[3] / "frontend"
CATALOGUE = FRONTEND / "src" / "messages" / "en.gen.ts"
STAGES = FRONTEND / "src" / "state" / "stages.ts"
FIELD = re.compile(r"{(\w+)")


def page_texts() -> dict[str, dict[str, str]]:
    source = CATALOGUE.read_text(encoding="utf-8")
    start = source.index("TEXTS = ") + len("TEXTS = ")
    texts: dict[str, dict[str, str]] = json.loads(source[start : source.index(" as const", start)])
    return texts


def _script(name: str) -> Any:
    """Return a script of the frontend as a module."""
    spec = importlib.util.spec_from_file_location(name, FRONTEND / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_page_has_the_same_codes_with_the_same_arguments() -> None:
    texts = page_texts()
    assert texts.keys() == CODES.keys(), "run: python frontend/catalogue.py"
    for code, entry in texts.items():
        templates = english.TEXTS[code] + english.HINTS.get(code, "")
        assert set(FIELD.findall(entry["text"] + entry["hint"])) == set(FIELD.findall(templates))


def test_the_english_of_the_page_is_that_of_the_backend() -> None:
    expected = _script("catalogue").catalogue()
    assert CATALOGUE.read_text(encoding="utf-8") == expected, "run: python frontend/catalogue.py"


def test_the_page_has_the_roles_that_the_routes_declare() -> None:
    expected = _script("roles").roles()
    written = (FRONTEND / "src" / "api" / "roles.gen.ts").read_text(encoding="utf-8")
    assert written == expected, "run: python frontend/roles.py"


def test_the_progress_bar_has_the_stages_of_a_compile_in_order() -> None:
    source = STAGES.read_text(encoding="utf-8")
    table = source[source.index("COMPILE_STAGES") : source.index("};")]
    titles = dict(re.findall(r"^  (\w+): (.+),$", table, re.MULTILINE))
    assert list(titles) == [stage.value for stage in Stage]
    # A server that is being prepared and an import report these; a compile ends with "done".
    hidden = {Stage.PREPARE, Stage.CLASSIFY, Stage.STORE, Stage.DONE}
    assert {stage for stage, title in titles.items() if title == "null"} == hidden
