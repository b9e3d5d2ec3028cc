"""Passwords that are guessed first are refused, for the reason that applies."""

from __future__ import annotations

import pytest

from knifetip.errors import RequestError
from knifetip.service.accounts.passwords import check_password
from knifetip.service.accounts.weak_passwords import weakness_of


@pytest.mark.parametrize(
    ("password", "reason"),
    [
        (" " * 10, "blank"),
        ("\t \t \t \t \t \t", "blank"),
        ("aaaaaaaaaa", "repeated"),
        ("abababababab", "repeated"),
        ("abc123abc123", "repeated"),
        ("1234567890", "sequence"),
        ("0987654321", "sequence"),
        ("abcdefghij", "sequence"),
        ("qwertyuiop", "sequence"),
        ("asdfghjkl123", "sequence"),
        ("1q2w3e4r5t", "sequence"),
        ("password123", "common"),
        ("Password!!", "common"),
        ("P@ssw0rd2024", "common"),
        ("letmein1234", "common"),
        ("welcome2026!", "common"),
        ("iloveyou123", "common"),
        ("Admin-Admin-1", "common"),
        ("changeme2024", "common"),
        ("annabelle2", "name"),
        ("annabelle-password", "name"),
        ("knifetip2026", "name"),
        ("Kn1fet1p!!!!", "name"),
    ],
)
def test_a_weak_password_is_refused_with_its_reason(password: str, reason: str) -> None:
    assert weakness_of(password, "annabelle") == reason
    with pytest.raises(RequestError) as refused:
        check_password(password, "annabelle")
    assert refused.value.message.code in ("user.weak-password", "user.bad-password")


@pytest.mark.parametrize(
    "password",
    [
        "four words of text",
        "correct horse battery staple",
        "Tr0ub4dor&3x",
        "zwölf Boxkämpfer",
        "mfp-92-koala-tin",
        "x7$kQp!2mZv0",
    ],
)
def test_a_password_that_is_not_guessed_first_is_accepted(password: str) -> None:
    assert weakness_of(password, "annabelle") is None
    check_password(password, "annabelle")
