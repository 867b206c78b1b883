//! Nouns behind numbers: one quad is no "1 quads".

use std::path::{Path, PathBuf};

use super::meshes::TETRAHEDRON;
use crate::documents::root;
use crate::workshop::Workshop;

/// Folders with messages.
const FOLDERS: [&str; 6] =
    ["src", "cli/src", "lab/src", "render/src", "generators/src", "python/src"];

/// Nouns that stand behind numbers in messages.
const NOUNS: &str = "arguments bytes cavities cells claims colours columns components corners costs \
                     edges faces fields files groups handles holes indices laws lines links loops \
                     machines meshes nodes numbers others pairs paths pictures pixels plots points \
                     programs quads records references rows runs sets shafts tables tests times \
                     triangles values vertices words";

/// Where the number is never one, or no number: the file, and the words.
const ALLOWED: &[(&str, &str)] = &[
    ("cli/src/aims.rs", "{remedy} the edges"),
    ("cli/src/certificate/read.rs", "{N} numbers"),
    ("cli/src/compare.rs", "{} claims"),
    ("cli/src/draw/mod.rs", "{height} pixels"),
    ("cli/src/out_of_memory.rs", "{size} bytes"),
    ("cli/src/plan.rs", "{:>9} triangles"),
    ("cli/src/progress.rs", "{spinner} augmenting paths"),
    ("cli/src/run.rs", "{len} runs"),
    ("generators/src/box_mesh/shape.rs", "{minimum} vertices"),
    ("lab/src/experiment/plan.rs", "{} vertices"),
    ("lab/src/report/baseline.rs", "{ratio} times"),
    ("lab/src/report/defects.rs", "{machines} machines"),
    ("lab/src/report/page/findings.rs", "{all} claims"),
    ("lab/src/report/page/findings.rs", "{rows} rows"),
    ("lab/src/report/page/lrs_against_ps.rs", "{} times"),
    ("lab/src/report/page/picture.rs", "{DRAWN_DEPTH} cells"),
    ("lab/src/report/page/picture.rs", "{} edges"),
    ("lab/src/report/tables/link_tests.rs", "{} runs"),
    ("lab/src/report/tables/link_tests.rs", "{name} runs"),
    ("python/src/arrays.rs", "{} indices"),
    ("render/src/error.rs", "{height} pixels"),
    ("src/mesh/attributes.rs", "{kind} indices"),
    ("src/mesh/error.rs", "{0} bytes"),
    ("src/mesh/error.rs", "{0} files"),
    ("src/mesh/obj/blocks.rs", "{LONGEST_LINE} bytes"),
];

/// Returns the source files below `folder`, tests left out.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let is_source = |path: &PathBuf| path.file_stem().is_none_or(|stem| stem != "tests");
    let below = |path: PathBuf| match path.is_dir() {
        true => sources(&path),
        false if path.extension().is_some_and(|ending| ending == "rs") => vec![path],
        false => Vec::new(),
    };
    entries.filter(is_source).flat_map(below).collect()
}

/// Returns the places of numbers in `text` with the plural behind each, at most a word between.
fn plurals(text: &str) -> Vec<String> {
    let nouns: Vec<&str> = NOUNS.split_whitespace().collect();
    let is_noun =
        |word: &str| nouns.contains(&word.trim_end_matches(|c: char| !c.is_alphanumeric()));
    let mut found = Vec::new();
    for (end, _) in text.match_indices("} ") {
        let Some(start) = text[..end].rfind('{') else { continue };
        let words: Vec<&str> = text[end + 2..].split(' ').take(2).collect();
        let is_plain = words[0].bytes().all(|byte| byte.is_ascii_lowercase() || byte == b'-');
        let nouns_at = match &words[..] {
            [one, ..] if is_noun(one) => 1,
            [one, two] if is_plain && *one != "of" && is_noun(two) => 2,
            _ => continue,
        };
        let behind = words[..nouns_at].join(" ");
        let behind = behind.trim_end_matches(|c: char| !c.is_alphanumeric());
        let behind = behind.split(|c: char| "\"',;.:()".contains(c)).next().unwrap_or_default();
        found.push(format!("{} {behind}", &text[start..=end]));
    }
    found
}

#[test]
fn messages_count_with_the_helper() {
    let mut bare = Vec::new();
    for path in FOLDERS.iter().flat_map(|folder| sources(&root().join(folder))) {
        let name = path.strip_prefix(root()).unwrap().to_string_lossy().replace('\\', "/");
        let text = std::fs::read_to_string(&path).unwrap().replace("\r\n", "\n");
        let code = text.split("#[cfg(test)]").next().unwrap_or_default();
        let lines = code.split('\n').map(str::trim_start);
        let lines = lines.filter(|line| !line.starts_with("//") && !line.contains("assert"));
        // Strings go on behind a backslash.
        let code = lines.collect::<Vec<_>>().join("\n").replace("\\\n", "");
        let plurals = code.lines().flat_map(plurals);
        let is_allowed = |found: &String| ALLOWED.contains(&(&*name, found));
        bare.extend(
            plurals.filter(|found| !is_allowed(found)).map(|found| format!("{name}: {found}")),
        );
    }
    assert!(bare.is_empty(), "use triquad::counted::counted: {bare:#?}");
}

#[test]
fn a_plural_behind_a_number_is_found() {
    let found = |text: &str| plurals(text);
    assert_eq!(found("{} -> {quads} quads, {:.3} s"), ["{quads} quads"]);
    assert_eq!(found("{count} link tests; {}"), ["{count} link tests"]);
    assert_eq!(found("{name} on faces"), ["{name} on faces"]);
    assert!(found("{quads} of {faces}, {file} of the faces").is_empty());
}

/// The smallest mesh of each kind.
#[test]
fn one_of_a_thing_takes_the_singular() {
    let shop = Workshop::new();
    shop.put("pair.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
    let said = |arguments: &str| String::from_utf8(shop.run(arguments).stdout).unwrap();
    let summary = said("convert pair.obj --open -o quad.obj");
    assert!(
        summary.contains("2 triangles (genus 0, 1 boundary loop) -> 1 quad and 0 triangles left")
    );
    let told = said("check quad.obj --against pair.obj --open");
    assert!(told.contains("ok: 1 quad on the 4 vertices of pair.obj, 0 of them"), "{told}");
    shop.put("one.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    let info = shop.run("info one.obj");
    let counts = String::from_utf8(info.stdout).unwrap();
    assert!(counts.contains("1 (1 triangle)\n"), "{counts}");
    assert!(info.stderr.contains("breaks 1 law, "), "{}", info.stderr);
    let summary = said("convert one.obj --open -o left.obj");
    assert!(
        summary.contains("1 triangle (genus 0, 1 boundary loop) -> 0 quads and 1 triangle left")
    );
    let refused = shop.run("convert one.obj pair.obj --out-dir out").stderr;
    assert!(refused.contains("2 of 2 meshes were not converted"), "{refused}");
    shop.put("closed.obj", TETRAHEDRON);
    let refused = shop.run("convert one.obj closed.obj --out-dir out").stderr;
    assert!(refused.contains("1 of 2 meshes was not converted"), "{refused}");
}
