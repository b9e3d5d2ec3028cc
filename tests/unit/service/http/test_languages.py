"""Errors are in the language that the request accepts; their code and arguments are the same."""

from __future__ import annotations

import pytest

from tests.support.serving.server import LocalClient

pytestmark = pytest.mark.xdist_group("server")

GERMAN = "Auftrag 'none' gibt es nicht."
ENGLISH = "Job 'none' does not exist."


@pytest.mark.parametrize(
    ("accepted", "language", "text"),
    [
        ("de-AT,de;q=0.9,en;q=0.5", "de", GERMAN),
        ("en, de;q=0.5", "en", ENGLISH),
        ("fr", "en", ENGLISH),
        ("", "en", ENGLISH),
    ],
)
def test_an_error_is_in_the_language_of_the_request(
    client: LocalClient, accepted: str, language: str, text: str
) -> None:
    answer = client.get("/api/v1/jobs/none", headers={"Accept-Language": accepted})
    assert answer.status_code == 404
    assert answer.headers["Content-Language"] == language
    assert "Accept-Language" in answer.headers["Vary"]
    problem = answer.json()
    assert problem["code"] == "job.unknown"
    assert problem["arguments"] == {"job": "'none'"}
    assert (problem["text"], problem["detail"]) == (text, text)


def test_the_hint_of_an_error_is_in_the_same_language(client: LocalClient) -> None:
    answer = client.get("/api/v1/jobs/none", headers={"Accept-Language": "de"})
    assert answer.json()["hint"] == "Einen der Aufträge wählen, die GET /api/jobs nennt."
    assert int(answer.headers["Content-Length"]) == len(answer.content)
