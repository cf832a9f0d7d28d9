//! An Add-On Instruction as the definition of a block.

use crate::scope::Kind;
use crate::sketch::{Sketcher, alone, network};
use crate::unit::Owner;
use ladder_format::Circuit;
use ladder_format::program::{Block, Item, Path, Qualifier, Section, SectionKind};

impl Sketcher<'_> {
    /// An Add-On Instruction as a block.
    pub(super) fn aoi(&mut self, aoi: usize) -> Vec<Item> {
        let project = self.translator.project;
        let definition = &project.aois[aoi];
        let scope = 1 + project.programs.len() + aoi;
        let name = self.translator.aoi_names[aoi].clone();
        let begin = self.begin_in_body(scope);
        let mut body = Vec::new();
        let routine = |name: &str| {
            let mut all = self.units.iter();
            all.position(|unit| unit.owner == Owner::Aoi(aoi) && unit.routine.name.eq_ignore_ascii_case(name))
        };
        let (logic, when_off) = (routine("Logic"), routine("EnableInFalse"));
        // With dead power nothing of it runs, but what it has for that.
        let own = |block: Block| alone(block, None);
        match when_off.filter(|unit| !self.units[*unit].is_empty()) {
            Some(unit) => {
                let label = self.translator.tags.fresh(scope, "logic");
                let jump = vec![own(Block::contact(Path::tag("EN"))), own(Block::jump(&label))];
                body.push(network(Vec::new(), Circuit::Series(jump)));
                body.extend(begin.clone());
                body.extend(self.unit(unit));
                let end = network(Vec::new(), own(Block::ret()));
                body.extend([Item::Blank, end, Item::Blank]);
                body.push(network(Vec::new(), own(Block::label(&label))));
            }
            None => {
                let leave = vec![own(Block::negated_contact(Path::tag("EN"))), own(Block::ret())];
                body.push(network(Vec::new(), Circuit::Series(leave)));
            }
        }
        body.extend(begin);
        if let Some(logic) = logic {
            body.extend(self.unit(logic));
        }
        let place = self.place(definition.at);
        for unit in self.units.iter().filter(|unit| unit.owner == Owner::Aoi(aoi)) {
            let own = unit.routine;
            let runs = matches!(own.name.to_ascii_uppercase().as_str(), "LOGIC" | "ENABLEINFALSE");
            if !runs && !unit.is_empty() {
                let place = self.place(own.at);
                let what = format!("routine {} of {}", own.name, definition.name);
                self.reading
                    .report
                    .approximated(place, what, "it is not run here: there is no such phase");
            }
        }
        let mut items = vec![Item::Blank];
        let told = definition.comment.as_deref().unwrap_or_default();
        let title = format!("Add-On Instruction {}\n{told}", definition.name);
        items.push(Item::Comment(title.trim().to_owned()));
        let mut inner = Vec::new();
        let sections = [
            (Kind::Input, SectionKind::VarInput, None),
            (Kind::InOut, SectionKind::VarInOut, None),
            (Kind::Output, SectionKind::VarOutput, None),
            (Kind::Plain, SectionKind::Var, None),
            (Kind::Constant, SectionKind::Var, Some(Qualifier::Constant)),
        ];
        for (kind, section, qualifier) in sections {
            let mut section = Section::new(section);
            section.qualifier = qualifier;
            section.declarations = self.declared(kind, |of| of == scope);
            if kind == Kind::Input {
                // What a call need not give has a value of its own.
                for declaration in &mut section.declarations {
                    let default = if declaration.ty == "BOOL" { "FALSE" } else { "0" };
                    let elementary = !declaration.ty.starts_with(['A', 'S', '$']) || declaration.ty == "SINT";
                    if declaration.initial.is_none() && elementary {
                        let real = matches!(declaration.ty.as_str(), "REAL" | "LREAL");
                        declaration.initial = Some(if real { "0.0" } else { default }.to_owned());
                    }
                }
            }
            inner.push(Item::Section(section));
        }
        inner.push(Item::Blank);
        inner.append(&mut body);
        self.reading
            .report
            .translated(place, format!("Add-On Instruction {}", definition.name));
        items.push(Item::Block {
            header: format!("[{name}]"),
            origin: None,
            items: inner,
        });
        items
    }
}
