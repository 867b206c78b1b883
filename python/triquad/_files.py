"""Mesh files."""

from __future__ import annotations

import os

import numpy as np
from numpy.typing import ArrayLike, NDArray

from triquad import _native
from triquad._arrays import (
    check_range,
    distance_of,
    face_array,
    index_array,
    path_of,
    vertices_array,
)


def read(
    path: str | os.PathLike[str],
    *,
    weld: float | None = None,
    clean: bool = False,
    triangulate: bool = False,
) -> tuple[NDArray[np.float64], NDArray[np.uint32]]:
    """Read a mesh file: OBJ, PLY, OFF or STL, each also with .gz.

    Repairs are made in the order of the parameters, as ``triquad convert`` makes them.

    Parameters
    ----------
    path : str or path
        The file. Its extension names the format.
    weld : float, optional
        Join vertices at most so far apart; 0 joins those at equal coordinates.
    clean : bool
        Drop faces that repeat a corner, and faces that repeat an earlier one.
    triangulate : bool
        Cut faces of four or more corners into triangles.

    Returns
    -------
    vertices : ndarray, shape (n, 3), float64
        All vertices, in file order, but for those that were joined to another. Those of STL are
        joined where coordinates are equal.
    faces : ndarray, shape (m, k), uint32
        Corners of the faces, from 0.

    Raises
    ------
    OSError
        The file cannot be opened.
    MeshError
        It is malformed, or faces differ in size; ``element`` has the line or byte.
    TypeError, ValueError
        An argument has the wrong type or value, or ``weld`` leaves no face.

    Examples
    --------
    >>> import triquad, tempfile, os
    >>> path = os.path.join(tempfile.mkdtemp(), "triangle.obj")
    >>> triquad.write(path, [[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    >>> vertices, faces = triquad.read(path)
    >>> faces.tolist()
    [[0, 1, 2]]
    """
    distance = None if weld is None else distance_of("weld", weld)
    return _native.read(path_of(path), distance, bool(clean), bool(triangulate))


def write(
    path: str | os.PathLike[str],
    vertices: ArrayLike,
    faces: ArrayLike,
    leftover: ArrayLike | None = None,
) -> None:
    """Write a mesh file: OBJ, PLY or OFF, each also with .gz.

    Coordinates read back to the same numbers. The file appears when it is complete.

    Parameters
    ----------
    path : str or path
        The file. Its extension names the format.
    vertices : array_like, shape (n, 3), float64
        Coordinates.
    faces : array_like, shape (m, 3) or (m, 4), any integer dtype
        Corners of triangles or quads, from 0.
    leftover : array_like, shape (k, 3), any integer dtype, optional
        Triangles to be written behind the faces.

    Raises
    ------
    OSError
        The file cannot be written.
    MeshError
        The format is not known or not written, or an index is negative or too large.
    TypeError, ValueError
        An argument has the wrong type, shape or value.

    Examples
    --------
    >>> import triquad, tempfile, os
    >>> path = os.path.join(tempfile.mkdtemp(), "square.off")
    >>> triquad.write(path, [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2, 3]])
    >>> open(path).read().split()[:4]
    ['OFF', '4', '1', '0']
    """
    positions = vertices_array(vertices)
    given = face_array(faces)
    check_range("faces", given, len(positions))
    triangles = None
    if leftover is not None:
        triangles = index_array("leftover", leftover, 3)
        check_range("leftover", triangles, len(positions))
    _native.write(path_of(path), positions, given, given.shape[1], triangles)
