//! What the elements of a drawing are: the classes of blocks, their pins, the types of their outputs.

use super::body::Body;
use crate::brought;
use crate::expression::type_text;
use crate::graph::{Edge, End, Kind, Modifier, Node, Output, Pin, Storage};
use crate::model::{Type, UnitKind};
use crate::scope::Shared;
use crate::standard::{self, Function, Gate, StandardBlock};

/// What a block is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Class {
    /// Wires.
    Gate(Gate),
    /// A condition: its mnemonic.
    Compare(&'static str),
    /// AND, OR, XOR, NOT and comparisons of which a tag holds the result.
    Logic(Function),
    /// An instruction that makes a value, by its mnemonic.
    Value(&'static str),
    /// A value in another type.
    Convert,
    /// A timer, a counter, a bistable, an edge detector.
    Standard(StandardBlock),
    /// A unit of the project.
    Unit(UnitKind),
    /// A text in ST that is read.
    Text,
    /// One that is not, or what neither the project nor ladder text has.
    Unknown,
}

impl Class {
    /// Whether it does something, once in a scan; else it only decides.
    pub(super) fn acts(self) -> bool {
        !matches!(self, Class::Gate(_) | Class::Compare(_))
    }
}

/// The class of a block.
pub(super) fn class(body: &Body<'_>, node: usize) -> Option<Class> {
    let drawn = &body.graph.nodes[node];
    let Kind::Block { name, code, .. } = &drawn.kind else {
        return None;
    };
    if code.is_some() {
        let is_read = body.has_text(node);
        return Some(if is_read { Class::Text } else { Class::Unknown });
    }
    if let Some(block) = body.shared.blocks.get(&name.to_lowercase()) {
        return Some(Class::Unit(block.unit.kind));
    }
    if let Some(block) = standard::block(name) {
        return Some(Class::Standard(block));
    }
    let Some(function) = standard::function(name) else {
        return Some(Class::Unknown);
    };
    let is_taken = |(output, it): (usize, &Output)| {
        is_enable_out(&it.name) && body.facts.uses.contains_key(&End { node, output })
    };
    let has_enable =
        drawn.inputs.iter().any(|pin| is_enable(&pin.name)) || drawn.outputs.iter().enumerate().any(is_taken);
    let has_enable = has_enable && !only_decides(body, node);
    Some(match function {
        Function::Gate(gate) if is_bits(body, node) => {
            Class::Value(["AND", "OR", "XOR", "NOT"][gate as usize])
        }
        Function::Gate(Gate::Xor) => Class::Logic(function),
        Function::Gate(gate) if !has_enable => Class::Gate(gate),
        Function::Compare(mnemonic, _) if !has_enable => Class::Compare(mnemonic),
        Function::Gate(_) | Function::Compare(..) => Class::Logic(function),
        Function::Value(mnemonic) => Class::Value(mnemonic),
        Function::Convert(_) => Class::Convert,
    })
}

/// Whether power goes on from a comparison with EN as one goes on from a contact: nothing takes ENO, and no variable the result,
/// which would keep its value without EN.
fn only_decides(body: &Body<'_>, node: usize) -> bool {
    let drawn = &body.graph.nodes[node];
    let is_compare = matches!(&drawn.kind, Kind::Block { name, .. } if matches!(standard::function(name), Some(Function::Compare(..))));
    let takes = |output: usize| {
        body.facts
            .uses
            .get(&End { node, output })
            .map_or(&[][..], Vec::as_slice)
    };
    let is_variable = |user: &usize| matches!(body.graph.nodes[*user].kind, Kind::Variable(..));
    let is_power = |(output, it): (usize, &Output)| {
        let is_taken = !takes(output).is_empty() && !takes(output).iter().any(is_variable);
        if is_enable_out(&it.name) {
            takes(output).is_empty()
        } else {
            is_taken
        }
    };
    is_compare && drawn.outputs.iter().enumerate().all(is_power)
}

/// Whether the inputs of a gate are words, and not power.
fn is_bits(body: &Body<'_>, node: usize) -> bool {
    let drawn = &body.graph.nodes[node];
    let values = drawn
        .inputs
        .iter()
        .filter(|pin| !is_enable(&pin.name))
        .flat_map(|pin| &pin.from);
    let mut types = values.filter_map(|end| match &body.graph.nodes[end.node].kind {
        Kind::Value(text, _) => body.operand(text).ok()?.ty,
        Kind::Block { name, .. } => match standard::function(name)? {
            Function::Convert(ty) => Some(Type::Named(ty.to_owned())),
            _ => None,
        },
        _ => None,
    });
    types.any(|ty| matches!(body.shared.real(&ty), Type::Named(name) if standard::elementary(name).is_some_and(|name| name != "BOOL")))
}

pub(super) fn is_enable(pin: &str) -> bool {
    pin.eq_ignore_ascii_case("EN")
}

pub(super) fn is_enable_out(pin: &str) -> bool {
    pin.eq_ignore_ascii_case("ENO")
}

/// What a pin of a unit of the project is called in the unit's own text.
pub(super) fn named_in_unit<'b>(body: &'b Body<'_>, node: usize, pin: &str) -> Option<&'b str> {
    let Kind::Block { name, .. } = &body.graph.nodes[node].kind else {
        return None;
    };
    let unit = body.shared.blocks.get(&name.to_lowercase())?;
    unit.scope.get(pin).map(|known| known.path.root.as_str())
}

/// The pins that power enters, in series: EN, and what starts a timer.
pub(super) fn power_pins(body: &Body<'_>, node: usize) -> Vec<usize> {
    let drawn = &body.graph.nodes[node];
    let mut pins: Vec<usize> = Vec::new();
    let is_own = |pin: &str| named_in_unit(body, node, pin) == Some("EN");
    let enables = |pin: &Pin| is_enable(&pin.name) || is_own(&pin.name);
    pins.extend((0..drawn.inputs.len()).filter(|pin| enables(&drawn.inputs[*pin])));
    let first = match body.class(node) {
        Some(Class::Standard(StandardBlock::Stateful(_, pin, _))) => pin,
        Some(Class::Standard(_)) => "CLK",
        _ => return pins,
    };
    let is_first = |name: &str| standard::is_pin(name, first);
    let named = drawn.inputs.iter().position(|pin| is_first(&pin.name));
    pins.extend(
        named
            .or_else(|| (!drawn.inputs.is_empty()).then_some(0))
            .filter(|pin| !pins.contains(pin)),
    );
    pins
}

/// The pins that are operands.
pub(super) fn operand_pins(body: &Body<'_>, node: usize) -> Vec<usize> {
    let power = power_pins(body, node);
    (0..body.graph.nodes[node].inputs.len())
        .filter(|pin| !power.contains(pin))
        .collect()
}

/// The output that power leaves.
pub(super) fn power_output(body: &Body<'_>, node: usize) -> Option<usize> {
    let outputs = &body.graph.nodes[node].outputs;
    let named = |name: &str| {
        outputs
            .iter()
            .position(|output| output.name.eq_ignore_ascii_case(name))
    };
    match body.class(node)? {
        Class::Standard(block) => named(standard::power_output(block)).or_else(|| {
            let is_only = outputs.len() == 1;
            is_only.then_some(0)
        }),
        Class::Gate(_) | Class::Compare(_) => result_output(&body.graph.nodes[node]),
        Class::Unknown | Class::Text => {
            named("ENO").or_else(|| is_text(&body.graph.nodes[node]).then_some(0))
        }
        _ => named("ENO")
            .or_else(|| {
                let mut outputs = outputs.iter();
                outputs.position(|output| named_in_unit(body, node, &output.name) == Some("ENO"))
            })
            .or_else(|| {
                let Kind::Block { name, .. } = &body.graph.nodes[node].kind else {
                    return None;
                };
                let block = body.shared.blocks.get(&name.to_lowercase())?;
                outputs
                    .iter()
                    .position(|output| brought::is_power(block.unit, &output.name))
            }),
    }
}

/// Whether a block is a text in ST.
fn is_text(node: &Node) -> bool {
    matches!(node.kind, Kind::Block { code: Some(_), .. })
}

/// The output that a function's result leaves.
pub(super) fn result_output(node: &Node) -> Option<usize> {
    node.outputs
        .iter()
        .position(|output| !is_enable_out(&output.name))
}

/// The type of the tag that a block has: its state, or the power after an edge detector.
pub(super) fn state(shared: &Shared<'_>, name: &str) -> Option<String> {
    if let Some(block) = shared.blocks.get(&name.to_lowercase()) {
        return (block.unit.kind == UnitKind::FunctionBlock).then(|| block.name.clone());
    }
    match standard::block(name)? {
        StandardBlock::Stateful(mnemonic, ..) => Some(mnemonic.to_owned()),
        StandardBlock::Rising | StandardBlock::Falling => Some("BOOL".to_owned()),
    }
}

impl Body<'_> {
    /// The type of what leaves an output.
    pub(super) fn out_type(&mut self, end: End) -> Option<Type> {
        if let Some(ty) = self.tags.types.get(&end) {
            return ty.clone();
        }
        // What asks for itself is not known.
        self.tags.types.insert(end, None);
        let ty = self.find_type(end);
        self.tags.types.insert(end, ty.clone());
        ty
    }

    fn find_type(&mut self, end: End) -> Option<Type> {
        let named = |name: &str| Some(Type::Named(name.to_owned()));
        let drawn = &self.graph.nodes[end.node];
        let Kind::Block { name, .. } = &drawn.kind else {
            return match &drawn.kind {
                Kind::Value(text, _) => self.operand(text).ok()?.ty,
                Kind::Joint => {
                    let first = drawn.inputs.first()?.from.first().copied()?;
                    self.out_type(first)
                }
                _ => named("BOOL"),
            };
        };
        let output = drawn.outputs.get(end.output)?;
        if is_enable_out(&output.name) {
            return named("BOOL");
        }
        match self.class(end.node)? {
            Class::Gate(_) | Class::Compare(_) | Class::Logic(_) => named("BOOL"),
            Class::Standard(_) => named(standard::output_type(&output.name)),
            Class::Unit(_) => {
                let block = self.shared.blocks.get(&name.to_lowercase())?;
                let known = block.scope.get(&output.name).filter(|_| !output.name.is_empty());
                known
                    .map(|known| known.ty.clone())
                    .or_else(|| block.unit.returns.clone())
            }
            Class::Convert => match standard::function(name)? {
                Function::Convert(ty) => named(ty),
                _ => None,
            },
            Class::Unknown | Class::Text => None,
            Class::Value(mnemonic) => {
                if matches!(mnemonic, "LEN" | "FIND") {
                    return named("INT");
                }
                let skipped = usize::from(matches!(mnemonic, "SEL" | "MUX"));
                let pins = operand_pins(self, end.node);
                let mut found = None;
                for pin in pins.into_iter().skip(skipped) {
                    for end in self.graph.nodes[end.node].inputs[pin].from.clone() {
                        found = found.or_else(|| self.out_type(end));
                    }
                }
                found
            }
        }
    }

    /// Whether what leaves an output is power. Where that is not known, what takes it decides.
    pub(super) fn is_power(&mut self, end: End) -> Option<bool> {
        let ty = self.out_type(end)?;
        Some(matches!(self.shared.real(&ty), Type::Named(name) if standard::elementary(name) == Some("BOOL")))
    }

    /// A type as it is declared.
    pub(super) fn type_text(&self, ty: &Type) -> Result<String, String> {
        type_text(self.shared, ty)
    }
}

/// An element in words: `contact X0`, `TON T1`.
pub(super) fn shown(node: &Node) -> String {
    let modified = |modifier: &Modifier| {
        let edge = match modifier.edge {
            Edge::None => "",
            Edge::Rising => ", rising",
            Edge::Falling => ", falling",
        };
        format!("{}{edge}", if modifier.negated { ", negated" } else { "" })
    };
    match &node.kind {
        Kind::LeftRail => "left rail".to_owned(),
        Kind::RightRail => "right rail".to_owned(),
        Kind::Contact(tag, modifier) => format!("contact {tag}{}", modified(modifier)),
        Kind::Coil(tag, modifier, storage) => {
            let storage = match storage {
                Storage::None => "",
                Storage::Set => ", set",
                Storage::Reset => ", reset",
            };
            format!("coil {tag}{storage}{}", modified(modifier))
        }
        Kind::Block { name, instance, .. } => match instance {
            Some(instance) => format!("{name} {instance}"),
            None => format!("block {name}"),
        },
        Kind::Value(text, _) => format!("input {text}"),
        Kind::Variable(text, _) => format!("output {text}"),
        Kind::Label(name) => format!("label {name}"),
        Kind::Jump(name, _) => format!("jump {name}"),
        Kind::Return(_) => "return".to_owned(),
        Kind::Joint => "connection".to_owned(),
        Kind::Comment(text) => format!("comment {}", text.lines().next().unwrap_or_default()),
        Kind::Other(what) => what.clone(),
    }
}

/// Whether a part that is not read may stand for an element: it leaves the unit nowhere.
pub(super) fn may_be_unread(kind: &Kind) -> bool {
    match kind {
        Kind::Block { code, .. } => code.is_none(),
        Kind::Contact(..) | Kind::Coil(..) | Kind::Value(..) | Kind::Variable(..) => true,
        _ => false,
    }
}
