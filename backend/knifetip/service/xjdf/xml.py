"""Parse XML documents of CIP4: without document types, entities and external references."""

from __future__ import annotations

from typing import Final
from xml.etree.ElementTree import Element, ParseError

import defusedxml.ElementTree as ElementTree  # type: ignore[import-untyped]  # has no types
from defusedxml.common import DefusedXmlException  # type: ignore[import-untyped]  # has no types

from knifetip.errors import RequestError

NAMESPACE: Final = "http://www.CIP4.org/JDFSchema_2_0"
#: Largest XML document that is read (bytes).
LARGEST: Final = 4 << 20


def parse(content: bytes, root: str) -> Element:
    """Return the root element of a document.

    Parameters
    ----------
    content
        The document.
    root
        Name that the root element must have: XJDF or XJMF.

    Raises
    ------
    RequestError
        The document is too large, is not well-formed, declares a document type, or has another root
        element.
    """
    if len(content) > LARGEST:
        raise RequestError("xjdf.too-large", name=root, limit=LARGEST >> 20)
    try:
        found: Element = ElementTree.fromstring(content, forbid_dtd=True)
    except DefusedXmlException as reason:
        text = "it declares a document type or an entity, which is not accepted"
        raise RequestError("xjdf.unreadable", reason=text) from reason
    except ParseError as reason:
        line, column = reason.position
        text = f"it is not well-formed in line {line}, column {column + 1}"
        raise RequestError("xjdf.unreadable", reason=text) from reason
    except (ValueError, LookupError) as reason:
        text = "its character encoding is not known"
        raise RequestError("xjdf.unreadable", reason=text) from reason
    if found.tag != f"{{{NAMESPACE}}}{root}":
        raise RequestError(
            "xjdf.not-xjdf", element=found.tag[:100], wanted=root, namespace=NAMESPACE
        )
    return found


def children(element: Element, name: str) -> list[Element]:
    """Return the children of an element with a name of the namespace."""
    return element.findall(f"{{{NAMESPACE}}}{name}")


def local_name(element: Element) -> str:
    """Return the name of an element without its namespace; "" for one of another namespace."""
    prefix = f"{{{NAMESPACE}}}"
    return element.tag.removeprefix(prefix) if element.tag.startswith(prefix) else ""
