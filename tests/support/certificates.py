"""Certificates of authorities that the tests of a process load once, for all their HTTP clients."""

from __future__ import annotations

import os
import ssl
from functools import cache

import pytest
from httpx._transports import default

from tests.support.modules import original


def share_certificates(patch: pytest.MonkeyPatch) -> None:
    """Let all HTTP clients of this process use the certificates that the first one has loaded.

    httpx loads all certificates of authorities for each client, also if it speaks HTTP only: 0.04 s
    of CPU time.
    """
    create = original(default, "create_ssl_context")

    @cache
    def load(trust_env: bool, file: str | None, folder: str | None) -> ssl.SSLContext:
        made: ssl.SSLContext = create(trust_env=trust_env)
        return made

    def create_ssl_context(
        verify: ssl.SSLContext | str | bool = True, cert: None = None, trust_env: bool = True
    ) -> ssl.SSLContext:
        if verify is not True or cert is not None:
            other: ssl.SSLContext = create(verify, cert, trust_env)
            return other
        # What httpx reads in the environment, which tests change.
        return load(trust_env, *map(os.environ.get, ("SSL_CERT_FILE", "SSL_CERT_DIR")))

    # Not the public function: whoever calls that may add certificates to its result.
    patch.setattr(default, "create_ssl_context", create_ssl_context)
