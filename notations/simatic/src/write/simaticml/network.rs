//! A network: its operands, its parts, and the wires between their pins.

use super::access::{LABEL, access, components};
use super::graph::{Graph, Node, Shape, Source};
use crate::model::{Argument, Net, Part, Role, Unit, Value, Variable};
use crate::operand::operand;
use crate::scope::Scope;
use crate::standard::{Form, Pins, power_pins};
use ladder_instructions::Op;
use ladder_notation::xml::XmlText;
use std::collections::HashSet;

/// The form that TIA Portal V17 writes.
const FLGNET: &str = "http://www.siemens.com/automation/Openness/SW/NetworkSource/FlgNet/v4";

/// A wire's end at a part.
fn pin(xml: &mut XmlText, id: &str, name: &str) {
    xml.empty("NameCon", &[("UId", id), ("Name", name)]);
}

/// The next numbers: each is that of one thing of a network.
struct Ids(u32);

impl Ids {
    fn next(&mut self) -> String {
        self.0 += 1;
        self.0.to_string()
    }
}

/// TIA Portal itself begins with 21.
const FIRST: u32 = 20;

/// A network.
///
/// # Errors
///
/// Why it has no form there.
pub(super) fn network<'n>(
    xml: &mut XmlText,
    net: &'n Net,
    label: Option<&str>,
    (unit, scope): (&'n Unit, &mut Scope<'n>),
) -> Result<(), String> {
    let graph = Graph::of(net, scope)?;
    let mut ids = Ids(FIRST);
    let mut done = Ok(());
    xml.around("FlgNet", &[("xmlns", FLGNET)], |xml| {
        if let Some(label) = label {
            xml.around("Labels", &[], |xml| {
                xml.around("LabelDeclaration", &[("UId", &ids.next())], |xml| {
                    xml.empty("Label", &[("Name", label)]);
                });
            });
        }
        let mut named = (Vec::new(), Vec::new());
        xml.around("Parts", &[], |xml| {
            match parts(xml, &graph, &mut ids, unit, scope) {
                Ok(found) => named = found,
                Err(why) => done = Err(why),
            }
        });
        xml.around("Wires", &[], |xml| wires(xml, &graph, &mut ids, &named));
    });
    done
}

/// The numbers of the operands of each node, and of the nodes.
type Named = (Vec<Vec<Option<String>>>, Vec<String>);

/// Operands, and then parts.
fn parts<'n>(
    xml: &mut XmlText,
    graph: &Graph<'n>,
    ids: &mut Ids,
    unit: &'n Unit,
    scope: &mut Scope<'n>,
) -> Result<Named, String> {
    let (mut operands, mut nodes) = (Vec::new(), Vec::new());
    for node in &graph.nodes {
        let mut own = Vec::new();
        if let Node::Part(part, shape) = node {
            for argument in &part.arguments {
                let Value::Operand(text) = &argument.value else {
                    own.push(None);
                    continue;
                };
                let id = ids.next();
                let ty = constant_type(part, shape, argument, text, scope);
                access(xml, (text, &ty), Some(&id), unit)?;
                own.push(Some(id));
            }
        }
        operands.push(own);
    }
    for node in &graph.nodes {
        let id = ids.next();
        match node {
            Node::Or(count) => xml.around("Part", &[("Name", "O"), ("UId", &id)], |xml| {
                template(xml, "Card", "Cardinality", &count.to_string());
            }),
            Node::Part(part, shape) => match shape.callee {
                Some(callee) => call(xml, (part, callee), (&id, &ids.next()), unit)?,
                None => instruction(xml, (part, shape), &id, ids, unit)?,
            },
        }
        nodes.push(id);
    }
    Ok((operands, nodes))
}

fn template(xml: &mut XmlText, name: &str, ty: &str, value: &str) {
    xml.words("TemplateValue", &[("Name", name), ("Type", ty)], value);
}

/// What holds a state.
fn instance(xml: &mut XmlText, path: &str, id: &str, unit: &Unit) -> Result<(), String> {
    let scope = if path.starts_with('#') {
        "LocalVariable"
    } else {
        "GlobalVariable"
    };
    let mut done = Ok(());
    xml.around("Instance", &[("Scope", scope), ("UId", id)], |xml| {
        done = components(xml, path, unit);
    });
    done
}

fn instruction(
    xml: &mut XmlText,
    (part, shape): (&Part, &Shape<'_>),
    id: &str,
    ids: &mut Ids,
    unit: &Unit,
) -> Result<(), String> {
    let row = shape.row;
    let mut attributes = vec![("Name", shape.name)];
    attributes.extend(row.filter(|row| row.is_of_library()).map(|_| ("Version", "1.0")));
    attributes.push(("UId", id));
    // The ENO of `SEL` is always its EN.
    if power_pins(shape.name) == ("en", "eno") && !matches!(shape.name, "SEL" | "SBitfield" | "RBitfield") {
        attributes.push(("DisabledENO", "true"));
    }
    let mut done = Ok(());
    xml.around("Part", &attributes, |xml| {
        if let Some(formula) = &part.formula {
            xml.words("Equation", &[], formula);
        }
        if let Some(path) = &part.instance {
            done = instance(xml, path, &ids.next(), unit);
        }
        let inputs = part
            .arguments
            .iter()
            .filter(|argument| !argument.is_output)
            .count();
        let count = match row.map(|row| row.form) {
            Some(Form::Move) => Some(1),
            Some(Form::Calculate | Form::Value(_, Pins::Numbered)) => Some(inputs),
            Some(Form::Value(_, Pins::Selected("k"))) => Some(inputs.saturating_sub(1)),
            _ => None,
        };
        if let Some(count) = count {
            template(xml, "Card", "Cardinality", &count.to_string());
        }
        for (name, ty) in &part.templates {
            template(xml, name, "Type", ty);
        }
        if shape.negated {
            xml.empty("Negated", &[("Name", "operand")]);
        }
    });
    done
}

fn call(
    xml: &mut XmlText,
    (part, callee): (&Part, &Unit),
    (id, held): (&str, &str),
    unit: &Unit,
) -> Result<(), String> {
    let mut done = Ok(());
    xml.around("Call", &[("UId", id)], |xml| {
        let info = [("Name", callee.name.as_str()), ("BlockType", "FB")];
        xml.around("CallInfo", &info, |xml| {
            done = instance(xml, &part.name, held, unit);
            for own in part
                .arguments
                .iter()
                .filter_map(|argument| parameter(callee, argument))
            {
                let section = super::section(own.role);
                let ty = own.ty.to_string();
                xml.empty(
                    "Parameter",
                    &[("Name", &own.name), ("Section", section), ("Type", &ty)],
                );
            }
        });
    });
    done
}

/// What a block declares of a pin.
fn parameter<'u>(callee: &'u Unit, argument: &Argument) -> Option<&'u Variable> {
    let pin = argument.pin.as_deref()?;
    let mut all = callee.variables.iter();
    all.find(|own| own.name.eq_ignore_ascii_case(pin) && own.role != Role::Static)
}

/// The type of a constant at a pin.
fn constant_type(
    part: &Part,
    shape: &Shape<'_>,
    argument: &Argument,
    text: &str,
    scope: &mut Scope<'_>,
) -> String {
    let pin = argument.pin.as_deref().unwrap_or_default();
    let own = match (shape.row.map(|row| row.form), pin) {
        (Some(Form::Jump { .. }), _) => Some(LABEL.to_owned()),
        (None, _) => shape
            .callee
            .and_then(|callee| parameter(callee, argument))
            .map(|own| own.ty.to_string()),
        (_, "n" | "k") => Some("Int".to_owned()),
        (Some(Form::Move), _) => part
            .pin("out1")
            .and_then(|out| match &out.value {
                Value::Operand(text) => operand(scope, text, "").ok()?.ty,
                _ => None,
            })
            .map(|ty| ty.to_string()),
        _ => part.templates.first().map(|(_, ty)| ty.clone()),
    };
    let shown = match text {
        "TRUE" | "FALSE" => "Bool",
        text if text.starts_with('\'') => "String",
        text if text.contains(['.', 'e', 'E']) && !text.contains('#') => "LReal",
        _ => "DInt",
    };
    match own {
        Some(own) if shown != "Bool" && shown != "String" => own,
        _ => shown.to_owned(),
    }
}

/// The wires in the order of the nodes: that which brings the power, and those of the other pins.
fn wires(xml: &mut XmlText, graph: &Graph<'_>, ids: &mut Ids, (operands, nodes): &Named) {
    let mut is_drawn: HashSet<Source> = HashSet::new();
    for (number, node) in graph.nodes.iter().enumerate() {
        let Some(id) = nodes.get(number) else { return };
        for source in &graph.sources[number] {
            if !is_drawn.insert(*source) {
                continue;
            }
            xml.around("Wire", &[("UId", &ids.next())], |xml| {
                match source {
                    Source::Rail => xml.empty("Powerrail", &[]),
                    Source::Pin(from, name) => pin(xml, &nodes[*from], name),
                }
                for (to, name) in graph.sinks.get(source).into_iter().flatten() {
                    pin(xml, &nodes[*to], name);
                }
            });
        }
        let Node::Part(part, shape) = node else { continue };
        for (argument, operand) in part.arguments.iter().zip(&operands[number]) {
            let Some(operand) = operand else { continue };
            let name = argument.pin.as_deref().unwrap_or_default();
            let name = shape
                .row
                .map_or_else(|| name.to_owned(), |row| row.pin_there(name));
            let is_read = !argument.is_output || shape.row.is_some_and(|row| row.form.is_coil());
            xml.around("Wire", &[("UId", &ids.next())], |xml| {
                if is_read {
                    xml.empty("IdentCon", &[("UId", operand)]);
                }
                pin(xml, id, &name);
                if !is_read {
                    xml.empty("IdentCon", &[("UId", operand)]);
                }
            });
        }
        let is_taken = |name: &&'static str| graph.sinks.contains_key(&Source::Pin(number, name));
        for (name, is_output) in open_pins(part, shape, is_taken) {
            let (wire, open) = (ids.next(), ids.next());
            xml.around("Wire", &[("UId", &wire)], |xml| {
                if !is_output {
                    xml.empty("OpenCon", &[("UId", &open)]);
                }
                pin(xml, id, &name);
                if is_output {
                    xml.empty("OpenCon", &[("UId", &open)]);
                }
            });
        }
    }
}

/// The pins of a timer or counter at which nothing is, and whether they are outputs: all of them are wired there.
fn open_pins(
    part: &Part,
    shape: &Shape<'_>,
    is_taken: impl Fn(&&'static str) -> bool,
) -> Vec<(String, bool)> {
    let Some(row) = shape.row else { return Vec::new() };
    let Form::State(op, pins) = row.form else {
        return Vec::new();
    };
    let inputs = pins
        .iter()
        .map(|(pin, _)| *pin)
        .filter(|pin| part.pin(pin).is_none());
    let leaves = Some(power_pins(shape.name).1).filter(|name| !is_taken(name));
    let others = part
        .arguments
        .iter()
        .filter(|argument| argument.value == Value::Open);
    let others = others.filter_map(|argument| argument.pin.as_deref());
    let falls = (op == Op::Ctud).then_some("QD");
    let outputs = leaves.into_iter().chain(others).chain(falls);
    let inputs = inputs.map(|pin| (row.pin_there(pin), false));
    inputs
        .chain(outputs.map(|pin| (row.pin_there(pin), true)))
        .collect()
}
