//! `ladder fmt` and `ldfmt`

use crate::harness::{CROOKED, Folder, MOTOR};
use expect_test::expect;
use std::fs;

#[test]
fn files_are_rewritten_in_place_and_nothing_else_happens() {
    let folder = Folder::with(&[
        ("plant/a.clad", CROOKED),
        ("plant/b.clad", MOTOR),
        ("c.clad", CROOKED),
    ]);
    let run = folder.ldfmt(&["plant", "c.clad"]);
    assert_eq!(run.to_string(), "exit status 0\n");
    for name in ["plant/a.clad", "plant/b.clad", "c.clad"] {
        assert_eq!(folder.read(name), MOTOR, "{name}");
    }
    assert_eq!(folder.names(), ["c.clad", "plant"]);
}

#[test]
fn a_file_in_canonical_layout_is_not_touched() {
    let folder = Folder::with(&[("a.clad", MOTOR)]);
    let changed = || fs::metadata(folder.path("a.clad")).unwrap().modified().unwrap();
    let before = changed();
    folder.ldfmt(&["a.clad"]);
    assert_eq!(changed(), before);
}

#[test]
fn ladder_fmt_is_the_same_command() {
    let folder = Folder::with(&[("a.clad", CROOKED)]);
    assert_eq!(folder.ladder(&["fmt", "a.clad"]).to_string(), "exit status 0\n");
    assert_eq!(folder.read("a.clad"), MOTOR);
}

#[test]
fn check_names_what_would_change_and_writes_nothing() {
    let folder = Folder::with(&[("a.clad", CROOKED), ("b.clad", MOTOR)]);
    expect![[r#"
        exit status 1
        -- stderr
        note: would change: a.clad
    "#]]
    .assert_eq(&folder.ldfmt(&["--check", "."]).to_string());
    assert_eq!(folder.read("a.clad"), CROOKED);
    assert_eq!(
        folder.ldfmt(&["--check", "b.clad"]).to_string(),
        "exit status 0\n"
    );
}

#[test]
fn diff_shows_what_would_change_and_writes_nothing() {
    let folder = Folder::with(&[("a.clad", CROOKED), ("b.clad", MOTOR)]);
    expect![[r#"
        exit status 1
        -- stdout
        --- a.clad
        +++ a.clad
        @@ -1,2 +1,2 @@
        -+-\-[ ]( start )-\-[/]( stop )-( )( run )-+
        -| /-[ ]( run )-/
        ++--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
        +|  /--[ ]( run )----/                                                          |
    "#]]
    .assert_eq(&folder.ldfmt(&["--diff", "."]).to_string());
    assert_eq!(folder.read("a.clad"), CROOKED);
    assert_eq!(folder.ldfmt(&["--diff", "b.clad"]).to_string(), "exit status 0\n");
}

const SCENARIOS: &str = "program a.clad\nscenario \"it counts\"\nstart _-_\ntotal=>0 10 10 # in all\n";
const ALIGNED: &str =
    "program a.clad\n\nscenario \"it counts\"\nstart    _ -  _\ntotal => 0 10 10  # in all\n";

#[test]
fn scenarios_that_are_named_are_aligned() {
    let folder = Folder::with(&[("a.clad", MOTOR), ("a.ladder-test", SCENARIOS)]);
    // Folders are searched for programs.
    assert_eq!(folder.ldfmt(&["--check", "."]).to_string(), "exit status 0\n");
    assert_eq!(
        folder.ldfmt(&["--check", "a.ladder-test"]).to_string(),
        "exit status 1\n-- stderr\nnote: would change: a.ladder-test\n"
    );
    let part = folder.ldfmt(&["--range", "1-2", "a.ladder-test"]).to_string();
    assert_eq!(
        part,
        "exit status 2\n-- stderr\nerror: a.ladder-test: --range is for programs; the columns of scenarios are aligned \
         in the whole file\n"
    );
    assert_eq!(folder.read("a.ladder-test"), SCENARIOS);
    assert_eq!(
        folder.ldfmt(&["a.clad", "a.ladder-test"]).to_string(),
        "exit status 0\n"
    );
    assert_eq!(folder.read("a.ladder-test"), ALIGNED);
    let run = folder.ldfmt_stdin(&["-", "--stdin-filename", "x.ladder-test"], SCENARIOS.as_bytes());
    assert_eq!(run.to_string(), format!("exit status 0\n-- stdout\n{ALIGNED}"));
}

#[test]
fn diff_says_where_the_last_line_has_no_end() {
    let folder = Folder::with(&[("a.clad", "+-( )( a )-+")]);
    expect![[r#"
        exit status 1
        -- stdout
        --- a.clad
        +++ a.clad
        @@ -1 +1 @@
        -+-( )( a )-+
        \ No newline at end of file
        ++--------------------------------------------------------------------( )( a )--+
        \ No newline at end of file
    "#]]
    .assert_eq(&folder.ldfmt(&["--diff", "a.clad"]).to_string());
}

#[test]
fn stdin_goes_to_stdout() {
    let folder = Folder::with(&[]);
    for arguments in [&["-"][..], &["-", "--stdin-filename", "not/there.clad"]] {
        let run = folder.ldfmt_stdin(arguments, CROOKED.as_bytes());
        assert_eq!(run.to_string(), format!("exit status 0\n-- stdout\n{MOTOR}"));
    }
    let empty = folder.ldfmt_stdin(&["-"], b"");
    assert_eq!(empty.to_string(), "exit status 0\n");
}

#[test]
fn stdin_is_checked_and_compared_too() {
    let folder = Folder::with(&[]);
    let run = |arguments: &[&str]| folder.ldfmt_stdin(arguments, CROOKED.as_bytes());
    let check = run(&["--check", "-", "--stdin-filename", "motor.clad"]);
    assert_eq!(
        check.to_string(),
        "exit status 1\n-- stderr\nnote: would change: motor.clad\n"
    );
    let diff = run(&["--diff", "-"]);
    assert_eq!(diff.status, Some(1));
    assert!(diff.stdout.starts_with("--- <stdin>\n+++ <stdin>\n@@ "), "{diff}");
    let good = folder.ldfmt_stdin(&["--check", "-"], MOTOR.as_bytes());
    assert_eq!(good.to_string(), "exit status 0\n");
}

#[test]
fn stdin_that_cannot_be_read_gives_no_output() {
    let folder = Folder::with(&[]);
    folder
        .ldfmt_stdin(&["-", "--stdin-filename", "a.clad"], b"+--\xFF--+")
        .refused_with(
            "a.clad: the file is not UTF-8: byte 16#FF at line 1, column 4; save it as UTF-8 in your editor",
        );
}

#[test]
fn a_network_with_an_error_stays_and_the_others_are_formatted() {
    let folder = Folder::with(&[]);
    let text = format!("{CROOKED}\n+-[ ]( a-+\n");
    let run = folder.ldfmt_stdin(&["-"], text.as_bytes());
    assert_eq!(
        run.to_string(),
        format!("exit status 0\n-- stdout\n{MOTOR}\n+-[ ]( a-+\n")
    );
}

#[test]
fn a_range_is_widened_to_networks() {
    let folder = Folder::with(&[]);
    let text = format!("{CROOKED}\n{CROOKED}\n{CROOKED}");
    let run = folder.ldfmt_stdin(&["-", "--range", "5-5"], text.as_bytes());
    assert_eq!(
        run.to_string(),
        format!("exit status 0\n-- stdout\n{CROOKED}\n{MOTOR}\n{CROOKED}")
    );
    let run = folder.ldfmt_stdin(&["-", "--range", "1:3-4:1"], text.as_bytes());
    assert_eq!(
        run.to_string(),
        format!("exit status 0\n-- stdout\n{MOTOR}\n{MOTOR}\n{CROOKED}")
    );
}

#[test]
fn arguments_that_contradict_each_other() {
    let folder = Folder::with(&[("a.clad", CROOKED), ("b.clad", CROOKED)]);
    folder
        .ldfmt(&["-", "a.clad"])
        .refused_with("`-` (stdin) cannot be given together with other paths");
    folder
        .ldfmt(&["a.clad", "--stdin-filename", "x.clad"])
        .refused_with("--stdin-filename needs `-` as the path, which reads stdin");
    folder
        .ldfmt(&[".", "--range", "1-2"])
        .refused_with("--range needs exactly one file");
    assert_eq!(folder.read("a.clad"), CROOKED);
}

#[test]
fn line_ends_and_the_byte_order_mark_stay() {
    let folder = Folder::with(&[]);
    let text = format!("\u{feff}{}", CROOKED.replace('\n', "\r\n"));
    let run = folder.ldfmt_stdin(&["-"], text.as_bytes());
    assert_eq!(run.stdout, format!("\u{feff}{}", MOTOR.replace('\n', "\r\n")));
}

#[cfg(unix)]
#[test]
fn the_mode_of_a_file_stays_and_links_are_followed() {
    use std::os::unix::fs::{PermissionsExt, symlink};

    let folder = Folder::with(&[("real.clad", CROOKED)]);
    let real = folder.path("real.clad");
    fs::set_permissions(&real, fs::Permissions::from_mode(0o640)).unwrap();
    symlink("real.clad", folder.path("link.clad")).unwrap();
    assert_eq!(folder.ldfmt(&["link.clad"]).to_string(), "exit status 0\n");
    assert_eq!(folder.read("real.clad"), MOTOR);
    assert_eq!(fs::metadata(&real).unwrap().permissions().mode() & 0o777, 0o640);
    assert!(
        fs::symlink_metadata(folder.path("link.clad"))
            .unwrap()
            .is_symlink()
    );
}

#[test]
fn many_files_are_named_in_their_order() {
    let names: Vec<String> = (0..300).map(|n| format!("f{n:03}.clad")).collect();
    let files: Vec<(&str, &str)> = names.iter().map(|name| (name.as_str(), CROOKED)).collect();
    let folder = Folder::with(&files);
    let run = folder.ldfmt(&["--check", "."]).to_string();
    let named: Vec<&str> = run
        .lines()
        .filter_map(|line| line.strip_prefix("note: would change: "))
        .collect();
    assert_eq!(named, names);
    assert_eq!(folder.ldfmt(&["."]).to_string(), "exit status 0\n");
    assert_eq!(folder.ldfmt(&["--check", "."]).to_string(), "exit status 0\n");
}

#[test]
fn settings_from_a_file_that_is_named() {
    let folder = Folder::with(&[
        ("a.clad", "+--[ ]( a )--( )( y )--+\n"),
        ("ladder.toml", "[format]\nspacing = 2\n"),
        (
            "other.toml",
            "[format]\nspacing = 4\n[workspace]\nexclude = [\"b/\"]\n",
        ),
        ("b/b.clad", CROOKED),
    ]);
    assert_eq!(
        folder.ldfmt(&["--config", "other.toml", "."]).to_string(),
        "exit status 0\n"
    );
    assert_eq!(
        folder.read("a.clad"),
        "+----[ ]( a )------------------------------------------------------( )( y )----+\n"
    );
    assert_eq!(folder.read("b/b.clad"), CROOKED);
    let stdin = folder.ldfmt_stdin(&["--config", "other.toml", "-"], b"+-[ ](a)-( )(y)-+");
    assert_eq!(
        stdin.to_string(),
        "exit status 0\n-- stdout\n+----[ ]( a )------------------------------------------------------( )( y )----+"
    );
    expect![[r#"
        exit status 2
        -- stderr
        error: none.toml: no such file or folder
    "#]]
    .assert_eq(&folder.ldfmt(&["--config", "none.toml", "a.clad"]).to_string());
}

#[test]
fn what_is_excluded_is_formatted_when_it_is_named_unless_excluding_is_forced() {
    let folder = Folder::with(&[
        ("ladder.toml", "[workspace]\nexclude = [\"old/\"]\n"),
        (".gitignore", "made.clad\n"),
        ("old/a.clad", CROOKED),
        ("made.clad", CROOKED),
        ("b.clad", MOTOR),
    ]);
    let forced = |arguments: &[&str]| {
        folder
            .ldfmt(&[&["--force-exclude"], arguments].concat())
            .to_string()
    };
    assert_eq!(folder.ldfmt(&["--check", "."]).to_string(), "exit status 0\n");
    assert_eq!(
        forced(&["--check", "old/a.clad", "made.clad", "b.clad"]),
        "exit status 0\n"
    );
    let stdin = |name: &str| {
        folder
            .ldfmt_stdin(
                &["--force-exclude", "--stdin-filename", name, "-"],
                CROOKED.as_bytes(),
            )
            .to_string()
    };
    assert_eq!(
        stdin("old/a.clad"),
        format!("exit status 0\n-- stdout\n{CROOKED}")
    );
    assert_eq!(stdin("b.clad"), format!("exit status 0\n-- stdout\n{MOTOR}"));
    assert_eq!(folder.ldfmt(&["old/a.clad"]).to_string(), "exit status 0\n");
    assert_eq!(folder.read("old/a.clad"), MOTOR);
}

/// It holds nothing but the way to `ladder`, which is in the same folder whatever link it was started by.
#[test]
fn ldfmt_starts_the_ladder_next_to_it() {
    let folder = Folder::with(&[("a.clad", MOTOR), ("path/ladder", "")]);
    let alone = folder.path("ldfmt");
    std::fs::copy(env!("CARGO_BIN_EXE_ldfmt"), &alone).unwrap();
    let run = folder.run(
        alone.to_str().unwrap(),
        &["--check", "a.clad"],
        b"",
        &[("PATH", "path")],
    );
    assert_eq!((run.status, run.stdout.as_str()), (Some(2), ""));
    assert!(
        run.stderr
            .starts_with("error: ldfmt needs the program ladder in its own folder, and cannot start it: "),
        "{run}"
    );
    #[cfg(unix)]
    {
        let link = folder.path("link");
        std::os::unix::fs::symlink(env!("CARGO_BIN_EXE_ldfmt"), &link).unwrap();
        let run = folder.run(link.to_str().unwrap(), &["--check", "a.clad"], b"", &[]);
        assert_eq!(run.to_string(), "exit status 0\n");
    }
}
