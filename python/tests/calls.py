"""Every public function with an array in the place of each argument; what comes back is checked."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import triquad
from surfaces import torus

VERTICES, TRIANGLES = torus(5, 7)
QUADS, _ = triquad.convert(VERTICES, TRIANGLES, "tq")
# The two triangles of the first quad.
LEFTOVER = TRIANGLES[triquad.pair(TRIANGLES)[0][0]]
EDGES = np.array([[0, 1], [1, 2], [2, 3], [3, 0]])

# The right array for each argument; that of `from_...` goes into a mesh of the other library.
RIGHT = {
    "vertices": VERTICES,
    "triangles": TRIANGLES,
    "quads": QUADS,
    "edges": EDGES,
    "keep_edges": TRIANGLES[:4, :2],
    "cost": np.arange(3 * len(TRIANGLES) // 2),
    "costs": np.array([1, 1, 1, 1]),
    "faces": QUADS,
    "leftover": LEFTOVER,
    "mesh": TRIANGLES,
}


def convert(vertices: Any, triangles: Any, **options: Any) -> object:
    quads, report = triquad.convert(vertices, triangles, **options)
    assert 2 * len(quads) + len(report.leftover) == len(triangles)
    assert triquad.check(quads, triangles, report.leftover).quads == len(quads)
    return quads, report.leftover, report.given_up


def pair(triangles: Any) -> object:
    pairs, _ = triquad.pair(triangles)
    assert np.array_equal(np.sort(pairs, axis=None), np.arange(len(triangles)))
    return pairs


def irreducible(triangles: Any) -> object:
    left, report = triquad.irreducible(triangles)
    assert len(left) == report.result_triangles and set(left.flat) <= set(np.ravel(triangles))
    return left


def simplify(vertices: Any, triangles: Any) -> object:
    fewer, left = triquad.simplify(vertices, triangles, 20)
    assert fewer.shape == (20, 3) and triquad.survey(fewer, left).closed
    return fewer, left


def check(quads: Any, triangles: Any, leftover: Any = None) -> object:
    report = triquad.check(quads, triangles, leftover)
    assert (report.quads, report.triangles) == (len(quads), len(() if leftover is None else leftover))
    return report


def survey(vertices: Any, triangles: Any) -> object:
    found = triquad.survey(vertices, triangles)
    assert found.triangles == len(triangles) and found.vertices <= len(vertices)
    return found


def weld(vertices: Any, triangles: Any) -> object:
    kept, corners = triquad.weld(vertices, triangles, 1e-9)
    assert len(kept) <= len(vertices) and len(corners) <= len(triangles)
    assert not corners.size or corners.max() < len(kept)
    return kept, corners


def clean(triangles: Any) -> object:
    left = triquad.clean(triangles)
    assert len({frozenset(corners) for corners in left.tolist()}) == len(left) <= len(triangles)
    return left


def match(edges: Any, costs: Any) -> object:
    matching = triquad.match(edges, costs)
    assert np.array_equal(matching.mates[matching.mates], np.arange(len(matching.mates)))
    return matching.mates, matching.cost


def write(vertices: Any, faces: Any, leftover: Any = None) -> object:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "a.off"
        triquad.write(path, vertices, faces, leftover)
        text = path.read_text().split()
    written = len(faces) + len(() if leftover is None else leftover)
    assert text[:3] == ["OFF", str(len(vertices)), str(written)]
    positions = np.array(text[4 : 4 + 3 * len(vertices)], float)
    assert np.array_equal(positions, np.asarray(vertices, float).ravel(), equal_nan=True)
    return text


def there(library: str, faces: Any) -> object:
    """Put triangles into a mesh of another library, if it takes them, and get them out."""
    module = pytest.importorskip(library)
    makers: dict[str, Callable[[], Any]] = {
        "trimesh": lambda: module.Trimesh(VERTICES, faces, process=False),
        # VTK crashes where the numbers of corners do not add up.
        "pyvista": lambda: module.PolyData.from_regular_faces(VERTICES, faces),
        "meshio": lambda: module.Mesh(VERTICES, [("triangle", faces)]),
    }
    try:
        mesh = makers[library]()
    except Exception:  # whatever the library raises
        mesh = faces
    vertices, triangles = getattr(triquad, f"from_{library}")(mesh)
    assert np.array_equal(vertices, VERTICES) and triangles.shape[1:] == (3,)
    return vertices, triangles


def back(library: str, *arrays: Any) -> object:
    """Make a mesh of another library and get all its cells out."""
    pytest.importorskip(library)
    mesh = getattr(triquad, f"to_{library}")(*arrays)
    if library == "meshio":
        return (mesh.points, *(block.data for block in mesh.cells))
    points = mesh.points if library == "pyvista" else mesh.vertices
    return np.asarray(points), np.asarray(mesh.faces)


# Each argument that is an array, with a call that takes it.
CALLS: dict[str, Callable[[Any], object]] = {
    "convert vertices": lambda x: convert(x, TRIANGLES),
    "convert triangles": lambda x: convert(VERTICES, x),
    "convert keep_edges": lambda x: convert(VERTICES, TRIANGLES, keep_edges=x),
    "convert cost": lambda x: convert(VERTICES, TRIANGLES, cost=x),
    "pair triangles": pair,
    "irreducible triangles": irreducible,
    "simplify vertices": lambda x: simplify(x, TRIANGLES),
    "simplify triangles": lambda x: simplify(VERTICES, x),
    "check quads": lambda x: check(x, TRIANGLES),
    "check triangles": lambda x: check(QUADS, x),
    "check leftover": lambda x: check(QUADS[1:], TRIANGLES, x),
    "survey vertices": lambda x: survey(x, TRIANGLES),
    "survey triangles": lambda x: survey(VERTICES, x),
    "weld vertices": lambda x: weld(x, TRIANGLES),
    "weld triangles": lambda x: weld(VERTICES, x),
    "clean triangles": clean,
    "match edges": lambda x: match(x, [1, 1, 1, 1]),
    "match costs": lambda x: match(EDGES, x),
    "write vertices": lambda x: write(x, TRIANGLES),
    "write faces": lambda x: write(VERTICES, x),
    "write leftover": lambda x: write(VERTICES, QUADS, x),
    "from_trimesh mesh": lambda x: there("trimesh", x),
    "from_pyvista mesh": lambda x: there("pyvista", x),
    "from_meshio mesh": lambda x: there("meshio", x),
    "to_trimesh vertices": lambda x: back("trimesh", x, QUADS),
    "to_trimesh faces": lambda x: back("trimesh", VERTICES, x),
    "to_pyvista vertices": lambda x: back("pyvista", x, QUADS),
    "to_pyvista faces": lambda x: back("pyvista", VERTICES, x),
    "to_pyvista leftover": lambda x: back("pyvista", VERTICES, QUADS, x),
    "to_meshio vertices": lambda x: back("meshio", x, QUADS),
    "to_meshio faces": lambda x: back("meshio", VERTICES, x),
    "to_meshio leftover": lambda x: back("meshio", VERTICES, QUADS, x),
}
