//! Runners that are killed at any moment, with others started beside them: no finished row is lost,
//! none comes twice, none is superseded.

use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

use triquad_generators::testing::draws;

use crate::experiment_text::experiment;
use crate::experiments::{Workshop, repeatable_rows};

const EXPERIMENT: &str = experiment!(
    "short",
    "convert",
    r#"["botijo"]"#,
    r#"algorithms = ["sg", "ps", "tq"]
        augmentations = ["tarjan", "local"]
        repetitions = { full = 4, small = 4, demo = 4 }"#,
);
const RUNS: usize = 3 * 2 * 4;

/// Kills without anything said; `TRIQUAD_KILLS` is another number.
const KILLS: u32 = 12;

fn spawn(shop: &Workshop, folder: &str) -> Child {
    let mut command = shop.command(&format!("run short.toml --scale demo --out {folder}"));
    command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

/// The complete rows of a folder: key, and the whole line.
fn rows(shop: &Workshop, folder: &str) -> Vec<(String, String)> {
    let text = std::fs::read_to_string(shop.path(folder).join("runs.csv")).unwrap_or_default();
    let complete = &text[..text.rfind('\n').map_or(0, |end| end + 1)];
    let row = |line: &str| (line.split(',').nth(1).unwrap().to_owned(), line.to_owned());
    complete.lines().skip(1).map(row).collect()
}

/// Asserts that all rows of `before` are there, in their order, and each run has one.
fn assert_kept(before: &[(String, String)], now: &[(String, String)]) {
    assert!(now.starts_with(before), "a row is lost: {before:#?}\n{now:#?}");
    let mut keys: Vec<&String> = now.iter().map(|(key, _)| key).collect();
    keys.sort_unstable();
    keys.dedup();
    assert_eq!(keys.len(), now.len(), "a run has two rows: {now:#?}");
    let ok = |(_, line): &(String, String)| line.contains(",ok,");
    assert!(now.iter().all(ok), "{now:#?}");
}

/// Lets a runner live for up to `longest`, with another one beside it if `is_two`, and kills both.
fn kill_one(
    shop: &Workshop,
    folder: &str,
    longest: Duration,
    is_two: bool,
    below: &mut dyn FnMut(u32) -> u32,
) {
    let mut pause = |most: Duration| {
        std::thread::sleep(Duration::from_micros(below(most.as_micros() as u32 + 1).into()));
    };
    let mut first = spawn(shop, folder);
    pause(longest / 2);
    let second = is_two.then(|| spawn(shop, folder));
    pause(longest / 2);
    first.kill().unwrap();
    first.wait().unwrap();
    if let Some(mut second) = second {
        // It has the folder now, unless it was refused before.
        pause(longest / 2);
        second.kill().unwrap();
        let code = second.wait().unwrap().code();
        assert!([None, Some(0), Some(2)].contains(&code), "{code:?}");
    }
}

#[test]
fn rows_survive_whenever_runners_are_killed() {
    let shop = Workshop::new();
    std::fs::write(shop.path("short.toml"), EXPERIMENT).unwrap();
    let start = Instant::now();
    shop.succeed("run short.toml --scale demo --out whole");
    // The last third is the page.
    let longest = start.elapsed() * 2 / 3;
    let whole = repeatable_rows(&shop.results("whole"));
    let kills = std::env::var("TRIQUAD_KILLS").map_or(KILLS, |kills| kills.parse().unwrap());
    let mut below = draws(u64::from(kills));
    let (mut folders, mut seconds) = (0, 0);
    let mut known = Vec::new();
    for kill in 1..=kills {
        let folder = format!("killed-{folders}");
        let is_two = kill % 3 == 0;
        kill_one(&shop, &folder, longest, is_two, &mut below);
        seconds += u32::from(is_two);
        let now = rows(&shop, &folder);
        assert_kept(&known, &now);
        known = now;
        if known.len() == RUNS || kill == kills {
            shop.succeed(&format!("run short.toml --scale demo --out {folder}"));
            assert_kept(&known, &rows(&shop, &folder));
            assert_eq!(repeatable_rows(&shop.results(&folder)), whole);
            (folders, known) = (folders + 1, Vec::new());
        }
    }
    println!("{kills} kills, {seconds} with a second runner, {folders} folders");
}
