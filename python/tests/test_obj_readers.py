"""Quads with textures, normals, groups and materials, as VTK and MeshLab read them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from surfaces import torus

VERTICES, TRIANGLES = torus(12, 16)
POSITIONS = "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in VERTICES.tolist())
NORMALS = POSITIONS.replace("v ", "vn ")
HEAD = "mtllib absent.mtl\no torus\n" + POSITIONS
# One coordinate a vertex, then three a face: every edge is a seam where these are used.
SHARED = "".join(f"vt {x / 9!r} {y / 9!r}\n" for x, y, _ in VERTICES.tolist())
ISLANDS = "".join(f"vt {k % 7 / 7!r} {k % 5 / 5!r}\n" for k in range(3 * len(TRIANGLES)))
TEXTURE = SHARED + ISLANDS


def plain(v: int, _: int) -> str:
    return f"{v}"


def shared(v: int, _: int) -> str:
    return f"{v}/{v}"


def islands(v: int, corner: int) -> str:
    return f"{v}/{len(VERTICES) + corner + 1}"


def normals(v: int, _: int) -> str:
    return f"{v}//{v}"


def everything(v: int, corner: int) -> str:
    return f"{islands(v, corner)}/{v}"


FORMS: list[Callable[[int, int], str]] = [plain, shared, islands, normals, everything]


def line(place: int, form: Callable[[int, int], str]) -> str:
    corners = (form(int(v) + 1, 3 * place + k) for k, v in enumerate(TRIANGLES[place]))
    return "f " + " ".join(corners) + "\n"


def mesh(form_of: Callable[[int], Callable[[int, int], str]], section: str = "") -> str:
    """Write a torus whose faces have the forms `form_of` their places, sections before every 50th."""
    faces = (
        (section.format(place) if place % 50 == 0 else "") + line(place, form_of(place))
        for place in range(len(TRIANGLES))
    )
    return HEAD + TEXTURE + NORMALS + "".join(faces)


MESHES = {form.__name__: mesh(lambda _, form=form: form) for form in FORMS} | {
    "mixed forms": mesh(lambda place: FORMS[place * 7 % 5]),
    "materials": mesh(lambda _: islands, "usemtl m{0}\n"),
    "groups": mesh(lambda _: everything, "g part {0}\ns {0}\n"),
    "objects": mesh(lambda place: FORMS[place // 50 % 5], "o part{0}\nusemtl m{0}\ns off\n"),
    "two layouts": mesh(lambda place: islands if place < 100 else shared),
}
OPTIONS = {"best": [], "seams kept": ["--keep-seams"], "mixed": ["--quad-dominant", "0.1"]}


@pytest.mark.parametrize("options", OPTIONS.values(), ids=OPTIONS)
@pytest.mark.parametrize("text", MESHES.values(), ids=MESHES)
def test_every_face_of_a_textured_mesh_is_read(
    text: str, options: list[str], tmp_path: Path, command: Callable[..., str]
) -> None:
    pyvista = pytest.importorskip("pyvista")
    (tmp_path / "in.obj").write_text(text)
    out = tmp_path / "out.obj"
    command("convert", tmp_path / "in.obj", "-o", out, *options)
    sizes = [len(row.split()) - 1 for row in out.read_text().splitlines() if row[:2] == "f "]
    assert sum(size - 2 for size in sizes) == len(TRIANGLES)
    read = pyvista.read(out)
    assert [read.get_cell(k).n_points for k in range(read.n_cells)] == sizes


@pytest.mark.parametrize("text", MESHES.values(), ids=MESHES)
def test_meshlab_reads_every_face_of_a_textured_mesh(
    text: str, tmp_path: Path, command: Callable[..., str]
) -> None:
    pymeshlab = pytest.importorskip("pymeshlab", exc_type=ImportError)
    (tmp_path / "in.obj").write_text(text)
    out = tmp_path / "out.obj"
    command("convert", tmp_path / "in.obj", "-o", out)
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(out))
    faces = meshes.current_mesh().polygonal_face_list()
    assert len(faces) == len(TRIANGLES) // 2 and {len(face) for face in faces} == {4}
