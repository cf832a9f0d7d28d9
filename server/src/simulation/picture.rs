//! What a simulation shows: tags and power, and of those what a client looks at.

use ladder_analysis::program::Role;
use ladder_analysis::values::types::Scalar;
use ladder_simulator::{Point, Simulation, chart, value_text};
use ladder_syntax::{TextRange, TextSize};

use super::drawing::{self, Drawing};
use super::engine::Engine;
use super::messages;
use super::value::to_json;
use super::view::Update;

impl Engine {
    /// Tells from now on only of this.
    pub(super) fn show(&mut self, shown: &messages::Shown) {
        let simulation = self.session.simulation();
        let drawing = self.drawing.get_or_init(|| Drawing::of(simulation));
        let view = self.view.get_or_insert_default();
        view.show(shown, drawing, &self.line_map, simulation);
        self.shown = Some(shown.clone());
    }

    /// Whether the client says what it shows.
    pub(super) fn is_shown_in_part(&self) -> bool {
        self.view.is_some()
    }

    /// What has changed of what is shown since this was asked last: tags, power, and what is new of operands.
    pub(super) fn update(&mut self) -> (Vec<messages::Tag>, Update) {
        let Some(view) = &mut self.view else {
            let power = self.power();
            return (
                self.tags(),
                Update {
                    power,
                    ..Update::default()
                },
            );
        };
        let simulation = self.session.simulation();
        let drawing = self.drawing.get_or_init(|| Drawing::of(simulation));
        let update = view.update(drawing, &self.line_map, simulation);
        (
            update.points.iter().map(|point| self.tag(point)).collect(),
            update,
        )
    }

    /// How many tags are forced.
    pub(super) fn forced(&self) -> usize {
        self.session.simulation().forced().count()
    }

    /// The tags whose names hold a text.
    pub(super) fn search(&self, search: &messages::Search) -> messages::Found {
        let wanted = search.containing.as_deref().unwrap_or_default().to_lowercase();
        let fits = |point: &&Point| wanted.is_empty() || point.name.to_lowercase().contains(&wanted);
        let found: Vec<&Point> = self.all_points().filter(fits).collect();
        let listed = found.iter().skip(search.first.unwrap_or_default());
        let listed = listed.take(search.count.unwrap_or(usize::MAX));
        messages::Found {
            count: found.len(),
            tags: listed.map(|point| self.tag(point)).collect(),
        }
    }

    /// What the operand at a place in the text holds, in words, as Markdown.
    pub(super) fn values_at(&self, offset: TextSize) -> Vec<String> {
        let simulation = self.session.simulation();
        let drawing = self.drawing.get_or_init(|| Drawing::of(simulation));
        let Some(offset) = self.line_map.running_offset(offset) else {
            return Vec::new();
        };
        let revision = self.line_map.running();
        let line = revision.line_of(offset);
        let stretch = TextRange::new(revision.line_start(line), revision.line_start(line + 1));
        let operands = drawing.operands_in(stretch, revision, simulation);
        let operand = operands
            .into_iter()
            .find(|it| it.range.contains_inclusive(offset));
        let points = operand.map_or_else(|| self.named_at(offset), |operand| operand.points);
        let values = points.iter().map(|point| {
            let value = simulation.value(point);
            let value = match point.ty {
                Scalar::Bool => value_text::cell(&value, point.ty),
                ty => value_text::display(&value, ty),
            };
            let forced = if simulation.is_forced(point) {
                ", forced"
            } else {
                ""
            };
            format!("`{}` is **{value}**{forced}", point.name)
        });
        values.collect()
    }

    /// What the word at a place names, as in a declaration.
    fn named_at(&self, offset: TextSize) -> Vec<Point> {
        let simulation = self.session.simulation();
        let word = self.line_map.running().word_at(offset);
        if let Ok(point) = simulation.resolve(&word) {
            return vec![point];
        }
        let members = drawing::MEMBERS.iter().map(|member| format!("{word}.{member}"));
        members
            .filter_map(|name| simulation.resolve(&name).ok())
            .collect()
    }

    /// Every scalar tag, then what else is forced (an element of an array, a bit of a word).
    pub(super) fn tags(&self) -> Vec<messages::Tag> {
        self.all_points().map(|point| self.tag(point)).collect()
    }

    fn all_points(&self) -> impl Iterator<Item = &Point> {
        let points = self.session.simulation().points();
        let forced = self.session.simulation().forced();
        points
            .iter()
            .chain(forced.filter(|forced| !points.contains(forced)))
    }

    fn tag(&self, point: &Point) -> messages::Tag {
        let value = self.session.simulation().value(point);
        messages::Tag {
            name: point.name.clone(),
            kind: point.ty.to_string(),
            value: to_json(&value, point.ty),
            text: chart::reading(&value, point.ty),
            role: match point.role {
                Role::Input => messages::Role::Input,
                Role::Output => messages::Role::Output,
                Role::Internal => messages::Role::Internal,
            },
            forced: self.session.simulation().is_forced(point),
            read_only: point.read_only,
        }
    }

    /// Every element of the drawing, with its power in the last scan.
    pub(super) fn power(&self) -> Vec<messages::Power> {
        let simulation = self.session.simulation();
        let places = self.places.get_or_init(|| {
            let places = power(simulation).map(|(place, _)| self.line_map.range(place));
            places.collect()
        });
        let live = power(simulation).map(|(_, on)| on);
        let power = places.iter().zip(live).filter_map(|(&range, on)| {
            Some(messages::Power {
                range: range?,
                on,
                contact: None,
            })
        });
        power.collect()
    }
}

/// The elements that are in the program's own file, which is the document.
fn power(simulation: &Simulation) -> impl Iterator<Item = (TextRange, bool)> {
    let own = simulation.power().filter(|(_, location, _)| location.file == 0);
    own.map(|(_, location, on)| (location.range, on))
}
