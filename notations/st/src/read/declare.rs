//! Declarations as they are written here.

use super::declared::{Role, TypeDeclaration, Variable};
use super::initial::initial_text;
use super::lower;
use super::scope::{Scope, Type};
use super::types::{self, type_text};
use ladder_format::program::{Declaration, Item, Qualifier, Section, SectionKind};
use ladder_notation::address::is_as_wide;
use std::collections::HashSet;

/// The sections of a unit, with what was declared so far.
#[derive(Debug, Default)]
pub(super) struct Sections {
    sections: Vec<Section>,
}

impl Sections {
    pub(super) fn items(self) -> Vec<Item> {
        self.sections.into_iter().map(Item::Section).collect()
    }

    fn push(&mut self, kind: SectionKind, qualifier: Option<Qualifier>, declaration: Declaration) {
        let last = self
            .sections
            .last_mut()
            .filter(|last| last.kind == kind && last.qualifier == qualifier);
        match last {
            Some(last) => last.declarations.push(declaration),
            None => {
                let declarations = vec![declaration];
                self.sections.push(Section {
                    kind,
                    qualifier,
                    declarations,
                });
            }
        }
    }

    /// Declares a variable: its type, and what is not quite as there.
    ///
    /// # Errors
    ///
    /// Why it cannot be declared.
    pub(super) fn variable(
        &mut self,
        variable: &Variable,
        spelled: &str,
        mut kind: SectionKind,
        origin: u32,
        (scope, shared, is_program): (&Scope, &HashSet<String>, bool),
    ) -> Result<(Type, Option<String>), String> {
        let ty = types::of(&variable.ty, scope)?;
        let mut declaration = Declaration::new(spelled, type_text(&variable.ty, &ty, scope)?);
        declaration.origin = Some(origin);
        declaration.comment = variable.comment.as_deref().map(lower::comment_of);
        let mut why = (spelled != variable.name).then(|| format!("it is spelled `{spelled}` here"));
        match variable.address.as_deref() {
            Some("") => return Err("it lies over another variable, in memory by address".to_owned()),
            Some(text) if text.ends_with('*') => {
                why = why.or(Some("its address is given elsewhere".to_owned()));
            }
            Some(text) => {
                declaration.address = lower::address(text)
                    .filter(|address| ty.scalar().is_some_and(|ty| is_as_wide(address, ty)));
                if declaration.address.is_none() {
                    if ty.scalar().is_none() {
                        return Err(format!("more than one value is at `{text}`"));
                    }
                    if shared.contains(&text.to_ascii_uppercase()) {
                        return Err(format!("another variable is at `{text}`, too"));
                    }
                    let area = text.chars().nth(1).map(|area| area.to_ascii_uppercase());
                    kind = match (area, kind) {
                        // What comes from outside is an input.
                        (Some('I'), SectionKind::Var) if is_program => SectionKind::VarInput,
                        (Some('Q'), SectionKind::Var) if is_program => SectionKind::VarOutput,
                        (Some('I'), _) => return Err(format!("`{text}` is not an address that is read")),
                        (_, kind) => kind,
                    };
                    why = Some(format!("there is no `{text}` here: the tag has no address"));
                }
            }
            None => {}
        }
        if let Some(initial) = &variable.initial
            && !ty.keeps_state()
            && variable.role != Role::External
        {
            declaration.initial = Some(initial_text(initial, &ty, scope)?);
        }
        self.push(kind, variable.qualifier, declaration);
        Ok((ty, why))
    }

    /// What a function returns is an output.
    pub(super) fn result(&mut self, name: &str, ty: &Type, origin: u32) {
        let Some(text) = ty.text() else { return };
        let mut declaration = Declaration::new(name, text);
        declaration.comment = Some("what the function returns".to_owned());
        declaration.origin = Some(origin);
        self.push(SectionKind::VarOutput, None, declaration);
    }

    /// Declares the tags of the reader's own.
    pub(super) fn tags(&mut self, tags: Vec<Declaration>) {
        if !tags.is_empty() {
            self.sections.push(Section {
                kind: SectionKind::Var,
                qualifier: None,
                declarations: tags,
            });
        }
    }
}

/// A declaration of a type.
pub(super) fn type_section(
    name: &str,
    text: String,
    initial: Option<String>,
    declared: &TypeDeclaration,
    origin: u32,
) -> Declaration {
    Declaration {
        initial,
        comment: declared.comment.as_deref().map(lower::comment_of),
        origin: Some(origin),
        ..Declaration::new(name, text)
    }
}
