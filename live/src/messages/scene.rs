//! A scene for a page that shows it: what is drawn, and what changes there.

use std::collections::BTreeMap;

use ladder_picture::scene::{Act, Bound, Finding, NodeKind, Scene, Use};
use serde::{Deserialize, Serialize};

/// The argument of `ladder.scene`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct SceneAsked {
    /// The file.
    pub uri: String,
    /// The simulation that it shows from now on; without one it is as at the start of its program.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub session: Option<String>,
}

/// The answer of `ladder.scene`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct SceneShown {
    /// The file.
    pub uri: String,
    /// The address of its program, if that is there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub program: Option<String>,
    /// What it is called.
    pub title: String,
    /// Its elements and texts: a child is after its parent.
    pub nodes: Vec<SceneNode>,
    /// The places that get values.
    pub slots: Vec<SceneSlot>,
    /// What can be done.
    pub acts: Vec<SceneAct>,
    /// The rows of the table of the same values.
    pub rows: Vec<SceneRow>,
    /// The value of each place. Empty: as it is drawn.
    pub values: Vec<String>,
    /// What is wrong, or has been left out, in words.
    pub findings: Vec<String>,
}

/// An element or a text.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct SceneNode {
    /// The number of the element that it is in; none of the first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub parent: Option<usize>,
    /// The name of an element of SVG.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Its attributes.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub attributes: BTreeMap<String, String>,
    /// It blinks, once in so many milliseconds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub blink: Option<u64>,
    /// Or the text.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub text: Option<String>,
}

/// A place that gets values.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct SceneSlot {
    /// The number of the element, or of the row.
    pub node: usize,
    /// The attribute that has the value; `text`: what is written there; `given`: what a click gives; `row`: the value of a row.
    #[serde(rename = "use")]
    pub used: String,
}

/// What a person can do with an element.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct SceneAct {
    /// The number of the element.
    pub node: usize,
    /// What.
    pub kind: SceneActKind,
    /// The tag.
    pub tag: String,
}

/// What can be done with an element.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum SceneActKind {
    /// The tag is TRUE while it is pressed.
    Press,
    /// The tag changes with each click.
    Toggle,
    /// The tag gets the value of the place `given` of the element.
    Set,
}

/// A row of the table.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct SceneRow {
    /// What the element is called.
    pub name: String,
    /// The attribute.
    pub attribute: String,
    /// What is written in it.
    pub expression: String,
}

/// What has changed in a scene.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct SceneValues {
    /// The file.
    pub uri: String,
    /// The numbers of places, with their values.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub values: Vec<(usize, String)>,
    /// Another program runs: the scene is to be asked for again.
    #[serde(default, skip_serializing_if = "super::is_false")]
    pub again: bool,
}

impl SceneShown {
    /// A scene with what its places hold.
    pub fn of(
        uri: String,
        scene: &Scene,
        bound: &Bound,
        values: Vec<String>,
        findings: &[Finding],
    ) -> SceneShown {
        let all = scene.findings.iter().chain(findings);
        SceneShown {
            uri,
            program: None,
            title: scene.title.clone(),
            nodes: scene.nodes.iter().map(SceneNode::of).collect(),
            slots: (bound.slots.iter())
                .map(|slot| SceneSlot {
                    node: slot.node,
                    used: match slot.used {
                        Use::Text => "text".to_owned(),
                        used => used.attribute().to_owned(),
                    },
                })
                .collect(),
            acts: bound.acts.iter().map(SceneAct::of).collect(),
            rows: (bound.rows.iter())
                .map(|row| SceneRow {
                    name: row.name.clone(),
                    attribute: row.attribute.to_owned(),
                    expression: row.expression.clone(),
                })
                .collect(),
            values,
            findings: all
                .map(|finding| {
                    format!(
                        "{}: {}; {}",
                        finding.severity.name(),
                        finding.message,
                        finding.help
                    )
                })
                .collect(),
        }
    }
}

impl SceneNode {
    fn of(node: &ladder_picture::scene::Node) -> SceneNode {
        let parent = node.parent;
        match &node.kind {
            NodeKind::Element {
                name,
                attributes,
                blink,
            } => SceneNode {
                parent,
                name: Some((*name).to_owned()),
                attributes: (attributes.iter())
                    .map(|(name, value)| ((*name).to_owned(), value.clone()))
                    .collect(),
                blink: *blink,
                text: None,
            },
            NodeKind::Text(text) => SceneNode {
                parent,
                name: None,
                attributes: BTreeMap::new(),
                blink: None,
                text: Some(text.clone()),
            },
        }
    }
}

impl SceneAct {
    fn of(act: &Act) -> SceneAct {
        let (kind, node, tag) = match act {
            Act::Press { node, tag } => (SceneActKind::Press, node, tag),
            Act::Toggle { node, tag } => (SceneActKind::Toggle, node, tag),
            Act::Set { node, tag } => (SceneActKind::Set, node, tag),
        };
        SceneAct {
            node: *node,
            kind,
            tag: tag.clone(),
        }
    }
}
