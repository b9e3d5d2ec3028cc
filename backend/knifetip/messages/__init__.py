"""messages: records of a code with typed arguments, from which the text is rendered.

``catalogue`` has one module for each area of knifetip, such as ``cleaning`` or ``job``; it contains
the code, English text, hint and types of the arguments of each message.  ``codes`` and ``english``
contain tables made from the catalogue.  ``german`` has the texts of another language in modules of
the same names; ``languages`` lists the languages.
"""

from knifetip.messages.characters import printable
from knifetip.messages.message import Argument, Message, finite, from_json
from knifetip.messages.render import hint, render, with_text

__all__ = ["Argument", "Message", "finite", "from_json", "hint", "printable", "render", "with_text"]
