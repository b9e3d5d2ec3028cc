"""controller: messages about the controller of a machine and the connection to it."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "controller.alarm": entry(
        "{name} stopped with ALARM:{code}: {alarm}. {due}",
        "Check the table and home the machine ($H) before the next job.",
        name="text",
        code="count",
        alarm="message",
        due="message?",
    ),
    "controller.alarm-code": entry("ALARM:{code} ({alarm})", code="count", alarm="message"),
    "controller.alarm-of-unknown-cause": entry(
        "{name} is locked by an alarm whose code was not received.",
        "Check the table, then home the machine. If it has no limit switches, unlock it.",
        name="text",
    ),
    "controller.alarm-state": entry(
        "{name} has stopped and reports an alarm. {due}",
        "Check the table, then home the machine ($H) or unlock it ($X).",
        name="text",
        due="message",
    ),
    "controller.alarm-unknown": entry(
        "an unknown alarm",
    ),
    "controller.answer-lost": entry(
        "{name} has been in the state {state} for {seconds:g} s. This means that a response of "
        "the controller was lost. {due}",
        "Check the cable to the controller, then check the board on the table.",
        name="text",
        state="text",
        seconds="number",
        due="message?",
    ),
    "controller.answer-missing": entry(
        "The receive buffer of {name} contains fewer bytes than were sent. This means that a "
        "response of the controller was lost, or bytes on their way to it. {due}",
        "Check the cable to the controller, then check the board on the table.",
        name="text",
        due="message?",
    ),
    "controller.bad-address": entry(
        "{address!r} is not the address of a controller.",
        "Write the address as HOST:PORT, for example 127.0.0.1:2323, or as a URL. Known schemes: "
        "{schemes:, }.",
        address="text",
        schemes="texts",
    ),
    "controller.bad-host": entry(
        "The address {address!r} of the controller cannot be right: {host!r} is neither an IP "
        "address nor the name of a host.",
        "Write the address as HOST:PORT, for example 127.0.0.1:2323.",
        address="text",
        host="text",
    ),
    "controller.bad-serial-address": entry(
        "{address!r} is not the address of a serial port.",
        "Write it as serial:///dev/ttyUSB0 or serial://COM3; ?baud=250000 at its end sets another "
        "speed than 115200 bits per second, &flow=rtscts or &flow=xonxoff the flow control.",
        address="text",
    ),
    "controller.busy": entry(
        "{name} is busy: it reports the state {state}. Nothing was sent.",
        "Wait until the controller is idle, or reset it at the table.",
        name="text",
        state="text",
    ),
    "controller.check-end-not-confirmed": entry(
        "{name} did not confirm within {seconds:g} s that its check mode ($C), in which "
        "nothing moves, has ended.",
        "Check the table, then try again.",
        name="text",
        seconds="number",
    ),
    "controller.closed": entry(
        "The connection to {name} was closed.",
        "Connect to the controller again.",
        name="text",
    ),
    "controller.connection-failed": entry(
        "The connection to {address} is lost ({reason}).",
        "Check the table before you send anything again.",
        address="text",
        reason="text",
    ),
    "controller.due": entry(
        "No response to program line {line} ({text}) was received.",
        line="count",
        text="text",
    ),
    "controller.in-alarm": entry(
        "{name} is locked by alarm {code}: {alarm}.",
        "{alarm:hint}",
        name="text",
        code="count",
        alarm="message",
    ),
    "controller.lift-not-finished": entry(
        "{name} did not finish lifting the tool within {seconds:g} s.",
        "Lift the tool and raise the stations at the table.",
        name="text",
        seconds="number",
    ),
    "controller.line-changed": entry(
        "{name} received {received!r} instead of program line {line} ({sent}).",
        "Check the cable to the controller. Check the board on the table, which may be spoiled.",
        name="text",
        received="text",
        line="count",
        sent="text",
    ),
    "controller.locked": entry(
        "{name} is locked by {cause}. The stations may still be lowered.",
        "Lift the tool and raise the stations at the table, then home the machine ($H) or "
        "unlock it ($X).",
        name="text",
        cause="message",
    ),
    "controller.locked-by-alarm": entry(
        "{name} is locked by an alarm.",
        "Home the machine ($H) or unlock it ($X) at the table.",
        name="text",
    ),
    "controller.left-program": entry(
        "{name} no longer executes the program: its state is {state}.",
        "Check the table. Another program or a person may have operated the machine.",
        name="text",
        state="text",
    ),
    "controller.lost": entry(
        "The connection to {name} is lost. {due}",
        "Check the cable to the controller, then check the board on the table.",
        name="text",
        due="message?",
    ),
    "controller.lost-in-buffer": entry(
        "The connection to {name} is lost. The controller may still execute the program lines "
        "in its buffer.",
        "Keep clear of the table until the machine has stopped, then check the table.",
        name="text",
    ),
    "controller.no-host-and-port": entry(
        "The address {address!r} of the controller has no host or no port.",
        "Write the address as HOST:PORT, for example 127.0.0.1:2323.",
        address="text",
    ),
    "controller.not-ready": entry(
        "{name} is not ready: it reports the state {state}. Nothing was sent.",
        "Wait until the controller is idle, or unlock it, then send the job again.",
        name="text",
        state="text",
    ),
    "controller.door-open": entry(
        "{name} did not lift the tool and did not raise the stations, because its safety door is "
        "open.",
        "Close the safety door, press Release, then lift the tool.",
        name="text",
    ),
    "controller.not-recovered": entry(
        "{name} did not reach its safe state, with the tool lifted and the stations raised.",
        "Lift the tool and raise the stations at the table.",
        name="text",
    ),
    "controller.not-secured": entry(
        "{name} cannot be brought into its safe state, with the tool lifted and the stations "
        "raised, because it reports the state {state}.",
        "Lift the tool and raise the stations at the table.",
        name="text",
        state="text",
    ),
    "controller.not-stopped": entry(
        "{error} {progress} The machine is not in a safe state: {unsafe}",
        "{unsafe:hint}",
        error="message",
        progress="message",
        unsafe="message",
    ),
    "controller.off-heading": entry(
        "At X{x:.3f} Y{y:.3f} mm the tool was turned to C{c:.3f}, which is {turn:.1f} degrees away "
        "from the program near program line {line}. Either a program line was corrupted on its way "
        "to the controller, or a motor lost steps.",
        "Check the cable to the controller and home the machine. Check the board on the table, "
        "which may be spoiled.",
        x="number",
        y="number",
        c="number",
        turn="number",
        line="count",
    ),
    "controller.off-path": entry(
        "The machine was at X{x:.3f} Y{y:.3f} Z{z:.3f} mm, which is {distance:.1f} mm away "
        "from the path of the program near program line {line}. Either a program line was "
        "corrupted on its way to the controller, or a motor lost steps.",
        "Check the cable to the controller and home the machine. Check the board on the table, "
        "which may be spoiled.",
        x="number",
        y="number",
        z="number",
        distance="number",
        line="count",
    ),
    "controller.port-busy": entry(
        "Another program uses the serial port {port}.",
        "Close the other program, then start the gateway again.",
        port="text",
    ),
    "controller.port-missing": entry(
        "There is no serial port {port}. {found}",
        "Plug in the controller and switch it on, or correct the name of the port.",
        port="text",
        found="message?",
    ),
    "controller.port-not-permitted": entry(
        "The user of this gateway may not open the serial port {port}.",
        "On Linux, add the user to the group of the port, usually dialout (sudo usermod -aG "
        "dialout USER), then log in again.",
        port="text",
    ),
    "controller.port-unusable": entry(
        "The serial port {port} cannot be opened ({reason}).",
        "Correct the name of the port or its speed.",
        port="text",
        reason="text",
    ),
    "controller.ports-found": entry(
        "This computer has the ports {ports:, }.",
        ports="texts",
    ),
    "controller.refused-safe-state": entry(
        "{refusals: }",
        "Lift the tool and raise the stations at the table. Then compare the outputs in the "
        "machine file with the outputs of the controller.",
        refusals="messages",
    ),
    "controller.one-carriage": entry(
        "The machine {machine} has {count} carriages, and the gateway and the simulated table can "
        "only drive a machine with one.",
        "Download the program and open it in the controller of the machine.",
        machine="text",
        count="count",
    ),
    "controller.rejected-command": entry(
        "{name} rejected the command {command}: {error} (error:{code}).",
        "Check the table, then try again.",
        name="text",
        command="text",
        error="message",
        code="count",
    ),
    "controller.rejected-in-check": entry(
        "{name} rejected program line {line} ({text}) in its check mode, before anything "
        "moved: {error} (error:{code}).",
        "Compile the job again for this controller.",
        name="text",
        line="count",
        text="text",
        error="message",
        code="count",
    ),
    "controller.rejected-line": entry(
        "{name} rejected program line {line} ({text}): {error} (error:{code}).",
        "Check the board on the table, then compile the job again for this controller.",
        name="text",
        line="count",
        text="text",
        error="message",
        code="count",
    ),
    "controller.reports-alarm": entry(
        "{name} reports an alarm.",
        "Check the table, then home the machine ($H) or unlock it ($X).",
        name="text",
    ),
    "controller.reset": entry(
        "{name} was reset. The position of the machine may be lost, so the job does not continue "
        "automatically. {due}",
        "Check the table and home the machine. Then queue the job again or scrap it.",
        name="text",
        due="message?",
    ),
    "controller.reset-not-confirmed": entry(
        "{name} did not confirm its reset within {seconds:g} s.",
        "Check the table, then try again.",
        name="text",
        seconds="number",
    ),
    "controller.settings-refused": entry(
        "{name} has settings with which the programs of this machine would be dangerous: "
        "{differences: } Nothing was sent.",
        "{differences:hint} The gateway then connects by itself.",
        name="text",
        differences="messages",
    ),
    "controller.silent": entry(
        "{name} has not responded for {seconds:g} s. {due}",
        "Check the cable to the controller, then check the board on the table.",
        name="text",
        seconds="number",
        due="message?",
    ),
    "controller.stopped": entry(
        "{error} {progress} The machine was stopped, the head was lifted to Z {height:.1f} mm, "
        "and the stations were raised.",
        "{error:hint}",
        error="message",
        progress="message",
        height="number",
    ),
    "controller.unsafe": entry(
        "{error} {progress} The machine is not in a safe state: the stations may still be lowered.",
        "Lift the tool and raise the stations at the table. {error:hint}",
        error="message",
        progress="message",
    ),
    "controller.unable": entry(
        "{name} cannot execute program line {line} ({text}): {obstacle}. Nothing has moved.",
        "Use a controller with the axes and outputs of the machine, for example grblHAL, or "
        "correct the machine file.",
        name="text",
        line="count",
        text="text",
        obstacle="message",
    ),
    "controller.too-few-outputs": entry(
        "{name} has {count:# digital output|# digital outputs}, but the machine file contains a "
        "station with output {output}. Nothing was sent.",
        "Use a controller with more outputs, for example grblHAL, or correct the machine file.",
        name="text",
        count="count",
        output="count",
    ),
    "controller.unexpected-answer": entry(
        "{name} responded to a program line that this gateway did not send. Either a response "
        "was sent twice, or another program sends lines to the controller.",
        "Check the cable to the controller, and close any other program that is connected to "
        "the controller.",
        name="text",
    ),
    "controller.unreachable": entry(
        "No controller responds at {address} ({reason}).",
        "Switch on the controller, or correct the address.",
        address="text",
        reason="text",
    ),
    "controller.was-reset": entry(
        "{name} was reset.",
        "Check the table and home the machine before the next job.",
        name="text",
    ),
    "controller.web-server": entry(
        "A web server answers at {address}, not a controller.",
        "Correct the host or the port in the address of the controller.",
        address="text",
    ),
    "folder.bad-address": entry(
        "{address!r} is not the address of a folder on this computer.",
        "Write it as file:///FOLDER with the full path of the folder, for example "
        "file:///srv/programs.",
        address="text",
    ),
    "folder.deleted": entry(
        "The program file {file} was still in the folder and was deleted. The software of the "
        "machine may have read it before.",
        "Check at the machine that the program is not loaded. If it runs, stop it there.",
        file="text",
    ),
    "folder.not-deleted": entry(
        "The program file {file} could not be deleted ({reason}).",
        "Delete the file. Check at the machine that the program is not loaded.",
        file="text",
        reason="text",
    ),
    "folder.not-written": entry(
        "The program was not written into the folder {folder}, so the machine did not get it.",
        "Check the folder, then queue the job again.",
        folder="text",
    ),
    "folder.taken": entry(
        "The software of the machine has taken the program file {file}, so the machine may "
        "execute it.",
        "Stop the program at the machine. Nothing can be stopped from here.",
        file="text",
    ),
    "folder.unusable": entry(
        "Programs cannot be written into the folder {folder} ({reason}).",
        "Create the folder, or give the user of the gateway the permission to write into it.",
        folder="text",
        reason="text",
    ),
    "run.executed": entry(
        "{executed} of {lines} program lines were executed.",
        executed="count",
        lines="count",
    ),
    "run.in-buffer": entry(
        "{executed} of {lines} program lines were executed. Up to {rest} more program lines, "
        "which were in the buffer of the controller, may also have been executed.",
        executed="count",
        lines="count",
        rest="count",
    ),
    "run.nothing-sent": entry(
        "No program line was executed.",
    ),
}
