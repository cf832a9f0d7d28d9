//! Tags as variables: by what they are for, with the members of timers and counters, the elements of arrays, and the tags
//! of each place of a user-defined block.

use ladder_analysis::program::{Role, SystemTag, Tag};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_simulator::{Instance, Point, Simulation, members_of, value_text};
use serde_json::{Value as Json, json};

use super::target::Target;
use super::watch::{Problem, Scope, Watch};

/// What a value in a list ends with while it is held.
const FORCED: &str = " (forced)";
/// What is between a value and the one that is waiting for the end of the scan.
const WAITING: &str = " → ";

/// What can be opened.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Container {
    Tags(Group),
    /// The tags of a place of a user-defined block, by its number among the instances.
    Instance(usize),
    /// All these places.
    Instances,
    /// A timer, counter or bistable, or an array.
    Whole(String, Type),
}

/// Tags that belong together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Group {
    Inputs,
    Outputs,
    Internal,
    States,
    Constants,
    System,
}

impl Group {
    const fn name(self) -> &'static str {
        match self {
            Group::Inputs => "Inputs",
            Group::Outputs => "Outputs",
            Group::Internal => "Internal",
            Group::States => "Timers and counters",
            Group::Constants => "Constants",
            Group::System => "System",
        }
    }

    fn of(tag: &Tag) -> Group {
        match (tag.constant, tag.ty, tag.role) {
            (true, ..) => Group::Constants,
            (_, Type::State(_), _) => Group::States,
            (.., Role::Input) => Group::Inputs,
            (.., Role::Output) => Group::Outputs,
            (.., Role::Internal) => Group::Internal,
        }
    }
}

/// What was handed out to be opened, until the program goes on.
#[derive(Debug, Default)]
pub(super) struct Handles(Vec<Container>);

impl Handles {
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }

    /// The number under which a container can be opened.
    pub(super) fn number(&mut self, container: Container) -> i64 {
        let known = self.0.iter().position(|known| *known == container);
        let index = known.unwrap_or_else(|| {
            self.0.push(container);
            self.0.len() - 1
        });
        index as i64 + 1
    }

    pub(super) fn get(&self, number: i64) -> Result<Container, Problem> {
        let index = number
            .checked_sub(1)
            .and_then(|index| usize::try_from(index).ok());
        let container = index.and_then(|index| self.0.get(index)).cloned();
        container.ok_or_else(|| "these variables are those of a moment that is over".to_owned())
    }
}

/// The scopes of a frame.
pub(super) fn scopes(target: &Target, frame: i64, handles: &mut Handles) -> Vec<Json> {
    let simulation = target.simulation();
    let program = simulation.program();
    let mut scopes = Vec::new();
    let mut push = |name: &str, container: Container, hint: Option<&str>, expensive: bool| {
        let mut scope = json!({
            "name": name, "variablesReference": handles.number(container), "expensive": expensive,
        });
        if let Some(hint) = hint {
            scope["presentationHint"] = hint.into();
        }
        scopes.push(scope);
    };
    let scope = target.scope(Some(frame));
    if let Some(instance) = scope.instance {
        let number = simulation
            .instances()
            .iter()
            .position(|other| other.name == instance.name);
        push(
            &instance.name,
            Container::Instance(number.unwrap_or(0)),
            Some("locals"),
            false,
        );
    }
    for group in [
        Group::Inputs,
        Group::Outputs,
        Group::Internal,
        Group::States,
        Group::Constants,
    ] {
        let mut visible = program.tags.iter().filter(|tag| tag.block.is_none());
        if visible.any(|tag| Group::of(tag) == group) {
            push(group.name(), Container::Tags(group), None, false);
        }
    }
    if !simulation.instances().is_empty() {
        push("Blocks", Container::Instances, None, false);
    }
    push(Group::System.name(), Container::Tags(Group::System), None, true);
    scopes
}

/// Something in a list.
enum Row {
    Value(String, Point),
    Open(String, Container),
}

/// What a container holds.
pub(super) fn list(
    target: &Target,
    container: &Container,
    filter: Option<&str>,
    (start, count): (usize, Option<usize>),
    handles: &mut Handles,
) -> Vec<Json> {
    let simulation = target.simulation();
    let is_array = matches!(container, Container::Whole(_, Type::Array { .. }));
    // Elements are indexed, everything else is named.
    if filter.is_some_and(|filter| (filter == "indexed") != is_array) {
        return Vec::new();
    }
    let take = count.filter(|&count| count > 0).unwrap_or(usize::MAX);
    let rows: Vec<Row> = match container {
        Container::Tags(Group::System) => {
            let names = SystemTag::list();
            let names = names.split([',', ' ']).filter(|name| !name.is_empty());
            let names = names.map(|name| {
                if name.starts_with("SYS.") {
                    name.to_owned()
                } else {
                    format!("SYS.{name}")
                }
            });
            names
                .filter_map(|name| value_row(simulation, &name, &name))
                .skip(start)
                .take(take)
                .collect()
        }
        Container::Tags(group) => {
            let program = simulation.program();
            let own = program.tags.iter().filter(|tag| tag.block.is_none());
            let own = own.map(|tag| (tag.name.as_str(), tag));
            let tags = own.chain(program.other_names_in(None));
            let tags = tags.filter(|(_, tag)| Group::of(tag) == *group);
            tags.filter_map(|(name, tag)| row(simulation, name, name, tag.ty))
                .skip(start)
                .take(take)
                .collect()
        }
        Container::Instance(number) => {
            let Some(instance) = simulation.instances().get(*number) else {
                return Vec::new();
            };
            let program = simulation.program();
            let tags = instance.tags().map(|tag| &program.tags[tag.0 as usize]);
            let tags = tags.map(|tag| (tag.name.as_str(), tag));
            let tags = tags.chain(program.other_names_in(Some(instance.block)));
            let own = tags.filter_map(|(name, tag)| {
                row(simulation, name, &format!("{}.{name}", instance.name), tag.ty)
            });
            own.chain(inner(simulation, Some(instance)))
                .skip(start)
                .take(take)
                .collect()
        }
        Container::Instances => inner(simulation, None).skip(start).take(take).collect(),
        Container::Whole(name, Type::State(state)) => {
            let members = members_of(*state)
                .filter_map(|member| value_row(simulation, member, &format!("{name}.{member}")));
            members.skip(start).take(take).collect()
        }
        Container::Whole(name, Type::Array { first, last, .. }) => {
            let first = first.saturating_add(start as i64);
            let indices = (first..=*last).take(take);
            indices
                .filter_map(|index| value_row(simulation, &format!("[{index}]"), &format!("{name}[{index}]")))
                .collect()
        }
        Container::Whole(name, Type::Scalar(_) | Type::Compound(_)) => {
            value_row(simulation, name, name).into_iter().collect()
        }
    };
    rows.into_iter()
        .map(|row| shown(simulation, row, handles))
        .collect()
}

/// The places of user-defined blocks that are in the body of one, or in none.
fn inner<'s>(simulation: &'s Simulation, outer: Option<&'s Instance>) -> impl Iterator<Item = Row> + 's {
    let all = simulation.instances().iter().enumerate();
    all.filter_map(move |(number, instance)| {
        let short = match outer {
            None => (!instance.name.contains('.')).then_some(instance.name.as_str()),
            Some(outer) => {
                let rest = instance
                    .name
                    .strip_prefix(&outer.name)
                    .and_then(|rest| rest.strip_prefix('.'));
                rest.filter(|rest| !rest.contains('.'))
            }
        };
        Some(Row::Open(short?.to_owned(), Container::Instance(number)))
    })
}

fn row(simulation: &Simulation, shown: &str, name: &str, ty: Type) -> Option<Row> {
    match ty {
        Type::Scalar(_) => value_row(simulation, shown, name),
        _ => Some(Row::Open(shown.to_owned(), Container::Whole(name.to_owned(), ty))),
    }
}

fn value_row(simulation: &Simulation, shown: &str, name: &str) -> Option<Row> {
    let point = simulation.resolve(name).ok()?;
    Some(Row::Value(shown.to_owned(), point))
}

fn shown(simulation: &Simulation, row: Row, handles: &mut Handles) -> Json {
    match row {
        Row::Value(name, point) => {
            let mut shown = point_json(simulation, &point);
            shown["name"] = name.into();
            shown
        }
        Row::Open(name, container) => {
            let mut shown = open_json(simulation, container, handles);
            shown["name"] = name.into();
            shown
        }
    }
}

/// A value with all that a client shows of it; without its name.
pub(super) fn point_json(simulation: &Simulation, point: &Point) -> Json {
    let is_forced = simulation.is_forced(point);
    let mut attributes = Vec::new();
    if point.read_only {
        attributes.push("readOnly");
    }
    if is_forced {
        attributes.push("forced");
    }
    let menu = match (point.read_only, is_forced) {
        (true, _) => "readOnly",
        (false, true) => "forced",
        (false, false) => "writable",
    };
    json!({
        "value": value_text_of(simulation, point),
        "type": point.ty.to_string(),
        "evaluateName": point.name,
        "variablesReference": 0,
        "presentationHint": {"kind": "data", "attributes": attributes},
        "__vscodeVariableMenuContext": menu,
    })
}

/// A value as it is shown: whether it is held, and what it will be after this scan.
fn value_text_of(simulation: &Simulation, point: &Point) -> String {
    let mut text = value_text::display(&simulation.value(point), point.ty);
    if simulation.is_forced(point) {
        text.push_str(FORCED);
    }
    if let Some(waiting) = simulation.waiting(point) {
        text.push_str(&format!(
            "{WAITING}{} after this scan",
            value_text::display(waiting, point.ty)
        ));
    }
    text
}

/// Something that can be opened, with what it shows while it is closed; without its name.
pub(super) fn open_json(simulation: &Simulation, container: Container, handles: &mut Handles) -> Json {
    let (value, ty, name) = match &container {
        Container::Whole(name, ty @ Type::State(state)) => {
            let values = members_of(*state).take(2).filter_map(|member| {
                let point = simulation.resolve(&format!("{name}.{member}")).ok()?;
                Some(format!(
                    "{member}={}",
                    value_text::display(&simulation.value(&point), point.ty)
                ))
            });
            (
                values.collect::<Vec<_>>().join(" "),
                ty.to_string(),
                Some(name.clone()),
            )
        }
        Container::Whole(name, ty) => (ty.to_string(), ty.to_string(), Some(name.clone())),
        Container::Instance(number) => {
            let instance = simulation.instances().get(*number);
            let block = instance.map(|instance| simulation.program().blocks[instance.block].name.clone());
            let block = block.unwrap_or_default();
            (
                block.clone(),
                block,
                instance.map(|instance| instance.name.clone()),
            )
        }
        Container::Instances | Container::Tags(_) => (String::new(), String::new(), None),
    };
    let mut shown = json!({"value": value, "type": ty, "presentationHint": {"kind": "data"}});
    if let Some(name) = name {
        shown["evaluateName"] = name.into();
    }
    if let Container::Whole(_, Type::Array { first, last, .. }) = &container {
        shown["indexedVariables"] = last.saturating_sub(*first).saturating_add(1).into();
    }
    shown["variablesReference"] = handles.number(container).into();
    shown
}

/// The place that a name in a container means.
pub(super) fn point_in(target: &Target, container: &Container, name: &str) -> Result<Point, Problem> {
    let simulation = target.simulation();
    let whole = match container {
        Container::Instance(number) => {
            let instance = simulation.instances().get(*number);
            format!(
                "{}.{name}",
                instance.map_or("", |instance| instance.name.as_str())
            )
        }
        Container::Whole(tag, Type::Array { .. }) => format!("{tag}{name}"),
        Container::Whole(tag, Type::State(_)) => format!("{tag}.{name}"),
        Container::Tags(_) | Container::Instances | Container::Whole(..) => name.to_owned(),
    };
    simulation.resolve(&whole).map_err(|unknown| unknown.message)
}

/// Reads a value that a person typed: a literal of the type, or an expression.
pub(super) fn read(text: &str, ty: Scalar, scope: Scope<'_>) -> Result<Value, Problem> {
    // A person may have edited the text that is shown.
    let text = text.rsplit(WAITING).next().unwrap_or(text).trim();
    let text = text.strip_suffix("after this scan").unwrap_or(text).trim();
    let text = text.strip_suffix(FORCED.trim()).unwrap_or(text).trim();
    let problem = match value_text::parse(text, ty) {
        Ok(value) => return Ok(value),
        Err(problem) => problem,
    };
    let Ok(mut watch) = Watch::new(text, scope) else {
        return Err(problem);
    };
    let found = watch.evaluate(scope.simulation)?;
    if found.ty == ty {
        return Ok(found.value);
    }
    // A number passes where its spelling is one of the type.
    value_text::parse(&found.shown(), ty).map_err(|_| problem)
}
