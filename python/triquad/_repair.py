"""Repairs of triangles."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from triquad import _native
from triquad._arrays import check_range, distance_of, index_array, vertices_array


def weld(
    vertices: ArrayLike, triangles: ArrayLike, distance: float = 0.0
) -> tuple[NDArray[np.float64], NDArray[np.uint32]]:
    """Join vertices at equal or nearly equal coordinates, as ``triquad convert --weld`` does.

    Each vertex is joined to the nearest one kept before it, if that is near enough; else it is
    kept. Kept vertices stay in order, each where it was. Triangles that are left with fewer than
    three corners are dropped.

    Parameters
    ----------
    vertices : array_like, shape (n, 3), float64
        Coordinates, in any unit.
    triangles : array_like, shape (m, 3), any integer dtype
        Corners of the triangles, from 0.
    distance : float
        The greatest distance of two vertices that are joined; 0 joins those at equal coordinates.

    Returns
    -------
    vertices : ndarray, shape (k, 3), float64
        The vertices kept.
    triangles : ndarray, shape (l, 3), uint32
        Triangles on them.

    Raises
    ------
    MeshError
        An index is negative or too large.
    TypeError, ValueError
        An argument has the wrong type, shape or value, or no triangle is left.

    Examples
    --------
    >>> import triquad
    >>> vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    >>> joined, triangles = triquad.weld(vertices, [[0, 1, 2], [3, 4, 5]])
    >>> len(joined), triangles.tolist()
    (4, [[0, 1, 2], [1, 3, 2]])
    """
    positions = vertices_array(vertices)
    corners = index_array("triangles", triangles, 3)
    check_range("triangles", corners, len(positions))
    return _native.weld(positions, corners, distance_of("distance", distance))


def clean(triangles: ArrayLike) -> NDArray[np.uint32]:
    """Drop triangles that no surface can have, as ``triquad convert --clean`` does.

    These are triangles with one corner twice, and triangles with the corners of an earlier one. A
    dropped triangle may leave a hole.

    Parameters
    ----------
    triangles : array_like, shape (m, 3), any integer dtype
        Corners of the triangles, from 0.

    Returns
    -------
    triangles : ndarray, shape (k, 3), uint32
        The others, in order.

    Raises
    ------
    MeshError
        An index is negative or too large.
    TypeError, ValueError
        The argument has the wrong type or shape.

    Examples
    --------
    >>> import triquad
    >>> triquad.clean([[0, 1, 2], [1, 1, 2], [2, 1, 0], [0, 1, 3]]).tolist()
    [[0, 1, 2], [0, 1, 3]]
    """
    return _native.clean(index_array("triangles", triangles, 3))
