//! The yardstick of `overhead.py`: the same conversion by the library, with no Python.
//!
//! `library FOLDER ALGORITHM` reads the arrays that the Python half has written, makes the mesh,
//! and prints the seconds of the call and the bytes by which it raised the peak. The call begins
//! with a mesh in memory that it may keep, and ends with the quads and the report. Linux only.

use std::error::Error;
use std::path::Path;
use std::time::Instant;
use std::{env, fs};

use triquad::{Algorithm, Converter, Mesh};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [folder, algorithm] = arguments.as_slice() else {
        return Err("usage: library FOLDER ALGORITHM".into());
    };
    let algorithm: Algorithm = algorithm.parse()?;
    let mesh = mesh(Path::new(folder))?;
    let before = bytes("VmRSS")?;
    let start = Instant::now();
    let converted = Converter::new().algorithm(algorithm).run(mesh)?;
    let report = converted.report().clone();
    let quads = converted.into_mesh().into_parts().1.into_corners();
    let seconds = start.elapsed().as_secs_f64();
    assert_eq!(quads.len(), 4 * report.quads);
    let peak = bytes("VmHWM")? - before;
    println!(r#"{{"seconds": {seconds}, "bytes": {peak}}}"#);
    Ok(())
}

/// Reads the arrays, little-endian.
fn mesh(folder: &Path) -> Result<Mesh, Box<dyn Error>> {
    let bytes = fs::read(folder.join("vertices"))?;
    let rows = bytes.as_chunks().0.as_chunks().0.iter();
    let vertices = rows.map(|row| row.map(f64::from_le_bytes)).collect();
    let bytes = fs::read(folder.join("triangles"))?;
    let rows = bytes.as_chunks().0.as_chunks().0.iter();
    // The indices of a mesh have 32 bits.
    let triangles = rows.map(|row| row.map(|index| i64::from_le_bytes(index) as u32)).collect();
    Ok(Mesh::from_triangles(vertices, triangles))
}

/// Reads a line of the kernel's account of this process.
fn bytes(name: &str) -> Result<u64, Box<dyn Error>> {
    let status = fs::read_to_string("/proc/self/status")?;
    let line = status.lines().find(|line| line.starts_with(name)).ok_or("no such line")?;
    let kilobytes: u64 = line.split_whitespace().nth(1).ok_or("no number")?.parse()?;
    Ok(1024 * kilobytes)
}
