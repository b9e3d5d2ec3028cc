"""A layers contract for import-linter in which packages can be named by a module they contain."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Final

from grimp import ImportGraph
from importlinter.contracts.layers import Layer, LayersContract, ModuleTail
from importlinter.domain.contract import ContractCheck

#: Beginning of a wildcard in a layer.
_WILDCARD: Final = "*."


class PatternLayersContract(LayersContract):
    """Layers contract with one container whose layers may contain wildcards.

    ``*.read`` is replaced by all packages of the container that have a module ``read`` and that no
    layer names.  A new package of that kind is then checked without a change of the contract.
    """

    layers: Any
    containers: Any

    def check(self, graph: ImportGraph, verbose: bool) -> ContractCheck:
        """Replace the wildcards, then check the import graph as a layers contract does."""
        (container,) = (str(expression) for expression in self.containers)
        named = {tail.name for layer in self.layers for tail in layer.module_tails}
        self.layers = [_expanded(layer, container, named, graph) for layer in self.layers]
        return super().check(graph, verbose)


def _expanded(layer: Layer, container: str, named: set[str], graph: ImportGraph) -> Layer:
    """Return a layer with package names instead of wildcards."""
    tails: set[ModuleTail] = set()
    for tail in layer.module_tails:
        if not tail.name.startswith(_WILDCARD):
            tails.add(tail)
            continue
        module = tail.name.removeprefix(_WILDCARD)
        for package in graph.find_children(container):
            name = package.removeprefix(f"{container}.")
            if name not in named and f"{package}.{module}" in graph.modules:
                tails.add(ModuleTail(name))
    return replace(layer, module_tails=tails)
