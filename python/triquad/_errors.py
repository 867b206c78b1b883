"""Exceptions, and the functions with which the native half makes them."""

from __future__ import annotations

import errno
import os
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Element(NamedTuple):
    """An element of a mesh or file.

    >>> import triquad
    >>> print(triquad.Element("edge", (3, 4)))
    edge (3, 4)
    """

    kind: str
    """``mesh``, ``vertex``, ``edge``, ``face``; of files ``file``, ``line`` or ``byte``."""

    indices: tuple[int, ...]
    """Index of the vertex or face, or of the two ends of the edge, from 0; lines from 1."""

    def __str__(self) -> str:
        if not self.indices:
            return f"the {self.kind}"
        return f"{self.kind} {self.indices[0] if len(self.indices) == 1 else self.indices}"


class MeshError(ValueError):
    """A mesh breaks a law, or a mesh file cannot be read.

    >>> import triquad
    >>> try:
    ...     triquad.pair([[0, 1, 2]])
    ... except triquad.MeshError as error:
    ...     print(error.law, error.element, error.count)
    boundary-edge edge (0, 1) 3
    """

    law: str
    """Name of the law, as ``triquad info`` prints it."""

    element: Element
    """The first element that breaks it."""

    count: int
    """Number of elements that break it."""

    remedy: str
    """What to do about it; empty if nothing is known."""

    def __init__(
        self,
        message: str,
        law: str = "",
        element: Element = Element("mesh", ()),
        count: int = 1,
        remedy: str = "",
    ) -> None:
        super().__init__(message)
        self.law = law
        self.element = element
        self.count = count
        self.remedy = remedy


class InfeasibleError(ValueError):
    """A graph has no matching that pairs every node without a price.

    >>> import triquad
    >>> try:
    ...     triquad.match([[0, 1], [0, 2], [0, 3]], [1, 1, 1])
    ... except triquad.InfeasibleError as error:
    ...     print(error.barrier)
    [0]
    """

    barrier: NDArray[np.int64]
    """The proof: without these nodes more odd components are left than there are such nodes."""

    def __init__(self, message: str, barrier: NDArray[np.int64]) -> None:
        super().__init__(message, barrier)
        self.barrier = barrier

    def __str__(self) -> str:
        return str(self.args[0])


def mesh_error(
    message: str, law: str, element: tuple[str, list[int]], count: int, remedy: str
) -> MeshError:
    """Make a MeshError."""
    kind, indices = element
    return MeshError(message, law, Element(kind, tuple(indices)), count, remedy)


def infeasible_error(barrier: list[int]) -> InfeasibleError:
    """Make an InfeasibleError."""
    message = "edges: no matching pairs every node; give a price for nodes that may stay unpaired"
    return InfeasibleError(message, np.array(barrier, dtype=np.int64))


def file_error(code: int | str | None, text: str, path: str | Path) -> OSError:
    """Make an OSError of the subclass that belongs to the code, a number or its name."""
    number = getattr(errno, code) if isinstance(code, str) else code
    if number is None:
        return OSError(f"{os.fspath(path)}: {text}")
    return OSError(number, os.strerror(number), os.fspath(path))
