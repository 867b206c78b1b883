//! Least costs of small graphs by trying every matching, subset by subset.

use super::super::problem::Problem;

/// Returns the least cost of a matching that leaves only priced nodes unpaired. O(2ⁿ · degree).
pub(super) fn least_cost(problem: &impl Problem) -> Option<i128> {
    let count = problem.node_count();
    assert!(count <= 20, "2^{count} subsets are too many");
    let mut around = vec![Vec::new(); count];
    for edge in problem.edges().filter(|edge| edge.ends[0] != edge.ends[1]) {
        let [u, v] = edge.ends.map(|end| end as usize);
        around[u.min(v)].push((u.max(v), edge.cost));
    }
    let mut least: Vec<Option<i128>> = vec![None; 1 << count];
    least[0] = Some(0);
    for nodes in 1..1_usize << count {
        let node = nodes.trailing_zeros() as usize;
        let rest = nodes & (nodes - 1);
        let alone = problem.price(node as u32).and_then(|price| Some(least[rest]? + price));
        let pairs = around[node].iter().filter(|(other, _)| rest >> other & 1 != 0);
        let paired = pairs.filter_map(|(other, cost)| Some(least[rest & !(1 << other)]? + cost));
        least[nodes] = paired.chain(alone).min();
    }
    least[(1 << count) - 1]
}
