//! The retentive file, on a real disk.

use expect_test::expect;
use ladder_simulator::Kept;
use ladder_workspace::{Found, RetentiveFile};
use std::fs;
use std::path::Path;

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
    let (_, found) = open(&path);
    assert_eq!((found.kept, found.notes), (Some(values.to_vec()), Vec::new()));
    assert_eq!(names(folder.path()), ["motor.retain"]);
}

#[test]
fn a_damaged_file_is_kept_beside_and_never_over_another() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("motor.retain");
    for text in [
        "ladder-retain 1\nprogram motor.clad\nn\tINT\t5\n",
        "\u{0}\u{0}",
        "ladder-retain 2\n",
    ] {
        fs::write(&path, text).unwrap();
        let (mut file, found) = open(&path);
        assert_eq!(found.kept, None);
        assert_eq!(found.notes.len(), 1);
        file.save(&[kept("n", "INT", &["1"])]).unwrap();
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
    expect!["FOLDER/motor.retain: this is no file of retentive values; the program starts cold, and the file is kept as FOLDER/motor.retain.damaged.5"].assert_eq(&says("total = 5\n"));
    expect!["FOLDER/motor.retain: the file has format 2, but this version of ladder reads format 1 only; the program starts cold, and the file is kept as FOLDER/motor.retain.damaged.6"].assert_eq(&says("ladder-retain 2\nend\n"));
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
    let (mut file, _) = open(&path);
    assert!(!file.is_due());
    std::thread::sleep(std::time::Duration::from_millis(1001));
    assert!(file.is_due());
    file.save(&[kept("n", "INT", &["1"])]).unwrap();
    assert!(!file.is_due());
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
