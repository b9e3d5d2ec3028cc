"""knifetip ticket: the PDF of a server in a file, in the language of the user."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import httpx
import pytest

from tests.support.command import Command


def test_the_ticket_of_a_job_is_written(
    knifetip: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    sent: list[tuple[str, Any]] = []

    def answer(method: str, url: str, *, params: Any, **_: Any) -> httpx.Response:
        sent.append((f"{method} {url}", params))
        return httpx.Response(200, content=b"%PDF-1.4")

    monkeypatch.setattr(httpx, "request", answer)
    file = tmp_path / "ticket.pdf"
    code, out = knifetip("ticket", "abc", "-o", file, "--language", "de")[:2]
    assert (code, out.strip()) == (0, str(file))
    assert file.read_bytes() == b"%PDF-1.4"
    assert sent == [("GET http://127.0.0.1:8080/api/v1/jobs/abc/ticket.pdf", {"language": "de"})]
