"""Repairs: results are those of the command, and every remedy that is named helps."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import triquad
from surfaces import TETRAHEDRON, Arrays, torus

Command = Callable[..., str]


def split(distance: float) -> Arrays:
    """Return a torus whose triangles have corners of their own, at most so far apart."""
    vertices, triangles = torus(6, 7)
    apart = np.random.default_rng(1).uniform(0, distance / 4, (triangles.size, 3))
    return vertices[triangles.ravel()] + apart, np.arange(triangles.size).reshape(-1, 3)


@pytest.mark.parametrize("distance", [0.0, 1e-6])
def test_welded_meshes_are_those_of_the_command(
    distance: float, command: Command, tmp_path: Path
) -> None:
    given, ours, theirs = (tmp_path / name for name in ("a.obj", "b.obj", "c.obj"))
    vertices, triangles = split(distance)
    triquad.write(given, vertices, triangles)
    vertices, triangles = triquad.weld(vertices, triangles, distance)
    assert vertices.shape == (42, 3) and triquad.survey(vertices, triangles).closed
    assert all(map(np.array_equal, triquad.read(given, weld=distance), (vertices, triangles)))
    triquad.write(ours, vertices, triquad.convert(vertices, triangles)[0])
    command("convert", given, "-o", theirs, "--weld", distance)
    assert ours.read_bytes() == theirs.read_bytes()


def test_a_file_is_repaired_in_the_order_of_the_command(command: Command, tmp_path: Path) -> None:
    given, ours, theirs = (tmp_path / name for name in ("a.obj", "b.obj", "c.obj"))
    # A prism of quads and two triangles: corners split, one face twice, one of a single edge.
    corners = "0 0 0|1 0 0|0 1 0|0 0 1|1 0 1|0 1 1|0 0 0".split("|")
    faces = "1 3 2|4 5 6|7 2 5 4|2 3 6 5|3 1 4 6|7 2 3|1 2 2".split("|")
    lines = [f"v {corner}" for corner in corners] + [f"f {face}" for face in faces]
    given.write_text("\n".join(lines) + "\n")
    vertices, triangles = triquad.read(given, weld=0, clean=True, triangulate=True)
    assert (len(vertices), len(triangles)) == (6, 8)
    triquad.write(ours, vertices, triquad.convert(vertices, triangles)[0])
    command("convert", given, "-o", theirs, "--weld", "--clean", "--triangulate")
    assert ours.read_bytes() == theirs.read_bytes()


def test_remedies_that_name_a_function_help() -> None:
    vertices, triangles = split(0)
    with pytest.raises(triquad.MeshError, match="use triquad.weld") as refused:
        triquad.convert(vertices, triangles)
    assert refused.value.law == "boundary-edge"
    assert triquad.convert(*triquad.weld(vertices, triangles))[1].genus == 1
    vertices, triangles = TETRAHEDRON
    for extra, law in (([1, 1, 2], "repeated-corner"), ([2, 3, 1], "duplicate-face")):
        broken = np.vstack((triangles, [extra]))
        violations = triquad.survey(vertices, broken).violations
        remedies = {violation.law: violation.remedy for violation in violations}
        assert remedies[law].startswith("triquad.clean drops ")
        assert np.array_equal(triquad.clean(broken), triangles)


def test_the_genus_of_a_survey_is_that_with_holes_filled() -> None:
    vertices, triangles = torus(5, 6)
    for removed in ([], [7], [7, 40]):
        found = triquad.survey(vertices, np.delete(triangles, removed, axis=0))
        assert (found.genus, found.boundary_loops) == (1, len(removed))
    strip = [[i, (i + 1) % 5, (i + 2) % 5] for i in range(5)]
    found = triquad.survey(vertices, strip)
    assert (found.genus, found.non_orientable_genus) == (None, 1)
    found = triquad.survey(vertices, np.vstack((triangles, triangles[:1])))
    assert (found.genus, found.non_orientable_genus) == (None, None)


def test_turned_faces_are_turned_back_by_the_survey() -> None:
    vertices, triangles = torus(5, 6)
    triangles[[3, 8]] = triangles[[3, 8], ::-1]
    flip = triquad.survey(vertices, triangles).faces_to_flip
    triangles[flip] = triangles[flip, ::-1]
    assert triquad.survey(vertices, triangles).violations == []


@pytest.mark.parametrize("wrong", [-1, np.nan, np.inf, "0", True, [0.0]])
def test_distances_that_are_none_are_refused_by_name(wrong: Any, tmp_path: Path) -> None:
    with pytest.raises((TypeError, ValueError), match="^distance: "):
        triquad.weld(*TETRAHEDRON, wrong)
    triquad.write(tmp_path / "a.off", *TETRAHEDRON)
    with pytest.raises((TypeError, ValueError), match="^weld: "):
        triquad.read(tmp_path / "a.off", weld=wrong)


def test_a_distance_that_leaves_no_face_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="^distance: 10.* leaves no face; give a smaller distance"):
        triquad.weld(*TETRAHEDRON, 10)
    triquad.write(tmp_path / "a.off", *TETRAHEDRON)
    with pytest.raises(ValueError, match="^weld: 10.* leaves no face"):
        triquad.read(tmp_path / "a.off", weld=10)
