//! Properties: what must hold in every run of a program, and the assumptions about what goes into it.
//!
//! ```text
//! assume not (is_open and is_closed)
//!
//! property "the lamp follows the door"
//! within 500ms of rises(up): warning or not up
//! ```
//!
//! A property is a form with expressions as `[CALC]` has them. What is after an expression begins where the parser of
//! expressions ends.

use super::error::ScenarioError;
use super::parse::is_levels;
use super::words::{Word, range};
use crate::expression::expression_end;
use crate::value_text;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_syntax::TextRange;

/// What must hold in every run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Property {
    /// What it is called: its own text if it has no name.
    pub name: String,
    /// Where its name is; its form if it has none.
    pub range: TextRange,
    /// Where its form is.
    pub place: TextRange,
    /// What must hold.
    pub form: Form<Written>,
}

/// An expression as it is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Written {
    /// Without what is around it.
    pub text: String,
    /// Where it is.
    pub range: TextRange,
}

/// What a property demands of its expressions.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Form<E> {
    /// High after every scan.
    Always(E),
    /// Low after every scan.
    Never(E),
    /// `when a: b until c`
    When {
        /// While this is high, or from the scan on in which it is.
        condition: E,
        /// This is high.
        then: E,
        /// Up to the scan before the one in which this is high.
        until: Option<E>,
    },
    /// High in the scan after one in which the condition is.
    After {
        /// What was high in the scan before.
        condition: E,
        /// What is high then.
        then: E,
    },
    /// An answer that comes soon enough.
    Within {
        /// How soon at the latest.
        span: Span,
        /// What asks.
        condition: E,
        /// What answers.
        then: E,
    },
    /// Some run has it.
    Possible {
        /// What some scan has.
        what: E,
        /// In which scan at the latest.
        within: Option<Span>,
    },
    /// No block records a fault.
    NoFaults,
}

/// How long something may take.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Span {
    /// So many scans.
    Scans(u64),
    /// A time, in nanoseconds.
    Time(i64),
}

impl Span {
    /// In whole scans of this interval: what comes later than the time is too late.
    pub fn scans(self, interval: i64) -> u64 {
        match self {
            Span::Scans(scans) => scans,
            Span::Time(time) => (time / interval.max(1)).unsigned_abs(),
        }
    }
}

/// The words that begin a form, and `assume`.
pub const FORMS: [&str; 8] = [
    "assume", "always", "never", "when", "after", "within", "possible", "no",
];

/// The word that begins the name of a property.
pub const PROPERTY: &str = "property";

/// Whether a line is of a property, and not a row of a tag that is called so; before the first scenario are no rows.
pub(super) fn is_of_property(first: Word, rest: &[Word], has_rows: bool) -> bool {
    let Some(next) = rest.first() else {
        return first.text == PROPERTY;
    };
    let is_value = |word: &Word| is_levels(word.text) || word.text.starts_with(|c: char| c.is_ascii_digit());
    match first.text {
        PROPERTY => next.text.starts_with('"'),
        "no" => next.text == "faults",
        word if !has_rows => FORMS.contains(&word),
        word => FORMS.contains(&word) && next.text != "=>" && !rest.iter().all(is_value),
    }
}

/// The text of a form on its line, from its first word on.
#[derive(Clone, Copy)]
pub(super) struct Reader<'t> {
    text: &'t str,
    /// Where that begins in the file.
    start: usize,
}

type Result<T> = std::result::Result<T, ScenarioError>;

impl<'t> Reader<'t> {
    pub(super) fn new(text: &'t str, start: usize) -> Reader<'t> {
        let trimmed = text.trim_start();
        Reader {
            text: trimmed.trim_end(),
            start: start + text.len() - trimmed.len(),
        }
    }

    pub(super) fn whole(self) -> TextRange {
        range(self.start, self.start + self.text.len())
    }

    pub(super) fn text(self) -> &'t str {
        self.text
    }

    fn error<T>(self, message: impl Into<String>, help: impl Into<String>) -> Result<T> {
        let place = if self.text.is_empty() {
            range(self.start, self.start)
        } else {
            self.whole()
        };
        Err(ScenarioError::new(place, message, help))
    }

    /// The text after this many bytes.
    fn after(self, bytes: usize) -> Reader<'t> {
        Reader::new(&self.text[bytes..], self.start + bytes)
    }

    /// Takes a word.
    fn word(&mut self) -> &'t str {
        let end = self.text.find(char::is_whitespace).unwrap_or(self.text.len());
        let word = &self.text[..end];
        *self = self.after(end);
        word
    }

    /// Takes this word or sign, if it is next.
    fn take(&mut self, what: &str) -> bool {
        let Some(rest) = self.text.strip_prefix(what) else {
            return false;
        };
        let is_word = what.ends_with(char::is_alphabetic);
        if is_word && rest.starts_with(|c: char| c.is_alphanumeric() || c == '_') {
            return false;
        }
        *self = self.after(what.len());
        true
    }

    /// Takes an expression.
    pub(super) fn expression(&mut self) -> Result<Written> {
        if let Some((at, sign, own)) = foreign_sign(self.text) {
            return self.after(at).error(
                format!("`{sign}` is a sign of other languages"),
                format!("write it here as: {own}"),
            );
        }
        let Some(end) = expression_end(self.text) else {
            return self.error(
                "an expression is missing here",
                "write one as in [CALC]: start and not stop, level > 80, rises(run)",
            );
        };
        let text = self.text[..end].trim_end();
        let written = Written {
            text: text.to_owned(),
            range: range(self.start, self.start + text.len()),
        };
        *self = self.after(end);
        Ok(written)
    }

    fn colon(&mut self, example: &str) -> Result<()> {
        if self.take(":") {
            return Ok(());
        }
        self.error("a colon is missing here", format!("write it as in: {example}"))
    }

    pub(super) fn end(self) -> Result<()> {
        if self.text.is_empty() {
            return Ok(());
        }
        self.error(
            format!("`{}` does not belong here", self.text),
            "the property ends before it",
        )
    }

    /// Takes the time or number of scans.
    fn span(&mut self) -> Result<Span> {
        let before = *self;
        let word = self.word();
        if let Ok(scans) = word.parse::<u64>()
            && (self.take("scans") || self.take("scan"))
        {
            return Ok(Span::Scans(scans.min(1 << 32)));
        }
        match value_text::parse(word, Scalar::Time) {
            Ok(Value::Int(time)) if time >= 0 && !word.is_empty() => Ok(Span::Time(time)),
            _ => before.error(
                "how long it may take is missing here",
                "write a time or a number of scans, as in: within 500ms of start: run",
            ),
        }
    }

    /// Reads a form.
    pub(super) fn form(mut self) -> Result<Form<Written>> {
        let form = match self.word() {
            "always" => Form::Always(self.expression()?),
            "never" => Form::Never(self.expression()?),
            "when" => {
                let condition = self.expression()?;
                self.colon("when jam: not running")?;
                let then = self.expression()?;
                let until = if self.take("until") {
                    Some(self.expression()?)
                } else {
                    None
                };
                Form::When {
                    condition,
                    then,
                    until,
                }
            }
            "after" => {
                let condition = self.expression()?;
                self.colon("after stop: not run")?;
                Form::After {
                    condition,
                    then: self.expression()?,
                }
            }
            "within" => {
                const EXAMPLE: &str = "within 500ms of rises(up): warning";
                let span = self.span()?;
                if !self.take("of") {
                    return self.error("`of` is missing here", format!("write it as in: {EXAMPLE}"));
                }
                let condition = self.expression()?;
                self.colon(EXAMPLE)?;
                Form::Within {
                    span,
                    condition,
                    then: self.expression()?,
                }
            }
            "possible" => {
                let what = self.expression()?;
                let within = if self.take("within") {
                    Some(self.span()?)
                } else {
                    None
                };
                Form::Possible { what, within }
            }
            "no" if self.take("faults") => Form::NoFaults,
            other => {
                return self.error(
                    format!("`{other}` is not a form of property"),
                    "the forms are: always, never, when a: b, when a: b until c, after a: b, within 1s of a: b, \
                     possible, no faults",
                );
            }
        };
        self.end()?;
        Ok(form)
    }
}

/// Signs and words of other languages, and what they are here.
const FOREIGN: [(&str, &str); 8] = [
    ("&&", "a and b"),
    ("||", "a or b"),
    ("==", "a = b"),
    ("!=", "a <> b"),
    ("->", "when a: b"),
    ("=>", "when a: b"),
    ("!", "not a"),
    ("implies ", "when a: b"),
];

/// The first of them outside of texts: where it is, and what to write.
fn foreign_sign(text: &str) -> Option<(usize, &'static str, &'static str)> {
    let mut quoted = false;
    text.char_indices().find_map(|(at, c)| {
        quoted ^= c == '\'';
        let is_word = text[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_');
        let is_it = |(sign, _): &&(&str, &str)| {
            text[at..].starts_with(sign) && !(is_word && sign.starts_with(char::is_alphabetic))
        };
        let (sign, own) = FOREIGN.iter().find(is_it).filter(|_| !quoted)?;
        Some((at, sign.trim_end(), *own))
    })
}

impl<E> Form<E> {
    /// The same of other expressions.
    ///
    /// # Errors
    /// The first that one of them is.
    pub fn try_map<'e, T, X>(
        &'e self,
        mut each: impl FnMut(&'e E) -> std::result::Result<T, X>,
    ) -> std::result::Result<Form<T>, X> {
        Ok(match self {
            Form::Always(e) => Form::Always(each(e)?),
            Form::Never(e) => Form::Never(each(e)?),
            Form::When {
                condition,
                then,
                until,
            } => Form::When {
                condition: each(condition)?,
                then: each(then)?,
                until: until.as_ref().map(each).transpose()?,
            },
            Form::After { condition, then } => Form::After {
                condition: each(condition)?,
                then: each(then)?,
            },
            Form::Within {
                span,
                condition,
                then,
            } => Form::Within {
                span: *span,
                condition: each(condition)?,
                then: each(then)?,
            },
            Form::Possible { what, within } => Form::Possible {
                what: each(what)?,
                within: *within,
            },
            Form::NoFaults => Form::NoFaults,
        })
    }
}
