"""Run a complete LinuxCNC without hardware: real planner, simulated joints, commands over TCP.

It needs no real-time kernel.  It refuses to run as root, so root starts it as user ``nobody``.
Only one can run at a time, because LinuxCNC's lock file has a fixed path.
"""

from __future__ import annotations

import os
import shutil
import signal
import socket
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
PARTS = Path(os.environ.get("KNIFETIP_LINUXCNC", ROOT.parent / "shared" / "linuxcnc"))
LOCK = Path(tempfile.gettempdir()) / "linuxcnc.lock"


def missing_requirement() -> str:
    """Return why LinuxCNC cannot be started here, "" if it can."""
    if not PARTS.is_dir():
        return f"the headless machine's files are not at {PARTS} (set KNIFETIP_LINUXCNC)"
    required = ["linuxcnc", "gcc", *(["runuser"] if os.geteuid() == 0 else [])]
    missing = [name for name in required if shutil.which(name) is None]
    if missing:
        return f"{' and '.join(missing)} not installed (apt-get install linuxcnc-uspace gcc)"
    if LOCK.exists():
        return f"another LinuxCNC runs on this machine: {LOCK} exists"
    return ""


class Machine:
    """A TCP connection to a running LinuxCNC; opening it switches LinuxCNC on and homes its
    axes.
    """

    def __init__(self, port: int, directory: Path) -> None:
        self.directory = directory
        self.socket = socket.create_connection(("127.0.0.1", port), 5.0)
        self.lines = self.socket.makefile("r", newline="\n")
        self.send("hello EMC x 1.0")
        while not self.read().startswith("HELLO ACK"):
            pass
        for command in ("set echo off", "set enable EMCTOO", "set estop off", "set machine on"):
            self.send(command)
        self.send("set mode manual")
        for joint in range(4):
            if self.get("joint_homed").split()[joint] != "YES":
                self.send(f"set home {joint}")
        self.wait_until(lambda: self.get("joint_homed").split()[:4] == ["YES"] * 4, 20.0)

    def send(self, command: str) -> None:
        self.socket.sendall(f"{command}\r\n".encode())

    def read(self) -> str:
        line = self.lines.readline()
        assert line, "LinuxCNC closed the connection"
        assert not line.strip().endswith("NAK"), line
        return line.strip()

    def get(self, variable: str) -> str:
        """Return the value of a variable that LinuxCNC's remote shell (linuxcncrsh) can report."""
        self.send(f"get {variable}")
        while not (line := self.read()).startswith(variable.upper()):
            pass
        return line.removeprefix(variable.upper()).strip()

    def wait_until(self, condition: Callable[[], bool], seconds: float) -> None:
        end = time.monotonic() + seconds
        while not condition():
            assert time.monotonic() < end, "LinuxCNC did not get there in time"
            time.sleep(0.05)

    def position(self) -> np.ndarray:
        """Return X, Y, Z and C of the joints, (4,)."""
        return np.array(self.get("joint_pos").split()[:4], float)

    @property
    def address(self) -> str:
        """HOST:PORT of the remote shell."""
        host, port = self.socket.getpeername()
        return f"{host}:{port}"

    def pins(self, prefix: str) -> dict[str, str]:
        """Return the values of the HAL pins whose names begin with a text, by name."""
        command = ["halcmd", "-s", "show", "pin", prefix]
        if os.geteuid() == 0:
            command = ["runuser", "-u", "nobody", "--", *command]
        lines = subprocess.check_output(command, text=True, timeout=10).splitlines()
        # Owner, type, direction, value, name, and the signal if there is one.
        rows = [line.split() for line in lines if line.strip()]
        return {row[4]: row[3] for row in rows}

    def lowered(self) -> list[int]:
        """Return the digital outputs that are on."""
        values = self.pins("motion.digital-out")
        return sorted(int(name[-2:]) for name, value in values.items() if value == "TRUE")

    def spins(self) -> bool:
        """Return whether the spindle is on."""
        return self.pins("spindle.0.on")["spindle.0.on"] == "TRUE"

    def run(self, program: bytes, seconds: float = 60.0) -> np.ndarray:
        """Run a program to its end; return the sampled positions of the joints, (n, 4)."""
        path = self.directory / "program.ngc"
        path.write_bytes(program)
        path.chmod(0o644)
        for command in ("set mode auto", f"set open {path}", "set run"):
            self.send(command)
        start, started, positions = time.monotonic(), False, [self.position()]
        # Immediately after the start the status may still be idle.
        while time.monotonic() < start + seconds:
            running = "IDLE" not in self.get("program_status")
            positions.append(self.position())
            assert (error := self.get("error")) == "OK", error
            started = started or running
            if not running and (started or time.monotonic() > start + 3.0):
                return np.array(positions)
            time.sleep(0.005)
        raise AssertionError(f"the program did not end within {seconds} s")


@contextmanager
def running(tool_table: str) -> Iterator[Machine]:
    """Start LinuxCNC with the text of a tool table, home it and yield it; stop it at the end."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with tempfile.TemporaryDirectory(prefix="linuxcnc-") as folder:
        directory = Path(folder)
        for part in ("carton.hal", "carton.ini", "loopback_bind.c"):
            shutil.copyfile(PARTS / part, directory / part)
        ini = (directory / "carton.ini").read_text()
        assert "--port 5007" in ini
        ini = ini.replace("--port 5007", f"--port {port}").replace("/path/to/programs", folder)
        (directory / "carton.ini").write_text(ini)
        (directory / "tool.tbl").write_text(tool_table)
        (directory / "sim.var").write_text("")
        shim = directory / "loopback_bind.so"
        compiler = ["gcc", "-shared", "-fPIC", "-o", str(shim), str(directory / "loopback_bind.c")]
        subprocess.run([*compiler, "-ldl"], check=True, timeout=60)
        command = [
            "env",
            f"HOME={folder}",
            f"LD_PRELOAD={shim}",
            "linuxcnc",
            f"{directory}/carton.ini",
        ]
        if os.geteuid() == 0:
            for path in (directory, *directory.iterdir()):
                shutil.chown(path, "nobody")
            command = ["runuser", "-u", "nobody", "--", *command]
        with (directory / "log.txt").open("wb") as log:
            process = subprocess.Popen(
                command,
                cwd=directory,
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=log,
                start_new_session=True,
            )
        machine = None
        try:
            machine = _connect(process, port, directory)
            yield machine
        finally:
            _stop(process, machine, port)


def _connect(process: subprocess.Popen[bytes], port: int, directory: Path) -> Machine:
    for _ in range(200):
        assert process.poll() is None, (directory / "log.txt").read_text()
        try:
            return Machine(port, directory)
        except ConnectionRefusedError:
            time.sleep(0.1)
    raise AssertionError(f"LinuxCNC does not listen: {(directory / 'log.txt').read_text()}")


def _stop(process: subprocess.Popen[bytes], machine: Machine | None, port: int) -> None:
    """Shut LinuxCNC down by a TCP command, because its script ignores SIGTERM; kill it if it hangs.

    ``machine`` is None if the connection to ``port`` was never opened.
    """
    try:
        if machine is None:
            with socket.create_connection(("127.0.0.1", port), 2.0) as last:
                last.sendall(b"hello EMC x 1.0\r\nset enable EMCTOO\r\nshutdown\r\n")
                time.sleep(1.0)
        else:
            # A gateway may have taken the permission to send commands.
            machine.send("set enable EMCTOO")
            machine.send("shutdown")
    except OSError:
        pass
    try:
        process.wait(30.0)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait(10.0)
        LOCK.unlink(missing_ok=True)
    finally:
        if machine is not None:
            machine.lines.close()
            machine.socket.close()
