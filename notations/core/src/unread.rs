//! Unread parts (LANGUAGE §5.9): what a reader does not understand becomes a block that names it and says what it may write.
//!
//! A reader collects them in [`UnreadParts`]: [`UnreadParts::block`] is what stands on the rung, [`UnreadParts::items`] are the
//! definitions. A body of its own, whose declarations are read, is only marked as unread: [`unread_body`].

use ladder_format::program::{Declaration, Item, Section, SectionKind};
use std::collections::HashMap;

/// As many characters of its operands a block takes; a longer text is in its definition.
const MOST_CHARACTERS: usize = 254;

/// A part that is not understood.
#[derive(Debug, Clone, Copy)]
pub struct Unread<'a> {
    /// What it is called: `MSG`, `routine Calc`.
    pub name: &'a str,
    /// A sentence for the comment above the definition: `MSG: reads and writes other controllers; it is not run here.`
    pub about: &'a str,
    /// What the other system writes for it: operands of an instruction, or a body.
    pub text: &'a str,
    /// The tags of the program that it may write, as they are named at its place. None: it is not known.
    pub writes: Option<&'a [String]>,
    /// What its power is.
    pub power: Power,
    /// When it runs.
    pub turn: Turn,
}

/// What power leaves an unread part while a scan runs past it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Power {
    /// It acts: what enters.
    Passes,
    /// It is a condition, and not known to hold: none.
    Ends,
}

/// When an unread part runs in the other system.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Turn {
    /// In its place.
    Here,
    /// It is another task's: between any two networks.
    AnyTime,
}

/// The unread parts of a program.
#[derive(Debug, Clone, Default)]
pub struct UnreadParts {
    /// In the order in which they were met.
    definitions: Vec<Vec<Item>>,
    /// The name of each, with its `$`, by what makes it another one.
    names: HashMap<Key, String>,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash)]
struct Key {
    name: String,
    directive: String,
    power: Power,
    /// The text, where it is in the definition.
    text: Option<String>,
}

impl UnreadParts {
    /// A part as it is on a rung: `[$MSG]( 'control, data' )`. `is_taken` says which names, with the `$`, other blocks have.
    pub fn block(&mut self, part: Unread<'_>, is_taken: impl Fn(&str) -> bool) -> String {
        let is_short = part.text.chars().count() <= MOST_CHARACTERS && !part.text.contains(['\n', '\r']);
        let key = Key {
            name: part.name.to_ascii_lowercase(),
            directive: directive(part.writes, part.turn),
            power: part.power,
            text: (!is_short).then(|| part.text.to_owned()),
        };
        let name = match self.names.get(&key) {
            Some(name) => name.clone(),
            None => self.define(part, key, is_taken),
        };
        if !is_short || part.text.is_empty() {
            return format!("[{name}]");
        }
        let shown = part.text.replace('$', "$$").replace('\'', "$'");
        format!("[{name}]( '{}' )", shown.replace(char::is_control, " "))
    }

    fn define(&mut self, part: Unread<'_>, key: Key, is_taken: impl Fn(&str) -> bool) -> String {
        let word = block_name(part.name);
        let is_free = |name: &String| {
            let mut names = self.names.values();
            !is_taken(name) && names.all(|other| !other.eq_ignore_ascii_case(name))
        };
        let numbered = (2u64..).map(|number| format!("{word}{number}"));
        let mut names = std::iter::once(word.clone()).chain(numbered);
        let name = names.find(is_free).unwrap_or(word);
        let mut items = Vec::new();
        if key.text.is_none() && !part.text.is_empty() {
            let mut section = Section::new(SectionKind::VarInput);
            section.declarations.push(Declaration {
                names: vec!["operands".to_owned()],
                ty: format!("STRING[{MOST_CHARACTERS}]"),
                initial: Some("''".to_owned()),
                ..Declaration::default()
            });
            items.push(Item::Section(section));
        }
        items.push(Item::Directive(key.directive.clone()));
        items.extend(key.text.as_deref().map(foreign_text));
        if part.power == Power::Ends {
            items.push(Item::Text("+--(R)( ENO )--+".to_owned()));
        }
        let header = format!("[{name}]");
        let above = Item::Comment(part.about.to_owned());
        let block = Item::Block { header, items };
        self.definitions.push(vec![Item::Blank, above, block]);
        self.names.insert(key, name.clone());
        name
    }

    /// Their definitions.
    pub fn items(&self) -> impl Iterator<Item = Item> {
        self.definitions.iter().flatten().cloned()
    }

    /// Whether there is none.
    pub const fn is_empty(&self) -> bool {
        self.definitions.is_empty()
    }
}

/// What is in the definition of a block whose declarations are read, and whose body is not.
pub fn unread_body(text: &str, writes: Option<&[String]>) -> [Item; 2] {
    [Item::Directive(directive(writes, Turn::Here)), foreign_text(text)]
}

/// What the comment for the tools says: `unread, writes control, data`.
fn directive(writes: Option<&[String]>, turn: Turn) -> String {
    let mut text = "unread".to_owned();
    if turn == Turn::AnyTime {
        text.push_str(", at any time");
    }
    if let Some(writes) = writes {
        text.push_str(", writes ");
        text.push_str(&writes.join(", "));
    }
    text.trim_end().to_owned()
}

/// A text of another system as a comment, from which it comes back to the letter.
fn foreign_text(text: &str) -> Item {
    Item::Comment(text.replace('\\', "\\\\").replace('#', "\\h"))
}

/// The text of another system that a comment holds, without its `#`.
pub fn of_foreign_text(comment: &str) -> String {
    let mut text = String::with_capacity(comment.len());
    let mut rest = comment.chars();
    while let Some(c) = rest.next() {
        match c {
            '\\' => text.push(if rest.next() == Some('h') { '#' } else { '\\' }),
            _ => text.push(c),
        }
    }
    text
}

/// A name as that of a block, with its `$`: letters and digits, a letter first.
fn block_name(name: &str) -> String {
    let mut word: String = name.chars().filter(char::is_ascii_alphanumeric).collect();
    if !word.starts_with(|c: char| c.is_ascii_alphabetic()) {
        word.insert_str(0, "Part");
    }
    word.insert(0, '$');
    word
}

#[cfg(test)]
mod tests {
    use super::*;
    use ladder_format::program::ProgramSketch;

    fn written(parts: &UnreadParts) -> String {
        let items = parts.items().collect();
        ProgramSketch { items }
            .write(&ladder_format::Options::default())
            .text
    }

    const MSG: Unread<'_> = Unread {
        name: "MSG",
        about: "MSG: it is not run here.",
        text: "control,'data'",
        writes: None,
        power: Power::Passes,
        turn: Turn::Here,
    };

    #[test]
    fn a_part_is_one_block_wherever_it_is() {
        let mut parts = UnreadParts::default();
        let is_taken = |name: &str| name == "$MSG";
        let place = parts.block(MSG, is_taken);
        assert_eq!(place, "[$MSG2]( 'control,$'data$'' )");
        assert_eq!(parts.block(MSG, is_taken), place);
        let writes = ["a".to_owned(), "b".to_owned()];
        let other = Unread {
            writes: Some(&writes),
            power: Power::Ends,
            text: "x := 16#FF;\ny := 2;",
            turn: Turn::AnyTime,
            ..MSG
        };
        assert_eq!(parts.block(other, is_taken), "[$MSG3]");
        expect_test::expect![[r#"
            # MSG: it is not run here. #
            FUNCTION_BLOCK [$MSG2]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread #
            END_FUNCTION_BLOCK

            # MSG: it is not run here. #
            FUNCTION_BLOCK [$MSG3]
            # ladder: unread, at any time, writes a, b #
            # x := 16\hFF; #
            # y := 2; #
            +------------------------------------------------------------------(R)( ENO )--+
            END_FUNCTION_BLOCK
        "#]]
        .assert_eq(&written(&parts));
    }

    #[test]
    fn a_foreign_text_comes_back() {
        for text in ["a \\h # b \\", "", "\\", "#", "\\\\h"] {
            let Item::Comment(comment) = foreign_text(text) else {
                unreachable!("it is a comment");
            };
            assert!(!comment.contains('#'));
            assert_eq!(of_foreign_text(&comment), text);
        }
    }
}
