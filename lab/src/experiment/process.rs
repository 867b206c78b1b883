//! One run in a process of its own: fresh memory, a limit of time, a limit of memory.

use std::ffi::OsString;
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use process_control::{ChildExt, Control, ExitStatus, Output};

use super::record::Outcome;
use super::spec::Limits;

/// Set for the processes of runs: they end with the process that started them.
pub const RUN_VARIABLE: &str = "TRIQUAD_RUN";

/// Value of [`RUN_VARIABLE`] with which `triquad` becomes the program that its arguments name, so
/// that this program ends with the experiment too.
pub const BECOME: &str = "become";

/// Exit code of a `triquad` that was interrupted.
pub const INTERRUPTED: i32 = 130;

/// Messages of Rust, Python and C++ when memory is refused.
const OUT_OF_MEMORY: [&str; 3] = ["memory allocation of", "MemoryError", "std::bad_alloc"];

/// Time that an interrupt may take from a run's process to this one.
const GRACE: Duration = Duration::from_secs(1);

/// Outcome of a run's process.
#[derive(Clone, Debug, PartialEq)]
pub struct Ending {
    /// Outcome.
    pub outcome: Outcome,
    /// Why, where that is not `ok`.
    pub reason: String,
    /// Its standard output.
    pub output: Vec<u8>,
    /// Most memory that it had, where that was watched.
    pub peak_memory_bytes: Option<u64>,
}

/// Interval at which the memory of an external program is read.
const SAMPLE_EVERY: Duration = Duration::from_millis(5);

/// Runs `program` with `arguments` and waits for its end.
///
/// # Errors
/// The process cannot be started or waited for.
pub fn run(program: &Path, arguments: &[OsString], limits: Limits) -> io::Result<Ending> {
    let mut command = Command::new(program);
    command.args(arguments).env(RUN_VARIABLE, "1");
    wait(command, limits, false)
}

/// Runs a command that is not ours and waits for its end; watches its memory on Linux.
///
/// On Unix `ours` becomes that command, so that it ends with the process that started it.
///
/// # Errors
/// The process cannot be started or waited for.
pub fn run_foreign(ours: &Path, words: &[String], limits: Limits) -> io::Result<Ending> {
    let mut command = if cfg!(unix) {
        let mut command = Command::new(ours);
        command.args(words).env(RUN_VARIABLE, BECOME);
        command
    } else {
        let mut command = Command::new(&words[0]);
        command.args(&words[1..]);
        command
    };
    // Python leaves no caches beside the scripts of experiments.
    command.env("PYTHONDONTWRITEBYTECODE", "1");
    wait(command, limits, true)
}

fn wait(mut command: Command, limits: Limits, is_watched: bool) -> io::Result<Ending> {
    let child =
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn()?;
    let process = child.id();
    let control = child
        .controlled_with_output()
        .time_limit(Duration::from_secs(limits.timeout_seconds))
        .terminate_for_timeout();
    #[cfg(any(target_os = "linux", windows))]
    let control = control.memory_limit(limits.memory_gigabytes as usize * 1_000_000_000);
    let is_over = AtomicBool::new(false);
    let (output, peak_memory_bytes) = std::thread::scope(|scope| {
        let watch = is_watched.then(|| scope.spawn(|| watch_memory(process, &is_over)));
        let output = control.wait();
        is_over.store(true, Ordering::Relaxed);
        let peak = watch.and_then(|watch| {
            watch.thread().unpark();
            watch.join().ok().flatten()
        });
        (output, peak)
    });
    let ending = match output? {
        None => {
            Ending::bad(Outcome::Timeout, format!("stopped after {} s", limits.timeout_seconds))
        }
        Some(output) => {
            if was_stopped(output.status) {
                // A terminal or a batch system stops both: then this process ends here, before a
                // row says that the run has crashed.
                std::thread::sleep(GRACE);
            }
            Ending::from(output)
        }
    };
    Ok(Ending { peak_memory_bytes, ..ending })
}

/// Returns the most memory that a process had until it was over, as of the last look.
fn watch_memory(process: u32, is_over: &AtomicBool) -> Option<u64> {
    let mut peak = None;
    while !is_over.load(Ordering::Relaxed) {
        peak = peak_memory(process).max(peak);
        std::thread::park_timeout(SAMPLE_EVERY);
    }
    peak
}

/// Reads `VmHWM` of a process, where the system has it.
fn peak_memory(process: u32) -> Option<u64> {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().trim_end_matches(" kB").parse().ok()?;
    Some(1024 * kibibytes)
}

/// Returns whether a process was ended from outside.
fn was_stopped(status: ExitStatus) -> bool {
    status.code().is_none_or(|code| code == i64::from(INTERRUPTED))
}

impl Ending {
    fn bad(outcome: Outcome, reason: String) -> Self {
        Self { outcome, reason, output: Vec::new(), peak_memory_bytes: None }
    }
}

impl From<Output> for Ending {
    fn from(output: Output) -> Self {
        let stderr = String::from_utf8_lossy(&output.stderr);
        let last_line = stderr.lines().rfind(|line| !line.trim().is_empty()).unwrap_or_default();
        if output.status.success() {
            let ok = Self::bad(Outcome::Ok, String::new());
            return Self { output: output.stdout, ..ok };
        }
        let outcome = match output.status.code() {
            _ if OUT_OF_MEMORY.iter().any(|words| stderr.contains(words)) => Outcome::OutOfMemory,
            // A check failed, or the mesh was refused.
            Some(1 | 2) => Outcome::Invalid,
            _ => Outcome::Crash,
        };
        Self::bad(outcome, reason(output.status, last_line))
    }
}

/// Returns the reason of a bad end in one line.
fn reason(status: ExitStatus, last_line: &str) -> String {
    let status = match status.code() {
        Some(code) => format!("exit code {code}"),
        None => status.to_string(),
    };
    let reason = format!("{status}: {last_line}");
    reason.trim_end_matches(": ").split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(all(test, unix))]
mod tests {
    use std::time::Instant;

    use super::*;

    fn ending(script: &str, timeout_seconds: u64) -> Ending {
        let arguments = ["-c".into(), script.into()];
        let limits = Limits { timeout_seconds, memory_gigabytes: 1 };
        run(Path::new("/bin/sh"), &arguments, limits).unwrap()
    }

    #[test]
    fn every_ending_has_its_word() {
        let ok = ending("echo said", 9);
        assert_eq!((ok.outcome, &ok.output[..]), (Outcome::Ok, &b"said\n"[..]));
        let outcome = |script, reason: &str| {
            let ending = ending(script, 1);
            assert!(ending.reason.contains(reason), "{}", ending.reason);
            ending.outcome
        };
        assert_eq!(outcome("echo why >&2; exit 1", "exit code 1: why"), Outcome::Invalid);
        assert_eq!(outcome("exit 101", "exit code 101"), Outcome::Crash);
        assert_eq!(outcome("kill -9 $$", "signal"), Outcome::Crash);
        let hungry = "echo 'memory allocation of 9 bytes failed' >&2; kill -6 $$";
        assert_eq!(outcome(hungry, "memory"), Outcome::OutOfMemory);
        assert_eq!(outcome("exec sleep 60", "stopped after 1 s"), Outcome::Timeout);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn memory_is_limited() {
        let limit = ending("sleep 0.3; ulimit -v", 9).output;
        assert_eq!(String::from_utf8(limit).unwrap().trim(), (1_000_000_000 / 1024).to_string());
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn the_memory_of_a_foreign_program_is_watched() {
        let words = ["exec", "sleep", "0.1"].map(str::to_owned);
        let limits = Limits { timeout_seconds: 9, memory_gigabytes: 1 };
        let folder = tempfile::tempdir().unwrap();
        let ours = folder.path().join("become");
        std::fs::write(&ours, "#!/bin/sh\n\"$@\"\n").unwrap();
        use std::os::unix::fs::PermissionsExt;
        std::fs::set_permissions(&ours, std::fs::Permissions::from_mode(0o755)).unwrap();
        let ending = run_foreign(&ours, &words, limits).unwrap();
        assert_eq!(ending.outcome, Outcome::Ok, "{}", ending.reason);
        assert!(ending.peak_memory_bytes.is_some_and(|bytes| bytes > 100_000), "{ending:?}");
    }

    #[test]
    fn there_is_time_for_an_interrupt_before_a_run_counts_as_crashed() {
        let start = Instant::now();
        assert_eq!(ending("exit 130", 9).outcome, Outcome::Crash);
        assert!(start.elapsed() >= GRACE);
    }

    #[test]
    fn everything_that_a_process_says_is_read() {
        let long = ending("head -c 300000 /dev/zero | tr '\\0' x >&2; echo '{}'", 9);
        assert_eq!(long.outcome, Outcome::Ok);
    }
}
