//! Charts: steps, transitions, and what joins them.

use super::Reader;
use super::body::Reading;
use crate::chart::{Action, Condition, Drawn, Element as Part, Kind, What};
use crate::graph::{Kind as NodeKind, Modifier, Storage};
use crate::model::Body;
use ladder_notation::xml::{Element, in_words};
use roxmltree::Node;

impl<'x> Reader<'x, '_> {
    /// What is in an element `SFC`.
    pub(super) fn chart(&mut self, chart: Node<'x, '_>) -> Body {
        let mut drawn = Drawn::default();
        let mut reading = Reading::default();
        for node in chart
            .elements()
            .filter(|node| !node.is("addData") && !node.is("documentation"))
        {
            let place = self.xml.place(node);
            drawn.shown.push((place, in_words(node)));
            let name = |attribute| node.attribute(attribute).unwrap_or_default().trim().to_owned();
            let kind = match Element::name(&node) {
                "step" => Kind::Step {
                    name: name("name"),
                    is_initial: node.flag("initialStep"),
                },
                "transition" => Kind::Transition {
                    priority: node.attribute("priority").map(str::to_owned),
                    condition: self.condition(node, &mut reading),
                },
                "jumpStep" => Kind::Jump(name("targetName")),
                "selectionDivergence" | "selectionConvergence" => Kind::Selection,
                "simultaneousDivergence" => Kind::SimultaneousDivergence,
                "simultaneousConvergence" => Kind::SimultaneousConvergence,
                "actionBlock" => {
                    let actions = node.children_of("action").map(|action| self.action(action));
                    Kind::Actions(actions.collect())
                }
                "macroStep" => Kind::Other("macroStep".to_owned()),
                _ => {
                    self.element(node, &mut reading);
                    continue;
                }
            };
            let points = node.children_of("connectionPointIn");
            let from = points.map(|point| {
                let ends = point.children_of("connection");
                let ids = ends.map(|end| end.attribute("refLocalId").unwrap_or_default().to_owned());
                ids.collect()
            });
            drawn.elements.push(Part {
                place,
                id: name("localId"),
                from: from.collect(),
                kind,
            });
        }
        drawn.conditions = self.joined(reading);
        Body::Chart(drawn)
    }

    /// The condition of a transition. One that is drawn ends at an element of the reading.
    fn condition(&mut self, node: Node<'x, '_>, reading: &mut Reading) -> Condition {
        let Some(condition) = node.child("condition") else {
            return Condition::Other("it has no condition".to_owned());
        };
        if condition.flag("negated") {
            return Condition::Other("its condition is inverted, which generators leave out".to_owned());
        }
        if let Some(named) = condition.child("reference") {
            return Condition::Named(named.attribute("name").unwrap_or_default().trim().to_owned());
        }
        if let Some(text) = condition.child("inline") {
            return match self.body(text) {
                Body::Text(language, text, place) => Condition::Text(language, text, place),
                Body::Empty => Condition::Other("its condition is empty".to_owned()),
                _ => Condition::Other("a condition in it is drawn".to_owned()),
            };
        }
        if condition.child("connectionPointIn").is_none() {
            return Condition::Other("its condition is not known".to_owned());
        }
        let kind = NodeKind::Coil(String::new(), Modifier::default(), Storage::None);
        Condition::Drawn(self.ends_at(condition, kind, reading))
    }

    fn action(&mut self, node: Node<'x, '_>) -> Action {
        let what = match (node.child("reference"), node.child("inline")) {
            (Some(named), _) => What::Named(named.attribute("name").unwrap_or_default().trim().to_owned()),
            (None, Some(text)) => What::Inline(self.body(text)),
            (None, None) => What::Named(String::new()),
        };
        let said = |attribute| node.attribute(attribute).map(str::trim);
        Action {
            place: self.xml.place(node),
            qualifier: said("qualifier")
                .filter(|it| !it.is_empty())
                .unwrap_or("N")
                .to_owned(),
            duration: said("duration").filter(|it| !it.is_empty()).map(str::to_owned),
            what,
        }
    }
}
