"""Arrays of all kinds as arguments: the right ones work, the others are refused by name."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import triquad
from calls import CALLS, RIGHT, TRIANGLES, VERTICES
from surfaces import TETRAHEDRON

QUADS, _ = triquad.convert(VERTICES, TRIANGLES)


def wrong_values(right: np.ndarray) -> Iterator[Any]:
    """Arrays of the right shape with values that cannot be."""
    for value in (-1, -(2**31), 2**31 - 1, 2**32 - 2, 2**32 - 1, 2**32, 2**63 - 1, -(2**63)):
        array = right.astype(np.int64)
        array[1, 1] = value
        yield array
    array = right.astype(np.uint64)
    array[1, 1] = 2**64 - 1
    yield array


# Meshes of other libraries may hold what they like; it is refused when they are converted.
INDEXED = [
    call
    for call in CALLS
    if RIGHT[call.split()[1]].ndim == 2 and not call.endswith(("vertices", "mesh"))
]


@pytest.mark.parametrize("call", INDEXED)
def test_indices_of_no_vertex_are_refused_by_name(call: str) -> None:
    argument = call.split()[1]
    for wrong in wrong_values(RIGHT[argument]):
        if call == "survey triangles" and 0 <= int(wrong[1, 1]) < 2**32:
            laws = [violation.law for violation in triquad.survey(VERTICES, wrong).violations]
            assert laws[0] == "index-out-of-range"
            continue
        with pytest.raises(ValueError, match=f"^{argument}: "):
            CALLS[call](wrong)


@pytest.mark.parametrize("call", ["convert vertices", "simplify vertices"])
@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_coordinates_that_are_no_numbers_are_refused(call: str, value: float, dtype: type) -> None:
    wrong = VERTICES.astype(dtype)
    wrong[[4, 9], 1] = value
    with pytest.raises(triquad.MeshError, match="^vertices: vertex 4 ") as refused:
        CALLS[call](wrong)
    error = refused.value
    assert (error.law, error.element, error.count) == ("non-finite-coordinate", ("vertex", (4,)), 2)
    assert error.remedy and error.remedy in str(error)


@pytest.mark.parametrize("dtype", [np.int64, np.int32, np.uint8])
def test_a_mesh_without_triangles_is_refused(dtype: type) -> None:
    for empty in (np.empty((0, 3), dtype), []):
        for call in ("convert triangles", "pair triangles", "irreducible triangles"):
            reason = "^triangles: the mesh has no faces"
            with pytest.raises(triquad.MeshError, match=reason) as refused:
                CALLS[call](empty)
            assert (refused.value.law, refused.value.element.kind) == ("empty-mesh", "mesh")
    assert triquad.survey([], []).violations[0].law == "empty-mesh"
    assert triquad.match([], []).cost == 0


def test_the_law_the_first_element_and_the_number_of_others_are_named() -> None:
    with pytest.raises(triquad.MeshError) as refused:
        triquad.convert(VERTICES, TRIANGLES[2:])
    error = refused.value
    assert (error.law, error.element.kind, error.count) == ("boundary-edge", "edge", 4)
    first, second = error.element.indices
    assert str(error).startswith(f"triangles: edge [{first}, {second}] is a boundary edge")
    outside = TRIANGLES.copy()
    outside[3, 2] = len(VERTICES)
    with pytest.raises(triquad.MeshError) as refused:
        triquad.convert(VERTICES, outside)
    assert (refused.value.law, refused.value.element) == ("index-out-of-range", ("face", (3,)))
    absent = len(VERTICES)
    assert f"does not exist (vertex {absent} of {absent})" in str(refused.value)
    violations = triquad.survey(VERTICES, outside).violations
    assert [violation.absent_vertex for violation in violations[:2]] == [absent, None]


@pytest.mark.parametrize("dtype", "i1 u1 i2 u2 i4 u4 i8 u8 >i4 >u8 q Q l L".split())
def test_indices_may_have_any_integer_dtype(dtype: str) -> None:
    assert np.array_equal(triquad.convert(VERTICES, TRIANGLES.astype(dtype))[0], QUADS)


def same_values(right: np.ndarray) -> Iterator[np.ndarray]:
    """Arrays of the same values in other places of memory."""
    frozen = right.copy()
    frozen.flags.writeable = False
    padded = np.zeros((2 * len(right), 7), right.dtype)
    padded[::2, 1:7:2] = right
    unaligned = np.frombuffer(b"." + right.tobytes(), np.uint8)[1:].view(right.dtype)
    yield from (frozen, np.asfortranarray(right), padded[::2, 1:7:2], right[::-1].copy()[::-1])
    yield from (unaligned.reshape(right.shape), right.astype(right.dtype.newbyteorder(">")))
    yield from (right.view(type("Subclass", (np.ndarray,), {})), np.ma.masked_array(right))


def test_arrays_may_be_read_only_strided_unaligned_or_swapped() -> None:
    for vertices in same_values(VERTICES):
        assert np.array_equal(triquad.convert(vertices, TRIANGLES)[0], QUADS)
    for triangles in same_values(TRIANGLES):
        assert np.array_equal(triquad.convert(VERTICES, triangles)[0], QUADS)
        assert triquad.check(QUADS, triangles).quads == len(QUADS)
    lists = triquad.convert(VERTICES.tolist(), TRIANGLES.tolist())
    assert np.array_equal(lists[0], QUADS)


def test_arguments_are_left_as_they_were() -> None:
    vertices, triangles = VERTICES.copy(), TRIANGLES.copy()
    quads, _ = triquad.convert(vertices, triangles)
    triquad.simplify(vertices, triangles, 10)
    assert np.array_equal(vertices, VERTICES) and np.array_equal(triangles, TRIANGLES)
    quads[:] = 0
    assert quads.dtype == np.uint32 and quads.flags.c_contiguous and quads.flags.writeable


def test_files_are_refused_with_their_place(tmp_path: Path) -> None:
    path = tmp_path / "a.obj"
    path.write_text("v 0 0 0\nv 0 x 0\n")
    with pytest.raises(triquad.MeshError) as refused:
        triquad.read(path)
    assert (refused.value.law, refused.value.element) == ("malformed-file", ("line", (2,)))
    with pytest.raises(FileNotFoundError) as missing:
        triquad.read(tmp_path / "b.obj")
    assert missing.value.filename == str(tmp_path / "b.obj")
    with pytest.raises(triquad.MeshError, match="unknown mesh format"):
        triquad.read(tmp_path / "b.step")
    with pytest.raises(triquad.MeshError, match="read, not written"):
        triquad.write(tmp_path / "b.stl", *TETRAHEDRON)
    with pytest.raises(triquad.MeshError, match="^faces: row 1 has index 4, .*4 vertices") as refused:
        triquad.write(tmp_path / "b.obj", TETRAHEDRON[0], TETRAHEDRON[1] + 1)
    assert not (tmp_path / "b.obj").exists()
    assert (refused.value.law, refused.value.element) == ("index-out-of-range", ("face", (1,)))
    with pytest.raises(ValueError, match="^path: "):
        triquad.read("a\0.obj")


@pytest.mark.parametrize("name", ["a.obj", "a.ply", "a.off", "a.obj.gz"])
def test_files_read_back_to_the_same_arrays(name: str, tmp_path: Path) -> None:
    triquad.write(tmp_path / name, VERTICES, QUADS)
    vertices, quads = triquad.read(tmp_path / name)
    assert np.array_equal(vertices, VERTICES) and np.array_equal(quads, QUADS)
    triquad.write(tmp_path / name, VERTICES, QUADS, leftover=TRIANGLES[:2])
    with pytest.raises(triquad.MeshError, match="faces differ in size"):
        triquad.read(tmp_path / name)
    _, triangles = triquad.read(tmp_path / name, triangulate=True)
    assert np.array_equal(triangles[-2:], TRIANGLES[:2])
