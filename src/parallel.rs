//! Work on several threads: rayon's, with feature `threads`; else all of it on this one.
//!
//! Nothing here may use another module of the library. Results never depend on the number of
//! threads: work is divided by index, and what a thread returns is put together in that order.

use std::ops::Range;

/// Indices that are worth a thread; in tests few, so that small surfaces are divided, too.
#[cfg(feature = "threads")]
const LEAST: usize = if cfg!(test) { 8 } else { 1 << 14 };

/// Runs both, at once if there are threads, and returns what they return.
pub(crate) fn join<A: Send, B: Send>(
    one: impl FnOnce() -> A + Send,
    other: impl FnOnce() -> B + Send,
) -> (A, B) {
    #[cfg(feature = "threads")]
    return rayon::join(one, other);
    #[cfg(not(feature = "threads"))]
    (one(), other())
}

/// Does `work` on other threads, if there are any, while this one does its `own`.
#[cfg(feature = "files")]
pub(crate) fn beside<A: Send, B>(
    work: impl FnOnce() -> A + Send,
    own: impl FnOnce() -> B,
) -> (A, B) {
    #[cfg(feature = "threads")]
    if rayon::current_num_threads() > 1 {
        let mut done = None;
        let owned = rayon::in_place_scope(|scope| {
            scope.spawn(|_| done = Some(work()));
            own()
        });
        return (done.expect("the scope waits for it"), owned);
    }
    (work(), own())
}

/// Divides `0..length` into ranges, one for each thread if there are indices enough.
///
/// Where they end depends on the number of threads; the caller sees to it that results do not.
pub(crate) fn ranges(length: usize) -> Vec<Range<usize>> {
    #[cfg(feature = "threads")]
    let parts = rayon::current_num_threads().min(length / LEAST).max(1);
    #[cfg(not(feature = "threads"))]
    let parts = 1;
    (0..parts).map(|part| range_of(part, parts, length)).collect()
}

/// Returns the range of `0..length` that is one of so many about equal parts.
pub(crate) fn range_of(part: usize, parts: usize, length: usize) -> Range<usize> {
    let end = |part: usize| (length as u128 * part as u128 / parts as u128) as usize;
    end(part)..end(part + 1)
}

/// Does `work` with each part and returns what it returns, in the order of the parts.
pub(crate) fn map<P: Send, T: Send>(parts: Vec<P>, work: impl Fn(P) -> T + Sync + Send) -> Vec<T> {
    #[cfg(feature = "threads")]
    if parts.len() > 1 {
        use rayon::prelude::*;
        return parts.into_par_iter().map(work).collect();
    }
    parts.into_iter().map(work).collect()
}

/// Fills an array with the value of `of` at every index.
pub(crate) fn collect<T: Send>(length: usize, of: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
    #[cfg(feature = "threads")]
    {
        use rayon::prelude::*;
        if length > LEAST && rayon::current_num_threads() > 1 {
            return (0..length).into_par_iter().with_min_len(LEAST).map(of).collect();
        }
    }
    (0..length).map(of).collect()
}

/// Returns the number of threads.
pub(crate) fn threads() -> usize {
    #[cfg(feature = "threads")]
    return rayon::current_num_threads();
    #[cfg(not(feature = "threads"))]
    1
}
