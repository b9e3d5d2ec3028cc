"""messages: records of a code and typed arguments, which a catalogue renders in a language.

``catalogue`` has one module per area with all its messages: code, English text, hint and types of
the arguments.  ``codes`` and ``english`` are tables made from it.  Another language is another
module with the tables of ``english``.
"""

from knifetip.messages.message import Argument, Message, finite, from_json, printable
from knifetip.messages.render import hint, render, with_text

__all__ = ["Argument", "Message", "finite", "from_json", "hint", "printable", "render", "with_text"]
