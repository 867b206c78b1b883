//! Every number in README and documents has a source.
//!
//! Looked at is prose, tables of Markdown included. Fenced blocks and tables made of records have
//! tests of their own; code spans, links and comments are left out. A number is one of these:
//!
//! | number | rule |
//! |---|---|
//! | small | a whole number below 100 without a unit of measurement |
//! | of a place | behind Table, Figure, section, Algorithm, line, page and the like |
//! | a year | from 1800 to 2099, without a unit |
//! | an angle | whole degrees |
//! | of a record | five digits or more, found in a table of the newest results or of the papers |
//! | printed | found in what the commands of the same document print |
//! | a constant | listed in `CONSTANTS` with the file that fixes it, and found there |
//! | measured by hand | between `<!-- measured by: COMMAND -->` and `<!-- end -->`; the document shows the command |

mod constants;

use std::collections::HashSet;
use std::path::Path;

use crate::documents::{root, runs};
use constants::{CONSTANTS, Constant};

/// Words before the number of a place.
const PLACES: &[&str] = &[
    "table",
    "tables",
    "figure",
    "figures",
    "section",
    "sections",
    "algorithm",
    "algorithms",
    "lemma",
    "theorem",
    "proposition",
    "line",
    "lines",
    "page",
    "pages",
    "volume",
    "arxiv",
];

/// Words after a number that was measured, or limits something.
const UNITS: &[&str] = &[
    "%", "per", "ms", "s", "seconds", "minutes", "hours", "times", "b", "kb", "mb", "gb", "kib",
    "mib", "gib", "bytes", "thousand", "million", "ghz",
];

/// Words that join the numbers of a range or a list.
const JOINTS: &[&str] = &["to", "and", "or", ",", ";", "–", "-", "; and", ", and"];

/// A number in a text.
#[derive(Clone, Debug, PartialEq)]
struct Number {
    /// Line from 1.
    line: usize,
    /// As it stands there.
    text: String,
    /// Without separators of thousands and zeros at the end of a fraction.
    value: String,
    has_unit: bool,
    is_of_place: bool,
    is_angle: bool,
}

impl Number {
    fn is_plain(&self) -> bool {
        self.text.bytes().all(|byte| byte.is_ascii_digit())
    }

    fn digits(&self) -> usize {
        self.value.bytes().filter(u8::is_ascii_digit).count()
    }

    /// Returns whether the number needs no source.
    fn is_free(&self) -> bool {
        let number = self.value.parse::<u64>().unwrap_or(u64::MAX);
        let is_small = self.is_plain() && number < 100;
        let is_year = self.is_plain() && (1800..2100).contains(&number);
        let is_angle = self.is_angle && self.is_plain() && number <= 360;
        self.is_of_place || is_angle || (!self.has_unit && (is_small || is_year))
    }
}

/// Returns the value of a number as it stands in a text.
fn value_of(text: &str) -> String {
    let value = text.replace(',', "");
    if value.contains('.') {
        value.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        value
    }
}

/// Returns the ranges of numbers in a line: digits, with single points and commas between them.
///
/// Digits that belong to a name (`A1`, `x2`) are none.
fn ranges(line: &str) -> Vec<std::ops::Range<usize>> {
    let bytes = line.as_bytes();
    let is_digit = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_digit);
    let (mut found, mut at) = (Vec::new(), 0);
    while at < bytes.len() {
        if !is_digit(at) {
            at += 1;
            continue;
        }
        let start = at;
        while is_digit(at) || (matches!(bytes.get(at), Some(b'.' | b',')) && is_digit(at + 1)) {
            at += 1;
        }
        let before = line[..start].chars().next_back();
        if !before.is_some_and(|c| c.is_alphanumeric() || c == '_') {
            found.push(start..at);
        }
    }
    found
}

/// Returns the numbers of a line of text.
fn numbers_of_line(number: usize, line: &str) -> Vec<Number> {
    let ranges = ranges(line);
    let between = |one: usize, other: usize| line[ranges[one].end..ranges[other].start].trim();
    let mut numbers: Vec<Number> = Vec::new();
    for (index, range) in ranges.iter().enumerate() {
        let joined = index > 0 && JOINTS.contains(&between(index - 1, index));
        let before = line[..range.start].trim_end_matches([' ', '*', ':']);
        let word = before.rsplit(|c: char| !c.is_alphabetic()).next().unwrap_or_default();
        let is_of_place = PLACES.contains(&word.to_lowercase().as_str());
        let text = line[range.clone()].to_owned();
        numbers.push(Number {
            line: number,
            value: value_of(&text),
            text,
            has_unit: has_unit(&line[range.end..]),
            is_angle: line[range.end..].starts_with('°'),
            is_of_place: is_of_place || (joined && numbers[index - 1].is_of_place),
        });
    }
    // The unit of a range stands behind its end.
    for index in (1..numbers.len()).rev() {
        if numbers[index].has_unit && JOINTS.contains(&between(index - 1, index)) {
            numbers[index - 1].has_unit = true;
        }
    }
    numbers
}

/// Returns whether a unit of measurement begins `rest`.
fn has_unit(rest: &str) -> bool {
    let rest = rest.trim_start_matches([' ', '*', '\u{a0}']).to_lowercase();
    let word = rest.split(|c: char| !c.is_alphabetic()).next().unwrap_or_default();
    rest.starts_with('%') || UNITS.contains(&word)
}

/// Returns `text` without what stands from each `open` to the next `close`.
fn without(text: &str, open: &str, close: &str) -> String {
    let mut parts = text.split(open);
    let first = parts.next().unwrap_or_default().to_owned();
    let rest = parts.map(|part| part.split_once(close).map_or("", |(_, rest)| rest));
    rest.fold(first, |kept, rest| kept + " " + rest)
}

/// Returns a paragraph without code spans, targets of links, comments and addresses.
fn prose(paragraph: &str) -> String {
    let spans = paragraph.split('`').enumerate();
    // Code is dropped, its line ends stay.
    let kept = spans.map(|(index, span)| match index % 2 {
        0 => span.to_owned(),
        _ => "\n".repeat(span.matches('\n').count()),
    });
    let pairs = [("](", ")"), ("<!--", "-->"), ("https://", " ")];
    let text = kept.collect::<Vec<_>>().join("`");
    pairs.iter().fold(text, |text, (open, close)| without(&text, open, close))
}

/// Parts of a document that have tests of their own.
#[derive(PartialEq)]
enum Part {
    Prose,
    Fence,
    /// Made of records, or measured by hand with a command beside it.
    Table,
}

/// Returns a document with empty lines for all that is no prose.
fn prose_lines(document: &str) -> String {
    let mut part = Part::Prose;
    let line = |text: &str| {
        let is_fence = text.starts_with("```");
        let was_prose = part == Part::Prose;
        part = match part {
            Part::Prose if is_fence => Part::Fence,
            Part::Fence if is_fence => Part::Prose,
            Part::Prose if text.starts_with("<!-- table: ") || measured_by(text).is_some() => {
                Part::Table
            }
            Part::Table if text.starts_with("<!-- end -->") => Part::Prose,
            _ => return if was_prose { text.to_owned() } else { String::new() },
        };
        String::new()
    };
    document.lines().map(line).collect::<Vec<_>>().join("\n")
}

/// Returns the numbers in the prose of a document that need a source.
fn numbers(document: &str) -> Vec<Number> {
    let lines = prose_lines(document);
    let prose = lines.split("\n\n").map(prose).collect::<Vec<_>>().join("\n\n");
    let numbers = (1..).zip(prose.lines()).flat_map(|(line, text)| numbers_of_line(line, text));
    numbers.filter(|number| !number.is_free()).collect()
}

/// Returns the command of a table that was measured by hand.
fn measured_by(line: &str) -> Option<&str> {
    line.strip_prefix("<!-- measured by: ")?.strip_suffix(" -->")
}

/// Returns the commands of tables measured by hand that the document does not show.
fn hidden_commands(document: &str) -> Vec<&str> {
    let commands = document.lines().filter_map(measured_by);
    commands.filter(|command| document.matches(command).count() < 2).collect()
}

/// Returns the values of all numbers in a text.
///
/// In CSV files a comma parts numbers, elsewhere it parts thousands: both readings are taken.
fn values(text: &str) -> HashSet<String> {
    let split = text.replace(',', " ");
    let lines = text.lines().chain(split.lines());
    let numbers = lines.flat_map(|line| ranges(line).into_iter().map(move |at| &line[at]));
    numbers.map(value_of).collect()
}

/// Returns the values of all numbers in the files of a folder with this ending.
fn values_in(folder: &Path, is_taken: impl Fn(&str) -> bool) -> HashSet<String> {
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let files = files.filter(|path| is_taken(path.file_name().unwrap().to_str().unwrap()));
    files.flat_map(|path| values(&std::fs::read_to_string(path).unwrap())).collect()
}

/// Values in the tables of the newest results, and in the papers'.
fn recorded() -> HashSet<String> {
    let results = std::fs::read_dir(root().join("results")).unwrap();
    let folders = results.map(|entry| entry.unwrap().path()).filter(|path| path.is_dir());
    let is_dated = |path: &Path| path.file_name().unwrap().to_str().unwrap().starts_with("20");
    let newest = folders.filter(|path| is_dated(path)).max().unwrap();
    let mut values = values_in(&newest, |name| name.starts_with("table_"));
    values.extend(values_in(&root().join("experiments/paper"), |name| name.ends_with(".csv")));
    values
}

/// Returns the numbers of a document that have no source.
fn without_source(
    name: &str,
    document: &str,
    printed: &HashSet<String>,
    recorded: &HashSet<String>,
) -> Vec<Number> {
    let is_constant = |number: &Number| {
        let mut listed = CONSTANTS.iter().filter(|constant| constant.document == name);
        listed.any(|constant| constant.number == number.text)
    };
    let has_source = |number: &Number| {
        is_constant(number)
            || (number.digits() >= 3 && printed.contains(&number.value))
            || (number.digits() >= 5 && recorded.contains(&number.value))
    };
    numbers(document).into_iter().filter(|number| !has_source(number)).collect()
}

#[test]
fn every_number_in_the_documents_is_recorded_or_printed_or_a_constant() {
    let (recorded, mut complaints) = (recorded(), Vec::new());
    for run in runs() {
        let name = run.path.strip_prefix(root()).unwrap().to_str().unwrap();
        let printed = values(&run.printed.join("\n"));
        for number in without_source(name, &run.text, &printed, &recorded) {
            complaints.push(format!("{name}:{}: {}", number.line, number.text));
        }
        for command in hidden_commands(&run.text) {
            complaints.push(format!("{name}: the command '{command}' is not shown"));
        }
    }
    assert!(
        complaints.is_empty(),
        "numbers without a source (rules: cli/tests/cli/numbers/):\n{}",
        complaints.join("\n")
    );
}

/// Returns whether a file, or one in a folder, contains `text`.
fn contains(path: &Path, text: &str) -> bool {
    if path.is_dir() {
        let mut entries = std::fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path());
        return entries.any(|path| contains(&path, text));
    }
    std::fs::read_to_string(path).is_ok_and(|content| content.contains(text))
}

#[test]
fn every_constant_in_the_documents_is_what_its_file_says() {
    for Constant { document, number, file, text } in CONSTANTS {
        assert!(contains(&root().join(file), text), "{document}, {number}: {file} lacks '{text}'");
        let content = std::fs::read_to_string(root().join(document)).unwrap();
        let is_used = numbers(&content).iter().any(|found| found.text == *number);
        assert!(is_used, "{document} has no {number}");
    }
}

#[test]
fn an_invented_number_is_found() {
    let recorded = values("4194296,0.1127");
    let complaints = |text: &str| -> Vec<String> {
        let found = without_source("README.md", text, &values("1202 quads of 4,004"), &recorded);
        found.into_iter().map(|number| number.text).collect()
    };
    for invented in ["0.1131 s", "5.3 times as fast", "9 % more", "12 to 13 %", "1,203 quads"] {
        assert!(!complaints(invented).is_empty(), "{invented}");
    }
    assert_eq!(complaints("a\n\n| A1 | 3.5 | 4,194,297 |"), ["3.5", "4,194,297"]);
    assert_eq!(complaints("3 steps\n```text\n0.7\n```\n0.8 `0.9\n1.0` 1.1"), ["0.8", "1.1"]);
    // All rules.
    let sound = "Rust 1.88, Tables 4.3, 4.4 and 6 to 11, section 3.3.1, in 1891, at 150°, 62 × 62, \
                 A1 of 4,194,296 triangles, 1,202 quads, [a](b.md#4.5) https://x.y/1.5 \
                 <!-- 2.5 -->, `0.123`, 24th, x3.5";
    assert_eq!(complaints(sound), Vec::<String>::new());
}

#[test]
fn a_changed_digit_of_a_long_number_is_found() {
    let recorded = recorded();
    let (mut changed, mut missed) = (0, Vec::new());
    for name in ["docs/errata.md", "docs/meshes.md", "docs/reproduction.md"] {
        let document = std::fs::read_to_string(root().join(name)).unwrap();
        for number in numbers(&document).iter().filter(|number| number.digits() >= 5) {
            let last = number.text.chars().next_back().unwrap();
            let other = char::from_digit((last.to_digit(10).unwrap() + 5) % 10, 10).unwrap();
            let wrong = format!("{}{other}", &number.text[..number.text.len() - 1]);
            changed += 1;
            if without_source(name, &wrong, &HashSet::new(), &recorded).is_empty() {
                missed.push(wrong);
            }
        }
    }
    // Some other record may have the changed number by chance.
    assert!(changed >= 10 && 10 * missed.len() <= changed, "{changed} changed, missed {missed:?}");
}

#[test]
fn a_table_measured_by_hand_needs_its_command() {
    let table = "<!-- measured by: make bench -->\n\n| 1.234 |\n\n<!-- end -->\n5.678\n";
    assert_eq!(hidden_commands(table), ["make bench"]);
    let shown = format!("Run `make bench`:\n\n{table}");
    assert!(hidden_commands(&shown).is_empty());
    let texts: Vec<String> = numbers(&shown).into_iter().map(|number| number.text).collect();
    assert_eq!(texts, ["5.678"]);
}
