//! Declarations: from sections to the tags of a scope (LANGUAGE §4).

use super::problem::NameProblem;
use crate::names::cold::{Cold, ColdFacts};
use crate::names::did_you_mean;
use crate::names::scope::{Origin, Scope, SectionKind, TagFacts, type_by_form};
use crate::networks::facts;
use crate::networks::reading::TOGETHER;
use crate::networks::use_place::Uses;
use crate::program::Role;
use crate::still_wanted::StillWanted;
use crate::values::constant;
use crate::values::types::{Scalar, Type};
use ladder_instructions::StateType;
use ladder_syntax::ast::{AstNode, Declaration, NodeView, SectionHeader, TypeRef};
use ladder_syntax::rowan::GreenNode;
use ladder_syntax::{
    Line, LineKind, Name, Parse, Section, TextRange, TextSize, Trees, is_declaration_keyword, is_reserved,
};

/// The longest array: what still shows and saves quickly.
const MAX_ELEMENTS: i128 = 1_000_000;
/// The longest STRING.
const MAX_STRING: i128 = 32_767;

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

/// Adds the tags of a section to its scope. None if that is not wanted any longer.
pub(crate) fn section(
    parse: &Parse,
    section: &Section,
    scope: &mut Scope,
    out: &mut Vec<NameProblem>,
    wanted: &StillWanted<'_>,
) -> Option<()> {
    let mut trees = Trees::default();
    let Some(around) = around(parse, section) else {
        return Some(());
    };
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
            wanted.one_more()?;
            let found = out.len();
            if let Some(node) = Declaration::cast(NodeView::root(&tree)) {
                declaration(&node, start, around, scope, out);
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

/// Adds the tags of a declaration, whose line starts here. What is wrong with it goes to `out`.
fn declaration(
    node: &Declaration,
    start: TextSize,
    context: Around,
    scope: &mut Scope,
    out: &mut Vec<NameProblem>,
) {
    let meaningless = |range: TextRange, message: String| NameProblem::Meaningless(range + start, message);
    // Where the type cannot be read the tag is declared all the same, and its places say its type: one error.
    let ty = match node.type_ref().map(|type_ref| declared_type(&type_ref)) {
        Some(Ok(ty)) => ty,
        Some(Err((range, message))) => {
            out.push(meaningless(range, message));
            None
        }
        None => None,
    };
    let address = node.address();
    if let Some(token) = &address
        && let Some(message) = refused_address(context)
    {
        out.push(meaningless(token.text_range(), message.to_owned()));
    }
    let address = address.filter(|_| refused_address(context).is_none());
    let mut initial = Vec::new();
    if let (Some(value), Some(ty)) = (node.initial_value(), ty) {
        match constant::initial_values(&facts::node(&value), ty) {
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
    for name in node.names() {
        let range = name.text_range();
        if let Some(message) = refused_name(name.text(), context.in_block) {
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

/// Why a name may not be declared.
fn refused_name(text: &str, in_block: bool) -> Option<String> {
    if is_reserved(text) || is_declaration_keyword(text) {
        return Some(format!("`{text}` is a word of the language: choose another name"));
    }
    if in_block && (text.eq_ignore_ascii_case("EN") || text.eq_ignore_ascii_case("ENO")) {
        return Some(format!("a block has `{text}` of its own: choose another name"));
    }
    None
}

/// The types that are likeliest meant come first.
const TYPE_NAMES: [&str; 31] = [
    "BOOL", "INT", "DINT", "REAL", "TIME", "STRING", "WORD", "BYTE", "DWORD", "LWORD", "SINT", "LINT",
    "USINT", "UINT", "UDINT", "ULINT", "LREAL", "DATE", "TOD", "DT", "TON", "TOF", "TP", "RTO", "RTOF",
    "CTU", "CTD", "CTUD", "CTC", "SR", "RS",
];

type TypeProblem = (TextRange, String);

/// The type that a declaration names. `Ok(None)`: the parser said what is wrong.
fn declared_type(type_ref: &TypeRef) -> Result<Option<Type>, TypeProblem> {
    let Some(name) = type_ref.name() else {
        return Ok(None);
    };
    let mut numbers = Vec::new();
    for (negative, token) in type_ref.numbers() {
        match crate::values::literal::literal(token.text()) {
            Ok(crate::values::literal::Literal::Int(n)) => numbers.push(if negative { -n } else { n }),
            _ => {
                return Err((
                    token.text_range(),
                    format!("`{}` is not a whole number", token.text()),
                ));
            }
        }
    }
    let mut numbers = numbers.into_iter();
    let bounds = if type_ref.is_array() {
        numbers.next().zip(numbers.next())
    } else {
        None
    };
    if type_ref.is_array() && bounds.is_none() {
        return Ok(None);
    }
    let scalar = match Scalar::from_name(name.text()) {
        Some(Scalar::String(default)) => {
            let length = numbers.next().unwrap_or(i128::from(default));
            if !(1..=MAX_STRING).contains(&length) {
                return Err((
                    type_ref.range(),
                    format!("a STRING holds 1 to {MAX_STRING} characters"),
                ));
            }
            Some(Scalar::String(length as u16))
        }
        other => other,
    };
    if let Some((first, last)) = bounds {
        let Some(element) = scalar else {
            return Err((
                name.text_range(),
                format!("an array holds elementary types, `{}` is none", name.text()),
            ));
        };
        if last < first {
            return Err((
                type_ref.range(),
                format!("the last index {last} is below the first {first}: swap them"),
            ));
        }
        if last - first >= MAX_ELEMENTS || first < -i128::from(i32::MAX) || last > i128::from(i32::MAX) {
            return Err((
                type_ref.range(),
                format!("an array has at most {MAX_ELEMENTS} elements"),
            ));
        }
        return Ok(Some(Type::Array {
            first: first as i64,
            last: last as i64,
            element,
        }));
    }
    if let Some(scalar) = scalar {
        return Ok(Some(Type::Scalar(scalar)));
    }
    match StateType::ALL
        .into_iter()
        .find(|state| state.name().eq_ignore_ascii_case(name.text()))
    {
        Some(state) => Ok(Some(Type::State(state))),
        None => {
            let near = did_you_mean::closest(name.text(), TYPE_NAMES.into_iter());
            let near = near.unwrap_or("DINT, BOOL or REAL");
            let message = format!("there is no type `{}`: did you mean {near}?", name.text());
            Err((name.text_range(), message))
        }
    }
}
