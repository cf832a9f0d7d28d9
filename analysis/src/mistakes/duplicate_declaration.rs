//! `duplicate-declaration`: one name is declared twice in a file or block.

use crate::diagnostic::Diagnostic;
use crate::rule::Rule;
use crate::scope::TagFacts;
use ladder_syntax::TextRange;
use ladder_syntax::ast::TokenView;

pub(crate) fn twice(name: TokenView<'_>, range: TextRange, first: (&TagFacts, TextRange)) -> Diagnostic {
    let message = format!("`{}` is declared twice", name.text());
    Diagnostic::new(Rule::DuplicateDeclaration, range, message)
        .help(
            "remove one of the declarations, or give one tag another name; capitals do not tell names apart",
        )
        .related(first.1, format!("`{}` is first declared here", first.0.name))
}
