//! The legend: the kinds and modifiers that are sent, by their names in the protocol.

/// What a word is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
#[repr(u8)]
pub enum TokenKind {
    Comment,
    Keyword,
    Type,
    Class,
    Function,
    Label,
    Variable,
    Parameter,
    Property,
    EnumMember,
    Number,
    String,
    Operator,
}

impl TokenKind {
    /// All of them, in the order of the legend, with their names in the protocol and what they stand for here.
    pub const LEGEND: [(TokenKind, &'static str, &'static str); 13] = [
        (TokenKind::Comment, "comment", "comments"),
        (
            TokenKind::Keyword,
            "keyword",
            "words of sections, declarations and block definitions; program flow: `<JMP>`",
        ),
        (TokenKind::Type, "type", "types in declarations"),
        (TokenKind::Class, "class", "user-defined blocks"),
        (
            TokenKind::Function,
            "function",
            "other instructions, the `/` of `[/]` and `(/)` among them; functions of `<FUN>` and of expressions",
        ),
        (TokenKind::Label, "label", "labels"),
        (TokenKind::Variable, "variable", "tags and direct addresses"),
        (
            TokenKind::Parameter,
            "parameter",
            "operands given by name; in a block's body its parameters",
        ),
        (TokenKind::Property, "property", "members and bits after a `.`"),
        (
            TokenKind::EnumMember,
            "enumMember",
            "TRUE and FALSE; the comparison in `[SEARCH]`",
        ),
        (TokenKind::Number, "number", "numbers, durations and dates"),
        (TokenKind::String, "string", "texts"),
        (TokenKind::Operator, "operator", "operators, `:=` and `=>`"),
    ];
}

/// What else is known of a word: a bit for each modifier.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub struct Modifiers(pub u16);

impl Modifiers {
    /// The name is introduced here.
    pub const DECLARATION: Modifiers = Modifiers(1);
    /// It cannot be written.
    pub(super) const READONLY: Modifiers = Modifiers(1 << 1);
    /// The whole workspace sees it, or it has an address.
    pub(super) const STATIC: Modifiers = Modifiers(1 << 2);
    /// It is written here.
    pub(super) const MODIFICATION: Modifiers = Modifiers(1 << 3);
    /// It belongs to the language.
    pub(super) const DEFAULT_LIBRARY: Modifiers = Modifiers(1 << 4);
    /// An input: the outside writes it.
    pub const INPUT: Modifiers = Modifiers(1 << 5);
    /// An output: the outside reads it.
    pub const OUTPUT: Modifiers = Modifiers(1 << 6);
    /// It makes a block a contact.
    pub const CONTACT: Modifiers = Modifiers(1 << 7);
    /// It makes a block a coil.
    pub const COIL: Modifiers = Modifiers(1 << 8);

    /// All of them, in the order of their bits, with their names in the protocol and what they stand for here.
    pub const LEGEND: [(Modifiers, &'static str, &'static str); 9] = [
        (
            Modifiers::DECLARATION,
            "declaration",
            "where a tag, label, function or block is introduced",
        ),
        (Modifiers::READONLY, "readonly", "constants and system tags"),
        (
            Modifiers::STATIC,
            "static",
            "direct addresses and tags of VAR_GLOBAL and VAR_EXTERNAL",
        ),
        (
            Modifiers::MODIFICATION,
            "modification",
            "a tag where a block writes it",
        ),
        (
            Modifiers::DEFAULT_LIBRARY,
            "defaultLibrary",
            "what belongs to the language itself",
        ),
        (Modifiers::INPUT, "input", "an input; not of the standard"),
        (Modifiers::OUTPUT, "output", "an output; not of the standard"),
        (
            Modifiers::CONTACT,
            "contact",
            "what is in a contact: the `P` of `[P]`; not of the standard",
        ),
        (
            Modifiers::COIL,
            "coil",
            "what is in a coil: the `S` of `(S)`; not of the standard",
        ),
    ];

    pub(super) const fn and(self, other: Modifiers) -> Modifiers {
        Modifiers(self.0 | other.0)
    }
}
