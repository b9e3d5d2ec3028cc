"""Pack numeric columns and their metadata into one block of bytes, and unpack such a block.

A browser can use the columns of a block as typed arrays without copying them.  Layout of a block,
little-endian throughout::

    4 bytes   b"KTIP"
    uint32    length of the header in bytes
    header    JSON in UTF-8, padded with spaces so that the data starts at a multiple of 8:
              {"columns": [{"name", "dtype", "shape", "offset"}, …], "meta": {…}}
    data      each column at a multiple of 8; ``offset`` counts from the start of the data

The ``dtype`` of a column is ``<f8``, ``<f4``, ``<i4`` or ``|u1``.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

MAGIC = b"KTIP"
_DTYPES = {"f": "<f8", "i": "<i4", "u": "|u1"}


def pack_columns(columns: Mapping[str, NDArray[Any]], meta: Mapping[str, object]) -> bytes:
    """Return columns and metadata as one block of bytes.

    Parameters
    ----------
    columns
        Arrays of any shape, by name; float32 is kept, other floats become float64, signed integers
        int32, and unsigned integers uint8.
    meta
        JSON data; all numbers must be finite.

    Raises
    ------
    ValueError
        A number of the metadata is infinite or NaN.
    """
    descriptions: list[dict[str, object]] = []
    data = bytearray()
    for name, column in columns.items():
        dtype = "<f4" if column.dtype == np.float32 else _DTYPES[column.dtype.kind]
        array = np.ascontiguousarray(column, dtype=dtype)
        descriptions.append(
            {
                "name": name,
                "dtype": array.dtype.str,
                "shape": list(array.shape),
                "offset": len(data),
            }
        )
        data += array.tobytes()
        data += bytes(-len(data) % 8)
    header = json.dumps(
        {"columns": descriptions, "meta": meta}, ensure_ascii=False, allow_nan=False
    )
    text = header.encode("utf-8", "replace")
    text += b" " * (-(8 + len(text)) % 8)
    return MAGIC + struct.pack("<I", len(text)) + text + bytes(data)


def unpack_columns(block: bytes) -> tuple[dict[str, NDArray[Any]], dict[str, Any]]:
    """Return the columns of a block by name, as read-only views of its bytes, and its metadata.

    Raises
    ------
    ValueError
        The block does not begin with ``KTIP``.
    """
    if block[:4] != MAGIC:
        raise ValueError("these bytes do not begin with KTIP")
    (length,) = struct.unpack_from("<I", block, 4)
    header = json.loads(block[8 : 8 + length])
    columns = {
        column["name"]: np.frombuffer(
            block,
            dtype=column["dtype"],
            count=int(np.prod(column["shape"], dtype=np.int64)),
            offset=8 + length + column["offset"],
        ).reshape(column["shape"])
        for column in header["columns"]
    }
    return columns, header["meta"]
