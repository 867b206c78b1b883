//! The phases in parts of the nodes, at once on several threads, as far as that goes.
//!
//! A part is a range of nodes. Those with neighbours in other parts are its border, and nobody
//! changes them: a search that would have to is left for later. With blossoms, each two neighbours
//! among the parts become one then, until all nodes are in view; without, all parts at once. The
//! parts depend on the number of nodes alone, so the threads do not change the result.

use std::ops::{ControlFlow, Range};

use super::blossoms::{Grown, Outcome, Trees};
use super::cubic::{Cubic, Rows};
use super::half::{first_rounds, half_integral};
use super::limits::Limits;
use super::nodes::Nodes;
use super::number::Number;
use super::observer::{Observer, Stage};
use super::refusal::Refusal;
use super::roots::Roots;
use super::start::{raise_each, start};
use super::work::Work;
use crate::parallel::{map, threads};

/// Returns whether there are several parts, and few nodes on their borders.
///
/// That depends on the graph alone. Where it has no near neighbours, parts would be all border.
pub(super) fn has_parts<N: Number>(rows: &mut Rows<N>, limits: Limits) -> bool {
    let nodes = rows.len();
    let count = |nodes: Cubic<N, true>| nodes.range().filter(|&v| nodes.is_on_border(v)).count();
    let border: usize = map(rows.parts(limits.ranges(nodes)), count).into_iter().sum();
    limits.parts(nodes) > 1 && limits.allow(border, nodes)
}

/// Runs all phases.
pub(super) fn run_in_parts<N: Number>(
    mut rows: Rows<N>,
    limits: Limits,
    observer: &mut Observer,
) -> Result<Outcome, Refusal> {
    let mut work = Work::of::<N>();
    let roots = half_phase(&mut rows, limits, &mut work, observer)?;
    work.blossom_roots = roots.len() as u64;
    let mut groups = Group::of_each(limits.ranges(rows.len()), &roots);
    let mut before = 0;
    while groups.len() > 1 {
        let most = limits.most_in_part(rows.len(), groups.len());
        groups = pair_in_each(&mut rows, groups, before..most, limits, observer)?;
        groups = unite_neighbours(groups);
        before = most;
    }
    let Group { grown, roots, .. } = groups.pop().expect("there are nodes");
    renumber_sets(&mut rows, &[&grown])?;
    let mut trees = Trees::join(rows.whole(), grown, work);
    trees.pair_all(roots, before, limits, observer)?;
    Ok(trees.finish())
}

/// Neighbouring parts that are one now: two of them, or at first one.
struct Group<N> {
    range: Range<u32>,
    grown: Vec<Grown<N>>,
    roots: Roots,
}

impl<N: Number> Group<N> {
    /// Makes a group of each range, with those of the `roots` that are in it.
    fn of_each(ranges: impl Iterator<Item = Range<u32>>, roots: &[u32]) -> Vec<Self> {
        let mut rest = roots;
        ranges
            .map(|range| {
                let (own, others) = rest.split_at(rest.partition_point(|&root| root < range.end));
                rest = others;
                let grown = vec![Grown::new(range.clone())];
                Self { range, grown, roots: Roots::new(own.to_vec()) }
            })
            .collect()
    }
}

/// Makes one group of each two neighbours.
fn unite_neighbours<N>(groups: Vec<Group<N>>) -> Vec<Group<N>> {
    let mut united: Vec<Group<N>> = Vec::with_capacity(groups.len().div_ceil(2));
    for (place, group) in groups.into_iter().enumerate() {
        match united.last_mut().filter(|_| place % 2 == 1) {
            Some(last) => {
                last.range.end = group.range.end;
                last.grown.extend(group.grown);
                last.roots.add(group.roots);
            }
            None => united.push(group),
        }
    }
    united
}

/// Pairs the roots of each group that need no larger trees than of `limits_now.end` nodes. Those
/// that were cut before have been searched from with limits up to its start.
fn pair_in_each<N: Number>(
    rows: &mut Rows<N>,
    groups: Vec<Group<N>>,
    limits_now: Range<usize>,
    limits: Limits,
    observer: &mut Observer,
) -> Result<Vec<Group<N>>, Refusal> {
    renumber_sets(rows, &groups.iter().map(|group| &group.grown).collect::<Vec<_>>())?;
    let roots = groups.iter().map(|group| group.roots.len()).sum();
    let ranges: Vec<_> = groups.iter().map(|group| group.range.clone()).collect();
    let parts = rows.parts(ranges.into_iter()).into_iter().zip(groups).collect();
    let pair = |(nodes, group): (_, Group<N>), in_a_hurry: bool| {
        let mut goes_on = |_| ControlFlow::Continue(());
        let mut trees = Trees::join(nodes, group.grown, Work::default());
        let most = if in_a_hurry { 0 } else { limits_now.end };
        let within = limits_now.start..most;
        let observer = &mut Observer::new(&mut goes_on);
        let roots = trees.pair_within(within, group.roots, limits, observer)?;
        Ok(Group { range: group.range, grown: vec![trees.into_grown()], roots })
    };
    in_batches(parts, Stage::Blossoms, roots, observer, pair)
}

/// Numbers the sets of the nodes of each group anew, as [`Trees::join`] numbers them.
fn renumber_sets<N: Number>(rows: &mut Rows<N>, groups: &[&Vec<Grown<N>>]) -> Result<(), Refusal> {
    let (mut ranges, mut before) = (Vec::new(), Vec::new());
    for grown in groups {
        let mut sets = 0;
        for part in *grown {
            ranges.push(part.range());
            before.push(sets);
            sets += part.set_count();
        }
        if sets > Cubic::<N, false>::MOST_SETS as usize {
            return Err(Refusal::TooNarrow);
        }
    }
    let parts = rows.parts(ranges.into_iter()).into_iter().zip(before);
    let moved = parts.filter(|&(_, before)| before > 0).collect();
    map(moved, |(mut nodes, before)| Grown::<N>::renumber_sets(&mut nodes, before as u32));
    Ok(())
}

/// Starts, and finds the half-integral optimum; returns one node of each odd cycle, in order.
fn half_phase<N: Number>(
    rows: &mut Rows<N>,
    limits: Limits,
    work: &mut Work,
    observer: &mut Observer,
) -> Result<Vec<u32>, Refusal> {
    let nodes = rows.len();
    let parts = rows.parts(limits.ranges(nodes));
    let half = |nodes, in_a_hurry: bool| Half::of(nodes, limits, !in_a_hurry);
    let halves = in_batches(parts, Stage::HalfIntegral, nodes, observer, half)?;
    let mut whole = rows.whole();
    let (mut roots, mut border, mut cycles) = (Roots::default(), Vec::new(), Vec::new());
    for half in halves {
        roots.add(half.roots);
        border.extend(half.border);
        cycles.extend(half.cycles);
        work.add(half.work);
    }
    raise_each(&mut whole, border, &mut roots.blocked);
    half_integral(&mut whole, roots, cycles, limits, work, observer)
}

/// Rest of a part after the first rounds of the half-integral phase.
struct Half {
    roots: Roots,
    border: Vec<u32>,
    cycles: Vec<u32>,
    work: Work,
}

impl Half {
    fn of<N: Number>(
        mut nodes: Cubic<N, true>,
        limits: Limits,
        with_rounds: bool,
    ) -> Result<Self, Refusal> {
        let (free, border) = start(&mut nodes, limits);
        let mut work = Work { free_after_start: free.len() as u64, ..Work::default() };
        let (mut roots, mut cycles) = (Roots::new(free), Vec::new());
        if with_rounds {
            first_rounds(&mut nodes, &mut roots, &mut cycles, limits, &mut work)?;
        }
        Ok(Self { roots, border, cycles, work })
    }
}

/// Does `work` with as many parts at once as there are threads; passes news on in between.
///
/// After the observer has stopped the search, the rest is cut short: just enough for a valid state.
fn in_batches<P: Send, T: Send>(
    parts: Vec<P>,
    stage: Stage,
    roots: usize,
    observer: &mut Observer,
    work: impl Fn(P, bool) -> Result<T, Refusal> + Sync + Send,
) -> Result<Vec<T>, Refusal> {
    let mut done = Vec::with_capacity(parts.len());
    let mut in_a_hurry = false;
    let mut parts = parts.into_iter();
    while parts.len() > 0 {
        in_a_hurry = in_a_hurry || observer.stops_now(stage, roots);
        let batch = parts.by_ref().take(threads()).collect();
        for result in map(batch, |part| work(part, in_a_hurry)) {
            done.push(result?);
        }
    }
    Ok(done)
}
