//! Selected blocks become a user-defined block. Its power goes in as `EN` and out as `ENO`, so that it is where they
//! were; the tags that they use become its operands: those that are only read as inputs, all others by reference.

use super::flow::is_flow;
use super::names::new_block;
use super::place::{OnNetwork, Selected};
use super::{Action, ActionKind};
use crate::drawing::item::Item;
use crate::drawing::region::Region;
use crate::drawing::rows::{Drawing, lines_text};
use ladder_analysis::context::Context;
use ladder_analysis::names::declaring::line_end;
use ladder_analysis::names::scope::{Origin, SectionKind, TagFacts};
use ladder_analysis::networks::use_place::Use;
use ladder_analysis::values::types::Type;
use ladder_format::Edit;
use ladder_instructions::Op;
use ladder_syntax::TextRange;

/// An operand of the new block.
struct Parameter {
    section: SectionKind,
    name: String,
    ty: Type,
}

pub(super) fn offer(place: &Selected<'_>, out: &mut Vec<Action>) {
    let Some(on) = place.on.as_ref().filter(|_| !place.range.is_empty()) else {
        return;
    };
    let Some(region) = on.region() else { return };
    let name = new_block(place.context);
    let title = format!("Extract the selected blocks into the block `[{name}]`");
    match extracted(place.context, on, &region, &name) {
        Ok(edits) => out.push(Action::new(ActionKind::Extract, title, edits).making_up(name)),
        Err(why) => out.push(Action::disabled(ActionKind::Extract, title, why)),
    }
}

fn extracted(
    context: &Context,
    on: &OnNetwork<'_>,
    region: &Region,
    name: &str,
) -> Result<Vec<Edit>, String> {
    let drawing = &on.drawing;
    let structure = context.parse.structure();
    if structure.blocks.iter().any(|block| !block.closed)
        || structure.sections.iter().any(|section| !section.closed)
    {
        return Err("a section or block above is not closed".to_owned());
    }
    if !region.is_evaluated_at_once(drawing) {
        return Err("other blocks are run between the selected ones".to_owned());
    }
    let numbers = region.blocks(drawing);
    for block in on.blocks(&numbers) {
        let retentive = matches!(
            block.op(),
            Some(Op::RetentiveCoil | Op::RetentiveSet | Op::RetentiveReset | Op::Persist)
        );
        if is_flow(&block) {
            return Err(format!("{} works only where it is", block.head_text()));
        }
        if retentive {
            return Err(format!(
                "{} makes a tag of the program retentive",
                block.head_text()
            ));
        }
        if block.faulty || block.instruction().is_none() && block.user_name().is_none() {
            return Err(format!("{} is not known", block.head_text()));
        }
    }
    let parameters = parameters(context, on, &numbers)?;
    let mut body = drawing.with_rows(region.copy(drawing));
    let top = &mut body.rows[0].items;
    if let Some(first) = top.first_mut() {
        first.joined = true;
    }
    top.splice(0..0, [Item::left_rail(), Item::block("[ ]( EN )")]);
    top.extend([Item::block("( )( ENO )"), Item::right_rail()]);
    let definition = definition(context, name, &parameters, &body);
    let operands: Vec<&str> = parameters
        .iter()
        .map(|parameter| parameter.name.as_str())
        .collect();
    let call = match operands.as_slice() {
        [] => format!("[{name}]"),
        _ => format!("[{name}]( {} )", operands.join(", ")),
    };
    let mut caller = drawing.clone();
    let mut call = Item::block(call);
    call.joined = drawing.rows[region.top].items[region.on_top().start].joined;
    region.replace(&mut caller, vec![call]);
    let parse = &context.parse;
    let end = parse.text_len();
    let line_end = line_end(parse);
    let last = lines_text(parse, parse.lines().len() - 1..parse.lines().len());
    let closed = last.ends_with(['\n', '\r']);
    let before = if closed { "" } else { line_end };
    Ok(vec![
        caller.replace(),
        Edit {
            range: TextRange::empty(end),
            text: format!("{before}{line_end}{definition}"),
        },
    ])
}

/// What the blocks use of the tags that a body does not see.
fn parameters(context: &Context, on: &OnNetwork<'_>, blocks: &[usize]) -> Result<Vec<Parameter>, String> {
    let scope = &context.scopes[on.facts.scope];
    let mut parameters = Vec::new();
    for tag in &scope.tags {
        let uses: Vec<Use> = uses_in(context, tag)
            .filter(|place| place.network == on.network && blocks.contains(&place.block))
            .collect();
        if uses.is_empty() || is_seen_everywhere(tag) {
            continue;
        }
        let name = &tag.name;
        if tag.origin == Origin::Implicit
            || name.eq_ignore_ascii_case("EN")
            || name.eq_ignore_ascii_case("ENO")
        {
            return Err(format!("`{name}` means something else in a block of its own"));
        }
        let ty = tag
            .ty
            .filter(|_| !tag.mistyped)
            .ok_or_else(|| format!("the type of `{name}` is not known"))?;
        if keeps_block(ty) {
            return Err(format!(
                "`{name}` keeps the state of a block, which stays where it is"
            ));
        }
        let read_only = uses.iter().all(|place| !place.access.writes());
        let section = match ty {
            Type::Scalar(_) if read_only => SectionKind::Input,
            _ if tag.constant => return Err(format!("the constant `{name}` cannot go by reference")),
            Type::Scalar(_) if uses.iter().all(|place| is_coil(on, place)) => SectionKind::Output,
            _ => SectionKind::InOut,
        };
        parameters.push(Parameter {
            section,
            name: name.to_string(),
            ty,
        });
    }
    parameters.sort_by_key(|parameter| match parameter.section {
        SectionKind::Input => 0,
        SectionKind::InOut => 1,
        _ => 2,
    });
    Ok(parameters)
}

/// Whether the state of a user-defined block is in a tag of a type.
fn keeps_block(ty: Type) -> bool {
    let is_block = |ty: Type| matches!(ty, Type::Compound(id) if id.block().is_some());
    ty.keeps_state() && ty.column_list().iter().any(|column| is_block(column.ty))
}

/// A shared tag counts the uses in all scopes; an alias of it, its own.
fn uses_in<'c>(context: &'c Context, tag: &'c TagFacts) -> impl Iterator<Item = Use> {
    context.uses(context.shared(tag))
}

/// Global tags and direct addresses are the same in every body.
fn is_seen_everywhere(tag: &TagFacts) -> bool {
    tag.is_alias()
        || tag.cold.foreign.is_some()
        || matches!(
            tag.origin,
            Origin::Declared(SectionKind::Global | SectionKind::External) | Origin::Shared
        )
        || (tag.origin == Origin::Form && tag.cold.address.is_some())
}

/// Whether the tag is all that a plain coil writes, which it does in every scan: what the block hands out at its end is
/// what the coil has written.
fn is_coil(on: &OnNetwork<'_>, place: &Use) -> bool {
    let block = on.facts.block(place.block);
    place.whole
        && matches!(block.op(), Some(Op::Coil | Op::NegatedCoil))
        && !place.indexed
        && !place.access.reads()
}

fn definition(context: &Context, name: &str, parameters: &[Parameter], body: &Drawing) -> String {
    let line_end = line_end(&context.parse);
    let mut text = format!("FUNCTION_BLOCK [{name}]{line_end}");
    for section in [SectionKind::Input, SectionKind::InOut, SectionKind::Output] {
        let own = parameters.iter().filter(|parameter| parameter.section == section);
        let mut declarations = String::new();
        for parameter in own {
            let ty = parameter.ty.to_string();
            declarations.extend(["    ", &parameter.name, " : ", &ty, ";", line_end]);
        }
        if !declarations.is_empty() {
            text.extend([section.keyword(), line_end, &declarations, "END_VAR", line_end]);
        }
    }
    text.extend([&body.text(), line_end, "END_FUNCTION_BLOCK", line_end]);
    text
}
