//! Commands in messages, to be pasted into a shell.

use std::path::Path;

/// Returns a file's name as a word of a shell: in double quotes if it has other characters than a
/// plain word, as messages have single quotes round commands.
pub fn word(path: &Path) -> String {
    let name = path.display().to_string();
    let is_plain = |c: char| c.is_alphanumeric() || "-_./:,+@%=".contains(c);
    // A name that begins with a hyphen would be taken for an option.
    let name = if name.len() > 1 && name.starts_with('-') { format!("./{name}") } else { name };
    if !name.is_empty() && name.chars().all(is_plain) {
        return name;
    }
    let special = if cfg!(windows) { "" } else { "\\\"$`" };
    let escape = |c: char| if special.contains(c) { vec!['\\', c] } else { vec![c] };
    format!("\"{}\"", name.chars().flat_map(escape).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_one_word_of_a_shell() {
        for (name, word_of_shell) in [
            ("scans/part-1.obj.gz", "scans/part-1.obj.gz"),
            ("größe.obj", "größe.obj"),
            ("-", "-"),
            ("-v.obj", "./-v.obj"),
            ("my part.obj", "\"my part.obj\""),
            ("it's (1).obj", "\"it's (1).obj\""),
        ] {
            assert_eq!(word(Path::new(name)), word_of_shell);
        }
    }

    #[test]
    #[cfg(unix)]
    fn a_shell_reads_the_name_back() {
        for name in ["a b.obj", "$HOME `id`.obj", "a\"b\\c.obj", "it's.obj", "a;b&c|d>e*.obj"] {
            let script = format!("printf %s {}", word(Path::new(name)));
            let run = std::process::Command::new("sh").args(["-c", &script]).output().unwrap();
            assert_eq!(String::from_utf8(run.stdout).unwrap(), name);
        }
    }
}
