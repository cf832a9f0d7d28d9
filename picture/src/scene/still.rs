//! A scene as an SVG document, as it is with certain values.

use super::bound::{Slot, Use};
use super::colour::on_paper;
use super::names::one_line;
use super::{Node, NodeKind, Scene};
use ladder_syntax::xml::Escaped;

/// The document: the drawing at rest where there are no values.
pub fn still(scene: &Scene, slots: &[Slot], values: &[String]) -> String {
    let mut nodes = scene.nodes.clone();
    let mut texts: Vec<Option<&str>> = vec![None; nodes.len()];
    for (slot, value) in slots.iter().zip(values) {
        let name = match slot.used {
            Use::Text => {
                texts[slot.node] = Some(value);
                continue;
            }
            Use::Row | Use::Given => continue,
            _ => slot.used.attribute(),
        };
        if !value.is_empty() {
            nodes[slot.node].set(name, value.clone());
        }
    }
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- drawn by ladder -->");
    let mut open: Vec<(usize, &'static str)> = Vec::new();
    for (at, node) in nodes.iter().enumerate() {
        while let Some((parent, name)) = open.last().copied()
            && Some(parent) != node.parent
        {
            out.push_str(&format!("</{name}>"));
            open.pop();
        }
        let is_replaced = |at: usize| texts.get(at).copied().flatten().is_some();
        match &node.kind {
            // What was written there is another text now.
            _ if open.iter().any(|(parent, _)| is_replaced(*parent)) => {}
            NodeKind::Text(text) => out.push_str(&written(text)),
            NodeKind::Element { name, attributes, .. } => {
                begin(&mut out, node, name, attributes);
                if let Some(text) = texts[at] {
                    out.push_str(&written(text));
                }
                open.push((at, name));
            }
        }
    }
    while let Some((_, name)) = open.pop() {
        out.push_str(&format!("</{name}>"));
    }
    out.push('\n');
    out
}

fn begin(out: &mut String, node: &Node, name: &str, attributes: &[(&'static str, String)]) {
    if !matches!(name, "tspan") {
        out.push('\n');
    }
    out.push_str(&format!("<{name}"));
    if node.parent.is_none() {
        out.push_str(" xmlns=\"http://www.w3.org/2000/svg\"");
    }
    for (name, value) in attributes {
        out.push_str(&format!(" {name}=\"{}\"", written(&on_paper(value))));
    }
    out.push('>');
}

fn written(text: &str) -> String {
    Escaped(&one_line(text)).to_string()
}
