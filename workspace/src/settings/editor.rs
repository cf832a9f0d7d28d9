//! What an editor's own settings say.
//!
//! What must be the same for everybody who works on a project is in its `ladder.toml`, and nothing in an editor
//! changes it. An editor decides what is shown to the person at the screen; for programs that no `ladder.toml` is
//! above it may say the rest too.

use super::Settings;
use super::given::{self, Paths, Tree};
use super::reader::{Reader, Source};
use super::table::{CODE_LENS, INLAY_HINTS, SECTIONS, SetBy};
use std::path::Path;

/// An editor's settings.
#[derive(Debug, Clone)]
pub struct EditorSettings {
    /// Whether hints are shown at the ends of lines.
    pub inlay_hints: bool,
    /// Whether commands are shown above networks.
    pub code_lens: bool,
    /// What holds for programs that no `ladder.toml` is above.
    pub project: Settings,
}

impl Default for EditorSettings {
    fn default() -> Self {
        EditorSettings {
            inlay_hints: false,
            code_lens: true,
            project: Settings::default(),
        }
    }
}

impl EditorSettings {
    /// Reads what an editor says below `ladder`, as far as it is right, and what is wrong with the rest: a sentence
    /// each, with the name of the setting.
    pub fn read(tree: &Tree) -> (EditorSettings, Vec<String>) {
        let mut settings = EditorSettings::default();
        let mut paths = Paths::default();
        let Some(entries) = given::from_tree(tree, &mut paths) else {
            let message = "`ladder` is a table of settings, for example { \"format\": { \"width\": 120 } }";
            return (settings, vec![message.to_owned()]);
        };
        let mut reader = Reader::new(Source::Editor);
        let mut top = reader.top(entries);
        // There is no folder that paths could start at; those who need one are settings of the file only.
        settings.project = Settings::take(&mut top, Path::new(""), &mut reader);
        for section in SECTIONS {
            match section.name {
                "inlayHints" => {
                    if let Some(mut table) = reader.section(&mut top, section) {
                        settings.inlay_hints = reader.switch(&mut table, &INLAY_HINTS).unwrap_or(false);
                        table.finish(&mut reader);
                    }
                }
                "codeLens" => {
                    if let Some(mut table) = reader.section(&mut top, section) {
                        settings.code_lens = reader.switch(&mut table, &CODE_LENS).unwrap_or(true);
                        table.finish(&mut reader);
                    }
                }
                // An extension reads these itself, and they come along.
                _ if section.settings.iter().all(|it| it.place == SetBy::Extension) => {
                    top.take(section.name);
                }
                _ => {}
            }
        }
        top.finish(&mut reader);
        let told = |(range, message)| match paths.of(&range) {
            "" => message,
            path => format!("`ladder.{path}`: {message}"),
        };
        let errors = reader.finish().into_iter().map(told).collect();
        (settings, errors)
    }
}
