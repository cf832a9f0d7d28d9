//! What a scene is for those who do not see it, or do not use a mouse.

use super::binding::{Binding, What};
use super::finding::Finding;
use super::{Node, NodeKind, Scene};
use ladder_syntax::TextRange;

/// What is told of a part by an element's attributes belongs to what is around it, which is hidden with it.
const TOLD: [&str; 5] = [
    "role",
    "aria-label",
    "aria-labelledby",
    "aria-describedby",
    "aria-hidden",
];

/// Puts its name and its role on the element of a binding.
pub(super) fn describe(nodes: &mut [Node], binding: &Binding) {
    if binding.outer != binding.inner
        && let NodeKind::Element { attributes, .. } = &mut nodes[binding.inner].kind
    {
        let told: Vec<_> = attributes
            .extract_if(.., |(name, _)| TOLD.contains(name))
            .collect();
        for (name, value) in told {
            nodes[binding.outer].set(name, value);
        }
    }
    let outer = &mut nodes[binding.outer];
    if let Some(alt) = &binding.alt {
        outer.set("aria-label", alt.clone());
    }
    let role = binding.all.iter().find_map(|one| match one.what {
        What::Toggle(_) => Some("switch"),
        What::Press(_) | What::Set(..) => Some("button"),
        _ => None,
    });
    match role {
        Some(role) => {
            outer.set("role", role.to_owned());
            outer.set("tabindex", "0".to_owned());
        }
        None if binding.alt.is_some() && outer.attribute("role").is_none() => {
            outer.set("role", "img".to_owned());
        }
        None => {}
    }
}

/// What a binding lacks for those who do not see it.
pub(super) fn lacks(
    binding: &Binding,
    (has_text, is_named): (bool, bool),
    range: TextRange,
    findings: &mut Vec<Finding>,
) {
    let paint = binding
        .all
        .iter()
        .find(|one| matches!(one.what, What::Paint { .. }));
    let is_told = is_named
        || binding.alt.is_some()
        || (binding.all.iter()).any(|one| matches!(one.what, What::Show(_) | What::Text(_)));
    if let Some(paint) = paint.filter(|_| !is_told) {
        findings.push(Finding::info(
            paint.range,
            format!("{} tells its state by a colour alone", paint.name),
            "say what it is with l:alt, or show a text too: not everybody sees colours",
        ));
    }
    if binding.acts() && binding.alt.is_none() && !has_text {
        findings.push(Finding::info(
            range,
            "this can be pressed and has no name",
            "say what it does with l:alt, as in l:alt=\"start\"",
        ));
    }
}

/// Names the scene itself.
pub(super) fn name(scene: &mut Scene, range: TextRange) {
    for (what, help) in [
        (
            "title",
            "add <title>Conveyor</title> as the first element: screen readers name the picture so",
        ),
        (
            "desc",
            "add <desc>A belt brings a box to its far end.</desc>: it tells what is seen to those who do not see it",
        ),
    ] {
        match text_of(scene, what) {
            Some(text) if what == "title" => scene.title = text,
            Some(_) => {}
            None => scene
                .findings
                .push(Finding::info(range, format!("the scene has no `{what}`"), help)),
        }
    }
    let title = scene.title.clone();
    if let Some(root) = scene.nodes.first_mut() {
        root.set("role", "group".to_owned());
        if root.attribute("aria-labelledby").is_none() && !title.is_empty() {
            root.set("aria-label", title);
        }
    }
}

/// The text of a child of the root.
fn text_of(scene: &Scene, wanted: &str) -> Option<String> {
    let is_it = |node: &&(usize, &Node)| {
        node.1.parent == Some(0) && matches!(&node.1.kind, NodeKind::Element { name, .. } if *name == wanted)
    };
    let (at, _) = scene.nodes.iter().enumerate().find(|node| is_it(&node))?;
    let texts = scene.nodes.iter().filter(|node| node.parent == Some(at));
    let text: String = texts
        .filter_map(|node| match &node.kind {
            NodeKind::Text(text) => Some(text.as_str()),
            NodeKind::Element { .. } => None,
        })
        .collect();
    let text = text.trim();
    (!text.is_empty()).then(|| text.to_owned())
}
