"""declare: convert the annotations of a function to the numba types of its arguments."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Callable, Mapping
from typing import Any, get_args, get_origin, get_type_hints

from numba import types
from numba.core.datamodel import models, register_default
from numba.core.imputils import lower_cast
from numba.core.typeconv import Conversion
from numba.core.types.npytypes import Array as NumbaArray
from numba.np.numpy_support import from_dtype
from numpy import dtype

from knifetip.kernels.vocabulary import Array, Scalar

_PLAIN = {float: types.float64, int: types.int64, bool: types.boolean}
_PLAIN_NAMES = {each.__name__: each for each in _PLAIN}


class Group(types.NamedTuple):
    """Numba type of a named tuple in a kernel's signature.

    A named tuple is accepted as an argument of this type if the type of each of its fields can be
    converted.  numba itself converts no named tuples: it would refuse a named tuple with a writable
    array if a read-only array is declared.
    """

    def can_convert_from(self, typingctx: Any, other: Any) -> Any:
        """Return how numba converts a value of type ``other`` to this type; None if it cannot.

        The result is the least safe conversion of a field, or ``Conversion.safe`` if all
        conversions of fields are safer than that.
        """
        if getattr(other, "instance_class", None) is not self.instance_class:
            return None
        kinds = [typingctx.can_convert(a, b) for a, b in zip(other, self, strict=True)]
        if any(kind is None for kind in kinds):
            return None
        return max([Conversion.safe, *kinds])


register_default(Group)(models.TupleModel)


@lower_cast(types.BaseNamedTuple, Group)
def _cast_group(context: Any, builder: Any, source: Any, declared: Any, value: Any) -> Any:
    fields = [
        context.cast(builder, builder.extract_value(value, i), a, b)
        for i, (a, b) in enumerate(zip(source, declared, strict=True))
    ]
    return context.make_tuple(builder, declared, fields)


def argument_types(function: Callable[..., Any]) -> dict[str, Any]:
    """Return the numba type of each argument of a function, by name.

    Raises
    ------
    TypeError
        An argument has no annotation, an annotation outside the vocabulary, or a default value.
    """
    hints = _resolve_annotations(function, function.__globals__)
    declared = {}
    for name, parameter in inspect.signature(function).parameters.items():
        location = f"{function.__module__}.{function.__qualname__}: argument {name}"
        if parameter.default is not parameter.empty:
            raise TypeError(
                f"{location} has a default value. Remove it, and pass it in every call."
            )
        if parameter.kind is not parameter.POSITIONAL_OR_KEYWORD:
            raise TypeError(f"{location} collects several arguments. Declare each by its own name.")
        if name not in hints:
            raise TypeError(
                f"{location} has no annotation. See knifetip.kernels for the vocabulary."
            )
        declared[name] = _numba_type(hints[name], location)
    return declared


def _resolve_annotations(owner: Any, namespace: Mapping[str, Any]) -> dict[str, Any]:
    """Return the annotations of a function or a class, with texts replaced by what they name.

    ``typing.get_type_hints`` compiles each text, which takes a fifth of the time in which the
    kernels of a command are loaded.  Most texts are names in the ``namespace`` of their module.
    """
    resolved = {}
    for name, annotation in owner.__annotations__.items():
        text = getattr(annotation, "__forward_arg__", annotation)
        if text in _PLAIN_NAMES:
            resolved[name] = _PLAIN_NAMES[text]
        elif text in namespace:
            resolved[name] = namespace[text]
        elif name != "return":
            return get_type_hints(owner, include_extras=True)
    return resolved


def _numba_type(annotation: Any, location: str) -> Any:
    if annotation in _PLAIN:
        return _PLAIN[annotation]
    for extra in getattr(annotation, "__metadata__", ()):
        if isinstance(extra, Scalar):
            return from_dtype(dtype(extra.dtype))
        if isinstance(extra, Array):
            return NumbaArray(
                from_dtype(dtype(extra.dtype)),
                extra.dimensions,
                extra.order,
                readonly=not extra.writable,
            )
    if get_origin(annotation) is tuple:
        return types.Tuple([_numba_type(each, location) for each in get_args(annotation)])
    if isinstance(annotation, type) and hasattr(annotation, "_fields"):
        fields = _resolve_annotations(annotation, vars(sys.modules[annotation.__module__]))
        return Group(
            [_numba_type(fields[f], f"{location}.{f}") for f in annotation._fields], annotation
        )
    raise TypeError(
        f"{location} is declared as {annotation}. See knifetip.kernels for the vocabulary."
    )
