//! A scene with the program whose values it shows.

use super::part::Part;
use ladder_simulator::Simulation;

/// A place of the picture that gets a value after each scan.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Slot {
    /// The number of the element; of a row of the table that of the row.
    pub node: usize,
    /// What the value is for.
    pub used: Use,
}

/// What a value is for. An empty value means: as it is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Use {
    /// `none`: it is not shown.
    Display,
    /// Where it is, how it is turned, how large.
    Transform,
    /// How dense it is.
    Opacity,
    /// What it is filled with.
    Fill,
    /// The colour of its line.
    Stroke,
    /// What is written in it, even if that is nothing.
    Text,
    /// Its name and state, for those who do not see it.
    Label,
    /// Whether a switch is on.
    Checked,
    /// What a click gives its tag.
    Given,
    /// The value of a row of the table.
    Row,
}

impl Use {
    /// The attribute that has the value.
    pub fn attribute(self) -> &'static str {
        match self {
            Use::Display => "display",
            Use::Transform => "transform",
            Use::Opacity => "opacity",
            Use::Fill => "fill",
            Use::Stroke => "stroke",
            Use::Label => "aria-label",
            Use::Checked => "aria-checked",
            Use::Text => "text",
            Use::Given => "given",
            Use::Row => "row",
        }
    }
}

/// What a person can do with an element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Act {
    /// The tag is TRUE while it is pressed.
    Press {
        /// The element.
        node: usize,
        /// The tag.
        tag: String,
    },
    /// The tag changes.
    Toggle {
        /// The element.
        node: usize,
        /// The tag.
        tag: String,
    },
    /// The tag gets the value of the element's place of that use.
    Set {
        /// The element.
        node: usize,
        /// The tag.
        tag: String,
    },
}

/// A row of the table that has the same values as text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Row {
    /// What the element is called.
    pub name: String,
    /// The attribute.
    pub attribute: &'static str,
    /// What is written in it.
    pub expression: String,
}

/// A scene bound to a program.
#[derive(Debug, Default)]
pub struct Bound {
    /// The places that get values.
    pub slots: Vec<Slot>,
    /// What can be done.
    pub acts: Vec<Act>,
    /// The rows of the table.
    pub rows: Vec<Row>,
    pub(super) parts: Vec<Part>,
}

impl Bound {
    /// What each place shows now.
    pub fn values(&mut self, simulation: &Simulation) -> Vec<String> {
        let mut values = vec![String::new(); self.slots.len()];
        for number in 0..self.parts.len() {
            let (before, rest) = self.parts.split_at_mut(number);
            let inside = rest[0].within.and_then(|within| before[within].state.clone());
            rest[0].values(simulation, inside, &mut values);
        }
        values
    }
}
