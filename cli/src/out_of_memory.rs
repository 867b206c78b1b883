//! The end of a process that is refused memory: one line, exit code 2, no half-written file.
//!
//! Called by the allocator, so nothing here may need memory for long: the line is put together on
//! the stack and written without a lock.

use std::io::Write as _;
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
    if IS_ENDING.swap(true, Ordering::SeqCst) {
        std::thread::sleep(GRACE);
    } else {
        let mut line = [0; 256];
        let unwritten = write_line(&mut line, size, stdio::voice().json);
        let length = line.len() - unwritten;
        let _ = rustix::io::write(rustix::stdio::stderr(), &line[..length]);
        triquad::atomic_file::abandon_all();
    }
    std::process::exit(2);
}

/// Writes the line at the start of `line` and returns the number of bytes that are left.
///
/// Experiments take its words for the mark of a run that was out of memory.
fn write_line(mut line: &mut [u8], size: usize, json: bool) -> usize {
    let (before, after) = match json {
        true => ("{\"schema\":\"triquad-failure-1\",\"exit_code\":2,\"message\":\"", "\"}\n"),
        false => ("triquad: ", "\n"),
    };
    let remedy = "raise the limit for memory, or use a machine with more";
    let _ = write!(line, "{before}memory allocation of {size} bytes failed; {remedy}{after}");
    line.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(json: bool) -> String {
        let mut line = [0; 256];
        let unwritten = write_line(&mut line, usize::MAX, json);
        String::from_utf8(line[..256 - unwritten].to_vec()).unwrap()
    }

    #[test]
    fn the_longest_line_has_room_and_is_one() {
        let plain = line(false);
        assert!(plain.starts_with("triquad: memory allocation of 18446744073709551615 bytes"));
        assert!(plain.ends_with("with more\n") && plain.lines().count() == 1);
        let json: serde_json::Value = serde_json::from_str(&line(true)).unwrap();
        assert_eq!(json["exit_code"], 2);
    }
}
