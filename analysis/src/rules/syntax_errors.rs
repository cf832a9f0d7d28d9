//! What the parser found, as findings of the rules.

use super::{
    bad_declaration, bad_literal, bad_operand, unclosed_block, unclosed_comment, unexpected_character,
};
use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::excerpt::{Excerpts, blanks_before_drawing};
use ladder_syntax::{LineKind, Parse, SyntaxError, SyntaxErrorKind, TextRange};

pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let parse = &*context.parse;
    let errors = parse.errors();
    if errors.is_empty() {
        return;
    }
    let taken = taken_rests(parse, &errors);
    let mut excerpts = Excerpts::new(parse);
    for (error, taken) in errors.iter().zip(taken) {
        let range = error.range;
        let (text, rest) = excerpts.text(range);
        out.push(match error.kind {
            // The text or comment that took the rest of the line took the closing bracket as well.
            SyntaxErrorKind::UnclosedBlock { .. } if taken => continue,
            SyntaxErrorKind::UnclosedBlock { closing } => {
                let blanks = TextRange::at(range.end(), blanks_before_drawing(rest));
                unclosed_block::missing(closing, text, range, blanks)
            }
            SyntaxErrorKind::WrongBracket { closing } => unclosed_block::wrong(closing, text, range),
            SyntaxErrorKind::UnclosedComment => unclosed_comment::unclosed(parse, range),
            SyntaxErrorKind::UnexpectedCharacter {
                place,
                behind_comment,
            } => unexpected_character::unexpected(place, behind_comment, text, range),
            SyntaxErrorKind::UnclosedString => bad_literal::unclosed_string(range),
            SyntaxErrorKind::BadBlockName => {
                let line = parse.line_at(range.start());
                let header = line.is_some_and(|line| parse.lines()[line].kind == LineKind::BlockHeader);
                bad_declaration::block_name(header, text, range)
            }
            SyntaxErrorKind::MissingOperand { place } => bad_operand::missing(place, range),
            SyntaxErrorKind::MissingComma => bad_operand::missing_comma(range),
            SyntaxErrorKind::TooComplex => bad_operand::too_complex(range),
            SyntaxErrorKind::BadDeclaration(problem) => bad_declaration::unreadable(problem, text, range),
        });
    }
}

/// For each mistake whether an unclosed text or comment stands behind it on its line.
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
