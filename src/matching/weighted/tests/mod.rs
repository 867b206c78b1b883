//! Random graphs, a slow oracle, and what must hold of every answer.

mod brute_force;
mod cubic;
mod dual;
mod graphs;
mod patches;
mod sparse;
mod special;
mod tampering;
