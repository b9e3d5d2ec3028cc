"""Time after which an operation of a person expires in tests of the gateway."""

from __future__ import annotations

from typing import Final

#: Much longer than the real limit, so that no operation expires because the computer is busy (s).
EXPIRY: Final = 30.0
