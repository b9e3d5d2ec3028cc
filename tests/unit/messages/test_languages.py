"""Languages: each has every message with its arguments, and writes numbers as its readers do."""

from __future__ import annotations

import importlib
import re
import sys
from string import Formatter
from typing import Any

import pytest

from knifetip.messages import Message, hint, render, with_text
from knifetip.messages.catalogue import MESSAGES
from knifetip.messages.codes import CODES
from knifetip.messages.language import Language, Text
from knifetip.messages.languages import LANGUAGES, accepted_languages, choose_language, language
from knifetip.messages.render import NAMED

#: English words that no German text contains, except in names of menus, pages and programs.
ENGLISH = re.compile(
    r"\b(the|and|or|is|are|not|of|with|this|that|from|which|line|edge|drawing|sheet|board)\b"
)
#: Names of programs and of their menus, options and values, which are the same in all languages.
NAMES = re.compile(
    r"„(Edit > Convert to Path|Connect a machine)“|`[^`]*`|--?[a-z][a-z-]*|/api/\S*|\{[^}]*\}"
    r"|knifetip \w+( \w+)?|\b(board|drawing) (und copies|ist|verwenden)\b"
)
#: Codes whose text contains a field or an option with an English word as its name.
FIELDS = {
    "request.one-drawing": "drawing",
    "request.invalid": "",
    "watch.bad-sidecar": "board",
    "watch.no-object": "board",
    "watch.other-drawing": "drawing",
}
SAMPLES: dict[str, Any] = {
    **{"text": "T", "count": 2, "number": 1.5, "texts": ("A", "B"), "message?": None},
    **{"message": Message("stored.text", text="M", hint=""), "messages": ()},
    **{"edge": 7, "edges": (7, 8), "x": 1.5, "y": 2.5},
}


def fields(template: str) -> set[str]:
    return {name for _, name, _, _ in Formatter().parse(template) if name is not None}


@pytest.mark.parametrize("tag", LANGUAGES)
def test_each_language_has_the_codes_of_the_catalogue(tag: str) -> None:
    assert sorted(language(tag).texts) == sorted(CODES)


@pytest.mark.parametrize("tag", LANGUAGES)
def test_text_and_hint_use_every_argument_and_no_other(tag: str) -> None:
    for code, text in language(tag).texts.items():
        assert fields(text.text) | fields(text.hint) == CODES[code].keys(), code


@pytest.mark.parametrize("tag", LANGUAGES)
def test_each_language_has_a_hint_where_english_has_one(tag: str) -> None:
    for code, text in language(tag).texts.items():
        assert bool(text.hint) == bool(MESSAGES[code].hint), code


@pytest.mark.parametrize("tag", LANGUAGES)
def test_each_text_is_rendered_with_sample_arguments(tag: str) -> None:
    for code, kinds in CODES.items():
        message = Message(code, **{name: SAMPLES[kind] for name, kind in kinds.items()})
        assert "{" not in render(message, tag) + hint(message, tag), code


def test_the_modules_of_german_are_those_of_the_catalogue() -> None:
    catalogue = importlib.import_module("knifetip.messages.catalogue")
    for area in vars(catalogue)["_AREAS"]:
        name = area.__name__.rsplit(".", 1)[1]
        german = importlib.import_module(f"knifetip.messages.german.{name}")
        assert list(german.TEXTS) == list(area.MESSAGES), name


def english_words(code: str, text: str) -> list[str]:
    """Return the English words in a German text, without names."""
    found = [match[0] for match in ENGLISH.finditer(NAMES.sub("", text))]
    return [word for word in found if word != FIELDS.get(code)]


def test_german_texts_contain_no_english_words() -> None:
    texts = language("de").texts.items()
    found = {code: words for code, text in texts if (words := english_words(code, "\n".join(text)))}
    assert found == {}


def test_the_check_finds_english_words() -> None:
    assert english_words("a.b", "Der Bogen of Auftrag {job} ist weg.") == ["of"]
    assert english_words("a.b", "Den Schlüssel mit `knifetip key list` anzeigen.") == []


def test_german_quotes_names_as_german_does() -> None:
    texts = language("de").texts.items()
    assert [code for code, text in texts if "!r}" in text.text + text.hint] == []
    assert [code for code, text in texts if text.text.count("„") != text.text.count("“")] == []


@pytest.mark.parametrize("tag", LANGUAGES)
def test_names_belong_to_formats_of_templates(tag: str) -> None:
    assert language(tag).names.keys() <= set(NAMED)


def test_german_names_every_word_that_english_names() -> None:
    english, german = language("en").names, language("de").names
    assert {kind: list(german[kind]) for kind in english} == {
        kind: list(names) for kind, names in english.items()
    }


def test_words_in_arguments_have_german_names() -> None:
    missing = Message("tool.missing", machine="T", count=1200, type="half-cut")
    assert render(missing, "de") == "T hat kein Werkzeug für 1.200 Kanten der Art „Ritzen“."
    assert render(missing) == "T has no tool for 1,200 edges of type half-cut."
    states = Message(
        "job.wrong-state-for-request",
        **{"job": "J", "state": "done", "request": "hold", "states": ("queued", "running")},
        advice=Message("advice.ended"),
    )
    assert render(states, "de") == (
        "Auftrag J ist fertig, aber für „Anhalten“ muss er in der Warteschlange oder in Arbeit "
        "sein."
    )


def test_a_word_without_a_name_is_written_as_it_is() -> None:
    newer = Message("tool.missing", machine="T", count=1, type="emboss")
    assert "der Art „emboss“" in render(newer, "de")


def test_numbers_are_written_in_the_form_of_the_language() -> None:
    size = Message("check.sheet-size", width=1200.0, height=845.25, place="")
    assert render(size) == "A sheet of 1,200 × 845.25 mm lies in its place."
    assert render(size, "de") == "Ein Bogen von 1.200 × 845,25 mm liegt an seinem Platz."


def test_a_message_that_a_language_lacks_is_english_as_a_whole(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    german = language("de")
    texts = {code: text for code, text in german.texts.items() if code != "advice.ready"}
    # The package has a function of the same name as the module.
    monkeypatch.setattr(
        sys.modules["knifetip.messages.render"],
        "language_of",
        lambda tag: german._replace(texts=texts) if tag == "de" else language(tag),
    )
    advice = Message("advice.ready")
    message = Message("queue.not-waiting", job="J", state="ready", advice=advice)
    assert render(message, "de") == (
        "Job J is ready and does not wait, so it cannot be changed in the queue."
    )
    assert hint(message, "de") == "Release the job first."
    assert render(Message("advice.queued"), "de").startswith("Warten, bis")


def test_json_data_has_the_text_of_the_language() -> None:
    data = with_text(Message("advice.ready"), "de")
    assert data["text"] == "Den Auftrag zuerst freigeben."


def test_another_language_is_refused() -> None:
    with pytest.raises(KeyError, match="fr"):
        render(Message("advice.ready"), "fr")


@pytest.mark.parametrize(
    ("tags", "chosen"),
    [
        (["de-AT", "en"], "de"),
        (["fr", "de"], "de"),
        (["de_DE.UTF-8"], "de"),
        (["C.UTF-8"], "en"),
        (["en-US", "de"], "en"),
        ([], "en"),
    ],
)
def test_the_first_known_language_is_chosen(tags: list[str], chosen: str) -> None:
    assert choose_language(tags) == chosen


@pytest.mark.parametrize(
    ("header", "tags"),
    [
        ("de-DE,de;q=0.9,en;q=0.8", ["de-DE", "de", "en"]),
        ("en;q=0.5, de", ["de", "en"]),
        ("de;q=0, en", ["en"]),
        ("de;q=x, en", ["en"]),
        ("*", ["*"]),
        ("", []),
    ],
)
def test_accepted_languages_are_ordered_by_weight(header: str, tags: list[str]) -> None:
    assert accepted_languages(header) == tags


def test_languages_have_records_of_their_own() -> None:
    assert isinstance(language("de"), Language)
    assert all(isinstance(text, Text) for text in language("de").texts.values())
