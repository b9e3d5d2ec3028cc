"""linuxcnc: the language record of the dialect of RS274/NGC that LinuxCNC reads."""

from knifetip.languages.language import Language

LANGUAGE = Language(
    name="linuxcnc",
    title="LinuxCNC",
    suffix=".ngc",
    emitter="knifetip.post.rs274.linuxcnc:emit",
    reader="knifetip.verification.reading.rs274.reader:READER",
    timing="knifetip.sequencing.linuxcnc:linuxcnc",
    driver="knifetip.gateway.linuxcnc.driver:dial",
    setting_lines="knifetip.gateway.linuxcnc.ini_settings:setting_lines",
    linear_axes="XYZUVW",
    rotary_axes="ABC",
    default_outputs=4,
)
