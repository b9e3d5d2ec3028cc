"""No kernel is compiled while somebody waits: what plain Python calls, ``warm`` has run."""

from __future__ import annotations

import subprocess
import sys

#: What no request calls: tests of the papers do, and callers that have the outline of the sheet,
#: which the service does not have.
_NOT_ASKED_FOR = {
    "geometry.transition._all",
    "sequencing.turning._clear_ways",
    "sequencing.turning._outside",
}

# In an interpreter of its own: here other tests have run kernels.
_PROGRAM = '''
import ast, importlib, inspect, pkgutil
import knifetip
from knifetip.warming import warm
from numba.core.dispatcher import Dispatcher


def called(module):
    """The kernels that a module names outside of kernels."""
    tree = ast.parse(inspect.getsource(module))
    plain = [one for one in tree.body if not kernel(module, getattr(one, "name", ""))]
    for node in (node for one in plain for node in ast.walk(one)):
        if isinstance(node, ast.Name) and kernel(module, node.id):
            yield getattr(module, node.id)
        elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            other = getattr(module, node.value.id, None)
            if inspect.ismodule(other) and kernel(other, node.attr):
                yield getattr(other, node.attr)


def kernel(module, name):
    return isinstance(getattr(module, name, None), Dispatcher)


found = set()
for one in pkgutil.walk_packages(knifetip.__path__, "knifetip."):
    if "__main__" not in one.name and "migrations" not in one.name and not one.ispkg:
        found.update(called(importlib.import_module(one.name)))
warm()
for one in found:
    state = "warm" if one.signatures else "cold"
    print(state, f"{one.py_func.__module__}.{one.py_func.__name__}".removeprefix("knifetip."))
'''


def test_every_kernel_that_a_request_may_call_is_warm() -> None:
    done = subprocess.run([sys.executable, "-c", _PROGRAM], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    lines = [line.split() for line in done.stdout.splitlines()]
    assert len(lines) > 80
    assert {name for state, name in lines if state == "cold"} == _NOT_ASKED_FOR
