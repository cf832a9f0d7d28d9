//! What the elements of a chart name: texts and drawings of its conditions and actions, variables, times.

use super::{Done, Read, Reader, Source, Text};
use crate::chart::{Action as DrawnAction, Condition as Drawing, Element, Flow, Kind, What};
use crate::expression::{Form, Meaning, operand};
use crate::graph::{Graph, Kind as NodeKind, Modifier, Storage};
use crate::model::{Body, Part, Type};
use crate::sketch::structured::within;
use ladder_format::program::Expression;
use ladder_notation::chart::{Association, Qualifier};
use ladder_notation::{LineColumn, Lines};
use ladder_notation_st::read::{self as st, Dialect, FirstNumbers, PartKind, PartText};
use std::collections::HashMap;

impl<'u> Reader<'_, '_, 'u> {
    /// A part of the unit by its name.
    pub(super) fn part(&self, what: &str, name: &str) -> Option<&'u Part> {
        let mut parts = self.unit.parts.iter();
        parts.find(|part| part.what == what && part.name.eq_ignore_ascii_case(name))
    }

    pub(super) fn condition_source(
        &self,
        element: &'u Element,
        texts: &mut Vec<Text<'u>>,
    ) -> Read<Source<'u>> {
        let Kind::Transition { condition, .. } = &element.kind else {
            return Err("it is no transition".to_owned());
        };
        let kind = PartKind::Condition;
        match condition {
            Drawing::Text("ST", text, place) => {
                let place = *place;
                texts.push(Text {
                    told: text,
                    place,
                    kind,
                });
                Ok(Source::Text(texts.len() - 1))
            }
            Drawing::Text(language, ..) => Err(format!("its condition is in {language}")),
            Drawing::Drawn(node) => Ok(Source::Graph(&self.drawn.conditions, *node)),
            Drawing::Other(why) => Err(why.clone()),
            Drawing::Named(name) => {
                let part = self
                    .part("transition", name)
                    .ok_or_else(|| format!("there is no transition {name}"))?;
                match &part.body {
                    Body::Text("ST", text, place) => {
                        let place = *place;
                        texts.push(Text {
                            told: text,
                            place,
                            kind,
                        });
                        Ok(Source::Text(texts.len() - 1))
                    }
                    Body::Graph(graph) => {
                        let node = result(graph, name)?;
                        Ok(Source::Graph(graph, node))
                    }
                    _ => Err(format!("the transition {name} is not in ST, LD or FBD")),
                }
            }
        }
    }

    /// The actions in the order in which a generator writes them, and what each step does with them.
    #[allow(clippy::type_complexity, reason = "two lists that belong together")]
    pub(super) fn actions(
        &self,
        flow: &Flow,
        texts: &mut Vec<Text<'u>>,
    ) -> Read<(Vec<(String, LineColumn, Done<'u>)>, Vec<Vec<Association>>)> {
        let mut actions: Vec<(String, LineColumn, Done<'u>)> = Vec::new();
        let mut by_name: HashMap<String, usize> = HashMap::new();
        let mut all = Vec::new();
        for (number, lists) in &flow.steps {
            let mut associations = Vec::new();
            for list in lists {
                let Kind::Actions(list) = &self.drawn.elements[*list].kind else {
                    continue;
                };
                for action in list {
                    let at = |why: String| format!("line {}: {why}", action.place.line);
                    let key = match &action.what {
                        What::Named(name) => name.to_lowercase(),
                        // One that is written at its step is used there alone.
                        What::Inline(_) => format!("\0{}", actions.len()),
                    };
                    let known = by_name.get(&key).copied();
                    let place = match known {
                        Some(known) => known,
                        None => {
                            let name = self.name_of(action, *number);
                            let done = self.done(action, texts).map_err(at)?;
                            actions.push((name, action.place, done));
                            by_name.insert(key, actions.len() - 1);
                            actions.len() - 1
                        }
                    };
                    associations.push(Association {
                        action: place,
                        qualifier: self.qualifier(action).map_err(at)?,
                    });
                }
            }
            all.push(associations);
        }
        Ok((actions, all))
    }

    pub(super) fn name_of(&self, action: &DrawnAction, step: usize) -> String {
        match (&action.what, &self.drawn.elements[step].kind) {
            (What::Named(name), _) => name.clone(),
            (What::Inline(_), Kind::Step { name, .. }) => format!("{name}_action"),
            (What::Inline(_), _) => "action".to_owned(),
        }
    }

    pub(super) fn meaning(&self) -> Meaning<'_> {
        Meaning {
            shared: self.seen.shared,
            scope: &self.made.scope,
        }
    }

    /// A tag, or a value, of a type.
    pub(super) fn of_type(&self, text: &str, name: &str) -> Read<Expression> {
        let found = operand(text, self.meaning())?;
        let is_it = found
            .ty
            .as_ref()
            .map(|ty| self.seen.shared.real(ty))
            .is_some_and(|ty| matches!(ty, Type::Named(own) if own.eq_ignore_ascii_case(name)));
        match found.form() {
            Form::Path(_) | Form::Literal(_) if is_it => Ok(found.value),
            _ => Err(format!("`{text}` is not of the type {name}")),
        }
    }

    pub(super) fn qualifier(&self, action: &DrawnAction) -> Read<Qualifier> {
        let time = action.duration.as_deref().map(|time| self.of_type(time, "TIME"));
        // What needs no time does not read it.
        let time = match Qualifier::read(&action.qualifier, None) {
            Ok(plain) => return Ok(plain),
            Err(_) => time.transpose()?,
        };
        Qualifier::read(&action.qualifier, time)
    }

    /// What an action is.
    pub(super) fn done(&self, action: &'u DrawnAction, texts: &mut Vec<Text<'u>>) -> Read<Done<'u>> {
        let body = match &action.what {
            What::Inline(body) => body,
            What::Named(name) => match (self.part("action", name), self.of_type(name, "BOOL")) {
                (Some(part), _) => {
                    if self.meaning().scope.get(name).is_some() {
                        return Err(format!("an action and a variable are called {name}"));
                    }
                    &part.body
                }
                (None, Ok(Expression::Path(path))) => return Ok(Done::Variable(path)),
                (None, _) => return Err(format!("`{name}` is neither an action nor a BOOL")),
            },
        };
        match body {
            Body::Empty => Ok(Done::Body(Source::Nothing)),
            Body::Text("ST", text, place) => {
                texts.push(Text {
                    told: text,
                    place: *place,
                    kind: PartKind::Statements,
                });
                Ok(Done::Body(Source::Text(texts.len() - 1)))
            }
            Body::Graph(graph) if matches!(action.what, What::Named(_)) => {
                let leaves = |kind: &NodeKind| {
                    matches!(
                        kind,
                        NodeKind::Label(_) | NodeKind::Jump(..) | NodeKind::Return(_)
                    )
                };
                if graph.nodes.iter().any(|node| leaves(&node.kind)) {
                    return Err("a jump or return in an action is not read".to_owned());
                }
                Ok(Done::Body(Source::Graph(graph, 0)))
            }
            _ => Err("an action is not in ST, LD or FBD".to_owned()),
        }
    }

    /// The texts as networks, each once.
    pub(super) fn texts(&mut self, texts: &[Text<'u>]) -> Read<Vec<Option<st::Body>>> {
        let scope = self.seen.in_text(&self.made.scope);
        let parts: Vec<PartText<'_>> = texts
            .iter()
            .map(|part| PartText {
                text: part.told,
                kind: part.kind,
            })
            .collect();
        let first_origin = self.reading.places.len() as u32;
        let made = &mut *self.made;
        let bodies = st::read_parts(
            (&parts, Dialect::Iec),
            (&self.unit.name, &scope),
            FirstNumbers {
                origin: first_origin,
                label: 0,
            },
            made.scope.names_mut(),
            &mut made.unread,
        )
        .map_err(|(part, why)| match part {
            Some(part) => format!("the text in line {}: {why}", texts[part].place.line),
            None => why,
        })?;
        for (body, text) in bodies.iter().zip(texts) {
            let lines = Lines::of(text.told);
            let place = |at| within(text.place, lines.place(text.told, at));
            body.note(text.told, place, self.reading);
            self.made
                .needed
                .extend(body.used.iter().map(|name| name.to_lowercase()));
            for tag in &body.tags {
                let names = tag.names.iter();
                let helpers = names.map(|name| (name.clone(), tag.ty.clone(), String::new()));
                self.made.helpers.extend(helpers);
            }
        }
        Ok(bodies.into_iter().map(Some).collect())
    }
}

/// The element of a drawing that says whether a transition holds: a coil or a variable of its name.
fn result(graph: &Graph, name: &str) -> Read<usize> {
    let is_it = |kind: &NodeKind| match kind {
        NodeKind::Coil(own, modifier, Storage::None) => {
            *modifier == Modifier::default() && own.eq_ignore_ascii_case(name)
        }
        NodeKind::Variable(own, false) => own.eq_ignore_ascii_case(name),
        _ => false,
    };
    let mut found = graph
        .nodes
        .iter()
        .enumerate()
        .filter(|(_, node)| is_it(&node.kind));
    match (found.next(), found.next()) {
        (Some((node, _)), None) => Ok(node),
        _ => Err(format!(
            "not one coil or variable in the transition {name} is called so"
        )),
    }
}
