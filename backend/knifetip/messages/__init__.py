"""messages: records of a code with typed arguments, which are rendered as text in a language.

``catalogue`` has one module per area with all its messages: code, English text, hint and types of
the arguments.  ``codes`` and ``english`` are tables made from the catalogue.  A module with the
tables of ``english`` is needed for each further language.
"""

from knifetip.messages.message import Argument, Message, finite, from_json, printable
from knifetip.messages.render import hint, render, with_text

__all__ = ["Argument", "Message", "finite", "from_json", "hint", "printable", "render", "with_text"]
