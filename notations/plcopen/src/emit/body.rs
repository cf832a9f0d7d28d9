//! The elements of a drawing.

use super::layout::{self, lay_out};
use crate::graph::{Edge, End, Graph, Kind, Modifier, Node, Pin, Storage};
use ladder_notation::xml::XmlText;

/// A drawing in LD.
pub(super) fn body(xml: &mut XmlText, mut graph: Graph) {
    lay_out(&mut graph);
    xml.around("LD", &[], |xml| {
        let rails = Rails::of(&graph);
        for (number, node) in graph.nodes.iter().enumerate() {
            element(xml, &graph, number, node, &rails);
        }
        rails.right(xml, &graph);
    });
}

/// What ends at rails.
struct Rails {
    /// For each left rail the heights at which power leaves it.
    left: Vec<Vec<f64>>,
    /// For each network the outputs that end at its right rail.
    right: Vec<Vec<End>>,
}

impl Rails {
    fn of(graph: &Graph) -> Rails {
        let mut left = vec![Vec::new(); graph.nodes.len()];
        let mut used = vec![false; graph.nodes.len()];
        for node in &graph.nodes {
            for (number, pin) in node.inputs.iter().enumerate() {
                for end in &pin.from {
                    used[end.node] = true;
                    if graph.nodes[end.node].kind == Kind::LeftRail {
                        let (_, y) = layout::at(node, layout::pin(node, number));
                        if !left[end.node].contains(&y) {
                            left[end.node].push(y);
                        }
                    }
                }
            }
        }
        for heights in &mut left {
            heights.sort_by(f64::total_cmp);
        }
        let mut right: Vec<Vec<End>> = Vec::new();
        for (number, node) in graph.nodes.iter().enumerate() {
            match node.kind {
                Kind::LeftRail => right.push(Vec::new()),
                Kind::Coil(..) if !used[number] => {
                    if let Some(last) = right.last_mut() {
                        last.push(End {
                            node: number,
                            output: 0,
                        });
                    }
                }
                _ => {}
            }
        }
        Rails { left, right }
    }

    /// The right rails, after all that feeds them.
    fn right(&self, xml: &mut XmlText, graph: &Graph) {
        let mut id = graph.nodes.len();
        for ends in self.right.iter().filter(|ends| !ends.is_empty()) {
            id += 1;
            let points: Vec<(f64, f64)> = ends
                .iter()
                .map(|end| {
                    let node = &graph.nodes[end.node];
                    layout::at(node, layout::output(node, end.output))
                })
                .collect();
            let x = points.iter().map(|(x, _)| *x).fold(0.0, f64::max) + 40.0;
            let top = points.iter().map(|(_, y)| *y).fold(f64::INFINITY, f64::min) - 20.0;
            let bottom = points.iter().map(|(_, y)| *y).fold(0.0, f64::max) + 20.0;
            let attributes = [
                ("localId", id.to_string()),
                ("height", (bottom - top).to_string()),
                ("width", "10".to_owned()),
            ];
            around(xml, "rightPowerRail", &attributes, |xml| {
                position(xml, "position", (x, top));
                for (end, point) in ends.iter().zip(&points) {
                    xml.around("connectionPointIn", &[], |xml| {
                        position(xml, "relPosition", (0.0, point.1 - top));
                        connection(xml, graph, *end, (x, point.1));
                    });
                }
            });
        }
    }
}

fn around(xml: &mut XmlText, name: &str, attributes: &[(&str, String)], inside: impl FnOnce(&mut XmlText)) {
    let attributes: Vec<(&str, &str)> = attributes
        .iter()
        .map(|(key, value)| (*key, value.as_str()))
        .collect();
    xml.around(name, &attributes, inside);
}

fn position(xml: &mut XmlText, name: &str, (x, y): (f64, f64)) {
    xml.empty(name, &[("x", &x.to_string()), ("y", &y.to_string())]);
}

/// A wire, from the pin where it ends to the output where it begins.
fn connection(xml: &mut XmlText, graph: &Graph, end: End, to: (f64, f64)) {
    let source = &graph.nodes[end.node];
    let (mut from, mut name) = (layout::at(source, layout::output(source, end.output)), None);
    match &source.kind {
        Kind::Block { .. } => name = source.outputs.get(end.output).map(|output| output.name.as_str()),
        Kind::LeftRail => from.1 = to.1,
        _ => {}
    }
    let id = (end.node + 1).to_string();
    let mut attributes = vec![("refLocalId", id.as_str())];
    attributes.extend(name.map(|name| ("formalParameter", name)));
    xml.around("connection", &attributes, |xml| {
        position(xml, "position", to);
        if (from.1 - to.1).abs() > 0.5 {
            // Down, or up, right before the pin.
            let middle = (to.0 - 20.0).max(from.0);
            position(xml, "position", (middle, to.1));
            position(xml, "position", (middle, from.1));
        }
        position(xml, "position", from);
    });
}

fn point_in(xml: &mut XmlText, graph: &Graph, node: &Node, number: usize) {
    xml.around("connectionPointIn", &[], |xml| {
        position(xml, "relPosition", layout::pin(node, number));
        let to = layout::at(node, layout::pin(node, number));
        for end in node.inputs.get(number).iter().flat_map(|pin| &pin.from) {
            connection(xml, graph, *end, to);
        }
    });
}

fn point_out(xml: &mut XmlText, node: &Node, number: usize) {
    xml.around("connectionPointOut", &[], |xml| {
        position(xml, "relPosition", layout::output(node, number));
    });
}

fn modified(attributes: &mut Vec<(&str, String)>, modifier: Modifier) {
    if modifier.negated {
        attributes.push(("negated", "true".to_owned()));
    }
    match modifier.edge {
        Edge::None => {}
        Edge::Rising => attributes.push(("edge", "rising".to_owned())),
        Edge::Falling => attributes.push(("edge", "falling".to_owned())),
    }
}

fn element(xml: &mut XmlText, graph: &Graph, number: usize, node: &Node, rails: &Rails) {
    let (width, height) = layout::size(node);
    let mut attributes = vec![
        ("localId", (number + 1).to_string()),
        ("height", height.to_string()),
        ("width", width.to_string()),
    ];
    match &node.kind {
        Kind::LeftRail => {
            let heights = &rails.left[number];
            let (top, bottom) = match (heights.first(), heights.last()) {
                (Some(top), Some(bottom)) => (top - 20.0, bottom + 20.0),
                _ => (node.position.1, node.position.1 + height),
            };
            attributes[1].1 = (bottom - top).to_string();
            around(xml, "leftPowerRail", &attributes, |xml| {
                position(xml, "position", (node.position.0, top));
                for y in heights {
                    xml.around("connectionPointOut", &[("formalParameter", "")], |xml| {
                        position(xml, "relPosition", (width, y - top));
                    });
                }
            });
        }
        Kind::Contact(tag, modifier) => {
            modified(&mut attributes, *modifier);
            switch(xml, graph, node, ("contact", &attributes), tag);
        }
        Kind::Coil(tag, modifier, storage) => {
            modified(&mut attributes, *modifier);
            match storage {
                Storage::None => {}
                Storage::Set => attributes.push(("storage", "set".to_owned())),
                Storage::Reset => attributes.push(("storage", "reset".to_owned())),
            }
            switch(xml, graph, node, ("coil", &attributes), tag);
        }
        Kind::Block { name, instance, .. } => {
            attributes.insert(1, ("typeName", name.clone()));
            if let Some(instance) = instance {
                attributes.insert(2, ("instanceName", instance.clone()));
            }
            around(xml, "block", &attributes, |xml| {
                position(xml, "position", node.position);
                xml.around("inputVariables", &[], |xml| {
                    for (number, pin) in node.inputs.iter().enumerate() {
                        variable(xml, pin, |xml| point_in(xml, graph, node, number));
                    }
                });
                xml.empty("inOutVariables", &[]);
                xml.around("outputVariables", &[], |xml| {
                    for (number, output) in node.outputs.iter().enumerate() {
                        xml.around("variable", &[("formalParameter", &output.name)], |xml| {
                            point_out(xml, node, number);
                        });
                    }
                });
            });
        }
        Kind::Value(text, _) => around(xml, "inVariable", &attributes, |xml| {
            position(xml, "position", node.position);
            point_out(xml, node, 0);
            xml.words("expression", &[], text);
        }),
        Kind::Variable(text, _) => around(xml, "outVariable", &attributes, |xml| {
            position(xml, "position", node.position);
            point_in(xml, graph, node, 0);
            xml.words("expression", &[], text);
        }),
        Kind::Label(label) | Kind::Jump(label, _) => {
            attributes.push(("label", label.clone()));
            let is_jump = matches!(node.kind, Kind::Jump(..));
            around(xml, if is_jump { "jump" } else { "label" }, &attributes, |xml| {
                position(xml, "position", node.position);
                if is_jump {
                    point_in(xml, graph, node, 0);
                }
            });
        }
        Kind::Return(_) => around(xml, "return", &attributes, |xml| {
            position(xml, "position", node.position);
            point_in(xml, graph, node, 0);
        }),
        Kind::Comment(told) => around(xml, "comment", &attributes, |xml| {
            position(xml, "position", node.position);
            xml.around("content", &[], |xml| xml.words("xhtml:p", &[], told));
        }),
        // The writer makes none of them.
        Kind::RightRail | Kind::Joint | Kind::Other(_) => {}
    }
}

fn variable(xml: &mut XmlText, pin: &Pin, inside: impl FnOnce(&mut XmlText)) {
    let mut attributes = vec![("formalParameter", pin.name.clone())];
    modified(&mut attributes, pin.modifier);
    around(xml, "variable", &attributes, inside);
}

/// A contact or a coil.
fn switch(
    xml: &mut XmlText,
    graph: &Graph,
    node: &Node,
    (name, attributes): (&str, &[(&str, String)]),
    tag: &str,
) {
    around(xml, name, attributes, |xml| {
        position(xml, "position", node.position);
        point_in(xml, graph, node, 0);
        point_out(xml, node, 0);
        xml.words("variable", &[], tag);
    });
}
