//! Reading, searching and writing over real folders.

use ladder_analysis::Cancel;
use ladder_workspace::{Files, MAX_FILE_BYTES, Replacement, Root, find_programs, read, write};
use std::fs;
use std::io::Write;
use std::path::PathBuf;
use tempfile::TempDir;

/// A folder with empty files; names that end in `/` are folders.
fn folder(names: &[&str]) -> TempDir {
    let dir = tempfile::tempdir().unwrap();
    for name in names {
        let path = dir.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        if name.ends_with('/') {
            fs::create_dir_all(path).unwrap();
        } else {
            fs::write(path, "").unwrap();
        }
    }
    dir
}

fn relative(dir: &TempDir, found: &[PathBuf]) -> Vec<String> {
    found
        .iter()
        .map(|path| path.strip_prefix(dir.path()).unwrap().display().to_string())
        .collect()
}

fn message(dir: &TempDir, error: impl std::fmt::Display) -> String {
    error.to_string().replace(dir.path().to_str().unwrap(), "DIR")
}

#[test]
fn a_folder_gives_its_programs_sorted() {
    let dir = folder(&[
        "b.clad",
        "a.clad",
        "sub/c.CLAD",
        "notes.txt",
        ".hidden.clad",
        ".git/x.clad",
    ]);
    let (found, errors) = find_programs(&[dir.path().to_owned()]);
    assert_eq!(relative(&dir, &found), ["a.clad", "b.clad", "sub/c.CLAD"]);
    assert!(errors.is_empty());
}

#[test]
fn gitignore_is_obeyed_without_a_repository_too() {
    let dir = folder(&["a.clad", "build/b.clad", "old.clad", "sub/old.clad"]);
    fs::write(dir.path().join(".gitignore"), "build/\n/old.clad\n").unwrap();
    let (found, _) = find_programs(&[dir.path().to_owned()]);
    assert_eq!(relative(&dir, &found), ["a.clad", "sub/old.clad"]);
}

#[test]
fn a_named_file_is_taken_whatever_its_name_and_only_once() {
    let dir = folder(&["a.clad", "notes.txt"]);
    let notes = dir.path().join("notes.txt");
    let (found, _) = find_programs(&[notes.clone(), dir.path().to_owned(), notes]);
    assert_eq!(relative(&dir, &found), ["notes.txt", "a.clad"]);
}

#[test]
fn each_bad_path_is_one_error_and_the_rest_is_found() {
    let dir = folder(&["a.clad", "empty/"]);
    let paths = ["a.clad", "empty", "missing.clad", "a.clad/b.clad"].map(|name| dir.path().join(name));
    let (found, errors) = find_programs(&paths);
    assert_eq!(relative(&dir, &found), ["a.clad"]);
    let errors: Vec<String> = errors.iter().map(|error| message(&dir, error)).collect();
    assert_eq!(
        errors,
        [
            "DIR/empty: no program (a file ending in .clad or .st) is in this folder",
            "DIR/missing.clad: no such file or folder",
            "DIR/a.clad/b.clad: no such file or folder",
        ]
    );
}

#[test]
fn a_file_past_the_limit_is_refused() {
    let dir = folder(&[]);
    let path = dir.path().join("big.clad");
    let file = fs::File::create(&path).unwrap();
    file.set_len(MAX_FILE_BYTES as u64 + 1).unwrap();
    assert_eq!(
        message(&dir, read(&path).unwrap_err()),
        "DIR/big.clad: the file is larger than 64 MiB, the most that is read"
    );
    file.set_len(MAX_FILE_BYTES as u64).unwrap();
    assert_eq!(read(&path).unwrap().len(), MAX_FILE_BYTES);
}

#[test]
fn a_folder_is_not_a_file() {
    let dir = folder(&[]);
    assert_eq!(
        message(&dir, read(dir.path()).unwrap_err()),
        "DIR: this is a folder; name a file in it"
    );
    assert_eq!(
        message(&dir, write(dir.path(), b"").unwrap_err()),
        "DIR: this is a folder; name a file in it"
    );
}

#[test]
fn writing_leaves_nothing_but_the_file() {
    let dir = folder(&["a.clad"]);
    for name in ["a.clad", "new.clad"] {
        let path = dir.path().join(name);
        write(&path, b"+--+\n").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "+--+\n");
    }
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 2);
}

#[test]
fn writing_into_a_missing_folder_names_the_file() {
    let dir = folder(&[]);
    let error = write(&dir.path().join("no/out.csv"), b"").unwrap_err();
    assert!(
        message(&dir, error).starts_with("DIR/no/out.csv: cannot be written: "),
        "the file is named"
    );
}

#[test]
fn a_replacement_that_is_given_up_leaves_the_old_content() {
    let dir = folder(&[]);
    let path = dir.path().join("out.csv");
    write(&path, b"old").unwrap();
    let mut replacement = Replacement::of(&path).unwrap();
    replacement.write_all(b"new").unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), "old");
    drop(replacement);
    assert_eq!(fs::read_to_string(&path).unwrap(), "old");
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1);
}

#[cfg(unix)]
mod unix {
    use super::*;
    use std::os::unix::fs::{PermissionsExt, symlink};
    use std::path::Path;

    fn mode(path: &Path) -> u32 {
        fs::metadata(path).unwrap().permissions().mode() & 0o777
    }

    #[test]
    fn the_mode_stays() {
        let dir = folder(&["a.clad"]);
        let path = dir.path().join("a.clad");
        fs::set_permissions(&path, fs::Permissions::from_mode(0o750)).unwrap();
        write(&path, b"x").unwrap();
        assert_eq!(mode(&path), 0o750);
        // A new file has the mode of any other new file here, not that of a temporary one.
        let (ours, theirs) = (dir.path().join("ours"), dir.path().join("theirs"));
        write(&ours, b"x").unwrap();
        fs::write(&theirs, b"x").unwrap();
        assert_eq!(mode(&ours), mode(&theirs));
    }

    #[test]
    fn a_write_protected_file_stays_as_it_is() {
        let dir = folder(&["a.clad"]);
        let path = dir.path().join("a.clad");
        fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).unwrap();
        assert_eq!(
            message(&dir, write(&path, b"x").unwrap_err()),
            "DIR/a.clad: the file is write-protected"
        );
        assert_eq!(fs::read_to_string(&path).unwrap(), "");
    }

    #[test]
    fn a_link_stays_a_link() {
        let dir = folder(&["real/a.clad"]);
        let link = dir.path().join("link.clad");
        symlink("real/a.clad", &link).unwrap();
        write(&link, b"x").unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read_to_string(dir.path().join("real/a.clad")).unwrap(), "x");

        let dangling = dir.path().join("dangling.clad");
        symlink("real/new.clad", &dangling).unwrap();
        write(&dangling, b"y").unwrap();
        assert_eq!(fs::read_to_string(dir.path().join("real/new.clad")).unwrap(), "y");
    }

    #[test]
    fn a_device_is_written_to_and_not_replaced() {
        write(Path::new("/dev/null"), b"x").unwrap();
        assert!(!fs::metadata("/dev/null").unwrap().is_file());
    }

    #[test]
    fn links_to_programs_are_found_and_links_to_folders_are_not_entered() {
        let dir = folder(&["real/a.clad", "own/b.clad"]);
        symlink("../real/a.clad", dir.path().join("own/link.clad")).unwrap();
        symlink("..", dir.path().join("own/up")).unwrap();
        let own = dir.path().join("own");
        let (found, errors) = find_programs(std::slice::from_ref(&own));
        assert_eq!(relative(&dir, &found), ["own/b.clad"]);
        assert_eq!(
            message(&dir, &errors[0]),
            "DIR/own/link.clad: this leads out of the workspace, the folder of ladder.toml (without one: the file's own folder); an empty ladder.toml in a folder above both makes them one"
        );
        // Where the folder of both is searched, or is the workspace, or the link is named, it is a program.
        for (paths, expected) in [
            (vec![dir.path().to_owned()], &["own/b.clad", "own/link.clad"][..]),
            (vec![own.join("link.clad")], &["own/link.clad"]),
        ] {
            let (found, errors) = find_programs(&paths);
            assert_eq!(relative(&dir, &found), expected);
            assert!(errors.is_empty(), "{errors:?}");
        }
        fs::write(dir.path().join("ladder.toml"), "").unwrap();
        assert_eq!(find_programs(&[own]).0.len(), 2);
        let programs = Root::of(&dir.path().join("own/b.clad"))
            .unwrap()
            .programs(&Files::default());
        assert_eq!(
            relative(&dir, &programs),
            ["own/b.clad", "own/link.clad", "real/a.clad"]
        );
    }

    #[test]
    fn a_workspace_does_not_hold_what_its_links_lead_to_outside() {
        let dir = folder(&["plant/a.clad", "secret.clad"]);
        symlink("../secret.clad", dir.path().join("plant/b.clad")).unwrap();
        symlink("/dev/zero", dir.path().join("plant/c.clad")).unwrap();
        let plant = dir.path().join("plant");
        let programs = |root: &Root| relative(&dir, &root.programs(&Files::default()));
        let root = Root::of(&plant.join("a.clad")).unwrap();
        assert_eq!(programs(&root), ["plant/a.clad"]);
        fs::write(plant.join("ladder.toml"), "").unwrap();
        let root = Root::of(&plant.join("a.clad")).unwrap();
        assert_eq!(programs(&root), ["plant/a.clad"]);
        let survey = ladder_workspace::survey(&plant, 1000, &Cancel::default());
        assert_eq!(relative(&dir, &survey.programs), ["plant/a.clad"]);
        assert_eq!(find_programs(&[plant]).1.len(), 2);
    }

    #[test]
    fn settings_that_lie_elsewhere_are_refused() {
        let dir = folder(&["plant/a.clad"]);
        fs::write(dir.path().join("shared.toml"), "token = 5\n").unwrap();
        symlink("../shared.toml", dir.path().join("plant/ladder.toml")).unwrap();
        let root = Root::of(&dir.path().join("plant/a.clad")).unwrap();
        let error = root.settings().unwrap_err().to_string();
        assert!(
            error.contains("plant/ladder.toml: this leads out of the workspace"),
            "{error}"
        );
        assert!(!error.contains("token"), "{error}");
    }

    fn pipe(path: &Path) {
        let made = std::process::Command::new("mkfifo").arg(path).status();
        assert!(made.unwrap().success());
    }

    #[test]
    fn a_pipe_is_not_waited_for() {
        let dir = folder(&["a.clad", "sub/b.clad"]);
        pipe(&dir.path().join("p.clad"));
        assert_eq!(
            message(&dir, read(&dir.path().join("p.clad")).unwrap_err()),
            "DIR/p.clad: this is a pipe, and only a regular file is used here"
        );
        pipe(&dir.path().join("sub/.gitignore"));
        let (found, errors) = find_programs(&[dir.path().to_owned()]);
        assert_eq!(relative(&dir, &found), ["a.clad"]);
        let refused = "DIR/sub/.gitignore: this is a pipe, and only a regular file is used here";
        assert_eq!(message(&dir, &errors[0]), refused);
        assert_eq!(
            message(&dir, &find_programs(&[dir.path().join("sub")]).1[0]),
            refused
        );
        assert!(!ladder_workspace::is_excluded(&dir.path().join("sub/b.clad")));
    }

    #[test]
    fn what_the_caller_hands_over_is_read() {
        let mut child = std::process::Command::new("cat")
            .stdin(std::process::Stdio::piped())
            .stdout(std::process::Stdio::piped())
            .spawn()
            .unwrap();
        let (mut write_end, read_end) = (child.stdin.take().unwrap(), child.stdout.take().unwrap());
        write_end.write_all(b"+--+\n").unwrap();
        drop(write_end);
        let path = format!("/dev/fd/{}", std::os::fd::AsRawFd::as_raw_fd(&read_end));
        assert_eq!(read(Path::new(&path)).unwrap(), "+--+\n");
        child.wait().unwrap();
    }
}

#[test]
fn the_root_is_the_nearest_settings_file_or_the_own_folder() {
    let dir = folder(&[
        "plant/ladder.toml",
        "plant/a.clad",
        "plant/line/b.clad",
        "other/c.clad",
        "other/sub/d.clad",
    ]);
    let root = |name: &str| Root::of(&dir.path().join(name)).unwrap();

    let plant = root("plant/line/b.clad");
    assert_eq!(plant, Root::Settings(dir.path().join("plant")));
    assert_eq!(
        plant.settings_file().unwrap(),
        dir.path().join("plant/ladder.toml")
    );
    assert_eq!(
        relative(&dir, &plant.programs(&Files::default())),
        ["plant/a.clad", "plant/line/b.clad"]
    );

    let other = root("other/c.clad");
    assert_eq!(other, Root::Folder(dir.path().join("other")));
    assert_eq!(other.settings_file(), None);
    assert_eq!(
        relative(&dir, &other.programs(&Files::default())),
        ["other/c.clad"]
    );
}
