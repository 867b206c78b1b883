"""Irreducible and simplified triangulations."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from triquad import _native
from triquad._arrays import count, index_array, name_of, vertices_array


@dataclass(frozen=True)
class IrreducibleReport:
    """Counts of a contraction, with the names of ``triquad irreducible --stats``.

    >>> import triquad
    >>> _, report = triquad.irreducible([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    >>> report.contractions, report.to_dict()["result_vertices"]
    (0, 4)
    """

    vertices: int
    edges: int
    triangles: int
    genus: int
    components: int
    result_vertices: int
    result_edges: int
    result_triangles: int
    contractions: int
    link_condition_tests: int
    edges_tested_more_than_once: int

    def to_dict(self) -> dict[str, Any]:
        """Return all fields by name."""
        return asdict(self)


def irreducible(
    triangles: ArrayLike, algorithm: str = "rs", *, order: str = "file", seed: int = 0
) -> tuple[NDArray[np.uint32], IrreducibleReport]:
    """Contract edges of a triangulation of closed surfaces until none can be contracted.

    A component without handles becomes a tetrahedron, one of genus g > 0 has at most 26 g - 4
    vertices left. Vertices that are left stay where they are.

    Parameters
    ----------
    triangles : array_like, shape (m, 3), any integer dtype
        Corners of the triangles, from 0.
    algorithm : str
        ``rs`` (Ramaswami and Siqueira), ``schipper`` or ``brute-force``.
    order : str
        The order in which ``rs`` processes vertices: ``file`` (as numbered) or ``random``.
    seed : int, from 0 to 2**64 - 1
        Seed of ``brute-force`` and of the random order.

    Returns
    -------
    triangles : ndarray, shape (k, 3), uint32
        The triangles left, with the vertex numbers of the input.
    report : IrreducibleReport
        Counts.

    Raises
    ------
    MeshError
        The triangles are no triangulation of closed surfaces.
    TypeError, ValueError
        An argument has the wrong type, shape or value.

    Examples
    --------
    >>> import triquad
    >>> octahedron = [[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2],
    ...               [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]]
    >>> left, report = triquad.irreducible(octahedron)
    >>> left.shape, report.contractions
    ((4, 3), 2)
    """
    left, report = _native.irreducible(
        index_array("triangles", triangles, 3),
        name_of("algorithm", algorithm),
        name_of("order", order),
        count("seed", seed),
    )
    return left, IrreducibleReport(**json.loads(report))


def simplify(
    vertices: ArrayLike, triangles: ArrayLike, vertex_count: int
) -> tuple[NDArray[np.float64], NDArray[np.uint32]]:
    """Simplify a triangulation of closed surfaces to an exact number of vertices.

    Edges are contracted in order of quadric error where that keeps the topology.

    Parameters
    ----------
    vertices : array_like, shape (n, 3), float64
        Coordinates, in any unit.
    triangles : array_like, shape (m, 3), any integer dtype
        Corners of the triangles, from 0.
    vertex_count : int
        The number of vertices to be left.

    Returns
    -------
    vertices : ndarray, shape (vertex_count, 3), float64
        Coordinates of new vertices.
    triangles : ndarray, shape (k, 3), uint32
        Triangles on them.

    Raises
    ------
    MeshError
        The triangles are no triangulation of closed surfaces, or a coordinate is not finite.
    TypeError, ValueError
        An argument has the wrong type, shape or value, or that many vertices cannot be left.

    Examples
    --------
    >>> import triquad
    >>> vertices = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]]
    >>> octahedron = [[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2],
    ...               [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]]
    >>> fewer, triangles = triquad.simplify(vertices, octahedron, 5)
    >>> fewer.shape, triangles.shape
    ((5, 3), (6, 3))
    """
    return _native.simplify(
        vertices_array(vertices),
        index_array("triangles", triangles, 3),
        count("vertex_count", vertex_count, 2**32),
    )
