"""A whole LinuxCNC without a table: real planner, joints in the loop, spoken to over TCP.

It needs no real-time kernel, but it refuses root, so root starts it as ``nobody``.  One runs at a
time: LinuxCNC's lock file has a fixed place.
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


def absent() -> str:
    """Why the machine cannot be started here; empty where it can."""
    if not PARTS.is_dir():
        return f"the headless machine's files are not at {PARTS} (set KNIFETIP_LINUXCNC)"
    wanted = ["linuxcnc", "gcc", *(["runuser"] if os.geteuid() == 0 else [])]
    missing = [name for name in wanted if shutil.which(name) is None]
    if missing:
        return f"{' and '.join(missing)} not installed (apt-get install linuxcnc-uspace gcc)"
    if LOCK.exists():
        return f"another LinuxCNC runs on this machine: {LOCK} exists"
    return ""


class Machine:
    """A conversation with a running machine."""

    def __init__(self, port: int, room: Path) -> None:
        self.room = room
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
        self.until(lambda: self.get("joint_homed").split()[:4] == ["YES"] * 4, 20.0)

    def send(self, command: str) -> None:
        self.socket.sendall(f"{command}\r\n".encode())

    def read(self) -> str:
        line = self.lines.readline()
        assert line, "LinuxCNC closed the connection"
        assert not line.strip().endswith("NAK"), line
        return line.strip()

    def get(self, what: str) -> str:
        """The answer to a question, without its name."""
        self.send(f"get {what}")
        while not (line := self.read()).startswith(what.upper()):
            pass
        return line.removeprefix(what.upper()).strip()

    def until(self, reached: Callable[[], bool], seconds: float) -> None:
        end = time.monotonic() + seconds
        while not reached():
            assert time.monotonic() < end, "LinuxCNC did not get there in time"
            time.sleep(0.05)

    def position(self) -> np.ndarray:
        """X Y Z C of the joints."""
        return np.array(self.get("joint_pos").split()[:4], float)

    def run(self, program: bytes, seconds: float = 60.0) -> np.ndarray:
        """Run a program to its end; return the joints' positions on the way, the last one last."""
        path = self.room / "program.ngc"
        path.write_bytes(program)
        path.chmod(0o644)
        for command in ("set mode auto", f"set open {path}", "set run"):
            self.send(command)
        start, moved, seen = time.monotonic(), False, [self.position()]
        # Just after the start the status may still be idle.
        while time.monotonic() < start + seconds:
            running = "IDLE" not in self.get("program_status")
            seen.append(self.position())
            assert (error := self.get("error")) == "OK", error
            moved = moved or running
            if not running and (moved or time.monotonic() > start + 3.0):
                return np.array(seen)
            time.sleep(0.005)
        raise AssertionError(f"the program did not end within {seconds} s")


@contextmanager
def running(tool_table: str) -> Iterator[Machine]:
    """A homed machine with this tool table, stopped at the end."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with tempfile.TemporaryDirectory(prefix="linuxcnc-") as folder:
        room = Path(folder)
        for part in ("carton.hal", "carton.ini", "loopback_bind.c"):
            shutil.copyfile(PARTS / part, room / part)
        ini = (room / "carton.ini").read_text()
        assert "--port 5007" in ini
        ini = ini.replace("--port 5007", f"--port {port}").replace("/path/to/programs", folder)
        (room / "carton.ini").write_text(ini)
        (room / "tool.tbl").write_text(tool_table)
        (room / "sim.var").write_text("")
        shim = room / "loopback_bind.so"
        compiler = ["gcc", "-shared", "-fPIC", "-o", str(shim), str(room / "loopback_bind.c")]
        subprocess.run([*compiler, "-ldl"], check=True, timeout=60)
        command = ["env", f"HOME={folder}", f"LD_PRELOAD={shim}", "linuxcnc", f"{room}/carton.ini"]
        if os.geteuid() == 0:
            for path in (room, *room.iterdir()):
                shutil.chown(path, "nobody")
            command = ["runuser", "-u", "nobody", "--", *command]
        with (room / "log.txt").open("wb") as log:
            process = subprocess.Popen(
                command,
                cwd=room,
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=log,
                start_new_session=True,
            )
        machine = None
        try:
            machine = _connected(process, port, room)
            yield machine
        finally:
            _stop(process, machine, port)


def _connected(process: subprocess.Popen[bytes], port: int, room: Path) -> Machine:
    for _ in range(200):
        assert process.poll() is None, (room / "log.txt").read_text()
        try:
            return Machine(port, room)
        except ConnectionRefusedError:
            time.sleep(0.1)
    raise AssertionError(f"LinuxCNC does not listen: {(room / 'log.txt').read_text()}")


def _stop(process: subprocess.Popen[bytes], machine: Machine | None, port: int) -> None:
    """Ask it to shut down, which it does itself; TERM on its script would do nothing."""
    try:
        if machine is None:
            with socket.create_connection(("127.0.0.1", port), 2.0) as last:
                last.sendall(b"hello EMC x 1.0\r\nset enable EMCTOO\r\nshutdown\r\n")
                time.sleep(1.0)
        else:
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
