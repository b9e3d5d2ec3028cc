"""knifetip on the command line.

    knifetip read | classify | program | verify | profile | machine | calibrate | samples
    knifetip serve | worker | gateway | simulator

Exit codes: 0 success; 1 the program was refused; 2 questions are open (also after ``classify``,
which prints its result all the same), or the command line is wrong; 3 the input cannot be used.
Results go to stdout, progress and problems to stderr.
"""

from knifetip.cli.main import main

__all__ = ["main"]
