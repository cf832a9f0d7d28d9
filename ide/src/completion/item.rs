//! What completion proposes.

use ladder_instructions::{Op, Profile, TABLE};
use ladder_syntax::TextRange;

/// What is proposed at a place.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Completions {
    /// The proposals, best first.
    pub items: Vec<Completion>,
    /// More would fit: when more of the word is written, others come into view.
    pub cut: bool,
}

/// One proposal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Completion {
    /// What the list shows.
    pub label: String,
    /// A few words after it.
    pub detail: String,
    /// What kind of thing it is.
    pub kind: CompletionKind,
    /// What is replaced: one stretch of the cursor's line that holds the cursor.
    pub range: TextRange,
    /// What is compared with the text from the start of the range to the cursor.
    pub filter: String,
    /// What is inserted, with tab stops.
    pub text: Snippet,
    /// What it is documented by.
    pub topic: Topic,
}

/// Kinds of proposals, as editors show them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum CompletionKind {
    Instruction,
    UserBlock,
    Tag,
    Constant,
    Member,
    Label,
    Function,
    Keyword,
    Type,
    Operand,
    Operator,
    Value,
    Drawing,
}

/// Where the documentation of a proposal is found, when the user asks for it.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum Topic {
    /// There is none.
    #[default]
    Nothing,
    /// An instruction, as it is in a profile.
    Instruction(Op, Profile),
    /// A user-defined block, by its name.
    UserBlock(String),
    /// A tag: its scope and its name.
    Tag(usize, String),
    /// A keyword.
    Keyword(String),
    /// A few words that are at hand.
    Words(&'static str),
}

impl Topic {
    /// The instruction with this number in the table, in a profile.
    pub fn instruction(number: usize, profile: Profile) -> Option<Topic> {
        TABLE.get(number).map(|row| Topic::Instruction(row.op, profile))
    }
}

/// A piece of a text that is inserted.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Piece {
    Text(String),
    Stop(String),
    /// The place of an earlier stop with the same text, once more.
    Again(String),
    End,
}

/// A text with tab stops.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Snippet(Vec<Piece>);

impl Snippet {
    /// A text without stops.
    pub(crate) fn plain_text(text: impl Into<String>) -> Snippet {
        Snippet(vec![Piece::Text(text.into())])
    }

    pub(crate) fn text(mut self, text: &str) -> Snippet {
        if !text.is_empty() {
            self.0.push(Piece::Text(text.to_owned()));
        }
        self
    }

    /// A stop with what is there until the user writes something else.
    pub(crate) fn stop(mut self, text: &str) -> Snippet {
        self.0.push(Piece::Stop(text.to_owned()));
        self
    }

    /// As `stop`, unless there is one with this text: then what is written there is written here too.
    pub(crate) fn stop_again(mut self, text: &str) -> Snippet {
        let known = self.0.contains(&Piece::Stop(text.to_owned()));
        let piece = if known { Piece::Again } else { Piece::Stop };
        self.0.push(piece(text.to_owned()));
        self
    }

    /// Where the cursor is in the end; without it that is after the text.
    pub(crate) fn end(mut self) -> Snippet {
        self.0.push(Piece::End);
        self
    }

    /// After it another one, in which the cursor ends if it says where.
    pub(crate) fn append(mut self, other: Snippet) -> Snippet {
        if other.0.contains(&Piece::End) {
            self.0.retain(|piece| *piece != Piece::End);
        }
        self.0.extend(other.0);
        self
    }

    /// Whether there are stops in it.
    pub(crate) fn has_stops(&self) -> bool {
        self.0.iter().any(|piece| !matches!(piece, Piece::Text(_)))
    }

    /// Whether it is one word without stops: what every editor inserts alike.
    pub fn is_word(&self) -> bool {
        !self.has_stops() && !self.plain().contains(char::is_whitespace)
    }

    /// As an editor without snippets inserts it.
    pub fn plain(&self) -> String {
        let pieces = self.0.iter().map(|piece| match piece {
            Piece::Text(text) | Piece::Stop(text) | Piece::Again(text) => text.as_str(),
            Piece::End => "",
        });
        pieces.collect()
    }

    /// In the notation of the language server protocol.
    pub fn snippet(&self) -> String {
        let mut out = String::new();
        let mut stops: Vec<&String> = Vec::new();
        for piece in &self.0 {
            match piece {
                Piece::Text(text) => escape(text, &mut out),
                Piece::Stop(text) => {
                    stops.push(text);
                    out.push_str(&format!("${{{}:", stops.len()));
                    escape(text, &mut out);
                    out.push('}');
                }
                Piece::Again(text) => {
                    let number = stops.iter().position(|stop| *stop == text).unwrap_or_default() + 1;
                    out.push_str(&format!("${{{number}:"));
                    escape(text, &mut out);
                    out.push('}');
                }
                Piece::End => out.push_str("$0"),
            }
        }
        out
    }
}

fn escape(text: &str, out: &mut String) {
    for c in text.chars() {
        if matches!(c, '$' | '}' | '\\') {
            out.push('\\');
        }
        out.push(c);
    }
}
