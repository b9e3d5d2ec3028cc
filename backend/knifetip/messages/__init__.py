"""Messages as records: a code with typed arguments, which a catalogue renders in a language.

``codes`` lists every code with the types of its arguments, ``english`` has a text and a hint for
each.  Another language is another file like ``english``.
"""

from knifetip.messages.message import Argument, Message, from_json, printable
from knifetip.messages.render import hint, render, with_text

__all__ = ["Argument", "Message", "from_json", "hint", "printable", "render", "with_text"]
