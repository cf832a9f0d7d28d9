//! What the parser found, as findings of the rules.

use super::{
    bad_declaration, bad_literal, bad_operand, unclosed_block, unclosed_comment, unexpected_character,
};
use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::excerpt;
use ladder_syntax::{LineKind, SyntaxError, SyntaxErrorKind};

pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let parse = &*context.parse;
    let errors = parse.errors();
    for (index, error) in errors.iter().enumerate() {
        let range = error.range;
        let text = || excerpt::text(parse, range);
        out.push(match error.kind {
            // The text or comment that took the rest of the line took the closing bracket as well.
            SyntaxErrorKind::UnclosedBlock { .. } if took_the_rest(context, &errors, index) => continue,
            SyntaxErrorKind::UnclosedBlock { closing } => unclosed_block::missing(
                closing,
                &text(),
                range,
                excerpt::blanks_behind(parse, range.end()),
            ),
            SyntaxErrorKind::WrongBracket { closing } => unclosed_block::wrong(closing, &text(), range),
            SyntaxErrorKind::UnclosedComment => unclosed_comment::unclosed(parse, range),
            SyntaxErrorKind::UnexpectedCharacter {
                place,
                behind_comment,
            } => unexpected_character::unexpected(place, behind_comment, &text(), range),
            SyntaxErrorKind::UnclosedString => bad_literal::unclosed_string(range),
            SyntaxErrorKind::BadBlockName => {
                let line = parse.line_at(range.start());
                let header = line.is_some_and(|line| parse.lines()[line].kind == LineKind::BlockHeader);
                bad_declaration::block_name(header, &text(), range)
            }
            SyntaxErrorKind::MissingOperand { place } => bad_operand::missing(place, range),
            SyntaxErrorKind::MissingComma => bad_operand::missing_comma(range),
            SyntaxErrorKind::TooComplex => bad_operand::too_complex(range),
            SyntaxErrorKind::BadDeclaration(problem) => bad_declaration::unreadable(problem, &text(), range),
        });
    }
}

/// Whether an unclosed text or comment stands on the same line behind the start of an unclosed block.
fn took_the_rest(context: &Context, errors: &[SyntaxError], index: usize) -> bool {
    let parse = &*context.parse;
    let line = parse.line_at(errors[index].range.start());
    errors[index + 1..]
        .iter()
        .take_while(|later| parse.line_at(later.range.start()) == line)
        .any(|later| {
            matches!(
                later.kind,
                SyntaxErrorKind::UnclosedString | SyntaxErrorKind::UnclosedComment
            )
        })
}
