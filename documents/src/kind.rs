//! What an open text is.

use std::path::Path;

use ladder_notations::{Notation, by_language, recognise};
use ladder_workspace::{SETTINGS_FILE, is_ladder_text, is_scenario, is_scene};

/// How the languages of notations begin. One that is not known is of a notation that this build leaves out.
const NOTATION: &str = "ladder-";

/// What an open text is.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Kind {
    /// Ladder text. Whatever has another name but is not known to be something else.
    #[default]
    Program,
    /// A program of another system: of a language that a notation calls its own, or in a file that is one by its name and
    /// content. Files in Python are nobody's but Python's unless the client names such a language for them.
    Foreign(&'static dyn Notation),
    /// `ladder.toml`.
    Settings,
    /// A file of scenarios.
    Scenarios,
    /// A drawing of the machine.
    Scene,
    /// Something that the server knows nothing of: the client sends all files of a language.
    Other,
}

impl Kind {
    /// By the address, by the language that the client says it is, and by its text.
    pub fn of(uri: &str, language: &str, text: &str) -> Kind {
        let name = Path::new(uri.rsplit('/').next().unwrap_or(uri));
        if let Some(notation) = by_language(language) {
            Kind::Foreign(notation)
        } else if name == Path::new(SETTINGS_FILE) {
            Kind::Settings
        } else if is_ladder_text(name) {
            Kind::Program
        } else if is_scenario(name) || matches!(language, "ladder-test" | "laddertest") {
            Kind::Scenarios
        } else if is_scene(name) {
            Kind::Scene
        } else if matches!(language, "toml" | "python") || language.starts_with(NOTATION) {
            Kind::Other
        } else if let Some(notation) = by_file(name, text).filter(|_| language != "clad") {
            Kind::Foreign(notation)
        } else if language == "xml" {
            Kind::Other
        } else {
            Kind::Program
        }
    }

    /// The notation of a program of another system.
    pub fn notation(self) -> Option<&'static dyn Notation> {
        match self {
            Kind::Foreign(notation) => Some(notation),
            Kind::Program | Kind::Settings | Kind::Scenarios | Kind::Scene | Kind::Other => None,
        }
    }
}

/// The notation of a file whose name ends as its files' names do, and which is in it.
fn by_file(name: &Path, text: &str) -> Option<&'static dyn Notation> {
    let extension = name.extension()?.to_str()?;
    recognise(name, text.as_bytes()).filter(|notation| {
        let mut endings = notation.extensions().iter();
        notation.is_read() && endings.any(|ending| ending.eq_ignore_ascii_case(extension))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_text_is() {
        let foreign = Kind::Foreign(by_language("ladder-click").expect("it is in the list"));
        for (uri, language, kind) in [
            ("file:///plant/motor.clad", "clad", Kind::Program),
            ("file:///plant/motor.clad", "", Kind::Program),
            ("untitled:Untitled-1", "clad", Kind::Program),
            ("file:///plant/ladder.toml", "toml", Kind::Settings),
            ("file:///plant/ladder.toml", "plaintext", Kind::Settings),
            ("file:///plant/Cargo.toml", "toml", Kind::Other),
            ("file:///plant/motor.ladder-test", "ladder-test", Kind::Scenarios),
            ("file:///plant/motor.ladder-test", "", Kind::Scenarios),
            ("untitled:Untitled-2", "laddertest", Kind::Scenarios),
            ("file:///plant/tank.scene.svg", "svg", Kind::Scene),
            ("file:///plant/tank.svg", "svg", Kind::Program),
            ("file:///plant/tank.py", "python", Kind::Other),
            ("file:///plant/tank.py", "ladder-click", foreign),
            ("untitled:Untitled-3", "ladder-click", foreign),
            ("untitled:Untitled-3", "ladder-unheard-of", Kind::Other),
        ] {
            assert_eq!(Kind::of(uri, language, ""), kind, "{uri} {language}");
        }
    }

    #[test]
    fn programs_of_other_systems_are_known_by_name_and_content() {
        const PLCOPEN: &str =
            r#"<?xml version="1.0"?><project xmlns="http://www.plcopen.org/xml/tc6_0201"></project>"#;
        for (uri, language, text, notation) in [
            (
                "file:///plant/Main.L5X",
                "xml",
                "<RSLogix5000Content/>",
                Some("l5x"),
            ),
            ("file:///plant/Main.L5X", "plaintext", "", Some("l5x")),
            (
                "file:///plant/Fill.TcPOU",
                "plaintext",
                "<TcPlcObject/>",
                Some("twincat"),
            ),
            ("file:///plant/Block.s7dcl", "plaintext", "", Some("simatic")),
            ("file:///plant/plc.xml", "xml", PLCOPEN, Some("plcopen")),
            ("file:///plant/pom.xml", "xml", "<project/>", None),
            ("untitled:Main.L5X", "clad", "", None),
        ] {
            let kind = Kind::of(uri, language, text);
            assert_eq!(kind.notation().map(Notation::name), notation, "{uri} {language}");
        }
        assert_eq!(
            Kind::of("file:///plant/pom.xml", "xml", "<project/>"),
            Kind::Other
        );
    }
}
