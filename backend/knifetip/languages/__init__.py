"""Controller languages: one record each, found by the name in a machine's TOML file.

    "grblhal" -> Language, which names its emitter, the verifier's reader, timing and gateway driver

This package imports no part of a language.  The parts are in other packages, and the reader of the
verifier shares no code with the emitter (ADR 27).
"""
