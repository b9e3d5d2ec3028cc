"""The ``knifetip`` command line.

    knifetip read | classify | clean | program | verify | samples
    knifetip profile | machine | calibrate | schema | job
    knifetip user | key
    knifetip serve | worker | gateway | simulator

Exit codes: 0 success; 1 the verifier refused the program; 2 the user must first answer questions
about the drawing (``classify`` also prints its result), or the command line is wrong; 3 the input
cannot be used.
Results are printed on stdout, progress and problems on stderr.
"""

from knifetip.cli.main import main

__all__ = ["main"]
