"""cache: load compiled kernels from disk, without the parts of numba that only a compilation needs.

When numba loads its first kernel, it prepares a whole compiler: it imports its implementations of
Python's and NumPy's functions, and parses the LLVM code of each kernel in case another kernel calls
it.  A command that only runs compiled kernels needs none of this, and starts faster without it.
"""

from __future__ import annotations

import errno
import io
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import llvmlite.binding as llvm
from numba.core.caching import (
    CompileResultCacheImpl,
    FunctionCache,
    IndexDataCacheFile,
    InTreeCacheLocator,
)
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import CompileResult
from numba.core.environment import Environment, lookup_environment
from numba.core.runtime import rtsys


class _LoadedLibrary(JITCodeLibrary):
    """Machine code of one kernel, and its LLVM code for the compilation of kernels that call it."""

    _bitcode: bytes | None = None
    _parsed: Any = None

    @property
    def _shared_module(self) -> Any:
        """The LLVM code of this kernel, parsed when a kernel that calls this one is compiled."""
        if self._parsed is None and self._bitcode is not None:
            self._parsed = llvm.parse_bitcode(self._bitcode)
        return self._parsed

    @_shared_module.setter
    def _shared_module(self, module: Any) -> None:
        self._parsed = module

    def get_pointer_to_function(self, name: str) -> int:
        """Return the memory address of the function ``name`` in this library."""
        return int(self._codegen._engine.get_function_address(name))

    @classmethod
    def load(cls, codegen: Any, stored: tuple[str, str, tuple[bytes, bytes]]) -> _LoadedLibrary:
        """Return the library of a cache file, with its machine code ready to run.

        ``codegen``: code generator of the processor, which owns the memory of machine code.
        ``stored``: what numba's ``serialize_using_object_code`` wrote: the name of the library, the
        text ``"object"``, and a pair of its machine code and its LLVM code.
        """
        name, _kind, (machine_code, bitcode) = stored
        library = cls(codegen, name)
        library.enable_object_caching()
        library._set_compiled_object(machine_code)
        library._bitcode = bitcode
        library._finalize_final_module()
        return library


class _ReadOnlyCacheLocator(InTreeCacheLocator):
    """Finds the cache folder beside a source file, even if this process cannot write to it.

    numba only reads a cache from a folder that it can write to.  In a container image with a
    read-only file system and no writable home directory, it would refuse to define any kernel.
    """

    def ensure_cache_path(self) -> None:
        """Require that the folder exists.

        Raises ``FileNotFoundError``: the folder does not exist.
        """
        if not Path(self.get_cache_path()).is_dir():
            raise FileNotFoundError(self.get_cache_path())


class _StoredKernel(CompileResultCacheImpl):
    """Converts a compiled kernel to the content of its cache file, and back."""

    # Last, because a kernel that is missing in this folder is compiled again in each process.
    # RUF012: numba declares the attribute as a list, not as a class variable.
    _locator_classes = [*CompileResultCacheImpl._locator_classes, _ReadOnlyCacheLocator]  # noqa: RUF012

    def rebuild(self, target_context: Any, payload: tuple[Any, ...]) -> CompileResult:
        """Return the compiled kernel that the content of a cache file describes.

        ``payload`` is the content: what numba's ``CompileResult._reduce`` returned when the file
        was written.  ``target_context`` is numba's compilation context of the processor.
        """
        stored, descriptor, environment, signature, object_mode, lifted, annotation, *rest = payload
        reload_init, referenced_environments = rest
        for initialise in reload_init:
            initialise()
        library = _LoadedLibrary.load(target_context.codegen(), stored)
        result = CompileResult(
            target_context=target_context,
            typing_context=target_context.typing_context,
            library=library,
            environment=environment,
            entry_point=target_context.get_executable(library, descriptor, environment),
            fndesc=descriptor,
            type_annotation=annotation,
            signature=signature,
            objectmode=object_mode,
            lifted=lifted,
            typing_error=None,
            call_helper=None,
            metadata=None,
            reload_init=reload_init,
            referenced_envs=referenced_environments,
        )
        for each in referenced_environments:
            library.codegen.set_env(each.env_name, each)
        return result


class _KernelUnpickler(pickle.Unpickler):
    """Reads a cache file without the import of the modules whose functions the kernel contains.

    A kernel that sorts an array contains functions of ``numba.np.arrayobj``.  numba would import
    that module, and with it the compiler's definitions, only to give its globals to the function's
    environment.  Machine code uses the constants of an environment, never its globals.
    """

    def find_class(self, module: str, name: str) -> Any:
        """Return a class or function that the file names; ``_restore_environment`` for numba's."""
        if (module, name) == ("numba.core.environment", "_rebuild_env"):
            return _restore_environment
        return super().find_class(module, name)


def _restore_environment(module: str, constants: list[Any], name: str) -> Environment:
    """Return the environment of a compiled function, without globals except ``__name__``.

    The arguments are those that numba wrote to the file: the module of the function, the constants
    that its machine code uses, and the name of the environment.
    """
    environment: Environment | None = lookup_environment(name)
    if environment is None:
        environment = Environment({"__name__": module})
        environment.consts[:] = constants
        environment.env_name = name
        Environment._memo[name] = environment
    return environment


class _KernelFiles(IndexDataCacheFile):
    """Index file of one kernel, and the files with machine code that the index names."""

    def _load_index(self) -> dict[Any, str]:
        """Return the names of the files with machine code, one per signature and processor.

        Returns an empty dict if the index file cannot be read; numba then compiles the kernel and
        overwrites the index.  Reading fails, for example, after the class of an argument was moved
        or deleted: numba reads the signatures in the index before it checks whether the source
        changed.
        """
        try:
            index: dict[Any, str] = super()._load_index()
        except Exception:  # reading a pickle may raise any exception
            return {}
        return index

    def _load_data(self, name: str) -> Any:
        """Return the content of the file ``name``, which contains machine code.

        Raises ``FileNotFoundError``: the file is missing or cannot be read; numba then compiles the
        kernel again.
        """
        try:
            return _KernelUnpickler(io.BytesIO(Path(self._data_path(name)).read_bytes())).load()
        except Exception as reason:
            raise FileNotFoundError(name) from reason


class KernelCache(FunctionCache):
    """The cache files of one kernel, in a folder beside its source file or of the user."""

    _impl_class = _StoredKernel

    def __init__(self, function: Callable[..., Any]) -> None:
        super().__init__(function)
        self._cache_file = _KernelFiles(
            cache_path=self._cache_path,
            filename_base=self._impl.filename_base,
            source_stamp=self._impl.locator.get_source_stamp(),
        )

    def load_overload(self, sig: Any, target_context: Any) -> CompileResult | None:
        """Return the compiled kernel for a signature, or None if it is not in the cache.

        numba's own method first loads the compiler's definitions (``target_context.refresh``),
        which takes 0.15 s.  This method does not load them: a compilation loads them itself, and
        machine code needs only the functions that allocate memory.
        """
        rtsys.initialize(target_context)
        loaded: CompileResult | None = self._load_overload(sig, target_context)
        return loaded

    def save_overload(self, sig: Any, cres: CompileResult) -> None:
        """Store a compiled kernel, unless the file system is read-only.

        ``sig`` is the signature of the kernel, and ``cres`` the compiled kernel.
        """
        try:
            super().save_overload(sig, cres)
        except OSError as reason:
            if reason.errno not in (errno.EROFS, errno.EACCES):
                raise

    def is_stored(self, sig: Any, target_context: Any) -> bool:
        """Return whether the cache has machine code for the signature ``sig`` and this processor.

        The machine code is not loaded.  ``target_context`` is numba's compilation context of the
        processor.
        """
        key = self._index_key(sig, target_context.codegen())
        data_name = self._cache_file._load_index().get(key)
        return data_name is not None and Path(self._cache_file._data_path(data_name)).is_file()
