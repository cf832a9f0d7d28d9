//! Settings files: what they say, and what is wrong with them.

use expect_test::{Expect, expect};
use ladder_analysis::program::Program;
use ladder_analysis::{Level, Severity};
use ladder_workspace::{Root, Settings, find_programs};
use std::fs;
use std::path::{Path, PathBuf};

fn settings(text: &str) -> Settings {
    Settings::parse(Path::new("/plant/ladder.toml"), text).unwrap()
}

fn wrong(text: &str, expected: Expect) {
    let error = Settings::parse(Path::new("ladder.toml"), text).unwrap_err();
    expected.assert_eq(&format!("{error}\n"));
}

#[test]
fn an_empty_file_asks_for_nothing() {
    let settings = settings("# nothing yet\n");
    assert_eq!(settings.format, ladder_format::Options::default());
    assert!(settings.lint.levels.is_empty());
    assert_eq!(
        settings
            .simulate
            .options(&Program::default(), Path::new("a.clad")),
        ladder_simulator::Options::default()
    );
    assert!(settings.files.contain(Path::new("/plant/a.clad")));
}

#[test]
fn every_key() {
    let settings = settings(
        r#"
[format]
width = 120
spacing = 3

[lint]
undeclared-tag = "error"
double-coil = "off"
no-output = "info"

[simulate]
interval = "T#20ms"
watchdog = 5_000
history = 300
retain = "state/plant.retain"

[workspace]
include = ["lines/", "pump.clad"]
exclude = ["old", "*.tmp.clad"]
"#,
    );
    assert_eq!((settings.format.width, settings.format.spacing), (120, 3));
    let lint: Vec<_> = settings.lint.levels.into_iter().collect();
    assert_eq!(
        lint,
        [
            (
                ladder_analysis::rules::rule_named("undeclared-tag").expect("a rule"),
                Level::Shown(Severity::Error)
            ),
            (
                ladder_analysis::rules::rule_named("no-output").expect("a rule"),
                Level::Shown(Severity::Info)
            ),
            (
                ladder_analysis::rules::rule_named("double-coil").expect("a rule"),
                Level::Off
            ),
        ]
    );
    assert_eq!(settings.simulate.interval, Some(20_000_000));
    assert_eq!(settings.simulate.watchdog, Some(5_000));
    assert_eq!(settings.simulate.history, Some(300));
    assert_eq!(
        settings.simulate.retain.map(|retain| retain.path()),
        Some(PathBuf::from("/plant/state/plant.retain"))
    );
    for (program, belongs) in [
        ("/plant/lines/a.clad", true),
        ("/plant/lines/deep/a.clad", true),
        ("/plant/pump.clad", true),
        ("/plant/valve.clad", false),
        ("/plant/lines/old/a.clad", false),
        ("/plant/lines/a.tmp.clad", false),
    ] {
        assert_eq!(settings.files.contain(Path::new(program)), belongs, "{program}");
    }
}

#[test]
fn what_is_no_toml() {
    wrong(
        "[format]\nwidth = \n",
        expect![[r#"
            ladder.toml:2:9: this is not TOML: string values must be quoted, expected literal string
        "#]],
    );
}

#[test]
fn what_is_larger_than_a_settings_file_can_be() {
    wrong(
        &"#".repeat((1 << 20) + 1),
        expect![[r#"
            ladder.toml:1:1: a ladder.toml has at most 1 MiB, and this one is larger
        "#]],
    );
}

#[test]
fn unknown_keys_and_tables() {
    wrong(
        "[formt]\nwidth = 5\n",
        expect![[r#"
            ladder.toml:1:2: `formt` is not a setting: did you mean `format`?
        "#]],
    );
    wrong(
        "[format]\nwith = 120\nindent = 4\n",
        expect![[r#"
            ladder.toml:2:1: `with` is not a setting in [format]: did you mean `width`?
            ladder.toml:3:1: `indent` is not a setting in [format]: known here are width, spacing
        "#]],
    );
    wrong(
        "format = 3\n",
        expect![[r#"
            ladder.toml:1:10: `format` is a table: write [format] on a line of its own
        "#]],
    );
}

#[test]
fn what_is_a_matter_of_taste_is_not_the_projects() {
    wrong(
        "[inlayHints]\nenable = true\n",
        expect![[r#"
            ladder.toml:1:2: `inlayHints` is not a setting: every person sets it in the settings of the editor
        "#]],
    );
}

#[test]
fn what_is_right_holds_next_to_what_is_wrong() {
    let (settings, errors) = Settings::examine(
        Path::new("/plant/ladder.toml"),
        "[format]\nwith = 120\nspacing = 3\n",
    );
    assert_eq!(errors.len(), 1);
    assert_eq!(settings.format.spacing, 3);
}

#[test]
fn wrong_values() {
    wrong(
        "[format]\nwidth = \"wide\"\nspacing = 0\n[simulate]\ninterval = 10\nwatchdog = -1\nretain = \"\"\n",
        expect![[r#"
            ladder.toml:2:9: a whole number from 40 to 300 is expected here
            ladder.toml:3:11: a whole number from 1 to 40 is expected here
            ladder.toml:5:12: a text in quotes is expected here, for example "20ms"
            ladder.toml:6:12: a whole number of at least 1 is expected here
            ladder.toml:7:10: name a file, or leave `retain` out
        "#]],
    );
    wrong(
        "[simulate]\ninterval = \"soon\"\n",
        expect![[r#"
            ladder.toml:2:12: `soon` is not a value for a TIME: write a duration as in 5s or T#1h30m, or a number of milliseconds
        "#]],
    );
    wrong(
        "[simulate]\ninterval = \"0ms\"\n",
        expect![[r#"
        ladder.toml:2:12: the time from one scan to the next must be longer than 0
    "#]],
    );
    wrong(
        "[lint]\ndouble-coils = \"warn\"\nno-output = \"warning\"\nfrobnicate = \"off\"\nopen-wire = 1\n",
        expect![[r#"
            ladder.toml:2:1: `double-coils` is not a rule: did you mean `double-coil`?
            ladder.toml:3:13: `warning` is not a severity: write "error", "warn", "info" or "off"
            ladder.toml:4:1: `frobnicate` is not a rule; the reference of the rules lists them all
            ladder.toml:5:13: a text in quotes is expected here, for example "warn"
        "#]],
    );
    wrong(
        "[workspace]\ninclude = \"lines\"\nexclude = [\"[z-a]\", 3]\n",
        expect![[r#"
            ladder.toml:2:11: a list of texts is expected here, for example ["lines/**"]
            ladder.toml:3:12: `[z-a]` is not a pattern as in .gitignore: invalid range; 'z' > 'a'
            ladder.toml:3:21: a text in quotes is expected here, for example "old/"
        "#]],
    );
}

/// A folder of files, each with its text.
fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    for (name, text) in files {
        let path = dir.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    dir
}

#[test]
fn a_workspace_is_what_include_and_exclude_leave_of_it() {
    let dir = folder(&[
        ("ladder.toml", "[workspace]\nexclude = [\"old\"]\n"),
        ("a.clad", ""),
        ("old/b.clad", ""),
        ("sub/c.clad", ""),
        // A workspace of its own.
        ("other/ladder.toml", ""),
        ("other/d.clad", ""),
    ]);
    let names = |paths: Vec<PathBuf>| -> Vec<String> {
        let below = paths.iter().map(|path| path.strip_prefix(dir.path()).unwrap());
        below.map(|path| path.display().to_string()).collect()
    };
    let root = Root::of(&dir.path().join("a.clad")).unwrap();
    let settings = root.settings().unwrap();
    assert_eq!(names(root.programs(&settings.files)), ["a.clad", "sub/c.clad"]);
    let (found, errors) = find_programs(&[dir.path().to_owned()]);
    assert!(errors.is_empty());
    assert_eq!(names(found), ["a.clad", "other/d.clad", "sub/c.clad"]);
    let named = find_programs(&[dir.path().join("old/b.clad")]).0;
    assert_eq!(names(named), ["old/b.clad"]);
}

#[test]
fn paths_that_lead_out_of_the_workspace() {
    for (text, message) in [
        (
            "[simulate]\nretain = \"/etc/profile.d/x.sh\"\n",
            "/plant/ladder.toml:2:10: `retain` cannot be used: a path in a workspace is relative: write it as it is seen \
             from the file that names it",
        ),
        (
            "[simulate]\nretain = \"state/../../x\"\n",
            "/plant/ladder.toml:2:10: `retain` cannot be used: this leads out of the workspace, the folder of ladder.toml \
             (without one: the file's own folder); an empty ladder.toml in a folder above both makes them one",
        ),
        (
            "[workspace]\ninclude = [\"../**\"]\n",
            "/plant/ladder.toml:2:12: `../**` leads out of the workspace: patterns are seen from the folder of ladder.toml",
        ),
        (
            "[workspace]\nexclude = [\"a/../../b\"]\n",
            "/plant/ladder.toml:2:12: `a/../../b` leads out of the workspace: patterns are seen from the folder of ladder.toml",
        ),
    ] {
        let error = Settings::parse(Path::new("/plant/ladder.toml"), text).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
}
