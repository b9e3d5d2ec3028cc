"""Records of the log are one line each, carry their job, and contain no secret."""

from __future__ import annotations

import io
import json
import logging
import re
import time
from collections.abc import Iterator

import pytest

from knifetip import logs
from knifetip.harmless import harmless
from knifetip.logs import LogFormat, LogLevel
from tests.support.hostile_names import ACTING, HOSTILE_NAMES, acting


@pytest.fixture
def stream() -> Iterator[io.StringIO]:
    """Stream of a configured log; the logging of the test run is restored afterwards."""
    root = logging.getLogger()
    handlers, level = root.handlers[:], root.level
    yield io.StringIO()
    logging.captureWarnings(False)
    root.handlers[:] = handlers
    root.setLevel(level)


@pytest.mark.parametrize("name", HOSTILE_NAMES.values(), ids=HOSTILE_NAMES.keys())
@pytest.mark.parametrize("form", list(LogFormat))
@pytest.mark.parametrize("logger", ["knifetip.api", "uvicorn.error", "some.library"])
def test_a_hostile_name_gives_one_line_without_acting_characters(
    stream: io.StringIO, form: LogFormat, name: str, logger: str
) -> None:
    logs.configure(form, LogLevel.INFO, stream)
    with logs.about(job=name):
        logging.getLogger(logger).error("drawing %s", name)
    written = stream.getvalue()
    assert written.endswith("\n")
    assert written.count("\n") == 1
    assert acting(written[:-1]) == set()
    if form is LogFormat.JSON:
        record = json.loads(written)
        assert (record["job"], record["message"]) == (name, f"drawing {name}")


def test_all_acting_characters_are_escaped_and_all_others_kept() -> None:
    assert harmless("".join(sorted(ACTING))).isascii()
    assert harmless("Schachtel 50 × 30 µm – Größe „L“ 箱 \\x1b") == (
        "Schachtel 50 × 30 µm – Größe „L“ 箱 \\x1b"
    )
    assert harmless("a\x1b[2J\n\u202e") == "a\\x1b[2J\\n\\u202e"
    assert harmless("a\nb\x07", keep="\n") == "a\nb\\x07"


def test_a_json_record_has_time_level_logger_message_and_fields(stream: io.StringIO) -> None:
    logs.configure(LogFormat.JSON, LogLevel.INFO, stream)
    log = logging.getLogger("knifetip.test")
    with logs.about(request_id="r1"):
        with logs.about(job="j1"):
            log.warning("lines: %d", 7, extra={logs.FIELDS: {"duration": 0.5}})
        log.debug("not written")
        log.info("after")
    first, second = map(json.loads, stream.getvalue().splitlines())
    assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z", first.pop("time"))
    assert first == {
        "level": "warning",
        "logger": "knifetip.test",
        "message": "lines: 7",
        "request_id": "r1",
        "job": "j1",
        "duration": 0.5,
    }
    assert "job" not in second


@pytest.mark.parametrize("form", list(LogFormat))
def test_the_trace_of_an_exception_stays_in_the_line_of_its_record(
    stream: io.StringIO, form: LogFormat
) -> None:
    logs.configure(form, LogLevel.INFO, stream)
    try:
        int("at \x1b[2J the table")
    except ValueError:
        logging.getLogger("knifetip.test").exception("it failed")
    assert stream.getvalue().count("\n") == 1
    assert "ValueError" in stream.getvalue()
    assert acting(stream.getvalue()[:-1]) == set()


SECRET = "s3cr3t-V4lue_with.signs"


@pytest.mark.parametrize(
    "text",
    [
        f"GET /?key={SECRET} HTTP/1.1",
        f"GET /?page=2&key={SECRET}&x=1",
        f"Authorization: Bearer {SECRET}",
        f"headers {{'authorization': 'Bearer {SECRET}', 'x': '1'}}",
        f"authorization=Basic {SECRET}",
        f"Cookie: knifetip_session={SECRET}; theme=dark",
        f"Set-Cookie: knifetip_8080={SECRET}; HttpOnly",
        f'{{"password": "{SECRET}", "name": "anna"}}',
        f"password={SECRET}",
        f"api_key: {SECRET}",
        f"X-API-Key: {SECRET}",
        f"client_secret={SECRET}&grant=code",
        f"postgresql+psycopg://shop:{SECRET}@db/shop",
        f"whsec_{SECRET}",
        f"a refused bearer {SECRET} was sent",
        f"token={SECRET}",
        f"GET /kt_abcdefghij_{SECRET}",
    ],
)
@pytest.mark.parametrize("form", list(LogFormat))
def test_secrets_are_hidden(stream: io.StringIO, form: LogFormat, text: str) -> None:
    logs.configure(form, LogLevel.INFO, stream)
    logging.getLogger("knifetip.test").error("%s", text, extra={logs.FIELDS: {"url": text}})
    assert SECRET not in stream.getvalue()
    assert "[hidden]" in stream.getvalue()


def test_a_named_secret_is_hidden_wherever_it_is(stream: io.StringIO) -> None:
    logs.configure(LogFormat.TEXT, LogLevel.INFO, stream)
    logs.hide("correct-horse-battery")
    logs.hide("")
    logging.getLogger("knifetip.test").error("found correct-horse-battery here")
    assert stream.getvalue().endswith("found [hidden] here\n")


def test_ordinary_texts_are_not_hidden() -> None:
    for text in (
        "job abc of drawing keyhole.dxf was released",
        "the keys of the machine",
        "http://127.0.0.1:8080/api/jobs?state=queued",
        "POST /api/jobs 201",
    ):
        assert logs.without_secrets(text) == text


@pytest.mark.parametrize("part", ["a-", "a.", "://a:", "key ", "key=", "bearer ", "authorization"])
def test_secrets_are_searched_in_a_time_that_grows_with_the_length_of_the_text(part: str) -> None:
    text = part * (100_000 // len(part))
    began = time.process_time()
    logs.without_secrets(text)
    # Less than 1 s.  A pattern that is tried at each word up to the end of the text takes minutes.
    assert time.process_time() - began < 20.0
