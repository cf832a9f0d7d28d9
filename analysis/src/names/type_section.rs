//! Sections of types: what they declare, as they write it.

use super::problem::NameProblem;
use crate::values::literal::Literal;
use crate::written::refused_name::{Place, refused_name};
use crate::written::type_spec::{
    self, Constants, Declared, DeclaredType, Initial, MemberSpec, SpecKind, TypeSpec,
};
use ladder_syntax::ast::{AstNode, Declaration, NodeView, SectionHeader, StructEnd, StructHeader, TokenView};
use ladder_syntax::{Line, LineKind, Name, Parse, Section, TextRange, TextSize};
use smol_str::SmolStr;
use std::sync::Arc;

/// Whether a section declares types.
pub fn is_of_types(parse: &Parse, section: &Section) -> bool {
    let tree = parse.lines()[section.lines.start].tree();
    let header = SectionHeader::cast(NodeView::root(&tree)).and_then(|header| header.section());
    header.is_some_and(|keyword| keyword.text().eq_ignore_ascii_case("TYPE"))
}

/// The types of a section.
pub(crate) fn types(
    parse: &Parse,
    section: &Section,
    constants: &Constants,
    types: &mut Vec<DeclaredType>,
    out: &mut Vec<NameProblem>,
) {
    let mut start = parse.line_start(section.lines.start);
    // The structure that is open.
    let mut open: Option<Open> = None;
    for line in parse.lines().range(section.lines.clone()) {
        let at = start;
        start += TextSize::new(line.len);
        let found = out.len();
        let tree = line.tree();
        let node = NodeView::root(&tree);
        let reader = Reader { line, at, constants };
        match line.kind {
            LineKind::StructHeader => {
                if let Some(header) = StructHeader::cast(node) {
                    open = reader
                        .name_of_type(header.names(), out)
                        .map(|(name, range)| Open {
                            name,
                            at: range,
                            range: line_range(line, at),
                            members: Vec::new(),
                            is_whole: true,
                        });
                }
            }
            LineKind::StructEnd => {
                let initial = StructEnd::cast(node).and_then(|end| end.initial_value());
                let initial = initial.map(|value| Initial::new(&value, at, line.text()));
                if let Some(open) = open.take() {
                    finish(open, initial, types, out);
                }
            }
            LineKind::Declaration => {
                let Some(declaration) = Declaration::cast(node) else {
                    continue;
                };
                let declared = reader.declared(&declaration, out);
                if let Some(open) = &mut open {
                    open.is_whole &= declared.is_some() && line.errors.is_empty();
                    let declared = declared.unwrap_or_else(|| reader.unread());
                    for name in declaration.names() {
                        open.member(&name, at, &declared, out);
                    }
                } else if let (Some((name, range)), Some(declared)) =
                    (reader.name_of_type(declaration.names(), out), declared)
                {
                    types.push(DeclaredType {
                        key: Name::new(&name),
                        name,
                        at: range,
                        declared: Arc::new(declared),
                    });
                }
            }
            _ => {}
        }
        // What the parser has to say about the line is enough.
        if !line.errors.is_empty() {
            out.truncate(found);
        }
    }
    if let Some(open) = open {
        finish(open, None, types, out);
    }
}

fn line_range(line: &Line, at: TextSize) -> TextRange {
    TextRange::at(at, TextSize::new(line.len))
}

/// A structure whose members are being read.
struct Open {
    name: SmolStr,
    at: TextRange,
    range: TextRange,
    members: Vec<MemberSpec>,
    /// All of them could be read.
    is_whole: bool,
}

impl Open {
    fn member(
        &mut self,
        name: &TokenView<'_>,
        start: TextSize,
        declared: &Declared,
        out: &mut Vec<NameProblem>,
    ) {
        let at = name.text_range() + start;
        if let Some(message) = refused_name(name.text(), Place::Member) {
            self.is_whole = false;
            out.push(NameProblem::Meaningless(at, message));
            return;
        }
        let key = Name::new(name.text());
        if let Some(first) = self.members.iter().find(|member| Name::new(&member.name) == key) {
            out.push(NameProblem::Twice {
                name: name.text().into(),
                at,
                first: first.name.clone(),
                first_at: first.at,
            });
            return;
        }
        self.members.push(MemberSpec {
            name: name.text().into(),
            at,
            declared: declared.clone(),
        });
    }
}

fn finish(open: Open, initial: Option<Initial>, types: &mut Vec<DeclaredType>, out: &mut Vec<NameProblem>) {
    if open.members.is_empty() && open.is_whole {
        let message = format!("`{}` has no members: a structure has at least one", open.name);
        out.push(NameProblem::Meaningless(open.at, message));
    }
    let spec = TypeSpec {
        kind: SpecKind::Structure(open.members),
        range: open.range,
    };
    types.push(DeclaredType {
        key: Name::new(&open.name),
        name: open.name,
        at: open.at,
        declared: Arc::new(Declared { spec, initial }),
    });
}

/// A line of a section of types.
struct Reader<'l> {
    line: &'l Line,
    at: TextSize,
    constants: &'l Constants,
}

impl Reader<'_> {
    /// The name of the type that a line declares.
    fn name_of_type<'g>(
        &self,
        mut names: impl Iterator<Item = TokenView<'g>>,
        out: &mut Vec<NameProblem>,
    ) -> Option<(SmolStr, TextRange)> {
        let name = names.next()?;
        let range = name.text_range() + self.at;
        if let Some(second) = names.next() {
            let message = format!(
                "a type is declared by itself: write `{}` on a line of its own",
                second.text()
            );
            out.push(NameProblem::Meaningless(second.text_range() + self.at, message));
        }
        if let Some(message) = refused_name(name.text(), Place::Type) {
            out.push(NameProblem::Meaningless(range, message));
            return None;
        }
        Some((name.text().into(), range))
    }

    /// What a member is of which that cannot be read: it is there all the same.
    fn unread(&self) -> Declared {
        let spec = TypeSpec {
            kind: SpecKind::Unread,
            range: line_range(self.line, self.at),
        };
        Declared { spec, initial: None }
    }

    /// The type and value of a declaration.
    fn declared(&self, declaration: &Declaration<'_>, out: &mut Vec<NameProblem>) -> Option<Declared> {
        if let Some(address) = declaration.address() {
            let message = "a type and its members have no address: declare the tag there with AT";
            out.push(NameProblem::Meaningless(
                address.text_range() + self.at,
                message.to_owned(),
            ));
        }
        let mut problems = Vec::new();
        let spec = type_spec::read(&declaration.type_ref()?, self.at, self.constants, &mut problems);
        let problems = problems.into_iter();
        out.extend(problems.map(|(range, message)| NameProblem::Meaningless(range + self.at, message)));
        let spec = spec?;
        let initial = declaration.initial_value();
        let initial = initial.map(|value| Initial::new(&value, self.at, self.line.text()));
        Some(Declared { spec, initial })
    }
}

/// The whole numbers that the CONSTANT sections of a file declare outside of blocks.
pub(crate) fn constants(parse: &Parse, sections: &[Section]) -> Constants {
    let mut constants = Constants::default();
    for section in sections.iter().filter(|section| section.block.is_none()) {
        let tree = parse.lines()[section.lines.start].tree();
        let header = SectionHeader::cast(NodeView::root(&tree));
        let is_constant = |token: TokenView<'_>| token.text().eq_ignore_ascii_case("CONSTANT");
        if !header.is_some_and(|header| header.qualifiers().any(is_constant)) {
            continue;
        }
        for line in parse.lines().range(section.lines.clone()) {
            let tree = line.tree();
            let Some(declaration) = Declaration::cast(NodeView::root(&tree)) else {
                continue;
            };
            let value = declaration.initial_value();
            let value = value.map(|value| crate::written::facts::node(&value));
            let literal = value.as_ref().and_then(crate::written::constant::signed_literal);
            if let Some((Ok(Literal::Int(n)), negative)) = literal {
                let n = if negative { -n } else { *n };
                for name in declaration.names() {
                    constants.entry(Name::new(name.text())).or_insert(n);
                }
            }
        }
    }
    constants
}
