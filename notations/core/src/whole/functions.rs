//! Functions of other files, with the tags of these files that they use: a function runs with the tags of the file that holds it.
//! Where a name is taken in the program the tag or function has another one.

use super::Needed;
use super::search::{Used, called_name};
use crate::elements::{change, rename};
use crate::functions::taken_out;
use crate::{Names, comments};
use ladder_analysis::Analysis;
use ladder_analysis::context::{Body, Callee, Context};
use ladder_analysis::names::scope::{Origin, SectionKind, TagFacts};
use ladder_analysis::program::Role;
use ladder_format::program::{self, Block, Declaration as Declared, Item, Qualifier, Section};
use ladder_instructions::Op;
use ladder_syntax::Name;
use ladder_syntax::ast::{AstNode, Declaration, NodeView};
use std::collections::{BTreeMap, HashMap, HashSet};
use std::sync::Arc;

/// The functions on their way into a program.
pub(super) struct Functions {
    /// What each of the functions that are needed is, by the number of its file.
    bodies: HashMap<usize, BTreeMap<usize, Vec<Item>>>,
    /// The tags that they need.
    pub(super) declarations: Vec<Item>,
}

impl Functions {
    /// Of these, which tags they need, and how everything is called.
    pub(super) fn of(own: &Context, files: &[Arc<Analysis>], found: &[Needed]) -> Functions {
        let (mut called, mut tags) = (Names::default(), Names::default());
        own.functions.iter().for_each(|function| {
            called.fresh(&function.name);
        });
        own.scopes[0].tags.iter().for_each(|tag| {
            tags.fresh(&tag.name);
        });
        let (mut names, mut needed) = (HashMap::new(), BTreeMap::<usize, HashSet<usize>>::new());
        // What the program itself calls keeps its name.
        let is_called = |file: usize, function: usize| {
            let other = &files[file].context;
            let callee = own.callee(&other.functions[function].key);
            matches!(callee, Some(Callee::Other(import)) if *import.file == *other.name && import.item == function)
        };
        for calls in [true, false] {
            for of in found {
                if let (file, Used::Function(Callee::Own(function))) = of
                    && is_called(*file, *function) == calls
                {
                    needed.entry(*file).or_default().insert(*function);
                    let name = &files[*file].context.functions[*function].name;
                    names.insert((*file, *function), called.fresh(name));
                }
            }
        }
        let mut functions = Functions {
            bodies: HashMap::new(),
            declarations: Vec::new(),
        };
        for (file, needed) in needed {
            let context = &files[file].context;
            let renamed = functions.enter_tags(context, &needed, &mut tags);
            let by_name = |wanted: &str| files.iter().position(|file| *file.context.name == *wanted);
            // What a function of the file is called in the program.
            let called = |name: &str| {
                let of = match context.callee(&Name::new(name))? {
                    Callee::Own(function) => (file, function),
                    Callee::Other(import) if *import.file == *own.name => return None,
                    Callee::Other(import) => (by_name(&import.file)?, import.item),
                };
                names.get(&of).cloned()
            };
            let (_, mut bodies) = taken_out(context);
            bodies.retain(|function, _| needed.contains(function));
            for items in bodies.values_mut() {
                change(items, &mut |_, block| {
                    rename(block, &renamed);
                    if let Some(name) = called_name(block).and_then(called) {
                        *block = match block.op() {
                            Some(Op::Fun) => Block::function(&name),
                            _ => Block::call(&name),
                        };
                    }
                });
            }
            functions.bodies.insert(file, bodies);
        }
        functions
    }

    /// The tags that the functions of a file use; the names of those that have others in the program come back.
    fn enter_tags(
        &mut self,
        context: &Context,
        needed: &HashSet<usize>,
        taken: &mut Names,
    ) -> HashMap<Name, String> {
        let is_within = |network: usize| matches!(context.bodies[network], Body::Function(function) if needed.contains(&function));
        let mut renamed = HashMap::new();
        for tag in &context.scopes[0].tags {
            let is_whole_program =
                tag.name.starts_with('%') || tag.name.eq_ignore_ascii_case("SYS") || is_shared(context, tag);
            if is_whole_program || !context.uses(tag).any(|place| is_within(place.network)) {
                continue;
            }
            let name = taken.fresh(&tag.name);
            self.declarations.extend(declaration(context, tag, &name, None));
            if *name != *tag.name {
                renamed.insert(Name::new(&tag.name), name);
            }
        }
        renamed
    }

    /// What a function is.
    pub(super) fn take(&mut self, file: usize, function: usize) -> Vec<Item> {
        let bodies = self.bodies.get_mut(&file);
        bodies
            .and_then(|bodies| bodies.remove(&function))
            .unwrap_or_default()
    }
}

/// Whether other files see the tag as well: then it is the same in the program.
pub(crate) fn is_shared(context: &Context, tag: &TagFacts) -> bool {
    let shared = context.shared(tag);
    let kinds = [SectionKind::Global, SectionKind::External];
    shared.cold.foreign.is_some() || matches!(shared.origin, Origin::Declared(kind) if kinds.contains(&kind))
}

/// Declarations of the globals of other files that a text names: in one file nothing else declares them.
pub(super) fn globals(own: &Context, files: &[Arc<Analysis>]) -> Vec<Item> {
    let named = own.scopes[0].tags.iter();
    let named =
        named.filter(|tag| tag.cold.foreign.is_some() && !tag.is_declared() && !tag.name.starts_with('%'));
    let declared = named.filter_map(|tag| {
        files.iter().find_map(|file| {
            let mut tags = file.context.scopes[0].tags.iter();
            let global = Origin::Declared(SectionKind::Global);
            let shared =
                tags.find(|own| own.origin == global && Name::new(&own.name) == Name::new(&tag.name))?;
            // A remark on it is one on its first use.
            let first = own.uses(tag).next().map(|place| place.range.start().into());
            declaration(&file.context, shared, &shared.name, first)
        })
    });
    declared.collect()
}

/// A section with one tag. None: its type is not known.
pub(crate) fn declaration(
    context: &Context,
    tag: &TagFacts,
    name: &str,
    origin: Option<program::Origin>,
) -> Option<Item> {
    let kind = match (tag.origin, tag.role) {
        (Origin::Declared(SectionKind::InOut), _) => program::SectionKind::VarInOut,
        (Origin::Declared(SectionKind::Global), _) => program::SectionKind::VarGlobal,
        (Origin::Declared(SectionKind::External), _) => program::SectionKind::VarExternal,
        (Origin::Declared(SectionKind::Input), _) => program::SectionKind::VarInput,
        (Origin::Declared(SectionKind::Output), _) => program::SectionKind::VarOutput,
        (Origin::Declared(SectionKind::Var), _) | (_, Role::Internal) => program::SectionKind::Var,
        (_, Role::Input) => program::SectionKind::VarInput,
        (_, Role::Output) => program::SectionKind::VarOutput,
    };
    let mut section = Section::new(kind);
    section.qualifier = match (tag.constant, tag.retain) {
        (true, _) => Some(Qualifier::Constant),
        (_, true) => Some(Qualifier::Retain),
        _ => None,
    };
    let line = context
        .parse
        .line_at(context.place_of(tag).start())
        .filter(|_| tag.is_declared());
    let initial = line.and_then(|line| {
        let line = &context.parse.lines()[line];
        let tree = line.tree();
        let initial = Declaration::cast(NodeView::root(&tree))?.initial_value()?;
        Some(line.text()[initial.range()].trim().to_owned())
    });
    let comment = line.map(|line| comments::on_line(&context.parse, line).join(" "));
    section.declarations.push(Declared {
        address: tag.cold.address.as_deref().map(str::to_owned),
        initial,
        comment: comment.filter(|comment| !comment.trim().is_empty()),
        origin,
        ..Declared::new(name, tag.ty?.to_string())
    });
    Some(Item::Section(section))
}
