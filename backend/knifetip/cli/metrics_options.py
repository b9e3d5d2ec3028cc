"""metrics_options: the option that opens a port for Prometheus."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import typer


@dataclass(frozen=True, slots=True)
class MetricsOptions:
    """Option that names the address at which Prometheus reads metrics without a key."""

    metrics_address: Annotated[
        str,
        typer.Option(
            envvar="KNIFETIP_METRICS_ADDRESS",
            help="HOST:PORT at which Prometheus reads metrics without a key, such as "
            "127.0.0.1:9464. Everybody who reaches it sees names of machines and numbers of jobs. "
            "Default: none.",
        ),
    ] = ""
