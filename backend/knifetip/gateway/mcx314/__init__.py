"""MCX314, a chip that interpolates up to three of four axes: its segments and a simulation of it.

``segments`` encodes a toolpath as a table of segments, ``feeder`` writes them to the registers of a
chip, and ``chip`` simulates the chip.  There is no language and no driver yet (ADR 72).
"""
