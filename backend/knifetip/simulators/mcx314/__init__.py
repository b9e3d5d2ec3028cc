"""A simulated board with an MCX314: its link, its queue, its interlocks and the chip."""
