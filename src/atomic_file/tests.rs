use std::io::{self, Write};
use std::path::Path;

use super::AtomicFile;

fn entries(folder: &Path) -> usize {
    std::fs::read_dir(folder).unwrap().count()
}

#[test]
fn nothing_appears_before_commit_and_nothing_stays_without() {
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("a.txt");
    let mut file = AtomicFile::create(&target).unwrap();
    file.write_all(b"new").unwrap();
    assert!(!target.exists());
    drop(file);
    assert_eq!(entries(folder.path()), 0);

    std::fs::write(&target, "old").unwrap();
    let mut file = AtomicFile::create(&target).unwrap();
    file.write_all(b"new").unwrap();
    assert_eq!(std::fs::read_to_string(&target).unwrap(), "old");
    file.commit().unwrap();
    assert_eq!(std::fs::read_to_string(&target).unwrap(), "new");
    assert_eq!(entries(folder.path()), 1);
}

#[cfg(target_os = "linux")]
#[test]
fn a_file_has_no_name_before_it_is_complete_and_both_ways_agree() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.txt");
    if super::nameless::open(folder.path()).is_none() {
        println!("skipped: no files without a name here");
        return;
    }
    let mut file = AtomicFile::create(&path).unwrap();
    file.write_all(&[7; 100_000]).unwrap();
    assert_eq!(entries(folder.path()), 0);
    file.commit().unwrap();
    let other = folder.path().join("b.txt");
    let mut file = AtomicFile(super::file::Kind::named(other.clone()).unwrap());
    file.write_all(&[7; 100_000]).unwrap();
    assert_eq!(entries(folder.path()), 2);
    file.commit().unwrap();
    assert_eq!(std::fs::read(&path).unwrap(), std::fs::read(&other).unwrap());
    let modes = [&path, &other].map(|path| path.metadata().unwrap().permissions());
    assert_eq!(modes[0], modes[1]);
    assert_eq!(entries(folder.path()), 2);
}

#[cfg(unix)]
#[test]
fn protected_files_and_links_to_nothing_are_no_targets() {
    let folder = tempfile::tempdir().unwrap();
    let (file, link) = (folder.path().join("kept"), folder.path().join("link"));
    std::fs::write(&file, "old").unwrap();
    let mut permissions = file.metadata().unwrap().permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(&file, permissions).unwrap();
    std::os::unix::fs::symlink(folder.path().join("nowhere"), &link).unwrap();
    for (target, kind) in
        [(&file, io::ErrorKind::PermissionDenied), (&link, io::ErrorKind::NotFound)]
    {
        assert_eq!(AtomicFile::create(target).unwrap_err().kind(), kind);
    }
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "old");
    assert!(link.is_symlink());
}

#[test]
fn a_folder_is_no_target() {
    let folder = tempfile::tempdir().unwrap();
    assert!(AtomicFile::create(folder.path()).is_err());
    assert!(AtomicFile::create(folder.path().join("missing/a.txt")).is_err());
}

#[cfg(unix)]
#[test]
fn a_private_file_stays_private() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("private");
    std::fs::write(&target, "old").unwrap();
    std::fs::set_permissions(&target, std::fs::Permissions::from_mode(0o600)).unwrap();
    AtomicFile::create(&target).unwrap().commit().unwrap();
    assert_eq!(target.metadata().unwrap().permissions().mode() & 0o777, 0o600);
}

#[cfg(unix)]
#[test]
fn links_are_followed_and_devices_written_to() {
    let folder = tempfile::tempdir().unwrap();
    let (file, link) = (folder.path().join("file"), folder.path().join("link"));
    std::fs::write(&file, "old").unwrap();
    std::os::unix::fs::symlink(&file, &link).unwrap();
    let mut out = AtomicFile::create(&link).unwrap();
    out.write_all(b"new").unwrap();
    out.commit().unwrap();
    assert!(link.is_symlink());
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "new");
    let mut out = AtomicFile::create("/dev/null").unwrap();
    out.write_all(b"gone").unwrap();
    out.commit().unwrap();
    assert!(!Path::new("/dev/null").is_file());
}
