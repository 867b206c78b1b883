"""Meshes of trimesh, PyVista and meshio; each is imported when it is needed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from triquad._arrays import check_range, face_array, index_array, vertices_array

if TYPE_CHECKING:
    import meshio
    import pyvista
    import trimesh

Arrays = tuple[NDArray[Any], NDArray[Any]]


def from_trimesh(mesh: trimesh.Trimesh) -> Arrays:
    """Return vertices (n, 3) and triangles (m, 3) of a trimesh.Trimesh, not copied.

    trimesh merges vertices of equal coordinates unless it is told not to (``process=False``).

    Raises
    ------
    TypeError
        ``mesh`` is something else.
    ValueError
        Its arrays have other shapes.

    Examples
    --------
    >>> import triquad
    >>> import trimesh
    >>> vertices, triangles = triquad.from_trimesh(trimesh.creation.box())
    >>> triquad.convert(vertices, triangles)[0].shape
    (6, 4)
    """
    import trimesh

    if not isinstance(mesh, trimesh.Trimesh):
        raise TypeError(f"mesh: expected a trimesh.Trimesh, got {type(mesh).__name__}")
    return _triangles(mesh.vertices, mesh.faces)


def to_trimesh(vertices: ArrayLike, faces: ArrayLike) -> trimesh.Trimesh:
    """Make a trimesh.Trimesh of triangles (m, 3). trimesh has no quads: those it cuts in two.

    Vertices keep their numbers.

    Raises
    ------
    MeshError
        An index is that of no vertex.
    TypeError, ValueError
        An argument has the wrong type or shape.

    Examples
    --------
    >>> import triquad
    >>> import trimesh
    >>> vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    >>> triquad.to_trimesh(vertices, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]).is_watertight
    True
    """
    import trimesh

    positions, corners, _ = _checked(vertices, faces)
    if corners.shape[1] == 4:
        corners = corners[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)
    return trimesh.Trimesh(positions, corners.astype(np.int64), process=False)


def from_pyvista(mesh: pyvista.PolyData) -> Arrays:
    """Return vertices (n, 3) and triangles (m, 3) of a pyvista.PolyData of triangles.

    Raises
    ------
    TypeError
        ``mesh`` is something else.
    ValueError
        It has other cells than triangles.

    Examples
    --------
    >>> import triquad
    >>> import pyvista
    >>> vertices, triangles = triquad.from_pyvista(pyvista.Tetrahedron())
    >>> triquad.convert(vertices, triangles)[0].shape
    (2, 4)
    """
    import pyvista

    if not isinstance(mesh, pyvista.PolyData):
        raise TypeError(f"mesh: expected a pyvista.PolyData, got {type(mesh).__name__}")
    cells = np.asarray(mesh.faces)
    if mesh.n_cells != len(cells) // 4 or not (cells[::4] == 3).all() or len(cells) % 4:
        raise ValueError("mesh: not all cells are triangles; use mesh.triangulate()")
    return _triangles(mesh.points, cells.reshape(-1, 4)[:, 1:])


def to_pyvista(
    vertices: ArrayLike, faces: ArrayLike, leftover: ArrayLike | None = None
) -> pyvista.PolyData:
    """Make a pyvista.PolyData of triangles (m, 3) or quads (m, 4), and triangles left over.

    Raises
    ------
    MeshError
        An index is that of no vertex.
    TypeError, ValueError
        An argument has the wrong type or shape.

    Examples
    --------
    >>> import triquad
    >>> import pyvista
    >>> vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    >>> triquad.to_pyvista(vertices, [[0, 1, 2, 3]]).n_cells
    1
    """
    import pyvista

    positions, *given = _checked(vertices, faces, leftover)
    counted = [np.insert(array.astype(np.int64), 0, array.shape[1], axis=1) for array in given]
    cells = np.concatenate([array.ravel() for array in counted])
    return pyvista.PolyData(positions, faces=cells)


def from_meshio(mesh: meshio.Mesh) -> Arrays:
    """Return vertices (n, 3) and triangles (m, 3) of a meshio.Mesh of triangles.

    Cells of no or one dimension (vertices and lines) are left out.

    Raises
    ------
    TypeError
        ``mesh`` is something else.
    ValueError
        It has other faces than triangles, or coordinates in the plane.

    Examples
    --------
    >>> import triquad
    >>> import meshio
    >>> vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    >>> cells = [("triangle", [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])]
    >>> vertices, triangles = triquad.from_meshio(meshio.Mesh(vertices, cells))
    >>> triquad.convert(vertices, triangles)[0].shape
    (2, 4)
    """
    import meshio

    if not isinstance(mesh, meshio.Mesh):
        raise TypeError(f"mesh: expected a meshio.Mesh, got {type(mesh).__name__}")
    blocks = [block for block in mesh.cells if block.dim > 1]
    others = sorted({block.type for block in blocks} - {"triangle"})
    if others:
        raise ValueError(f"mesh: expected triangles, got cells {', '.join(others)}")
    triangles = [_triangles(mesh.points, block.data)[1] for block in blocks]
    return _triangles(mesh.points, np.concatenate([np.empty((0, 3), np.int64), *triangles]))


def to_meshio(
    vertices: ArrayLike, faces: ArrayLike, leftover: ArrayLike | None = None
) -> meshio.Mesh:
    """Make a meshio.Mesh with cells ``quad`` of quads (m, 4) or ``triangle`` of triangles (m, 3).

    Triangles left over become a block of cells of their own.

    Raises
    ------
    MeshError
        An index is that of no vertex.
    TypeError, ValueError
        An argument has the wrong type or shape.

    Examples
    --------
    >>> import triquad
    >>> import meshio
    >>> vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    >>> triquad.to_meshio(vertices, [[0, 1, 2, 3]]).cells[0].type
    'quad'
    """
    import meshio

    positions, given, triangles = _checked(vertices, faces, leftover)
    cells = [("quad" if given.shape[1] == 4 else "triangle", given)]
    if len(triangles):
        cells.append(("triangle", triangles))
    return meshio.Mesh(positions, cells)


def _triangles(points: ArrayLike, corners: ArrayLike) -> Arrays:
    """Return what a mesh of another library holds, if that is a mesh of triangles in space."""
    arrays = np.asarray(points), np.asarray(corners)
    for name, array in zip(("points", "triangles"), arrays):
        if array.ndim != 2 or array.shape[1] != 3:
            raise ValueError(f"mesh: expected {name} of shape (n, 3), got {array.shape}")
    return arrays


def _checked(
    vertices: ArrayLike, faces: ArrayLike, leftover: ArrayLike | None = None
) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    """Return arrays of the right shapes, with indices that other libraries can rely on."""
    positions, given = vertices_array(vertices), face_array(faces)
    triangles = index_array("leftover", [] if leftover is None else leftover, 3)
    check_range("faces", given, len(positions))
    check_range("leftover", triangles, len(positions))
    return positions, given, triangles
