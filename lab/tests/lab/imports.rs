//! Files of results by others: what is refused, where, and with which remedy.

use triquad_lab::experiment::import::{self, ImportSettings, MissingPart};
use triquad_lab::meshes::MeshKind;
use triquad_lab::meshes::paper::Scale;

fn settings(mapping: &[(&str, &str)]) -> ImportSettings {
    ImportSettings {
        algorithm: "mine".into(),
        task: None,
        scale: Scale::Full,
        mapping: mapping.iter().map(|&(from, to)| (from.into(), to.into())).collect(),
        allows_other_meshes: true,
    }
}

fn refusal(text: &str) -> String {
    import::read(text, &settings(&[])).expect_err(text).to_string()
}

/// There are no smaller scans: of that size they are stand-ins, as those of `triquad run` are.
#[test]
fn the_kind_of_a_mesh_that_is_not_given_is_that_of_its_size() {
    let kinds = |scale, header: &str, rows: &str| -> Vec<MeshKind> {
        let settings = ImportSettings { scale, ..settings(&[]) };
        let imported = import::read(&format!("{header}\n{rows}"), &settings).unwrap();
        imported.records.iter().map(|record| record.mesh_kind).collect()
    };
    let (header, rows) = ("mesh,total_seconds", "botijo,1\nA1,1\nA2,1\nchair,1\n");
    let others = [MeshKind::Generated, MeshKind::Simplified, MeshKind::Real];
    for (scale, scan) in [
        (Scale::Full, MeshKind::Real),
        (Scale::Small, MeshKind::StandIn),
        (Scale::Demo, MeshKind::StandIn),
    ] {
        assert_eq!(kinds(scale, header, rows), [&[scan][..], &others].concat(), "{scale:?}");
        let given = kinds(scale, "mesh,total_seconds,mesh_kind", "eros,1,real\n");
        assert_eq!(given, [MeshKind::Real], "{scale:?}");
    }
}

#[test]
fn a_column_is_known_by_its_words() {
    for (name, nearest) in [
        ("unpaired", "unpaired_triangles"),
        ("seconds_total", "total_seconds"),
        ("Total Seconds", "total_seconds"),
        ("pairing time", "pairing_seconds"),
        ("peak_memory", "peak_memory_bytes"),
        ("flips", "edge_flips"),
        ("sead", "seed"),
    ] {
        let expected = format!(
            "the column {name:?} is not known; the nearest name is {nearest:?}: \
             --map \"{name}={nearest}\", or --map \"{name}=-\" to leave it out"
        );
        assert_eq!(refusal(&format!("mesh,{name}\nbotijo,1\n")), expected);
    }
    assert_eq!(
        refusal("mesh,time\nbotijo,1\n"),
        "the column \"time\" is not known; --map \"time=NAME\" with a column of runs.csv, as \
         \"total_seconds\" and \"unpaired_triangles\" are, or --map \"time=-\" to leave it out"
    );
    let mapped = |mapping: &[(&str, &str)]| {
        let text = "graph,time\nbotijo,1\n";
        import::read(text, &settings(mapping)).unwrap_err().to_string()
    };
    assert_eq!(
        mapped(&[("grph", "mesh")]),
        "--map: the file has no column \"grph\"; it has graph, time"
    );
    assert_eq!(
        mapped(&[("time", "seconds_total")]),
        "--map: \"seconds_total\" is no column of runs.csv; the nearest is \"total_seconds\""
    );
    assert_eq!(
        mapped(&[("time", "wall")]),
        "--map: \"wall\" is no column of runs.csv, as \"total_seconds\" and \
         \"unpaired_triangles\" are"
    );
}

/// The line for `--map` is one that works.
#[test]
fn the_column_of_the_mesh_is_known_by_its_values() {
    for values in ["botijo,1\nHappy Buddha", "B0,1\nB1", "part.obj,1\nx/y.ply.gz", ",1\nA5"] {
        let text = format!("model,total_seconds\n{values},2\n");
        let expected = "the column \"model\" is not known; its values are names of meshes: \
                        --map \"model=mesh\"";
        assert_eq!(refusal(&text), expected, "{values}");
        if !values.starts_with(',') {
            let read = import::read(&text, &settings(&[("model", "mesh")])).unwrap();
            assert_eq!(read.records.len(), 2);
        }
    }
    // It may be left out or taken for something else.
    for to in ["-", "reason"] {
        let error = import::read("model,total_seconds\nA5,1\n", &settings(&[("model", to)]));
        let expected = "no column says which mesh; the values of \"model\" are names of meshes: \
                        --map \"model=mesh\"";
        assert_eq!(error.unwrap_err().to_string(), expected);
    }
    assert_eq!(
        refusal("seed,total_seconds\n5,1\n"),
        "no column says which mesh; map one to it: --map \"NAME=mesh\" with a column of the file: \
         seed, total_seconds"
    );
    // Where another column is that of the mesh, or values are something else, names decide.
    assert!(refusal("mesh,model\nA5,A5\n").contains("--map \"model=NAME\""));
    assert!(refusal("model,total_seconds\nA5,1\nmine,1\n").contains("--map \"model=NAME\""));
    assert!(refusal("Meshs,total_seconds\nmine,1\n").contains("--map \"Meshs=mesh\""));
    assert!(refusal("mesh,lone\nA5,1\n").contains("--map \"lone=NAME\""));
}

#[test]
fn other_separators_are_named() {
    for (separator, name) in [(";", "semicolons"), ("\t", "tabs"), ("|", "vertical bars")] {
        let text = format!("mesh{separator}total_seconds\nbotijo{separator}0,5\n");
        let expected = format!(
            "its values are separated by {name}; save it with commas between values, and points in \
             numbers"
        );
        assert_eq!(refusal(&text), expected);
    }
    assert_eq!(
        refusal("mesh,total_seconds\nbotijo,0.5\neros,0,5\n"),
        "line 3: 3 fields where the first line has 2; a comma within a field needs quotes round \
         the field, and numbers have a point"
    );
    // Semicolons within fields are no separators.
    let text = "mesh,total_seconds,reason\nbotijo,0.5,a; b; c; d\n";
    assert_eq!(import::read(text, &settings(&[])).unwrap().records[0].reason, "a; b; c; d");
}

#[test]
fn impossible_numbers_are_refused_with_the_reason() {
    let has = "botijo has 40016 triangles";
    for (column, value, reason) in [
        ("unpaired_triangles", "999999", format!("999999 is too many: {has}")),
        ("augmenting_paths", "20009", format!("20009 is too many: {has}, and each takes two")),
        ("quads", "40016", format!("40016 is too many: {has}, and each takes two")),
        ("edge_flips", "60025", "60025 is too many: botijo has 60024 edges".into()),
        ("unpaired_triangles", "-1", "-1 must be 0 or more".into()),
        ("total_seconds", "-0.5", "-0.5 must be 0 or more".into()),
        ("quality_mean", "1.5", "1.5 must be from -1 to 1".into()),
        ("paired_percent", "-2", "-2 must be from 0 to 100".into()),
    ] {
        let text = format!("mesh,{column}\nbotijo,{value}\n");
        assert_eq!(refusal(&text), format!("line 2, column \"{column}\": {reason}"));
    }
    let text = "mesh,left\nbotijo,999999\n";
    let error = import::read(text, &settings(&[("left", "unpaired_triangles")])).unwrap_err();
    assert!(error.to_string().starts_with("line 2, column \"left\": 999999 is"), "{error}");
    // A size of its own is that of the row.
    let text = "mesh,triangles,unpaired_triangles\nbotijo,2000000,999999\n";
    assert_eq!(import::read(text, &settings(&[])).unwrap().records.len(), 1);
    for possible in ["unpaired_triangles\nbotijo,40016\n", "quads\nbotijo,20008\n"] {
        assert!(import::read(&format!("mesh,{possible}"), &settings(&[])).is_ok(), "{possible}");
    }
}

#[test]
fn a_given_total_is_kept_and_must_be_the_sum_of_its_parts() {
    let header = "mesh,pairing_seconds,augmentation_seconds,total_seconds\n";
    let total = |row: &str| {
        let read = import::read(&format!("{header}{row}\n"), &settings(&[]));
        read.map(|read| read.records[0].whole_total_seconds())
    };
    assert_eq!(
        total("botijo,5,5,1").unwrap_err().to_string(),
        "line 2, column \"total_seconds\": 1 is not pairing_seconds + augmentation_seconds, \
         which is 10; correct it, or leave the column out: --map \"total_seconds=-\""
    );
    assert!(total("botijo,0.125,0.25,0.40").is_err());
    // Rounded, each to its own digits.
    assert_eq!(total("botijo,0.1249,0.2504,0.38").unwrap(), Some(0.38));
    assert_eq!(total("botijo,1e-3,2.5e-3,3.6e-3").unwrap(), Some(3.6e-3));
    assert_eq!(total("botijo,0.1,0.2,0.3").unwrap(), Some(0.3));
    assert_eq!(total("botijo,0.1,,0.3").unwrap(), Some(0.3));
    // Less than one part alone.
    assert_eq!(
        total("botijo,2,,1").unwrap_err().to_string(),
        "line 2, column \"total_seconds\": 1 is less than pairing_seconds, which is 2; correct it, \
         or leave the column out: --map \"total_seconds=-\""
    );
    assert!(refusal("mesh,Total_Seconds,augmentation_seconds\nA5,1,2.5\n").contains(
        "column \"Total_Seconds\": 1 is less than augmentation_seconds, which is 2.5; correct it"
    ));
    assert_eq!(total("botijo,0.25,,0.2").unwrap(), Some(0.2));
    assert_eq!(total("botijo,,0,0").unwrap(), Some(0.0));
}

#[test]
fn names_of_meshes_have_blanks_or_not() {
    for (names, mesh, column) in [
        (&["A 5", "a_5", "a-5", "A5"][..], "A5", "total_seconds"),
        (&["happybuddha", "Happy Buddha", "happy_buddha"], "happy-buddha", "total_seconds"),
        (&["ir-B0", "IR B0", "ir_b_0", "irb0"], "ir-B0", "seconds"),
        (&["B0", "b 0"], "ir-B0", "link_condition_tests"),
    ] {
        for name in names {
            let settings = ImportSettings { allows_other_meshes: false, ..settings(&[]) };
            let read = import::read(&format!("mesh,{column}\n{name},1\n"), &settings).unwrap();
            assert_eq!(read.records[0].id.mesh.name, mesh, "{name}");
            let is_renamed = column == "link_condition_tests";
            assert_eq!(!read.renamed_meshes.is_empty(), is_renamed, "{name}");
        }
    }
    // No box of the second paper, so no reduction.
    let iron = import::read("mesh,total_seconds\niron,1\n", &settings(&[])).unwrap();
    assert_eq!(iron.records[0].measured.total_seconds, Some(1.0));
}

#[test]
fn names_of_columns_have_letters_of_either_case() {
    let read = |text: &str, mapping: &[(&str, &str)]| {
        import::read(text, &settings(mapping)).map(|read| read.records[0].measured.total_seconds)
    };
    assert_eq!(read("Mesh,TOTAL_SECONDS\nbotijo,0.5\n", &[]).unwrap(), Some(0.5));
    let mapping = [("graph", "Mesh"), ("Time", "total_seconds")];
    assert_eq!(read("Graph,time\nbotijo,0.5\n", &mapping).unwrap(), Some(0.5));
    let mapping = [("T", "total_seconds"), ("t", "-")];
    assert_eq!(read("mesh,t,T\nbotijo,0.25,0.5\n", &mapping).unwrap(), Some(0.5));
    let error = read("mesh,seed,Seed,seconds\nbotijo,1,2,3\n", &[]).unwrap_err();
    assert!(error.to_string().contains("two columns are \"seed\""), "{error}");
}

#[test]
fn more_than_all_is_no_share() {
    assert_eq!(
        refusal("mesh,paired_percent\nbotijo,100\neros,101.5\n"),
        "line 3, column \"paired_percent\": 101.5 must be from 0 to 100"
    );
}

#[test]
fn empty_cells_are_refused_where_a_value_is_needed_and_absent_elsewhere() {
    assert_eq!(
        refusal("mesh,total_seconds\nbotijo,0.5\n ,0.5\n"),
        "line 3, column \"mesh\": it is empty; every row needs a mesh"
    );
    // The column is called as the file calls it.
    let text = "graph,time,mem\nbotijo,0.5,\neros,,\n";
    let mapping =
        settings(&[("graph", "mesh"), ("time", "total_seconds"), ("mem", "peak_memory_bytes")]);
    assert_eq!(
        import::read(text, &mapping).unwrap_err().to_string(),
        "line 3, column \"time\": it is empty, and the row has no other number; leave the row \
         out, or name how the run ended in a column \"outcome\""
    );
    let text = "mesh,total_seconds,peak_memory_bytes,mesh_kind,seed,outcome\n\
                botijo,,7,,,\neros,,,,,timeout\n";
    let records = import::read(text, &settings(&[])).unwrap().records;
    let [botijo, eros] = &records[..] else { panic!("{records:?}") };
    assert_eq!((botijo.measured.total_seconds, botijo.measured.peak_memory_bytes), (None, Some(7)));
    assert!(botijo.is_ok() && botijo.seed == 0);
    assert_eq!(eros.outcome.id(), "timeout");
    assert_eq!(
        refusal("mesh,total_seconds,seed\nbotijo,0.5,-3\n"),
        "line 2, column \"seed\": -3 must be 0 or more"
    );
}

/// A total is the sum of both parts, or unknown: one part is never taken for it.
#[test]
fn a_total_is_computed_where_both_parts_are_known_and_missed_elsewhere() {
    let read = |text: &str| import::read(text, &settings(&[])).unwrap();
    let totals = |text: &str| -> Vec<Option<f64>> {
        read(text).records.iter().map(|record| record.measured.total_seconds).collect()
    };
    let missing = |column, known, has_column, runs| MissingPart { column, known, has_column, runs };
    let (pairing, augmentation) = ("pairing_seconds", "augmentation_seconds");

    let alone = "mesh,pairing_seconds\nbotijo,0.5\neros,1.5\n";
    assert_eq!(totals(alone), [None, None]);
    assert_eq!(read(alone).missing_parts, [missing(augmentation, pairing, false, 2)]);
    let other = "mesh,augmentation_seconds\nbotijo,0.5\n";
    assert_eq!(read(other).missing_parts, [missing(pairing, augmentation, false, 1)]);

    // Some rows have all, one has a total of its own, one did not end well.
    let mixed = "mesh,pairing_seconds,augmentation_seconds,total_seconds,outcome\n\
                 botijo,0.5,0.25,,\neros,0.5,,,\nA1,,2,,\nA2,0.5,,4,\nA3,0.5,,,timeout\n";
    assert_eq!(totals(mixed), [Some(0.75), None, None, Some(4.0), None]);
    let expected =
        [missing(augmentation, pairing, true, 1), missing(pairing, augmentation, true, 1)];
    assert_eq!(read(mixed).missing_parts, expected);

    // Neither part: nothing was promised.
    assert_eq!(read("mesh,unpaired_triangles\nbotijo,5\n").missing_parts, []);
    let both = "mesh,pairing_seconds,augmentation_seconds\nbotijo,0.5,0\n";
    assert_eq!((totals(both), read(both).missing_parts), (vec![Some(0.5)], vec![]));
    // A sum has no more digits than its parts.
    let sum = "mesh,pairing_seconds,augmentation_seconds\nbotijo,0.1,0.2\n";
    assert_eq!(totals(sum), [Some(0.3)]);
    // The task "irreducible" has one time only.
    let reduction = "mesh,seconds,link_condition_tests\nir-B0,0.5,9\n";
    assert_eq!(read(reduction).missing_parts, []);
}

/// Nothing was planned beyond the rows, wherever their repetitions begin to count.
#[test]
fn the_plan_of_imported_rows_is_what_they_are() {
    for numbers in [[0, 1], [1, 2], [7, 3], [u32::MAX, 0]] {
        let [one, other] = numbers;
        let text = format!(
            "mesh,repetition,total_seconds\nbotijo,{one},1\nbotijo,{other},2\n\
             botijo,{other},3\neros,{other},4\n"
        );
        let planned = import::read(&text, &settings(&[])).unwrap().planned();
        let plan: Vec<_> =
            planned.iter().map(|row| (row.id.mesh.name.as_str(), row.repetitions)).collect();
        assert_eq!(plan, [("botijo", 2), ("eros", 1)], "{numbers:?}");
    }
}
