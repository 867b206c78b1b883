"""Random and malformed arrays in every argument of every function, and eight threads at once."""

from __future__ import annotations

import inspect
import pickle
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import triquad
from calls import CALLS, RIGHT, TRIANGLES, VERTICES

RANDOM = 500
MALFORMED = 50
# It takes no arrays; its files are below.
READ = "read"


def test_every_argument_that_is_an_array_has_a_call() -> None:
    functions = {name for name in triquad.__all__ if inspect.isfunction(getattr(triquad, name))}
    arrays = {
        f"{name} {parameter.name}"
        for name in functions
        for parameter in inspect.signature(getattr(triquad, name)).parameters.values()
        if "ArrayLike" in parameter.annotation or parameter.name == "mesh"
    }
    assert arrays == set(CALLS)
    assert {call.split()[0] for call in CALLS} == functions - {READ}


def random_array(rng: np.random.Generator, right: np.ndarray) -> Any:
    """An array that may be all right, or nearly so, or not at all."""
    kind = rng.integers(7)
    if kind == 0:
        shape = tuple(rng.integers(0, 5, rng.integers(0, 4)))
        dtype = rng.choice(["i1", "i8", "u4", "f8", "f4", "?", "c16", "O"])
        return (rng.normal(0, 3, shape) * 2).astype(dtype)
    if kind == 1:
        right = list(RIGHT.values())[rng.integers(len(RIGHT))]
    array = right.copy()
    if kind == 2:
        array[tuple(map(rng.integers, array.shape))] = rng.integers(-2, 40)
    if kind == 3:
        array = array[rng.permutation(len(array))[: rng.integers(len(array))]]
    if kind == 4:
        array = rng.integers(0, 6, (rng.integers(1, 12), *array.shape[1:]))
    if kind == 5:
        array = array.astype(rng.choice(["i8", "u4", "f8"]))[:: rng.choice([-1, 1, 2])]
    return array


def is_named(call: str, error: Exception) -> bool:
    """Return whether an error begins with the name of an argument."""
    function = getattr(triquad, call.split()[0])
    return str(error).split(": ")[0] in inspect.signature(function).parameters


@pytest.mark.parametrize("call", CALLS)
def test_500_random_arrays_are_taken_or_refused_by_name(call: str) -> None:
    rng = np.random.default_rng(list(CALLS).index(call))
    taken = refused = 0
    for _ in range(RANDOM):
        array = random_array(rng, RIGHT[call.split()[1]])
        try:
            CALLS[call](array)
            taken += 1
        except (TypeError, ValueError) as error:
            assert is_named(call, error), error
            refused += 1
    assert taken >= 25 and refused >= 25, (taken, refused)


def malformed(argument: str) -> Iterator[Any]:
    """Things that are no array of the right shape and kind."""
    right = RIGHT[argument]
    nothing = [] if argument in ("leftover", "keep_edges") else [None]
    yield from (*nothing, "mesh", b"mesh", 7, 7.5, 1j, True, {"a": 1}, {1, 2}, object(), len)
    yield from ([[0, 1], [2]], [[0, 1, "a"]], [[0, 1, None]], [None], ["a"], [[[0]]], [object()])
    kinds = "c8 c16 ? S8 U8 O M8[s] m8[s]" + " f2 f4 f8 g" * (right.dtype.kind in "iu")
    for dtype in kinds.split():
        yield from (right.astype(dtype), right.astype(dtype)[::-1], right.astype(dtype)[:0])
    yield from (np.zeros(len(right), "i8,i8,i8"), right[None], right[..., None], right[:1][None])
    if right.ndim == 1:
        yield from (right[0], right[:, None], right[:-1], right.repeat(2), np.append(right, 1))
        return
    yield from (right.ravel(), right.T)
    widths = {3, 4} if argument == "faces" else {right.shape[1]}
    for width in set(range(9)) - widths:
        yield from (np.zeros((rows, width), right.dtype) for rows in (len(right), 0))


@pytest.mark.parametrize("call", CALLS)
def test_50_malformed_arrays_are_refused_by_name(call: str) -> None:
    function, argument = call.split()
    given = list(malformed(argument))
    assert len(given) >= MALFORMED
    for wrong in given:
        with pytest.raises((TypeError, ValueError), match=f"^{argument}: "):
            # Libraries make something of many of them; what is no mesh of theirs is refused here.
            if function.startswith("from_"):
                pytest.importorskip(function.removeprefix("from_"))
                getattr(triquad, function)(wrong)
            else:
                CALLS[call](wrong)


def test_500_random_files_and_50_malformed_ones_are_taken_or_refused(tmp_path: Path) -> None:
    rng = np.random.default_rng(1)
    names = ("a.obj", "a.off", "a.ply")
    sound = []
    for name in names:
        triquad.write(tmp_path / name, VERTICES, TRIANGLES)
        sound.append((tmp_path / name).read_bytes())
    taken = refused = 0
    for turn in range(RANDOM):
        text = bytearray(sound[turn % 3])
        for place in rng.integers(0, len(text), rng.integers(0, 3)):
            text[place] = rng.choice(list(b"09-. \nfv\xff"))
        (tmp_path / names[turn % 3]).write_bytes(text)
        try:
            vertices, faces = triquad.read(tmp_path / names[turn % 3])
            assert vertices.shape[1:] == (3,) and faces.ndim == 2
            taken += 1
        except triquad.MeshError as error:
            assert error.law and error.element.kind in ("file", "line", "byte", "face", "vertex")
            refused += 1
    assert taken >= 25 and refused >= 25, (taken, refused)
    for turn in range(MALFORMED):
        name, text = names[turn % 3], sound[turn % 3]
        (tmp_path / name).write_bytes(text[: len(text) * turn // MALFORMED] + b"\nf 0 x\n")
        with pytest.raises(triquad.MeshError):
            triquad.read(tmp_path / name)


@pytest.mark.parametrize("wrong", [7, None, 0.5, [], b"a.obj", object()])
def test_paths_of_the_wrong_type_are_refused_by_name(wrong: Any) -> None:
    with pytest.raises(TypeError, match="^path: "):
        triquad.read(wrong)
    with pytest.raises(TypeError, match="^path: "):
        triquad.write(wrong, VERTICES, TRIANGLES)


@pytest.mark.parametrize("function", sorted({call.split()[0] for call in CALLS} | {READ}))
def test_eight_threads_at_once_get_what_one_gets(function: str, tmp_path: Path) -> None:
    calls = {call: CALLS[call] for call in CALLS if call.split()[0] == function}
    triquad.write(tmp_path / "a.off", VERTICES, TRIANGLES)
    if function == READ:
        calls = {"read path": lambda _: triquad.read(tmp_path / "a.off")}

    def results(_: int) -> bytes:
        return pickle.dumps([calls[call](RIGHT.get(call.split()[1])) for call in calls])

    alone = results(0)
    with ThreadPoolExecutor(8) as pool:
        assert all(together == alone for together in pool.map(results, range(64)))
