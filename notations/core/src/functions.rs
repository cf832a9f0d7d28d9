//! Programs with functions, for systems whose functions do not see the tags of the program: each function is a block that is
//! handed the tags which it uses, and that does nothing without power. The one tag that holds its state is handed on to all that
//! call it, so that its edges and its own blocks go on wherever it is called from. A comment on the block says which function it
//! is, for people and for [`again`], which makes a function of it where such a program is read.

pub(crate) mod again;

use crate::block_name::block_name;
use crate::elements::{Replaced, is_comment, replace, rung};
use ladder_analysis::Analysis;
use ladder_analysis::context::{Body, Context};
use ladder_analysis::names::scope::{Origin, TagFacts};
use ladder_analysis::networks::BlockAt;
use ladder_analysis::networks::network::Meaning;
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Type;
use ladder_analysis::written::facts::NodeKind;
use ladder_format::program::{
    Block, Declaration, Item, Operand as Written, Path, ProgramSketch, Qualifier, Section, SectionKind,
};
use ladder_syntax::Name;
use std::collections::{BTreeMap, BTreeSet, HashSet};

/// Functions call each other no deeper: see the language.
const DEEPEST: usize = 64;
/// All calls together are handed no more.
const MOST_OPERANDS: usize = 200_000;

/// The comment on a block that is a function. The name follows.
const MARK: &str = "In ladder text this is the function ";
/// What follows the name if the function begins on a network that does more.
const BEGINS: &str = ", from its first network on";

/// Whether the comment on a block says that it is a function in ladder text. It does nothing without power, and a reader says so.
pub fn is_function(comment: &str) -> bool {
    comment.lines().any(|line| line.starts_with(MARK))
}

/// A function on its way to a block.
#[derive(Default)]
struct Function {
    /// Its name.
    name: String,
    /// The name of the block.
    block: String,
    /// The tag that holds its state.
    state: String,
    /// The network with which it begins.
    first: usize,
    /// What it is handed, by name.
    operands: BTreeMap<String, Operand>,
    calls: BTreeSet<usize>,
}

/// A tag that a function is handed.
#[derive(Clone)]
struct Operand {
    ty: String,
    /// A copy will do.
    is_input: bool,
}

type Functions = BTreeMap<usize, Function>;

/// A call: the block, in the body of which, and the function.
struct Call<'c> {
    block: BlockAt<'c>,
    within: Body,
    function: usize,
}

/// A program whose functions are blocks. None: it has none, or one cannot be a block.
pub(crate) fn as_blocks(analysis: &Analysis) -> Option<ProgramSketch> {
    let context = &analysis.context;
    if context.functions.is_empty() || analysis.has_errors() {
        return None;
    }
    let calls = calls(context)?;
    let mut functions = named(context);
    enter_operands(context, &mut functions)?;
    for call in &calls {
        if let Body::Function(caller) = call.within {
            functions.get_mut(&caller)?.calls.insert(call.function);
        }
    }
    hand_on(&mut functions)?;
    let handed = calls.iter().filter_map(|call| functions.get(&call.function));
    if handed.map(|function| function.operands.len()).sum::<usize>() > MOST_OPERANDS {
        return None;
    }
    let (mut items, mut bodies) = taken_out(context);
    let mut instead = Replaced::new();
    for call in &calls {
        let called = functions.get(&call.function)?.call()?;
        instead.insert(call.block.range().start().into(), vec![called]);
    }
    for function in functions.values() {
        let first = context.networks.at(function.first);
        for block in first.blocks().filter(|block| head(*block) == "<FUN>") {
            instead.insert(block.range().start().into(), Vec::new());
        }
    }
    items.extend(declarations(context, &functions));
    for (number, function) in &functions {
        let mut own = bodies.remove(number).unwrap_or_default();
        // What only begins the function has nothing to do there.
        let is_bare = context.networks.at(function.first).blocks().count() == 1;
        let first = own.iter().position(|item| matches!(item, Item::Network(_)))?;
        let below = own.split_off(first);
        items.push(Item::Blank);
        items.extend(own);
        let begins = if is_bare { "" } else { BEGINS };
        items.push(Item::Comment(format!("{MARK}{}{begins}", function.name)));
        let first = context.networks.at(function.first).blocks().next();
        let mut inside = function.head(first.map(|block| block.range().start().into()));
        inside.extend(below.into_iter().skip(usize::from(is_bare)));
        items.push(Item::Block {
            header: format!("[{}]", function.block),
            origin: None,
            items: inside,
        });
    }
    replace(&mut items, &instead);
    Some(ProgramSketch { items })
}

/// What an instruction is called; of a block of one's own nothing.
pub(crate) fn head(block: BlockAt<'_>) -> String {
    match block.meaning {
        Meaning::Instruction(row) => row.block(),
        _ => String::new(),
    }
}

/// The calls of the file. None: one is in a block, which does not see the tags of the program.
fn calls(context: &Context) -> Option<Vec<Call<'_>>> {
    let mut calls = Vec::new();
    for network in &context.networks {
        for block in network.blocks().filter(|block| head(*block) == "<CALL>") {
            let NodeKind::Name(name) = &block.bound().facts.operands.first()?.value.kind else {
                return None;
            };
            let within = context.bodies[network.index];
            if let Body::Block(_) = within {
                return None;
            }
            calls.push(Call {
                block,
                within,
                function: context.function(&Name::new(name))?,
            });
        }
    }
    Some(calls)
}

/// The functions, with names for their blocks and states.
fn named(context: &Context) -> Functions {
    let mut taken: HashSet<Name> = context.scopes[0]
        .tags
        .iter()
        .map(|tag| Name::new(&tag.name))
        .collect();
    // Blocks lose their sign there.
    taken.extend(
        context
            .user_blocks
            .iter()
            .map(|block| Name::new(&block.name[1..])),
    );
    let mut fresh = |like: String| {
        let mut name = like.clone();
        let mut number = 1;
        while !taken.insert(Name::new(&name)) {
            number += 1;
            name = format!("{like}{number}");
        }
        name
    };
    let mut functions = Functions::new();
    for (number, facts) in context.functions.iter().enumerate() {
        let plain = fresh(block_name(facts.name.as_ref(), "Function"));
        let function = Function {
            name: facts.name.to_string(),
            state: fresh(format!("{plain}_state")),
            block: format!("${plain}"),
            first: facts.network,
            ..Function::default()
        };
        functions.insert(number, function);
    }
    functions
}

/// Enters the tags that the functions use. None: one of them cannot be handed on.
fn enter_operands(context: &Context, functions: &mut Functions) -> Option<()> {
    for tag in &context.scopes[0].tags {
        if tag.name.starts_with('%') || tag.name.eq_ignore_ascii_case("SYS") {
            continue;
        }
        for place in context.uses(tag) {
            let Body::Function(function) = context.bodies[place.network] else {
                continue;
            };
            let Some(function) = functions.get_mut(&function) else {
                continue;
            };
            let ty = tag.ty?;
            let is_input = !place.access.writes() && matches!(ty, Type::Scalar(_));
            // The tag itself must be retentive, and a constant is not an in-out.
            let head = head(context.networks.at(place.network).block(place.block));
            if ["(M)", "(SM)", "(RM)", "[PERSIST]"].contains(&head.as_str()) || tag.constant && !is_input {
                return None;
            }
            let ty = ty.to_string();
            let operand = function
                .operands
                .entry(tag.name.to_string())
                .or_insert(Operand { ty, is_input });
            operand.is_input &= is_input;
        }
    }
    Some(())
}

/// Hands on what is used by the functions that a function calls, and their states. None: one calls itself, or that is too much.
fn hand_on(functions: &mut Functions) -> Option<()> {
    for _ in 0..DEEPEST {
        let (mut changes, mut handed) = (false, 0);
        for function in functions.keys().copied().collect::<Vec<_>>() {
            let own = functions.get(&function)?;
            let mut operands = own.operands.clone();
            let mut calls = own.calls.clone();
            for called in &own.calls {
                let called = functions.get(called)?;
                handed += called.operands.len() + called.calls.len();
                if handed > MOST_OPERANDS {
                    return None;
                }
                calls.extend(&called.calls);
                let state = Operand {
                    ty: called.block.clone(),
                    is_input: false,
                };
                operands.insert(called.state.clone(), state);
                for (name, operand) in &called.operands {
                    let own = operands.entry(name.clone()).or_insert_with(|| operand.clone());
                    own.is_input &= operand.is_input;
                }
            }
            if calls.contains(&function) {
                return None;
            }
            let inputs = |all: &BTreeMap<String, Operand>| all.values().filter(|one| one.is_input).count();
            let own = functions.get_mut(&function)?;
            changes |= own.calls.len() < calls.len()
                || own.operands.len() < operands.len()
                || inputs(&own.operands) != inputs(&operands);
            (own.operands, own.calls) = (operands, calls);
        }
        if !changes {
            return Some(());
        }
    }
    None
}

/// The items of a file, without its functions, and those of each function: its networks, and the comments above and between these.
pub(crate) fn taken_out(context: &Context) -> (Vec<Item>, BTreeMap<usize, Vec<Item>>) {
    let mut functions: BTreeMap<usize, Vec<Item>> = BTreeMap::new();
    let (mut items, mut above) = (Vec::new(), Vec::new());
    let (mut number, mut current) = (0, None);
    for item in ProgramSketch::of_text(&context.parse).items {
        match &item {
            Item::Network(_) => {
                let body = context.bodies[number];
                number += 1;
                let Body::Function(function) = body else {
                    items.append(&mut above);
                    items.push(item);
                    continue;
                };
                let is_first = current.replace(function) != Some(function);
                let comments = above.iter().rev().take_while(|item| is_comment(item)).count();
                let from = if is_first { above.len() - comments } else { 0 };
                let own = functions.entry(function).or_default();
                own.extend(above.drain(from..));
                own.push(item);
                items.append(&mut above);
            }
            Item::Blank => above.push(item),
            Item::Kept(..) if is_comment(&item) => above.push(item),
            _ => {
                if let Item::Block { items, .. } = &item {
                    number += items
                        .iter()
                        .filter(|item| matches!(item, Item::Network(_)))
                        .count();
                }
                items.append(&mut above);
                items.push(item);
            }
        }
    }
    items.append(&mut above);
    (items, functions)
}

/// The tags that hold the states, and those that are handed on and that nothing declares: else what they are would follow from
/// the blocks.
fn declarations(context: &Context, functions: &Functions) -> Vec<Item> {
    let is_handed = |tag: &&TagFacts| {
        let mut functions = functions.values();
        matches!(tag.origin, Origin::Undeclared | Origin::Form)
            && functions.any(|function| function.operands.contains_key(tag.name.as_str()))
    };
    let mut sections = Vec::new();
    for tag in context.scopes[0].tags.iter().filter(is_handed) {
        let mut section = Section::new(match tag.role {
            Role::Input => SectionKind::VarInput,
            Role::Output => SectionKind::VarOutput,
            Role::Internal => SectionKind::Var,
        });
        section.qualifier = (tag.retain && tag.role != Role::Input).then_some(Qualifier::Retain);
        let ty = tag
            .ty
            .map(|ty| Declaration::new(tag.name.as_str(), ty.to_string()));
        section.declarations.extend(ty);
        sections.push(Item::Section(section));
    }
    let mut states = Section::new(SectionKind::Var);
    let declared = functions
        .values()
        .map(|function| Declaration::new(&function.state, &function.block));
    states.declarations.extend(declared);
    sections.push(Item::Section(states));
    sections
}

impl Function {
    /// The block up to the network with which the function begins, made from what begins it.
    fn head(&self, origin: Option<u32>) -> Vec<Item> {
        let mut items = Vec::new();
        for (kind, is_input) in [(SectionKind::VarInput, true), (SectionKind::VarInOut, false)] {
            let own = self
                .operands
                .iter()
                .filter(|(_, operand)| operand.is_input == is_input);
            let mut section = Section::new(kind);
            let declared = own.map(|(name, operand)| Declaration {
                origin,
                ..Declaration::new(name, &operand.ty)
            });
            section.declarations = declared.collect();
            items.push(Item::Section(section));
        }
        items.push(rung(
            [Block::negated_contact(Path::tag("EN")), Block::ret()],
            origin,
        ));
        items
    }

    /// A call of the block.
    fn call(&self) -> Option<Block> {
        let handed = self
            .operands
            .keys()
            .map(|name| Written::Given(name.clone(), Path::tag(name).into()));
        let operands = std::iter::once(Path::tag(&self.state).into()).chain(handed);
        Block::user(&self.block[1..], operands).ok()
    }
}
