//! The declarations of a Click program, in the sections of ladder text.

use super::super::address::{Address, Tag, Which};
use super::super::bank::{Bank, Writer};
use super::super::operand::literal;
use super::super::ranges::is_of_blocks;
use super::{Tags, is_zero};
use ladder_format::program::{Declaration, Qualifier, Section, SectionKind};
use ladder_instructions::by_op;

impl Tags<'_> {
    /// The declarations, once everything has been met.
    pub(in super::super) fn sections(&self) -> Vec<Section> {
        let mut sections = Sections::default();
        for (bank, (first, last)) in &self.arrays {
            let is_copy = is_of_blocks(*bank);
            if is_copy && !self.copied.contains(bank) {
                continue;
            }
            let ty = format!("ARRAY[{first}..{last}] OF {}", bank.kind().iec());
            let mut declaration = Declaration::new(bank.array(), ty);
            declaration.comment = is_copy.then(|| "what timers or counters hold, as an array".to_owned());
            sections.push(*bank, bank.row().retentive, declaration, self);
        }
        for tag in &self.state_order {
            let state = &self.states[tag];
            let declaration = Declaration::new(&state.name, by_op(state.op).mnemonic);
            self.declare(&mut sections, tag, declaration);
        }
        for (tag, name) in &self.own {
            let declaration = Declaration::new(name, tag.bank.kind().iec());
            self.declare(&mut sections, tag, declaration);
        }
        for helper in &self.helpers {
            let mut declaration = Declaration::new(&helper.name, &helper.ty);
            declaration.comment = Some(format!("helper: {}", helper.what));
            declaration.initial = helper.initial.as_ref().map(|initial| initial.as_str().to_owned());
            sections.push(Bank::C, false, declaration, self);
        }
        sections.all()
    }

    fn declare(&self, sections: &mut Sections, tag: &Tag, mut declaration: Declaration) {
        let nickname = tag.address().and_then(|address| self.numbered.get(&address));
        let retentive = nickname.and_then(|nickname| nickname.retentive);
        declaration.comment = self.told(tag, &declaration.names[0]);
        let initial = nickname.and_then(|nickname| nickname.initial.as_ref());
        let initial = initial.filter(|initial| !is_zero(initial) && !matches!(tag.bank, Bank::T | Bank::Ct));
        let initial = initial.and_then(|initial| literal(initial, Some(tag.bank.kind())).ok());
        declaration.initial = initial.map(|initial| initial.as_str().to_owned());
        sections.push(
            tag.bank,
            retentive.unwrap_or(tag.bank.row().retentive),
            declaration,
            self,
        );
    }

    /// What the declaration of a tag says: its address if that is known, else its bank and nickname where they do not
    /// follow from the type and the section.
    fn told(&self, tag: &Tag, name: &str) -> Option<String> {
        let nickname = match &tag.which {
            Which::Nickname(nickname) => {
                let usual = !matches!(tag.bank, Bank::Sc | Bank::Sd | Bank::Xd | Bank::Yd);
                let like_number = Address::parse(nickname).is_some();
                return (!usual || like_number || nickname != name).then(|| tag.dsl());
            }
            Which::Number(_) => match (self.nickname_of(tag), tag.address()) {
                (Some(nickname), _) => nickname,
                (None, Some(address)) if address.is_upper() => return Some(address.to_string()),
                (None, _) => return None,
            },
        };
        let mut told = nickname.address.to_string();
        if nickname.name != name {
            told.push_str(&format!(" {}", nickname.name));
        }
        if !nickname.comment.is_empty() {
            told.push_str(&format!(": {}", nickname.comment));
        }
        Some(told)
    }
}

/// The sections in the order in which they are written.
#[derive(Default)]
struct Sections {
    inputs: Vec<Declaration>,
    outputs: Vec<Declaration>,
    others: Vec<Declaration>,
    kept: Vec<Declaration>,
}

impl Sections {
    fn push(&mut self, bank: Bank, retentive: bool, declaration: Declaration, tags: &Tags<'_>) {
        let section = match bank.row().writer {
            _ if retentive => &mut self.kept,
            Writer::System(_) if tags.written.contains(&bank) => &mut self.others,
            Writer::World | Writer::System(_) => &mut self.inputs,
            _ if matches!(bank, Bank::Y | Bank::Yd) => &mut self.outputs,
            _ => &mut self.others,
        };
        section.push(declaration);
    }

    fn all(self) -> Vec<Section> {
        let section = |kind, qualifier, declarations| Section {
            kind,
            qualifier,
            declarations,
        };
        vec![
            section(SectionKind::VarInput, None, self.inputs),
            section(SectionKind::VarOutput, None, self.outputs),
            section(SectionKind::Var, None, self.others),
            section(SectionKind::Var, Some(Qualifier::Retain), self.kept),
        ]
    }
}
