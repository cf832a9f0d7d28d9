//! The diagram of a program that runs, drawn with characters.

use ladder_picture::letters::{Gate, Live, Shown};
use ladder_simulator::chart;
use ladder_syntax::{TextRange, TextSize};

use super::drawing::Drawing as Elements;
use super::engine::Engine;
use super::messages::{Contact, Lines};
use super::request::Failure;
use crate::diagram_text::{self, DiagramText, DrawnText};

impl Engine {
    /// Draws what is asked for, as it is now.
    pub(super) fn diagram_text(&self, asked: &DiagramText) -> Result<DrawnText, Failure> {
        let simulation = self.session.simulation();
        let elements = self.drawing.get_or_init(|| Elements::of(simulation));
        let revision = self.line_map.running();
        let shown = self.line_map.shown();
        let Lines { first, last } = diagram_text::lines_asked(asked, shown.last_line());
        let mut drawing = diagram_text::Drawing::new(shown.version);
        let mut after = TextSize::from(0);
        for stretch in self.line_map.stretches(first, last) {
            // A network that is cut through is drawn as a whole, and once.
            let start = stretch.start().max(after);
            if start >= stretch.end() {
                continue;
            }
            let stretch = TextRange::new(start, stretch.end());
            let whole = elements.whole_networks(stretch);
            let live = self.live_in(elements, whole);
            let pieces = diagram_text::pieces(revision, stretch, diagram_text::rail(asked), Some(&live));
            let pieces = pieces.ok_or_else(|| Failure::Failed("the file is too large to be drawn".into()))?;
            let operands = elements.operands_in(whole, revision, simulation);
            for piece in pieces {
                after = after.max(piece.range.end());
                let line = |place: TextSize| self.line_map.range_or_near(TextRange::empty(place)).start.line;
                let block = |range: TextRange| {
                    let named = operands.iter().filter(|operand| operand.block == range);
                    let tags =
                        named.flat_map(|operand| operand.points.iter().map(|point| point.name.clone()));
                    Some((self.line_map.range(range)?, tags.collect()))
                };
                drawing.add(piece, line, block);
            }
        }
        Ok(drawing.done)
    }

    /// How the parts of the drawing in a stretch are.
    fn live_in(&self, elements: &Elements, stretch: TextRange) -> Live {
        let simulation = self.session.simulation();
        let revision = self.line_map.running();
        let mut live = Live::default();
        for element in elements.elements_in(stretch, revision, simulation) {
            let on = simulation.is_live(element.number);
            live.power.insert(element.range, on);
            if let Some(contact) = element.contact {
                let gate = match contact.state(on, simulation) {
                    Contact::Closed => Gate::Closed,
                    Contact::Open => Gate::Open,
                    Contact::Blocks => Gate::Blocks,
                };
                live.contacts.insert(element.range, gate);
            }
        }
        for operand in elements.operands_in(stretch, revision, simulation) {
            let Some(point) = operand.points.first() else {
                continue;
            };
            let shown = Shown {
                text: operand.index().unwrap_or_default()
                    + &chart::reading(&simulation.value(point), point.ty),
                forced: operand.points.iter().any(|point| simulation.is_forced(point)),
            };
            // Of the tags that an operand names the first stands for it.
            live.values.entry(operand.range).or_insert(shown);
        }
        live
    }
}
