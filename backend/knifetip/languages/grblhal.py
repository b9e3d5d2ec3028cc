"""grblhal: the language record of RS274/NGC as grblHAL and grbl 1.1 read it."""

from knifetip.languages.language import Language

LANGUAGE = Language(
    name="grblhal",
    title="grblHAL",
    suffix=".ngc",
    emitter="knifetip.post.rs274.grblhal:emit",
    reader="knifetip.verification.reading.rs274.reader:READER",
    timing="knifetip.sequencing.timing:no_halts",
    driver="knifetip.gateway.grbl.driver:dial",
)
