//! Bodies: LD and FBD as graphs, ST and IL as texts.

use super::Reader;
use crate::graph::{Code, Edge, End, Graph, Kind, Modifier, Node as Drawn, Output, Pin, Storage};
use crate::model::Body;
use ladder_notation::LineColumn;
use ladder_notation::xml::{Element, in_words};
use roxmltree::Node;
use std::collections::HashMap;

/// A connection as it is written: at which pin of which element, and what it names.
struct Connection {
    node: usize,
    pin: usize,
    place: LineColumn,
    to: String,
    output: Option<String>,
}

#[derive(Default)]
pub(super) struct Reading {
    graph: Graph,
    /// The elements by their `localId`; of two the first.
    by_id: HashMap<String, usize>,
    connections: Vec<Connection>,
    /// Connectors by name, and the continuations of each.
    connectors: HashMap<String, usize>,
    continuations: Vec<(usize, String)>,
}

/// Lets a value that comes through connectors and continuations come from where it is.
fn pass_values(graph: &mut Graph, passed: &[usize]) {
    let source = |node: usize| match &graph.nodes[node].inputs[..] {
        [pin] if pin.modifier == Modifier::default() => match pin.from[..] {
            [end] => Some((node, end)),
            _ => None,
        },
        _ => None,
    };
    let sources: HashMap<usize, End> = passed.iter().filter_map(|node| source(*node)).collect();
    let values: HashMap<usize, End> = passed
        .iter()
        .filter_map(|node| {
            let mut end = *sources.get(node)?;
            for _ in 0..passed.len() {
                end = sources.get(&end.node).copied().unwrap_or(end);
            }
            matches!(graph.nodes[end.node].kind, Kind::Value(..)).then_some((*node, end))
        })
        .collect();
    let pins = graph.nodes.iter_mut().flat_map(|node| &mut node.inputs);
    for end in pins.flat_map(|pin| &mut pin.from) {
        *end = values.get(&end.node).copied().unwrap_or(*end);
    }
}

impl<'x> Reader<'x, '_> {
    pub(super) fn body(&mut self, node: Node<'x, '_>) -> Body {
        let Some(language) = node
            .elements()
            .find(|child| !child.is("addData") && !child.is("documentation"))
        else {
            return Body::Empty;
        };
        match Element::name(&language) {
            "LD" | "FBD" => Body::Graph(self.graph(language.elements())),
            "ST" => text("ST", &language.words(), self.xml.place_of_words(language)),
            "IL" => text("IL", &language.words(), self.xml.place_of_words(language)),
            "SFC" => self.chart(language),
            _ => Body::Text(
                "a language of its own",
                in_words(language),
                self.xml.place(language),
            ),
        }
    }

    /// Joins continuations to the connectors of their names; `why` is what is wrong where there is none.
    pub(super) fn continued(
        &mut self,
        graph: &mut Graph,
        connectors: &HashMap<String, usize>,
        continuations: Vec<(usize, String)>,
        why: &str,
    ) {
        for (node, name) in continuations {
            match connectors.get(&name) {
                Some(connector) => graph.nodes[node].inputs.push(Pin {
                    from: vec![End {
                        node: *connector,
                        output: 0,
                    }],
                    ..Pin::default()
                }),
                None => {
                    let place = graph.nodes[node].place;
                    let shown = format!("continuation {name}");
                    self.project.report.refused(place, shown, why);
                }
            }
        }
    }

    fn graph(&mut self, elements: impl Iterator<Item = Node<'x, 'x>>) -> Graph {
        let mut reading = Reading::default();
        for node in elements {
            self.element(node, &mut reading);
        }
        self.joined(reading)
    }

    /// The elements that were read, joined by their wires.
    pub(super) fn joined(&mut self, reading: Reading) -> Graph {
        let Reading {
            mut graph,
            by_id,
            connections,
            connectors,
            continuations,
        } = reading;
        let passed: Vec<usize> = connectors
            .values()
            .copied()
            .chain(continuations.iter().map(|(node, _)| *node))
            .collect();
        self.continued(
            &mut graph,
            &connectors,
            continuations,
            "no connector has this name",
        );
        for connection in connections {
            let Some(&node) = by_id.get(&connection.to) else {
                let shown = format!("connection to {}", connection.to);
                let why = "no element has this localId";
                self.project.report.refused(connection.place, shown, why);
                continue;
            };
            let outputs = &graph.nodes[node].outputs;
            let named = connection.output.filter(|name| !name.is_empty());
            let output = named.as_ref().and_then(|name| {
                let mut outputs = outputs.iter();
                outputs.position(|output| output.name.eq_ignore_ascii_case(name))
            });
            if let (Some(name), None, true) = (&named, output, outputs.len() > 1) {
                let shown = format!("connection to {name}");
                self.project.report.approximated(
                    connection.place,
                    shown,
                    "the block has no such output: the first is taken",
                );
            }
            let end = End {
                node,
                output: output.unwrap_or(0),
            };
            graph.nodes[connection.node].inputs[connection.pin].from.push(end);
        }
        pass_values(&mut graph, &passed);
        graph.open(&mut self.project.report);
        graph
    }

    pub(super) fn element(&mut self, node: Node<'x, '_>, reading: &mut Reading) {
        let place = self.xml.place(node);
        let modifier = modifier(node);
        let variable = || {
            node.child("variable")
                .map(|node| node.words())
                .unwrap_or_default()
        };
        let expression = || {
            node.child("expression")
                .map(|node| node.words())
                .unwrap_or_default()
        };
        let negated = node.flag("negated");
        let name = || node.attribute("name").unwrap_or_default().to_owned();
        let label = || node.attribute("label").unwrap_or_default().to_owned();
        let kind = match Element::name(&node) {
            "leftPowerRail" => Kind::LeftRail,
            "rightPowerRail" => Kind::RightRail,
            "contact" => Kind::Contact(variable(), modifier),
            "coil" => Kind::Coil(variable(), modifier, storage(node)),
            "block" => Kind::Block {
                name: node.attribute("typeName").unwrap_or_default().to_owned(),
                instance: node
                    .attribute("instanceName")
                    .map(str::to_owned)
                    .filter(|name| !name.is_empty()),
                code: self.code(node),
            },
            "inVariable" => Kind::Value(expression(), negated),
            "outVariable" => Kind::Variable(expression(), negated),
            "inOutVariable" => return self.in_out_variable(node, reading),
            "label" => Kind::Label(label()),
            "jump" => Kind::Jump(label(), negated),
            "return" => Kind::Return(negated),
            "connector" | "continuation" => Kind::Joint,
            "comment" => Kind::Comment(node.child("content").map(|node| node.words()).unwrap_or_default()),
            "vendorElement" => match title(node) {
                Some(title) => Kind::Comment(title),
                None => return,
            },
            "addData" | "documentation" => return,
            other => Kind::Other(other.to_owned()),
        };
        let index = reading.graph.nodes.len();
        match Element::name(&node) {
            "connector" => drop(reading.connectors.entry(name()).or_insert(index)),
            "continuation" => reading.continuations.push((index, name())),
            _ => {}
        }
        let is_block = matches!(kind, Kind::Block { .. });
        let mut drawn = Drawn::new(place, kind, Vec::new());
        drawn.position = position(node);
        drawn.order = node
            .attribute("executionOrderId")
            .and_then(|number| number.parse().ok())
            .filter(|number| *number > 0);
        let mut pins: Vec<(Pin, Option<Node<'_, '_>>)> = Vec::new();
        if is_block {
            drawn.outputs.clear();
            for (list, in_out) in [("inputVariables", false), ("inOutVariables", true)] {
                for variable in node
                    .child(list)
                    .iter()
                    .flat_map(|list| list.children_of("variable"))
                {
                    pins.push((pin(variable, in_out), variable.child("connectionPointIn")));
                }
            }
            for list in ["outputVariables", "inOutVariables"] {
                for variable in node
                    .child(list)
                    .iter()
                    .flat_map(|list| list.children_of("variable"))
                {
                    drawn.outputs.push(Output {
                        name: variable
                            .attribute("formalParameter")
                            .unwrap_or_default()
                            .trim()
                            .to_owned(),
                        negated: variable.flag("negated"),
                    });
                }
            }
            if drawn.outputs.is_empty() {
                drawn.outputs.push(Output::default());
            }
        } else {
            pins.extend(
                node.children_of("connectionPointIn")
                    .map(|point| (Pin::default(), Some(point))),
            );
            if pins.is_empty()
                && !matches!(
                    drawn.kind,
                    Kind::LeftRail | Kind::Value(..) | Kind::Label(_) | Kind::Comment(_)
                )
                && !Element::name(&node).eq("continuation")
            {
                pins.push((Pin::default(), None));
            }
        }
        for (number, (pin, point)) in pins.into_iter().enumerate() {
            drawn.inputs.push(pin);
            self.wires(point, (index, number), reading);
        }
        reading.graph.nodes.push(drawn);
        self.number(node, index, reading);
    }

    /// An element of the reader's own that the wires at a point of another end at.
    pub(super) fn ends_at(&self, node: Node<'x, '_>, kind: Kind, reading: &mut Reading) -> usize {
        let index = reading.graph.nodes.len();
        let drawn = Drawn::new(self.xml.place(node), kind, vec![Pin::default()]);
        reading.graph.nodes.push(drawn);
        self.wires(node.child("connectionPointIn"), (index, 0), reading);
        index
    }

    /// The wires that end at a pin of an element.
    fn wires(&self, point: Option<Node<'_, '_>>, (node, pin): (usize, usize), reading: &mut Reading) {
        {
            let connections = point.iter().flat_map(|point| point.children_of("connection"));
            reading.connections.extend(connections.map(|connection| {
                Connection {
                    node,
                    pin,
                    place: self.xml.place(connection),
                    to: connection.attribute("refLocalId").unwrap_or_default().to_owned(),
                    output: connection
                        .attribute("formalParameter")
                        .map(|name| name.trim().to_owned()),
                }
            }));
        }
    }

    /// The text of a block in ST.
    fn code(&self, node: Node<'x, '_>) -> Option<Code> {
        let data = node.child("addData")?;
        let is_code = |node: &Node<'_, '_>| node.is_element() && (node.is("STCode") || node.is("code"));
        let code = data.descendants().find(is_code);
        let is_execute = || {
            let name = node.attribute("typeName");
            name.is_some_and(|name| name.eq_ignore_ascii_case("EXECUTE"))
        };
        let found = code.or_else(|| Some(data).filter(|_| is_execute()))?;
        let text = found.words();
        (code.is_some() || !text.is_empty()).then(|| Code {
            text,
            place: Some(self.xml.place_of_words(found)),
        })
    }

    /// A variable that is written and read: one of each, of which the second is what others are wired to.
    fn in_out_variable(&mut self, node: Node<'x, '_>, reading: &mut Reading) {
        let place = self.xml.place(node);
        let expression = node
            .child("expression")
            .map(|node| node.words())
            .unwrap_or_default();
        let (x, y) = position(node);
        let index = reading.graph.nodes.len();
        let point = node.child("connectionPointIn");
        let mut connections = point
            .iter()
            .flat_map(|point| point.children_of("connection"))
            .peekable();
        if connections.peek().is_some() {
            let kind = Kind::Variable(expression.clone(), node.flag("negatedIn"));
            let mut written = Drawn::new(place, kind, vec![Pin::default()]);
            written.position = (x, y);
            reading.graph.nodes.push(written);
            reading
                .connections
                .extend(connections.map(|connection| Connection {
                    node: index,
                    pin: 0,
                    place: self.xml.place(connection),
                    to: connection.attribute("refLocalId").unwrap_or_default().to_owned(),
                    output: connection.attribute("formalParameter").map(str::to_owned),
                }));
        }
        let mut read = Drawn::new(
            place,
            Kind::Value(expression, node.flag("negatedOut")),
            Vec::new(),
        );
        read.position = (x, y);
        let index = reading.graph.nodes.len();
        reading.graph.nodes.push(read);
        self.number(node, index, reading);
    }

    fn number(&mut self, node: Node<'x, '_>, index: usize, reading: &mut Reading) {
        let Some(id) = node.attribute("localId") else {
            return;
        };
        if let Some(first) = reading.by_id.get(id) {
            let first = reading.graph.nodes[*first].place;
            let why = format!("the element at {first} has this localId too, and wires end at that");
            self.project
                .report
                .approximated(self.xml.place(node), format!("localId {id}"), why);
            return;
        }
        reading.by_id.insert(id.to_owned(), index);
    }
}

pub(super) fn text(language: &'static str, text: &str, place: LineColumn) -> Body {
    if text.is_empty() {
        Body::Empty
    } else {
        Body::Text(language, text.to_owned(), place)
    }
}

fn pin(variable: Node<'_, '_>, in_out: bool) -> Pin {
    Pin {
        name: variable
            .attribute("formalParameter")
            .unwrap_or_default()
            .trim()
            .to_owned(),
        modifier: modifier(variable),
        from: Vec::new(),
        in_out,
    }
}

pub(super) fn modifier(node: Node<'_, '_>) -> Modifier {
    Modifier {
        negated: node.flag("negated"),
        edge: match node.attribute("edge") {
            Some("rising") => Edge::Rising,
            Some("falling") => Edge::Falling,
            _ => Edge::None,
        },
    }
}

/// IEC 61131-10 calls it a latch.
pub(super) fn storage(node: Node<'_, '_>) -> Storage {
    match node.attribute("storage").or_else(|| node.attribute("latch")) {
        Some("set") => Storage::Set,
        Some("reset") => Storage::Reset,
        _ => Storage::None,
    }
}

fn position(node: Node<'_, '_>) -> (f64, f64) {
    let Some(position) = node.child("position") else {
        return (0.0, 0.0);
    };
    let number = |name| {
        let number: Option<f64> = position.attribute(name).and_then(|number| number.parse().ok());
        number.filter(|number| number.is_finite()).unwrap_or(0.0)
    };
    (number("x"), number("y"))
}

/// The title of a network as CODESYS has it. None: something else of its own, which says nothing.
fn title(node: Node<'_, '_>) -> Option<String> {
    let ty = node
        .descendants()
        .find(|node| node.is_element() && node.is("ElementType"))?;
    let title = node.child("alternativeText")?.words();
    (ty.words().eq_ignore_ascii_case("networktitle") && !title.is_empty()).then_some(title)
}
