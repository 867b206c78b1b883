"""Perfect matchings of least cost, against brute force and their certificates."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import triquad


def least(nodes: frozenset[int], cost: dict[tuple[int, int], int], price: int | None) -> float:
    """Return the least cost of pairing all nodes, by trying everything."""
    if not nodes:
        return 0
    first = min(nodes)
    rest = nodes - {first}
    found = np.inf if price is None else price + least(rest, cost, price)
    for other in rest:
        if (first, other) in cost:
            found = min(found, cost[first, other] + least(rest - {other}, cost, price))
    return found


def is_proved(edges: Any, costs: Any, price: int | None, matching: triquad.Matching) -> bool:
    """Check the certificate by the definition of the linear program."""
    proof = matching.certificate
    above: list[set[int]] = []
    for innermost in proof.innermost.tolist():
        above.append(set())
        while innermost >= 0:
            above[-1].add(innermost)
            innermost = int(proof.parents[innermost])
    inside = [sum(int(proof.values[s]) for s in sets) for sets in above]
    y = [int(potential) - z for potential, z in zip(proof.potentials, inside)]
    for (u, v), cost in zip(edges.tolist(), costs.tolist()):
        crossed = sum(int(proof.values[s]) for s in above[u] ^ above[v])
        if u != v and y[u] + y[v] + crossed > 2 * cost:
            return False
    if price is not None and any(p > 2 * price for p in proof.potentials.tolist()):
        return False
    sizes = [sum(s in sets for sets in above) for s in range(len(proof.values))]
    odd = all(size % 2 == 1 for size in sizes) and all(z >= 0 for z in proof.values.tolist())
    return odd and sum(y) + sum(map(int, proof.values)) == 2 * matching.cost


@pytest.mark.parametrize("price", [None, 4, -3])
def test_matchings_of_small_graphs_are_of_least_cost(price: int | None) -> None:
    rng = np.random.default_rng(1)
    feasible = 0
    for _ in range(400):
        nodes = int(rng.integers(1, 9))
        edges = rng.integers(0, nodes, (rng.integers(0, 16), 2))
        costs = rng.integers(-5, 12, len(edges))
        table: dict[tuple[int, int], int] = {}
        for (u, v), cost in zip(edges.tolist(), costs.tolist()):
            if u != v:
                key = (min(u, v), max(u, v))
                table[key] = min(cost, table.get(key, cost))
        expected = least(frozenset(range(nodes)), table, price)
        if expected == np.inf:
            with pytest.raises(triquad.InfeasibleError, match="^edges: "):
                triquad.match(edges, costs, nodes=nodes, price=price)
            continue
        feasible += 1
        matching = triquad.match(edges, costs, nodes=nodes, price=price)
        assert matching.cost == expected
        assert is_proved(edges, costs, price, matching)
        unpaired = int((matching.mates < 0).sum())
        paid = sum(table[u, v] for u, v in matching.pairs().tolist())
        assert matching.cost == paid + unpaired * (price or 0)
    assert feasible > 50


def test_a_large_certificate_is_a_proof() -> None:
    rng = np.random.default_rng(2)
    points = rng.random((300, 2))
    near = np.argsort(((points[:, None] - points) ** 2).sum(2))[:, 1:8]
    edges = np.column_stack((np.repeat(np.arange(300), 7), near.ravel()))
    costs = (1e6 * np.hypot(*(points[edges[:, 0]] - points[edges[:, 1]]).T)).astype(np.int64)
    matching = triquad.match(edges, costs)
    assert len(matching.certificate.values) > 0
    assert is_proved(edges, costs, None, matching)


def test_costs_may_be_as_large_as_the_dtype() -> None:
    huge = np.array([2**63 - 1, -(2**63), 2**63 - 1, -(2**63)])
    edges = np.array([[0, 1], [1, 2], [2, 3], [3, 0]])
    matching = triquad.match(edges, huge)
    assert matching.cost == -(2**64)
    assert is_proved(edges, huge, None, matching)


def test_wrong_numbers_are_refused_by_name() -> None:
    with pytest.raises(ValueError, match=r"^costs: expected shape \(1,\), got \(2,\)"):
        triquad.match([[0, 1]], [1, 2])
    with pytest.raises(ValueError, match="^edges: node 1 "):
        triquad.match([[0, 1]], [1], nodes=1)
    with pytest.raises(ValueError, match="^nodes: "):
        triquad.match([[0, 1]], [1], nodes=-1)
    with pytest.raises((TypeError, ValueError), match="^price: "):
        triquad.match([[0, 1]], [1], price=2**63)
    with pytest.raises(TypeError, match="^price: "):
        triquad.match([[0, 1]], [1], price=0.5)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="^costs: .* does not fit"):
        triquad.match([[0, 1]], np.array([2**63], np.uint64))
