//! A network: its parts translated, its wires drawn.

use super::Sketcher;
use super::call::Call;
use super::translate::{Translated, Translator};
use super::unread::{is_scl, jumps, leads_elsewhere_in};
use super::wiring::{Drawn, Strand, drawn};
use crate::model::{Body, Net, Network, Part, RAIL, Unit, Value, Wire};
use crate::standard::{Form, of_document};
use ladder_format::Circuit;
use ladder_format::program::{self, Block, Drawing, Element, Item, Path};
use ladder_instructions::Op;

impl Sketcher<'_> {
    /// A network of a block, which is the one of this number, with the comment on it. None: it is not read, and may lead
    /// elsewhere.
    pub(super) fn network(
        &mut self,
        translator: &mut Translator<'_, '_>,
        at: (&Unit, usize),
        network: &Network,
    ) -> Option<Vec<Item>> {
        let mut comments = network.told.clone();
        let mut drawings = match &network.body {
            Body::Text(language, _) if is_scl(language) => match self.structured(translator, at, network) {
                Ok(items) => {
                    let comments = comments.into_iter().map(Item::Comment);
                    return Some(
                        std::iter::once(Item::Blank)
                            .chain(comments)
                            .chain(items)
                            .collect(),
                    );
                }
                Err(_) if leads_elsewhere_in(network) => return None,
                Err(why) => vec![self.unread_network(at, network, (language, &why))],
            },
            Body::Text(language, why) => {
                let quoted = network.text.split('"').skip(1).step_by(2);
                self.called_in(translator.scope, quoted);
                vec![self.unread_network(at, network, (language, why))]
            }
            Body::Ladder(net) => self.ladder(translator, at, network, net),
        };
        if let Some((place, label)) = &network.label {
            self.reading.report.translated(*place, format!("label {label}"));
            let origin = self.reading.origin(*place);
            let label = Block::label(&translator.label(label));
            marked(&mut drawings, Element::of(label, Some(origin)));
        }
        if drawings.is_empty() {
            return Some(comments.into_iter().map(Item::Comment).collect());
        }
        let networks = drawings.into_iter().enumerate().flat_map(|(number, drawing)| {
            let comments = if number == 0 {
                std::mem::take(&mut comments)
            } else {
                Vec::new()
            };
            [Item::Blank, Item::Network(program::Network { comments, drawing })]
        });
        Some(networks.collect())
    }

    fn ladder(
        &mut self,
        translator: &mut Translator<'_, '_>,
        at: (&Unit, usize),
        network: &Network,
        net: &Net,
    ) -> Vec<Drawing> {
        let mut strands: Vec<Strand> = Vec::new();
        let mut after = Vec::new();
        let merged = self.merged(net);
        let mut points = net.points;
        for (number, wire) in net.wires.iter().enumerate() {
            if merged.contains(&number) {
                continue;
            }
            let mut strand = Strand::new(wire.from, wire.to);
            for (at, part) in wire.parts.iter().enumerate() {
                let mut part = part.clone();
                for argument in &mut part.arguments {
                    if let Value::Power(point) = argument.value {
                        argument.value = match contact_before(net, point) {
                            Some((_, text)) => Value::Operand(text.to_owned()),
                            None => {
                                let tag = translator.scope.helper("pin", "BOOL", "the power at a pin");
                                let mut pin = Strand::new(point, None);
                                pin.elements.push(coil(&tag));
                                strand.needs.push(strands.len());
                                strands.push(pin);
                                Value::Helper(tag)
                            }
                        };
                    }
                }
                let done = self.part(translator, &part);
                if let Some(tag) = done.cut {
                    strand.elements.push(coil(&tag));
                    strand.to = None;
                    let after = Strand {
                        needs: vec![strands.len()],
                        ..Strand::new(RAIL, wire.to)
                    };
                    strands.push(std::mem::replace(&mut strand, after));
                }
                let origin = self.reading.origin(part.place);
                let element = |block| Element::of(block, Some(origin));
                let elements = done.blocks.into_iter().map(element);
                let goes_on = at + 1 < wire.parts.len() || wire.to.is_some();
                if goes_on && sets(&part) {
                    // Power goes on as it came, and here it would be the tag.
                    if !strand.elements.is_empty() {
                        strand.to = Some(points);
                        strands.push(std::mem::replace(&mut strand, Strand::new(points, wire.to)));
                        points += 1;
                    }
                    strands.push(Strand {
                        elements: elements.collect(),
                        ..Strand::new(strand.from, None)
                    });
                    continue;
                }
                strand.elements.extend(elements);
                after.extend(done.after.into_iter().map(|blocks| {
                    let elements = blocks.into_iter().map(element).map(Circuit::Element);
                    Drawing::Circuit(Circuit::Series(elements.collect()))
                }));
            }
            strands.push(strand);
        }
        if strands.iter().all(|strand| strand.elements.is_empty()) {
            return after;
        }
        let tag = || {
            translator
                .scope
                .helper("point", "BOOL", "power at a point of a network")
        };
        let mut drawings = match drawn(&mut strands, points, tag) {
            Ok(Drawn::Whole(drawing)) => vec![drawing],
            Ok(Drawn::Pieces(pieces)) => {
                let why = "its wires would cross here: the power at their points goes by way of tags";
                self.reading.report.approximated(network.place, "network", why);
                pieces
            }
            Err(why) if jumps(network) => {
                self.reading.report.refused(network.place, "network", why);
                Vec::new()
            }
            Err(why) => vec![self.unread_network(at, network, ("LAD", &why))],
        };
        drawings.extend(after);
        drawings
    }

    /// The wires that are but one contact on their way to a pin: its tag is an operand.
    fn merged(&mut self, net: &Net) -> Vec<usize> {
        let parts = net.wires.iter().flat_map(|wire| &wire.parts);
        let pins = parts
            .flat_map(|part| &part.arguments)
            .filter_map(|argument| match argument.value {
                Value::Power(point) => Some(point),
                _ => None,
            });
        let mut merged = Vec::new();
        for (wire, _) in pins.filter_map(|point| contact_before(net, point)) {
            for part in &net.wires[wire].parts {
                self.reading.report.translated(part.place, part.text.clone());
            }
            merged.push(wire);
        }
        merged
    }

    /// A part; one without a counterpart is not read.
    fn part(&mut self, translator: &mut Translator<'_, '_>, part: &Part) -> Translated {
        let done = match of_document(&part.name) {
            Some(row) => translator.instruction(row, part),
            None => self.call(translator, part),
        };
        match done {
            Ok(done) => {
                let report = &mut self.reading.report;
                match &done.note {
                    None => report.translated(part.place, part.text.clone()),
                    Some(note) => report.approximated(part.place, part.text.clone(), note.clone()),
                }
                done
            }
            Err(why) => Translated {
                blocks: vec![self.unread_part(part, &why)],
                ..Translated::default()
            },
        }
    }

    fn call(&mut self, translator: &mut Translator<'_, '_>, part: &Part) -> Result<Translated, String> {
        let call = Call::of(translator, part)?;
        self.needed.push(call.callee.name.clone());
        call.translated(translator, part)
    }
}

/// Whether a part sets its bit.
fn sets(part: &Part) -> bool {
    of_document(&part.name).is_some_and(|row| row.form == Form::Coil(Op::SetCoil))
}

/// The wire to a point and the operand of the contact on it, if no other wire ends at the point, and one pin takes it.
fn contact_before(net: &Net, point: usize) -> Option<(usize, &str)> {
    let mut into = net
        .wires
        .iter()
        .enumerate()
        .filter(|(_, wire)| wire.to == Some(point));
    let (number, wire) = into.next()?;
    let takes = |part: &Part| {
        part.arguments
            .iter()
            .filter(|it| it.value == Value::Power(point))
            .count()
    };
    let taken: usize = net.wires.iter().flat_map(|wire| &wire.parts).map(takes).sum();
    let is_only = into.next().is_none() && taken == 1 && net.wires.iter().all(|wire| wire.from != point);
    match wire {
        Wire {
            from: RAIL, parts, ..
        } if is_only && parts.len() == 1 && parts[0].name == "Contact" => {
            match &parts[0].only("operand")?.value {
                Value::Operand(text) => Some((number, text)),
                _ => None,
            }
        }
        _ => None,
    }
}

/// What puts the power into a tag of our own.
fn coil(tag: &str) -> Element {
    Element::of(Block::coil(Path::tag(tag)), None)
}

/// A label is at the beginning of its network, or in one of its own.
fn marked(drawings: &mut Vec<Drawing>, label: Element) {
    if let Some(Drawing::Circuit(circuit)) = drawings.first_mut() {
        let before = std::mem::replace(circuit, Circuit::Series(Vec::new()));
        let mut parts = vec![Circuit::Element(label)];
        match before {
            Circuit::Series(more) => parts.extend(more),
            other => parts.push(other),
        }
        *circuit = Circuit::Series(parts);
        return;
    }
    drawings.insert(0, Drawing::Circuit(Circuit::Element(label)));
}
