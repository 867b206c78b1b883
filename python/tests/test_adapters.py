"""Meshes of other libraries: there, and back as quads."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import triquad
from surfaces import torus

VERTICES, TRIANGLES = torus(6, 8)
QUADS, _ = triquad.convert(VERTICES, TRIANGLES)
LEFTOVER = TRIANGLES[:3]


def test_trimesh_there_and_back() -> None:
    trimesh = pytest.importorskip("trimesh")
    vertices, triangles = triquad.from_trimesh(trimesh.Trimesh(VERTICES, TRIANGLES, process=False))
    assert np.array_equal(vertices, VERTICES) and np.array_equal(triangles, TRIANGLES)
    assert np.array_equal(triquad.convert(vertices, triangles)[0], QUADS)
    back = triquad.to_trimesh(VERTICES, QUADS)
    assert back.is_watertight and len(back.faces) == len(TRIANGLES) and back.euler_number == 0
    assert np.array_equal(back.vertices, VERTICES)
    with pytest.raises(TypeError, match="^mesh: "):
        triquad.from_trimesh(7)  # type: ignore[arg-type]


def test_pyvista_there_and_back() -> None:
    pyvista = pytest.importorskip("pyvista")
    given = triquad.to_pyvista(VERTICES, TRIANGLES)
    vertices, triangles = triquad.from_pyvista(given)
    assert np.array_equal(triquad.convert(vertices, triangles)[0], QUADS)
    back = triquad.to_pyvista(VERTICES, QUADS, LEFTOVER)
    assert back.n_cells == len(QUADS) + 3 and back.get_cell(0).n_points == 4
    assert np.array_equal(back.faces.reshape(-1)[: 5 * len(QUADS)].reshape(-1, 5)[:, 1:], QUADS)
    with pytest.raises(ValueError, match="^mesh: not all cells are triangles"):
        triquad.from_pyvista(back)
    with pytest.raises(ValueError, match="^mesh: not all cells are triangles"):
        triquad.from_pyvista(pyvista.Line())
    with pytest.raises(TypeError, match="^mesh: "):
        triquad.from_pyvista(VERTICES)  # type: ignore[arg-type]
    sphere = triquad.from_pyvista(pyvista.Icosphere(nsub=2))
    assert triquad.convert(*sphere)[1].genus == 0


def test_meshio_there_and_back(tmp_path: Path) -> None:
    meshio = pytest.importorskip("meshio")
    given = meshio.Mesh(
        VERTICES,
        [("line", [[0, 1]]), ("triangle", TRIANGLES[:40]), ("triangle", TRIANGLES[40:])],
    )
    vertices, triangles = triquad.from_meshio(given)
    assert np.array_equal(triquad.convert(vertices, triangles)[0], QUADS)
    back = triquad.to_meshio(VERTICES, QUADS, LEFTOVER)
    assert [block.type for block in back.cells] == ["quad", "triangle"]
    back.write(tmp_path / "quads.vtk")
    read = meshio.read(tmp_path / "quads.vtk")
    assert np.array_equal(read.get_cells_type("quad"), QUADS)
    with pytest.raises(ValueError, match="^mesh: expected triangles, got cells quad"):
        triquad.from_meshio(back)
    with pytest.raises(TypeError, match="^mesh: "):
        triquad.from_meshio(None)  # type: ignore[arg-type]


@pytest.mark.parametrize("maker", [triquad.to_trimesh, triquad.to_pyvista, triquad.to_meshio])
def test_faces_of_five_corners_are_refused_by_name(maker: object) -> None:
    pytest.importorskip(str(getattr(maker, "__name__")).removeprefix("to_"))
    with pytest.raises(ValueError, match="^faces: expected shape"):
        maker(VERTICES, np.zeros((3, 5), int))  # type: ignore[operator]


@pytest.mark.parametrize("maker", [triquad.to_trimesh, triquad.to_pyvista, triquad.to_meshio])
@pytest.mark.parametrize("index", [-1, len(VERTICES)])
def test_indices_of_no_vertex_reach_no_other_library(maker: object, index: int) -> None:
    pytest.importorskip(str(getattr(maker, "__name__")).removeprefix("to_"))
    wrong = TRIANGLES.copy()
    wrong[[3, 5], 1] = index
    with pytest.raises(triquad.MeshError, match=f"^faces: row 3 has index {index}, ") as refused:
        maker(VERTICES, wrong)  # type: ignore[operator]
    assert (refused.value.element, refused.value.count) == (("face", (3,)), 2)


def test_points_in_the_plane_are_refused() -> None:
    meshio = pytest.importorskip("meshio")
    flat = meshio.Mesh(VERTICES[:, :2], [("triangle", TRIANGLES)])
    with pytest.raises(ValueError, match="^mesh: expected points of shape"):
        triquad.from_meshio(flat)
