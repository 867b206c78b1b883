"""Closed surfaces as arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Arrays = tuple[NDArray[np.float64], NDArray[Any]]

TETRAHEDRON: Arrays = (
    np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float64),
    np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]),
)


def torus(rows: int, columns: int, seed: int = 0) -> Arrays:
    """Return a torus of 2 * rows * columns triangles with a random diagonal in each cell."""
    rng = np.random.default_rng(seed)
    i, j = (x.ravel() for x in np.mgrid[:rows, :columns])
    u, v = 2 * np.pi * i / rows, 2 * np.pi * j / columns
    vertices = np.column_stack(
        ((2 + np.cos(v)) * np.cos(u), (2 + np.cos(v)) * np.sin(u), np.sin(v))
    )
    vertices += rng.uniform(-0.02, 0.02, vertices.shape)
    at = lambda di, dj: (i + di) % rows * columns + (j + dj) % columns  # noqa: E731
    a, b, c, d = at(0, 0), at(1, 0), at(1, 1), at(0, 1)
    one = np.column_stack((a, b, c, a, c, d))
    other = np.column_stack((a, b, d, b, c, d))
    cells = np.where(rng.random(len(a))[:, None] < 0.5, one, other)
    return vertices, cells.reshape(-1, 3)
