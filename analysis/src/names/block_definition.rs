//! From the definition of a user-defined block to what its callers see (LANGUAGE §5.7).

use super::scope::{Origin, Scope, SectionKind};
use super::unread_body::unread;
use crate::networks::unread_line::looks_like_declaration;
use crate::program::ParameterKind;
use crate::written::user_block::{Parameter, UserBlockFacts};
use ladder_instructions::Shape;
use ladder_syntax::ast::{AstNode, BlockHeader, BlockShape, HeadName};
use ladder_syntax::{BlockDefinition, Line, LineKind, Name, Parse};

/// The facts of a definition; `scope` is its body's, with its declarations. A header
/// that names no block gives a name that nothing can call.
pub(crate) fn user_block(parse: &Parse, definition: &BlockDefinition, scope: &Scope) -> UserBlockFacts {
    let header_line = definition.lines.start;
    let start = parse.line_start(header_line);
    let head = BlockHeader::cast(parse.lines()[header_line].view()).and_then(|header| header.head());
    let (name, shape, at) = match head {
        Some(head) => {
            let shape = match head.shape() {
                BlockShape::Logical => Shape::Logical,
                BlockShape::Coil => Shape::Coil,
                BlockShape::Function => Shape::Function,
            };
            let name = match head.name() {
                HeadName::User(token) => token.text().to_owned(),
                _ => String::new(),
            };
            (name, shape, head.range() + start)
        }
        None => (String::new(), Shape::Logical, parse.line_range(header_line)),
    };
    let parameters = scope
        .tags
        .iter()
        .enumerate()
        .filter_map(|(tag, facts)| {
            let kind = match facts.origin {
                Origin::Declared(SectionKind::Input) => ParameterKind::Input,
                Origin::Declared(SectionKind::Output) => ParameterKind::Output,
                Origin::Declared(SectionKind::InOut) => ParameterKind::InOut,
                _ => return None,
            };
            Some(Parameter {
                name: facts.name.to_string(),
                key: Name::new(&facts.name),
                ty: facts.ty.filter(|_| !facts.mistyped),
                declared: facts.cold.declared.clone(),
                tag,
                kind,
                has_default: !facts.cold.initial.is_empty(),
            })
        })
        .collect();
    UserBlockFacts {
        key: Name::new(&name),
        doubtful: parse.lines().range(definition.lines.clone()).any(is_doubtful),
        name,
        shape,
        at,
        parameters,
        unread: unread(parse, definition),
        import: None,
    }
}

/// Whether a line may have been a declaration that could not be read.
fn is_doubtful(line: &Line) -> bool {
    let faulty = line.kind == LineKind::Stray || !line.errors.is_empty();
    faulty && (line.kind != LineKind::Rung || looks_like_declaration(line))
}
