//! The end of a process that is refused memory: one line, exit code 2, no half-written file.
//!
//! Called by the allocator, so nothing here may need memory for long: the line is put together on
//! the stack and written without a lock.

use std::fmt::Arguments;
use std::io::Write as _;
use std::panic::PanicHookInfo;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use crate::stdio;

/// Set by the first thread that is refused memory.
static IS_ENDING: AtomicBool = AtomicBool::new(false);

/// Time for the first thread to print and clean up.
const GRACE: Duration = Duration::from_secs(1);

/// Ends the process because `size` bytes were refused.
#[cold]
pub fn end(size: usize) -> ! {
    end_without(format_args!("{size} bytes"))
}

/// Ends the process, too, where a new thread is refused what the standard library allots to it past
/// the allocator: it would panic, with a message of its own beside ours.
pub fn include_threads() {
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        if is_of_new_thread(panic) {
            end_without(format_args!("a stack for signals"));
        }
        usual(panic);
    }));
}

fn is_of_new_thread(panic: &PanicHookInfo) -> bool {
    let message = panic.payload().downcast_ref::<String>();
    message.is_some_and(|message| message.contains("failed to allocate an alternative stack"))
}

fn end_without(refused: Arguments) -> ! {
    if IS_ENDING.swap(true, Ordering::SeqCst) {
        std::thread::sleep(GRACE);
    } else {
        let mut line = [0; 256];
        let unwritten = write_line(&mut line, refused, stdio::voice().json);
        let length = line.len() - unwritten;
        let _ = rustix::io::write(rustix::stdio::stderr(), &line[..length]);
        triquad::atomic_file::abandon_all();
    }
    std::process::exit(2);
}

/// Writes the line at the start of `line` and returns the number of bytes that are left.
///
/// Experiments take its words for the mark of a run that was out of memory.
fn write_line(mut line: &mut [u8], refused: Arguments, json: bool) -> usize {
    let (before, after) = match json {
        true => (
            "{\"schema\":\"triquad-failure-1\",\"exit_code\":2,\"message\":\"",
            "\",\"file\":null,\"law\":null,\"element\":null,\"count\":null,\"remedy\":null}\n",
        ),
        false => ("triquad: ", "\n"),
    };
    let remedy = "raise the limit for memory, or use a machine with more";
    let _ = write!(line, "{before}memory allocation of {refused} failed; {remedy}{after}");
    line.len()
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn line(json: bool) -> String {
        let mut line = [0; 256];
        let unwritten = write_line(&mut line, format_args!("{} bytes", usize::MAX), json);
        String::from_utf8(line[..256 - unwritten].to_vec()).unwrap()
    }

    #[test]
    fn the_longest_line_has_room_and_is_one() {
        let plain = line(false);
        assert!(plain.starts_with("triquad: memory allocation of 18446744073709551615 bytes"));
        assert!(plain.ends_with("with more\n") && plain.lines().count() == 1);
        let json: serde_json::Value = serde_json::from_str(&line(true)).unwrap();
        assert_eq!((&json["exit_code"], json.get("remedy")), (&2.into(), Some(&json!(null))));
    }

    #[test]
    fn the_panic_of_a_thread_without_a_stack_for_signals_is_known() {
        let usual = std::panic::take_hook();
        let known = std::sync::Arc::new(AtomicBool::new(false));
        let seen = std::sync::Arc::clone(&known);
        std::panic::set_hook(Box::new(move |panic| {
            seen.fetch_or(is_of_new_thread(panic), Ordering::SeqCst);
        }));
        for (message, expected) in [
            ("failed to allocate a guard page", false),
            (
                // As the standard library words it.
                "failed to allocate an alternative stack: Cannot allocate memory (os error 12)",
                true,
            ),
        ] {
            let _ = std::panic::catch_unwind(|| panic!("{message}"));
            assert_eq!(known.load(Ordering::SeqCst), expected, "{message}");
        }
        std::panic::set_hook(usual);
    }
}
