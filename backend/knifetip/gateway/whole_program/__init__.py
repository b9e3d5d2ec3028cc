"""Controllers that run a whole program by themselves and report how far they are.

The drivers of such controllers (``linuxcnc``, ``mcx314``) share how they follow a program by
reports, how they watch the machine between programs and how they bring it to rest.
"""
