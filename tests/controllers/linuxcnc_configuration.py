"""The configuration of a LinuxCNC without hardware for a machine of the library.

Its joints follow their commands at once.  ``emergency-stop.in1`` is the emergency stop button: 1 is
released.  ``valve-N.out`` is what the valve of station output N gets: off while the machine is off,
and then until the program has switched the output off, as docs/howto/connect-linuxcnc.md advises.
``sampler`` records the joints, the digital outputs, the spindle and the valves in every servo
period.
"""

from __future__ import annotations

from collections.abc import Iterable

from knifetip.model.machine import Machine

#: Servo period, which is also the time between two samples (ns).
SERVO_PERIOD = 1_000_000
#: Joints in the order of their numbers.
JOINTS = "XYZC"
#: Samples that are kept until ``halsampler`` reads them.
_KEPT = 16_000


def ini(machine: Machine, port: int, folder: str) -> str:
    """Return the INI file: LinuxCNC in a folder, with its remote shell at a port as the display.

    The travel of a joint is that of the axis, widened by the datums of the stations.
    """
    sections = [
        ("EMC", ["MACHINE = knifetip-test", "VERSION = 1.1", "DEBUG = 0"]),
        ("DISPLAY", [f"DISPLAY = linuxcncrsh --port {port}", f"PROGRAM_PREFIX = {folder}"]),
        ("TASK", ["TASK = milltask", "CYCLE_TIME = 0.001"]),
        ("RS274NGC", ["PARAMETER_FILE = parameters.var"]),
        ("EMCMOT", ["EMCMOT = motmod", f"SERVO_PERIOD = {SERVO_PERIOD}", "COMM_TIMEOUT = 10.0"]),
        ("EMCIO", ["EMCIO = io", "CYCLE_TIME = 0.02", "TOOL_TABLE = tool.tbl"]),
        ("HAL", ["HALFILE = machine.hal", "HALUI = halui"]),
        ("KINS", [f"KINEMATICS = trivkins coordinates={JOINTS}", f"JOINTS = {len(JOINTS)}"]),
        (
            "TRAJ",
            [
                f"COORDINATES = {' '.join(JOINTS)}",
                "SPINDLES = 1",
                "LINEAR_UNITS = mm",
                "ANGULAR_UNITS = degree",
                "MAX_LINEAR_VELOCITY = 2000",
                "MAX_LINEAR_ACCELERATION = 10000",
            ],
        ),
        *_axes(machine),
    ]
    return "\n".join(f"[{name}]\n" + "\n".join(lines) + "\n" for name, lines in sections)


def _axes(machine: Machine) -> Iterable[tuple[str, list[str]]]:
    axes = (machine.x, machine.y, machine.z, machine.c)
    datums = [(station.x, station.y, station.z, 0.0) for station in machine.stations]
    for number, (letter, axis) in enumerate(zip(JOINTS, axes, strict=True)):
        offsets = [0.0, *(datum[number] for datum in datums)]
        limits = [
            f"MAX_VELOCITY = {axis.velocity}",
            f"MAX_ACCELERATION = {axis.acceleration}",
            f"MIN_LIMIT = {axis.low + min(offsets)}",
            f"MAX_LIMIT = {axis.high + max(offsets)}",
        ]
        kind = "ANGULAR" if letter == "C" else "LINEAR"
        # An absolute encoder (2: without a final move), so homing changes no position.
        homing = ["HOME = 0", "HOME_ABSOLUTE_ENCODER = 2", "HOME_SEQUENCE = 0"]
        homing += ["FERROR = 50", "MIN_FERROR = 50"]
        yield f"AXIS_{letter}", limits
        yield f"JOINT_{number}", [f"TYPE = {kind}", *limits, *homing]


def hal(machine: Machine) -> str:
    """Return the HAL file."""
    outputs = range(max(machine.outputs) + 1)
    recorded = "f" * len(JOINTS) + "b" * len(outputs) + "b" + "b" * len(outputs)
    lines = [
        f"loadrt trivkins coordinates={JOINTS}",
        f"loadrt motmod servo_period_nsec={SERVO_PERIOD} num_joints={len(JOINTS)}"
        f" num_dio={len(outputs)} num_spindles=1",
        f"loadrt sampler depth={_KEPT} cfg={recorded}",
        f"loadrt and2 names=emergency-stop,{','.join(f'valve-{n}' for n in outputs)}",
        f"loadrt lut5 names={','.join(f'allow-{n}' for n in outputs)}",
        "addf motion-command-handler servo-thread",
        "addf motion-controller servo-thread",
        "addf emergency-stop servo-thread",
        "net may-run iocontrol.0.user-enable-out => emergency-stop.in0",
        "net enabled emergency-stop.out => iocontrol.0.emc-enable-in",
        "setp emergency-stop.in1 1",
        "net tool-prepare iocontrol.0.tool-prepare => iocontrol.0.tool-prepared",
        "net tool-change iocontrol.0.tool-change => iocontrol.0.tool-changed",
    ]
    for number in range(len(JOINTS)):
        motor = f"joint.{number}.motor-pos"
        lines.append(f"net motor-{number} {motor}-cmd => {motor}-fb")
        lines.append(f"net joint-{number} joint.{number}.pos-fb => sampler.0.pin.{number}")
    spindle = len(JOINTS) + len(outputs)
    lines.append(f"net spindle spindle.0.on => spindle.0.at-speed sampler.0.pin.{spindle}")
    for number in outputs:
        output, valve = len(JOINTS) + number, spindle + 1 + number
        lines += [
            f"net output-{number} motion.digital-out-{number:02} => sampler.0.pin.{output}",
            *valve_lines(number),
            f"net valve-{number} => sampler.0.pin.{valve}",
        ]
    lines.append("addf sampler.0 servo-thread")
    return "\n".join(lines) + "\n"


def valve_lines(number: int) -> list[str]:
    """Return the lines of the HAL file between the signal of an output and that of its valve."""
    return [
        f"setp allow-{number}.function 0xA2",
        f"net machine-on motion.motion-enabled => allow-{number}.in-0",
        f"net output-{number} => allow-{number}.in-1 valve-{number}.in0",
        f"net allow-{number} allow-{number}.out => allow-{number}.in-2 valve-{number}.in1",
        f"net valve-{number} valve-{number}.out",
        f"addf allow-{number} servo-thread",
        f"addf valve-{number} servo-thread",
    ]
