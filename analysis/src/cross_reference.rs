//! The cross-reference of a file: each tag with its type and address, what its declaration says, and every place that
//! reads, writes, sets or resets it. The command line, the editors and the printed pages show this and nothing of their own.

use crate::names::context::Context;
use crate::names::scope::{Origin, TagFacts};
use crate::networks::access_kind::AccessKind;
use crate::program::Role;
use ladder_syntax::ast::NodeView;
use ladder_syntax::{LineKind, SyntaxKind, TextRange};
use std::collections::HashMap;

/// A tag and its places.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TagEntry {
    /// As declared, or as first written.
    pub name: String,
    /// The user-defined block in whose body it is.
    pub block: Option<String>,
    /// Its type; nothing where that is not known.
    pub ty: String,
    /// What it is for the program.
    pub kind: TagKind,
    /// Its direct address.
    pub address: Option<String>,
    /// The line of its declaration, from 1.
    pub declared: Option<usize>,
    /// Its name in the declaration, or where it is used first.
    pub range: TextRange,
    /// What the comment at its declaration says.
    pub comment: String,
    /// Where it is used, from top to bottom.
    pub places: Vec<TagPlace>,
}

/// What a tag is for the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum TagKind {
    Input,
    Output,
    Internal,
    Constant,
}

impl TagKind {
    /// In a word.
    pub const fn word(self) -> &'static str {
        match self {
            TagKind::Input => "input",
            TagKind::Output => "output",
            TagKind::Internal => "internal",
            TagKind::Constant => "constant",
        }
    }
}

/// A place where a tag is used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TagPlace {
    /// The tag's name there.
    pub range: TextRange,
    /// Its line, from 1.
    pub line: usize,
    /// The network, from 1, as printed pages number them.
    pub network: usize,
    /// What is done with the tag.
    pub access: AccessKind,
}

impl TagEntry {
    /// The places that write it.
    pub fn writers(&self) -> impl Iterator<Item = &TagPlace> {
        self.places.iter().filter(|place| place.access.writes())
    }

    /// The places that read it.
    pub fn readers(&self) -> impl Iterator<Item = &TagPlace> {
        self.places.iter().filter(|place| place.access.reads())
    }
}

/// All tags of a file, in the order of their names; those of a block's body after those of the file.
pub fn cross_reference(context: &Context) -> Vec<TagEntry> {
    let comments = comments(context);
    let mut entries = Vec::new();
    for scope in &context.scopes {
        let block = scope.block.map(|block| context.user_blocks[block].name.clone());
        let from = entries.len();
        for tag in &scope.tags {
            // What the body of a block shares with its file is listed there.
            let is_elsewhere = tag.is_alias() || tag.origin == Origin::Implicit;
            if is_elsewhere || (tag.uses.is_empty() && !tag.is_declared()) {
                continue;
            }
            entries.push(entry(context, tag, block.clone(), &comments));
        }
        entries[from..].sort_by_cached_key(|it| it.name.to_lowercase());
    }
    entries
}

fn entry(
    context: &Context,
    tag: &TagFacts,
    block: Option<String>,
    comments: &HashMap<usize, String>,
) -> TagEntry {
    let range = context.place_of(tag);
    let line = context.parse.line_at(range.start());
    let declared = tag.is_declared().then(|| context.line_number(range.start()));
    let comment = line.filter(|_| declared.is_some());
    TagEntry {
        name: tag.name.to_string(),
        block,
        ty: tag.ty.as_ref().map(ToString::to_string).unwrap_or_default(),
        kind: match tag.role {
            _ if tag.constant => TagKind::Constant,
            Role::Input => TagKind::Input,
            Role::Output => TagKind::Output,
            Role::Internal => TagKind::Internal,
        },
        address: tag.cold.address.as_deref().map(str::to_owned),
        declared,
        range,
        comment: comment
            .and_then(|line| comments.get(&line).cloned())
            .unwrap_or_default(),
        places: places(context, tag).collect(),
    }
}

fn places<'c>(context: &'c Context, tag: &'c TagFacts) -> impl Iterator<Item = TagPlace> + 'c {
    tag.uses.0.iter().map(|place| {
        let found = context.networks.use_of(*place);
        TagPlace {
            range: found.range,
            line: context.line_number(found.range.start()),
            network: found.network + 1,
            // `(S)( word.3 )` sets a bit of the tag.
            access: place.access_kind(),
        }
    })
}

/// The comments of declarations, by line.
fn comments(context: &Context) -> HashMap<usize, String> {
    let mut comments = HashMap::new();
    let lines = context.parse.lines();
    for section in &context.parse.structure_once().sections {
        for index in section.lines.clone() {
            let line = &lines[index];
            if line.kind != LineKind::Declaration || !line.text().contains('#') {
                continue;
            }
            let tree = line.tree();
            let found = NodeView::root(&tree).tokens();
            let found = found.filter(|token| token.kind() == SyntaxKind::COMMENT);
            let told: Vec<String> = found.map(|token| words(token.text())).collect();
            comments.insert(index, told.join(" "));
        }
    }
    comments
}

/// What a comment says, on one line.
fn words(comment: &str) -> String {
    let text = comment.strip_prefix('#').unwrap_or(comment);
    let text = text.strip_suffix('#').unwrap_or(text);
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::cross_reference;
    use crate::analyze;
    use expect_test::{Expect, expect};
    use std::sync::Arc;

    fn check(text: &str, expected: Expect) {
        let analysis = analyze(&Arc::new(ladder_syntax::parse(text)), "plant.clad");
        let context = &analysis.context;
        let mut shown = String::new();
        for entry in cross_reference(context) {
            let block = entry.block.map(|block| format!("{block}.")).unwrap_or_default();
            shown.push_str(&format!(
                "{block}{} : {} {:?} {:?} line {:?} {:?}\n",
                entry.name, entry.ty, entry.kind, entry.address, entry.declared, entry.comment
            ));
            for place in entry.places {
                shown.push_str(&format!(
                    "    {} in line {}, network {}\n",
                    place.access.words(),
                    place.line,
                    place.network
                ));
            }
        }
        expected.assert_eq(&shown);
    }

    #[test]
    fn each_place_says_what_it_does() {
        check(
            "\
VAR_INPUT
    start, stop : BOOL; # buttons
                          of the desk #
    level AT %IW3 : INT;
END_VAR
VAR_OUTPUT lamp : BOOL; END_VAR
VAR
    t : TON;  # warm up #
    n, unused : DINT;
END_VAR
VAR CONSTANT most : INT := 5; END_VAR

+--[ ]( start )--(S)( lamp )--+
+--[ ]( stop )--(R)( lamp )--+

+--[ ]( lamp )--[TON]( t, 5s )--[ADD]( n, n, most )--+
+--[GT]( level, most )--[ ]( t.Q )--( )( %QX0.1 )--+
",
            expect![[r#"
                %QX0.1 : BOOL Output Some("%QX0.1") line None ""
                    write in line 17, network 4
                lamp : BOOL Output None line Some(6) ""
                    set in line 13, network 1
                    reset in line 14, network 2
                    read in line 16, network 3
                level : INT Input Some("%IW3") line Some(4) ""
                    read in line 17, network 4
                most : INT Constant None line Some(11) ""
                    read in line 16, network 3
                    read in line 17, network 4
                n : DINT Internal None line Some(9) ""
                    write in line 16, network 3
                    read in line 16, network 3
                start : BOOL Input None line Some(2) "buttons of the desk"
                    read in line 13, network 1
                stop : BOOL Input None line Some(2) "buttons of the desk"
                    read in line 14, network 2
                t : TON Internal None line Some(8) "warm up"
                    read and write in line 16, network 3
                    read in line 17, network 4
                unused : DINT Internal None line Some(9) ""
            "#]],
        );
    }

    #[test]
    fn the_tags_of_a_block_are_its_own() {
        check(
            "VAR_GLOBAL shared : BOOL; END_VAR\n+--[$Blink]( first, lamp )--+\n\nFUNCTION_BLOCK [$Blink]\nVAR_OUTPUT out : BOOL; END_VAR\n+--[ ]( shared )--( )( out )--+\nEND_FUNCTION_BLOCK\n",
            expect![[r#"
                first : BOOL Internal None line None ""
                    write in line 2, network 1
                lamp : DINT Internal None line None ""
                    read and write in line 2, network 1
                shared : BOOL Internal None line Some(1) ""
                    read in line 6, network 2
                $Blink.out : BOOL Output None line Some(5) ""
                    write in line 6, network 2
            "#]],
        );
    }
}
