"""Test pieces: drawings that are cut and measured, and the settings that follow from the measures.

Terminology

piece
    Drawing that one machine makes in one board, with the depths of its lines as options of an
    order.  It is read, planned and proven like any other drawing.
measure
    What a person reads off the piece that was cut: a length in mm, or the number of a line.
figure
    Setting of a machine or a board that follows from the measures, with its uncertainty.

Each wizard (``wizard.Wizard``) has one module with its drawing, its measures and its formula.
"""
