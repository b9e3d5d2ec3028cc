"""The number of random examples of a test: all of them, or a share in `make test`."""

from __future__ import annotations

from collections.abc import Collection

from hypothesis import HealthCheck, settings

#: Profile of `make test`, in which each test draws a share of its examples.
QUICK = "quick"
#: A test with more examples draws one of SHARE in the profile QUICK, but at least LEAST.
SHARE, LEAST = 8, 25


def examples(count: int, suppress_health_check: Collection[HealthCheck] = ()) -> settings:
    """Return the settings of a test that draws ``count`` examples, and a share in `make test`."""
    return settings(max_examples=drawn(count), suppress_health_check=suppress_health_check)


def drawn(count: int) -> int:
    """Return how many of ``count`` random examples a test draws in this run."""
    return min(count, max(LEAST, count // SHARE)) if is_quick() else count


def is_quick() -> bool:
    """Return whether this is the shorter run, ``make test``."""
    return settings.get_current_profile_name() == QUICK
