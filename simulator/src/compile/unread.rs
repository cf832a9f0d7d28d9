//! Unread parts (LANGUAGE §5.9): a scan runs past them. What each may read and write is noted.

use super::place::{Slot, Spot};
use super::user_block::{Output, home_of};
use super::{Compiler, Result};
use crate::code::{Instr, Tracked, UnreadPlace};
use crate::layout::{Borrowed, Home};
use crate::memory::Bit;
use ladder_analysis::program::{
    Block, BlockKind, ParameterKind, Place, TagId, Unread, unread_name, without_blanks,
};
use ladder_instructions::Coil;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// What is known of unread parts while a program is compiled.
#[derive(Debug, Default)]
pub(super) struct Seen {
    /// What the networks of a file see outside of bodies, and what of it may be written.
    of_files: HashMap<u32, Around>,
    /// The parts that run between any two networks.
    at_any_time: Vec<u32>,
}

/// The tags that a part may read, and those that one may write that does not say which.
#[derive(Debug, Clone)]
struct Around {
    reads: Arc<[Tracked]>,
    writes: Arc<[Tracked]>,
}

impl Compiler<'_> {
    /// Notes the parts that run at any time.
    pub(super) fn parts_at_any_time(&mut self) {
        let program = self.program;
        for (number, name, unread) in program.unread_parts() {
            if !unread.directive.at_any_time {
                continue;
            }
            let is_call = |block: &Block| matches!(block.kind, BlockKind::User(it) if it == number);
            let is_in_body = |at: usize| program.blocks.iter().any(|block| block.networks.contains(&at));
            let mut networks = program.networks.iter().enumerate();
            let call = networks.find_map(|(at, network)| {
                let block = network.blocks.iter().find(|block| is_call(block))?;
                (!is_in_body(at)).then_some((at, block))
            });
            let tags = match call {
                Some((at, _)) => program.visible_in(at),
                None => program.visible_in_main(),
            };
            let around = self.around(&tags);
            self.unread.at_any_time.push(self.code.unread.len() as u32);
            self.code.unread.push(UnreadPlace {
                name: name.to_owned(),
                location: call.map(|(_, block)| block.location),
                text: format!(
                    "at any time {}",
                    text_of(name, unread, call.map(|(_, block)| block))
                ),
                power: None,
                given: Vec::new(),
                own: Vec::new(),
                writes: self.named(unread, &tags).unwrap_or(around.writes),
                reads: around.reads,
            });
        }
    }

    /// Between two networks, and before the first.
    pub(super) fn at_any_time(&mut self) {
        for number in 0..self.unread.at_any_time.len() {
            let at = self.unread.at_any_time[number];
            self.emit(Instr::Unread { at });
        }
    }

    /// A block that is an unread part, with its operands found and its power low.
    pub(super) fn unread_block(
        &mut self,
        (index, block): (usize, &Block),
        (en, out): (Bit, Bit),
        inputs: Vec<(Place, Slot)>,
        outputs: &[Output],
    ) -> Result<Bit> {
        let program = self.program;
        let user = &program.blocks[index];
        let Some(unread) = &user.unread else {
            return Ok(out);
        };
        let given = inputs.iter().map(|(_, value)| match *value {
            Slot::Bit(at) => Home::Bits { at, first: 0, len: 1 },
            Slot::Word(at) => Home::Words {
                at,
                first: 0,
                len: 1,
                ty: ladder_analysis::values::types::Scalar::Lint,
            },
            Slot::Text(at) => Home::Texts {
                at,
                first: 0,
                len: 1,
                max: 0,
            },
        });
        let given = given.collect();
        let has_state = block.arguments.iter().any(|bound| bound.parameter.is_none());
        if has_state {
            // Others see them as members of the state.
            for (place, value) in inputs {
                let spot = self.spot(&place)?;
                self.store(spot, value);
            }
        }
        let network = self.standing.last().map_or(0, |at| at.network);
        let tags = program.visible_in(network);
        let around = self.around_network(network, &tags);
        let in_body = self.block_tags[index].clone();
        let is_own = |tag: &TagId| *tag != user.en && *tag != user.eno;
        let (own, writes) = match &unread.directive.writes {
            None => {
                let is_input = |tag: &TagId| {
                    let mut parameters = user.parameters.iter();
                    parameters.any(|(input, kind)| input == tag && *kind == ParameterKind::Input)
                };
                let is_written = |tag: &TagId| {
                    is_own(tag) && !program.tags[tag.0 as usize].constant && (has_state || !is_input(tag))
                };
                (in_body.into_iter().filter(is_written).collect(), around.writes)
            }
            Some(paths) => {
                let mut own: Vec<TagId> = Vec::new();
                let mut writes = Vec::new();
                for path in paths {
                    match program.named_by(path, &in_body) {
                        named if named.is_empty() => writes.extend(program.named_by(path, &tags)),
                        named => own.extend(named),
                    }
                }
                (own, self.tracked(writes.iter()))
            }
        };
        let mut own = self.tracked_in_body(&own);
        for (number, output) in outputs.iter().enumerate() {
            if let (true, Some(home)) = (
                own.iter().any(|written| covers(written.home, output.read)),
                home_of(output.spot, output.to),
            ) {
                let name = format!("=> {number}");
                own.push(Tracked {
                    name,
                    tag: None,
                    home,
                });
            }
        }
        let passes = !self.ends_power(index);
        self.emit(Instr::Follow {
            out,
            en: if passes { en } else { Bit::LOW },
        });
        let at = self.code.unread.len() as u32;
        self.code.unread.push(UnreadPlace {
            name: unread_name(&user.name).to_owned(),
            location: Some(block.location),
            text: text_of(unread_name(&user.name), unread, Some(block)),
            power: Some([en, out]),
            given,
            own,
            writes,
            reads: around.reads,
        });
        self.emit(Instr::Unread { at });
        Ok(out)
    }

    /// Whether the body of a block gives no power: it ends so, `--(R)( ENO )--+`.
    fn ends_power(&self, index: usize) -> bool {
        let user = &self.program.blocks[index];
        let networks = &self.program.networks[user.networks.clone()];
        let mut blocks = networks.iter().flat_map(|network| &network.blocks);
        blocks.any(|block| {
            let resets = matches!(block.kind, BlockKind::Instruction(row) if row.coil == Some(Coil::Resets));
            let mut places = block.arguments.iter().flat_map(|bound| bound.places());
            resets && places.any(|(place, _)| place.root() == Some(user.eno))
        })
    }

    fn around_network(&mut self, network: usize, tags: &[TagId]) -> Around {
        let program = self.program;
        if program
            .blocks
            .iter()
            .any(|block| block.networks.contains(&network))
        {
            // Each place of the body has its own.
            return self.around(tags);
        }
        let file = program.networks[network].location.file;
        if let Some(known) = self.unread.of_files.get(&file) {
            return known.clone();
        }
        let around = self.around(tags);
        self.unread.of_files.insert(file, around.clone());
        around
    }

    fn around(&self, tags: &[TagId]) -> Around {
        let program = self.program;
        Around {
            reads: self.tracked(tags.iter()),
            writes: self.tracked(tags.iter().filter(|tag| program.may_be_written(**tag))),
        }
    }

    /// The tags of a list, if there is one.
    fn named(&self, unread: &Unread, tags: &[TagId]) -> Option<Arc<[Tracked]>> {
        let paths = unread.directive.writes.as_ref()?;
        let named: Vec<TagId> = (paths.iter())
            .flat_map(|path| self.program.named_by(path, tags))
            .collect();
        Some(self.tracked(named.iter()))
    }

    fn tracked<'t>(&self, tags: impl Iterator<Item = &'t TagId>) -> Arc<[Tracked]> {
        let tracked = tags.map(|tag| self.tracked_tag(*tag, ""));
        tracked
            .filter(|it| it.home != Home::Borrowed(Borrowed::Unbound))
            .collect()
    }

    fn tracked_in_body(&self, tags: &[TagId]) -> Vec<Tracked> {
        // The dot tells them from tags around.
        tags.iter().map(|tag| self.tracked_tag(*tag, ".")).collect()
    }

    fn tracked_tag(&self, tag: TagId, before: &str) -> Tracked {
        Tracked {
            name: format!(
                "{before}{}",
                self.program.tags[tag.0 as usize].name.to_lowercase()
            ),
            tag: Some(tag),
            home: self.homes[tag.0 as usize],
        }
    }

    /// What states remember besides tags may be written with them: such a block may be called from an unread part.
    pub(super) fn open_owned(&mut self) {
        let tags = &self.program.tags;
        for place in &mut self.code.unread {
            let of_state = |tracked: &Tracked| tracked.tag.filter(|tag| self.program.is_instance(*tag));
            let states: HashSet<TagId> = place
                .writes
                .iter()
                .chain(&place.own)
                .filter_map(of_state)
                .collect();
            let is_like = |first: &TagId| {
                let first_tag = &tags[first.0 as usize];
                states.iter().any(|tag| {
                    let tag_of = &tags[tag.0 as usize];
                    tag >= first && tag_of.ty == first_tag.ty && tag_of.block == first_tag.block
                })
            };
            let owned = self.owned.iter().enumerate();
            let owned = owned.filter(|(_, (first, _))| is_like(first));
            place.own.extend(owned.map(|(number, (first, home))| Tracked {
                name: format!("{} memory {number}", tags[first.0 as usize].name.to_lowercase()),
                tag: None,
                home: *home,
            }));
        }
    }
}

/// What of the text of a part makes it the same as another one. Where its definition has none, its name does, too.
fn text_of(name: &str, unread: &Unread, place: Option<&Block>) -> String {
    let operands = place
        .and_then(|block| block.unread.as_deref())
        .unwrap_or_default();
    let inside = operands.trim_start_matches('(').trim_end_matches(')').trim();
    let text = inside.strip_prefix('\'').and_then(|text| text.strip_suffix('\''));
    let text = text.map(|text| text.replace("$'", "\u{0}"));
    let shown = match text.filter(|text| !text.contains('\'')) {
        // They are a text of the other system.
        Some(text) => without_blanks(&text.replace('\u{0}', "'")),
        None => without_blanks(inside),
    };
    // Operands alone do not say of which instruction.
    let name = if unread.has_foreign_text { "" } else { name };
    format!("{name} {} {shown}", unread.text)
}

/// Whether an output of a body is, or is in, something that is written.
fn covers(home: Home, read: Spot) -> bool {
    match (home, read) {
        (Home::Bits { at, len, .. }, Spot::Bit(bit)) => (at.0..at.0 + len).contains(&bit.0),
        (Home::Words { at, len, .. }, Spot::Word(word)) => (at.0..at.0 + len).contains(&word.0),
        (Home::Texts { at, len, .. }, Spot::Text(text)) => (at.0..at.0 + len).contains(&text.0),
        (Home::Borrowed(_), _) => true,
        _ => false,
    }
}
