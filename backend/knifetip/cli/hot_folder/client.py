"""Requests of a hot folder to the server."""

from __future__ import annotations

from typing import Any
from urllib.parse import quote

import httpx

from knifetip.errors import RequestError
from knifetip.harmless import harmless
from knifetip.messages import Message, from_json

#: Statuses of answers after which the same request is sent again later.
_AGAIN = (408, 423, 425, 429)
#: Statuses with which a proxy, or a fault in the server, may refuse one file and accept others.
_OF_ONE_FILE = (400, 413, 414, 422, 431, 500)


class RetryLater(Exception):
    """Raised when a request must be repeated later.

    Parameters
    ----------
    reason
        The reason, as text.
    of_one_file
        Whether requests for other files may be accepted.
    """

    def __init__(self, reason: str, *, of_one_file: bool = False) -> None:
        super().__init__(reason)
        self.of_one_file = of_one_file


class OrderRefused(RequestError):
    """Raised when the server refuses a request; ``questions`` are those of the drawing.

    Parameters
    ----------
    message
        Message of the server.
    questions
        Open questions about the drawing, as texts.
    """

    def __init__(self, message: Message, questions: tuple[str, ...] = ()) -> None:
        super().__init__(message)
        self.questions = questions


class OrderClient:
    """HTTP client for uploads, jobs and their results.

    Parameters
    ----------
    server
        URL of the server.
    headers
        Headers of all requests, such as that with the access key.
    """

    def __init__(self, server: str, headers: dict[str, str]) -> None:
        self._server = server.rstrip("/")
        self._client = httpx.Client(
            headers={**headers, "X-Knifetip": "watch"},
            timeout=60.0,
            trust_env=False,  # no proxies; authorities in SSL_CERT_FILE are trusted nevertheless
            verify=httpx.create_ssl_context(),
        )

    def upload(self, name: str, content: bytes, fields: dict[str, str], key: str) -> str:
        """Upload a drawing under an Idempotency-Key; return its id.

        The server refuses control characters in names, which files may have.
        """
        answer = self._send(
            "POST", "/drawings", files={"file": (harmless(name), content)}, data=fields, key=key
        )
        return str(_fields(answer)["id"])

    def order(self, order: dict[str, Any], key: str) -> str:
        """Create a job under an Idempotency-Key; return its id."""
        return str(_fields(self._send("POST", "/jobs", json=order, key=key))["id"])

    def order_xjdf(self, content: bytes, fields: dict[str, Any], key: str) -> tuple[str, str]:
        """Create a job from an XJDF document or package; return the ids of job and drawing."""
        parameters = {
            name: str(value).lower() if value in (True, False) else value
            for name, value in fields.items()
        }
        answer = self._send("POST", "/xjdf", content=content, params=parameters, key=key)
        job = _fields(answer)
        return str(job["id"]), str(job["drawing"])

    def job_as_xjdf(self, id: str) -> bytes:
        """Return a job with its state as XJDF."""
        return self._send("GET", f"/jobs/{quote(id, safe='')}/xjdf").content

    def job(self, id: str) -> dict[str, Any]:
        """Return a job as JSON data."""
        return _fields(self._send("GET", f"/jobs/{quote(id, safe='')}"))

    def program(self, id: str) -> tuple[bytes, str]:
        """Return the program of a job, and the name under which the server sends it."""
        answer = self._send("GET", f"/jobs/{quote(id, safe='')}/program")
        return answer.content, answer.headers.get("Content-Disposition", "")

    def picture(self, drawing: str) -> bytes:
        """Return the picture of a drawing as SVG."""
        return self._send("GET", f"/drawings/{quote(drawing, safe='')}/picture").content

    def close(self) -> None:
        """Close the connections."""
        self._client.close()

    def _send(self, method: str, path: str, key: str = "", **body: Any) -> httpx.Response:
        """Send a request and return the answer, which is a success.

        Raises ``RetryLater``: the server cannot be reached, or cannot process requests now.
        Raises ``OrderRefused``: the server refuses the request.
        """
        headers = {"Idempotency-Key": key} if key else {}
        try:
            answer = self._client.request(
                method, f"{self._server}/api/v1{path}", headers=headers, **body
            )
        except httpx.HTTPError as reason:
            raise RetryLater(str(reason) or type(reason).__name__) from reason
        if answer.is_success:
            return answer
        status = answer.status_code
        of_one_file = status in _OF_ONE_FILE
        try:
            problem = answer.json()
            message = from_json({"text": problem["detail"], **problem})
        except (ValueError, TypeError, KeyError):
            # Not an answer of knifetip: that of a proxy, or of another server.
            raise RetryLater(f"HTTP status {status}", of_one_file=of_one_file) from None
        # A missing or expired key is replaced by a person; the files wait meanwhile.
        if status >= 500 or status in (401, 403, *_AGAIN):
            raise RetryLater(f"HTTP status {status}: {problem['detail']}", of_one_file=of_one_file)
        questions = tuple(str(from_json(one)) for one in problem.get("questions", ()))
        raise OrderRefused(message, questions)


def _fields(answer: httpx.Response) -> dict[str, Any]:
    """Return the JSON of a drawing or a job.

    Raises ``RetryLater``: the answer is another one, such as the page of a proxy on which a person
    signs in.
    """
    try:
        found = answer.json()
    except ValueError:
        found = None
    if not isinstance(found, dict) or "id" not in found:
        raise RetryLater("the answer is not that of knifetip")
    return found
