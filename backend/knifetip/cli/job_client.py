"""HTTP client for the jobs of a server."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Final
from urllib.parse import parse_qsl, quote, urlsplit

from knifetip.errors import JobError
from knifetip.messages import from_json

if TYPE_CHECKING:
    import httpx

_PAGE: Final = 500  # jobs that are listed by one request


class JobClient:
    """HTTP client for the routes of the server under ``/api/v1/jobs``."""

    def __init__(self, server: str, key: str = "") -> None:
        self._headers = {"X-Knifetip": "cli"}
        if key:
            self._headers["Authorization"] = f"Bearer {key}"
        self._server = server.rstrip("/")

    def request(
        self,
        method: str,
        path: str = "",
        *,
        params: dict[str, Any] | None = None,
        body: dict[str, str] | None = None,
    ) -> Any:
        """Send a request to a path under ``/api/v1/jobs`` and return the decoded JSON answer.

        Parameters
        ----------
        method, path
            HTTP method, and path after ``/api/v1/jobs``.
        params
            Query parameters; None for none.
        body
            JSON body; None for none.

        Raises
        ------
        JobError
            The server cannot be reached or refuses the request; the error contains the message of
            the server, if the server sent one.
        """
        return self._answer(method, path, params=params, body=body).json()

    def _answer(
        self,
        method: str,
        path: str = "",
        *,
        params: dict[str, Any] | None = None,
        body: dict[str, str] | None = None,
    ) -> httpx.Response:
        import httpx  # imported here: slow, and other commands do not need it

        url = f"{self._server}/api/v1/jobs{path}"
        try:
            answer = httpx.request(
                method, url, params=params, json=body, headers=self._headers, timeout=30.0
            )
        except (httpx.HTTPError, httpx.InvalidURL) as reason:
            raise JobError("server.unreachable", server=self._server, reason=reason) from reason
        if answer.is_success:
            return answer
        try:
            content = answer.json()
        except ValueError:
            content = {}
        if isinstance(content, dict) and "detail" in content:
            raise JobError(from_json({"text": content["detail"], **content}))
        raise JobError("server.answered", url=url, status=answer.status_code)

    def job(self, id: str) -> dict[str, Any]:
        """Return the job with an id as JSON data."""
        return dict(self.request("GET", _path(id)))

    def checks(self, id: str) -> list[dict[str, Any]]:
        """Return the checks before the next start of a job as JSON data."""
        return list(self.request("GET", f"{_path(id)}/confirmation")["checks"])

    def tracks(self, id: str) -> list[dict[str, Any]]:
        """Return the tracks of the program of a job as JSON data."""
        return list(self.request("GET", f"{_path(id)}/tracks"))

    def export(self, id: str) -> bytes:
        """Return the zip file of a job.

        Raises
        ------
        JobError
            The server cannot be reached or refuses the request.
        """
        return self._answer("GET", f"{_path(id)}/export").content

    def ticket(self, id: str, language: str) -> bytes:
        """Return the job ticket of a job as PDF, in the language with a tag.

        Raises
        ------
        JobError
            The server cannot be reached or refuses the request.
        """
        return self._answer("GET", f"{_path(id)}/ticket.pdf", params={"language": language}).content

    def ids(self) -> Iterator[str]:
        """Yield the ids of all jobs of the server, newest first."""
        cursor: dict[str, Any] = {}
        while True:
            answer = self._answer("GET", params={"limit": _PAGE, **cursor})
            yield from (row["id"] for row in answer.json())
            following = answer.links.get("next", {}).get("url")
            if following is None:
                return
            cursor = dict(parse_qsl(urlsplit(following).query))

    def command(self, id: str, command: str, body: dict[str, Any] | None = None) -> dict[str, Any]:
        """Send a command for a job to the server; return the changed job as JSON data.

        Parameters
        ----------
        id
            Id of the job.
        command
            Name of the command, such as ``hold``.
        body
            JSON body of the request; None for none.
        """
        return dict(self.request("POST", f"{_path(id)}/{command}", body=body))


def _path(id: str) -> str:
    return f"/{quote(id, safe='')}"
