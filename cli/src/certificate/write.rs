//! Writing certificates.

use std::io::{self, Write};

use triquad::matching::weighted::{Certificate, NONE};
use triquad::pairing::Proof;

use super::format::FIRST_LINE;
use crate::aims::ReadAims;

/// Writes what a pairing is the best of, and the proof.
pub fn write(out: &mut impl Write, read: &ReadAims, proof: &Proof) -> io::Result<()> {
    write_aims(out, read)?;
    write_certificate(out, &proof.certificate)?;
    if let Some(barrier) = &proof.barrier {
        writeln!(out, "barrier {}", barrier.nodes.len())?;
        barrier.nodes.iter().try_for_each(|node| writeln!(out, "{}", node + 1))?;
    }
    writeln!(out, "end")
}

fn write_aims(out: &mut impl Write, read: &ReadAims) -> io::Result<()> {
    let ReadAims { aims, cost, .. } = read;
    writeln!(out, "{FIRST_LINE}\ncost {}", cost.name())?;
    if let Some(degrees) = aims.keep.sharp {
        writeln!(out, "keep-sharp {degrees}")?;
    }
    if aims.keep.seams {
        writeln!(out, "keep-seams")?;
    }
    if aims.strict {
        writeln!(out, "strict")?;
    }
    if let Some(price) = aims.price {
        writeln!(out, "quad-dominant {price}")?;
    }
    writeln!(out, "keep-edges {}", aims.keep.edges.len())?;
    aims.keep
        .edges
        .iter()
        .try_for_each(|[a, b]| writeln!(out, "{} {}", u64::from(*a) + 1, u64::from(*b) + 1))
}

fn write_certificate(out: &mut impl Write, certificate: &Certificate) -> io::Result<()> {
    let number = |set: u32| if set == NONE { 0 } else { u64::from(set) + 1 };
    writeln!(out, "triangles {}", certificate.potentials.len())?;
    for (triangle, &set) in certificate.innermost.iter().enumerate() {
        writeln!(out, "{} {}", certificate.potentials.at(triangle), number(set))?;
    }
    writeln!(out, "sets {}", certificate.set_count())?;
    for (set, &parent) in certificate.parents.iter().enumerate() {
        writeln!(out, "{} {}", number(parent), certificate.values.at(set))?;
    }
    Ok(())
}
