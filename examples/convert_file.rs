//! Converts a mesh file: `cargo run --release --example convert_file -- IN.obj OUT.obj`.

use std::error::Error;

use triquad::{Converter, Mesh};

fn main() -> Result<(), Box<dyn Error>> {
    let mut paths = std::env::args_os().skip(1);
    let (Some(input), Some(output)) = (paths.next(), paths.next()) else {
        return Err("usage: convert_file IN OUT".into());
    };
    let mesh = Mesh::read(input)?;
    let quads = Converter::new().seed(7).run(&mesh)?;
    quads.mesh().write(output)?;
    println!("{}", quads.report());
    Ok(())
}
