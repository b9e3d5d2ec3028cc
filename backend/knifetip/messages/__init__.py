"""Messages as records: a code with typed arguments, which a catalogue renders in a language.

``catalogue`` has all messages, one module per area: code, English text, hint and the types of the
arguments.  ``codes`` and ``english`` are tables of it.  Another language is another module like
``english``.
"""

from knifetip.messages.message import Argument, Message, from_json, printable
from knifetip.messages.render import hint, render, with_text

__all__ = ["Argument", "Message", "from_json", "hint", "printable", "render", "with_text"]
