"""hpgl: the language record of Hewlett-Packard's plotter language, for flat cutters with pens."""

from knifetip.languages.language import Language
from knifetip.messages import Message

LANGUAGE = Language(
    name="hpgl",
    title="HPGL",
    suffix=".plt",
    emitter="knifetip.post.hpgl:emit",
    reader="knifetip.verification.reading.hpgl:READER",
    timing="knifetip.sequencing.look_ahead:look_ahead",
    driver="knifetip.gateway.hpgl.driver:dial",
    sets_pose=False,
    no_driver=Message("hpgl.send-by-hand"),
    settings="knifetip.languages.hpgl.settings:read_settings",
    settings_table="knifetip.languages.hpgl.settings:ControllerTable",
)
