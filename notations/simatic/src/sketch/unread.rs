//! What is not read: instructions and calls, networks, blocks as a whole, and what other events start.

use super::{Form, Sketcher};
use crate::model::{Body, Kind, Network, Part, Type, Unit};
use crate::operand::operand;
use crate::scope::{Scope, block_name};
use crate::standard::{self, of_document};
use ladder_format::program::{self, Block, Drawing, Element, Item, SectionKind};
use ladder_format::{Circuit, Options};
use ladder_notation::{LineColumn, Power, Turn, Unread, blocks, unread_body};
use std::collections::HashSet;

/// What becomes of something that is not read.
const UNREAD: &str = "a scan runs past it, and what it may write is not known";

/// Instructions that lead elsewhere, or stop the controller.
const LEADING: [&str; 3] = ["JMP_LIST", "SWITCH", "STP"];

/// Whether a network is in SCL, which is read.
pub(super) fn is_scl(language: &str) -> bool {
    language.eq_ignore_ascii_case("SCL")
}

/// Words of a text that leads elsewhere: of SCL, of STL, of a network in LAD that is broken.
const LEADING_WORDS: [&str; 30] = [
    "RETURN", "GOTO", "RET", "BE", "BEC", "BEU", "JU", "JL", "JC", "JCN", "JCB", "JNB", "JBI", "JNBI", "JO",
    "JOS", "JZ", "JN", "JP", "JM", "JPZ", "JMZ", "JUO", "JMP", "JMPN", "LOOP", "LABEL", "JMP_LIST", "SWITCH",
    "STP",
];

impl Sketcher<'_> {
    /// An instruction or a call, as it is on a rung.
    pub(super) fn unread_part(&mut self, part: &Part, why: &str) -> Block {
        let why = format!("{why}: {UNREAD}");
        self.reading
            .report
            .approximated(part.place, part.text.clone(), why);
        let name = part.name.trim_start_matches("_.").trim_matches(['#', '"']);
        let decides = of_document(&part.name).is_some_and(|row| {
            matches!(
                row.form,
                standard::Form::Contact(_)
                    | standard::Form::EdgeContact(_)
                    | standard::Form::Compare(_)
                    | standard::Form::InRange
                    | standard::Form::OutRange
                    | standard::Form::Valid(_)
                    | standard::Form::Edge(_)
                    | standard::Form::Not
                    | standard::Form::Bistable { .. }
                    | standard::Form::State(..)
            )
        });
        let about = format!("{name} is not read: {UNREAD}.");
        let part = Unread {
            name,
            about: &about,
            text: &part.text,
            writes: None,
            power: if decides { Power::Ends } else { Power::Passes },
            turn: Turn::Here,
        };
        let library = self.library;
        self.unread.block(part, |word| is_taken(library, word))
    }

    /// The blocks of the project that a text names come along: with another one of them it is another text.
    pub(super) fn called_in<'n>(&mut self, scope: &mut Scope<'_>, names: impl IntoIterator<Item = &'n str>) {
        for name in names {
            let Some(Ok(unit)) = self.library.get(&name.to_lowercase()) else {
                continue;
            };
            match (unit.kind, &unit.returns) {
                (Kind::FunctionBlock | Kind::Function, _) => self.needed.push(unit.name.clone()),
                // An instance.
                (Kind::Data, Some(Type::Named(block))) if scope.unit(block).is_some() => {
                    drop(operand(scope, &format!("\"{name}\""), ""));
                }
                _ => {}
            }
        }
    }

    /// A network.
    pub(super) fn unread_network(
        &mut self,
        (unit, number): (&Unit, usize),
        network: &Network,
        (language, why): (&str, &str),
    ) -> Drawing {
        let why = format!("{why}: {UNREAD}");
        self.reading.report.approximated(network.place, "network", why);
        let name = format!("network {} of {} ({language})", number + 1, unit.name);
        self.unread_body(&name, &network.text, network.place)
    }

    fn unread_body(&mut self, name: &str, text: &str, place: LineColumn) -> Drawing {
        let part = Unread {
            name,
            about: &format!("{name} is not read: {UNREAD}."),
            text,
            writes: None,
            power: Power::Passes,
            turn: Turn::Here,
        };
        let library = self.library;
        let block = self.unread.body(part, |word| is_taken(library, word));
        self.alone(block, place)
    }

    /// Declarations and body of a block of which nothing is read, because something in it that is not read may lead elsewhere.
    pub(super) fn unread_unit(&mut self, unit: &Unit, is_block: bool) -> Vec<Item> {
        let why = format!(
            "something in it that is not read may lead elsewhere, so that all of it is not read: {UNREAD}"
        );
        let shown = format!("body of {}", unit.name);
        self.reading.report.approximated(unit.place, shown, why);
        let networks = unit.networks.iter().enumerate();
        let texts = networks.map(|(number, network)| format!("NETWORK {}\n{}", number + 1, network.text));
        let text = texts.collect::<Vec<_>>().join("\n");
        let scope = Scope::of(unit, self.library);
        let mut items = self.variables(unit, &scope, is_block, |_| false).items();
        if is_block {
            items.extend(unread_body(&text, None));
        } else {
            let name = format!("body of {}", unit.name);
            let drawing = self.unread_body(&name, &text, unit.place);
            items.extend([Item::Blank, network(drawing)]);
        }
        items
    }

    /// What other organization blocks do, which run at events and not in this scan: between any two networks. `own` is the program
    /// with its blocks.
    pub(super) fn at_events(&mut self, unit: &Unit, own: &[Item]) -> Vec<Item> {
        let library = self.library;
        let mut others: Vec<&Unit> = library
            .values()
            .filter_map(|unit| unit.as_ref().ok().copied())
            .collect();
        others
            .retain(|other| other.kind == Kind::Organization && !other.name.eq_ignore_ascii_case(&unit.name));
        others.sort_by(|one, other| one.name.cmp(&other.name));
        let mut items = Vec::new();
        for other in others {
            let program = super::sketch(other, library, Form::Event).program;
            let text = program.write(&Options::default()).text;
            let writes = is_read(&program.items).then(|| globals_of_both(own, &program.items));
            if writes.as_ref().is_some_and(Vec::is_empty) {
                continue;
            }
            let about = format!(
                "{} runs at an event, between any two networks of this program.",
                other.name
            );
            let part = Unread {
                name: &other.name,
                about: &about,
                text: text.trim_end(),
                writes: writes.as_deref(),
                power: Power::Passes,
                turn: Turn::AnyTime,
            };
            let block = self.unread.body(part, |word| is_taken(library, word));
            let drawing = self.alone(block, unit.place);
            items.extend([Item::Blank, network(drawing)]);
            let why = "it runs at an event there, and not here: what it writes is not known at any time";
            let shown = format!("{} {}", Kind::Organization.keyword(), other.name);
            self.reading.report.approximated(unit.place, shown, why);
        }
        items
    }

    fn alone(&mut self, block: Block, place: LineColumn) -> Drawing {
        let origin = self.reading.origin(place);
        Drawing::Circuit(Circuit::Element(Element::of(block, Some(origin))))
    }
}

fn network(drawing: Drawing) -> Item {
    let comments = Vec::new();
    Item::Network(program::Network { comments, drawing })
}

/// Whether a network of a block may lead elsewhere in a way that is not read. Of one in SCL that is known when it has been read.
pub(super) fn leads_elsewhere(unit: &Unit) -> bool {
    let is_tried = |network: &Network| matches!(&network.body, Body::Text(language, _) if is_scl(language));
    let mut networks = unit.networks.iter().filter(|network| !is_tried(network));
    networks.any(leads_elsewhere_in)
}

/// The same of one network.
pub(super) fn leads_elsewhere_in(network: &Network) -> bool {
    let is_in = |words: &[&str], word: &str| words.iter().any(|own| own.eq_ignore_ascii_case(word));
    match &network.body {
        Body::Text(language, _) => {
            let words = if is_scl(language) {
                &LEADING_WORDS[..2]
            } else {
                &LEADING_WORDS[..]
            };
            let mut own = network.text.split(|c: char| !c.is_alphanumeric() && c != '_');
            own.any(|word| is_in(words, word))
        }
        Body::Ladder(net) => {
            let mut parts = net.wires.iter().flat_map(|wire| &wire.parts);
            parts.any(|part| is_in(&LEADING, &part.name) && of_document(&part.name).is_none())
        }
    }
}

/// Whether a network that cannot be drawn leads elsewhere.
pub(super) fn jumps(network: &Network) -> bool {
    let Body::Ladder(net) = &network.body else {
        return false;
    };
    let mut parts = net.wires.iter().flat_map(|wire| &wire.parts);
    parts.any(|part| {
        let form = of_document(&part.name).map(|row| row.form);
        matches!(form, Some(standard::Form::Jump { .. } | standard::Form::Return))
    })
}

fn is_taken(library: &crate::scope::Library<'_>, word: &str) -> bool {
    let mut units = library.values().filter_map(|unit| unit.as_ref().ok());
    units.any(|unit| block_name(&unit.name).eq_ignore_ascii_case(word))
}

/// Whether it is known what a program may write: no part of it is unread, and it has no addresses, which are everywhere.
fn is_read(items: &[Item]) -> bool {
    let mut is_read = !is_unread(items);
    blocks(items, &mut |block| {
        block.paths(|path| is_read &= !path.root.starts_with('%'));
    });
    is_read
}

fn is_unread(items: &[Item]) -> bool {
    items.iter().any(|item| match item {
        Item::Directive(told) => told.starts_with("unread"),
        Item::Block { items, .. } => is_unread(items),
        _ => false,
    })
}

/// The globals of a program that another one names, too.
fn globals_of_both(own: &[Item], other: &[Item]) -> Vec<String> {
    let (mut names, mut others) = (Vec::new(), Vec::new());
    globals(own, &mut names);
    globals(other, &mut others);
    let others: HashSet<String> = others.iter().map(|name| name.to_lowercase()).collect();
    let mut known = HashSet::new();
    names.retain(|name| others.contains(&name.to_lowercase()) && known.insert(name.to_lowercase()));
    names
}

fn globals(items: &[Item], out: &mut Vec<String>) {
    for item in items {
        match item {
            Item::Section(section) if section.kind == SectionKind::VarGlobal => {
                out.extend(
                    section
                        .declarations
                        .iter()
                        .flat_map(|it| it.names.iter().cloned()),
                );
            }
            Item::Block { items, .. } => globals(items, out),
            _ => {}
        }
    }
}
