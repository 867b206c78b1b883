"""Checks of arguments. Every error names the argument."""

from __future__ import annotations

import operator
import os
import sys
from typing import Any, SupportsFloat, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike, NDArray

from triquad._errors import Element, MeshError


def vertices_array(value: ArrayLike) -> NDArray[Any]:
    """Return coordinates as an array of shape (n, 3)."""
    array = _table("vertices", value, "n", 3, "fiu")
    return array if array.dtype in (np.float64, np.float32) else array.astype(np.float64)


def index_array(name: str, value: ArrayLike, width: int) -> NDArray[Any]:
    """Return indices as an array of shape (m, width)."""
    return _table(name, value, "m", width, "iu")


def face_array(value: ArrayLike) -> NDArray[Any]:
    """Return corners of triangles or quads as an array of shape (m, 3) or (m, 4)."""
    try:
        width = np.shape(value)[-1:]
    except (TypeError, ValueError):
        width = ()
    return index_array("faces", value, 3 if width == (3,) else 4)


def check_range(name: str, array: NDArray[Any], vertices: int) -> None:
    """Check that indices are those of vertices."""
    if not array.size or int(array.min()) >= 0 and int(array.max()) < vertices:
        return
    rows, columns = np.nonzero((array < 0) | (array >= vertices))
    index = int(array[rows[0], columns[0]])
    number = "1 vertex" if vertices == 1 else f"{vertices} vertices"
    problem = "is negative" if index < 0 else f"is too large for {number} (from 0)"
    remedy = "number vertices from 0 to len(vertices) - 1"
    raise MeshError(
        f"{name}: row {rows[0]} has index {index}, which {problem}; {remedy}",
        "index-out-of-range",
        Element("face", (int(rows[0]),)),
        len(rows),
        remedy,
    )


def path_of(value: str | os.PathLike[str]) -> str:
    """Return a path as a string."""
    try:
        path = os.fspath(value)
    except TypeError:
        raise TypeError(f"path: expected a path, got {type(value).__name__}") from None
    if not isinstance(path, str):
        raise TypeError(f"path: expected a string or a path, got {type(path).__name__}")
    if "\0" in path:
        raise ValueError("path: a zero character is in no path")
    return path


def integer_array(name: str, value: ArrayLike, dtype: type[np.signedinteger]) -> NDArray[Any]:
    """Return integers as a contiguous array of shape (m,) of a dtype that holds them all."""
    array = np.asarray([], dtype) if _is_empty_list(value) else _array(name, value, "iu")
    if array.ndim != 1:
        raise ValueError(f"{name}: expected shape (m,), got {array.shape}")
    limits = np.iinfo(dtype)
    for extreme in (array.min(), array.max()) if array.size else ():
        if not limits.min <= int(extreme) <= limits.max:
            raise ValueError(f"{name}: {extreme} does not fit {limits.bits} bits with a sign")
    return np.ascontiguousarray(array, dtype=dtype)


def real(name: str, value: float, least: float, most: float) -> float:
    """Return a number from least to most."""
    if isinstance(value, bool) or not isinstance(value, (SupportsFloat, SupportsIndex)):
        raise TypeError(f"{name}: expected a number, got {type(value).__name__}")
    number = float(value)
    if not least <= number <= most:
        raise ValueError(f"{name}: expected a number from {least:g} to {most:g}, got {value}")
    return number


def distance_of(name: str, value: float) -> float:
    """Return a distance, which is finite and not negative."""
    return real(name, value, 0, sys.float_info.max)


def count(name: str, value: SupportsIndex, limit: int = 2**64, least: int = 0) -> int:
    """Return an integer from least to limit - 1."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: expected an integer, got {type(value).__name__}") from None
    if not least <= number < limit:
        raise ValueError(f"{name}: expected an integer from {least} to {limit - 1}, got {number}")
    return number


def name_of(argument: str, value: str) -> str:
    """Return a name, which must be a string."""
    if not isinstance(value, str):
        raise TypeError(f"{argument}: expected a string, got {type(value).__name__}")
    return value


def _table(name: str, value: ArrayLike, rows: str, width: int, kinds: str) -> NDArray[Any]:
    if _is_empty_list(value):
        return np.empty((0, width), np.int64)
    array = _array(name, value, kinds)
    if array.ndim != 2 or array.shape[1] != width:
        raise ValueError(f"{name}: expected shape ({rows}, {width}), got {array.shape}")
    return array


def _array(name: str, value: ArrayLike, kinds: str) -> NDArray[Any]:
    try:
        array = np.asarray(value)
    except (TypeError, ValueError) as error:
        raise type(error)(f"{name}: {error}") from None
    if array.dtype.kind not in kinds:
        wanted = "numbers" if "f" in kinds else "integers"
        raise TypeError(f"{name}: expected an array of {wanted}, got dtype {array.dtype}")
    if not array.dtype.isnative or not array.flags.aligned:
        array = array.astype(array.dtype.newbyteorder("="))
    return array


def _is_empty_list(value: ArrayLike) -> bool:
    """Return whether there is neither a dtype nor a width."""
    return isinstance(value, (list, tuple)) and len(value) == 0
