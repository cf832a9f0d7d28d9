//! Writing over what is there: what a file is stays, and nothing is lost on the way.
#![cfg(unix)]

use ladder_workspace::{Replacement, write};
use std::fs;
use std::io::Write;
use std::os::unix::fs::{MetadataExt, PermissionsExt, chown};
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::Command;

/// The user `nobody` of nearly every system.
const NOBODY: u32 = 65534;

fn names(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = names
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

fn is_root(folder: &Path) -> bool {
    fs::metadata(folder).unwrap().uid() == 0
}

/// Runs a test as a user whom permissions bind: where root runs the tests, once more in a process of `nobody`. True:
/// this is that process, or root does not run the tests.
fn bound_by_permissions(test: &str) -> bool {
    let folder = tempfile::tempdir().unwrap();
    if !is_root(folder.path()) {
        return true;
    }
    let program = std::env::current_exe().unwrap();
    let run = Command::new(program)
        .args([test, "--exact", "--nocapture"])
        .current_dir("/")
        .env("TMPDIR", "/tmp")
        .uid(NOBODY)
        .gid(NOBODY)
        .output();
    match run {
        Ok(output) => assert!(
            output.status.success(),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        ),
        Err(error) => eprintln!("skipped: {test} cannot be run as another user: {error}"),
    }
    false
}

#[test]
fn all_names_of_a_file_show_the_new_content() {
    let folder = tempfile::tempdir().unwrap();
    let (one, other) = (folder.path().join("one.clad"), folder.path().join("other.clad"));
    for (old, new) in [("a longer old text\n", "new\n"), ("old\n", "a longer new text\n")] {
        fs::write(&one, old).unwrap();
        let _ = fs::hard_link(&one, &other);
        let mut replacement = Replacement::of(&one).unwrap();
        replacement.write_all(new.as_bytes()).unwrap();
        assert_eq!(fs::read_to_string(&other).unwrap(), old);
        replacement.commit().unwrap();
        assert_eq!(fs::read_to_string(&one).unwrap(), new);
        assert_eq!(fs::read_to_string(&other).unwrap(), new);
        assert_eq!(
            fs::metadata(&one).unwrap().ino(),
            fs::metadata(&other).unwrap().ino()
        );
    }
    assert_eq!(names(folder.path()), ["one.clad", "other.clad"]);
}

#[test]
fn the_owner_stays() {
    let folder = tempfile::tempdir().unwrap();
    if !is_root(folder.path()) {
        eprintln!("skipped: only root can give a file to another user");
        return;
    }
    let path = folder.path().join("a.clad");
    fs::write(&path, "old").unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
    chown(&path, Some(NOBODY), Some(NOBODY)).unwrap();
    write(&path, b"new").unwrap();
    let after = fs::metadata(&path).unwrap();
    assert_eq!(
        (after.uid(), after.gid(), after.mode() & 0o7777),
        (NOBODY, NOBODY, 0o640)
    );
    assert_eq!(fs::read_to_string(&path).unwrap(), "new");
}

#[test]
fn a_folder_that_takes_no_new_file() {
    if !bound_by_permissions("a_folder_that_takes_no_new_file") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let plant = folder.path().join("plant");
    fs::create_dir(&plant).unwrap();
    let path = plant.join("a.clad");
    fs::write(&path, "the old text").unwrap();
    let before = fs::metadata(&path).unwrap();
    fs::set_permissions(&plant, fs::Permissions::from_mode(0o555)).unwrap();
    write(&path, b"new").unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), "new");
    assert_eq!(fs::metadata(&path).unwrap().ino(), before.ino());
    assert_eq!(names(&plant), ["a.clad"]);
    assert!(write(&plant.join("new.clad"), b"new").is_err());
    fs::set_permissions(&plant, fs::Permissions::from_mode(0o755)).unwrap();
}

#[test]
fn a_file_of_another_user_in_a_folder_of_ours() {
    // Only root can make such a file; only another user is bound by it.
    let folder = tempfile::tempdir().unwrap();
    if !is_root(folder.path()) {
        eprintln!("skipped: only root can give a file to another user");
        return;
    }
    fs::set_permissions(folder.path(), fs::Permissions::from_mode(0o777)).unwrap();
    let path = folder.path().join("a.clad");
    fs::write(&path, "old").unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o666)).unwrap();
    let program = std::env::current_exe().unwrap();
    let run = Command::new(program)
        .args(["child_that_writes_the_file", "--exact", "--ignored"])
        .current_dir("/")
        .env("LADDER_TEST_FILE", &path)
        .uid(NOBODY)
        .gid(NOBODY)
        .output();
    match run {
        Ok(output) => assert!(
            output.status.success(),
            "{}",
            String::from_utf8_lossy(&output.stdout)
        ),
        Err(error) => return eprintln!("skipped: the test cannot be run as another user: {error}"),
    }
    let after = fs::metadata(&path).unwrap();
    assert_eq!((after.uid(), after.mode() & 0o777), (0, 0o666));
    assert_eq!(fs::read_to_string(&path).unwrap(), "written");
    assert_eq!(names(folder.path()), ["a.clad"]);
}

#[test]
#[ignore = "run by another test, as another user"]
fn child_that_writes_the_file() {
    let path = std::env::var_os("LADDER_TEST_FILE").unwrap();
    write(Path::new(&path), b"written").unwrap();
}

#[test]
fn a_process_that_is_killed_leaves_nothing_after() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.clad");
    fs::write(&path, "old").unwrap();
    let mut child = Command::new(std::env::current_exe().unwrap())
        .args(["waits_with_half_a_file", "--exact", "--ignored", "--nocapture"])
        .env("LADDER_TEST_FILE", &path)
        .stdout(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    let mut told = std::io::BufReader::new(child.stdout.take().unwrap());
    let mut line = String::new();
    while !line.contains("half") {
        line.clear();
        assert!(
            std::io::BufRead::read_line(&mut told, &mut line).unwrap() > 0,
            "it does not begin"
        );
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), "old");
    if cfg!(target_os = "linux") && names(folder.path()).len() > 1 {
        eprintln!("skipped: this file system knows no files without a name");
    } else if cfg!(target_os = "linux") {
        assert_eq!(names(folder.path()), ["a.clad"]);
    }
}

#[test]
#[ignore = "run by another test, which kills it"]
fn waits_with_half_a_file() {
    let path = std::env::var_os("LADDER_TEST_FILE").unwrap();
    let mut replacement = Replacement::of(Path::new(&path)).unwrap();
    replacement.write_all(b"half").unwrap();
    replacement.flush().unwrap();
    println!("\nhalf");
    std::thread::sleep(std::time::Duration::from_secs(60));
}
