//! What a person writes: expressions to be watched, and in the console assignments and forces too.

use ladder_analysis::values::types::Type;
use ladder_simulator::expression::{Expression, Problem};
use ladder_simulator::{Instance, Point, members_of};
use serde_json::{Value as Json, json};

use crate::adapter::Adapter;
use crate::messages::{Completions, Evaluate, Force, SetExpression, SetVariable};
use crate::variables::{self, Container};

const HELP: &str = "\
count > 5          an expression: tags, members, elements, operators, functions
start := TRUE      gives a tag a value
force start := 1   holds a tag at a value; `force start` at the one that it has
unforce start      lets it go; `unforce` alone lets all go
";

/// No more proposals than these are made.
const MOST: usize = 500;

impl Adapter {
    /// `evaluate`
    pub(crate) fn evaluate(&mut self, arguments: &Evaluate) -> Result<Json, Problem> {
        let text = arguments.expression.trim();
        if arguments.context.as_deref() != Some("repl") {
            return self.value_of(text, arguments.frame_id);
        }
        let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        match word {
            "help" if rest.is_empty() && self.target()?.scope(None).resolve("help").is_err() => {
                Ok(json!({"result": HELP, "variablesReference": 0}))
            }
            "force" if !rest.starts_with(":=") && !rest.is_empty() => {
                let (name, value) = match rest.split_once(":=") {
                    Some((name, value)) => (name, Some(value)),
                    None => rest
                        .trim()
                        .split_once(char::is_whitespace)
                        .map_or((rest, None), |(name, value)| (name, Some(value))),
                };
                let point = self.point(name.trim(), arguments.frame_id)?;
                self.force(&point, value, arguments.frame_id)?;
                self.value_of(&point.name, arguments.frame_id)
            }
            "unforce" if !rest.trim().is_empty() => {
                let point = self.point(rest.trim(), arguments.frame_id)?;
                self.unforce(Some(&point))?;
                self.value_of(&point.name, arguments.frame_id)
            }
            "unforce" => {
                self.unforce(None)?;
                Ok(json!({"result": "nothing is forced any more", "variablesReference": 0}))
            }
            _ => match text.split_once(":=") {
                Some((name, value)) => {
                    let point = self.point(name.trim(), arguments.frame_id)?;
                    self.assign(&point, value, arguments.frame_id)?;
                    self.value_of(&point.name, arguments.frame_id)
                }
                None => self.value_of(text, arguments.frame_id),
            },
        }
    }

    /// An expression, a whole timer or array, or a place of a user-defined block.
    fn value_of(&mut self, text: &str, frame: Option<i64>) -> Result<Json, Problem> {
        let target = self.target.as_ref().ok_or_else(super::adapter::no_program)?;
        let scope = target.scope(frame);
        let simulation = target.simulation();
        let instance = simulation
            .instances()
            .iter()
            .position(|instance| instance.name.eq_ignore_ascii_case(text));
        let named = simulation.instances().iter().filter_map(|instance| {
            let rest = text.strip_prefix(&instance.name)?.strip_prefix('.')?;
            Some((instance, rest))
        });
        let here = scope.instance.map(|instance| (instance, text));
        let within = here.into_iter().chain(named).find_map(|(instance, path)| {
            let group = simulation.group_within(instance, path)?;
            let number = simulation
                .instances()
                .iter()
                .position(|other| other.name == instance.name);
            Some(Container::Part(number, group.name))
        });
        let outside = || {
            simulation
                .group(text)
                .map(|group| Container::Part(None, group.name))
        };
        let place = || instance.map(Container::Instance);
        if let Some(container) = within.or_else(outside).or_else(place) {
            let shown = variables::open_json(simulation, container, &mut self.handles);
            return Ok(result(shown));
        }
        let mut watch = Expression::new(text, scope)?;
        if let Some(point) = watch.point() {
            return Ok(result(variables::point_json(simulation, point)));
        }
        let value = watch.evaluate(simulation)?;
        Ok(json!({"result": value.shown(), "type": value.ty.to_string(), "variablesReference": 0}))
    }

    fn point(&mut self, name: &str, frame: Option<i64>) -> Result<Point, Problem> {
        self.target()?.scope(frame).resolve(name)
    }

    /// Sets a tag's value.
    fn assign(&mut self, point: &Point, text: &str, frame: Option<i64>) -> Result<(), Problem> {
        let target = self.target()?;
        let value = variables::read(text, point.ty, target.scope(frame))?;
        target
            .session
            .set(point, value)
            .map_err(|refused| refused.message)?;
        self.has_changed();
        Ok(())
    }

    /// Holds a tag at a value, or at the one that it has.
    pub(crate) fn force(
        &mut self,
        point: &Point,
        text: Option<&str>,
        frame: Option<i64>,
    ) -> Result<(), Problem> {
        let target = self.target()?;
        let value = match text {
            Some(text) => variables::read(text, point.ty, target.scope(frame))?,
            None => target.simulation().value(point),
        };
        target
            .session
            .force(point, value)
            .map_err(|refused| refused.message)?;
        self.has_changed();
        Ok(())
    }

    /// Lets a tag go, or all.
    pub(crate) fn unforce(&mut self, point: Option<&Point>) -> Result<(), Problem> {
        let session = &mut self.target()?.session;
        match point {
            Some(point) => session.unforce(point),
            None => session.unforce_all(),
        }
        self.has_changed();
        Ok(())
    }

    /// What the client shows of tags is old.
    pub(crate) fn has_changed(&mut self) {
        if self.client.takes_invalidated {
            self.event(
                "invalidated",
                json!({"areas": ["variables"], "threadId": super::adapter::THREAD}),
            );
        }
    }

    /// `setVariable`
    pub(crate) fn set_variable(&mut self, arguments: &SetVariable) -> Result<Json, Problem> {
        let container = self.handles.get(arguments.variables_reference)?;
        let point = variables::point_in(self.target()?, &container, &arguments.name)?;
        self.assign(&point, &arguments.value, None)?;
        Ok(variables::point_json(self.target()?.simulation(), &point))
    }

    /// `setExpression`
    pub(crate) fn set_expression(&mut self, arguments: &SetExpression) -> Result<Json, Problem> {
        let point = self.point(&arguments.expression, arguments.frame_id)?;
        self.assign(&point, &arguments.value, arguments.frame_id)?;
        Ok(variables::point_json(self.target()?.simulation(), &point))
    }

    /// The tag that `ladder/force` and its like are about.
    pub(crate) fn point_of_force(&mut self, arguments: &Force) -> Result<Option<Point>, Problem> {
        let Some(name) = &arguments.name else {
            return Ok(None);
        };
        let point = match arguments.variables_reference.filter(|&reference| reference > 0) {
            Some(reference) => {
                let container = self.handles.get(reference)?;
                variables::point_in(self.target()?, &container, name)
            }
            None => self.point(name, arguments.frame_id),
        };
        point.map(Some)
    }

    /// `completions`
    pub(crate) fn completions(&mut self, arguments: &Completions) -> Result<Json, Problem> {
        let line = arguments.text.lines().next_back().unwrap_or_default();
        let at = self.counting.bytes_before(line, arguments.column);
        let before = &line[..at];
        let is_part = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '#' | '$');
        let start = before
            .rfind(|c| !is_part(c))
            .map_or(0, |at| at + before[at..].chars().next().map_or(1, char::len_utf8));
        let typed = before[start..].to_lowercase();
        let target = self.target()?;
        let names = names(target.scope(arguments.frame_id));
        let fitting = names
            .into_iter()
            .filter(|(name, _)| name.to_lowercase().starts_with(&typed));
        let length = before[start..].encode_utf16().count();
        let from = before[..start].encode_utf16().count();
        let targets: Vec<Json> = fitting
            .take(MOST)
            .map(|(name, ty)| {
                json!({"label": name, "type": "variable", "detail": ty, "start": from, "length": length})
            })
            .collect();
        Ok(json!({"targets": targets}))
    }
}

/// All that can be named, with its type.
fn names(scope: ladder_simulator::expression::Scope<'_>) -> Vec<(String, String)> {
    let program = scope.simulation.program();
    let mut names = Vec::new();
    let mut push = |name: String, ty: Type| {
        if let Type::State(state) = ty {
            for member in members_of(state) {
                names.push((format!("{name}.{member}"), String::new()));
            }
        }
        names.push((name, ty.to_string()));
    };
    let of_instance = |instance: &Instance| -> Vec<(&str, Type)> {
        let tags = instance.tags().map(|tag| &program.tags[tag.0 as usize]);
        let own = tags.map(|tag| (tag.name.as_str(), tag.ty));
        let others = program.other_names_in(Some(instance.block));
        own.chain(others.map(|(name, tag)| (name, tag.ty))).collect()
    };
    for (name, ty) in scope.instance.into_iter().flat_map(of_instance) {
        push(name.to_owned(), ty);
    }
    for tag in program.tags.iter().filter(|tag| tag.block.is_none()) {
        push(tag.name.clone(), tag.ty);
    }
    for (name, tag) in program.other_names_in(None) {
        push(name.to_owned(), tag.ty);
    }
    for instance in scope.simulation.instances() {
        for (name, ty) in of_instance(instance) {
            push(format!("{}.{name}", instance.name), ty);
        }
    }
    names.sort_by_cached_key(|(name, _)| ladder_syntax::Name::new(name));
    names.dedup();
    names
}

/// A variable as the answer to `evaluate`.
fn result(mut variable: Json) -> Json {
    let value = variable["value"].take();
    if let Some(variable) = variable.as_object_mut() {
        variable.remove("value");
        variable.remove("evaluateName");
        variable.insert("result".into(), value);
    }
    variable
}
