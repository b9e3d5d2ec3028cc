"""HTTP client for the jobs of a server."""

from __future__ import annotations

from typing import Any
from urllib.parse import quote

from knifetip.errors import JobError
from knifetip.messages import from_json


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
        import httpx  # imported here: slow, and other commands do not need it

        url = f"{self._server}/api/v1/jobs{path}"
        try:
            answer = httpx.request(
                method, url, params=params, json=body, headers=self._headers, timeout=30.0
            )
        except (httpx.HTTPError, httpx.InvalidURL) as reason:
            raise JobError("server.unreachable", server=self._server, reason=reason) from reason
        try:
            content = answer.json()
        except ValueError:
            content = {}
        if answer.is_success:
            return content
        if isinstance(content, dict) and "detail" in content:
            raise JobError(from_json({"text": content["detail"], **content}))
        raise JobError("server.answered", url=url, status=answer.status_code)

    def job(self, id: str) -> dict[str, Any]:
        """Return the job with an id as JSON data."""
        return dict(self.request("GET", _path(id)))

    def tracks(self, id: str) -> list[dict[str, Any]]:
        """Return the tracks of the program of a job as JSON data."""
        return list(self.request("GET", f"{_path(id)}/tracks"))

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
