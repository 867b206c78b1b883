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
    // Accepted, as other generators have it, but not in silence.
    let run = workshop.run(&format!("{wanted} --seed 5 -o again.obj"));
    assert_contains(&run.stderr, &["--seed has no effect: nothing about a box"], "a seed");
    assert!(!workshop.succeed("generate box --help").contains("--seed"));
    let run = workshop.run("generate paper-box --shafts 3 --depth 5 --seed 5 -o seed.obj");
    assert_contains(&run.stderr, &["--seed has no effect without --walls drawn"], "a seed");
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
    // As import takes them.
    for name in ["SOCKET", "Socket", "soc_ket"] {
        workshop.succeed(&format!("generate paper {name} --cache kept -o same.off"));
        assert_eq!(workshop.get("same.off"), workshop.get("socket.off"));
    }
    for name in ["ir_f1", "IR-f1", "irF1", "ir-f_1"] {
        workshop.succeed(&format!("generate paper {name} --scale demo -o f1.off"));
    }
}

#[test]
fn what_cannot_be_made_is_refused_with_the_minimum() {
    let workshop = Workshop::new();
    let line = workshop.fail("generate box --vertices 31 --holes 1 -o box.obj", 2);
    assert_contains(&line, &["at least 32 vertices, not 31"], "too small a box");
    let line = workshop.fail("generate stand-in --vertices 8 --genus 2 -o no.obj --cache .", 2);
    assert_contains(&line, &["8 vertices wanted"], "too small a stand-in");
    for (vertices, genus) in [(8, 2), (10, 5), (2, 0)] {
        let wanted = |vertices: u64| {
            format!("generate stand-in --vertices {vertices} --genus {genus} -o no.obj --cache .")
        };
        let line = workshop.fail(&wanted(vertices), 2);
        assert_contains(&line, &["triquad: a stand-in: "], "no file is to blame");
        let least = line.split("; ask for ").nth(1).and_then(|end| end.strip_suffix(" or more\n"));
        let least: u64 = least.unwrap_or_else(|| panic!("{line}")).parse().unwrap();
        // There is no mesh in the cache afterwards that the next failure could be blamed for.
        workshop.succeed(&wanted(least).replace("--cache .", "--cache kept"));
        std::fs::remove_file(workshop.path("no.obj")).unwrap();
    }
    let line = workshop.fail("generate box --vertices 3 -o box.obj", 2);
    assert_contains(&line, &["triquad: a box: ", "; ask for 8 or more\n"], "too small a box");
    let line = workshop.fail("generate box --vertices 100 -o box.xyz", 2);
    assert_contains(&line, &["box.xyz"], "an unknown format");
    let line = workshop.fail("generate box --vertices 100", 2);
    assert_contains(&line, &["--output"], "no target");
}
