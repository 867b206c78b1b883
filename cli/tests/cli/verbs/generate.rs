//! Meshes that `generate` makes.

use crate::workshop::{Workshop, assert_contains};

#[test]
fn boxes_are_made_to_order() {
    let workshop = Workshop::new();
    let wanted = "generate box --vertices 1000 --cavities 3 --holes 2";
    let line = workshop.succeed(&format!("{wanted} -o box.obj"));
    assert_contains(&line, &["box.obj", "1000 vertices", "2004 triangles", "genus 2"], wanted);
    let report = workshop.json("info box.obj --json", 0);
    assert_eq!((&report["vertices"], &report["genus"]), (&1000.into(), &2.into()));
    workshop.succeed(&format!("{wanted} --seed 5 -o again.obj"));
    assert_eq!(workshop.get("box.obj"), workshop.get("again.obj"));
    let printed = workshop.run(&format!("{wanted} -o -"));
    assert_eq!((printed.code, printed.stdout), (Some(0), workshop.get("box.obj")));
}

#[test]
fn boxes_of_the_papers_kind_are_made_to_order() {
    let workshop = Workshop::new();
    let wanted = "generate paper-box --shafts 3 --depth 5";
    // 2 (7 · 9 + 9 · 7 + 7 · 7) + 2 lattice vertices outside, 2 · 63 centres, 9 · 20 in shafts.
    for (holes, vertices, triangles) in [(0, 658, 1312), (4, 666, 1344)] {
        let line = workshop.succeed(&format!("{wanted} --holes {holes} -o box.obj"));
        let counts = format!("{vertices} vertices, {triangles} triangles, genus {holes}");
        assert_contains(&line, &[counts.as_str()], wanted);
        let report = workshop.json("info box.obj --json", 0);
        assert_eq!((&report["vertices"], &report["genus"]), (&vertices.into(), &holes.into()));
    }
    let drawn = |seed| {
        workshop.succeed(&format!("{wanted} --walls drawn --seed {seed} -o drawn.obj"));
        workshop.get("drawn.obj")
    };
    assert_eq!(drawn(1), drawn(1));
    assert_ne!(drawn(1), drawn(2));
    let line = workshop.fail("generate paper-box --shafts 3 --holes 10 -o no.obj", 2);
    assert_contains(&line, &["more holes (10) than shafts (9)", "fewer holes"], "too many holes");
}

#[test]
fn stand_ins_are_kept_in_the_cache() {
    let workshop = Workshop::new();
    let wanted = "generate stand-in --vertices 700 --genus 3 --cache kept";
    let (made, kept) = ("degrees; made in ", "degrees; read from the cache in ");
    // Each mesh has a seal beside it.
    let line = workshop.succeed(&format!("{wanted} -o one.ply"));
    assert_contains(&line, &[made], "a mesh that is new");
    let files: Vec<_> = workshop.path("kept").read_dir().unwrap().map(Result::unwrap).collect();
    assert_eq!(files.len(), 2);
    let line = workshop.succeed(&format!("{wanted} --seed 0 -o same.ply"));
    assert_contains(&line, &[kept], "a mesh that is kept");
    assert_eq!(workshop.path("kept").read_dir().unwrap().count(), 2);
    let mesh =
        files.iter().map(|file| file.path()).find(|path| path.extension() == Some("ply".as_ref()));
    std::fs::write(mesh.unwrap(), "damaged").unwrap();
    let line = workshop.succeed(&format!("{wanted} -o again.ply"));
    assert_contains(&line, &[made], "a mesh that was damaged");
    assert_eq!(workshop.get("one.ply"), workshop.get("again.ply"));
    workshop.succeed(&format!("{wanted} --seed 1 -o other.ply"));
    assert_eq!(workshop.get("one.ply"), workshop.get("same.ply"));
    assert_ne!(workshop.get("one.ply"), workshop.get("other.ply"));
    let report = workshop.json("info one.ply --json", 0);
    assert_eq!((&report["vertices"], &report["genus"]), (&700.into(), &3.into()));
}

#[test]
fn the_papers_meshes_are_made_by_name() {
    let workshop = Workshop::new();
    workshop.succeed("generate paper socket --cache kept -o socket.off");
    let report = workshop.json("info socket.off --json", 0);
    assert_eq!((&report["triangles"], &report["genus"]), (&1696.into(), &7.into()));
    let line = workshop.fail("generate paper A9 -o a9.obj", 2);
    assert_contains(&line, &["A9", "ir-B4"], "an unknown name");
}

#[test]
fn what_cannot_be_made_is_refused_with_the_minimum() {
    let workshop = Workshop::new();
    let line = workshop.fail("generate box --vertices 31 --holes 1 -o box.obj", 2);
    assert_contains(&line, &["at least 32 vertices, not 31"], "too small a box");
    let line = workshop.fail("generate stand-in --vertices 8 --genus 2 -o no.obj --cache .", 2);
    assert_contains(&line, &["8 vertices wanted", "ask for more"], "too small a stand-in");
    let line = workshop.fail("generate box --vertices 100 -o box.xyz", 2);
    assert_contains(&line, &["box.xyz"], "an unknown format");
    let line = workshop.fail("generate box --vertices 100", 2);
    assert_contains(&line, &["--output"], "no target");
}
