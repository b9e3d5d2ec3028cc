"""launcher: limit the resources of this process, then run a program in its place.

``child_process`` runs this file as a script, because the limits must be set between fork and exec,
where a process with threads cannot execute Python code.  It imports nothing of knifetip.

Arguments: processor time (s), address space (bytes), size of a file (bytes), program, arguments of
the program.
"""

from __future__ import annotations

import os
import resource
import sys
from collections.abc import Sequence
from typing import Final

#: Exit status if the program cannot be run, as of a shell.
NOT_RUN: Final = 127
#: Number of files that the program may have open.  ``child_process`` limits the size of the folder,
#: but files that are deleted and still open do not appear there.
_OPEN_FILES: Final = 40


def launch(arguments: Sequence[str]) -> None:
    """Limit this process, and replace it by a program; return only if the program cannot be run."""
    cpu, memory, file_size = map(int, arguments[:3])
    command = list(arguments[3:])
    # The program gets SIGXCPU at the soft limit, and is killed a second later.
    for kind, soft, hard in (
        (resource.RLIMIT_CPU, cpu, cpu + 1),
        (resource.RLIMIT_AS, memory, memory),
        (resource.RLIMIT_FSIZE, file_size, file_size),
        (resource.RLIMIT_NOFILE, _OPEN_FILES, _OPEN_FILES),
        (resource.RLIMIT_CORE, 0, 0),
    ):
        resource.setrlimit(kind, (soft, hard))
    try:
        os.execv(command[0], command)  # no shell
    except OSError as error:
        print(error.strerror, file=sys.stderr)


if __name__ == "__main__":
    launch(sys.argv[1:])
    sys.exit(NOT_RUN)
