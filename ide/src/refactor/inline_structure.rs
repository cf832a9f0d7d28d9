//! A tag that is a structure becomes a tag for each of its members: `pump1.run` is `pump1_run`.

use super::declared::{DeclaredTag, is_free, is_inner, parts, replaced, selected, uses};
use super::place::Selected;
use super::scenarios::InScenarios;
use super::{Action, ActionKind};
use crate::symbol::each_node;
use ladder_analysis::context::Context;
use ladder_analysis::values::compound::Compound;
use ladder_analysis::values::types::Type;
use ladder_analysis::written::facts::{Node, NodeKind};
use ladder_analysis::written::type_spec::{MemberSpec, SpecKind};
use ladder_format::Edit;
use ladder_syntax::{Name, TextRange};

pub(super) fn offer(place: &Selected<'_>, out: &mut Vec<Action>) {
    let tags = selected(place.context, place.range);
    let [tag] = tags.as_slice() else { return };
    let Some(ty @ Type::Compound(id)) = tag.tag.ty else {
        return;
    };
    let is_structure = id.with(|ty| matches!(ty, Compound::Structure(_)));
    if !is_structure {
        return;
    }
    let title = format!("Replace `{}` by a tag for each member of `{ty}`", tag.name);
    match inlined(place, tag, ty) {
        Ok((edits, scenarios)) => {
            out.push(Action::new(ActionKind::Inline, title, edits).in_scenarios(scenarios));
        }
        Err(why) => out.push(Action::disabled(ActionKind::Inline, title, why)),
    }
}

fn inlined(
    place: &Selected<'_>,
    tag: &DeclaredTag<'_>,
    ty: Type,
) -> Result<(Vec<Edit>, InScenarios), String> {
    let context = place.context;
    if place.has_errors() {
        return Err("fix the errors of the file first".to_owned());
    }
    is_inner(tag)?;
    let members = members(context, tag, ty)?;
    let mut declarations: Vec<String> = members.iter().map(|member| member.declaration.clone()).collect();
    if let (Some(first), Some(comment)) = (declarations.first_mut(), comment(context, tag)) {
        first.push_str(&comment);
    }
    let mut edits = replaced(context, std::slice::from_ref(tag), &declarations)?;
    for at in uses(context, tag) {
        let (whole, word) = path_at(context, at)
            .ok_or_else(|| format!("`{}` is used as a whole {}", tag.name, place_of(context, at)))?;
        let key = Name::new(&word);
        let member = members.iter().find(|member| member.key == key);
        let new = member
            .ok_or_else(|| format!("`{word}` is not known"))?
            .name
            .clone();
        edits.push(Edit {
            range: whole,
            text: new,
        });
    }
    let members = members.into_iter().map(|member| (member.key, member.name));
    Ok((edits, InScenarios::Members(tag.symbol.clone(), members.collect())))
}

/// The comment on a tag that has a declaration of its own: the blanks and comments after it.
fn comment(context: &Context, tag: &DeclaredTag<'_>) -> Option<String> {
    let parts = parts(context, tag.line).filter(|parts| parts.names.len() == 1)?;
    let (_, comment) = parts.says.split_once('#')?;
    let before = &parts.says[..parts.says.len() - comment.len() - 1];
    let declared = before.rfind(';')? + 1;
    Some(parts.says[declared..].to_owned())
}

fn place_of(context: &Context, at: TextRange) -> String {
    format!("on line {}", context.line_number(at.start()))
}

/// A member, and the tag that it becomes.
struct Member {
    key: Name,
    name: String,
    /// `pump1_run : BOOL;`
    declaration: String,
}

fn members(context: &Context, tag: &DeclaredTag<'_>, ty: Type) -> Result<Vec<Member>, String> {
    let name = ty.to_string();
    let found = context.types.find(&name).ok_or("its type is not known")?;
    if found.file.is_some() {
        return Err(format!("`{name}` is declared in another file"));
    }
    let SpecKind::Structure(specs) = &found.declaration.declared.spec.kind else {
        return Err(format!("`{name}` is not a structure"));
    };
    if found.declaration.declared.initial.is_some() {
        return Err(format!(
            "`{name}` has values at the start of its own: write those of the tag first"
        ));
    }
    let declared = tag.tag.cold.declared.as_ref();
    let initial = declared.and_then(|declared| declared.initial.as_ref());
    let given = match initial.map(|initial| (&initial.node.kind, initial.start)) {
        None => Vec::new(),
        Some((NodeKind::Members(values), start)) => values
            .iter()
            .map(|(word, value)| (Name::new(&word.text), value.range + start))
            .collect(),
        Some(_) => return Err("its value at the start cannot be read".to_owned()),
    };
    let mut members: Vec<Member> = Vec::new();
    for spec in specs {
        let new = format!("{}_{}", tag.name, spec.name);
        if !is_free(context, &Name::new(&new)) {
            return Err(format!("there is a tag `{new}` already"));
        }
        let key = Name::new(&spec.name);
        let value = given
            .iter()
            .find(|(name, _)| *name == key)
            .map(|(_, range)| *range);
        members.push(Member {
            declaration: declaration(context, spec, &new, value),
            key,
            name: new,
        });
    }
    Ok(members)
}

fn declaration(context: &Context, spec: &MemberSpec, name: &str, given: Option<TextRange>) -> String {
    let text = |range| context.parse.text_in(range).to_string();
    let own = spec.declared.initial.as_ref();
    let value = given.or_else(|| own.map(|initial| initial.node.range + initial.start));
    let value = value.map_or_else(String::new, |value| format!(" := {}", text(value)));
    format!("{name} : {}{value};", text(spec.declared.spec.range))
}

/// The path that begins at a use of a tag, up to its first member, and that. None: the tag is used as a whole.
fn path_at(context: &Context, at: TextRange) -> Option<(TextRange, String)> {
    let line = context.parse.line_at(at.start())?;
    let network = context.networks.on_line(line)?;
    for block in network.blocks() {
        for operand in &block.facts.operands {
            let mut found = None;
            each_node(&operand.value, &mut |node: &Node| {
                if let NodeKind::Member(base, word) = &node.kind
                    && matches!(base.kind, NodeKind::Name(_))
                    && block.absolute(base.range) == at
                {
                    found = Some((block.absolute(node.range), word.text.to_string()));
                }
            });
            if found.is_some() {
                return found;
            }
        }
    }
    None
}
