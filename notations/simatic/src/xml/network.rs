//! A network of SimaticML: parts, and wires between their pins.

use super::access;
use crate::model::{
    Argument, Body, MOST_PARTS, Net, Network, Part, RAIL, Role, Type, Unit, Value, Variable, Wire,
};
use crate::standard::{of_xml, pin_here, power_pins};
use ladder_notation::LineColumn;
use ladder_notation::xml::{Element, Xml};
use roxmltree::Node;
use std::collections::HashMap;

/// A network, with its texts.
pub(super) fn network(xml: &Xml<'_>, node: Node<'_, '_>, unit: &mut Unit) -> Network {
    let mut network = Network {
        place: xml.place(node),
        told: super::told(node),
        ..Network::default()
    };
    let attributes = node.child("AttributeList");
    let child = |name: &str| attributes.and_then(|list| list.child(name));
    let language = child("ProgrammingLanguage").map(|node| node.words());
    let language = language.unwrap_or_else(|| "LAD".to_owned());
    let source = child("NetworkSource");
    let Some(source) = source.filter(|source| source.elements().next().is_some()) else {
        return network;
    };
    (network.text, network.places) = access::text(xml, source);
    let drawn = source.child("FlgNet").filter(|_| language.ends_with("LAD"));
    let Some(drawn) = drawn else {
        network.body = Body::in_language(&language);
        return network;
    };
    let count = drawn.child("Parts").map_or(0, |parts| parts.elements().count());
    if count > MOST_PARTS {
        let why = format!("a network has no more than {MOST_PARTS} parts");
        network.body = Body::Text(language, why);
        return network;
    }
    let labels = drawn.child("Labels");
    let label = labels.and_then(|labels| {
        labels
            .descendants()
            .find(|node| node.is_element() && node.is("Label"))
    });
    network.label = label.and_then(|label| {
        let name = label.attribute("Name")?.to_owned();
        Some((xml.place(label), name))
    });
    network.body = Body::Ladder(Reader::of(xml, drawn, unit).net());
    network
}

/// A part with its pins.
struct Drawn {
    part: Part,
    is_or: bool,
    negated: Vec<String>,
    enters: &'static str,
    leaves: &'static str,
    /// What power it takes.
    source: Option<Source>,
    /// What takes its power.
    sinks: Vec<Sink>,
}

#[derive(Clone, Copy, PartialEq)]
enum Source {
    Rail,
    Part(usize),
}

#[derive(Clone, Copy, PartialEq)]
enum Sink {
    /// Another part's power.
    Part(usize),
    /// One of those that come together.
    Or(usize),
    /// A value of a part.
    Pin,
}

struct Reader {
    parts: Vec<Drawn>,
    rail: Vec<Sink>,
}

/// An end of a wire.
enum End<'x> {
    Rail,
    Pin(usize, &'x str),
    Operand(String),
}

impl Reader {
    fn of(xml: &Xml<'_>, drawn: Node<'_, '_>, unit: &mut Unit) -> Reader {
        let mut accesses: HashMap<&str, String> = HashMap::new();
        let mut numbers: HashMap<&str, usize> = HashMap::new();
        let mut reader = Reader {
            parts: Vec::new(),
            rail: Vec::new(),
        };
        let parts = drawn.child("Parts");
        for node in parts.iter().flat_map(Element::elements) {
            let id = node.attribute("UId").unwrap_or_default();
            if node.is("Access") {
                accesses.insert(id, access::operand(node, 0));
            } else {
                numbers.insert(id, reader.parts.len());
                reader.parts.push(part(xml.place(node), node));
            }
        }
        let wires = drawn.child("Wires");
        for wire in wires.iter().flat_map(|list| list.children_of("Wire")) {
            let ends = wire.elements().filter_map(|end| {
                let id = end.attribute("UId").unwrap_or_default();
                if end.is("Powerrail") {
                    return Some(End::Rail);
                }
                if end.is("IdentCon") {
                    return Some(End::Operand(accesses.get(id)?.clone()));
                }
                let pin = end.attribute("Name")?;
                Some(End::Pin(*numbers.get(id)?, pin))
            });
            let ends: Vec<End<'_>> = ends.collect();
            reader.wire(&ends, unit);
        }
        reader
    }

    fn wire(&mut self, ends: &[End<'_>], unit: &mut Unit) {
        let Some((first, rest)) = ends.split_first() else {
            return;
        };
        match first {
            End::Operand(text) => {
                for end in rest {
                    if let End::Pin(part, pin) = end {
                        self.give(*part, pin, Value::Operand(text.clone()), false);
                    }
                }
            }
            End::Rail => rest.iter().for_each(|end| self.power(Source::Rail, end)),
            End::Pin(part, pin) if pin.eq_ignore_ascii_case(self.parts[*part].leaves) => {
                for end in rest {
                    match end {
                        // A coil of its own in the place of the operand.
                        End::Operand(text) => self.give(*part, pin, Value::Operand(text.clone()), true),
                        end => self.power(Source::Part(*part), end),
                    }
                }
            }
            End::Pin(part, pin) => {
                for end in rest {
                    match end {
                        End::Operand(text) => self.give(*part, pin, Value::Operand(text.clone()), true),
                        End::Pin(to, into) => {
                            let text = self.between(*part, pin, unit);
                            self.give(*to, into, Value::Operand(text), false);
                        }
                        End::Rail => {}
                    }
                }
            }
        }
    }

    /// A variable for a value on its way from one part to another.
    fn between(&mut self, part: usize, pin: &str, unit: &mut Unit) -> String {
        let drawn = &mut self.parts[part];
        if let Some(Value::Operand(text)) = drawn.part.pin(pin).map(|argument| &argument.value) {
            return text.clone();
        }
        let ty = match pin.to_ascii_uppercase().as_str() {
            "ET" => "Time",
            "CV" => "DInt",
            "QD" | "QU" | "Q" => "Bool",
            _ => ["DestType", "SrcType", "value_type"]
                .iter()
                .find_map(|name| drawn.part.template(name))
                .unwrap_or("Int"),
        };
        let name = format!("value_{}", unit.variables.len());
        unit.variables.push(Variable {
            place: drawn.part.place,
            name: name.clone(),
            role: Role::Temp,
            ty: Type::Named(ty.to_owned()),
            comment: Some("a value on its way from one part to another".to_owned()),
            ..Variable::default()
        });
        let text = format!("#\"{name}\"");
        self.give(part, pin, Value::Operand(text.clone()), true);
        text
    }

    fn give(&mut self, part: usize, pin: &str, value: Value, is_output: bool) {
        let part = &mut self.parts[part].part;
        part.arguments.push(Argument {
            pin: Some(pin_here(&part.name, pin).to_owned()),
            value,
            is_output,
        });
    }

    /// Power goes from a source to a pin.
    fn power(&mut self, source: Source, end: &End<'_>) {
        let End::Pin(part, pin) = end else { return };
        let drawn = &mut self.parts[*part];
        let sink = if drawn.is_or {
            Sink::Or(*part)
        } else if pin.eq_ignore_ascii_case(drawn.enters) {
            drawn.source = Some(source);
            Sink::Part(*part)
        } else {
            let point = Self::point(source);
            self.give(*part, pin, Value::Power(point), false);
            Sink::Pin
        };
        match source {
            Source::Rail => self.rail.push(sink),
            Source::Part(from) => self.parts[from].sinks.push(sink),
        }
    }

    /// The point where the power of a source is.
    fn point(source: Source) -> usize {
        match source {
            Source::Rail => RAIL,
            Source::Part(part) => part + 1,
        }
    }

    fn net(mut self) -> Net {
        let mut net = Net {
            points: self.parts.len() + 2,
            wires: Vec::new(),
        };
        for sink in &self.rail {
            if let Sink::Or(or) = sink {
                net.wires.push(bare(RAIL, or + 1));
            }
        }
        let mut is_done = vec![false; self.parts.len()];
        // What begins a wire comes first; what is in a circle is left.
        for only_first in [true, false] {
            for number in 0..self.parts.len() {
                if is_done[number] || self.parts[number].is_or || (only_first && self.goes_on(number)) {
                    continue;
                }
                self.wire_from(number, &mut is_done, &mut net);
            }
        }
        for (number, drawn) in self.parts.iter().enumerate().filter(|(_, drawn)| drawn.is_or) {
            for sink in &drawn.sinks {
                if let Sink::Or(or) = sink {
                    net.wires.push(bare(number + 1, or + 1));
                }
            }
        }
        net
    }

    /// Whether a part is on a wire after another.
    fn goes_on(&self, number: usize) -> bool {
        match self.parts[number].source {
            Some(Source::Part(before)) => !self.parts[before].is_or && self.parts[before].sinks.len() == 1,
            _ => false,
        }
    }

    /// A wire, from a part on to where power parts or comes together.
    fn wire_from(&mut self, first: usize, is_done: &mut [bool], net: &mut Net) {
        let from = match self.parts[first].source {
            Some(source) => Self::point(source),
            // A box without its EN always runs.
            None if self.parts[first].enters == "en" => RAIL,
            None => self.parts.len() + 1,
        };
        let mut parts = Vec::new();
        let mut at = first;
        let to = loop {
            is_done[at] = true;
            let drawn = &mut self.parts[at];
            let mut part = std::mem::take(&mut drawn.part);
            for pin in std::mem::take(&mut drawn.negated) {
                negate(&mut part, &pin, drawn.enters, &mut parts);
            }
            part.text = shown(&part);
            parts.push(part);
            match self.parts[at].sinks[..] {
                [] => break None,
                [Sink::Or(or)] => break Some(or + 1),
                [Sink::Part(next)] if !is_done[next] => at = next,
                _ => break Some(at + 1),
            }
        };
        net.wires.push(Wire { from, to, parts });
        if self.parts[at].sinks.len() > 1 {
            for sink in &self.parts[at].sinks {
                if let Sink::Or(or) = sink {
                    net.wires.push(bare(at + 1, or + 1));
                }
            }
        }
    }
}

fn bare(from: usize, to: usize) -> Wire {
    Wire {
        from,
        to: Some(to),
        parts: Vec::new(),
    }
}

/// A pin that is inverted.
fn negate(part: &mut Part, pin: &str, enters: &str, before: &mut Vec<Part>) {
    match (part.name.as_str(), pin) {
        ("Contact" | "Coil", "operand") => part.name = format!("I_{}", part.name),
        (_, pin) if pin.eq_ignore_ascii_case(enters) => before.push(Part {
            place: part.place,
            name: "Not".to_owned(),
            text: "Not( )".to_owned(),
            ..Part::default()
        }),
        (name, pin) => part.name = format!("{name} with {pin} inverted"),
    }
}

/// A part as a source document writes it.
fn shown(part: &Part) -> String {
    let arguments = part.arguments.iter().map(|argument| {
        let sign = if argument.is_output { "=>" } else { ":=" };
        match (&argument.pin, &argument.value) {
            (Some(pin), Value::Operand(text)) => format!("{pin} {sign} {text}"),
            (pin, _) => pin.clone().unwrap_or_default(),
        }
    });
    let arguments: Vec<String> = arguments.collect();
    let instance = part
        .instance
        .as_ref()
        .map(|name| format!("{name}."))
        .unwrap_or_default();
    format!("{instance}{}( {} )", part.name, arguments.join(", "))
}

fn part(place: LineColumn, node: Node<'_, '_>) -> Drawn {
    let mut part = Part {
        place,
        ..Part::default()
    };
    let call = node.child("CallInfo");
    let instance = call.unwrap_or(node).child("Instance");
    let instance = instance.map(|it| access::path(it, it.attribute("Scope").unwrap_or_default(), 0));
    let name = node.attribute("Name").unwrap_or_default();
    let row = of_xml(name);
    if let Some(call) = call {
        let own = format!("\"{}\"", call.attribute("Name").unwrap_or_default());
        part.name = instance.unwrap_or(own);
    } else {
        row.map_or(name, |row| row.sd[0]).clone_into(&mut part.name);
        part.instance = instance;
    }
    let values = node
        .children_of("TemplateValue")
        .filter(|value| value.attribute("Type") == Some("Type"));
    part.templates = values
        .map(|value| {
            (
                value.attribute("Name").unwrap_or_default().to_owned(),
                value.words(),
            )
        })
        .collect();
    part.formula = node.child("Equation").map(|formula| formula.words());
    let (enters, leaves) = power_pins(name);
    let is_or = name == "O";
    let leaves = if is_or { "out" } else { leaves };
    Drawn {
        part,
        is_or,
        negated: node
            .children_of("Negated")
            .filter_map(|negated| negated.attribute("Name").map(str::to_owned))
            .collect(),
        enters,
        leaves,
        source: None,
        sinks: Vec::new(),
    }
}
