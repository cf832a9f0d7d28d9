//! Functions of other files, with the tags of these files that they use: a function runs with the tags of the file that holds it.
//! Where a name is taken in the program the tag or function has another one.

use super::Needed;
use super::search::{Used, used_by};
use crate::edited::edited_line;
use crate::functions::lines_of_functions;
use crate::{Names, comments};
use ladder_analysis::Analysis;
use ladder_analysis::context::{Body, Callee, Context};
use ladder_analysis::names::scope::{Origin, SectionKind, TagFacts};
use ladder_analysis::program::Role;
use ladder_syntax::ast::{AstNode, Declaration, NodeView};
use ladder_syntax::{Name, TextRange};
use std::collections::{BTreeMap, HashMap, HashSet};
use std::sync::Arc;

/// The functions on their way into the text of a program.
pub(super) struct Functions<'a> {
    files: &'a [Arc<Analysis>],
    /// The functions that are needed of each file.
    needed: HashMap<usize, HashSet<usize>>,
    /// The lines of the functions of each of these files.
    lines: HashMap<usize, BTreeMap<usize, Vec<usize>>>,
    /// What is changed in each file.
    edits: HashMap<usize, Vec<(TextRange, String)>>,
    pub(super) declarations: String,
}

impl<'a> Functions<'a> {
    /// Of these, which tags they need, and how everything is called.
    pub(super) fn of(own: &Context, files: &'a [Arc<Analysis>], found: &[Needed]) -> Functions<'a> {
        let mut functions = Functions {
            files,
            needed: HashMap::new(),
            lines: HashMap::new(),
            edits: HashMap::new(),
            declarations: String::new(),
        };
        let (mut called, mut tags) = (Names::default(), Names::default());
        own.functions.iter().for_each(|function| {
            called.fresh(&function.name);
        });
        own.scopes[0].tags.iter().for_each(|tag| {
            tags.fresh(&tag.name);
        });
        let mut names: HashMap<Needed, String> = HashMap::new();
        // What the program itself calls keeps its name.
        let is_called = |file: usize, function: usize| {
            let other = &files[file].context;
            let callee = own.callee(&other.functions[function].key);
            matches!(callee, Some(Callee::Other(import)) if *import.file == *other.name && import.item == function)
        };
        for calls in [true, false] {
            for needed in found {
                if let (file, Used::Function(Callee::Own(function))) = needed
                    && is_called(*file, *function) == calls
                {
                    functions.needed.entry(*file).or_default().insert(*function);
                    let name = &files[*file].context.functions[*function].name;
                    names.insert(needed.clone(), called.fresh(name));
                }
            }
        }
        let mut used: Vec<usize> = functions.needed.keys().copied().collect();
        used.sort_unstable();
        for file in used {
            let lines = lines_of_functions(&files[file].context);
            functions.lines.insert(file, lines);
            functions.enter_tags(file, &mut tags);
            functions.enter_calls(own, file, &names);
            let edits = functions.edits.entry(file).or_default();
            edits.sort_by_key(|(at, _)| at.start());
        }
        functions
    }

    /// The tags that the functions of a file use.
    fn enter_tags(&mut self, file: usize, taken: &mut Names) {
        let context = &self.files[file].context;
        let needed = &self.needed[&file];
        let is_within = |network: usize| matches!(context.bodies[network], Body::Function(function) if needed.contains(&function));
        for tag in &context.scopes[0].tags {
            let uses: Vec<TextRange> = context
                .uses(tag)
                .filter(|place| is_within(place.network))
                .map(|place| place.range)
                .collect();
            let is_whole_program =
                tag.name.starts_with('%') || tag.name.eq_ignore_ascii_case("SYS") || is_shared(context, tag);
            if uses.is_empty() || is_whole_program {
                continue;
            }
            let name = taken.fresh(&tag.name);
            if *name != *tag.name {
                let edits = self.edits.entry(file).or_default();
                edits.extend(uses.into_iter().map(|range| (range, name.clone())));
            }
            self.declarations.push_str(&declaration(context, tag, &name));
        }
    }

    /// Functions that have other names now.
    fn enter_calls(&mut self, own: &Context, file: usize, names: &HashMap<Needed, String>) {
        let context = &self.files[file].context;
        let edits = self.edits.entry(file).or_default();
        for function in &self.needed[&file] {
            let facts = &context.functions[*function];
            let name = &names[&(file, Used::Function(Callee::Own(*function)))];
            if **name != *facts.name {
                edits.push((facts.at, name.clone()));
            }
        }
        let by_name = |wanted: &str| self.files.iter().position(|file| *file.context.name == *wanted);
        for network in &context.networks {
            for block in network.blocks() {
                let Some(Used::Function(callee)) = used_by(context, block) else {
                    continue;
                };
                let called = match &callee {
                    Callee::Own(_) => Some((file, callee)),
                    Callee::Other(import) if *import.file == *own.name => None,
                    Callee::Other(import) => {
                        by_name(&import.file).map(|file| (file, Callee::Own(import.item)))
                    }
                };
                let called = called.map(|(file, callee)| (file, Used::Function(callee)));
                let operand = block
                    .facts
                    .operands
                    .first()
                    .map(|operand| block.absolute(operand.value.range));
                if let (Some(name), Some(range)) = (called.and_then(|called| names.get(&called)), operand) {
                    edits.push((range, name.clone()));
                }
            }
        }
    }

    /// The text of a function.
    pub(super) fn text(&self, file: usize, function: usize) -> String {
        let context = &self.files[file].context;
        let none = Vec::new();
        let edits = self.edits.get(&file).unwrap_or(&none);
        let lines = self.lines.get(&file).and_then(|lines| lines.get(&function));
        let lines = lines.into_iter().flatten();
        let mut text: String = lines.map(|line| edited_line(context, *line, edits)).collect();
        if !text.ends_with('\n') {
            text.push('\n');
        }
        text
    }
}

/// Whether other files see the tag as well: then it is the same in the program.
fn is_shared(context: &Context, tag: &TagFacts) -> bool {
    let shared = context.shared(tag);
    let kinds = [SectionKind::Global, SectionKind::External];
    shared.cold.foreign.is_some() || matches!(shared.origin, Origin::Declared(kind) if kinds.contains(&kind))
}

/// Declarations of the globals of other files that a text names: in one file nothing else declares them.
pub(super) fn globals(own: &Context, files: &[Arc<Analysis>]) -> String {
    let named = own.scopes[0].tags.iter();
    let named =
        named.filter(|tag| tag.cold.foreign.is_some() && !tag.is_declared() && !tag.name.starts_with('%'));
    let declared = named.filter_map(|tag| {
        files.iter().find_map(|file| {
            let mut tags = file.context.scopes[0].tags.iter();
            let global = Origin::Declared(SectionKind::Global);
            let own =
                tags.find(|own| own.origin == global && Name::new(&own.name) == Name::new(&tag.name))?;
            Some(declaration(&file.context, own, &own.name))
        })
    });
    declared.collect()
}

/// A section with one tag.
fn declaration(context: &Context, tag: &TagFacts, name: &str) -> String {
    let Some(ty) = tag.ty else { return String::new() };
    let section = match (tag.origin, tag.role) {
        (Origin::Declared(kind), _) => kind.keyword(),
        (_, Role::Input) => "VAR_INPUT",
        (_, Role::Output) => "VAR_OUTPUT",
        (_, Role::Internal) => "VAR",
    };
    let qualifier = match (tag.constant, tag.retain) {
        (true, _) => " CONSTANT",
        (_, true) => " RETAIN",
        _ => "",
    };
    let address = tag
        .cold
        .address
        .as_deref()
        .map(|address| format!(" AT {address}"));
    let line = context
        .parse
        .line_at(context.place_of(tag).start())
        .filter(|_| tag.is_declared());
    let initial = line.and_then(|line| {
        let line = &context.parse.lines()[line];
        let tree = line.tree();
        let initial = Declaration::cast(NodeView::root(&tree))?.initial_value()?;
        Some(format!(" := {}", line.text()[initial.range()].trim()))
    });
    let said = line.map(|line| comments::on_line(&context.parse, line).join(" "));
    let said = said
        .filter(|said| !said.trim().is_empty())
        .map(|said| format!("  #{said}#"));
    let or_none = Option::unwrap_or_default;
    format!(
        "{section}{qualifier}\n    {name}{} : {ty}{};{}\nEND_VAR\n",
        or_none(address),
        or_none(initial),
        or_none(said)
    )
}
