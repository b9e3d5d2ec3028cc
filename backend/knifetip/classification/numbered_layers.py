"""numbered_layers: find layers whose names only count, such as ``p-0`` … ``p-25``.

Generators of boxes put each part on a layer of its own.  The layer is then no evidence for the
line types of its edges, so all layers of a series are treated as one layer.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Hashable, Iterable
from typing import Final

from knifetip.vocabulary import name_meaning

_NUMBER: Final = re.compile(r"\d+")
#: Fewest layers of a series whose colours or line styles differ within its layers.
_FEWEST: Final = 4
#: Fewest layers of a series with one colour and line style; fewer may be one layer per line type.
_FEWEST_PLAIN: Final = 10
#: Least number of different colours and line styles per layer, on average over a series.
_LOOKS: Final = 1.25
#: Least number of layers for each look of a series, if each layer has about one look.
_LAYERS_PER_LOOK: Final = 3


def find_numbered_layers(styles: Iterable[tuple[str, Hashable]]) -> dict[str, str]:
    """Return the name of the series of each layer that belongs to one, such as "p-0 … p-25".

    The names of the layers of a series differ in one number, and suggest no line type.  If each
    layer has a colour or line style of its own, the layers may be line types and are no series.
    Many layers that share few colours and line styles are no line types.

    Parameters
    ----------
    styles
        Pairs of the name of a layer and the look (colour and line style) of some of its edges.
    """
    series: dict[tuple[str, str], dict[str, set[Hashable]]] = defaultdict(lambda: defaultdict(set))
    for layer, look in styles:
        numbers = _NUMBER.findall(layer)
        if len(numbers) == 1 and name_meaning(layer).kind is None:
            before, after = _NUMBER.split(layer)
            series[before.casefold(), after.casefold()][layer].add(look)
    names: dict[str, str] = {}
    for layers in series.values():
        looks = set().union(*layers.values())
        per_layer = sum(map(len, layers.values())) / len(layers)
        distinguished_by_look = len(looks) > 1 and per_layer >= _LOOKS and len(layers) >= _FEWEST
        many = len(layers) >= max(_FEWEST_PLAIN, _LAYERS_PER_LOOK * len(looks))
        if distinguished_by_look or many:
            ordered = sorted(layers, key=lambda layer: int(_NUMBER.findall(layer)[0]))
            names |= dict.fromkeys(layers, f"{ordered[0]} … {ordered[-1]}")
    return names
