//! Definitions of user-defined blocks: name, shape, parameters (LANGUAGE §5.7).

use crate::others::Import;
use crate::program::ParameterKind;
use crate::scope::{Origin, Scope, SectionKind};
use crate::types::Type;
use crate::unread_line::looks_like_declaration;
use ladder_instructions::Shape;
use ladder_syntax::ast::{AstNode, BlockHeader, BlockShape, HeadName};
use ladder_syntax::{BlockDefinition, Line, LineKind, Name, Parse, TextRange};
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

/// A block definition as its header and declarations give it.
#[derive(Debug, Clone)]
pub struct UserBlockFacts {
    /// As written, with the `$`.
    pub name: String,
    /// As it is compared.
    pub key: Name,
    /// The shape that the header shows.
    pub shape: Shape,
    /// Where the header's first part is.
    pub at: TextRange,
    /// Its header or a declaration could not be read: its operands are not all known.
    pub doubtful: bool,
    /// The operands in the order of their declaration.
    pub parameters: Vec<Parameter>,
    /// Where it is defined, if in another file. Its places are those of that file.
    pub import: Option<Import>,
}

impl UserBlockFacts {
    /// The file that defines it, if it is another one.
    pub fn file(&self) -> Option<&Arc<str>> {
        self.import.as_ref().map(|import| &import.file)
    }

    /// Whether a caller sees no difference.
    pub(crate) fn looks_like(&self, other: &UserBlockFacts) -> bool {
        let parameters = self.parameters.iter().zip(&other.parameters);
        (&self.name, self.shape, self.doubtful, self.parameters.len())
            == (&other.name, other.shape, other.doubtful, other.parameters.len())
            && parameters.into_iter().all(|(a, b)| a == b)
    }
}

/// A number that stands for what callers see of a file's blocks.
pub(crate) fn signatures(blocks: &[UserBlockFacts]) -> u64 {
    let mut hasher = FxHasher::default();
    for block in blocks {
        (&block.name, block.shape, block.doubtful, &block.parameters).hash(&mut hasher);
    }
    hasher.finish()
}

/// A parameter of a user-defined block.
#[derive(Debug, Clone, PartialEq, Hash)]
pub struct Parameter {
    /// As declared.
    pub name: String,
    /// As it is compared.
    pub key: Name,
    /// Its type; none if that cannot be read.
    pub ty: Option<Type>,
    /// The tag in the body's scope.
    pub tag: usize,
    /// How it is passed.
    pub kind: ParameterKind,
    /// It may be left out.
    pub has_default: bool,
}

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
                tag,
                kind,
                has_default: !facts.rare.initial.is_empty(),
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
        import: None,
    }
}

/// Whether a line may have been a declaration that could not be read.
pub(crate) fn is_doubtful(line: &Line) -> bool {
    let mistaken = line.kind == LineKind::Stray || !line.errors.is_empty();
    mistaken && (line.kind != LineKind::Rung || looks_like_declaration(line))
}
