//! Declarations: from sections to the tags of a scope (LANGUAGE §4).

use super::named_types::NamedTypes;
use super::problem::NameProblem;
use crate::cancel::Cancel;
use crate::names::cold::{Cold, ColdFacts};
use crate::names::scope::{Origin, Scope, SectionKind, TagFacts, type_by_form};
use crate::networks::reading::TOGETHER;
use crate::networks::use_place::Uses;
use crate::program::Role;
use crate::written::constant;
use crate::written::facts;
use crate::written::refused_name::{Place, refused_name};
use crate::written::type_spec::{self, Constants, Declared, Initial, TypeSpec};
use ladder_syntax::ast::{AstNode, Declaration, NodeView, SectionHeader};
use ladder_syntax::rowan::GreenNode;
use ladder_syntax::{Line, LineKind, Name, Parse, Section, TextRange, TextSize, Trees};
use std::sync::Arc;

/// What a section's first line says of the declarations in it; none if it cannot be read.
fn around(parse: &Parse, section: &Section) -> Option<Around> {
    let header = parse.lines()[section.lines.start].tree();
    let header = SectionHeader::cast(NodeView::root(&header))?;
    let kind = SectionKind::from_keyword(header.section()?.text())?;
    let has = |word: &str| {
        header
            .qualifiers()
            .any(|token| token.text().eq_ignore_ascii_case(word))
    };
    Some(Around {
        kind,
        retain: has("RETAIN"),
        constant: has("CONSTANT"),
        in_block: section.block.is_some(),
    })
}

/// About how many names the declarations of a section have, by the commas before their types. A line of nothing but commas
/// does not take all memory.
pub(crate) fn names_about(parse: &Parse, section: &Section) -> usize {
    const MOST_COUNTED: usize = 15;
    let lines = parse.lines().range(section.lines.clone());
    let declarations = lines.filter(|line| line.kind == LineKind::Declaration);
    let names = |line: &Line| {
        let before_type = line.text().bytes().take_while(|byte| *byte != b':');
        1 + before_type
            .filter(|byte| *byte == b',')
            .take(MOST_COUNTED)
            .count()
    };
    declarations.map(names).sum()
}

/// Adds the tags of a section to its scope. None if that is cancelled.
pub(crate) fn section(
    parse: &Parse,
    section: &Section,
    scope: &mut Scope,
    (named, constants): (&mut NamedTypes, &Constants),
    out: &mut Vec<NameProblem>,
    cancel: &Cancel,
) -> Option<()> {
    let mut trees = Trees::default();
    let Some(around) = around(parse, section) else {
        return Some(());
    };
    if around.kind == SectionKind::InOut && !around.in_block {
        out.push(NameProblem::InOutsOfProgram(
            parse.line_range(section.lines.start),
        ));
    }
    let mut start = parse.line_start(section.lines.start);
    let mut together: Vec<(&Line, TextSize, GreenNode)> = Vec::with_capacity(TOGETHER);
    let mut lines = parse.lines().range(section.lines.clone());
    loop {
        for line in lines.by_ref() {
            if line.kind == LineKind::Declaration {
                together.push((line, start, trees.of(line)));
            }
            start += TextSize::new(line.len);
            if together.len() == TOGETHER {
                break;
            }
        }
        if together.is_empty() {
            return Some(());
        }
        for (line, start, tree) in together.drain(..) {
            cancel.one_more()?;
            let found = out.len();
            if let Some(node) = Declaration::cast(NodeView::root(&tree)) {
                let mut types = Types {
                    named: &mut *named,
                    constants,
                    line,
                };
                declaration(&node, start, around, &mut types, scope, out);
            }
            // What the parser has to say about the line is enough.
            if !line.errors.is_empty() {
                out.truncate(found);
            }
        }
    }
}

/// What the section says of a declaration.
#[derive(Debug, Clone, Copy)]
struct Around {
    kind: SectionKind,
    retain: bool,
    constant: bool,
    in_block: bool,
}

/// What is known of types where a declaration is read.
struct Types<'t> {
    named: &'t mut NamedTypes,
    constants: &'t Constants,
    /// The line of the declaration.
    line: &'t Line,
}

/// Adds the tags of a declaration, whose line starts here. What is wrong with it goes to `out`.
fn declaration(
    node: &Declaration,
    start: TextSize,
    context: Around,
    types: &mut Types<'_>,
    scope: &mut Scope,
    out: &mut Vec<NameProblem>,
) {
    let meaningless = |range: TextRange, message: String| NameProblem::Meaningless(range + start, message);
    // Where the type cannot be read the tag is declared all the same, and its places say its type: one error.
    let mut problems = Vec::new();
    let type_ref = node.type_ref();
    let spec =
        type_ref.and_then(|type_ref| type_spec::read(&type_ref, start, types.constants, &mut problems));
    let problems = problems.into_iter();
    out.extend(problems.map(|(range, message)| meaningless(range, message)));
    let known = spec.as_ref().and_then(TypeSpec::known);
    // What is not known by itself crosses files as it is written.
    let declared = spec.filter(|_| known.is_none()).map(|spec| {
        let initial = node.initial_value();
        let initial = initial.map(|value| Initial::new(&value, start, types.line.text()));
        Arc::new(Declared { spec, initial })
    });
    let meaning = declared
        .as_ref()
        .and_then(|declared| types.named.meaning(declared, out));
    let ty = known.or(meaning.as_ref().map(|(ty, _)| *ty));
    let address = node.address();
    if let Some(token) = &address
        && let Some(message) = refused_address(context)
    {
        out.push(meaningless(token.text_range(), message.to_owned()));
    }
    let address = address.filter(|_| refused_address(context).is_none());
    let mut initial = Vec::new();
    if let Some((_, Some(values))) = meaning {
        initial = values.to_vec();
    } else if let (Some(value), Some(ty)) = (node.initial_value(), known) {
        match constant::initial_values(&facts::node(&value), ty, None) {
            Ok(values) => initial = values,
            Err(problem) => out.push(NameProblem::InitialValue(problem.moved_by(start))),
        }
    }
    let mut address_role = None;
    if let (Some(token), Some(ty)) = (&address, ty) {
        match type_by_form(token.text()) {
            None => out.push(meaningless(
                token.text_range(),
                format!(
                    "`{}` is not an address: write one like %IX0.0, %QW1 or %MD2",
                    token.text()
                ),
            )),
            Some((of_address, role)) => {
                address_role = Some(role);
                if ty
                    .scalar()
                    .is_none_or(|scalar| scalar.width() != of_address.width())
                {
                    out.push(meaningless(
                        token.text_range(),
                        format!("`{}` has the size of {of_address}, the tag is {ty}", token.text()),
                    ));
                }
            }
        }
    }
    let place = if context.in_block {
        Place::BlockTag
    } else {
        Place::Tag
    };
    for name in node.names() {
        let range = name.text_range();
        if let Some(message) = refused_name(name.text(), place) {
            out.push(meaningless(range, message));
            continue;
        }
        let key = Name::new(name.text());
        if let Some(first) = scope.find(&key) {
            let known = &scope.tags[first];
            out.push(NameProblem::Twice {
                name: name.text().into(),
                at: range + start,
                first: known.name.clone(),
                first_at: known.declared_at,
            });
            let alike = (known.ty, known.constant) == (ty, context.constant);
            // Which of the two its places mean is open.
            if !alike || known.origin != Origin::Declared(context.kind) {
                scope.tags[first].mistyped = true;
            }
            continue;
        }
        let tag = TagFacts {
            name: name.text().into(),
            ty,
            mistyped: ty.is_none(),
            role: role(context.kind, address_role),
            origin: Origin::Declared(context.kind),
            retain: context.retain,
            constant: context.constant,
            cold: Cold::from(ColdFacts {
                initial: initial.clone(),
                address: address.as_ref().map(|token| token.text().into()),
                declared: declared.clone(),
                ..ColdFacts::NONE
            }),
            declared_at: range + start,
            uses: Uses::default(),
        };
        let index = scope.declare(key, tag);
        // An address is one tag of the file; what a body declares belongs to each place of the block.
        if let Some(token) = address.as_ref().filter(|_| !context.in_block) {
            scope.find_by_address(token.text(), index);
        }
    }
}

fn role(kind: SectionKind, address: Option<Role>) -> Role {
    match kind {
        SectionKind::Input => Role::Input,
        SectionKind::Output => Role::Output,
        _ => address.unwrap_or(Role::Internal),
    }
}

/// Why a declaration may not have an address.
fn refused_address(context: Around) -> Option<&'static str> {
    let is_parameter = matches!(context.kind, SectionKind::Input | SectionKind::Output) && context.in_block;
    if is_parameter || context.kind == SectionKind::InOut {
        return Some(
            "an operand of a block is given where the block is: take AT away, or declare the tag in VAR",
        );
    }
    (context.kind == SectionKind::External)
        .then_some("VAR_EXTERNAL names a global that is declared elsewhere, with its address: take AT away")
}
