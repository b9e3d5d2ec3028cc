"""The page has the same messages and stages as the backend."""

from __future__ import annotations

import importlib.util
import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from knifetip.messages import Message, hint, render
from knifetip.messages.codes import CODES
from knifetip.messages.languages import LANGUAGES, language
from knifetip.model.stage import Stage

FRONTEND = Path(__file__).resolve().parents[3] / "frontend"
STAGES = FRONTEND / "src" / "state" / "job" / "stages.ts"


def _script(name: str) -> Any:
    """Return a script of the frontend as a module."""
    spec = importlib.util.spec_from_file_location(name, FRONTEND / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


#: Kinds of the arguments in the templates below.
KINDS = {
    **{"count": "count", "name": "text", "title": "text", "size": "number", "error": "message"},
    **{"names": "texts", "x": "x", "length": "number"},
}


@pytest.mark.parametrize(
    ("template", "icu"),
    [
        (
            "{count:# edge|# edges} of {name!r}",
            "{count, plural, one {# edge} other {# edges}} of ''{name}''",
        ),
        ("'{title}': {size:mm} mm", "''{title}': {size__mm} mm"),
        ("{error}: {error:hint} {names:or}", "{error}: {error__hint} {names__or}"),
        ("{names: and } {names: or }", "{names__and} {names__each_or}"),
        ("{name:unit} {name:type}", "{name__unit} {name__type}"),
        (
            "{length:.3f} {length:,.1f} {length:g} {length:.3g}",
            "{length, number, ::.000} {length, number, ::.0} {length, number, ::@#####} "
            "{length, number, ::@##}",
        ),
        ("{x:.3f} {x:,.1f}", "{x, number, ::.000 group-off} {x, number, ::.0}"),
        ("{length} {name}", "{length, number, ::@##############} {name}"),
        ("{count:,} {{raw}}", "{count, number} '{'raw'}'"),
    ],
)
def test_templates_are_written_in_icu_message_format(template: str, icu: str) -> None:
    assert _script("catalogue").to_icu(template, KINDS, language("en")) == icu


def test_words_between_the_items_of_a_list_are_those_of_the_language() -> None:
    icu = _script("catalogue").to_icu("{names: und } {names: oder }", KINDS, language("de"))
    assert icu == "{names__and} {names__each_or}"


def test_a_format_without_counterpart_is_refused() -> None:
    with pytest.raises(ValueError, match="no counterpart"):
        _script("catalogue").to_icu("{x:08.3f}", KINDS, language("en"))


#: Ordinary arguments, and those for which the forms of a text differ: numbers above 1000 and
#: 1,000,000, ties of rounding, very small numbers, and words that have a name in each language.
SAMPLES: tuple[dict[str, Any], ...] = (
    {
        **{"text": "T", "count": 2, "number": 1.5, "texts": ("A", "B"), "edge": 7, "edges": (7, 8)},
        **{"message": Message("stored.text", text="M", hint="Do it."), "message?": None},
        **{"messages": (Message("stored.text", text="N", hint="Do."),), "x": 1.5, "y": 2.5},
    },
    {
        **{
            "text": "mm",
            "count": 1,
            "number": 0.127,
            "texts": ("A", "B", "C"),
            "edge": 1,
            "edges": (7,),
        },
        **{
            "message": Message("stored.text", text="it's <b> {x}", hint=""),
            "x": -1234.5,
            "y": 0.25,
        },
        **{"message?": Message("stored.text", text="O", hint="Do so.")},
        **{"messages": tuple(Message("stored.text", text=text, hint="Do.") for text in "NPQ")},
    },
    {
        **{
            "text": "knife",
            "count": 1200,
            "number": 12.27,
            "texts": (),
            "edge": 12345,
            "edges": (),
        },
        **{"message": Message("stored.text", text="", hint=""), "message?": None, "messages": ()},
        **{"x": 0.05, "y": 100000.26},
    },
    {
        **{"text": "half-cut", "count": 1234567, "number": 1234567.5, "edge": 2, "edges": (3,)},
        **{"texts": ("queued", "held"), "x": 1234.5, "y": -0.125, "messages": ()},
        **{"message": Message("question.tool", edges=1200, type="crease", machine="T")},
        "message?": Message("import.too-far", coordinate=1200.5, limit=1e6),
    },
    {
        **{"text": "running", "count": 0, "number": 0.0000125, "edge": 0, "edges": (3,)},
        **{"texts": ("cut",), "x": -2.5e200, "y": 1e9, "messages": ()},
        **{"message": Message("stored.text", text="„a“", hint=" b "), "message?": None},
    },
)


def test_the_page_renders_every_message_as_the_server_does(tmp_path: Path) -> None:
    if not (FRONTEND / "node_modules" / "vitest").is_dir():
        pytest.skip("the packages of the page are not installed (make page)")
    _write_declared()
    messages = [
        Message(code, **{name: values[kind] for name, kind in kinds.items()})
        for code, kinds in CODES.items()
        for values in SAMPLES
    ]
    samples = {
        tag: [
            {"message": message.as_json(), "text": render(message, tag), "hint": hint(message, tag)}
            for message in messages
        ]
        for tag in LANGUAGES
    }
    written = tmp_path / "messages.json"
    written.write_text(json.dumps(samples), encoding="utf-8")
    vitest = ["npm", "exec", "--", "vitest", "run", "src/messages/rendering.test.ts"]
    done = subprocess.run(
        [sys.executable, FRONTEND / "build.py", *vitest],
        env={**os.environ, "KNIFETIP_MESSAGES": str(written)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-4000:]
    assert "2 passed" in done.stdout


def _write_declared() -> None:
    """Write what the page has from declarations, which is not in the repository."""
    for script in ("catalogue.py", "options.py"):
        subprocess.run([sys.executable, str(FRONTEND / script)], check=True)


def test_the_page_has_the_roles_that_the_routes_declare() -> None:
    expected = _script("roles").roles()
    written = (FRONTEND / "src" / "api" / "roles.gen.ts").read_text(encoding="utf-8")
    assert written == expected, "run: python frontend/roles.py"


def test_the_page_has_the_samples_and_their_pictures() -> None:
    folder = FRONTEND / "public" / "samples"
    written = {one.name: one.read_bytes() for one in folder.iterdir()}
    assert written == _script("samples").files(), "run: python frontend/samples.py"


def test_the_progress_bar_has_the_stages_of_a_compile_in_order() -> None:
    source = STAGES.read_text(encoding="utf-8")
    table = source[source.index("COMPILE_STAGES") : source.index("};")]
    titles = dict(re.findall(r"^  (\w+): (.+),$", table, re.MULTILINE))
    assert list(titles) == [stage.value for stage in Stage]
    # A server that is being prepared and an import report these; a compile ends with "done".
    hidden = {Stage.PREPARE, Stage.CLASSIFY, Stage.STORE, Stage.DONE}
    assert {stage for stage, title in titles.items() if title == "null"} == hidden
