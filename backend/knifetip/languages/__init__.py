"""Controller languages: one record each, found by the name in a machine's TOML file.

    "grblhal" -> Language, which names its emitter, the judge's reader, timing and gateway driver

This room imports no part of a language.  The parts lie in other rooms, and the reader of the judge
shares no code with the emitter (ADR 27).
"""
