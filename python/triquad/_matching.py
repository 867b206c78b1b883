"""Perfect matchings of least cost in any graph."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from triquad import _native
from triquad._arrays import count, index_array, integer_array


@dataclass(frozen=True)
class Certificate:
    """Dual values that prove a matching to be of least cost, in halves of the unit of the costs.

    The potentials of the ends of an edge, less twice the values of all odd sets that hold both
    ends, never exceed twice its cost, and they equal it for pairs. No set has a negative value.

    >>> import triquad
    >>> certificate = triquad.match([[0, 1]], [5]).certificate
    >>> int(certificate.potentials.sum())
    10
    """

    potentials: NDArray[Any]
    """Potential of each node, ``(n,)``, ``int64``; ``object`` if a value does not fit."""
    innermost: NDArray[np.int64]
    """Number of the smallest odd set that holds each node, ``(n,)``, or -1."""
    parents: NDArray[np.int64]
    """Number of the smallest odd set that holds each odd set, ``(s,)``, or -1."""
    values: NDArray[Any]
    """Value of each odd set, ``(s,)``, ``int64``; ``object`` if one does not fit."""


@dataclass(frozen=True)
class Matching:
    """A matching of least cost.

    >>> import triquad
    >>> triquad.match([[0, 1], [1, 2], [2, 3], [3, 0]], [3, 1, 3, 1]).pairs().tolist()
    [[0, 3], [1, 2]]
    """

    mates: NDArray[np.int64]
    """The node that each node is paired with, ``(n,)``, or -1."""
    cost: int
    """Sum of the costs of all pairs and the prices of all unpaired nodes."""
    certificate: Certificate

    def pairs(self) -> NDArray[np.int64]:
        """Return the pairs, ``(k, 2)``, in the order of their lower nodes."""
        lower = np.flatnonzero(self.mates > np.arange(len(self.mates)))
        return np.column_stack((lower, self.mates[lower]))


def match(
    edges: ArrayLike, costs: ArrayLike, *, nodes: int | None = None, price: int | None = None
) -> Matching:
    """Find a perfect matching of least total cost in a graph, exactly.

    The certificate was verified before it is returned.

    Parameters
    ----------
    edges : array_like, shape (m, 2), any integer dtype
        The nodes that each edge joins, from 0. Parallel edges are allowed, loops are ignored.
    costs : array_like, shape (m,), any integer dtype
        The cost of each edge; negative ones are allowed. Scale and round costs that are not
        integers.
    nodes : int, optional
        Number of nodes; by default the greatest one of ``edges`` is the last.
    price : int, optional
        Price of leaving a node unpaired. By default every node must be paired.

    Returns
    -------
    Matching
        Mates, cost and certificate.

    Raises
    ------
    InfeasibleError
        Not all nodes can be paired; ``barrier`` proves it.
    MeshError
        A node is negative or beyond 2**32.
    TypeError, ValueError
        An argument has the wrong type, shape or value.

    Examples
    --------
    >>> import triquad
    >>> matching = triquad.match([[0, 1], [1, 2], [2, 3], [3, 0]], [3, 1, 3, 1])
    >>> matching.mates.tolist(), matching.cost
    ([3, 2, 1, 0], 2)
    """
    ends = index_array("edges", edges, 2)
    prices = integer_array("costs", costs, np.int64)
    if len(prices) != len(ends):
        raise ValueError(f"costs: expected shape ({len(ends)},), got {prices.shape}")
    mates, cost, potentials, innermost, parents, values = _native.solve(
        ends,
        prices,
        None if nodes is None else count("nodes", nodes, 2**30),
        None if price is None else count("price", price, 2**63, least=-(2**63)),
    )
    certificate = Certificate(_numbers(potentials), innermost, parents, _numbers(values))
    return Matching(mates, cost, certificate)


def _numbers(values: NDArray[np.int64] | list[int]) -> NDArray[Any]:
    return np.array(values, dtype=object) if isinstance(values, list) else values
