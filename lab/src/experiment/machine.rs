//! Facts about the machine and the build that rows of results refer to.

use sysinfo::System;

use super::results::MachineFacts;
use crate::file_hash::hash_of_bytes;
pub use crate::file_hash::{hash_of_file, hash_of_words};

/// The build of the program.
#[derive(Clone, Copy, Debug)]
pub struct Build {
    /// Profile of Cargo.
    pub profile: &'static str,
    /// Commit of the sources; empty if it is not known.
    pub commit: &'static str,
}

/// Returns the facts about this machine and this `build` that may change times.
pub fn facts(build: Build) -> MachineFacts {
    let mut system = System::new();
    system.refresh_memory();
    system.refresh_cpu_all();
    let cpu = system.cpus().first();
    let gibibytes = |bytes: u64| format!("{:.1} GiB", bytes as f64 / f64::from(1 << 30));
    let facts = [
        ("processor", cpu.map(|cpu| cpu.brand().trim().to_owned())),
        ("cores", Some(system.cpus().len().to_string())),
        ("memory", Some(gibibytes(system.total_memory()))),
        ("system", System::long_os_version()),
        ("kernel", System::kernel_version()),
        ("architecture", Some(System::cpu_arch())),
        ("governor", governor()),
        ("compiler", Some(format!("rustc {}", rustc_version_runtime::version()))),
        ("profile", Some(build.profile.into())),
        ("program", Some(program())),
        ("commit", Some(build.commit.into()).filter(|commit: &String| !commit.is_empty())),
    ];
    facts.into_iter().filter_map(|(name, fact)| Some((name.to_owned(), fact?))).collect()
}

/// Returns name and version of the program.
pub fn program() -> String {
    concat!("triquad ", env!("CARGO_PKG_VERSION")).into()
}

/// Returns a short name for `facts`, the same for equal ones.
pub fn name_of(facts: &MachineFacts) -> String {
    let text: String = facts.iter().map(|(name, fact)| format!("{name}={fact}\n")).collect();
    hash_of_bytes(text.as_bytes())[..8].to_owned()
}

fn governor() -> Option<String> {
    let path = "/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor";
    Some(std::fs::read_to_string(path).ok()?.trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_facts_have_one_name() {
        let facts = facts(Build { profile: "release", commit: "" });
        assert!(!facts.contains_key("commit"), "{facts:?}");
        assert!(facts.contains_key("cores") && facts.contains_key("compiler"), "{facts:?}");
        let mut other = facts.clone();
        other.insert("cores".into(), "many".into());
        assert_eq!(name_of(&facts), name_of(&facts.clone()));
        assert_ne!(name_of(&facts), name_of(&other));
    }
}
