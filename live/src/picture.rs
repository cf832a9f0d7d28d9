//! What a simulation shows: tags and power, and of those what a client looks at.

use std::collections::HashSet;

use ladder_analysis::program::Role;
use ladder_analysis::values::types::Scalar;
use ladder_ide::markdown;
use ladder_simulator::{Entry, Group, Point, Simulation, chart, value_text};
use ladder_syntax::{TextRange, TextSize};

use crate::drawing::{self, Drawing};
use crate::engine::Engine;
use crate::messages;
use crate::value::to_json;
use crate::view::{Flow, Update};

impl Engine {
    /// Tells from now on only of this.
    pub(crate) fn show(&mut self, shown: &messages::Shown) {
        let simulation = self.session.simulation();
        let drawing = self.drawing.get_or_init(|| Drawing::of(simulation));
        let view = self.view.get_or_insert_default();
        view.show(shown, drawing, &self.line_map, simulation);
        self.shown = Some(shown.clone());
    }

    /// Whether the client says what it shows.
    pub(crate) fn is_shown_in_part(&self) -> bool {
        self.view.is_some()
    }

    /// What has changed of what is shown since this was asked last: tags, power, and what is new of operands.
    pub(crate) fn update(&mut self) -> (Vec<messages::Tag>, Update) {
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
        let controller = self.controller.as_ref();
        let is_unknown = |element| controller.is_some_and(|it| it.is_unknown(element));
        let update = view.update(drawing, &self.line_map, simulation, &is_unknown);
        let values = update.points.iter().map(|point| self.tag(point));
        let groups = update.groups.iter().map(|group| self.group(group));
        (values.chain(groups).collect(), update)
    }

    /// How many tags are forced.
    pub(crate) fn forced(&self) -> usize {
        self.session.simulation().forced().count()
    }

    /// The tags whose names hold a text, or those that a tag opens into.
    pub(crate) fn search(&self, search: &messages::Search) -> messages::Found {
        let wanted = search.containing.as_deref().unwrap_or_default();
        let found = match (search.of.as_deref(), &search.names) {
            (None, Some(names)) => self.named(names),
            (None, None) => self.values_with(wanted).into_iter().map(Entry::Value).collect(),
            (Some(""), _) => self.entries_with(wanted),
            // A client that asks for so many elements parts the array itself.
            (Some(tag), _) if search.count.is_some() => self.session.simulation().entries(tag),
            (Some(tag), _) => self.session.simulation().listed(tag),
        };
        let listed = found.iter().skip(search.first.unwrap_or_default());
        let listed = listed.take(search.count.unwrap_or(usize::MAX));
        messages::Found {
            count: found.len(),
            tags: listed.map(|entry| self.listed(entry)).collect(),
        }
    }

    /// What each name means: one value, or what opens.
    fn named(&self, names: &[String]) -> Vec<Entry> {
        let simulation = self.session.simulation();
        let entry = |name: &String| {
            let value = simulation.resolve(name).ok().map(Entry::Value);
            value.or_else(|| simulation.listed_group(name).map(Entry::Group))
        };
        names.iter().filter_map(entry).collect()
    }

    fn values_with(&self, wanted: &str) -> Vec<Point> {
        let mut found = self.session.simulation().search(wanted);
        let small = wanted.to_lowercase();
        let more = self
            .unlisted()
            .filter(|forced| forced.name.to_lowercase().contains(&small));
        let more: Vec<Point> = more.filter(|forced| !found.contains(forced)).cloned().collect();
        found.extend(more);
        found
    }

    /// The tags of the program; those that open are one each, and fit if anything in them does.
    fn entries_with(&self, wanted: &str) -> Vec<Entry> {
        let values = self.values_with(wanted);
        let names: HashSet<&str> = values.iter().map(|point| point.name.as_str()).collect();
        let roots: HashSet<String> = values.iter().map(|point| root(&point.name)).collect();
        let small = wanted.to_lowercase();
        let mut entries = self.session.simulation().entries("");
        entries.retain(|entry| match entry {
            Entry::Value(point) => names.contains(point.name.as_str()),
            Entry::Group(group) => {
                roots.contains(&root(&group.name)) || group.name.to_lowercase().contains(&small)
            }
        });
        let groups: HashSet<String> = entries
            .iter()
            .filter_map(|entry| match entry {
                Entry::Group(group) => Some(group.name.to_lowercase()),
                Entry::Value(_) => None,
            })
            .collect();
        let more = self
            .unlisted()
            .filter(|forced| !groups.contains(&root(&forced.name)));
        let more = more.filter(|forced| names.contains(forced.name.as_str()));
        entries.extend(more.cloned().map(Entry::Value));
        entries
    }

    fn listed(&self, entry: &Entry) -> messages::Tag {
        match entry {
            Entry::Value(point) => self.tag(point),
            Entry::Group(group) => self.group(group),
        }
    }

    fn group(&self, group: &Group) -> messages::Tag {
        let simulation = self.session.simulation();
        messages::Tag {
            name: group.name.clone(),
            kind: group.ty.clone(),
            value: "".into(),
            text: simulation.brief(group, &group.name),
            role: role(group.role),
            forced: simulation.has_forced(group),
            read_only: group.read_only,
            parts: Some(group.parts),
        }
    }

    /// What the operand at a place in the text holds, in words, as Markdown.
    pub(crate) fn values_at(&self, offset: TextSize) -> Vec<String> {
        let simulation = self.session.simulation();
        let points = match self.line_map.running_offset(offset) {
            Some(offset) => self.operand_at(offset),
            None => self.operand_shown_at(offset),
        };
        let values = points.iter().map(|point| {
            let value = simulation.value(point);
            let value = match point.ty {
                Scalar::Bool => value_text::cell(&value, point.ty),
                // It may hold anything, as an image that the editor would load.
                ty if ty.is_string() => markdown::code(&value_text::display(&value, ty)),
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

    /// What the operand at a place in the text that runs holds, or the word there names.
    fn operand_at(&self, offset: TextSize) -> Vec<Point> {
        let simulation = self.session.simulation();
        let drawing = self.drawing.get_or_init(|| Drawing::of(simulation));
        let revision = self.line_map.running();
        let line = revision.line_of(offset);
        let stretch = TextRange::new(revision.line_start(line), revision.line_start(line + 1));
        let operands = drawing.operands_in(stretch, revision, simulation);
        let operand = operands
            .into_iter()
            .find(|it| it.range.contains_inclusive(offset));
        operand.map_or_else(|| self.named_at(offset), |operand| operand.points)
    }

    /// The same of an operand that the editor shows at a place, in a statement that goes on there.
    fn operand_shown_at(&self, shown: TextSize) -> Vec<Point> {
        let simulation = self.session.simulation();
        let drawing = self.drawing.get_or_init(|| Drawing::of(simulation));
        let revision = self.line_map.running();
        let at = self.line_map.shown().range(TextRange::empty(shown)).start;
        let is_there = |range: TextRange| {
            let place = self.line_map.operand(range);
            place.is_some_and(|place| {
                place.start.line == at.line
                    && (place.start.character..=place.end.character).contains(&at.character)
            })
        };
        let all = TextRange::up_to(TextSize::new(revision.len() as u32));
        let mut operands = drawing.operands_in(all, revision, simulation).into_iter();
        let found = operands.find(|operand| is_there(operand.range));
        found.map_or_else(Vec::new, |operand| operand.points)
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

    /// Every tag that is listed, then what else is forced.
    pub(crate) fn tags(&self) -> Vec<messages::Tag> {
        self.all_points().map(|point| self.tag(point)).collect()
    }

    fn all_points(&self) -> impl Iterator<Item = &Point> {
        self.session.simulation().points().iter().chain(self.unlisted())
    }

    /// What is forced and in no list of all tags: an element of a long array, a bit of a word.
    fn unlisted(&self) -> impl Iterator<Item = &Point> {
        let points = self.session.simulation().points();
        let forced = self.session.simulation().forced();
        forced.filter(|forced| !points.contains(forced))
    }

    fn tag(&self, point: &Point) -> messages::Tag {
        let value = self.session.simulation().value(point);
        messages::Tag {
            name: point.name.clone(),
            kind: point.ty.to_string(),
            value: to_json(&value, point.ty),
            text: chart::reading(&value, point.ty),
            role: if point.is_input {
                messages::Role::Input
            } else {
                role(point.role)
            },
            forced: self.session.simulation().is_forced(point),
            // A controller is only watched.
            read_only: point.read_only || self.controller.is_some(),
            parts: None,
        }
    }

    /// Every element of the drawing, with its power in the last scan.
    pub(crate) fn power(&self) -> Vec<messages::Power> {
        // A text has no wires.
        if !self.line_map.shows_drawing() {
            return Vec::new();
        }
        let simulation = self.session.simulation();
        let places = self.places.get_or_init(|| {
            let places = power(simulation).map(|(_, place, _)| self.line_map.range(place));
            places.collect()
        });
        let power = places
            .iter()
            .zip(power(simulation))
            .filter_map(|(&range, (element, _, on))| {
                let controller = self.controller.as_ref();
                let flow = match controller.filter(|it| it.is_unknown(element)) {
                    Some(_) => Flow::Unknown,
                    None => Flow::Known { on, contact: None },
                };
                Some(flow.at(range?))
            });
        power.collect()
    }
}

/// What is before the first dot or bracket of a path, in lower case.
fn root(path: &str) -> String {
    path.split(['.', '[']).next().unwrap_or_default().to_lowercase()
}

fn role(role: Role) -> messages::Role {
    match role {
        Role::Input => messages::Role::Input,
        Role::Output => messages::Role::Output,
        Role::Internal => messages::Role::Internal,
    }
}

/// The elements that are in the program's own file, which is the document, by the engine's numbers.
fn power(simulation: &Simulation) -> impl Iterator<Item = (usize, TextRange, bool)> {
    let own = simulation.power().enumerate();
    let own = own.filter(|(_, (_, location, _))| location.file == 0);
    own.map(|(number, (_, location, on))| (number, location.range, on))
}
