//! What an interrupt leaves.

use std::process::Command;

use crate::workshop::{Workshop, finish};
use triquad_generators::grids;

#[test]
fn an_interrupt_leaves_nothing_behind() {
    use std::time::Duration;

    let workshop = Workshop::new();
    // 300,000 triangles, of which simple greedy leaves tens of thousands to searches that take
    // minutes together.
    workshop.put_surface("in.ply", &grids::sphere(194));
    let arguments =
        "convert in.ply -o out.obj --stats stats.json --augmentation rebuild --algorithm sg";
    let mut child = workshop.spawn(&arguments.split(' ').collect::<Vec<_>>());
    // Long enough to be among the searches.
    std::thread::sleep(Duration::from_millis(1500));
    assert!(child.try_wait().unwrap().is_none(), "it was over too soon to be interrupted");
    let id = child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    let run = finish(child);
    assert!(matches!(run.code, None | Some(130)), "{run:?}");
    if run.code.is_some() {
        assert_eq!(run.stderr, "triquad: interrupted\n");
    }
    assert_eq!(workshop.names().into_iter().collect::<Vec<_>>(), ["in.ply"]);
}
