"""groups: the equidistants of all regions, one after the other, in columns.

    all paths, and which of them bound a region together -> columns of the results

What shortening can do is done in one go; the others go to ``region`` one by one.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from knifetip.geometry.beside import COLUMNS, FINE, moved
from knifetip.geometry.region import fitting, left_over
from knifetip.geometry.shortened import alone
from knifetip.geometry.transition import MOST
from knifetip.kernels import (
    F64_1,
    F64_2,
    I32_1,
    U8_1,
    OutBool_1,
    OutF64_1,
    OutF64_2,
    OutI32_1,
    kernel,
)


@kernel
def _room(
    start: OutF64_2,
    end: OutF64_2,
    bulge: OutF64_1,
    source: OutI32_1,
    inserted: OutBool_1,
    used: int,
    wanted: int,
) -> tuple[Any, Any, Any, Any, Any]:
    if wanted <= len(bulge):
        return start, end, bulge, source, inserted
    size = 2 * wanted
    s = np.empty((size, 2))
    e = np.empty((size, 2))
    b = np.empty(size)
    o = np.empty(size, np.int32)
    i = np.empty(size, np.bool_)
    s[:used] = start[:used]
    e[:used] = end[:used]
    b[:used] = bulge[:used]
    o[:used] = source[:used]
    i[:used] = inserted[:used]
    return s, e, b, o, i


@kernel
def _longer(column: I32_1) -> Any:
    result = np.empty(2 * len(column), column.dtype)
    result[: len(column)] = column
    return result


@kernel
def all_groups(
    start: F64_2,
    end: F64_2,
    bulge: F64_1,
    first: I32_1,
    member: I32_1,
    members: I32_1,
    signed: F64_1,
    corner: U8_1,
    k: F64_1,
    refuse: bool,
) -> Any:
    """Return start, end, bulge, source, inserted, first, owner, unreached, and a failure.

    ``member`` has the paths in the order of their groups, ``members`` where each group begins;
    ``corner`` and ``k`` are of one length: that of ``bulge``, or 1 where all are alike.
    """
    step = 0 if len(corner) == 1 else 1
    count = len(first) - 1
    most = 0
    for p in range(count):
        most = max(most, first[p + 1] - first[p])
    table = np.empty((most, COLUMNS))
    joint = np.empty(most, np.int64)
    boxes = np.empty((4, 2 * (MOST + 1) * most))
    pair = np.empty((4, 5))
    found = np.empty((4, 4))
    size = 2 * len(bulge) + (MOST + 1) * most + 256
    out_start = np.empty((size, 2))
    out_end = np.empty((size, 2))
    out_bulge = np.empty(size)
    source = np.empty(size, np.int32)
    inserted = np.empty(size, np.bool_)
    out_first = np.empty(count + 16, np.int32)
    owner = np.empty(count + 16, np.int32)
    unreached = np.zeros(count)
    failure = (FINE, 0, 0, 0.0)
    done = 0
    chains = 0
    group = 0
    while True:
        while chains + len(members) - group > len(owner):
            out_first, owner = _longer(out_first), _longer(owner)
        group, done, chains = alone(
            start, end, bulge, first, member, members, group, signed, corner, k, step,
            table, joint, boxes, pair, found, out_start, out_end, out_bulge, source, inserted,
            done, out_first, owner, chains, unreached,
        )  # fmt: skip
        if group == len(members) - 1:
            break
        paths = member[members[group] : members[group + 1]]
        group += 1
        rows = 0
        for path in paths:
            rows += first[path + 1] - first[path]
        if rows == 0:
            continue
        path = paths[0]
        if done + (MOST + 1) * rows > len(out_bulge):
            # It may only have been this that was in the way: try again.
            out_start, out_end, out_bulge, source, inserted = _room(
                out_start, out_end, out_bulge, source, inserted, done, done + (MOST + 1) * rows
            )
            if len(paths) == 1:
                group -= 1
                continue
        if signed[path] == 0.0:
            for path in paths:
                a, b = first[path], first[path + 1]
                if a == b:
                    continue
                code, row = moved(start, end, bulge, a, b, 0.0, table, 0)
                if code != FINE:
                    failure = (code, row, row, 0.0)
                    break
                if chains + 2 > len(owner):
                    out_first, owner = _longer(out_first), _longer(owner)
                out_first[chains] = done
                owner[chains] = path
                chains += 1
                for i in range(a, b):
                    out_start[done] = start[i]
                    out_end[done] = end[i]
                    out_bulge[done] = bulge[i]
                    source[done] = i
                    inserted[done] = False
                    done += 1
            if failure[0] != FINE:
                break
            continue
        line, tag, bounds, more, area, twice, code, row, other, depth = fitting(
            start, end, bulge, first, paths, signed[path], corner, k, step, refuse, pair, found
        )
        if code != FINE:
            failure = (code, row, other, depth)
            break
        if twice:
            area = left_over(
                start, end, bulge, first, paths, signed[path], line, bounds, more, area, pair, found
            )
        unreached[path] = max(area, 0.0)
        if more == 0:
            continue
        out_start, out_end, out_bulge, source, inserted = _room(
            out_start, out_end, out_bulge, source, inserted, done, done + bounds[more]
        )
        while chains + more + 1 > len(owner):
            out_first, owner = _longer(out_first), _longer(owner)
        for c in np.argsort(tag[bounds[:more], 2], kind="mergesort"):
            out_first[chains] = done
            owner[chains] = tag[bounds[c], 2]
            chains += 1
            for r in range(bounds[c], bounds[c + 1]):
                out_start[done, 0] = line[r, 0]
                out_start[done, 1] = line[r, 1]
                out_end[done, 0] = line[r, 2]
                out_end[done, 1] = line[r, 3]
                out_bulge[done] = line[r, 4]
                source[done] = tag[r, 0]
                inserted[done] = tag[r, 1] == 1
                done += 1
    out_first[chains] = done
    return (
        out_start[:done],
        out_end[:done],
        out_bulge[:done],
        source[:done],
        inserted[:done],
        out_first[: chains + 1],
        owner[:chains],
        unreached,
        failure,
    )
