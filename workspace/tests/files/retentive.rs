//! The retentive file, on a real disk.

use expect_test::expect;
use ladder_simulator::Kept;
use ladder_workspace::{Found, Named, RetentiveFile, SystemDisk};
use std::fs;
use std::path::Path;
use std::time::Duration;

fn kept(name: &str, ty: &str, values: &[&str]) -> Kept {
    Kept {
        name: name.into(),
        ty: ty.into(),
        values: values.iter().map(|&value| value.to_owned()).collect(),
    }
}

fn open(path: &Path) -> (RetentiveFile, Found) {
    RetentiveFile::open(path, "motor.clad").unwrap_or_else(|error| panic!("{error}"))
}

fn notes(folder: &Path, found: &Found) -> String {
    found
        .notes
        .join("\n")
        .replace(&folder.display().to_string(), "FOLDER")
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn what_is_saved_is_found_again() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("motor.retain");
    let (mut file, found) = open(&path);
    assert_eq!(found, Found::default());
    let values = [
        kept("total", "DINT", &["42"]),
        kept("name", "STRING", &["'a$Tb$N'"]),
        kept("recipe", "ARRAY[1..2] OF INT", &["7", "-9"]),
        kept("nothing", "INT", &[]),
    ];
    file.save(&values).unwrap();
    expect![[r#"
        ladder-retain 1
        program motor.clad
        total	DINT	42
        name	STRING	'a$Tb$N'
        recipe	ARRAY[1..2] OF INT	7	-9
        nothing	INT
        end a86a7a90
    "#]]
    .assert_eq(&fs::read_to_string(&path).unwrap());
    drop(file);
    let (_, found) = open(&path);
    assert_eq!((found.kept, found.notes), (Some(values.to_vec()), Vec::new()));
    assert_eq!(names(folder.path()), ["motor.retain"]);
}

#[test]
fn a_damaged_file_is_kept_next_to_and_never_over_another() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("motor.retain");
    for text in [
        "ladder-retain 1\nprogram motor.clad\nn\tINT\t5\n",
        "ladder-retain \u{0}\u{0}",
        "ladder-retain 2\n",
    ] {
        fs::write(&path, text).unwrap();
        let (mut file, found) = open(&path);
        assert_eq!(found.kept, None);
        assert_eq!(found.notes.len(), 1);
        file.save(&[kept("n", "INT", &["1"])]).unwrap();
        drop(file);
        assert_eq!(open(&path).1.kept, Some(vec![kept("n", "INT", &["1"])]));
    }
    assert_eq!(
        names(folder.path()),
        [
            "motor.retain",
            "motor.retain.damaged",
            "motor.retain.damaged.2",
            "motor.retain.damaged.3"
        ]
    );
    let first = fs::read_to_string(folder.path().join("motor.retain.damaged")).unwrap();
    assert!(first.ends_with("5\n"), "{first}");
    let says = |text: &str| {
        fs::write(&path, text).unwrap();
        notes(folder.path(), &open(&path).1)
    };
    expect![
        "FOLDER/motor.retain: the file is damaged; the program starts cold, and the file is kept as FOLDER/motor.retain.damaged.4"
    ]
    .assert_eq(&says("ladder-retain 1\nprogram motor.clad\nend 00000000\n"));
    expect!["FOLDER/motor.retain: the file has format 2, but this version of ladder reads format 1 only; the program starts cold, and the file is kept as FOLDER/motor.retain.damaged.5"].assert_eq(&says("ladder-retain 2\nend\n"));
}

#[test]
fn another_program_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("plant.retain");
    open(&path).0.save(&[]).unwrap();
    let (_, found) = RetentiveFile::open(&path, "pump.clad").unwrap();
    assert_eq!(found.kept, Some(Vec::new()));
    expect!["FOLDER/plant.retain: the values were kept by motor.clad; pump.clad takes those that fit"]
        .assert_eq(&notes(folder.path(), &found));
}

#[test]
fn a_save_is_due_once_a_second_and_writes_only_what_changed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("motor.retain");
    let second = Duration::from_secs(1);
    let (mut file, _) = open(&path);
    assert!(!file.is_due(second));
    assert!(!file.is_due(second * 3 / 2));
    assert!(file.is_due(second * 2));
    file.save(&[kept("n", "INT", &["1"])]).unwrap();
    assert!(!file.is_due(second * 4), "it was saved meanwhile");
    assert!(file.is_due(second * 5));
    fs::remove_file(&path).unwrap();
    file.save(&[kept("n", "INT", &["1"])]).unwrap();
    assert!(!path.exists());
    file.save(&[kept("n", "INT", &["2"])]).unwrap();
    assert!(path.exists());
}

#[test]
fn a_folder_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let error = RetentiveFile::open(folder.path(), "motor.clad").unwrap_err();
    assert!(error.to_string().contains("this is a folder"), "{error}");
}

#[test]
fn a_file_of_others_stays_as_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("motor.retain");
    for text in ["total = 5\n", "", "#!/bin/sh\n", "ladder-retain"] {
        fs::write(&path, text).unwrap();
        let error = RetentiveFile::open(&path, "motor.clad").unwrap_err().to_string();
        assert!(
            error.ends_with("this is not a file of retentive values, and it stays as it is; name another file, or remove this one"),
            "{error}"
        );
        assert_eq!(fs::read_to_string(&path).unwrap(), text);
        assert_eq!(names(folder.path()), ["motor.retain"]);
    }
}

#[test]
fn two_runs_do_not_share_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("motor.retain");
    let (mut first, _) = open(&path);
    let refused = |()| {
        let error = RetentiveFile::open(&path, "pump.clad").unwrap_err().to_string();
        assert!(
            error.ends_with("another run uses this file; wait until that ends, or name another file"),
            "{error}"
        );
    };
    refused(());
    first.save(&[kept("n", "INT", &["1"])]).unwrap();
    // The file is another one now; it is used all the same.
    refused(());
    drop(first);
    assert_eq!(open(&path).1.kept, Some(vec![kept("n", "INT", &["1"])]));
    assert_eq!(names(folder.path()), ["motor.retain"]);
}

#[test]
fn a_workspace_names_a_file_of_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let plant = folder.path().join("plant");
    fs::create_dir(&plant).unwrap();
    let open = |name: &str| {
        RetentiveFile::open_named(
            &SystemDisk,
            &Named::in_settings(&plant, name),
            "motor.clad",
            Duration::ZERO,
        )
    };
    open("motor.retain").unwrap().0.save(&[]).unwrap();
    assert_eq!(names(&plant), ["motor.retain"]);
    for name in [
        "../motor.retain",
        "/tmp/motor.retain",
        "a/../../motor.retain",
        ".git/hooks/pre-commit",
    ] {
        assert!(open(name).is_err(), "{name}");
    }
    assert_eq!(names(folder.path()), ["plant"]);
}

#[cfg(unix)]
#[test]
fn a_link_leads_to_no_file_outside() {
    let folder = tempfile::tempdir().unwrap();
    let plant = folder.path().join("plant");
    fs::create_dir(&plant).unwrap();
    std::os::unix::fs::symlink("../profile", plant.join("a.retain")).unwrap();
    std::os::unix::fs::symlink("..", plant.join("up")).unwrap();
    for name in ["a.retain", "up/profile"] {
        let error = RetentiveFile::open_named(
            &SystemDisk,
            &Named::in_settings(&plant, name),
            "motor.clad",
            Duration::ZERO,
        )
        .unwrap_err();
        assert!(
            error.to_string().contains("leads out of the workspace"),
            "{error}"
        );
    }
    // One that is there already, with content that the tools would take for their own.
    fs::write(folder.path().join("profile"), "ladder-retain 1\n").unwrap();
    assert!(
        RetentiveFile::open_named(
            &SystemDisk,
            &Named::in_settings(&plant, "a.retain"),
            "motor.clad",
            Duration::ZERO
        )
        .is_err()
    );
    assert_eq!(
        fs::read_to_string(folder.path().join("profile")).unwrap(),
        "ladder-retain 1\n"
    );
    assert_eq!(names(folder.path()), ["plant", "profile"]);
}
