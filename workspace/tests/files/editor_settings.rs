//! What editors say of settings, and what is wrong with it.

use expect_test::{Expect, expect};
use ladder_analysis::Level;
use ladder_workspace::{EditorSettings, Tree};

fn table(entries: &[(&str, Tree)]) -> Tree {
    let entries = entries
        .iter()
        .map(|(key, value)| ((*key).to_owned(), value.clone()));
    Tree::Table(entries.collect())
}

fn text(text: &str) -> Tree {
    Tree::Text(text.to_owned())
}

fn wrong(tree: &Tree, expected: Expect) -> EditorSettings {
    let (settings, errors) = EditorSettings::read(tree);
    expected.assert_eq(&(errors.join("\n") + "\n"));
    settings
}

#[test]
fn nothing_is_what_holds_anyway() {
    for tree in [Tree::Nothing, table(&[]), table(&[("format", Tree::Nothing)])] {
        let (settings, errors) = EditorSettings::read(&tree);
        assert_eq!(errors, Vec::<String>::new());
        assert!(!settings.inlay_hints && settings.code_lens);
        assert_eq!(settings.project.format, ladder_format::Options::default());
    }
}

#[test]
fn every_key() {
    let (settings, errors) = EditorSettings::read(&table(&[
        (
            "format",
            table(&[("width", Tree::Whole(120)), ("spacing", Tree::Whole(3))]),
        ),
        ("lint", table(&[("double-coil", text("off"))])),
        (
            "simulate",
            table(&[
                ("interval", text("20ms")),
                ("watchdog", Tree::Whole(7)),
                ("history", Tree::Whole(0)),
            ]),
        ),
        ("inlayHints", table(&[("enable", Tree::Switch(true))])),
        ("codeLens", table(&[("enable", Tree::Switch(false))])),
        ("server", table(&[("path", text("/opt/ladder"))])),
        ("trace", table(&[("server", text("verbose"))])),
    ]));
    assert_eq!(errors, Vec::<String>::new());
    assert!(settings.inlay_hints && !settings.code_lens);
    let project = settings.project;
    assert_eq!((project.format.width, project.format.spacing), (120, 3));
    assert_eq!(
        project
            .lint
            .levels
            .get(&ladder_analysis::rules::rule_named("double-coil").expect("a rule")),
        Some(&Level::Off)
    );
    assert_eq!(project.simulate.interval, Some(20_000_000));
    assert_eq!(
        (project.simulate.watchdog, project.simulate.history),
        (Some(7), Some(0))
    );
}

#[test]
fn what_is_wrong_is_named_and_the_rest_holds() {
    let settings = wrong(
        &table(&[
            ("formt", table(&[])),
            (
                "format",
                table(&[
                    ("width", text("wide")),
                    ("spacing", Tree::Whole(4)),
                    ("with", Tree::Other),
                ]),
            ),
            (
                "lint",
                table(&[("open-wires", text("off")), ("no-output", text("warning"))]),
            ),
            ("inlayHints", Tree::Switch(true)),
            ("codeLens", table(&[("enable", text("yes"))])),
        ]),
        expect![[r#"
            `ladder.formt`: `formt` is not a setting: did you mean `format`?
            `ladder.format.width`: a whole number from 40 to 300 is expected here
            `ladder.format.with`: `with` is not a setting in [format]: did you mean `width`?
            `ladder.lint.open-wires`: `open-wires` is not a rule: did you mean `open-wire`?
            `ladder.lint.no-output`: `warning` is not a severity: write "error", "warn", "info" or "off"
            `ladder.inlayHints`: a table of settings is expected here, as in { "enable": ... }
            `ladder.codeLens.enable`: true or false is expected here
        "#]],
    );
    assert_eq!(settings.project.format.spacing, 4);
}

#[test]
fn what_must_be_the_same_for_everybody_is_not_set_in_an_editor() {
    wrong(
        &table(&[
            ("workspace", table(&[("exclude", Tree::List(vec![text("old/")]))])),
            ("simulate", table(&[("retain", text("plant.retain"))])),
        ]),
        expect![[r#"
            `ladder.workspace`: `workspace` is not a setting: it must be the same for everybody, and is in ladder.toml
            `ladder.simulate.retain`: `retain` is not a setting in [simulate]: it must be the same for everybody, and is in ladder.toml
        "#]],
    );
}

#[test]
fn what_is_no_table_at_all() {
    wrong(
        &text("on"),
        expect![[r#"
            `ladder` is a table of settings, for example { "format": { "width": 120 } }
        "#]],
    );
}
