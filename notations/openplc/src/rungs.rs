//! The rungs: elements and the edges between their handles.

use ladder_notation::{LineColumn, Lines, ReadError, Report};
use ladder_notation_plcopen::graph::{Code, Edge, End, Graph, Kind, Modifier, Node, Output, Pin, Storage};
use serde::Deserialize;
use serde_json::Value;
use serde_json::value::RawValue;
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::ops::Range;

/// Rungs are this far apart in the one drawing that they become.
const APART: f64 = 100_000.0;

#[derive(Deserialize)]
struct Flow<'t> {
    #[serde(borrow, default)]
    rungs: Vec<Rung<'t>>,
}

#[derive(Deserialize)]
struct Rung<'t> {
    #[serde(default)]
    comment: Option<String>,
    #[serde(borrow, default)]
    nodes: Vec<&'t RawValue>,
    #[serde(borrow, default)]
    edges: Vec<&'t RawValue>,
}

#[derive(Deserialize)]
struct Element {
    #[serde(default)]
    id: String,
    #[serde(default, rename = "type")]
    ty: String,
    #[serde(default)]
    position: Option<Position>,
    #[serde(default)]
    data: Value,
}

#[derive(Deserialize)]
struct Position {
    #[serde(default)]
    x: f64,
    #[serde(default)]
    y: f64,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Wire {
    source: String,
    #[serde(default)]
    source_handle: Option<String>,
    target: String,
    #[serde(default)]
    target_handle: Option<String>,
}

/// The rungs as one drawing.
///
/// # Errors
///
/// If they are not JSON, or no rungs.
pub(super) fn read(text: &str, json: Range<usize>, report: &mut Report) -> Result<Graph, ReadError> {
    let lines = Lines::of(text);
    let json = &text[json];
    let start = json.as_ptr() as usize - text.as_ptr() as usize;
    let flow: Flow<'_> = serde_json::from_str(json).map_err(|error| {
        let first = lines.place(text, start);
        let (line, column) = (error.line() as u32, error.column() as u32);
        let place = LineColumn {
            line: first.line + line.max(1) - 1,
            column: if line <= 1 {
                first.column + column.max(1) - 1
            } else {
                column.max(1)
            },
        };
        let told = error.to_string();
        let told = told.split(" at line ").next().unwrap_or_default().to_owned();
        ReadError::at(place, format!("these are no rungs in JSON: {told}"))
    })?;
    let mut reader = Reader {
        place: |raw: &RawValue| lines.place(text, raw.get().as_ptr() as usize - text.as_ptr() as usize),
        graph: Graph::default(),
        report,
        top: 0.0,
    };
    for rung in &flow.rungs {
        reader.rung(rung);
        reader.top += APART;
    }
    let Reader {
        mut graph, report, ..
    } = reader;
    graph.open(report);
    Ok(graph)
}

struct Reader<'r, P> {
    place: P,
    graph: Graph,
    report: &'r mut Report,
    top: f64,
}

/// A pin that is wired: of which element, under which handle.
type Handles = HashMap<String, (usize, Vec<String>, Vec<String>)>;

impl<P: Fn(&RawValue) -> LineColumn> Reader<'_, P> {
    fn rung(&mut self, rung: &Rung<'_>) {
        let mut known: Handles = HashMap::new();
        let mut tied = Vec::new();
        let first = rung.nodes.first().map(|node| (self.place)(node));
        let first = first.unwrap_or(LineColumn::START);
        self.graph.networks.push(first);
        if let Some(comment) = rung
            .comment
            .as_deref()
            .map(str::trim)
            .filter(|comment| !comment.is_empty())
        {
            let mut node = Node::new(first, Kind::Comment(comment.to_owned()), Vec::new());
            node.position.1 = self.top - 1.0;
            self.graph.nodes.push(node);
        }
        for raw in &rung.nodes {
            let place = (self.place)(raw);
            match serde_json::from_str::<Element>(raw.get()) {
                Ok(element) => self.element(element, place, &mut known, &mut tied),
                Err(error) => {
                    self.report
                        .refused(place, "element", format!("it is no element of a rung: {error}"));
                }
            }
        }
        let mut wires = Vec::new();
        for raw in &rung.edges {
            let place = (self.place)(raw);
            match serde_json::from_str::<Wire>(raw.get()) {
                Ok(wire) => wires.push((place, wire)),
                Err(error) => self
                    .report
                    .refused(place, "edge", format!("it is no edge of a rung: {error}")),
            }
        }
        // What comes straight on is above what comes from below.
        wires.sort_by(|(_, one), (_, other)| one.target_handle.cmp(&other.target_handle));
        for (place, wire) in wires {
            self.wire(&wire, place, &known);
        }
        for (variable, place, block, handle, is_input) in tied {
            let (source, target) = if is_input {
                (variable, block)
            } else {
                (block, variable)
            };
            let named = |is_block: bool| is_block.then(|| handle.clone());
            let wire = Wire {
                source,
                source_handle: named(!is_input),
                target,
                target_handle: named(is_input),
            };
            self.wire(&wire, place, &known);
        }
    }

    fn wire(&mut self, wire: &Wire, place: LineColumn, known: &Handles) {
        let shown = format!("edge from {} to {}", wire.source, wire.target);
        let (Some((source, _, outputs)), Some((target, inputs, _))) =
            (known.get(&wire.source), known.get(&wire.target))
        else {
            self.report
                .refused(place, shown, "no element of the rung has this id");
            return;
        };
        let find = |handles: &[String], handle: &Option<String>| match handle {
            Some(handle) if handles.len() != 1 || !handles[0].is_empty() => {
                handles.iter().position(|name| name.eq_ignore_ascii_case(handle))
            }
            _ => Some(0),
        };
        let output = find(outputs, &wire.source_handle);
        let input = find(inputs, &wire.target_handle);
        let (Some(output), Some(input)) = (output, input) else {
            self.report.refused(place, shown, "an element has no such handle");
            return;
        };
        let end = End {
            node: *source,
            output,
        };
        if let Some(pin) = self.graph.nodes[*target].inputs.get_mut(input)
            && !pin.from.contains(&end)
        {
            pin.from.push(end);
        }
    }

    fn element(
        &mut self,
        mut element: Element,
        place: LineColumn,
        known: &mut Handles,
        tied: &mut Vec<(String, LineColumn, String, String, bool)>,
    ) {
        let data = &element.data;
        let text = |value: &Value, path: &str| {
            value
                .pointer(path)
                .and_then(Value::as_str)
                .unwrap_or_default()
                .to_owned()
        };
        let variant = text(data, "/variant");
        let variable = match data.get("variable") {
            Some(Value::String(name)) => name.clone(),
            _ => text(data, "/variable/name"),
        };
        let modifier = Modifier {
            negated: variant == "negated",
            edge: match variant.as_str() {
                "risingEdge" => Edge::Rising,
                "fallingEdge" => Edge::Falling,
                _ => Edge::None,
            },
        };
        let kind = match element.ty.as_str() {
            "powerRail" if variant == "right" => Kind::RightRail,
            "powerRail" => Kind::LeftRail,
            "contact" => Kind::Contact(variable, modifier),
            "coil" => {
                let storage = match variant.as_str() {
                    "set" => Storage::Set,
                    "reset" => Storage::Reset,
                    _ => Storage::None,
                };
                Kind::Coil(variable, modifier, storage)
            }
            "parallel" => Kind::Joint,
            "block" => {
                let is_block = text(data, "/variant/type") == "function-block";
                Kind::Block {
                    name: text(data, "/variant/name"),
                    instance: Some(variable).filter(|name| is_block && !name.is_empty()),
                    code: None,
                }
            }
            "execute" => Kind::Block {
                name: "EXECUTE".to_owned(),
                instance: None,
                code: Some(Code {
                    text: text(data, "/code"),
                    place: None,
                }),
            },
            "variable" => {
                let is_input = variant != "output";
                let (block, handle) = (text(data, "/block/id"), text(data, "/block/handleId"));
                if !block.is_empty() {
                    tied.push((element.id.clone(), place, block, handle, is_input));
                }
                if is_input {
                    Kind::Value(variable, false)
                } else {
                    Kind::Variable(variable, false)
                }
            }
            // What the editor shows while something is dragged.
            "placeholder" | "parallelPlaceholder" | "mockNode" => return,
            other => Kind::Other(other.to_owned()),
        };
        let mut node = Node::new(place, kind, vec![Pin::default()]);
        let position = element.position.take().unwrap_or(Position { x: 0.0, y: 0.0 });
        node.position = (position.x, self.top + position.y.clamp(0.0, APART - 1.0));
        let order = data.get("executionOrder").and_then(Value::as_u64);
        node.order = order
            .and_then(|order| u32::try_from(order).ok())
            .filter(|order| *order > 0);
        if matches!(node.kind, Kind::LeftRail | Kind::Value(..)) {
            node.inputs.clear();
        }
        if matches!(node.kind, Kind::Block { .. }) {
            Self::pins(&element, &mut node);
        }
        let inputs = node.inputs.iter().map(|pin| pin.name.clone()).collect();
        let outputs = node.outputs.iter().map(|output| output.name.clone()).collect();
        let index = self.graph.nodes.len();
        match known.entry(element.id) {
            Entry::Vacant(entry) => drop(entry.insert((index, inputs, outputs))),
            Entry::Occupied(entry) => {
                let why = "another element of the rung has this id, and wires end at that";
                self.report
                    .approximated(place, format!("id {}", entry.key()), why);
            }
        }
        self.graph.nodes.push(node);
    }

    /// The pins of a block: those of its variant, and EN and ENO where they are shown.
    fn pins(element: &Element, node: &mut Node) {
        node.inputs.clear();
        node.outputs.clear();
        let pin = |name: &str, in_out| Pin {
            name: name.to_owned(),
            in_out,
            ..Pin::default()
        };
        let output = |name: &str| Output {
            name: name.to_owned(),
            negated: false,
        };
        let is_execute = element.ty == "execute";
        if is_execute || element.data.get("executionControl").and_then(Value::as_bool) == Some(true) {
            node.inputs.push(pin("EN", false));
            node.outputs.push(output("ENO"));
        }
        let variables = element
            .data
            .pointer("/variant/variables")
            .and_then(Value::as_array);
        for variable in variables.into_iter().flatten() {
            let text = |name: &str| variable.get(name).and_then(Value::as_str).unwrap_or_default();
            let name = text("name");
            let has_input = node.inputs.iter().any(|pin| pin.name.eq_ignore_ascii_case(name));
            let has_output = node
                .outputs
                .iter()
                .any(|output| output.name.eq_ignore_ascii_case(name));
            match text("class") {
                "output" if !has_output => node.outputs.push(output(name)),
                "inOut" if !has_input => {
                    node.inputs.push(pin(name, true));
                    node.outputs.push(output(name));
                }
                "input" if !has_input => node.inputs.push(pin(name, false)),
                _ => {}
            }
        }
        if node.outputs.is_empty() {
            node.outputs.push(Output::default());
        }
    }
}
