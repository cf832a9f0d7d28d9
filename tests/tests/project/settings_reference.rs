//! The page, the schema and the extension have the settings that the reader reads.
//!
//! After the table of settings or a rule was changed, `UPDATE_EXPECT=1 cargo test -p ladder-tests` writes them again.

use expect_test::expect_file;
use ladder_devices::modbus::{self, Hold, Layout, Words};
use ladder_devices::online;
use ladder_tests::project::{files, read, root};
use ladder_tests::settings_reference::{extension_settings, schema, tables};
use ladder_workspace::table::{Kind, SECTIONS, SetBy};
use ladder_workspace::{EditorSettings, Settings, Tree};
use serde_json::Value;
use std::path::Path;

/// The text with what is after `begin`, up to `end`, replaced.
fn replaced(text: &str, begin: &str, end: &str, new: &str) -> String {
    let start = text.find(begin).unwrap_or_else(|| panic!("{begin} is missing")) + begin.len();
    let length = text[start..]
        .find(end)
        .unwrap_or_else(|| panic!("{end} is missing"));
    format!("{}{new}{}", &text[..start], &text[start + length..])
}

#[test]
fn the_page_lists_every_setting() {
    let page = root().join("docs/src/guide/settings.md");
    let [of_file, of_editor] = tables();
    let mut text = read(&page);
    for (name, table) in [("file", of_file), ("editor", of_editor)] {
        let begin = format!("<!-- settings of the {name}, written by a test -->\n\n");
        text = replaced(&text, &begin, "\n<!-- end -->", &table);
    }
    expect_file![page].assert_eq(&text);
}

#[test]
fn the_schema_is_up_to_date() {
    for place in ["docs/schema", "editors/vscode/schema"] {
        expect_file![root().join(place).join("ladder.schema.json")].assert_eq(&schema());
    }
}

#[test]
fn the_extension_has_every_setting_of_an_editor() {
    let manifest = root().join("editors/vscode/package.json");
    let text = read(&manifest);
    let new = replaced(
        &text,
        "\n    },\n    \"configuration\": ",
        ",\n    \"tomlValidation\"",
        &extension_settings(),
    );
    serde_json::from_str::<Value>(&new).unwrap();
    expect_file![manifest].assert_eq(&new);
}

/// What the table says holds without a setting is what the crates do.
#[test]
fn the_defaults_are_those_of_the_code() {
    let nothing = Settings::default();
    let editor = EditorSettings::default();
    let served = modbus::Rules::default();
    let device = modbus::Device::new("rio", "192.168.1.20:502");
    let engine = nothing
        .simulate
        .options(&ladder_analysis::program::Program::default(), Path::new("a.clad"));
    for section in SECTIONS {
        for setting in section.settings.iter().filter(|it| it.place != SetBy::Extension) {
            let found = match (section.name, setting.key) {
                ("format", "width") => Some(nothing.format.width.to_string()),
                ("format", "spacing") => Some(nothing.format.spacing.to_string()),
                ("simulate", "interval") => Some(format!("\"{}ms\"", engine.interval / 1_000_000)),
                ("simulate", "watchdog") => Some(engine.watchdog.to_string()),
                ("inlayHints", "enable") => Some(editor.inlay_hints.to_string()),
                ("codeLens", "enable") => Some(editor.code_lens.to_string()),
                ("serve.modbus", "listen") => Some(format!("\"{}\"", modbus::ADDRESS)),
                ("serve.modbus", "unit") => Some(format!("{:?}", served.units)),
                ("serve.modbus", "layout") if Layout::default() == Layout::OpenPlc => {
                    Some("\"openplc\"".to_owned())
                }
                ("serve.modbus" | "device", "words") if Words::default() == Words::Big => {
                    Some("\"big\"".to_owned())
                }
                ("serve.modbus", "hold") if Hold::default() == Hold::Last => Some("\"last\"".to_owned()),
                ("serve.modbus", "timeout") => Some(format!("\"{:?}\"", modbus::TIMEOUT)),
                ("serve.modbus", "connections") => Some(served.connections.to_string()),
                ("serve.modbus", "idle") => Some(format!("\"{:?}\"", served.idle)),
                ("device", "unit") => Some(device.unit.to_string()),
                ("device", "poll") => Some(format!("\"{:?}\"", device.poll)),
                ("device", "timeout") => Some(format!("\"{:?}\"", device.timeout)),
                ("device", "repeat") => Some(format!("\"{:?}\"", device.repeat)),
                ("device", "gap") => Some(device.gap.to_string()),
                ("online", "unit") => Some("1".to_owned()),
                ("online", "layout") => Some("\"openplc\"".to_owned()),
                ("online", "words") => Some("\"big\"".to_owned()),
                ("online", "every") => Some(format!("\"{:?}\"", online::EVERY)),
                ("online", "timeout") => Some(format!("\"{:?}\"", online::PATIENCE)),
                ("task", "priority") => Some("0".to_owned()),
                ("simulate", "history" | "retain" | "plant" | "connect")
                | ("lint", "overrides")
                | ("run", "watchdog")
                | ("serve.modbus", "write" | "allow" | "map")
                | ("task" | "device" | "online" | "workspace" | "project", _) => None,
                other => panic!("compare the default of {other:?} with the code"),
            };
            assert_eq!(setting.default.map(str::to_owned), found, "{}", setting.key);
        }
    }
}

/// Every setting of the table is read: as its example it is right, as anything else it is wrong.
#[test]
fn every_setting_is_read() {
    for section in SECTIONS {
        for setting in section.settings {
            if setting.place.is_in_file() {
                // A task needs the others, too.
                let others = section
                    .settings
                    .iter()
                    .filter(|it| section.list.is_some() && it.key != setting.key);
                let others: Vec<String> = others
                    .map(|it| format!("{} = {}\n", it.key, it.example))
                    .collect();
                let heading = if section.list.is_some() {
                    format!("[[{}]]", section.name)
                } else {
                    format!("[{}]", section.name)
                };
                let text = |value: &str| format!("{heading}\n{}{} = {value}\n", others.concat(), setting.key);
                let errors = |value: &str| Settings::examine(Path::new("ladder.toml"), &text(value)).1;
                assert_eq!(errors(setting.example), [], "{}", text(setting.example));
                assert_eq!(errors("1979-05-27").len(), 1, "{}", text("1979-05-27"));
            }
            if matches!(setting.place, SetBy::FileOrEditor | SetBy::Editor) {
                let errors = |value: Tree| {
                    let section = (
                        section.name.to_owned(),
                        Tree::Table(vec![(setting.key.to_owned(), value)]),
                    );
                    EditorSettings::read(&Tree::Table(vec![section])).1
                };
                let example = match setting.kind {
                    Kind::Whole { .. } => Tree::Whole(setting.example.parse().unwrap()),
                    Kind::Switch => Tree::Switch(setting.example == "true"),
                    _ => Tree::Text(setting.example.trim_matches('"').to_owned()),
                };
                assert_eq!(errors(example), [""; 0], "{}.{}", section.name, setting.key);
                assert_eq!(errors(Tree::Other).len(), 1, "{}.{}", section.name, setting.key);
            }
        }
    }
}

/// The files that the schema is tried with are right and wrong for the reader, too.
#[test]
fn examples_are_what_their_folder_says() {
    let folder = root().join("tests/settings");
    for (kind, right) in [("good", true), ("broken", false)] {
        let files = files(&folder.join(kind), "toml");
        assert!(files.len() > 3, "{kind}");
        for file in files {
            let found = Settings::parse(&file, &read(&file));
            assert_eq!(found.is_ok(), right, "{}: {found:?}", file.display());
        }
    }
}
