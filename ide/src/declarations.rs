//! The declarations of a file as a table: what an editor shows above a diagram, row by row as they are written.

use crate::comments;
use ladder_analysis::context::Context;
use ladder_analysis::names::declaring::header_of;
use ladder_syntax::ast::{AstNode, Declaration, NodeView};
use ladder_syntax::{LineKind, TextRange, Trees};

/// What a row of the table says, in the words of the declaration.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Row {
    /// The header of its section: `VAR RETAIN`.
    pub section: String,
    /// Its name.
    pub name: String,
    /// What is written after `AT`; empty if nothing is.
    pub address: String,
    /// Its type.
    pub ty: String,
    /// What is written after `:=`; empty if nothing is.
    pub initial: String,
    /// What the comments on its line say.
    pub comment: String,
}

/// A declared tag.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DeclaredRow {
    /// The user-defined block in whose body it is.
    pub block: Option<String>,
    /// What it says.
    pub cells: Row,
    /// Where its name is.
    pub at: TextRange,
}

/// All of them in the order of the text.
pub fn declarations(context: &Context) -> Vec<DeclaredRow> {
    let parse = &context.parse;
    let mut trees = Trees::default();
    let mut rows = Vec::new();
    for section in &parse.frame().sections {
        let Some(header) = header_of(parse, section) else {
            continue;
        };
        let block = section.block.map(|block| context.user_blocks[block].name.clone());
        for line in section.lines.clone() {
            let found = &parse.lines()[line];
            if found.kind != LineKind::Declaration {
                continue;
            }
            let tree = trees.of(found);
            let Some(declaration) = Declaration::cast(NodeView::root(&tree)) else {
                continue;
            };
            let address = declaration.address().map(|address| address.text().to_owned());
            let ty = declaration.type_ref().map(|ty| ty.syntax().to_string());
            let initial = declaration.initial_value();
            let initial = initial.map(|value| found.text()[value.range()].to_owned());
            let written = |part: &Option<String>| part.as_deref().unwrap_or_default().trim().to_owned();
            let comment = comment_of(context, line);
            rows.extend(declaration.names().map(|name| DeclaredRow {
                block: block.clone(),
                cells: Row {
                    section: header.clone(),
                    name: name.text().to_owned(),
                    address: written(&address),
                    ty: written(&ty),
                    initial: written(&initial),
                    comment: comment.clone(),
                },
                at: name.text_range() + parse.line_start(line),
            }));
        }
    }
    rows
}

/// What the comments on a line say, as one.
pub(crate) fn comment_of(context: &Context, line: usize) -> String {
    let told = comments::of_line(&context.parse, line).into_iter();
    let told = told.filter_map(|(_, comment)| comments::whole(&comment));
    told.collect::<Vec<_>>().join(" ").replace('\n', " ")
}

#[cfg(test)]
mod tests {
    use super::{Row, declarations};
    use expect_test::{Expect, expect};
    use std::sync::Arc;

    fn check(text: &str, expected: Expect) {
        let context = ladder_analysis::context(&Arc::new(ladder_syntax::parse(text)), "plant.clad");
        let rows = declarations(&context).into_iter().map(|row| {
            let block = row.block.map(|block| format!(" of {block}")).unwrap_or_default();
            assert_eq!(text[row.at], row.cells.name);
            let Row {
                section,
                name,
                address,
                ty,
                initial,
                comment,
            } = row.cells;
            format!("{section}{block} | {name} | {address} | {ty} | {initial} | {comment}\n")
        });
        expected.assert_eq(&rows.collect::<String>());
    }

    #[test]
    fn rows_are_what_is_written() {
        check(
            "\
TYPE Phase : (IDLE, RUN); END_TYPE
var_input
    start, stop : BOOL; # buttons
                          of the desk #
    level AT %IW3 : INT := -5;
END_VAR
VAR retain  total : ARRAY[1..3] OF DINT := [1, 2(0)]; END_VAR
VAR wrong : ; END_VAR
+--[ ]( start )--+
FUNCTION_BLOCK [$Motor]
VAR_INPUT
    go : BOOL;
END_VAR
END_FUNCTION_BLOCK
",
            expect![[r#"
                VAR_INPUT | start |  | BOOL |  | buttons of the desk
                VAR_INPUT | stop |  | BOOL |  | buttons of the desk
                VAR_INPUT | level | %IW3 | INT | -5 | 
                VAR RETAIN | total |  | ARRAY[1..3] OF DINT | [1, 2(0)] | 
                VAR | wrong |  |  |  | 
                VAR_INPUT of $Motor | go |  | BOOL |  | 
            "#]],
        );
    }
}
