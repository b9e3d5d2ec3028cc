"""An interpreter of HPGL as a flat cutter executes it; it shares no code with the verifier."""

from __future__ import annotations

import math
import re
from itertools import pairwise

import numpy as np

from knifetip.languages.hpgl.plotter import CM_PER_SECOND, Pen, Plotter
from knifetip.model.machine import Machine
from tests.attack.controller import NotExecuted
from tests.attack.effects import Contact, Effect

_NUMBERS = r"[+-]?\d+(?:[ ]*[, ][ ]*[+-]?\d+)*"
_INSTRUCTION = re.compile(
    rf'\s*(?:CO\s*"[^"\n]*"|([A-Z]{{2}})[ ]*((?:{_NUMBERS})?))[ ]*(;|\n|\r|(?=[A-Z])|$)'
)


def plot(text: bytes, machine: Machine) -> Effect:
    """Return what a program does to the board on a flat cutter.

    Raises
    ------
    NotExecuted
        An instruction is wrong, or is not supported.
    """
    plotter = machine.controller
    assert isinstance(plotter, Plotter)
    program = text.decode("latin-1")
    result, pens = Effect(), {pen.number: pen for pen in plotter.pens}
    started, absolute, down = False, False, False
    pen, speed, force, at, track = 0, -1, -1, (math.nan, math.nan), 0
    place = 0
    path: list[tuple[float, float]] = []

    def finish(line: int) -> None:
        if len(path) > 1:
            _add_track(result, line, pen, track, path)
        path.clear()

    while place < len(program) and program[place:].strip(" ;\r\n"):
        found = _INSTRUCTION.match(program, place)
        if not found or found.end() == place:
            if program[place] in ";\n\r ":
                place += 1
                continue
            raise NotExecuted(f"cannot read {program[place : place + 10]!r}")
        line = program.count("\n", 0, found.start(1) if found[1] else place) + 1
        place = found.end()
        if not found[1]:
            continue
        name, numbers = found[1], [int(n) for n in re.findall(r"[+-]?\d+", found[2] or "")]
        if name == "IN":
            if started:
                raise NotExecuted(f"line {line}: IN again")
            started, absolute, pen, speed, force = True, True, 0, -1, -1
        elif name in ("PU", "PD", "PA"):
            if not started or not absolute or len(numbers) % 2:
                raise NotExecuted(f"line {line}: {name} {numbers}")
            if name == "PD" and not down:
                track += 1
                path[:] = [at]
                fault = _lowering_danger(pens.get(pen), speed, force, at, machine)
                result.dangers += [f"line {line}: {fault}"] if fault else []
            if name == "PU" and down:
                finish(line)
            down = down if name == "PA" else name == "PD"
            for x, y in zip(numbers[::2], numbers[1::2], strict=True):
                at = (
                    x / plotter.device.units + plotter.device.zero[0],
                    y / plotter.device.units + plotter.device.zero[1],
                )
                if down:
                    path.append(at)
        elif name in ("SP", "VS", "FS") and len(numbers) == 1:
            if down:
                result.dangers.append(f"line {line}: {name} while a tool is down")
            if name == "SP":
                pen, force = numbers[0], -1
                if pen and pen not in pens:
                    raise NotExecuted(f"line {line}: pen {pen}")
            elif name == "VS":
                speed = numbers[0]
            else:
                force = numbers[0]
        else:
            raise NotExecuted(f"line {line}: {name} {numbers}")
    if down or pen:
        result.dangers.append("ends with a tool down or selected")
    return result


def _lowering_danger(
    pen: Pen | None, speed: int, force: int, at: tuple[float, float], machine: Machine
) -> str:
    if pen is None:
        return "lowers no tool"
    if force != pen.force:
        return f"force {force}"
    if speed * CM_PER_SECOND != machine.station(pen.station).tool.feed:
        return f"speed {speed}"
    return "lowers a tool at an unknown place" if math.isnan(at[0]) else ""


def _add_track(
    result: Effect, line: int, pen: int, track: int, path: list[tuple[float, float]]
) -> None:
    for one, other in pairwise(path):
        if one == other:
            continue
        # The device turns the tool along its path.
        points = np.array([[*one, 0.0, 0.0, 0.0], [*other, 0.0, 0.0, 0.0]])
        result.contacts.append(Contact(line, pen, track, points))
