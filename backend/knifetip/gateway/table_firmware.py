"""table_firmware: the build of grbl or grblHAL on a simulated table, and its reports of itself."""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.gateway.interpreter import Block, LineRefused
from knifetip.gateway.motion import Limits, Pose


@dataclass(frozen=True, slots=True)
class Firmware:
    """Properties that differ between builds of grblHAL, and between grblHAL and grbl 1.1."""

    axes: str = "XYZC"  #: letters in the order of status reports; one of them is A or C, or none
    outputs: int = 16  #: number of digital outputs (M64, M65)
    grblhal: bool = True  #: grblHAL, which states its axes and outputs; False for grbl 1.1
    sizes: bool = True  #: whether it states the sizes of planner and receive buffer

    @property
    def rotary(self) -> str:
        """Letter of the axis that rotates the tool; empty if there is none."""
        return next((letter for letter in "CA" if letter in self.axes), "")

    def by_axis(self, pose: Pose) -> str:
        """Return the figures of a pose for each axis of the controller; 0 for further axes."""
        figures = dict(zip(f"XYZ{self.rotary or '-'}", pose, strict=True))
        return ",".join(f"{figures.get(axis, 0.0):.3f}" for axis in self.axes)

    def require_axes(self, text: bytes) -> None:
        """Raise ``LineRefused`` for an unknown axis letter."""
        if any(letter in text and letter != self.rotary.encode() for letter in (b"A", b"C")):
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


def settings(limits: Limits, *, beam: bool) -> list[str]:
    """Return the answer to ``$$`` without its ``ok``.

    Parameters
    ----------
    limits
        Limits of the axes.
    beam
        Whether the machine has a laser, so that the controller is in laser mode.
    """
    rows = ["$10=511", "$13=0", "$20=1", "$22=1", f"$32={int(beam)}"]
    for axis in range(4):
        rows.append(f"$11{axis}={limits.velocity[axis] * 60.0:.3f}")
        rows.append(f"$12{axis}={limits.acceleration[axis]:.3f}")
        rows.append(f"$13{axis}={limits.high[axis] - limits.low[axis]:.3f}")
    return rows
