//! Names that nothing has yet, and how titles call things.

use ladder_analysis::context::Context;
use ladder_analysis::networks::network::BoundBlock;
use ladder_analysis::written::facts::{Node, NodeKind};
use ladder_syntax::{Name, TextRange, is_declaration_keyword, is_reserved};

/// A name for a new tag of a scope that no tag has.
pub(crate) fn new_tag(context: &Context, taken: &[String], base: &str) -> String {
    numbered(base, "_", |name| {
        is_tag(context, name) || taken.iter().any(|taken| Name::new(taken) == *name)
    })
}

/// A name for a new tag that is named like another one: `t2` after `t1`.
pub(crate) fn tag_like(context: &Context, name: &str) -> String {
    let base = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let between = if base.len() < name.len() { "" } else { "_" };
    numbered(base, between, |name| is_tag(context, name))
}

fn is_tag(context: &Context, name: &Name) -> bool {
    context.scopes.iter().any(|scope| scope.find(name).is_some())
        || context.others.globals(name).next().is_some()
}

/// A name for a new function that no function of the workspace has.
pub(crate) fn new_function(context: &Context) -> String {
    numbered("function", "_", |name| {
        context.function(name).is_some() || context.others.functions(name).next().is_some()
    })
}

/// A name for a new block that no block of the workspace has.
pub(crate) fn new_block(context: &Context) -> String {
    numbered("$Block", "", |name| {
        context.user_blocks.iter().any(|block| block.key == *name)
            || context.others.blocks(name).next().is_some()
    })
}

/// A name for a new type that no type of the workspace has.
pub(crate) fn new_type(context: &Context, base: &str) -> String {
    let is_taken = |name: &str| {
        context.types.find(name).is_some()
            || is_reserved(name)
            || is_declaration_keyword(name)
            || is_prefix(name)
    };
    if !is_taken(base) {
        return base.to_owned();
    }
    numbered(base, "_", |name| is_taken(name.as_str()))
}

/// Whether a word before `#` begins a literal.
fn is_prefix(name: &str) -> bool {
    ["T", "D", "LTIME", "TIME_OF_DAY", "DATE_AND_TIME"]
        .iter()
        .any(|word| word.eq_ignore_ascii_case(name))
}

/// A base with the first number that makes a name of it which does not exist.
pub(crate) fn numbered(base: &str, between: &str, exists: impl Fn(&Name) -> bool) -> String {
    let mut number = 1;
    loop {
        let name = format!("{base}{between}{number}");
        if !exists(&Name::new(&name)) {
            return name;
        }
        number += 1;
    }
}

/// How a title calls a block that is in `drawing`: by its first operand, else by its first part.
pub(crate) fn called(block: &BoundBlock, text: &str) -> String {
    operand(block, text, 0).map_or_else(|| block.head_text(), str::to_owned)
}

/// An operand as it is written. `text` is the block's.
pub(crate) fn operand<'t>(block: &BoundBlock, text: &'t str, number: usize) -> Option<&'t str> {
    let range = block.facts.operands.get(number)?.value.range;
    let start = range.start().checked_sub(block.facts.range.start())?;
    text.get(usize::from(start)..usize::from(start + range.len()))
}

/// Every name in an expression, with its place.
pub(crate) fn each_name(node: &Node, found: &mut dyn FnMut(&str, TextRange)) {
    let mut each = |nodes: &[&Node]| {
        for node in nodes {
            each_name(node, found);
        }
    };
    match &node.kind {
        NodeKind::Name(name) => found(name, node.range),
        NodeKind::Member(base, _) | NodeKind::Unary(_, base) | NodeKind::Paren(base) => each(&[base]),
        NodeKind::Index(base, index) => each(&[base, index]),
        NodeKind::Range(base, first, last) => each(&[base, first, last]),
        NodeKind::Binary(_, left, right) => each(&[left, right]),
        NodeKind::Call(_, values) | NodeKind::Array(values) | NodeKind::Repeat(_, values) => {
            each(&values.iter().collect::<Vec<_>>());
        }
        NodeKind::Address(_)
        | NodeKind::Members(_)
        | NodeKind::Literal(_)
        | NodeKind::NoFunction
        | NodeKind::Missing => {}
    }
}
