"""dispatch: the decorators of kernels, and a dispatcher that compiles only the declared signature.

numba's own dispatcher compiles a function again for each combination of argument types in its
calls: for read-only and writable arrays, and for every constant that another kernel passes.  With
explicit signatures it compiles when the module is imported, and casts floats to integers.
``Kernel`` compiles at the first call, or loads the machine code from the cache file, and converts
arguments only if no digit can be lost.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any, TypeVar, cast, overload

from numba import typeof
from numba.core import errors, typing
from numba.core.registry import CPUDispatcher
from numba.core.typeconv import Conversion

from knifetip.kernels.cache import KernelCache
from knifetip.kernels.declare import argument_types

_Function = TypeVar("_Function", bound=Callable[..., Any])


class Kernel(CPUDispatcher):
    """A function that numba compiles for the signature that its annotations declare."""

    def enable_caching(self) -> None:
        """Make the kernel store its machine code in a cache file beside the source."""
        del self._cache  # numba's "no cache"; the property below takes its place

    @cached_property
    def _cache(self) -> KernelCache:
        """Return the cache files of this kernel.

        The record is created at first use, because its creation makes numba look for a writable
        folder, and most kernels of a command are never called.
        """
        return KernelCache(self.py_func)

    @cached_property
    def declared(self) -> dict[str, Any]:
        """Return the numba type of each argument of the kernel, by the argument's name."""
        return argument_types(self.py_func)

    @cached_property
    def _accepted(self) -> set[tuple[Any, ...]]:
        """Return the argument types of earlier calls for which machine code has been registered.

        Each entry is a tuple of one numba type per argument.  The set also keeps these types alive:
        numba gives a new code to a type that was released, and the machine code is registered by
        the codes of the types.
        """
        return {tuple(self.declared.values())}

    def compile(self, _sig: object = None) -> Any:
        """Return the entry point of the machine code for the declared signature.

        The machine code is loaded from the cache, or compiled if the cache does not contain it.
        numba passes the types of the arguments of a call, which are not needed here.
        """
        return super().compile(tuple(self.declared.values()))

    @property
    def is_cached(self) -> bool:
        """Return whether the cache has machine code for the kernel's present source and this
        processor.

        The machine code is not loaded.
        """
        self.targetctx.refresh()
        return self._cache.is_stored(tuple(self.declared.values()), self.targetctx)

    def get_call_template(self, args: Sequence[Any], kws: dict[str, Any]) -> Any:
        """Return how another kernel calls this kernel, as numba's protocol requires.

        ``args`` and ``kws`` are the types of the positional and of the keyword arguments of the
        call.

        Returns
        -------
        template
            Numba's typing template with the signature of this kernel.
        signature
            Python signature of the function.
        types
            Types of all arguments, in the order of the signature.
        keywords
            An empty dict.

        Raises
        ------
        numba.core.errors.TypingError
            An argument has another type than declared.
        """
        pysig, args = self._compiler.fold_argument_types(args, kws)
        if wrong := self._mismatch(args):
            raise errors.TypingError(wrong)
        if not self.overloads:
            self.compile()
        name = self.py_func.__name__
        template = typing.make_concrete_template(name, name, self.nopython_signatures)
        return template, pysig, args, {}

    def _compile_for_args(self, *args: Any, **_kws: Any) -> Any:
        # numba's C code calls this for types of arguments that it has not met before, and then
        # calls the returned function, which converts the arguments.
        entry_point = self.compile()
        arguments = tuple(typeof(value) for value in args)
        if wrong := self._mismatch(arguments):
            raise TypeError(wrong)
        if arguments not in self._accepted:
            self._accepted.add(arguments)
            self._insert([each._code for each in arguments], entry_point, False)
        return entry_point

    def _mismatch(self, arguments: Sequence[Any]) -> str:
        """Return an error message if an argument of a call has another type than declared, else "".

        ``arguments`` are the numba types of the arguments of the call.
        """
        for (name, declared), each in zip(self.declared.items(), arguments, strict=True):
            kind = self.typingctx.can_convert(each, declared)
            if kind is None or kind > Conversion.safe:
                where = f"{self.py_func.__module__}.{self.py_func.__name__}"
                return f"{where}: argument {name} is {each}, declared is {declared}. Convert it."
        return ""


def _compiled(function: _Function, **options: Any) -> _Function:
    dispatcher = Kernel(
        function, targetoptions={"nopython": True, "no_cfunc_wrapper": True, **options}
    )
    dispatcher.enable_caching()
    return cast(_Function, dispatcher)


@overload
def kernel(function: _Function, /) -> _Function: ...


@overload
def kernel(
    *, allocates: bool = True, checks_division: bool = False
) -> Callable[[_Function], _Function]: ...


def kernel(
    function: _Function | None = None,
    /,
    *,
    allocates: bool = True,
    checks_division: bool = False,
) -> _Function | Callable[[_Function], _Function]:
    """Compile a function to machine code that runs without Python's global interpreter lock.

    Parameters
    ----------
    function
        The function to compile; None if the decorator is called with options.
    allocates
        Must be True for a function that creates an array or stores a reference to one; functions
        that it calls may do so in either case.  With False the function is compiled without
        reference counting.  Reference counting synchronises the cores, so it can take longer than
        the function itself, most of all if named tuples are passed.
    checks_division
        Whether division by 0 raises ``ZeroDivisionError``; otherwise it returns inf, nan or 0.
    """
    options: dict[str, Any] = {
        "nogil": True,
        "error_model": "python" if checks_division else "numpy",
        # Always given: a kernel inherits missing options from the kernel whose compilation
        # compiles it.
        "_nrt": allocates,
        "forceinline": False,
    }
    if function is not None:
        return _compiled(function, **options)
    return lambda decorated: _compiled(decorated, **options)


def inline_kernel(function: _Function) -> _Function:
    """Compile a function into each kernel that calls it, because calls with many arrays are slow.

    The function must not create an array or store a reference to one (``allocates=False``).
    """
    return _compiled(function, nogil=True, error_model="numpy", forceinline=True, _nrt=False)
