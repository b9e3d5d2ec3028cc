"""Addresses to which webhooks may be sent."""

from __future__ import annotations

import asyncio
import ipaddress
import socket
import threading

import pytest

from knifetip.errors import RequestError
from knifetip.service.webhooks.egress import check_url, is_permitted, resolve


@pytest.mark.parametrize(
    ("address", "private", "public"),
    [
        ("93.184.216.34", True, True),
        ("2606:2800:220:1::1", True, True),
        ("127.0.0.1", True, False),
        ("::1", True, False),
        ("192.168.1.20", True, False),
        ("10.0.0.1", True, False),
        ("fd12:3456::1", True, False),
        ("169.254.169.254", False, False),
        ("169.254.1.1", False, False),
        ("fe80::1", False, False),
        ("::ffff:169.254.169.254", False, False),
        ("64:ff9b::a9fe:a9fe", False, False),
        ("2002:a9fe:a9fe::1", False, False),
        ("::ffff:192.168.1.20", True, False),
        ("fd00:ec2::254", False, False),
        ("fd20:ce::254", False, False),
        ("100.100.100.200", False, False),
        ("168.63.129.16", False, False),
        ("0.0.0.0", False, False),
        ("::", False, False),
        ("224.0.0.1", False, False),
        ("255.255.255.255", False, False),
        ("240.0.0.1", False, False),
    ],
)
def test_addresses(address: str, private: bool, public: bool) -> None:
    found = ipaddress.ip_address(address)
    assert is_permitted(found, private=True) is private
    assert is_permitted(found, private=False) is public


@pytest.mark.parametrize(
    "url",
    [
        "http://erp.example/hooks",
        "https://erp.example:8443/hooks?shop=1",
        "http://127.0.0.1:9000/",
        "http://[::1]:9000/",
    ],
)
def test_usable_urls(url: str) -> None:
    assert check_url(url, private=True) == url


@pytest.mark.parametrize(
    "url",
    [
        "",
        "erp.example/hooks",
        "ftp://erp.example/",
        "file:///etc/passwd",
        "http://",
        "http:///hooks",
        "http://user:pass@erp.example/",
        "http://user@erp.example/",
        "http://erp.example:0/",
        "http://erp.example:99999/",
        "http://[::1/",
        "http://erp.example/\r\nX: 1",
        "http://erp.example/ a",
        "http://erp.example/ü",
        "http://169.254.169.254/latest/meta-data",
        "http://[fe80::1]/",
    ],
)
def test_refused_urls(url: str) -> None:
    with pytest.raises(RequestError) as refused:
        check_url(url, private=True)
    assert refused.value.source == ("url",)


def test_every_address_of_a_name_is_checked() -> None:
    found = asyncio.run(resolve("http://localhost:9/", private=True))
    assert found
    assert set(found) <= {"127.0.0.1", "::1"}
    with pytest.raises(RequestError):
        asyncio.run(resolve("http://localhost:9/", private=False))
    # Forms of 169.254.169.254 that only the resolver understands.
    for host in ("2852039166", "0xa9.254.43518", "169.254.169.254"):
        with pytest.raises(RequestError):
            asyncio.run(resolve(f"http://{host}/", private=True))


def test_a_name_server_that_does_not_answer_blocks_no_other_threads(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Event streams wait for the threads of the event loop, too."""
    answer = threading.Event()

    def wait(*_: object, **__: object) -> list[object]:
        answer.wait(60.0)
        return []

    monkeypatch.setattr(socket, "getaddrinfo", wait)

    async def resolve_many() -> str:
        waiting = [
            asyncio.ensure_future(resolve("http://erp.example/", private=True)) for _ in range(40)
        ]
        await asyncio.sleep(0)  # all have begun
        try:
            return await asyncio.wait_for(asyncio.to_thread(lambda: "works"), 30.0)
        finally:
            answer.set()
            await asyncio.gather(*waiting, return_exceptions=True)

    assert asyncio.run(resolve_many()) == "works"
