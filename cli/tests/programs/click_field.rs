//! Click programs that people had trouble with: what `convert` says of each, and that what it writes has no errors that it does
//! not tell.

use crate::harness::Folder;
use expect_test::{Expect, expect};
use std::fs;
use std::path::{Path, PathBuf};

fn field(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../tests/corpus/field")
        .join(name)
}

/// The Python files of the field whose names begin so, and what is said of each.
#[track_caller]
fn check(expected: Expect) {
    let entries = fs::read_dir(field("")).expect("the folder can be read");
    let names = entries.map(|entry| entry.expect("an entry").file_name().into_string().expect("a name"));
    let mut names: Vec<String> = names
        .filter(|name| name.starts_with("click_") && name.ends_with(".py"))
        .collect();
    names.sort_unstable();
    let mut said = String::new();
    for name in names {
        let text = fs::read_to_string(field(&name)).expect("the file can be read");
        let folder = Folder::with(&[(&name, &text)]);
        let run = folder.ladder(&["convert", &name, "-o", "out.clad"]);
        said.push_str(&format!("{} {}", run.status.unwrap_or(-1), run.stderr));
        if run.status == Some(2) {
            continue;
        }
        let checked = folder.ladder(&["check", "out.clad"]);
        assert!(
            checked.status == Some(0) || run.status == Some(1),
            "{name}: {run}{checked}"
        );
        // No finding is about a line of the importer's own.
        for file in ["out.clad", &name] {
            let checked = folder.ladder(&["check", file, "--format", "concise"]);
            assert!(!checked.stdout.contains("suppression-unused"), "{checked}");
        }
    }
    expected.assert_eq(&said);
}

#[test]
fn python() {
    check(expect![[r#""#]]);
}

/// A program of the field, in a folder of its own.
fn folder_of(name: &str, files: &[&str]) -> Folder {
    let texts: Vec<String> = files
        .iter()
        .map(|file| fs::read_to_string(field(name).join(file)).expect("the file can be read"))
        .collect();
    let files: Vec<(&str, &str)> = files.iter().copied().zip(texts.iter().map(String::as_str)).collect();
    Folder::with(&files)
}

/// What is written of a Python file, without the wires.
#[track_caller]
fn written(name: &str, program: &str, expected: Expect) {
    let folder = folder_of(name, &[program]);
    let run = folder.ladder(&["convert", program, "-o", "made/main.csv"]);
    assert_eq!(run.status, Some(2), "the folder is not there: {run}");
    let run = folder.ladder(&["convert", program, "-o", "main.csv"]);
    assert_eq!(run.status, Some(0), "{run}");
    let text = folder.read("main.csv").replace(",-", "");
    let rows: Vec<&str> = text.lines().skip(1).collect();
    expected.assert_eq(&rows.join("\n"));
}

#[test]
fn formulas_and_searches_are_written_as_the_tools_read_them() {
    written("click_csv_formula_written", "p.py", expect![[r#""#]]);
    written("click_csv_search_written", "p.py", expect![[r#""#]]);
}

#[test]
fn grids_of_other_tools_are_read() {
    for (name, files) in [
        ("click_csv_search_read", &["main.csv"][..]),
        ("click_csv_indexed_marker", &["main.csv"]),
        ("click_csv_subroutines_folder", &["main.csv", "subroutines/Fill Tank.csv"]),
        ("click_nicknames_xd0u", &["main.csv", "nicknames.csv"]),
    ] {
        let folder = folder_of(name, files);
        let run = folder.ladder(&["convert", "main.csv"]);
        assert_eq!(run.status, Some(0), "{name}: {run}");
        assert!(run.stderr.contains(" 0 refused"), "{name}: {run}");
    }
}

#[test]
fn subroutines_are_written_into_their_folder() {
    let folder = folder_of("click_csv_subroutines_folder", &["two.py"]);
    let run = folder.ladder(&["convert", "two.py", "-o", "main.csv"]);
    assert_eq!(run.status, Some(0), "{run}");
    assert!(folder.read("subroutines/fill.csv").contains("out(Y001)"));
    let run = folder.ladder(&["convert", "main.csv"]);
    assert!(run.stdout.contains("<FUN>( fill )"), "{run}");
}

#[test]
fn a_lone_rung_needs_no_end() {
    let grid = fs::read_to_string(field("click_csv_indexed_marker/main.csv")).expect("the file can be read");
    let lines: Vec<&str> = grid.lines().take(2).collect();
    let folder = Folder::with(&[("rung.csv", &format!("{}\n", lines.join("\n")))]);
    let run = folder.ladder(&["convert", "rung.csv"]);
    assert_eq!(run.status, Some(0), "{run}");
}

/// The reset of a register sees its bits as they were before the shift: the last one is on for a scan.
#[test]
fn a_register_is_reset_by_its_own_bit() {
    let folder = folder_of("click_shift_reset_by_own_bit", &["main.py", "main.csv", "in.csv"]);
    for file in ["main.py", "main.csv"] {
        let run = folder.ladder(&[
            "sim",
            file,
            "--scans",
            "8",
            "--inputs",
            "in.csv",
            "--watch",
            "C[1],C[2],C[3]",
        ]);
        let bits: Vec<String> = run
            .stdout
            .lines()
            .skip(1)
            .map(|line| line.splitn(3, ',').nth(2).unwrap_or_default().replace(',', ""))
            .collect();
        // As pyrung 0.15.2 has it.
        assert_eq!(
            bits,
            ["000", "100", "100", "010", "010", "001", "000", "000"],
            "{file}: {run}"
        );
    }
}
