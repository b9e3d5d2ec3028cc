"""MCX314, a chip that interpolates up to three of four axes, on a board with a queue.

The driver of the gateway talks to the board (``frames``, ``connection``).  The simulated board in
``simulators.mcx314`` serves the same protocol on a TCP port.
"""
