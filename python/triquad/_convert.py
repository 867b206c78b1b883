"""Conversion of triangles to quads."""

from __future__ import annotations

import json
from dataclasses import dataclass, field, fields
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from triquad import _native
from triquad._arrays import (
    count,
    index_array,
    integer_array,
    name_of,
    real,
    vertices_array,
)


@dataclass(frozen=True)
class Report:
    """Counts, quality and times of a conversion; times in seconds.

    The fields have the names of ``triquad convert --stats``. Those that a conversion does not
    have are None. ``str(report)`` is the summary that the command prints.

    >>> import triquad
    >>> _, report = triquad.pair([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    >>> report.triangles, report.to_dict()["quads"]
    (4, 2)
    """

    algorithm: str
    augmentation: str
    seed: int
    vertices: int
    """Vertices that a triangle uses."""
    edges: int
    triangles: int
    genus: int
    """Genus, summed over the components."""
    components: int
    quads: int
    degree_two_vertices: int
    """Vertices where two quads share two edges."""
    unpaired_triangles: int
    """Triangles that the algorithm left unpaired, before the augmentation."""
    paired_percent: float
    edge_flips: int
    """Edges of the triangles paired that the input does not have; 0 but for ``lrs``."""
    augmenting_paths: int
    build_seconds: float
    pairing_seconds: float
    augmentation_seconds: float
    total_seconds: float
    check_seconds: float
    augmenting_path_length_mean: float
    augmenting_path_length_max: int
    augmentation_triangles_visited: int
    shuffle_seconds: float = 0.0
    """The part of the pairing in which the order of triangles or edges is drawn."""
    lrs_variant: str | None = None
    lrs_order: str | None = None
    boundary_loops: int | None = None
    """Boundary loops, if the surface was open or one-sided."""
    non_orientable_genus: int | None = None
    """Cross-caps of one-sided components, if there are any."""
    leftover_triangles: int | None = None
    """Triangles left over, if some might have been."""
    proved_fewest: bool | None = None
    kept_edges: int | None = None
    """Edges to keep, if any were asked for."""
    given_up_edges: int | None = None
    """Those of them that were given up, as few as can be."""
    total_cost: int | None = None
    """The least total cost, of ``best``."""
    proved_least: bool | None = None
    cost_seconds: float | None = None
    quality_minimum: float | None = None
    """Least scaled Jacobian of the quads, from -1 to 1."""
    quality_mean: float | None = None
    folded_quads: int | None = None
    """Quads of scaled Jacobian 0 and less."""
    quality_histogram: list[int] | None = None
    """Quads in 20 classes of scaled Jacobian, of equal width from -1 to 1."""
    sharp_edges: int | None = None
    sharp_edges_kept: int | None = None
    leftover: NDArray[np.uint32] = field(
        default_factory=lambda: np.empty((0, 3), np.uint32), repr=False, compare=False
    )
    """Triangles that are in no quad, ``(k, 3)``; none on a closed surface unless asked for."""
    given_up: NDArray[np.uint32] = field(
        default_factory=lambda: np.empty((0, 2), np.uint32), repr=False, compare=False
    )
    """Edges to keep that lie inside a quad, ``(k, 2)``."""
    triangulation: NDArray[np.uint32] | None = field(default=None, repr=False, compare=False)
    """The triangles that were paired, ``(m, 3)``, if ``lrs`` flipped edges."""
    summary: str = field(default="", repr=False, compare=False)
    record: dict[str, Any] = field(default_factory=dict, repr=False, compare=False)
    """What the command writes as JSON."""

    def __str__(self) -> str:
        return self.summary

    def to_dict(self) -> dict[str, Any]:
        """Return what the command writes as JSON: all fields but arrays and those that are None."""
        return dict(self.record)

    @classmethod
    def _of(cls, record: str, **others: Any) -> Report:
        """Make a report of JSON and what is not in it."""
        values = json.loads(record)
        names = {f.name for f in fields(cls)}
        known = {name: value for name, value in values.items() if name in names}
        return cls(**known, **others, record=values)


def convert(
    vertices: ArrayLike,
    triangles: ArrayLike,
    algorithm: str = "best",
    *,
    keep_sharp: float | None = None,
    keep_edges: ArrayLike | None = None,
    strict: bool = False,
    open: bool = False,
    quad_dominant: float | None = None,
    cost: str | ArrayLike = "default",
    augmentation: str = "local",
    orient: bool = False,
    seed: int = 0,
    threads: int | None = None,
) -> tuple[NDArray[np.uint32], Report]:
    """Convert a triangulation to quads on the same vertices.

    Every quad is the union of two triangles. The result is checked before it is returned, and
    equals that of ``triquad convert`` with the same options.

    Parameters
    ----------
    vertices : array_like, shape (n, 3), float64
        Coordinates, in any unit. Vertices that no triangle uses are allowed.
    triangles : array_like, shape (m, 3), any integer dtype
        Corners of the triangles, counter-clockwise seen from one side, from 0.
    algorithm : str
        ``best`` (the least total cost, proved), ``tq`` (fastest), ``sg``, ``velho``, ``ps``, ``ds``,
        ``gw``, ``lrs`` or ``lrs few-flips`` (flips edges).
    keep_sharp : float, degrees, optional
        Lay no quad across an edge at which the surface bends by more. As few edges as can be are
        given up so that all triangles are paired. ``best`` only.
    keep_edges : array_like, shape (k, 2), any integer dtype, optional
        Edges that no quad shall lie across either. ``best`` only.
    strict : bool
        Give up none of the edges to keep; the fewest triangles are left over instead.
    open : bool
        Allow surfaces with boundary and one-sided ones. The fewest triangles are left over.
        ``best``, ``tq``, ``ps``, ``sg`` and ``velho`` only.
    quad_dominant : float, optional
        Leave triangles wherever a pair would cost more than twice this price; 1 is the price of a
        flat quad with a corner of 180 degrees, and the command's usual price is 0.35. With
        (1 - J) / 2 no quad has a scaled Jacobian below J. ``best`` only.
    cost : str or array_like, shape (e,), any integer dtype
        The cost of a quad that ``best`` minimises the sum of: ``default``, ``shape``, or one
        integer of 32 bits for each edge, in the order in which the triangles first pass them.
    augmentation : str
        ``local``, ``tarjan`` or ``rebuild``: completes the pairing of other algorithms.
    orient : bool
        Flip triangles first where neighbours disagree on orientation.
    seed : int, from 0 to 2**64 - 1
        Seed of the random choices of ``sg`` and ``ps``.
    threads : int, optional
        Number of threads, by default one for each core. The result does not depend on it.

    Returns
    -------
    quads : ndarray, shape (m/2, 4), uint32
        Corners of the quads, indices of rows of ``vertices``. Triangles left over, if any, are
        ``report.leftover``.
    report : Report
        Counts, quality and times.

    Raises
    ------
    MeshError
        The triangles are no triangulation of closed surfaces (or open ones, with ``open``), or a
        coordinate is not finite.
    TypeError, ValueError
        An argument has the wrong type, shape or value.

    Examples
    --------
    >>> import triquad
    >>> vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    >>> triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
    >>> quads, report = triquad.convert(vertices, triangles, seed=7)
    >>> quads.shape, report.proved_least
    ((2, 4), True)
    """
    if strict and keep_sharp is None and keep_edges is None:
        raise ValueError("strict: there are no edges to keep; add keep_sharp or keep_edges")
    options = _options(algorithm, augmentation, orient, seed, threads)
    options["open"] = bool(open)
    options["strict"] = bool(strict)
    options["cost"] = cost if isinstance(cost, str) else integer_array("cost", cost, np.int32)
    if keep_sharp is not None:
        options["keep_sharp"] = real("keep_sharp", keep_sharp, 0, 180)
    if keep_edges is not None:
        options["keep_edges"] = index_array("keep_edges", keep_edges, 2)
    if quad_dominant is not None:
        options["quad_dominant"] = real("quad_dominant", quad_dominant, -1e300, 1e300)
    converted = _native.convert(
        vertices_array(vertices), index_array("triangles", triangles, 3), options
    )
    quads = converted.pop("quads")
    return quads, Report._of(converted.pop("report"), **converted)


def pair(
    triangles: ArrayLike,
    algorithm: str = "tq",
    *,
    augmentation: str = "local",
    orient: bool = False,
    seed: int = 0,
    threads: int | None = None,
) -> tuple[NDArray[np.uint32], Report]:
    """Pair up the triangles of closed surfaces, without coordinates.

    Parameters
    ----------
    triangles : array_like, shape (m, 3), any integer dtype
        Corners of the triangles, from 0.
    algorithm : str
        ``tq`` (fastest), ``sg``, ``ps``, ``ds`` or ``gw``.
    augmentation, orient, seed, threads
        As for `convert`.

    Returns
    -------
    pairs : ndarray, shape (m/2, 2), uint32
        Rows of ``triangles`` that make one quad, the lower one first and in order. The quads of
        `convert` come in the same order.
    report : Report
        Counts and times.

    Raises
    ------
    MeshError
        The triangles are no triangulation of closed surfaces.
    TypeError, ValueError
        An argument has the wrong type, shape or value.

    Examples
    --------
    >>> import triquad
    >>> pairs, _ = triquad.pair([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    >>> sorted(pairs.ravel().tolist())
    [0, 1, 2, 3]
    """
    if name_of("algorithm", algorithm).split(" ")[0] in ("best", "lrs"):
        reason = "needs vertices" if algorithm == "best" else "flips edges"
        raise ValueError(f"algorithm: {algorithm} {reason}; use convert")
    pairs, report, summary = _native.pair(
        index_array("triangles", triangles, 3),
        _options(algorithm, augmentation, orient, seed, threads),
    )
    return pairs, Report._of(report, summary=summary)


def _options(
    algorithm: str, augmentation: str, orient: bool, seed: int, threads: int | None
) -> dict[str, Any]:
    return {
        "algorithm": name_of("algorithm", algorithm),
        "augmentation": name_of("augmentation", augmentation),
        "orient": bool(orient),
        "seed": count("seed", seed),
        "threads": 0 if threads is None else count("threads", threads, 1025, least=1),
        "cost": "default",
        "keep_sharp": None,
        "keep_edges": None,
        "strict": False,
        "open": False,
        "quad_dominant": None,
    }
