//! Tags as variables: by what they are for, with the members of timers and counters, the elements of arrays, and the tags
//! of each place of a user-defined block.

use ladder_analysis::program::{Role, SystemTag};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::expression::{Expression, Problem, Scope};
use ladder_simulator::{Entry, Instance, Point, Simulation, members_of, value_text};
use serde_json::{Value as Json, json};

use crate::target::Target;

/// What a value in a list ends with while it is held.
const FORCED: &str = " (forced)";
/// What is between a value and the one that is waiting for the end of the scan.
const WAITING: &str = " → ";

/// What can be opened.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Container {
    Tags(Group),
    /// The tags of a place of a user-defined block, by its number among the instances.
    Instance(usize),
    /// All these places.
    Instances,
    /// A tag that opens, or a part of one: its path from outside. In a body the number of the instance is before it, and the path
    /// is that in the body.
    Part(Option<usize>, String),
}

/// Tags that belong together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Group {
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

    fn of(entry: &Entry) -> Group {
        match entry {
            Entry::Value(point) => Group::of_value(point),
            Entry::Group(group) => match (group.read_only, group.state, group.role) {
                (false, Some(_), _) => Group::States,
                (constant, _, role) => Group::by(constant, role),
            },
        }
    }

    fn of_value(point: &Point) -> Group {
        let role = if point.is_input { Role::Input } else { point.role };
        Group::by(point.read_only, role)
    }

    fn by(constant: bool, role: Role) -> Group {
        match (constant, role) {
            (true, _) => Group::Constants,
            (_, Role::Input) => Group::Inputs,
            (_, Role::Output) => Group::Outputs,
            (_, Role::Internal) => Group::Internal,
        }
    }
}

/// What was handed out to be opened, until the program goes on.
#[derive(Debug, Default)]
pub(crate) struct Handles(Vec<Container>);

impl Handles {
    pub(crate) fn clear(&mut self) {
        self.0.clear();
    }

    /// The number under which a container can be opened.
    pub(crate) fn number(&mut self, container: Container) -> i64 {
        let known = self.0.iter().position(|known| *known == container);
        let index = known.unwrap_or_else(|| {
            self.0.push(container);
            self.0.len() - 1
        });
        index as i64 + 1
    }

    pub(crate) fn get(&self, number: i64) -> Result<Container, Problem> {
        let index = number
            .checked_sub(1)
            .and_then(|index| usize::try_from(index).ok());
        let container = index.and_then(|index| self.0.get(index)).cloned();
        container.ok_or_else(|| "these variables are those of a moment that is over".to_owned())
    }
}

/// The scopes of a frame.
pub(crate) fn scopes(target: &Target, frame: i64, handles: &mut Handles) -> Vec<Json> {
    let simulation = target.simulation();
    let tags = simulation.tags();
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
        if tags.iter().any(|entry| Group::of(entry) == group) {
            push(group.name(), Container::Tags(group), None, false);
        }
    }
    if inner(simulation, None).next().is_some() {
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
pub(crate) fn list(
    target: &Target,
    container: &Container,
    filter: Option<&str>,
    (start, count): (usize, Option<usize>),
    handles: &mut Handles,
) -> Vec<Json> {
    let simulation = target.simulation();
    let is_array = group_of(simulation, container).is_some_and(|group| group.is_array());
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
            let tags = simulation.tags().into_iter();
            let tags = tags
                .filter(|entry| Group::of(entry) == *group)
                .map(|entry| row("", None, entry));
            let others = program.other_names_in(None);
            let others = others.filter_map(|(name, _)| value_row(simulation, name, name));
            let others =
                others.filter(|row| matches!(row, Row::Value(_, point) if Group::of_value(point) == *group));
            tags.chain(others).skip(start).take(take).collect()
        }
        Container::Instance(number) => {
            let Some(instance) = simulation.instances().get(*number) else {
                return Vec::new();
            };
            let entries = simulation
                .opened_within(instance, "")
                .unwrap_or_default()
                .into_iter();
            let own = entries.map(|entry| row(&instance.name, Some((*number, instance)), entry));
            let others = simulation.program().other_names_in(Some(instance.block));
            let others = others
                .filter_map(|(name, _)| value_row(simulation, name, &format!("{}.{name}", instance.name)));
            own.chain(others)
                .chain(inner(simulation, Some(instance)))
                .skip(start)
                .take(take)
                .collect()
        }
        Container::Instances => inner(simulation, None).skip(start).take(take).collect(),
        Container::Part(within, path) => {
            let instance = within.and_then(|number| Some((number, simulation.instances().get(number)?)));
            let whole = whole_name(simulation, container);
            if let Some(state) = group_of(simulation, container).and_then(|group| group.state) {
                let members = members_of(state)
                    .filter_map(|member| value_row(simulation, member, &format!("{whole}.{member}")));
                members.skip(start).take(take).collect()
            } else {
                let entries = match instance {
                    Some((_, instance)) => simulation.opened_within(instance, path),
                    None => simulation.opened(path),
                };
                let entries = entries.unwrap_or_default().into_iter();
                let rows = entries.map(|entry| row(&whole, instance, entry));
                // The blocks in the body of the one whose state this is.
                let state = simulation
                    .instances()
                    .iter()
                    .find(|instance| instance.name == whole);
                let inside = state.into_iter().flat_map(|state| inner(simulation, Some(state)));
                rows.chain(inside).skip(start).take(take).collect()
            }
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
            None => Some(instance.name.as_str()),
            Some(outer) => instance
                .name
                .strip_prefix(&outer.name)
                .and_then(|rest| rest.strip_prefix('.')),
        };
        // One whose state is a tag is there as that tag.
        let short = short.filter(|short| short.starts_with('$') && !short.contains('.'));
        Some(Row::Open(short?.to_owned(), Container::Instance(number)))
    })
}

/// An entry as it is in what it belongs to: without the name of that.
fn row(whole: &str, within: Option<(usize, &Instance)>, entry: Entry) -> Row {
    let short = |name: &str| {
        let rest = name.strip_prefix(whole).unwrap_or(name);
        rest.strip_prefix('.').unwrap_or(rest).to_owned()
    };
    match entry {
        Entry::Value(point) => Row::Value(short(&point.name), point),
        Entry::Group(group) => {
            let outside =
                within.and_then(|(_, instance)| group.name.strip_prefix(&instance.name)?.strip_prefix('.'));
            let path = outside.unwrap_or(&group.name).to_owned();
            Row::Open(
                short(&group.name),
                Container::Part(within.map(|(number, _)| number), path),
            )
        }
    }
}

/// The name of what opens, as from outside.
fn whole_name(simulation: &Simulation, container: &Container) -> String {
    match container {
        Container::Part(None, path) => path.clone(),
        Container::Part(Some(number), path) => match simulation.instances().get(*number) {
            Some(instance) => format!("{}.{path}", instance.name),
            None => path.clone(),
        },
        Container::Instance(number) => {
            let instance = simulation.instances().get(*number);
            instance.map_or(String::new(), |instance| instance.name.clone())
        }
        Container::Tags(_) | Container::Instances => String::new(),
    }
}

/// What opens, if it is a tag or a part of one.
fn group_of(simulation: &Simulation, container: &Container) -> Option<ladder_simulator::Group> {
    match container {
        Container::Part(None, path) => simulation.group(path),
        Container::Part(Some(number), path) => {
            simulation.group_within(simulation.instances().get(*number)?, path)
        }
        _ => None,
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
pub(crate) fn point_json(simulation: &Simulation, point: &Point) -> Json {
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
        (false, false) if point.takes_force() => "writable",
        (false, false) => "settable",
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
pub(crate) fn open_json(simulation: &Simulation, container: Container, handles: &mut Handles) -> Json {
    let (value, ty, name) = match &container {
        Container::Part(..) => {
            let group = group_of(simulation, &container);
            let ty = group.as_ref().map_or(String::new(), |group| group.ty.clone());
            let name = whole_name(simulation, &container);
            let brief = group.map_or(String::new(), |group| simulation.brief(&group, &name));
            let value = if brief.is_empty() { ty.clone() } else { brief };
            (value, ty, Some(name))
        }
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
    if let Some(group) = group_of(simulation, &container).filter(ladder_simulator::Group::is_array) {
        shown["indexedVariables"] = group.parts.into();
    }
    shown["variablesReference"] = handles.number(container).into();
    shown
}

/// The place that a name in a container means.
pub(crate) fn point_in(target: &Target, container: &Container, name: &str) -> Result<Point, Problem> {
    let simulation = target.simulation();
    let outer = whole_name(simulation, container);
    let whole = match outer.as_str() {
        "" => name.to_owned(),
        outer if name.starts_with('[') => format!("{outer}{name}"),
        outer => format!("{outer}.{name}"),
    };
    simulation.resolve(&whole).map_err(|unknown| unknown.message)
}

/// Reads a value that a person typed: a literal of the type, or an expression.
pub(crate) fn read(text: &str, ty: Scalar, scope: Scope<'_>) -> Result<Value, Problem> {
    // A person may have edited the text that is shown.
    let text = text.rsplit(WAITING).next().unwrap_or(text).trim();
    let text = text.strip_suffix("after this scan").unwrap_or(text).trim();
    let text = text.strip_suffix(FORCED.trim()).unwrap_or(text).trim();
    let problem = match value_text::parse(text, ty) {
        Ok(value) => return Ok(value),
        Err(problem) => problem,
    };
    let Ok(mut watch) = Expression::new(text, scope) else {
        return Err(problem);
    };
    let found = watch.evaluate(scope.simulation)?;
    if found.ty == ty {
        return Ok(found.value);
    }
    // A number passes where its spelling is one of the type.
    value_text::parse(&found.shown(), ty).map_err(|_| problem)
}
