"""references: the targets of references between elements."""

from __future__ import annotations

from knifetip.svg.document import Node


def href(node: Node) -> str:
    """Return the value of the attribute ``href`` of an element.

    If there is none, the value of an attribute with a prefix, such as ``xlink:href``, is returned,
    or "" if there is no such attribute either.
    """
    attributes = node.attributes
    return next((value for key, value in attributes.items() if key == "href"), None) or next(
        (value for key, value in attributes.items() if key.endswith(":href")), ""
    )
