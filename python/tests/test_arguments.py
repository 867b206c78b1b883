"""Arrays of all kinds as arguments: the right ones work, the others are refused by name."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import triquad
from surfaces import TETRAHEDRON, torus

VERTICES, TRIANGLES = torus(5, 7)
QUADS, _ = triquad.convert(VERTICES, TRIANGLES)
EDGES = np.array([[0, 1], [1, 2], [2, 3], [3, 0]])

# Each argument that is an array, with a call that takes it.
CALLS: dict[str, Callable[[Any], object]] = {
    "convert vertices": lambda x: triquad.convert(x, TRIANGLES),
    "convert triangles": lambda x: triquad.convert(VERTICES, x),
    "pair triangles": triquad.pair,
    "irreducible triangles": triquad.irreducible,
    "simplify vertices": lambda x: triquad.simplify(x, TRIANGLES, 20),
    "simplify triangles": lambda x: triquad.simplify(VERTICES, x, 20),
    "check quads": lambda x: triquad.check(x, TRIANGLES),
    "check leftover": lambda x: triquad.check(QUADS, TRIANGLES, x),
    "convert keep_edges": lambda x: triquad.convert(VERTICES, TRIANGLES, keep_edges=x),
    "convert cost": lambda x: triquad.convert(VERTICES, TRIANGLES, cost=x),
    "check triangles": lambda x: triquad.check(QUADS, x),
    "survey vertices": lambda x: triquad.survey(x, TRIANGLES),
    "survey triangles": lambda x: triquad.survey(VERTICES, x),
    "match edges": lambda x: triquad.match(x, [1, 1, 1, 1]),
    "match costs": lambda x: triquad.match(EDGES, x),
    "write vertices": lambda x: triquad.write("/nonexistent/a.obj", x, TRIANGLES),
    "write faces": lambda x: triquad.write("/nonexistent/a.obj", VERTICES, x),
    "write leftover": lambda x: triquad.write("/nonexistent/a.obj", VERTICES, QUADS, x),
}
# The right array for each.
RIGHT = {
    "vertices": VERTICES,
    "triangles": TRIANGLES,
    "quads": QUADS,
    "edges": EDGES,
    "keep_edges": TRIANGLES[:4, :2],
    "cost": np.arange(3 * len(TRIANGLES) // 2),
    "costs": np.array([1, 1, 1, 1]),
    "faces": QUADS,
    "leftover": TRIANGLES[:2],
}


def shapeless(right: np.ndarray) -> Iterator[Any]:
    """Things that are no array of the right shape and kind."""
    yield from (None, "mesh", 7, {"a": 1}, [[0, 1], [2]], [[0, 1, "a"]], object())
    yield from (right.astype(complex), right.astype(str), right.astype(object), right > 0)
    yield from (right[None], np.zeros((4, 0)), np.zeros((3, 3, 3)), right.astype("datetime64[s]"))
    if right.ndim == 2:
        yield from (right.ravel(), right[:, :2].repeat(4, 1), right[:, :1], right.T)
    if right.dtype.kind in "iu":
        yield from (right.astype(float), right * 0.5)


@pytest.mark.parametrize("call", CALLS)
def test_arrays_of_the_wrong_shape_or_kind_are_refused_by_name(call: str) -> None:
    argument = call.split()[1]
    for wrong in shapeless(RIGHT[argument]):
        if argument in ("leftover", "keep_edges") and wrong is None:
            continue
        with pytest.raises((TypeError, ValueError), match=f"^{argument}: "):
            CALLS[call](wrong)


def wrong_values(right: np.ndarray) -> Iterator[Any]:
    """Arrays of the right shape with values that cannot be."""
    for value in (-1, -(2**31), 2**31 - 1, 2**32 - 2, 2**32 - 1, 2**32, 2**63 - 1, -(2**63)):
        array = right.astype(np.int64)
        array[1, 1] = value
        yield array
    array = right.astype(np.uint64)
    array[1, 1] = 2**64 - 1
    yield array


INDEXED = [call for call in CALLS if RIGHT[call.split()[1]].ndim == 2 and "vert" not in call]


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


def random_array(rng: np.random.Generator) -> Any:
    """An array that may be all right, or nearly so, or not at all."""
    kind = rng.integers(6)
    if kind == 0:
        shape = tuple(rng.integers(0, 5, rng.integers(0, 4)))
        dtype = rng.choice(["i1", "i8", "u4", "f8", "f4", "?", "c16", "O"])
        return (rng.normal(0, 3, shape) * 2).astype(dtype)
    right = rng.choice(["triangles", "quads", "edges", "vertices", "faces", "leftover"])
    array = RIGHT[str(right)].copy()
    if kind == 1:
        array[rng.integers(len(array)), rng.integers(array.shape[1])] = rng.integers(-2, 40)
    if kind == 2:
        array = array[rng.permutation(len(array))[: rng.integers(len(array))]]
    if kind == 3:
        array = rng.integers(0, 6, (rng.integers(1, 12), array.shape[1]))
    if kind == 4:
        array = array.astype(rng.choice(["i8", "u4", "f8"]))[:: rng.choice([-1, 1, 2])]
    return array


@pytest.mark.parametrize("call", CALLS)
def test_500_random_arrays_are_taken_or_refused(call: str) -> None:
    rng = np.random.default_rng(list(CALLS).index(call))
    for _ in range(500):
        try:
            CALLS[call](random_array(rng))
        except (TypeError, ValueError, FileNotFoundError):
            pass


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
    with pytest.raises(ValueError, match="^faces: index 4 is too large for 4 vertices"):
        triquad.write(tmp_path / "b.obj", TETRAHEDRON[0], TETRAHEDRON[1] + 1)
    assert not (tmp_path / "b.obj").exists()


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
