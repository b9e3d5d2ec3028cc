"""Routes for machines, with their stations, their tools, their gateway and their current job."""

from __future__ import annotations

from fastapi import APIRouter

from knifetip.api.parameters import MachineName
from knifetip.api.schemas.machines import MachineOut
from knifetip.api.service import ServiceDep, check_library_name
from knifetip.api.waiting import ABSENT
from knifetip.library import load
from knifetip.model.machine import Machine
from knifetip.model.tool import kind_of
from knifetip.presentation.machine import machine_json, station_json

router = APIRouter(prefix="/machines", tags=["machines"])


@router.get("")
def list_machines(service: ServiceDep) -> list[MachineOut]:
    """List the machines of the library with their current jobs."""
    connected = service.store.machines.connected_machines(ABSENT)
    on_table = service.store.machines.jobs_on_tables()
    return [
        _machine_out(load.machine(name), name in connected, on_table.get(name))
        for name in load.names("machines")
    ]


@router.get("/{name}")
def get_machine(service: ServiceDep, name: MachineName) -> MachineOut:
    """Get a machine of the library with its current job."""
    machine = load.machine(check_library_name("machines", name))
    return _machine_out(
        machine,
        name in service.store.machines.connected_machines(ABSENT),
        service.store.machines.jobs_on_tables().get(name),
    )


def _machine_out(machine: Machine, connected: bool, job: str | None) -> MachineOut:
    return MachineOut.model_validate(
        {
            **machine_json(machine),
            "offset_cuts": machine.offset_cuts,
            "stations": [
                {
                    **station_json(station),
                    "tool": {
                        "kind": kind_of(station.tool).name,
                        "dimensions": station.tool.dimensions,
                        "footprint": station.tool.footprint,
                    },
                }
                for station in machine.stations
            ],
            "gateway": "connected" if connected else "absent",
            "job": job,
        }
    )
