//! The tags of a program or a block's body: made when something asks for one, declared when the text is written.

use super::dice::Dice;
use super::value::literal;
use ladder_analysis::values::types::Scalar;
use ladder_instructions::StateType;
use std::fmt::Write;

/// Where a tag is declared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Section {
    /// `VAR_INPUT`: never written.
    Input,
    /// `VAR_OUTPUT`
    Output,
    /// `VAR_IN_OUT` of a user-defined block.
    InOut,
    /// `VAR`
    Internal,
    /// `VAR RETAIN`
    Retain,
    /// `VAR CONSTANT`
    Constant,
    /// `VAR_GLOBAL`
    Global,
    /// Nowhere: its name says what it is.
    Undeclared,
}

impl Section {
    const DECLARED: [Section; 7] = [
        Section::Global,
        Section::Input,
        Section::Output,
        Section::InOut,
        Section::Internal,
        Section::Retain,
        Section::Constant,
    ];

    const fn header(self) -> &'static str {
        match self {
            Section::Input => "VAR_INPUT",
            Section::Output => "VAR_OUTPUT",
            Section::InOut => "VAR_IN_OUT",
            Section::Internal | Section::Undeclared => "VAR",
            Section::Retain => "VAR RETAIN",
            Section::Constant => "VAR CONSTANT",
            Section::Global => "VAR_GLOBAL",
        }
    }

    const fn is_writable(self) -> bool {
        !matches!(self, Section::Input | Section::Constant)
    }
}

/// The type of a tag.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Type {
    /// One value.
    Scalar(Scalar),
    /// The state of a timer, counter or bistable.
    State(StateType),
    /// An array from one index to another.
    Array(i64, i64, Scalar),
}

/// A tag.
#[derive(Debug, Clone)]
pub(super) struct Tag {
    /// As it is declared.
    pub(super) name: String,
    /// Its type.
    pub(super) ty: Type,
    /// Where it is declared.
    pub(super) section: Section,
    /// What is after the `:=`.
    pub(super) initial: Option<String>,
    /// What is after `AT`.
    pub(super) address: Option<String>,
}

/// The tags that can be seen in one place.
#[derive(Debug, Clone, Default)]
pub(super) struct Scope {
    /// The tags, in the order in which they were made.
    pub(super) tags: Vec<Tag>,
    /// The tags of the body of a user-defined block: everything is declared.
    pub(super) is_body: bool,
    /// Only BOOL tags, which begin low and are declared nowhere: everything is plain.
    pub(super) is_boolean: bool,
}

impl Scope {
    /// A tag of a type, one that is there or a new one.
    pub(super) fn scalar(&mut self, dice: &mut Dice, ty: Scalar, write: bool) -> String {
        let fits = |tag: &&Tag| tag.ty == Type::Scalar(ty) && (!write || tag.section.is_writable());
        let there: Vec<&Tag> = self.tags.iter().filter(fits).collect();
        if !there.is_empty() && !dice.one_in(2 + there.len()) {
            return dice.of(&there).name.clone();
        }
        let section = self.section(dice, write, ty == Scalar::Bool);
        let name = if section == Section::Undeclared {
            self.undeclared_name(dice, write)
        } else {
            self.name(ty.name())
        };
        let initial =
            (!self.is_boolean && dice.one_in(3) && !matches!(section, Section::InOut | Section::Undeclared))
                .then(|| literal(dice, ty));
        let address = self.address(dice, section, ty);
        self.add(Tag {
            name: name.clone(),
            ty: Type::Scalar(ty),
            section,
            initial,
            address,
        });
        name
    }

    /// An array of at least so many elements: its name and its bounds.
    pub(super) fn array(
        &mut self,
        dice: &mut Dice,
        element: Scalar,
        least: i64,
        write: bool,
    ) -> (String, i64, i64) {
        let fits = |tag: &&Tag| {
            matches!(tag.ty, Type::Array(first, last, found) if found == element && last - first + 1 >= least)
                && (!write || tag.section.is_writable())
        };
        if let Some(&Tag {
            ref name,
            ty: Type::Array(first, last, _),
            ..
        }) = self.tags.iter().find(fits)
            && !dice.one_in(4)
        {
            return (name.clone(), first, last);
        }
        let first = dice.of(&[0, 1, 1, -2, 5]);
        let last = first + least - 1 + dice.between(0, 4);
        let section = match self.section(dice, write, false) {
            Section::Global => Section::Internal,
            section => section,
        };
        let initial = dice.one_in(3).then(|| {
            let (one, other) = (literal(dice, element), literal(dice, element));
            match last - first {
                0 => format!("[{one}]"),
                1 => format!("[{one}, {other}]"),
                rest => format!("[{one}, {rest}({other})]"),
            }
        });
        let name = self.name("list");
        let ty = Type::Array(first, last, element);
        self.add(Tag {
            name: name.clone(),
            ty,
            section,
            initial,
            address: None,
        });
        (name, first, last)
    }

    /// A tag for the state of a block of its own.
    pub(super) fn state(&mut self, dice: &mut Dice, state: StateType) -> String {
        let section = if dice.one_in(4) {
            Section::Retain
        } else {
            Section::Internal
        };
        let name = self.name(state.name());
        let ty = Type::State(state);
        self.add(Tag {
            name: name.clone(),
            ty,
            section,
            initial: None,
            address: None,
        });
        name
    }

    /// Adds a tag.
    pub(super) fn add(&mut self, tag: Tag) {
        self.tags.push(tag);
    }

    fn section(&self, dice: &mut Dice, write: bool, is_bool: bool) -> Section {
        if self.is_boolean {
            return Section::Internal;
        }
        if self.is_body {
            return Section::Internal;
        }
        let choices: &[Section] = match (write, is_bool) {
            (true, true) => &[
                Section::Output,
                Section::Internal,
                Section::Retain,
                Section::Undeclared,
            ],
            (true, false) => &[Section::Output, Section::Internal, Section::Retain],
            (false, true) => &[
                Section::Input,
                Section::Input,
                Section::Internal,
                Section::Undeclared,
            ],
            (false, false) => &[
                Section::Input,
                Section::Input,
                Section::Internal,
                Section::Constant,
            ],
        };
        if !self.is_body && dice.one_in(12) {
            return Section::Global;
        }
        dice.of(choices)
    }

    /// No two tags have one name: each has its number.
    fn name(&self, stem: &str) -> String {
        let body = if self.is_body { "own_" } else { "" };
        format!("{body}{}_{}", stem.to_lowercase(), self.tags.len())
    }

    fn undeclared_name(&self, dice: &mut Dice, write: bool) -> String {
        let number = self.tags.len();
        let forms: [String; 2] = if write {
            [format!("Q{number}"), format!("%QX{number}.1")]
        } else {
            [format!("I{number}"), format!("%IX{number}.7")]
        };
        forms[dice.below(2)].clone()
    }

    /// No two addresses overlap: each has its number, a hundred from the next.
    fn address(&self, dice: &mut Dice, section: Section, ty: Scalar) -> Option<String> {
        let letter = match section {
            Section::Input => 'I',
            Section::Output => 'Q',
            _ => return None,
        };
        let size = match ty {
            Scalar::Bool => "X",
            Scalar::Int | Scalar::Uint | Scalar::Word => "W",
            Scalar::Dint | Scalar::Udint | Scalar::Dword => "D",
            _ => return None,
        };
        let number = 100 + self.tags.len();
        let bit = if size == "X" { ".0" } else { "" };
        dice.one_in(4).then(|| format!("%{letter}{size}{number}{bit}"))
    }

    /// The declarations, in sections that a dice draws.
    pub(super) fn declare(&self, dice: &mut Dice, line_end: &str, text: &mut String) {
        for section in Section::DECLARED {
            let tags: Vec<&Tag> = self.tags.iter().filter(|tag| tag.section == section).collect();
            if tags.is_empty() {
                continue;
            }
            let header = section.header();
            let lower = dice.one_in(4);
            text.push_str(&if lower {
                header.to_lowercase()
            } else {
                header.to_owned()
            });
            text.push_str(line_end);
            for tag in tags {
                text.push_str(dice.of(&["", "    ", "\t"]));
                text.push_str(&tag.declaration(dice));
                text.push_str(if dice.one_in(6) { "  # declared #" } else { "" });
                text.push_str(line_end);
            }
            text.push_str(if lower { "end_var" } else { "END_VAR" });
            text.push_str(line_end);
        }
    }
}

impl Tag {
    /// `name AT %IW3 : INT := 5;`
    fn declaration(&self, dice: &mut Dice) -> String {
        let mut text = self.name.clone();
        if let Some(address) = &self.address {
            // Writing to a String does not fail.
            let _ = write!(text, " AT {address}");
        }
        text.push_str(dice.of(&[" : ", ":", "  :"]));
        match self.ty {
            Type::Scalar(ty) => text.push_str(&ty.to_string()),
            Type::State(state) => text.push_str(state.name()),
            Type::Array(first, last, element) => {
                let _ = write!(text, "ARRAY[{first}..{last}] OF {element}");
            }
        }
        if let Some(initial) = &self.initial {
            let _ = write!(text, " := {initial}");
        }
        text.push(';');
        text
    }
}
