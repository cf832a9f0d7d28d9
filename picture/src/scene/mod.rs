//! A picture of the machine next to its program: `NAME.scene.svg`, any SVG whose elements have attributes of the
//! namespace `l` with expressions over the program's tags.
//!
//! ```text
//! text --read--> Scene: elements from an allow list, bindings with their places, findings
//!        --bind--> Bound: expressions compiled for a program, places for their values
//!          --values--> one text for each place, after each scan
//!        --still--> an SVG document that shows these values
//! ```
//!
//! What is not on the allow list is not in the [`Scene`]: a page builds its elements from that, and never sees the file. So there
//! are no scripts in it, no reference that leads out of it, and no more of it than [`limits`](MOST_BYTES) allow.

mod accessible;
mod allow;
mod bind;
mod binding;
mod bound;
mod changes;
mod colour;
mod expansion;
mod finding;
mod names;
mod part;
mod read;
mod refused;
mod source;
mod still;
mod style;

pub use binding::{ATTRIBUTES, Attribute};
pub use bound::{Act, Bound, Row, Slot, Use};
pub use changes::Changes;
pub use colour::{THEME, THEME_VALUES};
pub use finding::Finding;
pub use read::read;
pub use source::program_named;
pub use still::still;

use binding::Binding;
use ladder_simulator::scenario::{PlantLine, Suite, Written};
use ladder_syntax::{TextRange, TextSize};

/// A scene has at most so many bytes.
pub const MOST_BYTES: usize = 4 * 1024 * 1024;
/// And so many elements.
pub const MOST_ELEMENTS: usize = 20_000;
/// Which are in so many others.
pub const MOST_DEPTH: usize = 64;

/// The namespace of the attributes that make a drawing a scene.
pub const NAMESPACE: &str = "https://ladder.example/scene";

/// A scene as it is written.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Scene {
    /// Its elements and texts, in the order of the document: a child is after its parent.
    pub nodes: Vec<Node>,
    /// The program, as it is named, seen from the scene's own folder. The range is empty where the file's name says it.
    pub program: Option<(String, TextRange)>,
    /// The models of the machine that run beside the program, in their order.
    pub plants: Vec<PlantLine>,
    /// What is wrong, or has been left out.
    pub findings: Vec<Finding>,
    /// What its name is, for screen readers.
    pub title: String,
    bindings: Vec<Binding>,
}

/// A part of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// The element that it is in; none of the root.
    pub parent: Option<usize>,
    /// What it is.
    pub kind: NodeKind,
}

/// What a part of a scene is.
#[derive(Debug, Clone, PartialEq)]
pub enum NodeKind {
    /// An element of SVG.
    Element {
        /// Its name, which is on the allow list.
        name: &'static str,
        /// Its attributes, which are on the allow list too.
        attributes: Vec<(&'static str, String)>,
        /// It is drawn half of the time: the milliseconds of a whole turn.
        blink: Option<u64>,
    },
    /// What is written in one.
    Text(String),
}

impl Node {
    /// The value of an attribute.
    pub fn attribute(&self, wanted: &str) -> Option<&str> {
        let NodeKind::Element { attributes, .. } = &self.kind else {
            return None;
        };
        let found = attributes.iter().find(|(name, _)| *name == wanted);
        found.map(|(_, value)| value.as_str())
    }

    fn set(&mut self, name: &'static str, value: String) {
        let NodeKind::Element { attributes, .. } = &mut self.kind else {
            return;
        };
        match attributes.iter_mut().find(|(known, _)| *known == name) {
            Some((_, old)) => *old = value,
            None => attributes.push((name, value)),
        }
    }
}

impl Scene {
    /// Its expressions, in the order of the file.
    pub fn expressions(&self) -> impl Iterator<Item = &Written> {
        self.bindings.iter().flat_map(Binding::expressions)
    }

    /// What it names, in the form in which files of scenarios name it: so that one code follows names in both.
    pub fn suite(&self) -> Suite {
        Suite {
            program: self.program.clone(),
            plants: self.plants.clone(),
            connects: Vec::new(),
            step: None,
            interval: None,
            tolerance: None,
            scenarios: Vec::new(),
            assumptions: self.expressions().cloned().collect(),
            properties: Vec::new(),
            errors: Vec::new(),
        }
    }
}

/// The scene of a file that is called so, without its ending: where it has no `l:program` it is about the program of that name.
pub fn of_file(stem: &str, text: &str) -> Scene {
    let mut scene = read(text);
    if scene.program.is_none() {
        // While somebody types the text may not be XML for a moment.
        scene.program = program_named(text).map(|name| (name, TextRange::default()));
    }
    if scene.program.is_none() {
        scene.program = Some((format!("{stem}.clad"), TextRange::default()));
    }
    scene
}

/// Bytes of the text as a range.
fn text_range(range: std::ops::Range<usize>) -> TextRange {
    let at = |place: usize| TextSize::new(u32::try_from(place).unwrap_or(u32::MAX));
    TextRange::new(at(range.start), at(range.end))
}
