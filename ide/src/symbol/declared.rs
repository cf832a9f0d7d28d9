//! The names that declarations introduce, read off the text: also those that the scope refused because it has them.

use crate::body::line_body;
use ladder_analysis::context::Context;
use ladder_analysis::scope::SectionKind;
use ladder_syntax::ast::{AstNode, Declaration, NodeView, SectionHeader};
use ladder_syntax::{LineKind, Name, TextRange, Trees};

/// A name in a declaration.
#[derive(Debug, Clone)]
pub(crate) struct DeclaredName {
    pub(crate) name: Name,
    /// The scope: 0 the file's.
    pub(crate) scope: usize,
    pub(crate) section: SectionKind,
    /// Where the name is.
    pub(crate) at: TextRange,
    /// The whole declaration.
    pub(crate) declaration: TextRange,
}

/// All of them in the order of the text.
pub(crate) fn declared_names(context: &Context) -> impl Iterator<Item = DeclaredName> + '_ {
    let sections = 0..context.parse.structure().sections.len();
    sections.flat_map(move |section| names_of(context, section))
}

/// Those of one section of the structure.
pub(crate) fn names_of(context: &Context, section: usize) -> Vec<DeclaredName> {
    let parse = &context.parse;
    let section = &parse.structure().sections[section];
    let mut trees = Trees::default();
    let header = trees.of(&parse.lines()[section.lines.start]);
    let header = SectionHeader::cast(NodeView::root(&header));
    let keyword = header.and_then(|header| header.section());
    let Some(kind) = keyword.and_then(|word| SectionKind::from_keyword(word.text())) else {
        return Vec::new();
    };
    let mut names = Vec::new();
    for line in section.lines.clone() {
        if parse.lines()[line].kind != LineKind::Declaration {
            continue;
        }
        let tree = trees.of(&parse.lines()[line]);
        let Some(node) = Declaration::cast(NodeView::root(&tree)) else {
            continue;
        };
        let start = parse.line_start(line);
        let declaration = line_body(parse, line);
        names.extend(node.names().map(|token| DeclaredName {
            name: Name::new(token.text()),
            scope: section.block.map_or(0, |block| block + 1),
            section: kind,
            at: token.text_range() + start,
            declaration,
        }));
    }
    names
}
