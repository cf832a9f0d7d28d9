//! Unread parts (LANGUAGE §5.9): what a reader does not understand becomes a block that names it and says what it may write.
//!
//! A reader collects them in [`UnreadParts`]: [`UnreadParts::block`] is what is on the rung, [`UnreadParts::items`] are the
//! definitions. A body of its own, whose declarations are read, is only marked as unread: [`unread_body`].

use crate::block_name::block_name;
use ladder_format::program::{Block, Declaration, Item, Section, SectionKind};
use std::collections::{HashMap, HashSet};

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
    /// The tags of the program that it may write, as they are named at its place; a condition may have none. `None`: it is not
    /// known.
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
    /// The name of each, with its `$`, and its number, by what makes it another one.
    names: HashMap<Key, (String, usize)>,
    /// Those names in small letters, and how many there are of each word.
    taken: HashSet<String>,
    numbers: HashMap<String, u64>,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash)]
struct Key {
    name: String,
    about: String,
    directive: String,
    power: Power,
    /// The text, where it is in the definition.
    text: Option<String>,
}

impl UnreadParts {
    /// An instruction as it is on a rung: `[$MSG]( 'control, data' )`. `is_taken` says which names, with the `$`, other blocks have.
    pub fn block(&mut self, part: Unread<'_>, is_taken: impl Fn(&str) -> bool) -> Block {
        let is_short = part.text.len() <= MOST_CHARACTERS && !part.text.contains(['\n', '\r']);
        self.on_rung(part, is_short, is_taken)
    }

    /// A body or a network as it is on a rung: `[$network_1_of_Motor]`. Its text is in its definition, however short it is.
    pub fn body(&mut self, part: Unread<'_>, is_taken: impl Fn(&str) -> bool) -> Block {
        self.on_rung(part, false, is_taken)
    }

    fn on_rung(&mut self, part: Unread<'_>, is_short: bool, is_taken: impl Fn(&str) -> bool) -> Block {
        let key = Key {
            name: part.name.to_ascii_lowercase(),
            about: part.about.to_owned(),
            directive: directive(part.writes, part.turn),
            power: part.power,
            text: (!is_short).then(|| part.text.to_owned()),
        };
        let name = match self.names.get(&key) {
            Some((name, _)) => name.clone(),
            None => self.define(part, key, is_taken),
        };
        let text = part.text.replace(char::is_control, " ");
        Block::unread(&name[1..], Some(text).filter(|text| is_short && !text.is_empty()))
    }

    fn define(&mut self, part: Unread<'_>, key: Key, is_taken: impl Fn(&str) -> bool) -> String {
        let word = format!("${}", block_name(part.name, "Part"));
        let name = loop {
            // Of many that are alike the next number is known.
            let count = self.numbers.entry(word.to_ascii_lowercase()).or_default();
            *count += 1;
            let name = match *count {
                1 => word.clone(),
                count => format!("{word}{count}"),
            };
            if !is_taken(&name) && self.taken.insert(name.to_ascii_lowercase()) {
                break name;
            }
        };
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
        let block = Item::Block {
            header,
            origin: None,
            items,
        };
        self.definitions.push(vec![Item::Blank, above, block]);
        self.names.insert(key, (name.clone(), self.definitions.len() - 1));
        name
    }

    /// Their definitions.
    pub fn items(&self) -> impl Iterator<Item = Item> {
        self.definitions.iter().flatten().cloned()
    }

    /// How many there are.
    pub const fn len(&self) -> usize {
        self.definitions.len()
    }

    /// Forgets all but so many: what they were in is unread as a whole.
    pub fn truncate(&mut self, count: usize) {
        self.definitions.truncate(count);
        self.names.retain(|_, (_, number)| *number < count);
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

/// A text of another system as comments, from which it comes back to the letter.
fn foreign_text(text: &str) -> Item {
    let text = text.replace("\r\n", "\n").replace('\r', "\n");
    let comments = text.split('\n').map(|line| {
        // What would be a comment for the tools is none.
        let is_directive = line.trim_start().starts_with("ladder:");
        let mut comment = String::from("# ");
        if is_directive {
            comment.push_str("\\s");
        }
        for c in line.chars() {
            match c {
                '\\' => comment.push_str("\\\\"),
                '#' => comment.push_str("\\h"),
                c if c.is_control() && c != '\t' => comment.push(' '),
                c => comment.push(c),
            }
        }
        comment + " #"
    });
    Item::Text(comments.collect::<Vec<_>>().join("\n"))
}

/// The text of another system in the definition of an unread part, which begins with `FUNCTION_BLOCK`. None: it has no such text.
pub fn foreign_text_of(definition: &str) -> Option<String> {
    let mut lines = definition.lines().map(str::trim_end);
    lines.find(|line| line.starts_with("# ladder: unread"))?;
    let comments = lines.map_while(|line| {
        let inside = line.strip_prefix('#')?.strip_suffix('#')?;
        let inside = inside.strip_prefix(' ').unwrap_or(inside);
        Some(in_foreign_text(inside.strip_suffix(' ').unwrap_or(inside)))
    });
    let lines: Vec<String> = comments.collect();
    (!lines.is_empty()).then(|| lines.join("\n"))
}

fn in_foreign_text(comment: &str) -> String {
    let mut text = String::with_capacity(comment.len());
    let mut rest = comment.chars();
    while let Some(c) = rest.next() {
        match c {
            '\\' => match rest.next() {
                Some('h') => text.push('#'),
                Some('s') => {}
                _ => text.push('\\'),
            },
            _ => text.push(c),
        }
    }
    text
}

/// The operands of an instruction that is on a rung: those of `'control, $'data$''`.
pub fn unread_operands(literal: &str) -> String {
    let inside = literal.trim();
    let inside = inside.strip_prefix('\'').unwrap_or(inside);
    let mut rest = inside.strip_suffix('\'').unwrap_or(inside).chars();
    let mut text = String::with_capacity(inside.len());
    while let Some(c) = rest.next() {
        match c {
            '$' => text.extend(rest.next()),
            _ => text.push(c),
        }
    }
    text
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
        assert_eq!(place.to_string(), "[$MSG2]( 'control,$'data$'' )");
        assert_eq!(parts.block(MSG, is_taken), place);
        assert_eq!(unread_operands("'control,$'data$'' "), MSG.text);
        let writes = ["a".to_owned(), "b".to_owned()];
        let other = Unread {
            writes: Some(&writes),
            power: Power::Ends,
            text: "x := 16#FF;\ny := 2;",
            turn: Turn::AnyTime,
            ..MSG
        };
        assert_eq!(parts.block(other, is_taken).to_string(), "[$MSG3]");
        let network = Unread {
            name: "network 3 of Motor (SCL)",
            text: "x := 2;",
            ..MSG
        };
        assert_eq!(
            parts.body(network, is_taken).to_string(),
            "[$network_3_of_Motor_SCL]"
        );
        let why = Unread {
            about: "MSG: for another reason.",
            writes: Some(&[]),
            text: "",
            ..MSG
        };
        assert_eq!(parts.block(why, is_taken).to_string(), "[$MSG4]");
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

            # MSG: it is not run here. #
            FUNCTION_BLOCK [$network_3_of_Motor_SCL]
            # ladder: unread #
            # x := 2; #
            END_FUNCTION_BLOCK

            # MSG: for another reason. #
            FUNCTION_BLOCK [$MSG4]
            # ladder: unread, writes #
            END_FUNCTION_BLOCK
        "#]]
        .assert_eq(&written(&parts));
    }

    #[test]
    fn a_foreign_text_comes_back() {
        let texts = [
            "a \\h # b \\",
            "",
            "\\",
            "#",
            "\\\\h",
            "IF a THEN\n    b := 1;\n\nEND_IF;\n",
            "  ladder: unread",
        ];
        for text in texts {
            let mut items = vec![Item::Section(Section::new(SectionKind::Var))];
            items.extend(unread_body(text, None));
            let header = "[$Motor]".to_owned();
            let block = ProgramSketch {
                items: vec![Item::Block {
                    header,
                    origin: None,
                    items,
                }],
            };
            let definition = block.write(&ladder_format::Options::default()).text;
            assert_eq!(
                foreign_text_of(&definition).as_deref(),
                Some(text),
                "{definition}"
            );
        }
        assert_eq!(foreign_text_of("FUNCTION_BLOCK [$A]\nEND_FUNCTION_BLOCK"), None);
    }
}
