//! What the parser found, as findings of the rules.
//!
//! One slip often makes the parser stumble more than once: a bracket that is missing leaves its partner over, a
//! section that is not recognised leaves its END_VAR alone. What follows so from an earlier error is not reported.

use super::{
    bad_literal, frame_keyword, is_enough, unclosed_block, unclosed_comment, unclosed_section,
    unexpected_character,
};
use crate::findings::diagnostic::Diagnostic;
use crate::findings::excerpt::{self, Excerpts, blanks_before_drawing};
use crate::findings::foreign_comment::ForeignComments;
use crate::names::context::Context;
use crate::networks::unread_line::{identifiers, looks_like_declaration};
use crate::rules::{bad_declaration, bad_operand};
use ladder_syntax::{
    DeclarationProblem, LineKind, Many, Parse, Surroundings, SyntaxError, SyntaxErrorKind, TextRange,
    TextSize,
};

pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let parse = &*context.parse;
    let is_faulty = parse.lines().parts().iter().any(|part| part.is_faulty());
    if !is_faulty && parse.frame().is_whole() && parse.unclosed_comment().is_none() {
        return;
    }
    let errors = parse.errors();
    let taken = taken_rests(parse, &errors);
    let foreign = context.foreign_comments();
    let lost = LostFrames::new(parse, foreign);
    let mut excerpts = Excerpts::new(parse);
    let mut line = Line::default();
    let mut number = None;
    let reported = out.len();
    for (index, (error, taken)) in errors.iter().zip(taken).enumerate() {
        if is_enough(reported, out) {
            break;
        }
        let range = error.range;
        let on_line = parse.line_at(range.start());
        if std::mem::replace(&mut number, on_line) != on_line {
            line = Line::default();
        }
        let opens_text = errors
            .get(index + 1)
            .is_some_and(|next| next.kind == SyntaxErrorKind::UnclosedString && next.range == range);
        let since = range.start().min(line.last_operand.unwrap_or(range.start()));
        let between = excerpts
            .text(TextRange::new(since, range.start()))
            .0
            .contains(')');
        let (text, _) = excerpts.text(range);
        if taken && matches!(error.kind, SyntaxErrorKind::UnclosedBlock { .. }) {
            // The text or comment that took the rest of the line took the closing bracket as well.
            continue;
        }
        if opens_text
            || foreign.explain(parse, range.start())
            || line.explains(error, text, between)
            || lost.explain(parse, error)
        {
            continue;
        }
        line.met(error);
        out.push(match misspelt_frame(parse, error, &mut excerpts) {
            Some(finding) => finding,
            None => {
                let (text, rest) = excerpts.text(range);
                finding(parse, error, text, rest)
            }
        });
    }
}

/// `END_VR` in a section: the parser takes it for a name and waits for its type.
fn misspelt_frame(parse: &Parse, error: &SyntaxError, excerpts: &mut Excerpts<'_>) -> Option<Diagnostic> {
    if error.kind != SyntaxErrorKind::BadDeclaration(DeclarationProblem::TypeExpected) {
        return None;
    }
    let start = parse.line_start(parse.line_at(error.range.start())?);
    let (before, _) = excerpts.text(TextRange::new(start, error.range.start()));
    let word = before.trim();
    let keyword = frame_keyword::misspelt(word)?;
    let blanks = before.len() - before.trim_start().len();
    let range = TextRange::at(start + TextSize::new(blanks as u32), TextSize::of(word));
    Some(bad_declaration::misspelt(word, keyword, range))
}

fn finding(parse: &Parse, error: &SyntaxError, text: &str, rest: &str) -> Diagnostic {
    let range = error.range;
    match error.kind {
        SyntaxErrorKind::UnclosedBlock { closing } => {
            let blanks = TextRange::at(range.end(), blanks_before_drawing(rest));
            let of_list = text_before(parse, range).trim_end().ends_with([']', ')', '>']);
            match unclosed_block::drawn(text, rest, range).filter(|_| !of_list) {
                Some(found) => found,
                None => unclosed_block::missing(closing, text, range, blanks, of_list),
            }
        }
        SyntaxErrorKind::WrongBracket { closing } => unclosed_block::wrong(closing, text, range),
        SyntaxErrorKind::UnclosedComment => unclosed_comment::unclosed(parse, range),
        SyntaxErrorKind::UnexpectedCharacter { place, after_comment } => {
            let found = unexpected_character::unexpected(place, after_comment, text, range);
            if place != Surroundings::Head {
                return found;
            }
            let before = text_before(parse, range);
            let found = unexpected_character::sign_in_head::explain(found, &before, text, rest);
            unexpected_character::named_in_head::explain(found, &before, text, rest)
        }
        SyntaxErrorKind::UnclosedString => bad_literal::unclosed_string(range),
        SyntaxErrorKind::BadBlockName => {
            let line = parse.line_at(range.start());
            let header = line.is_some_and(|line| parse.lines()[line].kind == LineKind::BlockHeader);
            bad_declaration::block_name(header, text, range)
        }
        SyntaxErrorKind::MissingOperand { place } => bad_operand::missing(place, range),
        SyntaxErrorKind::MissingComma => bad_operand::missing_comma(range, &text_before(parse, range), text),
        SyntaxErrorKind::TooComplex => bad_operand::too_complex(range),
        SyntaxErrorKind::TooMany(Many::Operands) => bad_operand::too_many(range),
        SyntaxErrorKind::TooMany(Many::Parts) => unexpected_character::too_many(range),
        SyntaxErrorKind::BadDeclaration(problem) => {
            // A text may have swallowed the `;`.
            let has_text = text_before(parse, range).contains('\'');
            let found = bad_declaration::unreadable(problem, text, range, has_text);
            unclosed_section::with_end(parse, problem, found)
        }
    }
}

/// What is before a place on its logical line.
fn text_before(parse: &Parse, range: TextRange) -> String {
    let line = parse.line_at(range.start()).unwrap_or_default();
    excerpt::text(parse, TextRange::new(parse.line_start(line), range.start()))
}

/// For each error whether an unclosed text or comment is after it on its line.
fn taken_rests(parse: &Parse, errors: &[SyntaxError]) -> Vec<bool> {
    let mut taken = vec![false; errors.len()];
    let mut line_with_open_end = None;
    for (index, error) in errors.iter().enumerate().rev() {
        let line = parse.line_at(error.range.start());
        taken[index] = line_with_open_end == Some(line);
        if matches!(
            error.kind,
            SyntaxErrorKind::UnclosedString | SyntaxErrorKind::UnclosedComment
        ) {
            line_with_open_end = Some(line);
        }
    }
    taken
}

/// What was reported on a line so far.
#[derive(Default)]
struct Line {
    /// A bracket is missing or something is on the rung that does not belong there: where the drawing goes on
    /// after it is a guess.
    misread: bool,
    /// Up to where a block that is not closed reaches.
    unclosed_to: TextSize,
    /// The end of the last error in an operand list.
    last_operand: Option<TextSize>,
}

impl Line {
    /// Whether an error follows from one before it on the line. `list_ended`: a parenthesis closes between it
    /// and the last one in an operand list.
    fn explains(&self, error: &SyntaxError, text: &str, list_ended: bool) -> bool {
        let same_list = self.last_operand.is_some() && !list_ended;
        match error.kind {
            SyntaxErrorKind::UnexpectedCharacter { place, .. } => {
                // A drawing made of typographic characters is fixed piece by piece.
                let typographic = unexpected_character::is_typographic(text);
                (self.misread && !typographic)
                    || error.range.start() < self.unclosed_to
                    || (place == Surroundings::Operands && same_list)
            }
            SyntaxErrorKind::MissingOperand { .. } | SyntaxErrorKind::MissingComma => {
                same_list || error.range.start() < self.unclosed_to
            }
            SyntaxErrorKind::UnclosedBlock { .. } => self.misread,
            _ => false,
        }
    }

    fn met(&mut self, error: &SyntaxError) {
        let end = error.range.end();
        match error.kind {
            SyntaxErrorKind::UnclosedBlock { .. } => {
                self.misread = true;
                self.unclosed_to = self.unclosed_to.max(end);
                self.last_operand = Some(end);
            }
            SyntaxErrorKind::UnexpectedCharacter { place, .. } => match place {
                Surroundings::Operands => self.last_operand = Some(end),
                _ => self.misread = true,
            },
            SyntaxErrorKind::MissingOperand { .. } | SyntaxErrorKind::MissingComma => {
                self.last_operand = Some(end);
            }
            _ => {}
        }
    }
}

/// First or last lines of sections and block definitions that could not be read as such.
struct LostFrames {
    /// The first such line of a section, and of a block definition.
    section: Option<usize>,
    block: Option<usize>,
}

impl LostFrames {
    fn new(parse: &Parse, foreign: &ForeignComments) -> LostFrames {
        let mut lost = LostFrames {
            section: None,
            block: None,
        };
        let anywhere = !foreign.0.is_empty();
        for (index, line) in parse.lines().of_parts_that(|part| anywhere || part.is_faulty()) {
            let frame = matches!(
                line.kind,
                LineKind::SectionHeader
                    | LineKind::SectionEnd
                    | LineKind::StructEnd
                    | LineKind::BlockHeader
                    | LineKind::BlockEnd
            );
            if let Some(comment) = foreign.on_line(index) {
                if comment.ends_section {
                    lost.section.get_or_insert(index);
                }
                continue;
            }
            if frame || (line.errors.is_empty() && line.kind != LineKind::Stray) {
                continue;
            }
            let text = line.text().to_owned();
            for keyword in identifiers(&text).filter_map(frame_keyword::nearest) {
                if keyword.contains("BLOCK") {
                    lost.block.get_or_insert(index);
                } else {
                    lost.section.get_or_insert(index);
                }
            }
        }
        lost
    }

    /// Whether an error follows from such a line.
    fn explain(&self, parse: &Parse, error: &SyntaxError) -> bool {
        use DeclarationProblem::*;
        let Some(line) = parse.line_at(error.range.start()) else {
            return false;
        };
        let elsewhere = |lost: Option<usize>| lost.is_some_and(|lost| lost != line);
        match error.kind {
            SyntaxErrorKind::BadDeclaration(
                SectionNotClosed | TypesNotClosed | StructNotClosed | EndWithoutSection | OtherEnd,
            ) => elsewhere(self.section),
            SyntaxErrorKind::BadDeclaration(BlockNotClosed | EndWithoutBlock | NestedBlock) => {
                elsewhere(self.block)
            }
            // A declaration after the first line of its section.
            SyntaxErrorKind::UnexpectedCharacter { .. } => {
                self.section.is_some_and(|section| section < line)
                    && looks_like_declaration(&parse.lines()[line])
            }
            _ => false,
        }
    }
}
