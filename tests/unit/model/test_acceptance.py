from dataclasses import replace

import numpy as np
import pytest

from knifetip.errors import RequestError
from knifetip.messages import Message
from knifetip.model.acceptance import Exceptions, with_exceptions, with_ordered_exceptions
from knifetip.model.verdict import Acceptance, Finding, Severity, Verdict

WIDE = Message("verify.wide-slit", length=50.0, width=6.0)
OFF = Message("verify.unclassified")
GIVEN = Acceptance("Ada", "the tab is 8 mm wide", 1.0)


def verdict(*findings: Finding) -> Verdict:
    nothing = np.zeros(0)
    return Verdict(
        accepted=not any(found.refuses for found in findings),
        tolerance=0.01,
        deviation=nothing,
        overcut=nothing,
        uncut=nothing,
        setback=nothing,
        findings=findings,
        seconds=1.0,
    )


def slit(edge: int) -> Finding:
    return Finding("kerf", WIDE, 50.0, edge, severity=Severity.SHORTFALL)


def test_a_program_is_accepted_when_all_its_shortfalls_are() -> None:
    refused = verdict(slit(3), slit(4))
    partly = with_exceptions(refused, {(3, WIDE.code)}, GIVEN)
    assert [found.acceptance for found in partly.findings] == [GIVEN, None]
    assert (refused.accepted, partly.accepted) == (False, False)
    later = replace(GIVEN, by="Grace")
    both = with_exceptions(partly, {(3, WIDE.code), (4, WIDE.code)}, later)
    assert both.accepted
    # The first decision about a shortfall stays.
    assert [found.acceptance for found in both.findings] == [GIVEN, later]


def test_a_fault_is_never_accepted_and_refuses_the_program() -> None:
    fault = Finding("stray", OFF, 2.0, 3)
    with pytest.raises(RequestError, match="is no shortfall, so it cannot be accepted"):
        with_exceptions(verdict(fault), {(3, OFF.code)}, GIVEN)
    # A fault and a shortfall with the same edge and code.
    twin = replace(slit(3), severity=Severity.FAULT)
    with pytest.raises(RequestError, match="cannot be accepted"):
        with_exceptions(verdict(slit(3), twin), {(3, WIDE.code)}, GIVEN)
    assert not with_exceptions(verdict(slit(4), fault), {(4, WIDE.code)}, GIVEN).accepted


def test_a_note_or_a_missing_finding_cannot_be_accepted() -> None:
    note = replace(slit(3), severity=Severity.NOTE)
    with pytest.raises(RequestError, match="no shortfall"):
        with_exceptions(verdict(note), {(3, WIDE.code)}, GIVEN)
    with pytest.raises(RequestError, match=r"no finding verify\.wide-slit at edge 5"):
        with_exceptions(verdict(slit(3)), {(5, WIDE.code)}, GIVEN)


def test_a_note_beside_a_shortfall_of_the_same_code_stays_a_note() -> None:
    note = replace(slit(3), severity=Severity.NOTE)
    accepted = with_exceptions(verdict(slit(3), note), {(3, WIDE.code)}, GIVEN)
    assert accepted.accepted
    assert [found.acceptance for found in accepted.findings] == [GIVEN, None]


def test_an_order_accepts_the_shortfalls_that_it_names_and_the_program_has() -> None:
    order = Exceptions(((3, WIDE.code), (9, WIDE.code)), GIVEN)
    made = with_ordered_exceptions(verdict(slit(3)), order)
    assert made.accepted
    assert [found.acceptance for found in made.findings] == [GIVEN]
    more = with_ordered_exceptions(verdict(slit(3), slit(4)), order)
    assert not more.accepted
    assert [found.acceptance for found in more.findings] == [GIVEN, None]
    # An order is no acceptance of a fault with the same edge and code.
    twin = replace(slit(3), severity=Severity.FAULT)
    spoilt = with_ordered_exceptions(verdict(slit(3), twin), order)
    assert [found.acceptance for found in spoilt.findings] == [None, None]
