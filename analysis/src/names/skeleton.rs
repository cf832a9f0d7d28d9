//! From the lines of a text to what is known before any use of a tag is checked: declared tags, blocks, networks, and the
//! bodies that these belong to.

use super::at_address::AtAddress;
use super::block_definition;
use super::cold::Cold;
use super::declare;
use super::instances::Instances;
use super::joined::Joined;
use super::named_types::NamedTypes;
use super::problem::NameProblem;
use super::scope::{Origin, Scope, TagFacts};
use super::type_section;
use super::unread_uses::UnreadUses;
use crate::cancel::Cancel;
use crate::names::context::{Body, Context, FunctionFacts, LabelFacts};
use crate::names::kept::Kept;
use crate::networks::control_flow::ControlFlow;
use crate::networks::known_blocks::KnownBlocks;
use crate::networks::neighbours::break_neighbours;
use crate::networks::network;
use crate::networks::reading::{Reading, TOGETHER};
use crate::networks::use_place::Uses;
use crate::networks::{BlockAt, NetworkAt, Networks};
use crate::other_files::others::Others;
use crate::profile;
use crate::program::Role;
use crate::values::types::{Scalar, Type};
use crate::written::user_block::{self, UserBlockFacts};
use ladder_instructions::{Op, Shape};
use ladder_syntax::{Name, Parse, Structure, TextRange};
use rustc_hash::{FxHashMap, FxHashSet, FxHasher};
use smol_str::SmolStr;
use std::hash::{Hash, Hasher};
use std::sync::{Arc, OnceLock};

/// The context before any use of a tag is checked: declarations, blocks, networks, functions and labels. None if that is not
/// cancelled.
pub(crate) fn skeleton(
    parse: &Arc<Parse>,
    name: &str,
    others: &Others,
    before: Option<&Context>,
    cancel: &Cancel,
) -> Option<Context> {
    let structure = &*parse.structure_once();
    let profile = profile::profile(parse);
    // In another profile the same text means something else.
    let before = before.filter(|before| before.profile == profile);
    let Declarations {
        scopes,
        mut types,
        mut problems,
    } = declared(parse, structure, others, cancel)?;
    let mut user_blocks: Vec<UserBlockFacts> = structure
        .blocks
        .iter()
        .zip(&scopes[1..])
        .map(|(definition, scope)| block_definition::user_block(parse, definition, scope))
        .collect();
    super::unread_body::with_calls(parse, structure, &mut user_blocks);
    let own_blocks = user_blocks.len();
    let instances = instances(&scopes, others);
    let signatures = user_block::signatures(&user_blocks) ^ instances.unwrap_or(0);
    let mut kept = before.map(|before| Kept::of(before, parse, signatures));
    unknown_blocks(&scopes, &types, (&user_blocks, others), &mut problems);
    let mut declarations = Instances {
        scopes: &scopes,
        types: &mut types,
        others,
        semantics: profile.semantics(),
        any: instances.is_some(),
    };
    let mut known = KnownBlocks::new(user_blocks, others, &mut declarations);
    let mut reading = Reading::default();
    let mut networks = Networks::with_capacity(structure.networks.len());
    for (number, drawn) in structure.networks.iter().enumerate() {
        cancel.one_more()?;
        if kept.is_none() && number.is_multiple_of(TOGETHER) {
            let next = &structure.networks[number..];
            reading.look_ahead(parse, &next[..next.len().min(TOGETHER)]);
        }
        let scope = drawn.block.map_or(0, |block| block + 1);
        known.scope = scope;
        let same = kept.as_mut().and_then(|kept| kept.network(drawn));
        let facts =
            same.unwrap_or_else(|| Arc::new(network::network(parse, drawn, &mut known, &mut reading)));
        let first = drawn.lines.start;
        networks.push(facts, first, parse.line_start(first), scope);
    }
    let all = 0..networks.len();
    break_neighbours(parse, &mut networks, all);
    take_in_held(&mut known, (&scopes, others), &networks);
    let user_blocks = known.into_list();
    let mut context = Context {
        parse: Arc::clone(parse),
        name: Arc::from(name),
        profile,
        cycle: profile::cycle(parse),
        networks,
        scopes,
        problems,
        at_address: AtAddress::default(),
        user_blocks,
        types,
        own_blocks,
        signatures,
        others: others.clone(),
        functions: Vec::new(),
        labels: Vec::new(),
        bodies: Vec::new(),
        foreign_comments: OnceLock::new(),
        joined: Joined::default(),
        unread: UnreadUses::default(),
        labels_by_name: FxHashMap::default(),
        functions_by_name: FxHashMap::default(),
    };
    bodies(&mut context);
    context.unread = UnreadUses::of(
        context.scopes.len(),
        (&context.user_blocks, context.own_blocks),
        &context.networks,
    );
    Some(context)
}

/// What the sections of a file declare.
struct Declarations {
    /// The scopes with their declared tags.
    scopes: Vec<Scope>,
    types: NamedTypes,
    /// What is wrong with the declarations.
    problems: Vec<NameProblem>,
}

/// Reads the sections. None if that is cancelled.
fn declared(parse: &Parse, structure: &Structure, others: &Others, cancel: &Cancel) -> Option<Declarations> {
    let mut scopes = vec![Scope::default()];
    scopes.extend(structure.blocks.iter().enumerate().map(|(index, definition)| {
        let mut scope = Scope::default();
        scope.block = Some(index);
        for name in ["EN", "ENO"] {
            let at = parse.line_range(definition.lines.start);
            scope.declare(Name::new(name), implicit(name, at));
        }
        scope
    }));
    let mut problems = Vec::new();
    let mut names = vec![0; scopes.len()];
    for section in &structure.sections {
        names[section.block.map_or(0, |block| block + 1)] += declare::names_about(parse, section);
    }
    for (scope, names) in scopes.iter_mut().zip(names) {
        scope.reserve_declared(names);
    }
    let constants = type_section::constants(parse, &structure.sections);
    let mut own = Vec::new();
    for section in structure
        .sections
        .iter()
        .filter(|section| type_section::is_of_types(parse, section))
    {
        match section.block {
            Some(_) => problems.push(NameProblem::TypesInBlock(parse.line_range(section.lines.start))),
            None => type_section::types(parse, section, &constants, &mut own, &mut problems),
        }
    }
    let mut types = NamedTypes::new(own, others, &mut problems);
    for section in &structure.sections {
        let scope = section.block.map_or(0, |block| block + 1);
        let types = (&mut types, &constants);
        declare::section(parse, section, &mut scopes[scope], types, &mut problems, cancel)?;
    }
    Some(Declarations {
        scopes,
        types,
        problems,
    })
}

/// Says which declarations name a block that nobody defines.
fn unknown_blocks(
    scopes: &[Scope],
    types: &NamedTypes,
    (own, others): (&[UserBlockFacts], &Others),
    problems: &mut Vec<NameProblem>,
) {
    let tags = scopes.iter().flat_map(|scope| &scope.tags);
    let declared = tags.filter_map(|tag| tag.cold.declared.as_deref());
    let types = types.own().iter().map(|ty| &*ty.declaration.declared);
    let mut told = Vec::new();
    for declared in declared.chain(types) {
        declared.spec.each_block(&mut |name, at| {
            let key = Name::new(name);
            let is_known = own.iter().any(|block| block.key == key) || others.blocks(&key).next().is_some();
            if !is_known && !told.contains(&at) {
                told.push(at);
                problems.push(NameProblem::UnknownType {
                    name: name.clone(),
                    at,
                    near: None,
                });
            }
        });
    }
}

/// Takes in the blocks of other files whose states tags hold: declared ones, and those of other files that networks name.
fn take_in_held(known: &mut KnownBlocks<'_>, (scopes, others): (&[Scope], &Others), networks: &Networks) {
    for tag in scopes.iter().flat_map(|scope| &scope.tags) {
        known.held(tag.ty);
    }
    let globals = others.all_globals();
    let mut globals: Vec<_> = globals.filter(|(_, global)| global.declared.is_some()).collect();
    if globals.is_empty() {
        return;
    }
    let wanted: FxHashSet<&Name> = globals.iter().map(|(_, global)| &global.key).collect();
    let mut named: FxHashSet<Name> = FxHashSet::default();
    for network in networks {
        let keys = network.facts().named.iter().map(|one| &one.key);
        named.extend(keys.filter(|key| wanted.contains(key)).cloned());
    }
    globals.retain(|(_, global)| named.contains(&global.key));
    for (file, global) in globals {
        if let Some(declared) = &global.declared {
            known.held_by_other(declared, &file.file);
        }
    }
}

/// Stands for the tags that are, or hold, the states of user-defined blocks; none if there are none.
fn instances(scopes: &[Scope], others: &Others) -> Option<u64> {
    let mut hasher = FxHasher::default();
    let mut any = false;
    for (scope, tags) in scopes.iter().enumerate() {
        for tag in &tags.tags {
            if let Some(ty @ Type::Compound(_)) = tag.ty
                && ty.keeps_state()
            {
                (scope, &tag.name, ty).hash(&mut hasher);
                any = true;
            }
        }
    }
    for (file, global) in others
        .all_globals()
        .filter(|(_, global)| global.declared.is_some())
    {
        (&file.file, &global.name).hash(&mut hasher);
        any = true;
    }
    any.then(|| hasher.finish())
}

fn implicit(name: &str, at: TextRange) -> TagFacts {
    TagFacts {
        name: name.into(),
        ty: Some(Type::Scalar(Scalar::Bool)),
        role: Role::Internal,
        origin: Origin::Implicit,
        retain: false,
        constant: false,
        cold: Cold::default(),
        declared_at: at,
        uses: Uses::default(),
        mistyped: false,
    }
}

/// Finds functions and labels, and which body each network belongs to. A network's first `<FUN>` counts. One in the
/// body of a `<$B>` begins a function of the file, which reaches to the end of the body (LANGUAGE §5.7).
fn bodies(context: &mut Context) {
    let mut current = Body::Main;
    // In the definition of a block: the function that its body has come to.
    let mut inner: Option<(usize, usize)> = None;
    let mut in_file = Vec::new();
    let mut bodies = Vec::with_capacity(context.networks.len());
    for network in &context.networks {
        let index = network.index;
        let definition = network.scope.checked_sub(1);
        inner = inner.filter(|(of, _)| Some(*of) == definition);
        let may_begin = definition.is_none_or(|block| context.user_blocks[block].shape == Shape::Function);
        context.labels.extend(labels_in(network));
        for block in marks_in(network).filter(|block| block.op() == Some(Op::Fun)) {
            let Some((name, key, at)) = named(&block) else {
                continue;
            };
            if may_begin && context.functions.last().is_none_or(|last| last.network != index) {
                match definition {
                    Some(block) => inner = Some((block, context.functions.len())),
                    None => current = Body::Function(context.functions.len()),
                }
                context.functions.push(FunctionFacts {
                    name,
                    key,
                    network: index,
                    at,
                });
            }
        }
        bodies.push(match (definition, inner) {
            (None, _) => current,
            (Some(_), Some((_, function))) => {
                // It runs with the tags of the file.
                in_file.push(index);
                Body::Function(function)
            }
            (Some(block), None) => Body::Block(block),
        });
    }
    context.bodies = bodies;
    for index in in_file {
        context.networks.set_scope(index, 0);
    }
    name_labels(context);
    let mut by_name: FxHashMap<Name, usize> = FxHashMap::default();
    for (index, function) in context.functions.iter().enumerate() {
        by_name.entry(function.key.clone()).or_insert(index);
    }
    context.functions_by_name = by_name;
}

/// The blocks of a network, if there is a label or the beginning of a function among them.
fn marks_in(network: NetworkAt<'_>) -> impl Iterator<Item = BlockAt<'_>> {
    let is_marked = network.control_flow.has(ControlFlow::MARK);
    let blocks = is_marked.then(|| network.blocks());
    blocks.into_iter().flatten()
}

/// The labels of a network, in the order of its blocks.
fn labels_in(network: NetworkAt<'_>) -> impl Iterator<Item = LabelFacts> {
    let labels = marks_in(network).filter(|block| block.op() == Some(Op::Lbl));
    labels.filter_map(move |block| {
        let (name, key, at) = named(&block)?;
        Some(LabelFacts {
            name,
            key,
            network: network.index,
            at,
        })
    })
}

/// The name in the first operand of a label or function, as written and as it is compared, and where it is.
fn named(block: &BlockAt<'_>) -> Option<(SmolStr, Name, TextRange)> {
    let (name, range) = block.facts.first_name()?;
    Some((name.clone(), Name::new(name), block.absolute(range)))
}

/// Enters the labels of each body by their names.
fn name_labels(context: &mut Context) {
    let mut by_name: FxHashMap<(Body, Name), Vec<usize>> = FxHashMap::default();
    for (index, label) in context.labels.iter().enumerate() {
        let key = (context.bodies[label.network], label.key.clone());
        by_name.entry(key).or_default().push(index);
    }
    context.labels_by_name = by_name;
}
