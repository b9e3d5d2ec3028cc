"""firmware: the build of grbl or grblHAL on a simulated table, and its reports of itself."""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.gateway.interpreter import Block, LineRefused
from knifetip.gateway.motion import Pose
from knifetip.model.machine import Machine

#: Setting with the rotary axes; as all settings of grblHAL from 256 on, ``$$`` does not report it.
ROTARY_AXES = 376


@dataclass(frozen=True, slots=True)
class Firmware:
    """Properties that differ between builds of grblHAL, and between grblHAL and grbl 1.1."""

    axes: str = "XYZC"  #: letters in the order of status reports; one of them is A, B or C, or none
    outputs: int = 16  #: number of digital outputs (M64, M65)
    grblhal: bool = True  #: grblHAL, which states its axes and outputs; False for grbl 1.1
    sizes: bool = True  #: whether it states the sizes of planner and receive buffer

    @property
    def rotary(self) -> str:
        """Letter of the axis that rotates the tool; empty if there is none."""
        return next((letter for letter in "CAB" if letter in self.axes), "")

    def by_axis(self, pose: Pose) -> str:
        """Return the figures of a pose for each axis of the controller; 0 for further axes."""
        figures = dict(zip(f"XYZ{self.rotary or '-'}", pose, strict=True))
        return ",".join(f"{figures.get(axis, 0.0):.3f}" for axis in self.axes)

    def require_axes(self, text: bytes) -> None:
        """Raise ``LineRefused`` for an unknown axis letter."""
        if any(letter in text and letter != self.rotary.encode() for letter in (b"A", b"B", b"C")):
            raise LineRefused(36 if self.grblhal else 20)

    def require_output(self, block: Block) -> None:
        """Raise ``LineRefused`` for an output that the controller does not have."""
        if block.output >= self.outputs:
            raise LineRefused(39 if self.outputs else 20)

    def build_info(self, blocks: int, window: int) -> list[str]:
        """Return the answer to ``$I`` without its ``ok``.

        Parameters
        ----------
        blocks
            Blocks of the planner.
        window
            Size of the receive buffer (bytes).
        """
        lines = ["[VER:1.1f.knifetip:simulated table]"]
        if not self.sizes:
            lines.append("[OPT:PHS]")
        elif self.grblhal:
            lines.append(f"[OPT:VNMSL,{blocks},{window},{len(self.axes)},0]")
        else:
            lines.append(f"[OPT:V,{blocks},{window}]")
        if self.grblhal:
            lines.append(f"[AXS:{len(self.axes)}:{self.axes}]")
            lines.append("[FIRMWARE:grblHAL]")
            lines.append(f"[AUX IO:0,{self.outputs},0,0]")
        return lines


def settings(machine: Machine, firmware: Firmware) -> dict[int, str]:
    """Return the settings of a machine's controller by their numbers, as ``$$`` reports them."""
    fastest = max((station.speed for station in machine.stations), default=0)
    found = {
        10: "511" if firmware.grblhal else "3",
        13: "0",
        20: "1",
        21: "1",
        22: "1",
        23: "0",
        30: f"{max(fastest, 1000)}",
        32: f"{int(machine.has_beam)}",
    }
    axes = dict(zip(f"XYZ{firmware.rotary or '-'}", machine.carriages[0].axes, strict=True))
    for index, letter in enumerate(firmware.axes):
        axis = axes.get(letter, machine.c)
        found[100 + index] = "80.000"
        found[110 + index] = f"{axis.velocity * 60.0:.3f}"
        found[120 + index] = f"{axis.acceleration:.3f}"
        found[130 + index] = f"{axis.high - axis.low:.3f}"
    if firmware.grblhal and len(firmware.axes) > len("XYZ"):
        found[ROTARY_AXES] = f"{(1 << (len(firmware.axes) - len('XYZ'))) - 1}"
    return found
