"""Connections of webhooks: names with several addresses, and certificates."""

from __future__ import annotations

import asyncio
import datetime
import socket
import ssl
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from cryptography import x509
from cryptography.hazmat.primitives import hashes, serialization
from cryptography.hazmat.primitives.asymmetric import ec
from cryptography.x509.oid import NameOID

from knifetip.service.webhooks import sender as webhook_sender
from knifetip.service.webhooks.queue import ClaimedDelivery, DeliveryAttempt
from knifetip.service.webhooks.sender import attempt_delivery
from knifetip.service.webhooks.store import new_secret
from tests.support.serving.webhook_receiver import Receiver, run_receiver

NAME = "erp.shop.example"


def send(url: str, *, private: bool = True) -> DeliveryAttempt:
    secrets = (new_secret(),)
    claimed = ClaimedDelivery(1, 1, "msg_1", url, "{}", secrets, "webhook.test", 1, "")
    return asyncio.run(attempt_delivery(claimed, 1000.0, private=private))


def url_of(receiver: Receiver, scheme: str = "http") -> str:
    """Return the URL of a receiver with the name of the ERP."""
    port = receiver.url.split(":")[2]
    return f"{scheme}://{NAME}:{port}"


@pytest.fixture(autouse=True)
def _patience(monkeypatch: pytest.MonkeyPatch) -> None:
    """Give a busy computer time."""
    monkeypatch.setattr(webhook_sender, "TIME_LIMIT", 120.0)


@pytest.fixture
def addresses(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The addresses of the name of the ERP, which a test sets."""
    found: list[str] = []

    def look_up(host: str, port: int, *_: object, **__: object) -> list[Any]:
        assert host == NAME
        kind = socket.SOCK_STREAM
        return [
            (
                socket.AF_INET6 if ":" in address else socket.AF_INET,
                *(kind, 0, "", (address, port)),
            )
            for address in found
        ]

    monkeypatch.setattr(socket, "getaddrinfo", look_up)
    return found


def test_the_next_address_is_tried_if_one_refuses(addresses: list[str]) -> None:
    """As where a name has an IPv6 address on which the ERP does not listen."""
    with run_receiver() as receiver:
        addresses[:] = ["::1", "127.0.0.9", "127.0.0.1"]
        assert send(url_of(receiver)).status == 204
        (call,) = receiver.calls
        assert call.headers["host"].startswith(NAME)
        addresses[:] = ["127.0.0.8", "127.0.0.9"]
        failed = send(url_of(receiver))
        assert (failed.status, bool(failed.fault)) == (0, True)
        # One forbidden address refuses the name, also if it would never be tried.
        addresses[:] = [*(f"127.0.0.{last}" for last in range(1, 9)), "169.254.169.254"]
        assert "169.254.169.254" in send(url_of(receiver)).fault
        assert len(receiver.calls) == 1


def test_a_delivery_is_not_sent_to_a_second_address_after_it_was_received(
    addresses: list[str],
) -> None:
    with run_receiver() as receiver:
        receiver.answer = lambda _call: (500, {})
        addresses[:] = ["127.0.0.1", "127.0.0.1", "127.0.0.2"]
        assert send(url_of(receiver)).status == 500
        assert len(receiver.calls) == 1


@contextmanager
def with_certificate(folder: Path, name: str) -> Iterator[tuple[Receiver, Path]]:
    """Run a receiver with a certificate of an authority of its own; yield that of the authority."""
    authority, certificate, key = certificates(name)
    for file, content in (("ca.pem", authority), ("server.pem", certificate + key)):
        (folder / file).write_bytes(content)
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(folder / "server.pem")
    with run_receiver(tls=context) as receiver:
        yield receiver, folder / "ca.pem"


def certificates(name: str) -> tuple[bytes, bytes, bytes]:
    """Return the certificate of an authority, one that it has signed, and the key of that."""
    now = datetime.datetime.now(datetime.UTC)
    keys = [ec.generate_private_key(ec.SECP256R1()) for _ in range(2)]
    subjects = [x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, one)]) for one in ("CA", name)]
    found = []
    for number in range(2):
        usage = x509.KeyUsage(
            *(True, False, False, False, False, number == 0, number == 0, False, False)
        )
        identifier = x509.SubjectKeyIdentifier.from_public_key(keys[number].public_key())
        issuer = x509.AuthorityKeyIdentifier.from_issuer_public_key(keys[0].public_key())
        builder = (
            x509.CertificateBuilder()
            .subject_name(subjects[number])
            .issuer_name(subjects[0])
            .public_key(keys[number].public_key())
            .serial_number(x509.random_serial_number())
            .not_valid_before(now - datetime.timedelta(days=1))
            .not_valid_after(now + datetime.timedelta(days=1))
            .add_extension(x509.BasicConstraints(number == 0, None), critical=True)
            .add_extension(usage, critical=True)
            .add_extension(identifier, critical=False)
            .add_extension(issuer, critical=False)
            .add_extension(x509.SubjectAlternativeName([x509.DNSName(name)]), critical=False)
        )
        signed = builder.sign(keys[0], hashes.SHA256())
        found.append(signed.public_bytes(serialization.Encoding.PEM))
    key = keys[1].private_bytes(
        serialization.Encoding.PEM,
        serialization.PrivateFormat.PKCS8,
        serialization.NoEncryption(),
    )
    return found[0], found[1], key


def test_the_authority_of_a_shop_is_trusted_if_the_system_trusts_it(
    addresses: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    addresses[:] = ["127.0.0.1"]
    webhook_sender._tls_settings.cache_clear()
    with with_certificate(tmp_path, NAME) as (receiver, authority):
        assert "certificate" in send(url_of(receiver, "https")).fault
        monkeypatch.setenv("SSL_CERT_FILE", str(authority))
        webhook_sender._tls_settings.cache_clear()
        assert send(url_of(receiver, "https")).status == 204
    with with_certificate(tmp_path, "other.example") as (receiver, _):
        webhook_sender._tls_settings.cache_clear()
        assert "certificate" in send(url_of(receiver, "https")).fault
        assert receiver.calls == []
    webhook_sender._tls_settings.cache_clear()
