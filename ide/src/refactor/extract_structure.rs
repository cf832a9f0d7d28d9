//! Tags whose names begin alike become a structure: `pump1_run` and `pump1_fault` are `pump1.run` and `pump1.fault`.
//!
//! With the cursor on one of them all of its section that share its beginning are taken; else those that are selected.

use super::declared::{DeclaredTag, is_free, is_inner, like_section_of, parts, replaced, selected, uses};
use super::names::{new_tag, new_type};
use super::place::Selected;
use super::scenarios::InScenarios;
use super::{Action, ActionKind};
use ladder_analysis::context::Context;
use ladder_analysis::networks::network::{Formal, Meaning};
use ladder_analysis::networks::{BlockAt, NetworkAt};
use ladder_analysis::program::ParameterKind;
use ladder_analysis::values::compound::Compound;
use ladder_analysis::values::types::Type;
use ladder_analysis::values::value::Value;
use ladder_format::Edit;
use ladder_instructions::Profile;
use ladder_syntax::{LineKind, Name, TextRange, is_declaration_keyword, is_identifier, is_reserved};

pub(super) fn offer(place: &Selected<'_>, out: &mut Vec<Action>) {
    let context = place.context;
    let Some(group) = group(context, place.range) else {
        return;
    };
    let title = format!(
        "Extract {} tags into the structure `{}`",
        group.tags.len(),
        group.ty
    );
    match extracted(place, &group) {
        Ok((edits, scenarios)) => {
            let action = Action::new(ActionKind::Extract, title, edits).in_scenarios(scenarios);
            out.push(if group.is_new {
                action.making_up(group.ty)
            } else {
                action
            });
        }
        Err(why) => out.push(Action::disabled(ActionKind::Extract, title, why)),
    }
}

/// Tags that become one.
struct Group<'c> {
    tags: Vec<DeclaredTag<'c>>,
    /// What each of them is called as a member.
    members: Vec<String>,
    /// The new tag, and its type.
    name: String,
    ty: String,
    /// Nobody declares such a type yet.
    is_new: bool,
}

fn group(context: &Context, range: TextRange) -> Option<Group<'_>> {
    let mut tags = selected(context, range);
    let first = tags.first()?;
    let beginning = if tags.len() > 1 {
        shared_beginning(&tags)
    } else {
        let (all, own) = (like_section_of(context, first.line), first.name.clone());
        let alike = |beginning: &str| all.iter().filter(|tag| begins(&tag.name, beginning)).count();
        // The longest that another one shares.
        let ends = own.rmatch_indices('_').map(|(at, _)| &own[..=at]);
        let beginning = ends
            .filter(|it| !it.trim_matches('_').is_empty())
            .find(|it| alike(it) > 1)?;
        let beginning = beginning.to_owned();
        tags = all;
        tags.retain(|tag| begins(&tag.name, &beginning));
        beginning
    };
    let members = members(&tags, &beginning);
    let base = if members.iter().zip(&tags).any(|(member, tag)| *member != tag.name) {
        beginning.trim_end_matches('_').to_owned()
    } else {
        "group".to_owned()
    };
    let name = if is_free(context, &Name::new(&base)) && is_identifier(&base) && !is_reserved(&base) {
        base.clone()
    } else {
        new_tag(context, &[], &base)
    };
    let known = existing(context, &type_name(&base), &tags, &members);
    Some(Group {
        tags,
        members,
        name,
        is_new: known.is_none(),
        ty: known.unwrap_or_else(|| new_type(context, &type_name(&base))),
    })
}

fn begins(name: &str, beginning: &str) -> bool {
    let start = name.get(..beginning.len());
    start.is_some_and(|start| Name::new(start) == Name::new(beginning)) && name.len() > beginning.len()
}

/// What all names begin with, up to a `_`.
fn shared_beginning(tags: &[DeclaredTag<'_>]) -> String {
    let first = &tags[0].name;
    let mut ends = first.rmatch_indices('_').map(|(at, _)| &first[..=at]);
    let shared = ends.find(|beginning| tags.iter().all(|tag| begins(&tag.name, beginning)));
    shared.unwrap_or_default().to_owned()
}

/// What is after the beginning, if that names members, else the whole names.
fn members(tags: &[DeclaredTag<'_>], beginning: &str) -> Vec<String> {
    let rest = tags.iter().map(|tag| tag.name[beginning.len()..].to_owned());
    let rest: Vec<String> = rest.collect();
    let is_name = |name: &String| is_identifier(name) && !is_reserved(name) && !is_declaration_keyword(name);
    if rest.iter().all(is_name) {
        return rest;
    }
    tags.iter().map(|tag| tag.name.clone()).collect()
}

/// `pump1` is a `Pump`.
fn type_name(base: &str) -> String {
    let base = base.trim_end_matches(|c: char| c.is_ascii_digit() || c == '_');
    let mut letters = base.trim_start_matches('_').chars();
    match letters.next() {
        Some(first) => first.to_uppercase().chain(letters).collect(),
        None => "Group".to_owned(),
    }
}

/// A type of this name that has just these members.
fn existing(context: &Context, name: &str, tags: &[DeclaredTag<'_>], members: &[String]) -> Option<String> {
    let found = context.types.find(name).filter(|found| found.initial.is_none())?;
    let Type::Compound(id) = found.ty? else {
        return None;
    };
    let Compound::Structure(structure) = id.get() else {
        return None;
    };
    let own = |ty: Type, values: &[Value]| match values {
        [] => ty.initial_values(),
        values => values.to_vec(),
    };
    let fits = |(tag, member): (&DeclaredTag<'_>, &String)| {
        let Some((ty, (_, member))) = tag.tag.ty.zip(structure.member(member)) else {
            return false;
        };
        let values = member.initial.as_deref().unwrap_or_default();
        ty == member.ty && own(ty, values) == own(ty, &tag.tag.cold.initial)
    };
    let is_it = structure.members.len() == tags.len() && tags.iter().zip(members).all(fits);
    is_it.then(|| found.declaration.name.to_string())
}

fn extracted(place: &Selected<'_>, group: &Group<'_>) -> Result<(Vec<Edit>, InScenarios), String> {
    let context = place.context;
    if place.has_errors() {
        return Err("fix the errors of the file first".to_owned());
    }
    if context.profile != Profile::Iec {
        return Err("programs of this profile have no structures".to_owned());
    }
    let first = &group.tags[0];
    for tag in &group.tags {
        is_inner(tag)?;
        if let Some(block) = given_by_reference(context, tag) {
            return Err(format!(
                "`{}` goes into `{block}` by reference, as a whole array",
                tag.name
            ));
        }
        let alike = like_section_of(context, first.line);
        if !alike.iter().any(|other| other.at == tag.at) {
            return Err("the tags are in sections of different kinds".to_owned());
        }
    }
    let mut edits = replaced(context, &group.tags, &[format!("{} : {};", group.name, group.ty)])?;
    if group.is_new {
        edits.push(declared(context, group)?);
    }
    let mut paths = Vec::new();
    for (tag, member) in group.tags.iter().zip(&group.members) {
        let path = format!("{}.{member}", group.name);
        edits.extend(uses(context, tag).into_iter().map(|range| Edit {
            range,
            text: path.clone(),
        }));
        paths.push((tag.symbol.clone(), path));
    }
    Ok((edits, InScenarios::Tags(paths)))
}

/// The block that an array goes into by reference: what that compiles to knows no arrays in structures.
fn given_by_reference(context: &Context, tag: &DeclaredTag<'_>) -> Option<String> {
    tag.tag.ty?.array()?;
    let uses = uses(context, tag);
    let blocks = context.networks.iter().flat_map(NetworkAt::blocks);
    let takes = |block: &BlockAt<'_>| {
        let Meaning::User(user) = block.meaning else {
            return false;
        };
        let parameters = &context.user_blocks[user].parameters;
        let mut given = block.facts.operands.iter().zip(block.formals.iter());
        given.any(|(operand, formal)| {
            matches!(formal, Formal::Parameter(index) if parameters[*index].kind == ParameterKind::InOut)
                && uses.contains(&block.absolute(operand.value.range))
        })
    };
    blocks.into_iter().find(takes).map(|block| block.head_text())
}

/// The declaration of the type: in the last section of types, else in one before the section of the tags.
fn declared(context: &Context, group: &Group<'_>) -> Result<Edit, String> {
    let parse = &context.parse;
    let line_end = ladder_analysis::names::declaring::line_end(parse);
    let mut text = format!("    {} : STRUCT{line_end}", group.ty);
    let mut lines: Vec<usize> = group.tags.iter().map(|tag| tag.line).collect();
    lines.dedup();
    for line in lines {
        let own = group
            .tags
            .iter()
            .zip(&group.members)
            .filter(|(tag, _)| tag.line == line);
        let names: Vec<&str> = own.map(|(_, member)| member.as_str()).collect();
        let parts = parts(context, line).ok_or("a declaration cannot be read")?;
        text.extend(["        ", &names.join(", "), &parts.says, line_end]);
    }
    text.extend(["    END_STRUCT;", line_end]);
    let sections = parse.frame().sections.iter();
    let is_types = |line: usize| {
        let words = parse.lines()[line].text().trim_start();
        words
            .get(..4)
            .is_some_and(|word| word.eq_ignore_ascii_case("TYPE"))
    };
    let mut types = sections.filter(|section| section.closed && is_types(section.lines.start));
    if let Some(last) = types.next_back() {
        let at = parse.line_start(last.lines.end - 1);
        return Ok(Edit {
            range: TextRange::empty(at),
            text,
        });
    }
    let line = before_section(context, group.tags[0].section);
    let above = line.checked_sub(1).map(|above| parse.lines()[above].kind);
    let blank = if above.is_some_and(|above| above != LineKind::Blank) {
        line_end
    } else {
        ""
    };
    Ok(Edit {
        range: TextRange::empty(parse.line_start(line)),
        text: format!("{blank}TYPE{line_end}{text}END_TYPE{line_end}{line_end}"),
    })
}

/// The line of a section, or of the block that it is in, or of the comments right above that.
fn before_section(context: &Context, section: usize) -> usize {
    let frame = context.parse.frame();
    let section = &frame.sections[section];
    let line = match section.block {
        Some(block) => frame.blocks[block].lines.start,
        None => section.lines.start,
    };
    let lines = context.parse.lines();
    let above = (0..line)
        .rev()
        .take_while(|line| lines[*line].kind == LineKind::Comment);
    let above = above.count();
    // A comment at the beginning of the file is about all of it.
    if above == line { line } else { line - above }
}
