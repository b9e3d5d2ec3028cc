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

A finding is a fault, which refuses the program, or a shortfall, which does not.  The modules that
add each kind of finding (in ``checks`` unless another package is named):

==========  ========================================================================
kind        modules
==========  ========================================================================
program     readers in ``reading``, ``output_checks`` (unset outputs, early switching),
            ``motion_checks`` (outputs in the board), ``board_move_check``
            (unknown positions), ``verify`` (placement)
travel      ``motion_checks``, ``carriage_check``, ``zone_check``
feed        ``motion_checks``
heading     ``check_base`` (along edges), ``board_move_check`` (turns in the board),
            ``overlap_check`` (turns in place), ``trailing_blade`` (pushed or not parked)
deviation   ``check_base`` (knives, wheels, V-cutters), ``milling_check``,
            ``groove_check`` (flanks), ``stray_work`` (beside an edge),
            ``bridge_check`` (near corners), ``board_move_check`` (slanted plunges),
            ``overlap_check`` (LinuxCNC without exact stops)
depth       ``check_base``, ``groove_check`` and ``milling_check`` (passes),
            ``board_move_check`` (focus of a beam), ``blade_swivels``
uncut       ``check_base``, ``crease_check`` (short creases), ``knife_check``
            (perforations), ``track_ends`` (stops short), ``bridge_check``,
            ``milling_check``, ``cleaning_check``, ``verify`` (no line type)
beside      ``crease_bends`` and ``blade_swivels`` (shortfalls), ``blade_bends`` (a note or a
            shortfall)
overcut     ``stray_work`` and ``track_ends`` (past an end), ``groove_check``
            (run-outs, flanks through cuts), ``bridge_check``, ``milling_paths``,
            ``knife_check`` (short gaps of perforations)
stray       ``stray_work``, ``milling_check`` (shallow passes), ``milling_paths``,
            ``board_move_check`` (rapids in the board, too near to it or to the
            sheet), ``repeated_work`` (work of an earlier program)
order       ``work_order``
unreached   ``milling_shortfalls`` (a shortfall)
kerf        ``milling_shortfalls`` (a note or a shortfall)
fold        ``groove_check`` (a shortfall)
near        ``near_lines`` (a note or a shortfall), ``replaced_lines`` (a note)
==========  ========================================================================

The codes of findings and of phrases in them, without the codes of faults found by the readers:

=================================  =========================================
code                               module
=================================  =========================================
verify.beam-on-rapid               checks.board_move_check
verify.beam-refocused              checks.board_move_check
verify.beside-line                 checks.stray_work
verify.beyond-rotation             checks.motion_checks
verify.beyond-travel               checks.motion_checks
verify.blade-bend                  checks.blade_bends
verify.blade-bend-too-tight        checks.blade_bends
verify.blade-not-parked            trailing_blade
verify.blade-pushed                trailing_blade
verify.bridge-near-corner          checks.bridge_check
verify.bridge-spacing              checks.bridge_check
verify.bridge-spare                checks.bridge_check
verify.bridge-width                checks.bridge_check
verify.centre-off-path             checks.milling_check
verify.cleaning-beyond             checks.cleaning_check
verify.cleaning-dropped            checks.cleaning_check
verify.cleaning-fit                checks.cleaning_check
verify.cleaning-incomplete         checks.cleaning_check
verify.cleaning-invented           checks.cleaning_check
verify.cleaning-moved              checks.cleaning_check
verify.cleaning-type               checks.cleaning_check
verify.comes-out-anywhere          checks.track_ends
verify.comes-out-past              checks.track_ends
verify.comes-out-short             checks.track_ends
verify.contour-unreached           checks.milling_shortfalls
verify.crease-meets-cuts           checks.crease_check
verify.crease-stops-at-cut         checks.crease_check
verify.crease-too-bent             checks.crease_bends
verify.crease-too-short            checks.crease_check
verify.cut-both-ways               checks.knife_check
verify.cut-too-short               checks.knife_check
verify.cuts-part                   checks.milling_paths
verify.cutter-at-rest              tools
verify.deep-swivel                 checks.blade_swivels
verify.drawn-twice                 checks.near_lines
verify.feed-of-other-axis          checks.motion_checks
verify.fixed-blade                 checks.knife_passes
verify.flank-inside                checks.groove_check
verify.flank-outside               checks.groove_check
verify.flank-through-cut           checks.groove_check
verify.fold-angle                  checks.groove_check
verify.goes-in-anywhere            checks.track_ends
verify.groove-arc                  checks.groove_check
verify.groove-past-ends            checks.groove_check
verify.groove-shallower            checks.groove_check
verify.groove-shifted              checks.groove_check
verify.groove-too-short            checks.groove_check
verify.grooves-meet                checks.near_lines
verify.hanging-piece               checks.work_order
verify.head-not-located            checks.carriage_check
verify.heads-too-near              checks.carriage_check
verify.idle-head-low               checks.carriage_check
verify.in-zone                     checks.zone_check
verify.inside-part                 checks.milling_paths
verify.knife-at-rest               tools
verify.laser-off                   tools
verify.loose-piece                 checks.work_order
verify.lowers-second               checks.output_checks
verify.made-before                 checks.repeated_work
verify.moves-before-stated         checks.output_checks
verify.moves-overlap               checks.overlap_check
verify.moves-with-beam             checks.output_checks
verify.narrow-cuts                 checks.near_lines
verify.narrow-lines                checks.near_lines
verify.narrow-rim                  checks.rim_check
verify.narrow-slits                checks.milling_shortfalls
verify.never-stated                checks.output_checks
verify.no-station                  checks.motion_checks
verify.not-worked                  checks.check_base, checks.milling_check
verify.off-curve                   checks.check_base, checks.milling_check
verify.off-line                    checks.check_base
verify.one-pass                    checks.knife_passes
verify.oscillation-on              checks.motion_checks
verify.other-placement             verify
verify.outline-begun               checks.work_order
verify.output                      checks.output_checks
verify.output-off                  checks.motion_checks
verify.pass-alone                  checks.milling_check
verify.pass-too-deep               checks.groove_check, checks.knife_passes, checks.milling_check
verify.past-end                    checks.stray_work
verify.past-open-cut               checks.milling_paths
verify.past-stop                   checks.stray_work
verify.perforation-bridge          checks.perforation_check
verify.perforation-cut             checks.perforation_check
verify.perforation-gap             checks.perforation_check
verify.perforation-uneven          checks.perforation_check
verify.plunge-without-move         checks.check_base
verify.rapid-in-board              checks.board_move_check
verify.rapid-near-sheet            checks.board_move_check
verify.rapid-too-low               checks.board_move_check
verify.released-before             checks.work_order
verify.replaced                    checks.replaced_lines
verify.slanted                     checks.board_move_check
verify.spindle                     checks.output_checks
verify.stray                       checks.milling_paths, checks.stray_work
verify.stray-along                 checks.stray_work
verify.stray-plunge                checks.stray_work
verify.stray-plunge-along          checks.stray_work
verify.switches-at-unknown-height  checks.output_checks
verify.switches-low                checks.output_checks
verify.swivel-mark                 checks.blade_swivels
verify.too-few-bridges             checks.bridge_check
verify.turn-at-feed                checks.motion_checks
verify.turn-in-board               checks.board_move_check
verify.turn-off-path               checks.board_move_check
verify.turn-overlaps               checks.overlap_check
verify.two-lowered                 checks.motion_checks
verify.unclassified                verify
verify.unknown-beside-zone         checks.zone_check
verify.unknown-position            checks.board_move_check, checks.carriage_check
verify.unreached                   checks.milling_shortfalls
verify.where-from-start            checks.check_base, checks.milling_check
verify.where-past-end              checks.check_base
verify.where-past-start            checks.check_base
verify.wide-slit                   checks.milling_shortfalls
verify.work-creased                checks.check_base
verify.work-cut                    checks.check_base, checks.milling_check
verify.work-grooved                checks.check_base
verify.work-grooved-from-end       checks.check_base
verify.work-grooved-from-start     checks.check_base
verify.wrong-depth                 checks.check_base, checks.milling_check
verify.wrong-feed                  checks.motion_checks
verify.wrong-heading               checks.check_base
verify.wrong-time                  checks.motion_checks
=================================  =========================================
"""
