"""Job tickets: their text read by pypdf, and their QR code decoded from the printed page."""

from __future__ import annotations

import io
import json
from pathlib import Path
from typing import Any

import numpy as np
import pypdf
import pypdfium2
import pytest
import zxingcpp

from knifetip.handover.ticket.document import write_ticket
from knifetip.handover.ticket.facts import Accepted, StationUse, TicketFacts, TypeLength
from knifetip.handover.ticket.sentences import Sentences
from knifetip.messages import Message
from knifetip.model.figure import Figure, FigureLayer
from tests.support.hostile_names import HOSTILE_NAMES

KNIFE = StationUse(
    1, "Knife", "knife", Message("ticket.tool-blade", width=1.5, angle=30.0), 5230.0, 61.2
)
ACCEPTED = {"accepted": True, "deviation": 0.0071, "tolerance": 0.01, "overcut": 0.41}
PICTURE = Figure(
    (
        FigureLayer(
            "CUT",
            "#d9534f",
            1,
            (),
            np.array([[[0.0, 0.0], [90.0, 0.0]], [[90.0, 0.0], [0.0, 50.0]]]),
            np.zeros(2),
        ),
    )
)


def facts(**changed: Any) -> TicketFacts:
    fields: dict[str, Any] = {
        "job": "b7d1",
        "state": "ready",
        "printed": 1.9e9,
        "address": "https://shop.example/#/station/demo-table",
        "order": "PO-4711",
        "customer": "Müller & Söhne GmbH",
        "due": 1.9e9 + 86400.0,
        "notes": "Grain along X.",
        "drawing": "tray.dxf",
        "revision": 3,
        "is_changed": False,
        "machine": "Demo table",
        "board": "E-flute",
        "caliper": 1.6,
        "sheet": (700.0, 500.0),
        "margins": (10.0, 20.0),
        "corner": (20.0, 22.5),
        "copies": 3,
        "seconds": 95.2,
        "lines": 1234,
        "summary": {**ACCEPTED, "exceptions": 0},
        "stations": (KNIFE,),
        "lengths": (TypeLength("cut", 5230.0),),
        **changed,
    }
    return TicketFacts(**fields)


def pages(content: bytes) -> list[str]:
    return [page.extract_text() for page in pypdf.PdfReader(io.BytesIO(content)).pages]


def ticket(language: str = "en", **changed: Any) -> str:
    """Return the text of a ticket, with one space for each white space."""
    return " ".join("\n".join(pages(write_ticket(facts(**changed), PICTURE, language))).split())


def test_a_ticket_states_what_the_operator_needs() -> None:
    text = ticket()
    for part in (
        "Order PO-4711",
        "Customer Müller & Söhne GmbH",
        "Drawing tray.dxf, revision 3",
        "E-flute, 1.6 mm thick",
        "Sheet 700 × 500 mm, margins 10 mm left, 20 mm below",
        "lower left corner of the sheet at X 20.0, Y 22.5 mm",
        "Copies 3",
        "1:35 min each, 4:46 min for all copies",
        "T1 Knife Knife: blade 1.5 mm wide, slanted 30° 5.23 m 1:01 min",
        "cut: 5.23 m",
        "The program makes the drawing within 0.007 mm (0.01 mm allowed)",
        "Grain along X.",
        "page 1 of 1",
    ):
        assert part in text, part


def test_a_ticket_is_german_with_decimal_commas() -> None:
    text = ticket("de")
    for part in (
        "Auftragszettel",
        "Kunde Müller & Söhne GmbH",
        "E-flute, 1,6 mm dick",
        "Schneiden: 5,23 m",
        "auf 0,007 mm genau (0,01 mm erlaubt)",
        "Seite 1 von 1",
    ):
        assert part in text, part


def test_a_qr_code_on_the_page_opens_the_station() -> None:
    with pypdfium2.PdfDocument(write_ticket(facts(), PICTURE, "en")) as document:
        picture = document[0].render(scale=2).to_pil()
    (code,) = zxingcpp.read_barcodes(picture)
    assert code.text == facts().address


def test_exceptions_are_listed_with_who_when_and_why() -> None:
    finding = Message("layout.no-unit", drawing="tray")
    accepted = Accepted(finding, "Anna", 1.9e9, "sample only")
    text = ticket(summary={**ACCEPTED, "exceptions": 40}, accepted=(accepted,) * 40)
    assert "except for 40 accepted exceptions" in text
    assert "accepted by Anna, 2030-03-17" in text
    assert text.count("sample only") == 30
    assert "and 10 more" in text


@pytest.mark.parametrize(
    ("changed", "warning"),
    [
        ({"lines": 0, "summary": None, "state": "compiling"}, "There is no program yet"),
        ({"summary": None}, "The program is not verified"),
        (
            {"summary": {**ACCEPTED, "accepted": False, "faults": 2, "shortfalls": 1}},
            "REFUSED: the program does not make the drawing as drawn; findings that refuse it: 3",
        ),
        ({"is_changed": True}, "revision 3. CHANGED after this job was ordered"),
    ],
)
def test_a_ticket_warns_of_what_must_not_be_made(changed: dict[str, Any], warning: str) -> None:
    assert warning in ticket(**changed)


def test_a_job_without_a_program_or_details_has_a_ticket() -> None:
    text = ticket(
        order="", customer="", due=None, notes="", caliper=None, sheet=None, corner=None,
        seconds=0.0, lines=0, summary=None, stations=(), lengths=(),
    )  # fmt: skip
    assert "Order Job b7d1" in text
    assert "Tools to be loaded" not in text


def test_twelve_tools_and_200_copies_fit_on_two_pages() -> None:
    stations = tuple(KNIFE._replace(number=number) for number in range(1, 13))
    found = pages(
        write_ticket(facts(stations=stations, copies=200, notes="word " * 400), PICTURE, "de")
    )
    assert len(found) == 2
    assert "T12" in found[0]
    assert "Seite 2 von 2" in found[1]
    assert "5:17 h" in found[0]


#: Times in s, and as the page writes them: its test reads the same table.
DURATIONS = json.loads(
    (Path(__file__).parents[3] / "support" / "durations.json").read_text("utf-8")
)


@pytest.mark.parametrize(("seconds", "text"), DURATIONS)
def test_a_time_is_written_as_the_page_writes_it(seconds: float, text: str) -> None:
    assert Sentences(facts(), "en").duration(seconds) == text
    assert Sentences(facts(), "de").duration(seconds) == text.replace(".", ",")


def test_names_in_other_scripts_and_missing_letters() -> None:
    text = ticket(customer="Ωμέγα Жук „Karton“ 日本包装")
    assert "Ωμέγα Жук „Karton“ □□□□" in text
    assert "A box □ stands for a letter" in text
    # The letters of a line from right to left are stored in the order in which they are printed.
    assert "םולש" in ticket(customer="שלום")
    assert "A box" not in ticket(customer="שלום")


def test_a_name_of_190_letters_without_spaces_is_broken_into_lines() -> None:
    name = "Wellpappe" * 21 + "X"
    joined = ticket(customer=name).replace(" ", "")
    assert name in joined


@pytest.mark.parametrize("kind", HOSTILE_NAMES)
def test_a_hostile_name_does_not_change_the_ticket(kind: str) -> None:
    name = HOSTILE_NAMES[kind]
    text = ticket(customer=name, drawing=name, notes=name, order=name)
    assert "Place on the table" in text
    assert "page 1 of 1" in text


def test_an_address_that_is_too_long_gives_no_code() -> None:
    with pypdfium2.PdfDocument(write_ticket(facts(address="x" * 5000), PICTURE, "en")) as document:
        assert not zxingcpp.read_barcodes(document[0].render(scale=2).to_pil())


def test_a_font_that_cannot_be_read_is_left_out(tmp_path: Any) -> None:
    broken = tmp_path / "broken.ttf"
    broken.write_bytes(b"no font")
    fonts = [str(broken), str(tmp_path / "missing.ttf")]
    assert "PO-4711" in pages(write_ticket(facts(), PICTURE, "en", fonts))[0]
