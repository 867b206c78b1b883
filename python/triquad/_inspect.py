"""The check of quads, and the survey of a mesh."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from typing import Any

from numpy.typing import ArrayLike

from triquad import _native
from triquad._arrays import index_array, vertices_array
from triquad._errors import Element


@dataclass(frozen=True)
class CheckReport:
    """Counts of quads that passed their check.

    >>> import triquad
    >>> triquad.check([[0, 2, 1, 3], [1, 2, 0, 3]],
    ...               [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]).euler_characteristic
    2
    """

    quads: int
    triangles: int
    """Triangles left over."""
    vertices: int
    """Vertices that the faces use."""
    degree_two_vertices: int
    """Vertices where two quads share two edges: legal and common."""
    euler_characteristic: int

    def to_dict(self) -> dict[str, Any]:
        """Return all fields by name."""
        return asdict(self)


@dataclass(frozen=True)
class Violation:
    """A law that a mesh breaks.

    >>> import triquad
    >>> vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    >>> for violation in triquad.survey(vertices, [[0, 1, 2]]).violations:
    ...     print(violation.law, violation.count)
    boundary-edge 3
    """

    law: str
    element: Element
    """The first element that breaks the law."""
    count: int
    """Number of elements that break it."""
    faces: list[int]
    """Faces at the element, if that is an edge, a vertex or a face like an earlier one."""
    absent_vertex: int | None
    """The vertex that the face names and that does not exist."""
    remedy: str
    message: str


@dataclass(frozen=True)
class Survey:
    """Counts of a mesh, whatever state it is in, and every law that it breaks.

    >>> import triquad
    >>> vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    >>> found = triquad.survey(vertices, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    >>> found.closed, found.genus, found.violations
    (True, 0, [])
    """

    vertices: int
    """Vertices that a triangle uses."""
    unreferenced_vertices: int
    edges: int
    triangles: int
    euler_characteristic: int
    genus: int | None
    """Genus with holes filled, summed over the two-sided components; None if the mesh is not one of
    surfaces, or some are one-sided and no other has handles."""
    non_orientable_genus: int | None
    """Cross-caps, if the mesh is one of surfaces of which some are one-sided."""
    components: int
    boundary_loops: int
    orientable: bool
    closed: bool
    """True if every edge belongs to two triangles."""
    violations: list[Violation]
    """Every broken law once, the most basic one first."""
    faces_to_flip: list[int]
    """Triangles to flip so that neighbours agree: ``triangles[flip] = triangles[flip, ::-1]``."""

    def to_dict(self) -> dict[str, Any]:
        """Return all fields by name, violations as dictionaries."""
        return asdict(self)


def check(
    quads: ArrayLike,
    triangles: ArrayLike,
    leftover: ArrayLike | None = None,
    *,
    open: bool = False,
) -> CheckReport:
    """Check that quads are a quadrangulation of triangles on the same vertices.

    Every quad must be the union of two triangles across their common edge and every triangle in
    one quad or left over. Without triangles left over and without ``open``, the quads must also be
    closed and oriented and have the Euler characteristic of the triangles.

    Parameters
    ----------
    quads : array_like, shape (k, 4), any integer dtype
        Corners of the quads, from 0.
    triangles : array_like, shape (m, 3), any integer dtype
        Corners of the triangles that were paired. Of ``lrs`` that is ``report.triangulation``.
    leftover : array_like, shape (l, 3), any integer dtype, optional
        Triangles left over: ``report.leftover``.
    open : bool
        Allow surfaces with boundary and one-sided ones.

    Returns
    -------
    CheckReport
        Counts.

    Raises
    ------
    MeshError
        The quads fail; ``law`` and ``element`` name the first defect. Faces are counted through
        the quads and on through the triangles left over.
    TypeError, ValueError
        An argument has the wrong type or shape.

    Examples
    --------
    >>> import triquad
    >>> triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
    >>> triquad.check([[0, 2, 1, 3], [1, 2, 0, 3]], triangles).quads
    2
    """
    counts = _native.check(
        index_array("quads", quads, 4),
        index_array("triangles", triangles, 3),
        index_array("leftover", [] if leftover is None else leftover, 3),
        bool(open),
    )
    return CheckReport(**json.loads(counts))


def survey(vertices: ArrayLike, triangles: ArrayLike) -> Survey:
    """Examine a mesh and find every law of triangulations of closed surfaces that it breaks.

    Parameters
    ----------
    vertices : array_like, shape (n, 3), float64
        Coordinates, in any unit; NaN is allowed here.
    triangles : array_like, shape (m, 3), any integer dtype
        Corners of the triangles, from 0.

    Returns
    -------
    Survey
        Counts and violations.

    Raises
    ------
    MeshError
        An index is negative or beyond 2**32.
    TypeError, ValueError
        An argument has the wrong type or shape.

    Examples
    --------
    >>> import triquad
    >>> vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    >>> found = triquad.survey(vertices, [[0, 2, 1], [0, 1, 3], [1, 2, 3]])
    >>> found.boundary_loops, found.violations[0].remedy.split(",")[0]
    (1, 'close the holes')
    """
    found = json.loads(
        _native.survey(vertices_array(vertices), index_array("triangles", triangles, 3))
    )
    for violation in found["violations"]:
        kind, indices = violation["element"]
        violation["element"] = Element(kind, tuple(indices))
    violations = [Violation(**violation) for violation in found.pop("violations")]
    return Survey(**found, violations=violations)
