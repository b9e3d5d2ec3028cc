"""mcx314: write tables of segments for boards with the motion chip MCX314.

``segments`` converts the moves of one station to segments in pulses, and ``program`` writes them as
the lines of a program.
"""
