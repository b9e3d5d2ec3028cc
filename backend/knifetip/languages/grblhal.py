"""grblhal: the language record of the dialect of RS274/NGC that grblHAL and grbl 1.1 read."""

from knifetip.languages.language import Language

LANGUAGE = Language(
    name="grblhal",
    title="grblHAL",
    suffix=".ngc",
    emitter="knifetip.post.rs274.grblhal:emit",
    reader="knifetip.verification.reading.rs274.reader:READER",
    timing="knifetip.sequencing.look_ahead:look_ahead",
    driver="knifetip.gateway.grbl.driver:dial",
    setting_lines="knifetip.gateway.grbl.settings:setting_lines",
    linear_axes="XYZABUV",
    rotary_axes="ABCUV",
)
