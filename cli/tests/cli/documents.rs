//! What README and documents show: their commands work, their outputs are what is printed, their
//! tables are what the records make.
//!
//! | fence | meaning here |
//! |---|---|
//! | `sh` | run by bash in an empty folder with `triquad` and folders of a clone at hand |
//! | `text output` | printed by the block before it; `…`: anything in a line; alone: any lines |
//! | `csv NAME`, `toml NAME` | a file of that name, there for later blocks |
//!
//! Other fences are not run. Blocks of one document share a folder.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use triquad::Algorithm;

/// A fenced block of a document.
struct Block {
    /// The words behind the fence.
    info: Vec<String>,
    /// The lines between the fences.
    text: String,
}

/// The folder of the repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize().unwrap()
}

/// README and every document, by path.
fn documents() -> Vec<PathBuf> {
    let docs = std::fs::read_dir(root().join("docs")).unwrap().map(|entry| entry.unwrap().path());
    let is_markdown = |path: &PathBuf| path.extension().is_some_and(|extension| extension == "md");
    let mut documents: Vec<PathBuf> = docs.filter(is_markdown).collect();
    documents.sort();
    let others = ["README.md", "examples/meshes/README.md"];
    documents.extend(others.map(|name| root().join(name)));
    documents
}

/// Returns the fenced blocks of a document.
fn blocks(document: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut open: Option<Block> = None;
    for line in document.lines() {
        match (line.strip_prefix("```"), &mut open) {
            (Some(info), None) => {
                let info = info.split_whitespace().map(str::to_owned).collect();
                open = Some(Block { info, text: String::new() });
            }
            (Some(_), Some(_)) => blocks.extend(open.take()),
            (None, Some(block)) => block.text.extend([line, "\n"]),
            (None, None) => {}
        }
    }
    assert!(open.is_none(), "a fence is not closed");
    blocks
}

/// Runs the blocks of a document in `folder`; returns what each prints, or what went wrong.
fn run(document: &str, folder: &Path) -> Result<Vec<String>, String> {
    let mut printed = Vec::<String>::new();
    for block in blocks(document) {
        match block.info.iter().map(String::as_str).collect::<Vec<_>>()[..] {
            ["sh"] => printed.push(shell(&block.text, folder)?),
            ["text", "output"] => {
                let last = printed.last().map_or("", String::as_str);
                if !shows(&block.text, last) {
                    return Err(format!("expected\n{}\nprinted\n{last}", block.text));
                }
            }
            ["csv" | "toml", name] => std::fs::write(folder.join(name), &block.text).unwrap(),
            _ => {}
        }
    }
    Ok(printed)
}

/// A document whose commands were run.
pub struct DocumentRun {
    pub path: PathBuf,
    pub text: String,
    /// Output of each block of commands.
    pub printed: Vec<String>,
    /// The reason why the commands ended early.
    failure: Option<String>,
}

/// Runs the commands of all documents, once for all tests. Two at a time: two tests wait for it.
pub fn runs() -> &'static [DocumentRun] {
    static RUNS: OnceLock<Vec<DocumentRun>> = OnceLock::new();
    let run_one = |path: &PathBuf| {
        let path = path.clone();
        let text = std::fs::read_to_string(&path).unwrap();
        let (printed, failure) = match run(&text, clone().path()) {
            Ok(printed) => (printed, None),
            Err(failure) => (Vec::new(), Some(failure)),
        };
        DocumentRun { path, text, printed, failure }
    };
    RUNS.get_or_init(|| {
        let documents = documents();
        let next = AtomicUsize::new(0);
        let work = || {
            let mine = || documents.get(next.fetch_add(1, Ordering::Relaxed));
            std::iter::from_fn(mine).map(run_one).collect::<Vec<_>>()
        };
        std::thread::scope(|scope| {
            let other = scope.spawn(work);
            let mut runs = work();
            runs.extend(other.join().unwrap());
            runs
        })
    })
}

/// Runs a script that ends with its first failing command; returns all that it prints.
fn shell(script: &str, folder: &Path) -> Result<String, String> {
    let program = Path::new(env!("CARGO_BIN_EXE_triquad"));
    let others = std::env::var_os("PATH").unwrap_or_default();
    let first = program.parent().unwrap().to_owned();
    let path = std::env::join_paths(std::iter::once(first).chain(std::env::split_paths(&others)));
    let output = Command::new("bash")
        .args(["-e", "-u", "-o", "pipefail", "-c", &format!("exec 2>&1\n{script}")])
        .current_dir(folder)
        .env("PATH", path.unwrap())
        .env("TRIQUAD_CACHE", folder.join("cache"))
        .output()
        .expect("bash");
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() { Ok(printed) } else { Err(format!("{script}\n{printed}")) }
}

/// Returns whether `printed` is `expected`, in which `…` stands for anything within a line, and a
/// line of it alone for any lines. The number of blanks and empty lines do not matter.
fn shows(expected: &str, printed: &str) -> bool {
    let lines = |text: &str| {
        let words = text.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" "));
        words.filter(|line| !line.is_empty()).collect::<Vec<_>>()
    };
    is_like(&lines(expected), &lines(printed), &"…".to_owned(), &|expected, printed| {
        let [expected, printed] = [expected, printed].map(|line| line.chars().collect::<Vec<_>>());
        is_like(&expected, &printed, &'…', &|one, other| one == other)
    })
}

/// Returns whether `items` are those of `pattern`, in which `any` stands for any number of them.
fn is_like<T: PartialEq>(pattern: &[T], items: &[T], any: &T, is: &dyn Fn(&T, &T) -> bool) -> bool {
    match (pattern, items) {
        ([], _) => items.is_empty(),
        ([first, rest @ ..], _) if first == any => {
            (0..=items.len()).any(|skipped| is_like(rest, &items[skipped..], any, is))
        }
        ([first, rest @ ..], [item, others @ ..]) => {
            is(first, item) && is_like(rest, others, any, is)
        }
        (_, []) => false,
    }
}

/// An empty folder with links to what a clone has.
fn clone() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let link = |name: &str| {
        std::os::unix::fs::symlink(root().join(name), folder.path().join(name)).unwrap();
    };
    ["docs", "examples", "experiments"].into_iter().for_each(link);
    // Committed records; what commands write goes beside them.
    std::fs::create_dir(folder.path().join("results")).unwrap();
    for entry in std::fs::read_dir(root().join("results")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        if name.starts_with("20") || name.starts_with("quality-20") {
            link(&format!("results/{name}"));
        }
    }
    folder
}

/// Whoever tries the documents in a clone finds nothing new in `git status`.
#[test]
fn what_the_documents_write_into_a_clone_is_ignored_by_git() {
    if !root().join(".git").exists() {
        println!("skipped: no clone");
        return;
    }
    let written = |block: Block| -> Vec<String> {
        match block.info.iter().map(String::as_str).collect::<Vec<_>>()[..] {
            ["csv" | "toml", name] => vec![name.to_owned()],
            ["sh"] => {
                let words: Vec<&str> = block.text.split_whitespace().collect();
                let is_out = |pair: &&[&str]| pair[0] == "--out";
                words
                    .windows(2)
                    .filter(is_out)
                    .map(|pair| format!("{}/runs.csv", pair[1]))
                    .collect()
            }
            _ => Vec::new(),
        }
    };
    let texts = documents().into_iter().map(|path| std::fs::read_to_string(path).unwrap());
    let written: BTreeSet<String> =
        texts.flat_map(|text| blocks(&text)).flat_map(written).collect();
    assert!(written.contains("results/programs/runs.csv"), "{written:?}");
    for path in written {
        let mut git = Command::new("git");
        let found = git.args(["check-ignore", "-q", &path]).current_dir(root()).status();
        assert!(found.unwrap().success(), "{path} is not ignored");
    }
}

#[test]
fn every_command_in_the_documents_works() {
    let failure =
        |run: &DocumentRun| Some(format!("{}: {}", run.path.display(), run.failure.as_ref()?));
    let failures: Vec<_> = runs().iter().filter_map(failure).collect();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    let commands: usize = runs().iter().map(|run| run.printed.len()).sum();
    assert!(commands > 10, "only {commands} blocks");
}

#[test]
fn a_wrong_command_or_a_wrong_output_in_a_document_is_found() {
    let convert = "triquad convert examples/meshes/plate.obj.gz -o quads.obj";
    let ok = |document: &str| run(document, clone().path()).is_ok();
    assert!(ok(&format!("```sh\n{convert}\n```\n```text output\n…1202 quads…\n```\n")));
    assert!(!ok(&format!("```sh\n{convert}\n```\n```text output\n…1203 quads…\n```\n")));
    assert!(!ok(&format!("```sh\n{convert}\n```\n```text output\n1202 quads\n```\n")));
    assert!(!ok("```sh\ntriquad convert absent.obj -o quads.obj\n```\n"));
    // A failure in the midst of a block is not covered up by its end, nor one in a pipe.
    assert!(!ok("```sh\ntriquad convert absent.obj -o quads.obj\ntrue\n```\n"));
    assert!(!ok("```sh\ntriquad info absent.obj | cat\n```\n"));
}

#[test]
fn dots_in_an_expected_output_stand_for_anything_within_a_line_or_for_lines() {
    assert!(shows("a b", "a  b\n\n"));
    assert!(!shows("a b", "a\n  b\n"));
    assert!(shows("a … c", "a b c"));
    assert!(shows("a …", "a b c"));
    assert!(shows("… c", "a b c"));
    assert!(shows("a … c … e", "a b c d c e"));
    assert!(!shows("a", "a b"));
    assert!(!shows("b …", "a b c"));
    assert!(!shows("… b", "a b c"));
    assert!(!shows("a … c", "a b\nb c"));
    assert!(!shows("a …\ne", "a b\nc\ne"));
    assert!(shows("a\n…\ne", "a\nb\nc\ne"));
    assert!(shows("…\ne …\n…", "a\ne\ne f"));
    assert!(!shows("…\nc\n…", "a\nb\nd c\n"));
}

/// Returns the words of `text` that begin with two dashes.
pub fn long_options(text: &str) -> BTreeSet<String> {
    let is_part = |c: char| c.is_ascii_lowercase() || c == '-';
    let option = |rest: &str| rest.split(|c| !is_part(c)).next().unwrap_or_default().to_owned();
    let found = text.match_indices("--").map(|(at, _)| option(&text[at..]));
    found.filter(|option| option.len() > 2 && !option.starts_with("---")).collect()
}

/// Returns the help of the program, or of a verb of it.
pub fn help(verbs: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_triquad"));
    let output = command.args(verbs).arg("--help").output().unwrap();
    String::from_utf8(output.stdout).unwrap()
}

/// Returns the verbs that a help text lists.
pub fn verbs(help: &str) -> Vec<String> {
    let list = help.split("Commands:\n").nth(1).unwrap_or_default();
    let list = list.split("\n\n").next().unwrap_or_default();
    let lines = list.lines().filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    let words = lines.filter_map(|line| line.split_whitespace().next());
    words.filter(|&word| word != "help").map(str::to_owned).collect()
}

#[test]
fn the_page_of_the_command_has_every_verb_and_every_option_and_no_others() {
    let page = std::fs::read_to_string(root().join("docs/cli.md")).unwrap();
    let mut options = long_options("--help --version");
    let verbs_of_all = verbs(&help(&[]));
    assert!(verbs_of_all.len() > 10, "{verbs_of_all:?}");
    for verb in &verbs_of_all {
        assert!(page.contains(&format!("`{verb}")), "{verb} is missing");
        let text = help(&[verb]);
        for second in verbs(&text) {
            assert!(page.contains(&format!("`{second}")), "{verb} {second} is missing");
            options.extend(long_options(&help(&[verb, &second])));
        }
        options.extend(long_options(&text));
    }
    let on_page = long_options(&page);
    let missing: Vec<_> = options.difference(&on_page).collect();
    assert!(
        missing.iter().all(|&option| option == "--help" || option == "--version"),
        "{missing:?}"
    );
    let invented: Vec<_> = on_page.difference(&options).collect();
    assert!(invented.is_empty(), "{invented:?}");
}

/// Returns the arguments of a help text under each of its headings.
fn arguments_by_heading(help: &str) -> BTreeMap<String, BTreeSet<String>> {
    let mut found: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut heading = String::new();
    for line in help.lines() {
        let depth = line.len() - line.trim_start().len();
        if line.is_empty() {
            continue;
        }
        if depth == 0 {
            heading = line.strip_suffix(':').unwrap_or_default().to_owned();
        } else if depth <= 6 && line.trim_start().starts_with(['-', '<', '[']) {
            found.entry(heading.clone()).or_default().insert(line.trim_start().to_owned());
        }
    }
    found
}

/// A heading holds what it names: `clap` hands it on to what is declared after its group.
#[test]
fn every_argument_stands_under_its_heading() {
    let page = std::fs::read_to_string(root().join("docs/cli.md")).unwrap();
    let aims = page.split("What `best` aims at").nth(1).unwrap().split("\n\n").nth(1).unwrap();
    let everywhere = page.split("| option, before or after").nth(1).unwrap();
    let everywhere = everywhere.split("\n\n").next().unwrap();
    let tables = BTreeMap::from([("What best aims at", aims), ("Everywhere", everywhere)]);
    let mut texts = Vec::new();
    for verb in verbs(&help(&[])) {
        let text = help(&[&verb]);
        texts.extend(verbs(&text).iter().map(|second| help(&[&verb, second])));
        texts.push(text);
    }
    let mut seen = BTreeSet::new();
    for text in &texts {
        for (heading, arguments) in arguments_by_heading(text) {
            let is_place = |argument: &String| argument.starts_with(['<', '[']);
            let places = arguments.iter().filter(|argument| is_place(argument)).count();
            let expected = if heading == "Arguments" { arguments.len() } else { 0 };
            assert_eq!(places, expected, "{heading}: {arguments:?}");
            let options = arguments.iter().flat_map(|argument| {
                let name = argument.split("  ").next().unwrap_or_default();
                long_options(name.split(['<', '[']).next().unwrap_or_default())
            });
            let options: BTreeSet<String> = options.collect();
            match tables.get(heading.as_str()) {
                Some(table) => assert_eq!(options, long_options(table), "{heading}"),
                None => assert!(["Arguments", "Options"].contains(&&*heading), "{heading}"),
            }
            seen.insert(heading);
        }
    }
    assert_eq!(seen.len(), 4, "{seen:?}");
}

/// README has a selection.
#[test]
fn every_algorithm_is_named_where_algorithms_are_listed() {
    let lists = ["CONTRIBUTING.md", "docs/cli.md", "docs/algorithms.md"];
    let mut missing = Vec::new();
    for file in lists.into_iter().chain(["CHANGELOG.md", "python/triquad/_convert.py"]) {
        let text = std::fs::read_to_string(root().join(file)).unwrap();
        for id in Algorithm::ALL.map(Algorithm::id) {
            let named =
                text.contains(&format!("`{id}`")) || text.contains(&format!("--algorithm {id}`"));
            if !named {
                missing.push(format!("{file}: `{id}`"));
            }
        }
    }
    // The table that `--compare` prints: what `…` stands for may hide a row.
    let quality = std::fs::read_to_string(root().join("docs/quality.md")).unwrap();
    let has_row = |id: &&str| quality.contains(&format!("\n{id:<10}  "));
    let ids = triquad::Algorithm::ALL.map(triquad::Algorithm::id);
    let rows = ids.into_iter().filter(|id| !has_row(id));
    missing.extend(rows.map(|id| format!("docs/quality.md, output of --compare: {id}")));
    assert!(missing.is_empty(), "lists of algorithms that lack one: {missing:?}");
}

/// Returns whether a character may stand in the id of an algorithm.
fn is_of_id(c: char) -> bool {
    c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-'
}

/// Returns the ids of algorithms that are words of `text`.
fn algorithms_in(text: &str) -> BTreeSet<&'static str> {
    let words: BTreeSet<&str> = text.split(|c| !is_of_id(c)).collect();
    Algorithm::ALL.map(Algorithm::id).into_iter().filter(|id| words.contains(id)).collect()
}

#[test]
fn ids_of_algorithms_begin_with_a_letter_and_have_letters_digits_and_hyphens() {
    for id in Algorithm::ALL.map(Algorithm::id) {
        assert!(id.starts_with(|c: char| c.is_ascii_lowercase()), "{id}");
        assert!(id.chars().all(is_of_id), "{id}");
    }
    assert_eq!(algorithms_in("`best2`, x-tq and `sg`."), BTreeSet::from(["sg"]));
}

#[test]
fn lists_of_what_open_works_with_are_those_of_the_algorithms() {
    let (open, closed): (Vec<_>, Vec<_>) =
        Algorithm::ALL.into_iter().partition(|algorithm| algorithm.works_on_open());
    let ids = |list: Vec<Algorithm>| list.into_iter().map(Algorithm::id).collect();
    let [open, closed]: [BTreeSet<&str>; 2] = [open, closed].map(ids);
    let file = |name: &str| std::fs::read_to_string(root().join(name)).unwrap();
    // Each list, and what stands before it and behind it.
    let lists = [
        ("--help", help(&["convert"]), "written as triangles. For ", "\n\n", &open),
        ("docs/cli.md", file("docs/cli.md"), "triangles are left over. For ", "|\n", &open),
        ("docs/convert.md", file("docs/convert.md"), "`--open` works with ", ".\n", &open),
        (
            "docs/convert.md",
            file("docs/convert.md"),
            "\n- Closed, two-sided surfaces only: ",
            ";",
            &closed,
        ),
        (
            "python/triquad/_convert.py",
            file("python/triquad/_convert.py"),
            "one-sided ones. The fewest triangles are left over.",
            "only.",
            &open,
        ),
    ];
    let mut wrong = Vec::new();
    for (name, text, before, behind, expected) in &lists {
        let list = text.split_once(before).and_then(|(_, rest)| rest.split_once(behind));
        let (list, _) = list.unwrap_or_else(|| panic!("{name}: no list behind {before:?}"));
        let found = algorithms_in(list);
        let missing: Vec<_> = expected.difference(&found).collect();
        let invented: Vec<_> = found.difference(expected).collect();
        if !missing.is_empty() || !invented.is_empty() {
            wrong.push(format!(
                "{name}, behind {before:?}: lacks {missing:?}, must not have {invented:?}"
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Returns the targets of the links and pictures of a document that are files.
fn linked_files(document: &str) -> impl Iterator<Item = &str> {
    let targets = document.split("](").skip(1).filter_map(|rest| rest.split([')', '#']).next());
    targets.filter(|target| !target.is_empty() && !target.contains("://"))
}

#[test]
fn every_link_to_a_file_leads_to_one() {
    let others = ["CONTRIBUTING.md", "CHANGELOG.md", "experiments/README.md", "results/README.md"];
    for path in documents().into_iter().chain(others.map(|name| root().join(name))) {
        let document = std::fs::read_to_string(&path).unwrap();
        for target in linked_files(&document) {
            let file = path.parent().unwrap().join(target);
            assert!(file.exists(), "{}: {target}", path.display());
        }
    }
    assert_eq!(linked_files("[a](b.md#c) ![d](e/f.svg) [g](#h) [i](https://j.k)").count(), 2);
}
