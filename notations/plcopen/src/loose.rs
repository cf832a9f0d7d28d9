//! What is in a drawing and connects nothing: editors draw a box for a variable at every pin of a block, and the pin EN, also where
//! nobody fills them in.

use crate::graph::{Graph, Kind, Modifier, Node};

impl Graph {
    /// Takes out variables without a name, what is done to power at pins that nothing is wired to, and every EN that nothing is wired to: such a block runs in every scan.
    pub(crate) fn without_loose(&mut self) {
        let is_blank = |node: &Node| match &node.kind {
            Kind::Value(text, _) | Kind::Variable(text, _) => text.trim().is_empty(),
            _ => false,
        };
        let mut count = 0;
        let places: Vec<Option<usize>> = self
            .nodes
            .iter()
            .map(|node| {
                (!is_blank(node)).then(|| {
                    count += 1;
                    count - 1
                })
            })
            .collect();
        self.nodes.retain(|node| !is_blank(node));
        for node in &mut self.nodes {
            for pin in &mut node.inputs {
                pin.from.retain_mut(|end| match places[end.node] {
                    Some(place) => {
                        end.node = place;
                        true
                    }
                    None => false,
                });
                // A generator passes over it: what would come there is not inverted.
                if pin.from.is_empty() {
                    pin.modifier = Modifier::default();
                }
            }
            if matches!(node.kind, Kind::Block { .. }) {
                node.inputs
                    .retain(|pin| !pin.from.is_empty() || !pin.name.eq_ignore_ascii_case("EN"));
            }
        }
    }
}
