//! Projects in the form of IEC 61131-10: units and types in namespaces, drawings in rungs whose elements say what they are in
//! `xsi:type`, and wires that name the output they begin at.

use super::body::storage;
use super::interface::{comment, initial};
use super::{Reader, named};
use crate::chart;
use crate::graph::{Edge, End, Graph, Kind, Modifier, Node as Drawn, Output, Pin};
use crate::model::{Body, Evaluation, Role, Task, Type, TypeDeclaration, Unit, UnitKind, Variable};
use ladder_format::program::Qualifier;
use ladder_notation::LineColumn;
use ladder_notation::xml::{Element, in_words};
use roxmltree::Node;
use std::collections::HashMap;

const INSTANCE: &str = "http://www.w3.org/2001/XMLSchema-instance";

/// Types nest no deeper.
const DEEPEST: usize = 16;

/// What an element says that it is.
fn kind<'a>(node: Node<'a, '_>) -> &'a str {
    let told = node.attribute((INSTANCE, "type")).unwrap_or_default();
    told.rsplit(':').next().unwrap_or_default()
}

fn text(node: Node<'_, '_>, attribute: &str) -> String {
    node.attribute(attribute).unwrap_or_default().to_owned()
}

impl<'x> Reader<'x, '_> {
    /// All that is in the project after its head.
    pub(super) fn ten(&mut self, root: Node<'x, '_>) {
        // Its networks are drawn one by one, and each is run once.
        self.project.evaluation = Evaluation::Once;
        let types = root.child("Types");
        for node in types.iter().flat_map(Node::descendants).filter(Node::is_element) {
            match Element::name(&node) {
                "Program" => self.unit_of_ten(node, UnitKind::Program),
                "FunctionBlock" => self.unit_of_ten(node, UnitKind::FunctionBlock),
                "Function" => self.unit_of_ten(node, UnitKind::Function),
                "DataTypeDecl" => self.type_of_ten(node),
                "Class" | "Interface" => {
                    let shown = format!("{} {}", Element::name(&node), text(node, "name"));
                    let why = "ladder text has no classes";
                    self.project.report.refused(self.xml.place(node), shown, why);
                }
                _ => {}
            }
        }
        for instances in root.children_of("Instances") {
            for node in instances.descendants().filter(Node::is_element) {
                match Element::name(&node) {
                    "GlobalVars" => {
                        let more = self.list_of_ten(node, Role::Global);
                        self.project.globals.extend(more);
                    }
                    "Resource" => self.tasks_of_ten(node),
                    _ => {}
                }
            }
        }
    }

    fn tasks_of_ten(&mut self, resource: Node<'x, '_>) {
        let instances: Vec<Node<'_, '_>> = resource.children_of("ProgramInstance").collect();
        let of = |name: Option<&str>| -> Vec<(LineColumn, String)> {
            let own = instances.iter().filter(|node| {
                node.attribute("associatedTaskName")
                    .filter(|name| !name.is_empty())
                    == name
            });
            own.map(|node| (self.xml.place(*node), text(*node, "typeName")))
                .collect()
        };
        let mut tasks = Vec::new();
        for node in resource.children_of("Task") {
            tasks.push(Task {
                place: self.xml.place(node),
                name: text(node, "name"),
                interval: named(node, "interval"),
                event: named(node, "single"),
                priority: node
                    .attribute("priority")
                    .and_then(|it| it.parse().ok())
                    .unwrap_or(0),
                programs: of(node.attribute("name")),
            });
        }
        let left = of(None);
        if !left.is_empty() {
            tasks.push(Task {
                place: self.xml.place(resource),
                name: String::new(),
                interval: None,
                event: None,
                priority: i64::MAX,
                programs: left,
            });
        }
        self.project.tasks.extend(tasks);
    }

    fn unit_of_ten(&mut self, node: Node<'x, '_>, of: UnitKind) {
        let mut variables = Vec::new();
        let parameters = node.child("Parameters");
        for list in parameters
            .iter()
            .flat_map(Element::elements)
            .chain(node.elements())
        {
            let role = match Element::name(&list) {
                "InputVars" => Role::Input,
                "OutputVars" => Role::Output,
                "InoutVars" | "InOutVars" => Role::InOut,
                "ExternalVars" => Role::External,
                "Vars" | "GlobalVars" => Role::Local,
                "TempVars" => Role::Temp,
                _ => continue,
            };
            variables.extend(self.list_of_ten(list, role));
        }
        let returns = node.child("ResultType").map(|ty| self.inside_of_ten(ty, 0));
        let mut body = Body::Empty;
        for part in node
            .child("MainBody")
            .iter()
            .flat_map(|body| body.children_of("BodyContent"))
        {
            let more = self.body_of_ten(part);
            body = match (body, more) {
                (Body::Empty, more) => more,
                (Body::Graph(mut graph), Body::Graph(more)) => {
                    graph.append(more);
                    Body::Graph(graph)
                }
                (body, _) => {
                    let why = "a unit has one body here: the first is read";
                    self.project.report.refused(self.xml.place(part), "body", why);
                    body
                }
            };
        }
        for part in node
            .elements()
            .filter(|part| part.is("Action") || part.is("Method"))
        {
            let shown = format!("{} {}", Element::name(&part).to_lowercase(), text(part, "name"));
            let why = "what only charts and classes run has no counterpart";
            self.project.report.refused(self.xml.place(part), shown, why);
        }
        self.project.units.push(Unit {
            place: self.xml.place(node),
            name: text(node, "name"),
            kind: of,
            returns,
            variables,
            comment: comment(node),
            body,
            parts: Vec::new(),
        });
    }

    fn list_of_ten(&mut self, list: Node<'x, '_>, role: Role) -> Vec<Variable> {
        let qualifier = if list.flag("constant") {
            Some(Qualifier::Constant)
        } else if list.flag("retain") {
            Some(Qualifier::Retain)
        } else {
            None
        };
        let variables = list.children_of("Variable").map(|node| {
            let address = node
                .child("Address")
                .and_then(|address| address.attribute("address"));
            Variable {
                role,
                qualifier,
                address: address.filter(|it| !it.is_empty()).map(str::to_owned),
                initial: initial(node, 0),
                comment: comment(node),
                ..Variable::local(
                    self.xml.place(node),
                    text(node, "name"),
                    self.declared_of_ten(node, 0),
                )
            }
        });
        variables.collect()
    }

    /// The type that a variable or member is declared with.
    fn declared_of_ten(&self, node: Node<'x, '_>, depth: usize) -> Type {
        match node.child("Type") {
            Some(ty) => self.inside_of_ten(ty, depth),
            None => Type::Other("a variable without type".to_owned()),
        }
    }

    /// The type that an element holds: its name, or what it is.
    fn inside_of_ten(&self, node: Node<'x, '_>, depth: usize) -> Type {
        if depth > DEEPEST {
            return Type::Other(format!("a type in more than {DEEPEST} others"));
        }
        let Some(inner) = node.elements().next() else {
            return Type::Named(node.words());
        };
        match Element::name(&inner) {
            "TypeName" => Type::Named(inner.words()),
            _ => self.spec_of_ten(inner, depth + 1),
        }
    }

    fn spec_of_ten(&self, node: Node<'x, '_>, depth: usize) -> Type {
        let base = || match node.child("BaseType") {
            Some(base) => self.inside_of_ten(base, depth),
            None => Type::Other("a type of nothing".to_owned()),
        };
        let range = |node: Node<'_, '_>| (text(node, "lower"), text(node, "upper"));
        match kind(node) {
            "StringTypeSpec" | "WStringTypeSpec" => {
                let length = node.attribute("maxLength").or_else(|| node.attribute("length"));
                Type::Text(length.and_then(|length| length.parse().ok()))
            }
            "ArrayTypeSpec" => {
                let dimensions = node
                    .children_of("DimensionSpec")
                    .filter_map(|it| it.child("IndexRange"));
                Type::Array(dimensions.map(range).collect(), Box::new(base()))
            }
            "EnumTypeSpec" | "EnumTypeWithNamedValueSpec" => {
                let values = node.children_of("Enumerator").map(|value| {
                    let number = value.child("Value").map(|it| it.words());
                    let number = number.or_else(|| value.attribute("value").map(str::to_owned));
                    (text(value, "name"), number.filter(|it| !it.is_empty()))
                });
                Type::Enumeration(values.collect())
            }
            "StructTypeSpec" => {
                let members = node.children_of("Member").map(|member| Variable {
                    initial: initial(member, 0),
                    comment: comment(member),
                    ..Variable::local(
                        self.xml.place(member),
                        text(member, "name"),
                        self.declared_of_ten(member, depth),
                    )
                });
                Type::Structure(members.collect())
            }
            "SubrangeTypeSpec" => {
                let (low, high) = node.child("Range").map(range).unwrap_or_default();
                match base() {
                    Type::Named(base) => Type::Range(base, low, high),
                    other => other,
                }
            }
            "DirectlyDerivedTypeSpec" => base(),
            other => Type::Other(format!("a `{other}`")),
        }
    }

    fn type_of_ten(&mut self, node: Node<'x, '_>) {
        let spec = node.child("UserDefinedTypeSpec");
        self.project.types.push(TypeDeclaration {
            place: self.xml.place(node),
            name: text(node, "name"),
            ty: match spec {
                Some(spec) => self.spec_of_ten(spec, 0),
                None => Type::Other("nothing".to_owned()),
            },
            initial: spec.and_then(|spec| initial(spec, 0)),
            comment: comment(node),
        });
    }

    fn body_of_ten(&mut self, node: Node<'x, '_>) -> Body {
        match kind(node) {
            "ST" => super::body::text("ST", &node.words(), self.xml.place_of_words(node)),
            "IL" => super::body::text("IL", &node.words(), self.xml.place_of_words(node)),
            "SFC" => {
                let parts = node.elements().map(|part| (self.xml.place(part), in_words(part)));
                let elements = node.elements().take(1).map(|part| chart::Element {
                    place: self.xml.place(part),
                    id: String::new(),
                    from: Vec::new(),
                    kind: chart::Kind::Other("SFC of IEC 61131-10".to_owned()),
                });
                Body::Chart(chart::Drawn {
                    shown: parts.collect(),
                    elements: elements.collect(),
                    ..chart::Drawn::default()
                })
            }
            _ => {
                let mut graph = Graph::default();
                let mut top = 0.0;
                for rung in node
                    .elements()
                    .filter(|part| part.is("Rung") || part.is("Network"))
                {
                    top = self.rung_of_ten(rung, &mut graph, top);
                }
                graph.open(&mut self.project.report);
                Body::Graph(graph)
            }
        }
    }

    /// Puts a rung below this height; comes back where it ends.
    fn rung_of_ten(&mut self, rung: Node<'x, '_>, graph: &mut Graph, top: f64) -> f64 {
        let mut ends: HashMap<&str, End> = HashMap::new();
        let mut wires: Vec<(usize, usize, Node<'_, '_>)> = Vec::new();
        let mut connectors: HashMap<String, usize> = HashMap::new();
        let mut continuations = Vec::new();
        let mut bottom = top;
        graph.networks.push(self.xml.place(rung));
        if let Some(label) = rung.attribute("label").filter(|label| !label.is_empty()) {
            let mut node = Drawn::new(self.xml.place(rung), Kind::Label(label.to_owned()), Vec::new());
            node.position = (0.0, top);
            graph.nodes.push(node);
        }
        for object in rung.elements().filter(|object| !object.is("AddData")) {
            let index = graph.nodes.len();
            let (drawn, pins, outputs) = self.object_of_ten(object, top);
            bottom = drawn.position.1.max(bottom);
            for (pin, point) in pins.into_iter().enumerate() {
                let connections = point.iter().flat_map(|point| point.children_of("Connection"));
                wires.extend(connections.map(|connection| (index, pin, connection)));
            }
            for (output, point) in outputs {
                if let Some(id) = point.attribute("connectionPointOutId") {
                    ends.entry(id).or_insert(End { node: index, output });
                }
            }
            match kind(object) {
                "Connector" => drop(connectors.entry(text(object, "label")).or_insert(index)),
                "Continuation" => continuations.push((index, text(object, "label"))),
                _ => {}
            }
            graph.nodes.push(drawn);
        }
        for (node, pin, connection) in wires {
            let id = connection
                .attribute("refConnectionPointOutId")
                .unwrap_or_default();
            match ends.get(id) {
                Some(end) => graph.nodes[node].inputs[pin].from.push(*end),
                None => {
                    let shown = format!("connection to {id}");
                    let why = "no element of the rung has this output";
                    self.project
                        .report
                        .refused(self.xml.place(connection), shown, why);
                }
            }
        }
        let why = "no connector of the rung has this name";
        self.continued(graph, &connectors, continuations, why);
        bottom + 100.0
    }

    /// An element of a rung, where wires end at its pins, and where they begin.
    fn object_of_ten(
        &self,
        node: Node<'x, 'x>,
        top: f64,
    ) -> (Drawn, Vec<Option<Node<'x, 'x>>>, Vec<(usize, Node<'x, 'x>)>) {
        let modifier = Modifier {
            negated: node.flag("negated"),
            edge: match node.attribute("edge") {
                Some("rising") => Edge::Rising,
                Some("falling") => Edge::Falling,
                _ => Edge::None,
            },
        };
        let negated = modifier.negated;
        let label = || {
            let label = node.attribute("targetLabel").or_else(|| node.attribute("label"));
            label.unwrap_or_default().to_owned()
        };
        let shape = match kind(node) {
            "LeftPowerRail" => Kind::LeftRail,
            "RightPowerRail" => Kind::RightRail,
            "Contact" => Kind::Contact(text(node, "operand"), modifier),
            "Coil" => Kind::Coil(text(node, "operand"), modifier, storage(node)),
            "Block" => Kind::Block {
                name: text(node, "typeName"),
                instance: node
                    .attribute("instanceName")
                    .filter(|it| !it.is_empty())
                    .map(str::to_owned),
                code: None,
            },
            "DataSource" => Kind::Value(text(node, "identifier"), negated),
            "DataSink" => Kind::Variable(text(node, "identifier"), negated),
            "Jump" => Kind::Jump(label(), negated),
            "Return" => Kind::Return(negated),
            "Connector" | "Continuation" => Kind::Joint,
            "Comment" => Kind::Comment(node.words()),
            "" => Kind::Other(Element::name(&node).to_owned()),
            other => Kind::Other(other.to_owned()),
        };
        let mut drawn = Drawn::new(self.xml.place(node), shape, Vec::new());
        let position = node.child("RelPosition");
        let number = |name| position.and_then(|it| it.attribute(name)?.parse::<f64>().ok());
        let number = |name| {
            number(name)
                .filter(|it| it.is_finite())
                .unwrap_or(0.0)
                .clamp(0.0, 1e6)
        };
        drawn.position = (number("x"), top + number("y"));
        let (mut points, mut outputs) = (Vec::new(), Vec::new());
        if let Kind::Block { .. } = drawn.kind {
            drawn.outputs.clear();
            for (list, in_out) in [
                ("InputVariables", false),
                ("InOutVariables", true),
                ("OutputVariables", false),
            ] {
                for variable in node.child(list).iter().flat_map(Element::elements) {
                    let name = text(variable, "parameterName");
                    if list != "OutputVariables" {
                        points.push(variable.child("ConnectionPointIn"));
                        drawn.inputs.push(Pin {
                            name: name.clone(),
                            modifier: super::body::modifier(variable),
                            from: Vec::new(),
                            in_out,
                        });
                    }
                    if list != "InputVariables" {
                        let number = drawn.outputs.len();
                        outputs.extend(variable.child("ConnectionPointOut").map(|point| (number, point)));
                        drawn.outputs.push(Output {
                            name,
                            negated: variable.flag("negated"),
                        });
                    }
                }
            }
            if drawn.outputs.is_empty() {
                drawn.outputs.push(Output::default());
            }
        } else {
            points.extend(node.children_of("ConnectionPointIn").map(Some));
            let has_pin = matches!(
                drawn.kind,
                Kind::Contact(..) | Kind::Coil(..) | Kind::Variable(..) | Kind::Jump(..) | Kind::Return(_)
            );
            if points.is_empty() && has_pin {
                points.push(None);
            }
            drawn.inputs.extend(points.iter().map(|_| Pin::default()));
            outputs.extend(node.children_of("ConnectionPointOut").map(|point| (0, point)));
        }
        (drawn, points, outputs)
    }
}
