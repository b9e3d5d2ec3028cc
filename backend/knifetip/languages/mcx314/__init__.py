"""mcx314: the controller language of boards with the motion chip MCX314: tables of segments."""

from knifetip.languages.language import Language

LANGUAGE = Language(
    name="mcx314",
    title="MCX314",
    suffix=".mcx",
    emitter="knifetip.post.mcx314.program:emit",
    reader="knifetip.verification.reading.mcx314:READER",
    timing="knifetip.sequencing.look_ahead:look_ahead",
    driver="knifetip.gateway.mcx314.driver:dial",
    simulator="knifetip.simulators.mcx314.simulator:serve",
    settings="knifetip.languages.mcx314.settings:read_settings",
    settings_table="knifetip.languages.mcx314.settings:ControllerTable",
)
