"""Run a complete LinuxCNC without hardware: real planner, simulated joints.

It is observed through its HAL pins and switched through ``halui`` only.  The remote shell of
LinuxCNC 2.9 ends or mixes up replies when two clients use it at the same time, so the gateway under
test is its only client.

LinuxCNC needs no real-time kernel.  It refuses to run as root, so root starts it as user
``nobody``.  A computer runs only one: a second one ends the first.  ``running`` therefore waits for
other test runs.
"""

from __future__ import annotations

import fcntl
import os
import pwd
import shutil
import signal
import socket
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from knifetip.geometry.columns import F64
from knifetip.model.machine import Machine as TableMachine
from knifetip.post.rs274.tool_table import tool_table
from tests.controllers import linuxcnc_configuration as configuration

#: Created by LinuxCNC while it runs.
LOCK = Path("/tmp/linuxcnc.lock")
#: In the log of a LinuxCNC that finds components of another one.
_DUPLICATE = "duplicate component name"
#: Locked by the test run that uses LinuxCNC.
_TURN = Path(tempfile.gettempdir()) / "knifetip-test-linuxcnc"
_SHELL = "linuxcncrsh"
#: Its processes that may outlive a killed test run.
_REMAINS = ("halsampler", "rtapi_app", _SHELL)
_SHARED_MEMORY = Path("/proc/sysvipc/shm")
#: Keys of the shared memories that a killed run leaves: HAL's sampler, HAL, RTAPI and motion.
_KEYS = (0x48534130, 0x48414C32, 0x48484C34, 100)
_JOINTS = len(configuration.JOINTS)


def missing_requirement() -> str:
    """Return why LinuxCNC cannot be started here, "" if it can."""
    required = ("linuxcnc", "halcmd", "halsampler", "gcc")
    missing = [name for name in required if shutil.which(name) is None]
    if missing:
        return f"{' and '.join(missing)} not installed (apt-get install linuxcnc-uspace gcc)"
    return ""


class Machine:
    """A running LinuxCNC, observed through its HAL pins.

    Parameters
    ----------
    process
        The script that runs LinuxCNC.
    port
        Port of the remote shell.
    directory
        Folder with the configuration, the log and the samples.
    """

    def __init__(self, process: subprocess.Popen[bytes], port: int, directory: Path) -> None:
        self.process = process
        self.port = port
        self.directory = directory
        self.killed = False  #: a test has ended it

    @property
    def address(self) -> str:
        """HOST:PORT of the remote shell."""
        return f"127.0.0.1:{self.port}"

    @property
    def log(self) -> str:
        """What LinuxCNC and its parts have written."""
        return (self.directory / "log.txt").read_text(errors="replace")

    @property
    def runs(self) -> bool:
        """Whether LinuxCNC runs and its remote shell listens."""
        return self.process.poll() is None and _listens(self.port)

    # -- operation --------------------------------------------------------------------------------

    def make_ready(self) -> None:
        """Discard a program, release the emergency stop, switch on and home, like a person."""
        self.release_emergency_stop()
        self.override_feed(100)
        if not self._is("halui.program.is-idle"):
            self._request("halui.abort", lambda: self._is("halui.program.is-idle"))
        if not self._is("halui.machine.is-on"):
            self._request("halui.estop.reset", lambda: not self._is("halui.estop.is-activated"))
            self._request("halui.machine.on", lambda: self._is("halui.machine.is-on"))
        if not self._homed():
            self._request("halui.mode.manual", lambda: self._is("halui.mode.is-manual"))
            self._request("halui.home-all", self._homed)

    def wait_for_idle(self) -> None:
        """Wait until no program runs."""
        wait_until(lambda: self._is("halui.program.is-idle"), 60.0)

    def abort(self) -> None:
        """Stop the program, like a person at the machine."""
        self._request("halui.abort", lambda: self._is("halui.program.is-idle"))

    def override_feed(self, percent: int) -> None:
        """Move at a percentage of the programmed feeds."""
        pin = "halui.feed-override"
        for name, value in (("direct-value", 1), ("scale", 0.01), ("counts", percent)):
            self._halcmd("setp", f"{pin}.{name}", str(value))
        wait_until(lambda: float(self.pins(pin)[f"{pin}.value"]) == percent / 100.0)

    def press_emergency_stop(self) -> None:
        """Press the emergency stop button of the machine."""
        self._halcmd("setp", "emergency-stop.in1", "0")

    def release_emergency_stop(self) -> None:
        """Release the emergency stop button; LinuxCNC remains in emergency stop."""
        self._halcmd("setp", "emergency-stop.in1", "1")

    def kill_shell(self) -> None:
        """End the remote shell, as a fault in it does; LinuxCNC then ends, too."""
        self.killed = True
        self._signal_shell(signal.SIGSEGV)

    def stop_shell(self) -> None:
        """Let the remote shell hang until ``continue_shell``; the machine goes on."""
        self._signal_shell(signal.SIGSTOP)

    def continue_shell(self) -> None:
        """Let the remote shell continue."""
        self._signal_shell(signal.SIGCONT)

    def _signal_shell(self, signal_number: signal.Signals) -> None:
        (shell,) = _processes(self.process.pid, _SHELL)
        os.kill(shell, signal_number)

    def _request(self, pin: str, done: Callable[[], bool]) -> None:
        """Press a button of ``halui`` until it has an effect: LinuxCNC drops some commands."""
        for _ in range(3):
            self._halcmd("setp", pin, "1")
            try:
                wait_until(done, 7.0)
            except AssertionError:
                continue
            else:
                return
            finally:
                # Only a change to 1 counts as pressed.
                self._halcmd("setp", pin, "0")
                time.sleep(0.1)
        wait_until(done, 0.0, f"{pin} has no effect")

    def _is(self, pin: str) -> bool:
        return self.pins(pin)[pin] == "TRUE"

    def _homed(self) -> bool:
        pins = self.pins("halui.joint")
        return all(pins[f"halui.joint.{joint}.is-homed"] == "TRUE" for joint in range(_JOINTS))

    # -- observation ------------------------------------------------------------------------------

    def position(self) -> F64:
        """Return X, Y, Z and C of the joints, (4,)."""
        pins = self.pins("joint")
        return np.array([float(pins[f"joint.{n}.pos-fb"]) for n in range(_JOINTS)])

    def lowered(self) -> list[int]:
        """Return the digital outputs that are on."""
        values = self.pins("motion.digital-out")
        return sorted(int(name[-2:]) for name, value in values.items() if value == "TRUE")

    def spins(self) -> bool:
        """Return whether the spindle is on."""
        return self._is("spindle.0.on")

    def pins(self, prefix: str) -> dict[str, str]:
        """Return the values of the HAL pins whose names begin with a text, by name."""
        # Owner, type, direction, value, name, and the signal if there is one.
        rows = [line.split() for line in self._halcmd("-s", "show", "pin", prefix).splitlines()]
        return {row[4]: row[3] for row in rows if row}

    def is_still(self, milliseconds: int = 300) -> bool:
        """Watch the joints for a time; return whether none of them moves."""
        mark = self.mark()
        wait_until(lambda: len(self.samples(mark)) >= milliseconds)
        return bool((np.ptp(self.samples(mark)[:, :_JOINTS], axis=0) == 0.0).all())

    def comes_to_rest(self, seconds: float = 2.0) -> bool:
        """Return whether the joints are still within a time.

        The sampler writes late on a busy computer: the first samples may be those of a motion that
        has ended.
        """
        end = time.monotonic() + seconds
        while not self.is_still():
            if time.monotonic() > end:
                return False
        return True

    def mark(self) -> int:
        """Return the present end of the samples, for ``samples``."""
        return (self.directory / "samples.txt").stat().st_size

    def samples(self, since: int = 0) -> F64:
        """Return the samples of all servo periods since a mark.

        Returns
        -------
        numpy.ndarray
            Joints X, Y, Z, C (mm, degrees), then 0 or 1 for each digital output, the spindle and
            the valve of each output, shape (samples, columns).
        """
        # A mark may lie within a line.
        with (self.directory / "samples.txt").open("rb") as file:
            file.seek(since)
            lines = file.read().split(b"\n")[1:-1]
        assert b"overrun" not in lines, "halsampler has lost samples"
        return np.array([line.split() for line in lines], dtype=np.float64)

    def _halcmd(self, *words: str) -> str:
        output: bytes = subprocess.check_output(["halcmd", *words], **_as_user(), timeout=10.0)
        return output.decode()


def wait_until(
    condition: Callable[[], bool], seconds: float = 20.0, what: str = "the machine is not ready"
) -> None:
    """Wait until a condition is true; fail with ``what`` if it is not in time."""
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, f"{what} after {seconds} s"
        time.sleep(0.02)


# -- starting and stopping ------------------------------------------------------------------------


@contextmanager
def reserved() -> Iterator[None]:
    """Wait until no other test run uses LinuxCNC on this computer, and reserve it."""
    descriptor = os.open(_TURN, os.O_RDWR | os.O_CREAT, 0o666)
    try:
        wait_until(lambda: _locked(descriptor), 240.0, "another test run uses LinuxCNC")
        # That of the last test run may need a moment to end.
        others = partial(_processes, None, "milltask")
        wait_until(lambda: not others(), 10.0, "another LinuxCNC runs on this computer")
        _remove_leftovers()
        yield
    finally:
        os.close(descriptor)


def _locked(descriptor: int) -> bool:
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    return True


def _remove_leftovers() -> None:
    """Remove what a killed test run has left of its LinuxCNC: lock, sampler and shared memory.

    LinuxCNC cannot create a shared memory again with another size, as a table with other pins needs
    it, and a left ``halsampler`` keeps it.
    """
    LOCK.unlink(missing_ok=True)
    for name in _REMAINS:
        for process in _processes(None, name):
            with suppress(ProcessLookupError):
                os.kill(process, signal.SIGKILL)
    wait_until(lambda: not any(_processes(None, name) for name in _REMAINS), 10.0)
    # Key and identity of each shared memory of this computer.
    rows = [line.split()[:2] for line in _SHARED_MEMORY.read_text().splitlines()[1:]]
    for key, identity in rows:
        if int(key) & 0xFFFFFFFF in _KEYS:
            subprocess.run(["ipcrm", "-m", identity], check=False, timeout=10)


@contextmanager
def running(table: TableMachine) -> Iterator[Machine]:
    """Run a LinuxCNC for a machine of the library; it is in emergency stop at first."""
    with reserved(), started(table) as machine:
        yield machine


class Supply:
    """Gives tests a running LinuxCNC; starts a new one if the last one has ended.

    Parameters
    ----------
    table
        Machine of the library.
    """

    def __init__(self, table: TableMachine) -> None:
        self._table = table
        self._reservation = ExitStack()
        self._stack = ExitStack()
        self._machine: Machine | None = None

    def __enter__(self) -> Supply:
        self._reservation.enter_context(reserved())
        return self

    def __exit__(self, *_: object) -> None:
        self._stack.close()
        self._reservation.close()

    @contextmanager
    def machine(self) -> Iterator[Machine]:
        """Yield a LinuxCNC that is on, homed and idle; fail if it ends by itself meanwhile."""
        machine = self._ready_machine()
        try:
            yield machine
        finally:
            print(machine.log)  # pytest shows it if the test fails
        assert machine.runs or machine.killed, "LinuxCNC has ended"

    def _ready_machine(self) -> Machine:
        """Return the last LinuxCNC, or a new one if that has ended or does not become ready.

        A test may leave LinuxCNC in a state that no command ends; the next test is not about that.
        """
        if self._machine is not None and self._machine.runs:
            try:
                self._machine.make_ready()
            except (AssertionError, subprocess.SubprocessError) as reason:
                print(f"another LinuxCNC is started: {reason}", self._machine.log)
            else:
                return self._machine
        self._stack.close()
        self._machine = self._stack.enter_context(started(self._table))
        self._machine.make_ready()
        return self._machine


@contextmanager
def started(table: TableMachine) -> Iterator[Machine]:
    """Run a LinuxCNC as ``running`` does, on a computer that is reserved already."""
    with tempfile.TemporaryDirectory(prefix="linuxcnc-") as folder:
        directory = Path(folder)
        machine = _start(table, directory)
        sampler = None
        try:
            _wait_for_start(machine)
            if not machine.runs and _DUPLICATE in machine.log:
                # A LinuxCNC that was just ending has left its components in the memory.
                _stop(machine)
                _remove_leftovers()
                machine = _start(table, directory)
                _wait_for_start(machine)
            assert machine.runs, machine.log
            with (directory / "samples.txt").open("wb") as samples:
                sampler = subprocess.Popen(["halsampler"], **_as_user(), stdout=samples)
            yield machine
        finally:
            if sampler is not None:
                sampler.terminate()
                sampler.wait(10.0)
            _stop(machine)


def _wait_for_start(machine: Machine) -> None:
    wait_until(lambda: machine.runs or machine.process.poll() is not None, 30.0)


def _start(table: TableMachine, directory: Path) -> Machine:
    port = _free_port()
    (directory / "machine.ini").write_text(configuration.ini(table, port, str(directory)))
    (directory / "machine.hal").write_text(configuration.hal(table))
    (directory / "tool.tbl").write_text(tool_table(table))
    (directory / "parameters.var").touch()
    shim = directory / "loopback_bind.so"
    source = Path(__file__).with_name("loopback_bind.c")
    compiler = ["gcc", "-shared", "-fPIC", "-o", str(shim), str(source), "-ldl"]
    subprocess.run(compiler, check=True, timeout=60)
    user = _as_user()
    if user:
        for path in (directory, *directory.iterdir()):
            shutil.chown(path, user["user"], user["group"])
    # Without a display and a terminal LinuxCNC asks nothing.
    environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    environment |= {"HOME": str(directory), "LD_PRELOAD": str(shim)}
    with (directory / "log.txt").open("wb") as log:
        process = subprocess.Popen(
            # Option -r: it writes to its terminal, also if that is a file.
            ["linuxcnc", "-r", str(directory / "machine.ini")],
            **user,
            cwd=directory,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=log,
            start_new_session=True,
        )
    return Machine(process, port, directory)


def _stop(machine: Machine) -> None:
    """Shut LinuxCNC down by ending its display; kill it if that does not end it."""
    process = machine.process
    for shell in _processes(process.pid, _SHELL):
        with suppress(ProcessLookupError):
            os.kill(shell, signal.SIGTERM)
    try:
        process.wait(30.0)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait(10.0)
        LOCK.unlink(missing_ok=True)


def _as_user() -> dict[str, Any]:
    """Return options of ``subprocess`` for the user who runs LinuxCNC."""
    if os.geteuid() != 0:
        return {}
    nobody = pwd.getpwnam("nobody")
    return {"user": nobody.pw_uid, "group": nobody.pw_gid, "extra_groups": []}


def _free_port() -> int:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port: int = free.getsockname()[1]
    return port


def _listens(port: int) -> bool:
    """Return whether a process listens at a port of this computer, without connecting to it."""
    rows = [line.split() for line in Path("/proc/net/tcp").read_text().splitlines()[1:]]
    return any(row[3] == "0A" and row[1].endswith(f":{port:04X}") for row in rows)


def _processes(session: int | None, name: str) -> list[int]:
    """Return the processes with a name in a session; None for all sessions."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with suppress(FileNotFoundError, ProcessLookupError):
            identity, _, rest = stat.read_text().partition(" (")
            command, _, fields = rest.rpartition(") ")
            state, _, _, its_session = fields.split()[:4]
            if command == name and state != "Z" and session in (None, int(its_session)):
                found.append(int(identity))
    return found
