"""Controller languages: one record each, found by the name in a machine's file.

    "grblhal" -> Language, which names its emitter, the judge's reader, timing and gateway driver

This room imports no part of a language, and the judge's reader shares no code with the emitter:
each part lies in the room that it belongs to (ADR 27).
"""
