//! The phases in parts of the nodes, at once on several threads, as far as that goes.
//!
//! A part is a range of nodes. Those with neighbours in other parts are its border, and nobody
//! changes them: a search that would have to is left for the end, when all nodes are in view. The
//! parts depend on the number of nodes alone, so the threads do not change the result.

use std::ops::ControlFlow;

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
    let most = limits.most_in_part(rows.len());
    let mut rest: &[u32] = &roots;
    let mut parts = Vec::new();
    for nodes in rows.parts(limits.ranges(rows.len())) {
        let (own, others) = rest.split_at(rest.partition_point(|&root| root < nodes.range().end));
        parts.push((nodes, own.to_vec()));
        rest = others;
    }
    let pair = |(nodes, roots), in_a_hurry| {
        pair_in_part(nodes, roots, limits, if in_a_hurry { 0 } else { most })
    };
    let grown = in_batches(parts, Stage::Blossoms, roots.len(), observer, pair)?;
    let (grown, roots): (Vec<_>, Vec<_>) = grown.into_iter().unzip();
    let mut left = Roots::default();
    roots.into_iter().for_each(|roots| left.add(roots));
    let mut trees = join(&mut rows, grown, limits, work)?;
    trees.pair_all(left, most, limits, observer)?;
    Ok(trees.finish())
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

/// Pairs the roots of a part that need no larger trees than `most`; returns the others, too.
fn pair_in_part<N: Number>(
    nodes: Cubic<N, true>,
    roots: Vec<u32>,
    limits: Limits,
    most: usize,
) -> Result<(Grown<N>, Roots), Refusal> {
    let mut goes_on = |_| ControlFlow::Continue(());
    let mut trees = Trees::new(nodes, Work::default());
    let left = trees.pair_within(most, roots, limits, &mut Observer::new(&mut goes_on))?;
    Ok((trees.into_grown(), left))
}

/// Joins the blossoms of all parts.
fn join<N: Number>(
    rows: &mut Rows<N>,
    grown: Vec<Grown<N>>,
    limits: Limits,
    work: Work,
) -> Result<Trees<Cubic<'_, N, false>>, Refusal> {
    let mut before = vec![0];
    for part in &grown {
        before.push(before[before.len() - 1] + part.set_count());
    }
    if before[grown.len()] > Cubic::<N, false>::MOST_SETS as usize {
        return Err(Refusal::TooNarrow);
    }
    let parts = rows.parts(limits.ranges(rows.len()));
    map(parts.into_iter().zip(before).collect(), |(mut nodes, before)| {
        Grown::<N>::renumber_sets(&mut nodes, before as u32);
    });
    Ok(Trees::join(rows.whole(), grown, work))
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
