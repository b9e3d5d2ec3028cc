"""gateway: what a gateway and the service say to each other."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, Field

from knifetip.api.schemas.common import Count, Name, Strict


class ClaimIn(Strict):
    """A gateway asks for work and says how long it will wait for it."""

    gateway: Name
    machine: Name
    wait: float = Field(default=20.0, ge=0.0, le=60.0)


class Claim(BaseModel):
    """A job for this gateway alone, until the lease runs out."""

    job: str
    epoch: int
    lease: float = Field(description="Seconds; each heartbeat renews it")
    program: str = Field(description="URL of the program's bytes")
    sha256: str
    lines: int
    copies: int
    confirm: bool = Field(
        default=False,
        description="Send nothing to the machine: heartbeats with `waiting` until one is answered "
        "with `start`",
    )


class HeartbeatIn(Strict):
    """What the machine did since the last one."""

    job: Name
    epoch: Count
    line: Count
    copies_done: Count = 0
    held: bool = False
    waiting: bool = Field(
        default=False,
        description="Nothing has been sent to the machine yet: the gateway waits for `start`",
    )
    position: tuple[float, float, float, float] | None = None
    seconds_left: float | None = None


class HeartbeatOut(BaseModel):
    """What the gateway is to do."""

    command: Literal["wait", "start", "continue", "hold", "resume", "cancel"]
    lease: float


class FinishIn(Strict):
    """How it ended."""

    job: Name
    epoch: Count
    outcome: Literal["done", "interrupted", "cancelled", "returned"] = Field(
        description="returned: the claim is given back, nothing was sent to the machine"
    )
    why: str = Field(default="", max_length=2000)
    line: Count | None = Field(
        default=None, description="The last line executed, where it is not the last heartbeat's"
    )
    copies_done: Count | None = Field(default=None, description="Under this claim")
