from typing import Any

import numpy as np
from numpy.typing import NDArray

def convert(
    vertices: NDArray[Any], triangles: NDArray[Any], options: dict[str, Any]
) -> dict[str, Any]: ...
def pair(
    triangles: NDArray[Any], options: dict[str, Any]
) -> tuple[NDArray[np.uint32], str, str]: ...
def irreducible(
    triangles: NDArray[Any], algorithm: str, order: str, seed: int
) -> tuple[NDArray[np.uint32], str]: ...
def simplify(
    vertices: NDArray[Any], triangles: NDArray[Any], vertex_count: int
) -> tuple[NDArray[np.float64], NDArray[np.uint32]]: ...
def check(
    quads: NDArray[Any], triangles: NDArray[Any], leftover: NDArray[Any], open: bool
) -> str: ...
def survey(vertices: NDArray[Any], triangles: NDArray[Any]) -> str: ...
def solve(
    edges: NDArray[Any], costs: NDArray[np.int64], nodes: int | None, price: int | None
) -> tuple[
    NDArray[np.int64],
    int,
    NDArray[np.int64] | list[int],
    NDArray[np.int64],
    NDArray[np.int64],
    NDArray[np.int64] | list[int],
]: ...
def read(path: str, triangulate: bool) -> tuple[NDArray[np.float64], NDArray[np.uint32]]: ...
def write(
    path: str,
    vertices: NDArray[Any],
    faces: NDArray[Any],
    arity: int,
    leftover: NDArray[Any] | None,
) -> None: ...
