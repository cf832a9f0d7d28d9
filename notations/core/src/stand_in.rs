//! Elements without a counterpart, which are in ladder text as comments, on their way back.

use super::WriteError;
use super::no_program::no_program;
use ladder_analysis::Analysis;
use ladder_syntax::{NodeOrToken, SyntaxKind};
use std::borrow::Cow;

/// What holds the place of a comment; a parenthesis closes it.
const STAND_IN: &str = "[ ](SYS.ON";
/// What holds the place of a short one; a bracket closes it.
const SHORT: &str = "[NOT";

/// The analysis of a text in which each comment on a rung that is an element has a block in its place, so that it has
/// a place in the circuit. Every byte stays where it is: what is at the block's place in the text is the comment.
///
/// # Errors
///
/// If the program has errors.
pub fn analysis<'a>(
    analysis: &'a Analysis,
    text: &str,
    is_element: impl Fn(&str) -> bool,
) -> Result<Cow<'a, Analysis>, WriteError> {
    let parse = &analysis.context.parse;
    let mut aside = text.to_owned();
    for line in 0..parse.lines().len() {
        let start = usize::from(parse.line_start(line));
        if !text[start..].starts_with(['+', '|', '/', '\\']) {
            continue;
        }
        let tokens = parse.lines()[line].syntax().descendants_with_tokens();
        let tokens = tokens.filter_map(NodeOrToken::into_token);
        for token in tokens.filter(|token| token.kind() == SyntaxKind::COMMENT) {
            let comment = token.text();
            let (begin, end) = if comment.len() > STAND_IN.len() {
                (STAND_IN, ")")
            } else {
                (SHORT, "]")
            };
            if comment.len() > begin.len() && is_element(comment) {
                let blanks = comment.len() - begin.len() - 1;
                let at = start + usize::from(token.text_range().start());
                aside.replace_range(at..at + comment.len(), &format!("{begin}{:blanks$}{end}", ""));
            }
        }
    }
    let analysis = if aside == text {
        Cow::Borrowed(analysis)
    } else {
        let parse = ladder_syntax::parse(&aside).into();
        let context = &analysis.context;
        Cow::Owned(ladder_analysis::analyze(
            &parse,
            ladder_analysis::AnalyzeOptions::new(&context.name).among(&context.others),
        ))
    };
    if analysis.program().is_some() {
        return Ok(analysis);
    }
    Err(no_program(&analysis, text))
}
