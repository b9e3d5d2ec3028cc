"""Verify a program: read its bytes back and compare the tool's work with the drawn edges.

    reading       program bytes -> moves of the machine's joints, one reader for each language
    kinematics    moves -> poses of the tool tip -> its paths in the board
    expectation   drawn edges, board, tools -> what must be worked, how deep and how far
    checks        paths against expectation -> findings and figures
    curves        lines, arcs and their overlaps, for all of the above

This package shares no calculation with the stages that make a program: it imports nothing from
``geometry`` or from them, so that an error there is not repeated here.

Where each kind of finding is made (modules of ``checks`` where no package is named):

==========  ========================================================================
kind        modules
==========  ========================================================================
program     readers in ``reading``, ``output_checks`` (unstated or early switching),
            ``motion_checks`` (outputs while working, unknown positions), ``verify``
            (placement)
travel      ``motion_checks``
feed        ``motion_checks``
heading     ``check_base`` (along edges), ``motion_checks`` (turns in the board)
deviation   ``check_base`` (knives, wheels, V-cutters), ``milling_check``,
            ``groove_check`` (flanks), ``stray_work`` (beside an edge),
            ``bridge_check`` (near corners), ``motion_checks`` (slanted plunges)
depth       ``check_base``, ``groove_check`` and ``milling_check`` (passes),
            ``motion_checks`` (focus of a beam)
uncut       ``check_base``, ``crease_check`` (short creases), ``knife_check``
            (perforations), ``track_ends`` (stops short), ``bridge_check``,
            ``milling_check``, ``cleaning_check``, ``verify`` (no line type)
overcut     ``stray_work`` and ``track_ends`` (past an end), ``groove_check``
            (run-outs, flanks through cuts), ``bridge_check``, ``milling_check``
stray       ``stray_work``, ``milling_check``, ``motion_checks`` (rapids in the board)
order       ``work_order``
==========  ========================================================================
"""
