"""Messages: every code has a text and a hint that use exactly its arguments."""

from __future__ import annotations

import json
import math
import pickle
from typing import Any

import numpy as np
import pytest

from knifetip.messages import Message, finite, from_json, hint, render, with_text
from knifetip.messages.codes import CODES

SAMPLES = {
    "text": "T",
    "count": 2,
    "number": 1.5,
    "texts": ("A", "B"),
    "message": Message("stored.text", text="M", hint=""),
    "message?": None,
    "messages": (Message("stored.text", text="N", hint=""),),
    "edge": 7,
    "edges": (7, 8),
    "x": 1.5,
    "y": 2.5,
}


def sample(code: str) -> Message:
    arguments: dict[str, Any] = {name: SAMPLES[kind] for name, kind in CODES[code].items()}
    return Message(code, **arguments)


# One test of each message would take six times as long.
@pytest.mark.parametrize("area", sorted({code.partition(".")[0] for code in CODES}))
def test_the_messages_of_an_area_are_rendered_stored_and_restored(area: str) -> None:
    for code in CODES:
        if code.partition(".")[0] == area:
            message = sample(code)
            assert "{" not in render(message) + hint(message)
            assert from_json(json.loads(json.dumps(message.as_json()))) == message
            assert pickle.loads(pickle.dumps(message)) == message


def test_edges_and_places_in_a_message_and_its_arguments_can_be_those_of_the_drawing() -> None:
    crossing = Message("milling.contours-cross", edge=3, x=30.0, y=50.0)
    message = Message("error.at-edges", edges=(3, 4, 5), error=crossing)
    drawn = {3: 0, 4: 0, 5: 2}
    moved = message.located(drawn.__getitem__, (-10.0, -20.0))
    assert moved.arguments["edges"] == (0, 2)
    assert moved.arguments["error"].arguments == {"edge": 0, "x": 20.0, "y": 30.0}
    assert crossing.arguments == {"edge": 3, "x": 30.0, "y": 50.0}


def test_arguments_of_other_names_are_refused() -> None:
    with pytest.raises(TypeError, match=r"question\.tool takes edges, type, machine"):
        Message("question.tool", edges=1)
    with pytest.raises(TypeError, match="is not listed"):
        Message("question.none")


def test_numbers_of_numpy_become_plain_and_those_that_json_cannot_contain_finite() -> None:
    size = Message("question.unit-size", unit="mm", width=np.float64(2), height=np.inf)
    assert json.loads(json.dumps(size.as_json()))["arguments"]["height"] == 1e9
    assert json.dumps(Message("question.tool", edges=np.int64(1), type="", machine="").as_json())


def test_finite_numbers_remain_and_others_become_a_billion() -> None:
    numbers = [2.5, math.inf, -math.inf, math.nan, -math.nan]
    assert [finite(number) for number in numbers] == [2.5, 1e9, -1e9, 1e9, 1e9]


def test_text_that_utf8_cannot_encode_is_replaced() -> None:
    plain = Message("stored.text", text="a\udc80\0b", hint="").as_json()
    assert plain["arguments"]["text"] == "a?b"


def test_plural_and_lists() -> None:
    one = Message("question.tool", edges=1, type="crease", machine="T")
    many = Message("question.tool", edges=1200, type="crease", machine="T")
    assert "no tool for 1 edge of" in render(one)
    assert "no tool for 1,200 edges of" in render(many)


def test_sentences_stored_without_a_code_stay_readable() -> None:
    assert with_text({"text": "Old.", "hint": "Do.", "edges": [1]}) == {
        "code": "stored.text",
        "arguments": {"text": "Old.", "hint": "Do."},
        "text": "Old.",
        "hint": "Do.",
        "edges": [1],
    }
    # Without a text, the code and the arguments as they are tell what happened.
    wrong = {"code": "question.tool", "arguments": {"alarm": 9, "why": "\x1b[31m<b>\u202e\nend"}}
    found = from_json(wrong)
    assert found.code == "stored.text"
    assert render(found) == 'question.tool {"alarm": 9, "why": "\\u001b[31m<b>\ufffd\\nend"}'
    long = from_json({"code": "none", "arguments": {"why": "x" * 5000}})
    assert len(render(long)) < 400
    # A message of another version, whose code or arguments do not exist in this one.
    assert render(from_json({"code": "none", "arguments": {}, "text": "New."})) == "New."
    assert render(from_json({"code": "question.tool", "arguments": {}, "text": "New."})) == "New."
