"""
Functions behind the package `triquad`; not to be called directly.
"""

from numpy import float64, int64, uint32
from numpy.typing import NDArray
from os import PathLike
from typing import Any, SupportsFloat, SupportsIndex

__all__ = ["check", "clean", "convert", "irreducible", "pair", "read", "simplify", "solve", "survey", "weld", "write"]

def check(quads: NDArray[Any], triangles: NDArray[Any], leftover: NDArray[Any], open: bool) -> str:
    """
    Checks quads, and triangles left over, against triangles on the same vertices. Returns counts as
    JSON. With `open` the surface may have a boundary or one side.
    """

def clean(triangles: NDArray[Any]) -> NDArray[uint32]:
    """
    Drops degenerate triangles, and those that repeat an earlier one. Returns the others.
    """

def convert(vertices: NDArray[Any], triangles: NDArray[Any], options: "dict[str, Any]") -> "dict[str, Any]":
    """
    Converts arrays.
    """

def irreducible(triangles: NDArray[Any], algorithm: str, order: str, seed: SupportsIndex) -> tuple[NDArray[uint32], str]:
    """
    Contracts edges until none can be. Returns triangles on the vertices of the input, and counts.
    """

def pair(triangles: NDArray[Any], options: "dict[str, Any]") -> tuple[NDArray[uint32], str, str]:
    """
    Pairs triangles without coordinates; row by row the lower and the upper triangle of a pair.
    """

def read(path: str | PathLike[str], weld: SupportsFloat | SupportsIndex | None, clean: bool, triangulate: bool) -> tuple[NDArray[float64], NDArray[uint32]]:
    """
    Reads a mesh file and repairs it, in this order. Returns positions and faces of one size.
    """

def simplify(vertices: NDArray[Any], triangles: NDArray[Any], vertex_count: SupportsIndex) -> tuple[NDArray[float64], NDArray[uint32]]:
    """
    Simplifies to a number of vertices. Returns the vertices and triangles left.
    """

def solve(edges: NDArray[Any], costs: NDArray[Any], nodes: SupportsIndex | None, price: SupportsIndex | None) -> tuple[NDArray[int64], int, NDArray[int64] | list[int], NDArray[int64], NDArray[int64], NDArray[int64] | list[int]]:
    """
    Finds a perfect matching of least cost and verifies its certificate.
    """

def survey(vertices: NDArray[Any], triangles: NDArray[Any]) -> str:
    """
    Counts a mesh and the laws that it breaks. Returns JSON.
    """

def weld(vertices: NDArray[Any], triangles: NDArray[Any], distance: SupportsFloat | SupportsIndex) -> tuple[NDArray[float64], NDArray[uint32]]:
    """
    Joins vertices at most `distance` apart. Returns the vertices left and triangles on them.
    """

def write(path: str | PathLike[str], vertices: NDArray[Any], faces: NDArray[Any], arity: SupportsIndex, leftover: NDArray[Any] | None) -> None:
    """
    Writes a mesh file of triangles or quads, and triangles left over behind them.
    """
