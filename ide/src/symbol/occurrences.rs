//! From a symbol to its places in one file.

use super::find::{is_system, tag_of_node};
use super::{Symbol, Usage, declared_names, tag_of, types};
use ladder_analysis::context::{Body, Callee, Context};
use ladder_analysis::names::scope::SectionKind;
use ladder_analysis::networks::network::{Formal, Meaning};
use ladder_analysis::networks::{BlockAt, NetworkAt};
use ladder_analysis::program::ParameterKind;
use ladder_analysis::written::facts::{Node, NodeKind};
use ladder_instructions::{Accepts, Op};
use ladder_syntax::{Name, TextRange};
use std::collections::HashMap;
use std::sync::Arc;

/// A place of a symbol.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Occurrence {
    pub(crate) range: TextRange,
    pub(crate) usage: Usage,
}

/// The places of a symbol in one file, in the order of the text.
pub(crate) fn occurrences(file: &Context, symbol: &Symbol) -> Vec<Occurrence> {
    let mut out = Places(Vec::new());
    match symbol {
        Symbol::Tag {
            file: of,
            scope,
            name,
            ..
        } => {
            if file.is_called(of) {
                tag_uses(file, *scope..*scope + 1, symbol, name, &mut out);
            }
            if *scope > 0 {
                named_operands(file, symbol, &mut out);
                members_of_types(file, symbol, &mut out);
            }
        }
        Symbol::Global(name) | Symbol::Address(name) => {
            tag_uses(file, 0..file.scopes.len(), symbol, name, &mut out);
        }
        Symbol::Label { file: of, body, name } if file.is_called(of) => labels(file, *body, name, &mut out),
        Symbol::Label { .. } => {}
        Symbol::Function { file: of, name } => functions(file, of, name, &mut out),
        Symbol::Block { file: of, name } => blocks(file, of, name, &mut out),
        Symbol::Member { of, name } => members(file, of, name, &mut out),
        Symbol::Type { .. } | Symbol::Part { .. } => types_and_parts(file, symbol, &mut out),
        Symbol::System(name) => system_tags(file, name, &mut out),
        Symbol::Instruction(op) => {
            for (_, _, block) in all_blocks(file) {
                if block.op() == Some(*op) {
                    out.add(block.head_range(), Usage::Mention);
                }
            }
        }
    }
    out.sorted()
}

struct Places(Vec<Occurrence>);

impl Places {
    fn add(&mut self, range: TextRange, usage: Usage) {
        self.0.push(Occurrence { range, usage });
    }

    fn sorted(mut self) -> Vec<Occurrence> {
        self.0
            .sort_by_key(|it| (it.range.start(), it.range.end(), it.usage));
        self.0.dedup();
        self.0
    }
}

fn types_and_parts(file: &Context, symbol: &Symbol, out: &mut Places) {
    in_declarations(file, symbol, out);
    members_of_types(file, symbol, out);
}

/// What a declared type brings, in the declarations of a file.
fn in_declarations(file: &Context, symbol: &Symbol, out: &mut Places) {
    for (range, found, usage) in types::in_declarations(file) {
        if found == *symbol {
            out.add(range, usage);
        }
    }
}

/// The same on its rungs: `pump.valve`, `m1.running`, `IDLE`.
fn members_of_types(file: &Context, symbol: &Symbol, out: &mut Places) {
    let in_blocks = file
        .networks
        .iter()
        .flat_map(|network| network.blocks().map(move |block| (network, block)))
        .flat_map(|(network, block)| types::in_block(file, network, block));
    for (range, found, usage) in in_blocks {
        if found == *symbol {
            out.add(range, usage);
        }
    }
}

fn tag_uses(file: &Context, scopes: std::ops::Range<usize>, symbol: &Symbol, name: &Name, out: &mut Places) {
    let context = file;
    let mut found = false;
    for scope in scopes {
        // What a shadowing tag of the same name does is its own affair.
        if tag_of(file, scope, name).as_ref() != Some(symbol) {
            continue;
        }
        found = true;
        let Some(tag) = context.scopes[scope].find(name) else {
            continue;
        };
        for place in context.uses(&context.scopes[scope].tags[tag]) {
            out.add(place.range, place.access.into());
        }
    }
    if !found {
        return;
    }
    for declared in declared_names(context).filter(|declared| declared.name == *name) {
        if tag_of(file, declared.scope, name).as_ref() == Some(symbol) {
            let usage = match declared.section {
                SectionKind::External => Usage::Declaration,
                _ => Usage::Definition,
            };
            out.add(declared.at, usage);
        }
    }
}

/// `raw := button` where a block is used: what is given for an input is written into it.
fn named_operands(file: &Context, symbol: &Symbol, out: &mut Places) {
    for (_, _, block) in all_blocks(file) {
        let Meaning::User(user) = block.meaning else {
            continue;
        };
        for (operand, formal) in block.facts.operands.iter().zip(block.formals.iter()) {
            let (Some(word), Formal::Parameter(parameter)) = (operand.name(), *formal) else {
                continue;
            };
            if operand_name(file, user, parameter).as_ref() == Some(symbol) {
                let usage = match file.user_blocks[user].parameters[parameter].kind {
                    ParameterKind::Input => Usage::Write,
                    ParameterKind::Output => Usage::Read,
                    ParameterKind::InOut => Usage::ReadWrite,
                };
                out.add(block.absolute(word.range), usage);
            }
        }
    }
}

/// The symbol of a parameter of a user-defined block, by the block's and its own index.
pub(crate) fn operand_name(file: &Context, user: usize, parameter: usize) -> Option<Symbol> {
    let facts = file.user_blocks.get(user)?;
    let (of, item) = match &facts.import {
        Some(import) => (&import.file, import.item),
        None => (&file.name, user),
    };
    Some(Symbol::Tag {
        file: Arc::clone(of),
        scope: item + 1,
        name: facts.parameters.get(parameter)?.key.clone(),
    })
}

fn labels(file: &Context, body: Body, name: &Name, out: &mut Places) {
    for (network, _, block) in all_blocks(file) {
        let usage = match block.op() {
            Some(Op::Lbl) => Usage::Definition,
            Some(Op::Jmp) => Usage::Mention,
            _ => continue,
        };
        if file.bodies[network] == body
            && let Some(range) = named(block, name)
        {
            out.add(range, usage);
        }
    }
}

/// The label that a name means in a network.
pub(crate) fn label_name(file: &Context, network: usize, name: Name) -> Symbol {
    Symbol::Label {
        file: Arc::clone(&file.name),
        body: file.bodies[network],
        name,
    }
}

fn functions(file: &Context, of: &Arc<str>, name: &Name, out: &mut Places) {
    let leads_there = function_file(file, name).is_some_and(|found| found == *of);
    if !leads_there && !file.is_called(of) {
        return;
    }
    for (_, _, block) in all_blocks(file) {
        let usage = match block.op() {
            Some(Op::Fun) if file.is_called(of) => Usage::Definition,
            Some(Op::Call) => Usage::Mention,
            _ => continue,
        };
        if let Some(range) = named(block, name) {
            out.add(range, usage);
        }
    }
}

/// The file whose function a `<CALL>` of a name leads to.
pub(crate) fn function_file(file: &Context, name: &Name) -> Option<Arc<str>> {
    Some(match file.callee(name)? {
        Callee::Own(_) => Arc::clone(&file.name),
        Callee::Other(import) => import.file,
    })
}

/// Where a block's first operand is, if it is this name.
fn named(block: BlockAt<'_>, name: &Name) -> Option<TextRange> {
    let value = &block.facts.operands.first()?.value;
    match &value.kind {
        NodeKind::Name(text) if Name::new(text) == *name => Some(block.absolute(value.range)),
        _ => None,
    }
}

fn blocks(file: &Context, of: &Arc<str>, name: &Name, out: &mut Places) {
    let context = file;
    let own = file.is_called(of);
    if own {
        for block in &context.user_blocks[..context.own_blocks] {
            if block.key == *name
                && let Some(range) = block_name(context, block.at)
            {
                out.add(range, Usage::Definition);
            }
        }
    }
    if !own && block_file(file, name).is_none_or(|found| found != *of) {
        return;
    }
    for (_, _, block) in all_blocks(context) {
        if block.user_name().is_some_and(|text| Name::new(text) == *name)
            && let Some(range) = block_name(context, block.head_range())
        {
            out.add(range, Usage::Mention);
        }
    }
    let symbol = Symbol::Block {
        file: Arc::clone(of),
        name: name.clone(),
    };
    in_declarations(file, &symbol, out);
}

/// The file whose user-defined block a name means, in whatever shape it is drawn.
pub(crate) fn block_file(file: &Context, name: &Name) -> Option<Arc<str>> {
    let context = file;
    if context.user_blocks[..context.own_blocks]
        .iter()
        .any(|block| block.key == *name)
    {
        return Some(Arc::clone(&file.name));
    }
    let (exports, _) = context.others.blocks(name).next()?;
    Some(Arc::clone(&exports.file))
}

/// The word `$Name` in a block's first part, which is on one line.
pub(crate) fn block_name(context: &Context, head: TextRange) -> Option<TextRange> {
    let parse = &context.parse;
    let line = parse.line_at(head.start())?;
    let start = parse.line_start(line);
    let mut tokens = parse.lines()[line].syntax().descendants_with_tokens();
    tokens.find_map(|element| {
        let token = element.into_token()?;
        let range = token.text_range() + start;
        let is_it = token.kind() == ladder_syntax::SyntaxKind::BLOCK_NAME && head.contains_range(range);
        is_it.then_some(range)
    })
}

fn members(file: &Context, of: &Symbol, member: &Name, out: &mut Places) {
    let Some(tag) = of.name() else { return };
    let mut usages: HashMap<TextRange, Usage> = HashMap::new();
    for scope in &file.scopes {
        let tag = scope.find(tag).map(|tag| &scope.tags[tag]);
        let uses = tag.into_iter().flat_map(|tag| file.uses(tag));
        usages.extend(uses.map(|place| (place.range, Usage::from(place.access))));
    }
    each_operand(file, |network, block, _, node| {
        let NodeKind::Member(base, word) = &node.kind else {
            return;
        };
        if is_system(base) || member_name(&word.text) != *member {
            return;
        }
        let Some((name, at)) = tag_of_node(base) else {
            return;
        };
        if Name::new(name) != *tag || tag_of(file, network.scope, tag).as_ref() != Some(of) {
            return;
        }
        // A bit may be written; a timer's members are its own.
        let usage = usages.get(&block.absolute(at)).copied();
        out.add(block.absolute(word.range), usage.unwrap_or(Usage::Read));
    });
}

fn system_tags(file: &Context, name: &Name, out: &mut Places) {
    each_operand(file, |_, block, _, node| {
        if let NodeKind::Member(base, word) = &node.kind
            && is_system(base)
            && Name::new(&word.text) == *name
        {
            out.add(block.absolute(node.range), Usage::Read);
        }
    });
}

/// A member's name: those of controllers mean the same as those of IEC (LANGUAGE §4). A timer has none of a
/// counter's, so one table does for both.
pub(super) fn member_name(word: &str) -> Name {
    Name::new(match word.to_ascii_uppercase().as_str() {
        "EN" | "CU" => "IN",
        "PRE" | "PV" => "PT",
        "DN" => "Q",
        "AC" | "ACC" | "CV" => "ET",
        _ => word,
    })
}

/// All blocks with the index of their network, and their own in it.
pub(super) fn all_blocks(context: &Context) -> impl Iterator<Item = (usize, usize, BlockAt<'_>)> {
    let networks = context.networks.iter().enumerate();
    networks.flat_map(|(index, network)| {
        let blocks = network.blocks().enumerate();
        blocks.map(move |(block, bound)| (index, block, bound))
    })
}

/// Every node of every operand that is a value.
fn each_operand(context: &Context, mut give: impl FnMut(NetworkAt<'_>, BlockAt<'_>, usize, &Node)) {
    for network in &context.networks {
        for block in network.blocks() {
            for (index, (operand, formal)) in
                block.facts.operands.iter().zip(block.formals.iter()).enumerate()
            {
                let names_no_tag = matches!(formal, Formal::Operand(row) if matches!(
                    row.accepts,
                    Accepts::Label | Accepts::Function | Accepts::SearchOperator
                ));
                if !names_no_tag {
                    each_node(&operand.value, &mut |node| give(network, block, index, node));
                }
            }
        }
    }
}

/// A node and all within it.
pub(crate) fn each_node<'n>(node: &'n Node, give: &mut impl FnMut(&'n Node)) {
    give(node);
    match &node.kind {
        NodeKind::Member(base, _) => each_node(base, give),
        NodeKind::Index(base, index) => {
            each_node(base, give);
            each_node(index, give);
        }
        NodeKind::Range(base, first, last) => {
            each_node(base, give);
            each_node(first, give);
            each_node(last, give);
        }
        NodeKind::Unary(_, inner) | NodeKind::Paren(inner) => each_node(inner, give),
        NodeKind::Binary(_, left, right) => {
            each_node(left, give);
            each_node(right, give);
        }
        NodeKind::Call(_, values) | NodeKind::Array(values) | NodeKind::Repeat(_, values) => {
            for value in values {
                each_node(value, give);
            }
        }
        NodeKind::Name(_)
        | NodeKind::Address(_)
        | NodeKind::Members(_)
        | NodeKind::Literal(_)
        | NodeKind::NoFunction
        | NodeKind::Missing => {}
    }
}
