//! The names that declarations introduce, read off the text: also those that the scope refused because it has them.

use crate::body::line_body;
use ladder_analysis::context::Context;
use ladder_analysis::names::scope::SectionKind;
use ladder_syntax::ast::{AstNode, Declaration, NodeView, SectionHeader};
use ladder_syntax::{Line, LineKind, Name, TextRange, TextSize, Trees, is_identifier};
use smallvec::SmallVec;

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
    let sections = 0..context.parse.frame().sections.len();
    sections.flat_map(move |section| names_of(context, section))
}

/// Those of one section of the structure.
pub(crate) fn names_of(context: &Context, section: usize) -> Vec<DeclaredName> {
    let parse = &context.parse;
    let section = &parse.frame().sections[section];
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
        let found = &parse.lines()[line];
        let start = parse.line_start(line);
        let declaration = line_body(parse, line);
        let mut add = |text: &str, at: TextRange| {
            names.push(DeclaredName {
                name: Name::new(text),
                scope: section.block.map_or(0, |block| block + 1),
                section: kind,
                at: at + start,
                declaration,
            });
        };
        if let Some(plain) = plain_names(found) {
            let text = found.text();
            plain.into_iter().for_each(|at| add(&text[at], at));
            continue;
        }
        let tree = trees.of(found);
        if let Some(node) = Declaration::cast(NodeView::root(&tree)) {
            node.names()
                .for_each(|token| add(token.text(), token.text_range()));
        }
    }
    names
}

/// The names of a declaration that begins with nothing but them, as nearly all do: for those no tree is made.
fn plain_names(line: &Line) -> Option<SmallVec<[TextRange; 4]>> {
    if !line.errors.is_empty() {
        return None;
    }
    let (names, _) = line.text().split_once(':')?;
    let mut at = 0;
    let mut found = SmallVec::new();
    for piece in names.split(',') {
        let name = piece.trim_matches([' ', '\t', '\r', '\n']);
        if !is_identifier(name) {
            return None;
        }
        let before = at + (name.as_ptr().addr() - piece.as_ptr().addr());
        found.push(TextRange::at(TextSize::new(before as u32), TextSize::of(name)));
        at += piece.len() + 1;
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use ladder_syntax::ast::TokenView;
    use ladder_syntax::parse;

    /// Both ways to the names of each declaration give the same.
    #[test]
    fn names_by_themselves_are_those_of_the_tree() {
        let mut plain = 0;
        for declaration in [
            "a : BOOL;",
            "\ta,b , Äö\t,_9:INT := 5;",
            "a,\r\n  b\r\n : BOOL;",
            "a AT %IX0.0 : BOOL;",
            "a # the first #, b : BOOL;",
            "a, : BOOL;",
            "a b : BOOL;",
            "VAR : BOOL;",
            "TRUE : BOOL;",
            "s : STRING(10) := ':';",
        ] {
            let parse = parse(&format!("VAR\n{declaration}\nEND_VAR\n"));
            let lines = parse
                .lines()
                .iter()
                .filter(|line| line.kind == LineKind::Declaration);
            for line in lines {
                let Some(found) = plain_names(line) else { continue };
                plain += 1;
                let tree = line.tree();
                let node = Declaration::cast(NodeView::root(&tree)).expect("a declaration");
                let of_tree: Vec<TextRange> = node.names().map(TokenView::text_range).collect();
                assert_eq!(found.to_vec(), of_tree, "{declaration}");
            }
        }
        assert_eq!(plain, 3);
    }
}
