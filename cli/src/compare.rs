//! `triquad compare`.

use std::path::{Path, PathBuf};

use triquad::counted::counted;
use triquad_lab::experiment::Results;
use triquad_lab::report::baseline::{self, BaselineTable};
use triquad_lab::report::{self as lab_report, Judged, Summary, Verdict, compare};

use crate::failure::Failure;
use crate::{report, shell, stdio};

/// Judge every claim of the two papers on the records of a results folder
///
/// Prints a line for each claim: verdict, name, our number, the paper's, and the reason if it is
/// not reproduced. Counts of verdicts follow. Claims that differ are no failure. If none can be
/// judged, it prints that alone.
///
/// With --baseline it prints the tables instead, number by number: ours, the baseline's, their
/// ratio, and its 95 % interval where runs were repeated. They are written to DIR/baseline, too.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  \
                        triquad compare results/laptop\n  \
                        triquad compare results/laptop --baseline paper\n  \
                        triquad compare results/laptop --baseline results/desktop")]
pub struct Arguments {
    /// The results folder
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// The baseline of the tables: 'paper', or another results folder
    #[arg(long, value_name = "paper|DIR")]
    baseline: Option<PathBuf>,
}

/// Prints the verdicts, or the tables against the baseline.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let results = report::read(&arguments.folder)?;
    let summary = Summary::new(&results);
    match &arguments.baseline {
        None => print_verdicts(&arguments.folder, &summary),
        Some(baseline) => print_baseline(&arguments.folder, &summary, baseline),
    }
}

fn print_verdicts(folder: &Path, summary: &Summary) -> Result<(), Failure> {
    let comparison = compare::judge(summary);
    if !comparison.says_anything() {
        let why = match comparison.nearest() {
            Some(Judged { id, lacks, .. }) => format!("the nearest, {id}, lacks {lacks}"),
            None => "they need the papers' algorithms on the papers' meshes".into(),
        };
        let file = folder.join("compare.csv");
        let file = match file.exists() {
            true => format!("see {}", file.display()),
            false => format!("'triquad report {}' writes all reasons", shell::word(folder)),
        };
        return stdio::say(&format!(
            "{}: none of the {} claims of the papers can be judged: {why}; {file}",
            folder.display(),
            comparison.verdicts.len()
        ));
    }
    let width = comparison.verdicts.iter().map(|judged| judged.id.len()).max().unwrap_or(0);
    for judged in &comparison.verdicts {
        stdio::say(&line(judged, width))?;
    }
    let counts = Verdict::ALL.map(|v| format!("{} {}", comparison.count(v), v.name()));
    stdio::say(&format!("{} claims: {}", comparison.verdicts.len(), counts.join(", ")))
}

/// Writes one claim in columns.
fn line(judged: &Judged, width: usize) -> String {
    let number = |number: &String| if number.is_empty() { "-".into() } else { number.clone() };
    let (ours, paper) = (number(&judged.ours), number(&judged.paper));
    let why = match judged.verdict {
        Verdict::Reproduced => String::new(),
        _ => format!("  ({})", judged.reason),
    };
    format!(
        "{:<18}  {:<width$}  ours {ours} | paper {paper}{why}",
        judged.verdict.name(),
        judged.id
    )
}

fn print_baseline(folder: &Path, summary: &Summary, with: &Path) -> Result<(), Failure> {
    let compared = if with.as_os_str() == "paper" {
        baseline::against_paper(summary)
    } else {
        let theirs: Results = report::read(with)?;
        baseline::against(summary, &Summary::new(&theirs))
    };
    let (folder_name, with) = (folder.display(), with.display());
    let tables = &compared.tables;
    if tables.is_empty() {
        return Err(Failure::bad(format!(
            "{folder_name}: no number can be compared with {with}: {}",
            compared.why_none
        )));
    }
    let written = lab_report::write_baseline(folder, tables)
        .map_err(|error| Failure::bad(error.to_string()))?;
    for table in tables {
        print_table(table)?;
    }
    let numbers: usize = tables.iter().map(|table| table.rows.len()).sum();
    if let Some(meshes) = compared.left_out() {
        let what = "numbers that depend on size are left out";
        stdio::say(&format!("{folder_name}: {what}: {meshes}"))?;
    }
    stdio::say(&format!(
        "{}: {} of {}, ours divided by those of {with}",
        written.display(),
        counted(numbers, "number", "numbers"),
        counted(tables.len(), "table", "tables"),
    ))
}

/// Prints the columns of a table under each other.
fn print_table(table: &BaselineTable) -> Result<(), Failure> {
    stdio::say(&format!("{}: {}", table.file, table.title))?;
    let header = ["mesh", "algorithm", "number", "ours", "theirs", "ratio", "95 %", ""];
    let mut lines = vec![header.map(str::to_owned)];
    lines.extend(table.rows.iter().map(|row| {
        let mut fields = row.fields();
        let [.., low, high] = &mut fields;
        if !low.is_empty() {
            *low = format!("[{low}, {high}]");
        }
        high.clear();
        fields
    }));
    let width = |at: usize| lines.iter().map(|line| line[at].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..header.len()).map(width).collect();
    for line in &lines {
        let padded = line.iter().zip(&widths).enumerate().map(|(at, (field, &width))| match at {
            3..=5 => format!("{field:>width$}"),
            _ => format!("{field:<width$}"),
        });
        let line = padded.collect::<Vec<_>>().join("  ");
        stdio::say(&format!("  {}", line.trim_end()))?;
    }
    stdio::say("")
}
