//! What is written from the table of settings: the tables of the book's page, the JSON schema of `ladder.toml`, and the
//! settings of the extension for Visual Studio Code.

use crate::rule_index::summary;
use ladder_analysis::Severity;
use ladder_workspace::table::{Kind, LEVELS, LINT, SECTIONS, Section, SetBy, Setting};
use serde_json::{Map, Value, json};
use std::fmt::Write;

/// The tables of the page about settings: those of the file, and those of an editor.
pub fn tables() -> [String; 2] {
    [
        table("in `ladder.toml`", SetBy::is_in_file, |section, setting| {
            let (open, close) = if section.list.is_some() {
                ("[[", "]]")
            } else {
                ("[", "]")
            };
            format!("`{open}{}{close}` `{}`", section.name, setting.key)
        }),
        table(
            "in an editor",
            |place| matches!(place, SetBy::FileOrEditor | SetBy::Editor),
            |section, setting| format!("`{}.{}`", section.name, setting.key),
        ),
    ]
}

fn table(title: &str, shown: impl Fn(SetBy) -> bool, name: impl Fn(&Section, &Setting) -> String) -> String {
    let mut out = format!("| {title} | takes | default | |\n| --- | --- | --- | --- |\n");
    for section in SECTIONS {
        if section.name == LINT.name {
            let levels = LEVELS.map(|level| format!("`\"{level}\"`")).join(" ");
            let rule = Setting {
                key: "*rule*",
                ..LINT.settings[0]
            };
            let name = name(section, &rule)
                .replace("`*rule*`", "*rule*")
                .replace(".*rule*`", "`*.rule*");
            // Writing to a String does not fail.
            let _ = writeln!(
                out,
                "| {name} | {levels} | [the rule's own](../rules/index.md) | {} |",
                section.about
            );
        }
        for setting in section.settings.iter().filter(|setting| shown(setting.place)) {
            let default = setting
                .default
                .map_or_else(String::new, |default| format!("`{default}`"));
            let _ = writeln!(
                out,
                "| {} | {} | {default} | {} |",
                name(section, setting),
                takes(setting),
                setting.about
            );
        }
    }
    out
}

fn takes(setting: &Setting) -> String {
    match setting.kind {
        Kind::Whole { least, most } if most == i64::MAX => format!("a number from {least}"),
        Kind::Whole { least, most } => format!("{least} to {most}"),
        Kind::Duration => format!("a time, as `{}`", setting.example),
        Kind::File => format!("a file, as `{}`", setting.example),
        Kind::Patterns => format!("patterns, as `{}`", setting.example),
        Kind::Folders => format!("folders, as `{}`", setting.example),
        Kind::Programs => format!("programs, as `{}`", setting.example),
        Kind::Switch => "`true` or `false`".to_owned(),
        Kind::Text => "a text".to_owned(),
        Kind::Texts => format!("a text or a list of texts, as `{}`", setting.example),
        Kind::Choice(choices) => choices
            .iter()
            .map(|choice| format!("`\"{choice}\"`"))
            .collect::<Vec<_>>()
            .join(" "),
        Kind::Units => format!(
            "a number from 0 to 255 or a list of them, as `{}`",
            setting.example
        ),
        Kind::Places | Kind::Names => {
            format!("a table of {}, as `{}`", setting.kind.entries(), setting.example)
        }
        Kind::Overrides => "tables `[[lint.overrides]]`, each with `files` and rules".to_owned(),
    }
}

/// The JSON schema of `ladder.toml`, as text.
pub fn schema() -> String {
    let mut properties = Map::new();
    for section in SECTIONS {
        let of_file: Vec<&Setting> = section
            .settings
            .iter()
            .filter(|setting| setting.place.is_in_file())
            .collect();
        if of_file.is_empty() {
            continue;
        }
        let mut keys = Map::new();
        for setting in of_file {
            keys.insert(setting.key.to_owned(), described(setting, setting.about));
        }
        if section.name == LINT.name {
            keys.extend(rules(&json!({ "$ref": "#/definitions/level" })));
        }
        let mut table = json!({
            "type": "object",
            "description": section.about,
            "properties": keys,
            "additionalProperties": false
        });
        if let Some(required) = section.list {
            table["required"] = json!(required);
            table = json!({ "type": "array", "description": section.about, "items": table });
        }
        match section.outer() {
            (outer, Some(inner)) => {
                let around = json!({
                    "type": "object",
                    "properties": { inner: table },
                    "additionalProperties": false
                });
                properties.insert(outer.to_owned(), around);
            }
            (name, None) => {
                properties.insert(name.to_owned(), table);
            }
        }
    }
    let schema = json!({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "ladder.toml",
        "description": "How the ladder programs of a workspace are laid out, checked and run.",
        "type": "object",
        "properties": properties,
        "additionalProperties": false,
        "definitions": { "level": {
            "anyOf": [
                { "enum": LEVELS },
                {
                    "type": "object",
                    "properties": {
                        "level": { "enum": LEVELS },
                        "reason": { "type": "string", "description": "Why, for those who read the file." }
                    },
                    "required": ["level"],
                    "additionalProperties": false
                }
            ]
        }}
    });
    pretty(&schema) + "\n"
}

/// The value of `contributes.configuration` in the extension's package.json, as it is there.
pub fn extension_settings() -> String {
    let mut entries = Vec::new();
    for section in SECTIONS {
        if section.name == LINT.name {
            let lint = json!({
                "type": "object",
                "default": {},
                "scope": "window",
                "markdownDescription": about(section.about, SetBy::FileOrEditor),
                // Without a type the page of settings does not show them.
                "properties": rules(&json!({ "type": "string", "enum": LEVELS })),
                "additionalProperties": false
            });
            entries.push((format!("ladder.{}", section.name), lint));
        }
        for setting in section.settings.iter().filter(|it| it.place.is_in_editor()) {
            let mut entry = described(setting, setting.about);
            let fields = entry.as_object_mut().expect("an object");
            fields.remove("description");
            fields.remove("examples");
            fields.insert(
                "markdownDescription".into(),
                about(setting.about, setting.place).into(),
            );
            // Those who may write a workspace's settings must not say which program runs.
            let scope = if setting.kind == Kind::Text {
                // Not for a workspace to say, trusted or not.
                "machine"
            } else {
                "window"
            };
            fields.insert("scope".into(), scope.into());
            if setting.default.is_none() {
                let kind = fields["type"].take();
                fields.insert("type".into(), json!([kind, "null"]));
                fields.insert("default".into(), Value::Null);
            }
            entries.push((format!("ladder.{}.{}", section.name, setting.key), entry));
        }
    }
    let mut out = "[\n  {\n    \"title\": \"Ladder\",\n    \"properties\": {\n".to_owned();
    for (nth, (name, mut entry)) in entries.into_iter().enumerate() {
        entry["order"] = json!(nth + 1);
        let comma = if nth == 0 { "" } else { ",\n" };
        let _ = write!(
            out,
            "{comma}      \"{name}\": {}",
            pretty(&entry).replace('\n', "\n      ")
        );
    }
    out += "\n    }\n  }\n]";
    out.replace('\n', "\n    ")
}

fn about(about: &str, place: SetBy) -> String {
    match place {
        SetBy::FileOrEditor => {
            format!("{about} For programs that no `ladder.toml` is above; otherwise that file says it.")
        }
        SetBy::File | SetBy::Editor | SetBy::Extension => about.to_owned(),
    }
}

fn rules(takes: &Value) -> Map<String, Value> {
    let rules = ladder_analysis::rules::ALL.iter().map(|rule| {
        let mut entry = takes.clone();
        let level = match (rule.on_by_default(), rule.default_severity()) {
            (false, _) => "off",
            (true, Severity::Error) => "error",
            (true, Severity::Warning) => "warn",
            (true, Severity::Info) => "info",
        };
        let about = format!(
            "{} Without a setting: {level}.",
            summary(*rule).replace("\\|", "|")
        );
        // Next to a reference a description is not checked.
        if let Some(reference) = entry.as_object_mut().and_then(|it| it.remove("$ref")) {
            entry = json!({ "allOf": [{ "$ref": reference }] });
        }
        entry["description"] = about.into();
        (rule.name().to_owned(), entry)
    });
    rules.collect()
}

fn described(setting: &Setting, about: &str) -> Value {
    let mut entry = match setting.kind {
        Kind::Whole { least, most } if most == i64::MAX => json!({ "type": "integer", "minimum": least }),
        Kind::Whole { least, most } => json!({ "type": "integer", "minimum": least, "maximum": most }),
        Kind::Duration => json!({ "type": "string", "pattern": DURATION }),
        Kind::File => json!({ "type": "string", "minLength": 1 }),
        Kind::Text => json!({ "type": "string" }),
        Kind::Texts => json!({ "anyOf": [
            { "type": "string" },
            { "type": "array", "items": { "type": "string" } }
        ] }),
        Kind::Patterns | Kind::Folders | Kind::Programs => {
            json!({ "type": "array", "items": { "type": "string" } })
        }
        Kind::Switch => json!({ "type": "boolean" }),
        Kind::Choice(choices) => json!({ "type": "string", "enum": choices }),
        Kind::Units => {
            let unit = json!({ "type": "integer", "minimum": 0, "maximum": 255 });
            json!({ "anyOf": [unit, { "type": "array", "items": unit }] })
        }
        Kind::Places | Kind::Names => {
            json!({ "type": "object", "additionalProperties": { "type": "string" } })
        }
        Kind::Overrides => json!({ "type": "array", "items": {
            "type": "object",
            "properties": overriding(),
            "required": ["files"],
            "additionalProperties": false
        }}),
    };
    entry["description"] = about.into();
    if let Some(default) = setting.default {
        entry["default"] = as_json(default);
    }
    if matches!(setting.kind, Kind::Duration | Kind::File) {
        entry["examples"] = json!([as_json(setting.example)]);
    }
    entry
}

/// `10ms`, `T#1h30m`, or milliseconds. What else a time must be is for the reader to say.
const DURATION: &str = r"^\s*([Tt]([Ii][Mm][Ee])?#)?[0-9][0-9A-Za-z_.]*\s*$";

fn overriding() -> Map<String, Value> {
    let mut keys = rules(&json!({ "$ref": "#/definitions/level" }));
    keys.insert(
        "files".into(),
        json!({
            "type": "array",
            "items": { "type": "string" },
            "description": "The files that are meant: patterns as in .gitignore, seen from the folder of ladder.toml."
        }),
    );
    keys
}

/// The simple values that settings have are written alike in both languages.
fn as_json(toml: &str) -> Value {
    serde_json::from_str(toml).unwrap_or_else(|error| panic!("{toml}: {error}"))
}

fn pretty(value: &Value) -> String {
    serde_json::to_string_pretty(value).expect("JSON")
}
