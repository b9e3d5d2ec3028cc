"""Controllers that run a whole program by themselves and report their progress.

The drivers of such controllers (``linuxcnc``, ``mcx314``) share the code that follows a
program by reports, polls the machine between programs, and brings it to rest.
"""
