//! The declarations of a file, as rows of a table.

use super::super::comment;
use ladder_analysis::context::Context;
use ladder_analysis::names::scope::Origin;
use ladder_analysis::program::Role;
use ladder_syntax::ast::{AstNode, Declaration, NodeView, SectionHeader};
use ladder_syntax::{LineKind, Section, SyntaxKind};

/// The columns of the table.
pub(super) const COLUMNS: [&str; 5] = ["Tag", "Type", "Address", "Initial value", "Comment"];

/// The tags of a section, or those that have no declaration.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Group {
    /// As the section's header has it.
    pub(super) heading: String,
    /// The section, by its index.
    pub(super) section: Option<usize>,
    pub(super) rows: Vec<Row>,
}

/// What each column says.
pub(super) type Row = [String; 5];

/// The declarations in the order of the text, then the tags that are used without one.
pub(super) fn groups(context: &Context) -> Vec<Group> {
    let parse = &context.parse;
    let sections = parse.structure().sections.iter().enumerate();
    let mut groups: Vec<Group> = sections
        .map(|(index, section)| group(context, index, section))
        .collect();
    groups.push(without_declaration(context));
    groups.retain(|group| !group.rows.is_empty());
    groups
}

fn group(context: &Context, index: usize, section: &Section) -> Group {
    let lines = context.parse.lines();
    let mut heading = Vec::new();
    if let Some(block) = section.block.and_then(|block| context.user_blocks.get(block)) {
        heading.push(format!("FUNCTION_BLOCK {} –", block.name));
    }
    if let Some(header) = SectionHeader::cast(NodeView::root(&lines[section.lines.start].tree())) {
        let words = header.section().into_iter().chain(header.qualifiers());
        heading.extend(words.map(|word| word.text().to_ascii_uppercase()));
    }
    let mut rows = Vec::new();
    for line in lines.range(section.lines.clone()) {
        if line.kind != LineKind::Declaration {
            continue;
        }
        let tree = line.tree();
        let Some(node) = Declaration::cast(NodeView::root(&tree)) else {
            continue;
        };
        let text = line.green().to_string();
        let part = |range: ladder_syntax::TextRange| {
            let text = text.get(usize::from(range.start())..usize::from(range.end()));
            let words: Vec<&str> = text.unwrap_or_default().split_whitespace().collect();
            words.join(" ")
        };
        let ty = node.type_ref().map(|ty| part(ty.range()));
        let address = node.address().map(|address| address.text().to_owned());
        let initial = node.initial_value().map(|value| part(value.range()));
        let comments = node
            .syntax()
            .tokens()
            .filter(|token| token.kind() == SyntaxKind::COMMENT);
        let comments: Vec<String> = comments.map(|token| comment::on_one_line(token.text())).collect();
        let comment = comments.join(" ");
        for name in node.names() {
            rows.push([
                name.text().to_owned(),
                ty.clone().unwrap_or_default(),
                address.clone().unwrap_or_default(),
                initial.clone().unwrap_or_default(),
                comment.clone(),
            ]);
        }
    }
    Group {
        heading: heading.join(" "),
        section: Some(index),
        rows,
    }
}

fn without_declaration(context: &Context) -> Group {
    let tags = context.scopes.first().into_iter();
    let tags = tags
        .flat_map(|scope| &scope.tags)
        .filter(|tag| matches!(tag.origin, Origin::Form | Origin::Undeclared));
    let rows = tags.map(|tag| {
        let role = match tag.role {
            Role::Input => "input",
            Role::Output => "output",
            Role::Internal => "",
        };
        let ty = tag.ty.as_ref().map(ToString::to_string);
        [
            tag.name.to_string(),
            ty.unwrap_or_default(),
            tag.cold.address.as_deref().unwrap_or_default().to_owned(),
            String::new(),
            role.to_owned(),
        ]
    });
    Group {
        heading: "Without declaration".to_owned(),
        section: None,
        rows: rows.collect(),
    }
}
