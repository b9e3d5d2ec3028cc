"""Verify a program: parse its bytes and compare the paths of the tools with the drawn edges.

Sub-packages and modules, in the order in which they are used:

    reading       converts program bytes to moves of the machine's joints; one reader per language
    trailing_blade  integrates the headings of blades that no joint turns
    kinematics    computes the poses of the tool tip from the moves, and its paths in the board
    expectation   derives the required paths, depths and limits from edges, board and tools
    checks        compares the paths with the expectation; adds findings and figures
    curves        lines, arcs and their overlaps, used by all the other modules

This package shares no calculation with the stages that make a program: it imports nothing from
``geometry`` or from those stages, so that an error in them is not repeated here.

A finding is a fault, which refuses the program; a shortfall, which refuses it until a user accepts
it; or a note.  Each check names the codes of the findings that it adds, so that a search for a code
leads to its check.
"""
