//! The declarations of a project: types, and tags in their sections.

use crate::scope::{CONTROLLER, Kind};
use crate::sketch::Sketcher;
use crate::types::{Ty, Types};
use ladder_format::program::{
    Declaration, Item, Qualifier, Section, SectionKind, comment_on_line, comment_text,
};

impl Sketcher<'_> {
    /// The sections of a file with the tags of these scopes, without those of Add-On Instructions.
    pub(super) fn declarations(&mut self, of: impl Fn(usize) -> bool) -> Vec<Item> {
        let last = CONTROLLER + self.translator.project.programs.len();
        let mut items = Vec::new();
        let sections = [
            (Kind::Input, SectionKind::VarInput, None),
            (Kind::Output, SectionKind::VarOutput, None),
            (Kind::Plain, SectionKind::Var, None),
            (Kind::Constant, SectionKind::Var, Some(Qualifier::Constant)),
        ];
        for (kind, section, qualifier) in sections {
            let declarations = self.declared(kind, |scope| scope <= last && of(scope));
            if !declarations.is_empty() {
                let mut section = Section::new(section);
                section.qualifier = qualifier;
                section.declarations = declarations;
                items.extend([Item::Blank, Item::Section(section)]);
            }
        }
        items
    }

    pub(super) fn declared(&mut self, kind: Kind, of: impl Fn(usize) -> bool) -> Vec<Declaration> {
        let tags = &self.translator.tags;
        let own = tags
            .symbols
            .iter()
            .filter(|symbol| symbol.kind == kind && of(symbol.declared_in()));
        let mut places: Vec<(usize, Option<usize>)> = Vec::new();
        let mut declarations = Vec::new();
        for symbol in own {
            let mut declaration = Declaration::new(&symbol.name, self.type_text(&symbol.ty));
            let value = symbol.value.as_ref();
            declaration.initial = value.and_then(|value| value.text(&symbol.ty, &tags.types));
            declaration.comment = symbol
                .comment
                .as_ref()
                .map(|text| text.replace(['\n', '\r'], " "));
            places.push((declarations.len(), symbol.at));
            declarations.push(declaration);
        }
        for (number, at) in places {
            if let Some(at) = at {
                declarations[number].origin = Some(self.origin(at));
            }
        }
        declarations
    }

    pub(super) fn type_text(&self, ty: &Ty) -> String {
        type_text(&self.translator.tags.types, &self.translator.aoi_names, ty)
    }
}

fn type_text(types: &Types, aois: &[String], ty: &Ty) -> String {
    match ty {
        Ty::Elem(elem) => elem.text(),
        Ty::Structure(index) => types.all[*index].name.clone(),
        Ty::Aoi(index) => aois[*index].clone(),
        Ty::Array(ty, sizes) => {
            let bounds: Vec<String> = sizes.iter().map(|size| format!("0..{}", size - 1)).collect();
            format!("ARRAY[{}] OF {}", bounds.join(", "), type_text(types, aois, ty))
        }
    }
}

/// The types that declared tags have.
pub(super) fn types(types: &Types, aois: &[String]) -> Option<Item> {
    let mut text = String::new();
    for structure in types.all.iter().filter(|structure| structure.used) {
        if let Some(comment) = &structure.comment {
            for line in comment_text(comment)
                .lines()
                .filter(|line| !line.trim().is_empty())
            {
                text.push_str(&format!("    # {} #\n", line.trim()));
            }
        }
        text.push_str(&format!("    {} : STRUCT\n", structure.name));
        for field in &structure.members {
            text.push_str(&format!(
                "        {} : {};",
                field.name,
                type_text(types, aois, &field.ty)
            ));
            if let Some(comment) = &field.comment {
                text.push_str(&format!("  {}", comment_on_line(comment)));
            }
            text.push('\n');
        }
        if structure.members.is_empty() {
            text.push_str("        unused : DINT;\n");
        }
        if structure.original == "TIMER" {
            text.push_str("        LAST : LINT;  # when the time was last counted, in ms #\n");
        }
        text.push_str("    END_STRUCT;\n");
    }
    (!text.is_empty()).then(|| Item::Text(format!("\nTYPE\n{text}END_TYPE")))
}
