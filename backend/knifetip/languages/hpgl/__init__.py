"""hpgl: the language record of Hewlett-Packard's plotter language, for flat cutters with pens."""

from knifetip.languages.language import Language

LANGUAGE = Language(
    name="hpgl",
    title="HPGL",
    suffix=".plt",
    emitter="knifetip.post.hpgl:emit",
    reader="knifetip.verification.reading.hpgl:READER",
    timing="knifetip.sequencing.timing:no_halts",
    # Open loop: the device does not report progress and cannot be stopped (ADR 27).
    no_driver="Download the program and send it with the software of the cutter, where a person "
    "can stop it.",
    settings="knifetip.languages.hpgl.plotter:read_settings",
)
