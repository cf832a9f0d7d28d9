//! What is put into a drawing: its parts, and the names that it brings with it.

use super::declaring::{self, Declared};
use super::piece::Piece;
use super::words::as_rungs;
use crate::drawing::carry::fresh;
use crate::drawing::insert::has_block;
use crate::drawing::item::Item;
use crate::drawing::rows::Drawing;
use crate::drawing::term::Rung;
use crate::refactor::names::{called, each_name, numbered, tag_like};
use ladder_analysis::context::Context;
use ladder_analysis::names::scope::SectionKind;
use ladder_analysis::networks::network::{Formal, Meaning};
use ladder_analysis::networks::{BlockAt, NetworkAt};
use ladder_analysis::rules::declaration_fix::undeclared;
use ladder_analysis::{Analysis, AnalyzeOptions, RuleGroup, Severity, analyze};
use ladder_format::{Circuit, Edit, Options, apply};
use ladder_instructions::Accepts;
use ladder_syntax::{Item as TextItem, Name, TextRange, parse};
use std::sync::Arc;

/// What is put in.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Given {
    /// Ladder text, mnemonics or drawn characters.
    pub text: String,
    /// It was copied: timers, counters and instances get tags of their own.
    pub copied: bool,
    /// The section and the type of its first new name.
    pub declare: Option<(SectionKind, String)>,
}

/// Rungs that belong into a scope, and what they bring with them.
#[derive(Debug)]
pub(super) struct Fragment {
    /// The rungs, from rail to rail.
    pub(super) rungs: String,
    /// The declarations of their new names.
    pub(super) declarations: Vec<Piece>,
    pub(super) declared: Vec<Declared>,
    /// What they are in words: `Open contact test`.
    pub(super) said: String,
}

impl Fragment {
    /// Reads what is given for a scope.
    ///
    /// # Errors
    /// What cannot be read, or must not be there.
    pub(super) fn read(
        context: &Context,
        scope: usize,
        given: &Given,
        options: &Options,
    ) -> Result<Fragment, String> {
        Fragment::of_block(context, scope, given, 0, options)
    }

    /// The same of a block that may have so many errors: those that it had before.
    ///
    /// # Errors
    /// As of `read`.
    pub(super) fn of_block(
        context: &Context,
        scope: usize,
        given: &Given,
        errors: usize,
        options: &Options,
    ) -> Result<Fragment, String> {
        let mut rungs = as_rungs(&given.text)?;
        let mut analysis = checked(context, &rungs, errors)?;
        let mut copies = Vec::new();
        if given.copied {
            let (edits, found) = own_states(context, scope, &analysis);
            rungs = apply(&rungs, &edits);
            analysis = checked(context, &rungs, errors)?;
            copies = found;
        }
        let new = new_names(context, scope, &analysis, &copies, given)?;
        let mut declared: Vec<Declared> = copies.iter().map(|copy| copy.new.clone()).collect();
        declared.extend(new.iter().cloned());
        let declares = scope > 0 || context.scopes[scope].declares() || given.declare.is_some();
        if !declares {
            declared.clear();
        }
        let declarations = if declared.is_empty() {
            Vec::new()
        } else {
            declaring::pieces(context, scope, &copies, &new, options)?
        };
        Ok(Fragment {
            said: said(&analysis),
            rungs,
            declarations,
            declared,
        })
    }

    /// Its parts, to be put into a wire.
    ///
    /// # Errors
    /// Why it is no run of parts.
    pub(super) fn parts(&self) -> Result<Vec<Circuit<Item>>, String> {
        let parsed = parse(&self.rungs);
        let [network] = parsed.structure().networks.as_slice() else {
            return Err(
                "several networks cannot be put into a wire: put them between two networks".to_owned(),
            );
        };
        let drawing = Drawing::of_text(&parsed, network).map_err(|why| why.message().to_owned())?;
        let rung = Rung::read(&drawing)
            .filter(|rung| has_block(&rung.parts))
            .ok_or("what is put into a wire is joined on both sides, and its branches meet again")?;
        Ok(fresh(rung.parts))
    }
}

/// The rungs as a file of their own, if they can be read and hold nothing else.
fn checked(context: &Context, rungs: &str, errors: usize) -> Result<Analysis, String> {
    let parsed = Arc::new(parse(rungs));
    let items = &parsed.structure().items;
    if !items
        .iter()
        .all(|item| matches!(item, TextItem::Network(_) | TextItem::Decoration(_)))
    {
        return Err("only networks and comments can be put in here".to_owned());
    }
    let analysis = analyze(&parsed, AnalyzeOptions::new(&context.name).among(&context.others));
    let is_unpaired = analysis
        .context
        .networks
        .iter()
        .any(|network| !network.wiring.unpaired.is_empty());
    let in_text = parsed.errors();
    if in_text.len() <= errors && !is_unpaired {
        return Ok(analysis);
    }
    let place = in_text.first().map(|error| error.range);
    let mut found = analysis
        .diagnostics()
        .iter()
        .filter(|found| found.severity == Severity::Error);
    let wrong = found.find(|found| match place {
        Some(place) => found.range.contains_inclusive(place.start()),
        None => found.rule.group() == RuleGroup::Connectors,
    });
    let wrong = wrong.or_else(|| analysis.diagnostics().first());
    Err(wrong.map_or_else(|| "this cannot be read".to_owned(), |found| found.message.clone()))
}

/// What the first blocks are, in words.
fn said(analysis: &Analysis) -> String {
    let context = &analysis.context;
    let mut blocks = context.networks.iter().flat_map(NetworkAt::blocks);
    let Some(first) = blocks.next() else {
        return "Comment".to_owned();
    };
    let title = match first.instruction() {
        Some(row) => row.title.to_owned(),
        None => first.head_text(),
    };
    let name = called(&first, &context.parse.text_in(first.range()));
    let name = if first.facts.operands.is_empty() {
        String::new()
    } else {
        format!(" {name}")
    };
    match blocks.count() {
        0 => format!("{title}{name}"),
        more => format!("{title}{name} and {more} more"),
    }
}

/// A timer, counter or instance that gets a tag of its own.
#[derive(Debug, Clone)]
pub(super) struct Copied {
    /// The tag that it was copied from.
    pub(super) of: String,
    pub(super) new: Declared,
}

/// The edits that give the states of copied blocks names of their own, and those names.
fn own_states(context: &Context, scope: usize, analysis: &Analysis) -> (Vec<Edit>, Vec<Copied>) {
    let fragment = &analysis.context;
    let mut found: Vec<Copied> = Vec::new();
    for block in fragment.networks.iter().flat_map(NetworkAt::blocks) {
        for (number, (operand, formal)) in block.facts.operands.iter().zip(&block.formals).enumerate() {
            let ty = match formal {
                Formal::Operand(row) => match row.accepts {
                    Accepts::State(state) => state.name().to_owned(),
                    _ => continue,
                },
                Formal::Instance => block.facts.head.text().to_owned(),
                Formal::Unknown if number == 0 && is_instance(context, scope, &block) => {
                    block.facts.head.text().to_owned()
                }
                _ => continue,
            };
            let written = fragment
                .parse
                .text_in(block.absolute(operand.value.range))
                .to_string();
            let is_known = context.scopes[scope].find(&Name::new(&written)).is_some()
                || context.others.globals(&Name::new(&written)).next().is_some();
            if is_known && !found.iter().any(|copy| copy.of.eq_ignore_ascii_case(&written)) {
                let taken = |name: &str| found.iter().any(|copy| copy.new.name.eq_ignore_ascii_case(name));
                let mut name = tag_like(context, &written);
                if taken(&name) {
                    let base = name.trim_end_matches(|c: char| c.is_ascii_digit()).to_owned();
                    name = numbered(&base, "", |name| {
                        taken(name.as_str()) || context.scopes.iter().any(|scope| scope.find(name).is_some())
                    });
                }
                found.push(Copied {
                    of: written,
                    new: Declared {
                        name,
                        section: SectionKind::Var,
                        ty,
                    },
                });
            }
        }
    }
    let mut edits = Vec::new();
    for block in fragment.networks.iter().flat_map(NetworkAt::blocks) {
        for operand in &block.facts.operands {
            each_name(&operand.value, &mut |name, range| {
                let copy = found.iter().find(|copy| copy.of.eq_ignore_ascii_case(name));
                edits.extend(copy.map(|copy| Edit {
                    range: block.absolute(range),
                    text: copy.new.name.clone(),
                }));
            });
        }
    }
    edits.sort_by_key(|edit| edit.range.start());
    (edits, found)
}

/// Whether the first operand of a block that the fragment does not know is the tag that keeps its state.
fn is_instance(context: &Context, scope: usize, block: &BlockAt<'_>) -> bool {
    let head = Name::new(block.facts.head.text());
    let Some(definition) = context.user_blocks.iter().find(|known| known.key == head) else {
        return false;
    };
    let Some(operand) = block.facts.operands.first() else {
        return false;
    };
    let mut is_state = false;
    each_name(&operand.value, &mut |name, _| {
        let tag = context.scopes[scope].find(&Name::new(name));
        let ty = tag.and_then(|tag| context.scopes[scope].tags[tag].ty);
        is_state |= ty.is_some_and(|ty| Name::new(&ty.to_string()) == definition.key);
    });
    is_state || block.facts.operands.len() > definition.parameters.len()
}

/// The names that the scope does not know, as they are to be declared.
fn new_names(
    context: &Context,
    scope: usize,
    analysis: &Analysis,
    copies: &[Copied],
    given: &Given,
) -> Result<Vec<Declared>, String> {
    let is_known = |name: &str| {
        let key = Name::new(name);
        context.scopes[scope].find(&key).is_some()
            || context.others.globals(&key).next().is_some()
            || context.types.find(name).is_some()
            || copies.iter().any(|copy| copy.new.name.eq_ignore_ascii_case(name))
    };
    let fragment = &analysis.context;
    let found = undeclared(fragment, 0).into_iter();
    let mut new: Vec<Declared> = found
        .filter(|found| !is_known(&found.name))
        .map(|found| Declared {
            section: if scope > 0 {
                SectionKind::Var
            } else {
                found.section
            },
            name: found.name,
            ty: found.ty,
        })
        .collect();
    // What a block of the file itself takes.
    for block in fragment.networks.iter().flat_map(NetworkAt::blocks) {
        if let Meaning::UnknownUser = block.meaning {
            let own = of_user_block(context, scope, &block);
            new.extend(own.into_iter().filter(|own| !is_known(&own.name)));
        }
    }
    let mut names: Vec<Declared> = Vec::with_capacity(new.len());
    for declared in new {
        if !names
            .iter()
            .any(|known| known.name.eq_ignore_ascii_case(&declared.name))
        {
            names.push(declared);
        }
    }
    if let (Some((section, ty)), Some(first)) = (&given.declare, names.first_mut()) {
        first.section = *section;
        first.ty.clone_from(ty);
    }
    match names.first().filter(|_| given.copied && scope > 0) {
        Some(first) => Err(format!(
            "`{}` is not known in the block `{}`: declare it there first",
            first.name,
            context.user_blocks[scope - 1].name
        )),
        None => Ok(names),
    }
}

/// The tags that a block of the file is called with, each of the type of its parameter.
fn of_user_block(context: &Context, scope: usize, block: &BlockAt<'_>) -> Vec<Declared> {
    let head = Name::new(block.facts.head.text());
    let own = context.user_blocks[..context.own_blocks].iter();
    let Some((number, definition)) = own.enumerate().find(|(_, known)| known.key == head) else {
        return Vec::new();
    };
    let has_instance = is_instance(context, scope, block);
    let mut place = 0;
    let mut found = Vec::new();
    for (index, operand) in block.facts.operands.iter().enumerate() {
        let parameter = match operand.name() {
            Some(name) => {
                let key = Name::new(&name.text);
                definition
                    .parameters
                    .iter()
                    .find(|parameter| parameter.key == key)
            }
            None if has_instance && index == 0 => None,
            None => {
                place += 1;
                definition.parameters.get(place - 1)
            }
        };
        let ty = match parameter {
            Some(parameter) => context.scopes[number + 1].tags[parameter.tag]
                .ty
                .map(|ty| ty.to_string()),
            None if has_instance && index == 0 => Some(definition.name.clone()),
            None => None,
        };
        let mut names: Vec<(String, TextRange)> = Vec::new();
        each_name(&operand.value, &mut |name, range| {
            names.push((name.to_owned(), range));
        });
        if let ([(name, range)], Some(ty)) = (names.as_slice(), ty)
            && *range == operand.value.range
        {
            found.push(Declared {
                name: name.clone(),
                section: SectionKind::Var,
                ty,
            });
        }
    }
    found
}
