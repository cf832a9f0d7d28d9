//! What the generator of Beremiz and OpenPLC makes of a drawing, read without the reader of this crate: steps in their order.

use roxmltree::Node;
use std::collections::{HashMap, HashSet};

/// What a step reads.
#[derive(Debug, Clone)]
pub(super) enum Term {
    Always,
    Literal(f64),
    /// A variable, an output (`t1.q`), or what a function left.
    Read(String),
    Not(Box<Term>),
    And(Vec<Term>),
    Or(Vec<Term>),
}

/// A statement.
#[derive(Debug, Clone)]
pub(super) enum Step {
    Write(String, Term),
    /// A set or reset coil.
    Latch(Term, String, bool),
    /// What a variable takes where ENO is high.
    WriteIf(String, String, Term),
    /// An edge detector of its own: its name, whether it sees rises.
    Edge(String, bool, Term),
    /// An instance, and what comes to its inputs.
    Call(String, Vec<(String, Term)>),
    /// A function: its name, its inputs, where its result goes, and its EN with the place of ENO.
    Compute(String, Vec<Term>, String, Option<(Term, String)>),
}

/// A unit: its variables (name, type, first value) and steps.
#[derive(Debug, Default)]
pub(super) struct Unit {
    pub(super) variables: Vec<(String, String, f64)>,
    pub(super) inputs: Vec<String>,
    pub(super) steps: Vec<Step>,
}

type Found<T> = Result<T, String>;

#[derive(Default)]
struct Pin {
    name: String,
    modifier: Modifier,
    from: Vec<(String, String)>,
}

#[derive(Default, Clone)]
struct Modifier {
    negated: bool,
    storage: String,
    edge: String,
}

struct Element {
    kind: String,
    at: (i64, i64),
    order: u32,
    told: String,
    type_name: String,
    instance: Option<String>,
    modifier: Modifier,
    inputs: Vec<Pin>,
    outputs: Vec<Pin>,
}

fn kids<'x>(node: Node<'x, 'x>, name: &'static str) -> impl Iterator<Item = Node<'x, 'x>> {
    node.children()
        .filter(move |child| child.tag_name().name() == name)
}

fn told(node: Node<'_, '_>, name: &'static str) -> String {
    let words = node.descendants().find(|inner| inner.tag_name().name() == name);
    words
        .and_then(|words| words.text())
        .unwrap_or_default()
        .trim()
        .to_lowercase()
}

fn modifier(node: Node<'_, '_>) -> Modifier {
    let told = |name: &str| node.attribute(name).unwrap_or_default().to_owned();
    Modifier {
        negated: told("negated") == "true",
        storage: told("storage"),
        edge: told("edge"),
    }
}

fn pin(node: Node<'_, '_>, named: Node<'_, '_>) -> Pin {
    let connections = node
        .descendants()
        .filter(|inner| inner.tag_name().name() == "connection");
    let told = |node: Node<'_, '_>, name: &str| node.attribute(name).unwrap_or_default().to_owned();
    Pin {
        name: told(named, "formalParameter").to_lowercase(),
        modifier: modifier(named),
        from: connections
            .map(|it| (told(it, "refLocalId"), told(it, "formalParameter").to_lowercase()))
            .collect(),
    }
}

fn element(node: Node<'_, '_>) -> Element {
    let number = |name: &str| {
        let position = node
            .children()
            .find(|child| child.tag_name().name() == "position");
        let number = position.and_then(|position| position.attribute(name)?.parse().ok());
        number.map_or(0, |number: f64| number as i64)
    };
    let mut inputs: Vec<Pin> = kids(node, "connectionPointIn")
        .map(|point| pin(point, point))
        .collect();
    let mut outputs = Vec::new();
    for (list, to) in [
        ("inputVariables", 0),
        ("inOutVariables", 0),
        ("outputVariables", 1),
    ] {
        for variable in kids(node, list).flat_map(|list| kids(list, "variable")) {
            let to = if to == 0 { &mut inputs } else { &mut outputs };
            to.push(pin(variable, variable));
        }
    }
    let kind = node.tag_name().name().to_owned();
    let words = if kind.ends_with("ariable") {
        "expression"
    } else {
        "variable"
    };
    Element {
        at: (number("x"), number("y")),
        order: node
            .attribute("executionOrderId")
            .and_then(|it| it.parse().ok())
            .unwrap_or(0),
        told: if kind == "block" {
            String::new()
        } else {
            told(node, words)
        },
        type_name: node.attribute("typeName").unwrap_or_default().to_uppercase(),
        instance: node.attribute("instanceName").map(str::to_lowercase),
        modifier: modifier(node),
        inputs,
        outputs,
        kind,
    }
}

/// The units of a project, by their names in small letters, and the name of its first program. The error is what the generator
/// would not do, or this one does not know.
pub(super) fn units(xml: &str) -> Found<(HashMap<String, Unit>, String)> {
    let options = roxmltree::ParsingOptions::default();
    let document =
        roxmltree::Document::parse_with_options(xml, options).map_err(|error| error.to_string())?;
    let pous = document
        .descendants()
        .filter(|node| node.tag_name().name() == "pou");
    let mut units = HashMap::new();
    let mut main = None;
    let globals: Vec<_> = document
        .descendants()
        .filter(|node| node.tag_name().name() == "globalVars")
        .collect();
    if globals.iter().any(|list| kids(*list, "variable").count() > 0) {
        return Err("globals".to_owned());
    }
    for pou in pous {
        let name = pou.attribute("name").unwrap_or_default().to_lowercase();
        if main.is_none() && pou.attribute("pouType") == Some("program") {
            main = Some(name.clone());
        }
        units.insert(name, unit(pou)?);
    }
    Ok((units, main.ok_or("no program")?))
}

fn unit<'x>(pou: Node<'x, 'x>) -> Found<Unit> {
    let mut unit = Unit::default();
    for list in kids(pou, "interface").flat_map(|interface| interface.children()) {
        for variable in kids(list, "variable") {
            let name = variable.attribute("name").unwrap_or_default().to_lowercase();
            let ty = kids(variable, "type")
                .flat_map(|ty| ty.children())
                .find(Node::is_element);
            let ty = ty.ok_or("a variable without a type")?;
            let ty = match ty.tag_name().name() {
                "derived" => ty.attribute("name").unwrap_or_default(),
                other => other,
            };
            let initial = variable
                .descendants()
                .find(|node| node.tag_name().name() == "simpleValue");
            let initial = match initial.and_then(|initial| initial.attribute("value")) {
                Some(value) => literal(&value.to_lowercase()).ok_or("a first value")?,
                None => 0.0,
            };
            if list.tag_name().name() == "inputVars" {
                unit.inputs.push(name.clone());
            }
            unit.variables.push((name, ty.to_uppercase(), initial));
        }
    }
    let body = kids(pou, "body")
        .flat_map(|body| body.children())
        .find(Node::is_element);
    let body = body
        .filter(|body| matches!(body.tag_name().name(), "LD" | "FBD"))
        .ok_or("no drawing")?;
    let mut elements = HashMap::new();
    let mut ids = Vec::new();
    for node in body.children().filter(Node::is_element) {
        let id = node.attribute("localId").unwrap_or_default().to_owned();
        if elements.insert(id.clone(), element(node)).is_none() {
            ids.push(id);
        }
    }
    let mut generator = Generator {
        elements: &elements,
        done: HashSet::new(),
        edges: 0,
        depth: 0,
        steps: Vec::new(),
    };
    generator.body(&ids)?;
    unit.steps = generator.steps;
    Ok(unit)
}

/// A number, a time in milliseconds, a truth.
pub(super) fn literal(text: &str) -> Option<f64> {
    let text = text
        .split_once('#')
        .filter(|(ty, _)| matches!(*ty, "int" | "dint" | "real" | "bool"))
        .map_or(text, |(_, text)| text);
    match text {
        "true" => return Some(1.0),
        "false" => return Some(0.0),
        _ => {}
    }
    let Some(time) = text.strip_prefix("t#").or_else(|| text.strip_prefix("time#")) else {
        return text.parse().ok();
    };
    let mut whole = 0.0;
    let mut rest = time;
    while !rest.is_empty() {
        let end = rest.find(|c: char| !c.is_ascii_digit() && c != '.')?;
        let number: f64 = rest[..end].parse().ok()?;
        let after = &rest[end..];
        let end = after.find(|c: char| c.is_ascii_digit()).unwrap_or(after.len());
        let unit = match after[..end].trim_matches('_') {
            "d" => 86_400_000.0,
            "h" => 3_600_000.0,
            "m" => 60_000.0,
            "s" => 1000.0,
            "ms" => 1.0,
            _ => return None,
        };
        whole += number * unit;
        rest = &after[end..];
    }
    Some(whole)
}

struct Generator<'e> {
    elements: &'e HashMap<String, Element>,
    /// Blocks that stand among the steps.
    done: HashSet<String>,
    edges: usize,
    depth: usize,
    steps: Vec<Step>,
}

impl<'e> Generator<'e> {
    fn body(&mut self, ids: &[String]) -> Found<()> {
        let roots = |kinds: &[&str]| -> Vec<&String> {
            let is_one = |id: &&String| kinds.contains(&self.elements[*id].kind.as_str());
            ids.iter().filter(is_one).collect()
        };
        let ordered = |id: &&String| self.elements[*id].order > 0;
        let written = roots(&["outVariable", "inOutVariable", "coil"]);
        let written: Vec<&String> = written
            .into_iter()
            .filter(|id| !self.elements[*id].told.trim().is_empty())
            .collect();
        let all: Vec<&String> = written.into_iter().chain(roots(&["block"])).collect();
        let mut first: Vec<&String> = all.iter().copied().filter(ordered).collect();
        first.sort_by_key(|id| self.elements[*id].order);
        let mut others: Vec<&String> = all.into_iter().filter(|id| !ordered(id)).collect();
        // The one of OpenPLC 4 runs all functions by their places, and what takes their results after that.
        let is_function =
            |id: &str| self.elements[id].kind == "block" && self.elements[id].instance.is_none();
        let mut waiting: Vec<&str> = first
            .iter()
            .chain(&others)
            .map(|id| id.as_str())
            .filter(|id| !is_function(id))
            .collect();
        let mut asked = HashSet::new();
        while let Some(id) = waiting.pop() {
            if asked.insert(id) {
                let pins = self.elements.get(id).into_iter().flat_map(|it| &it.inputs);
                waiting.extend(pins.flat_map(|pin| &pin.from).map(|(id, _)| id.as_str()));
            }
        }
        others.retain(|id| !(is_function(id) && asked.contains(id.as_str())));
        others.sort_by(|one, other| {
            let (one, other) = (self.elements[*one].at, self.elements[*other].at);
            if (one.1 - other.1).abs() < 10 {
                one.0.cmp(&other.0)
            } else {
                one.1.cmp(&other.1)
            }
        });
        for id in first.into_iter().chain(others) {
            let element = &self.elements[id];
            match element.kind.as_str() {
                "block" => drop(self.block(id, "", false)?),
                "coil" => self.coil(element)?,
                _ => self.variable(element)?,
            }
        }
        Ok(())
    }

    fn coil(&mut self, coil: &'e Element) -> Found<()> {
        let Some(power) = self.pin(&coil.inputs, 0, false)? else {
            return Ok(());
        };
        let to = coil.told.clone();
        if coil.modifier.negated {
            self.steps.push(Step::Write(to, Term::Not(Box::new(power))));
        } else if matches!(coil.modifier.storage.as_str(), "set" | "reset") {
            self.steps
                .push(Step::Latch(power, to, coil.modifier.storage == "set"));
        } else {
            let power = self.modified(&coil.modifier, power);
            self.steps.push(Step::Write(to, power));
        }
        Ok(())
    }

    fn variable(&mut self, variable: &'e Element) -> Found<()> {
        let Some(value) = self.pin(&variable.inputs, 0, false)? else {
            return Ok(());
        };
        let from = &variable.inputs[0].from;
        let source = self
            .elements
            .get(&from[0].0)
            .filter(|it| from.len() == 1 && it.kind == "block");
        let eno = source.filter(|it| {
            it.inputs
                .iter()
                .any(|pin| pin.name == "en" && !pin.from.is_empty())
        });
        let to = variable.told.clone();
        self.steps.push(match eno {
            Some(source) => {
                let eno = match &source.instance {
                    Some(instance) => format!("{instance}.eno"),
                    None => format!("_{}_eno", from[0].0),
                };
                Step::WriteIf(eno, to, value)
            }
            None => Step::Write(to, value),
        });
        Ok(())
    }

    fn modified(&mut self, modifier: &Modifier, term: Term) -> Term {
        if modifier.negated {
            return Term::Not(Box::new(term));
        }
        if !matches!(modifier.edge.as_str(), "rising" | "falling") {
            return term;
        }
        self.edges += 1;
        let name = format!("_edge{}", self.edges);
        self.steps
            .push(Step::Edge(name.clone(), modifier.edge == "rising", term));
        Term::Read(name)
    }

    fn pin(&mut self, pins: &'e [Pin], number: usize, order: bool) -> Found<Option<Term>> {
        let from = pins.get(number).map_or(&[][..], |pin| &pin.from);
        let paths = self.paths(from, order)?;
        Ok(match paths.len() {
            0 => None,
            _ => Some(any(paths)),
        })
    }

    /// What comes by each wire. None is the rail.
    fn paths(&mut self, from: &'e [(String, String)], order: bool) -> Found<Vec<Option<Term>>> {
        self.depth += 1;
        if self.depth > 200 {
            return Err(super::ENDLESS.to_owned());
        }
        let mut paths = Vec::new();
        for (id, output) in from {
            let Some(source) = self.elements.get(id) else {
                continue;
            };
            match source.kind.as_str() {
                "leftPowerRail" => paths.push(None),
                "inVariable" | "inOutVariable" => {
                    let term = match literal(&source.told) {
                        Some(value) => Term::Literal(value),
                        None if source
                            .told
                            .chars()
                            .all(|c| c.is_alphanumeric() || "._".contains(c)) =>
                        {
                            Term::Read(source.told.clone())
                        }
                        None => return Err(format!("a formula {}", source.told)),
                    };
                    paths.push(Some(term));
                }
                "block" => paths.push(Some(self.block(id, output, order)?.ok_or("no such output")?)),
                "contact" => {
                    let contact = self.modified(&source.modifier, Term::Read(source.told.clone()));
                    let before = self.paths(source.inputs.first().map_or(&[][..], |pin| &pin.from), order)?;
                    if before.is_empty() {
                        return Err("a contact that nothing is wired to".to_owned());
                    }
                    paths.push(Some(match any(before) {
                        Term::Always => contact,
                        before => Term::And(vec![contact, before]),
                    }));
                }
                "coil" => {
                    paths.extend(self.paths(source.inputs.first().map_or(&[][..], |pin| &pin.from), order)?);
                }
                other => return Err(format!("power from {other}")),
            }
        }
        self.depth -= 1;
        Ok(paths)
    }

    fn block(&mut self, id: &str, output: &str, order: bool) -> Found<Option<Term>> {
        let block = &self.elements[id];
        let own_order = block.order > 0;
        if !order && self.done.insert(id.to_owned()) {
            let mut given = Vec::new();
            for (number, pin) in block.inputs.iter().enumerate() {
                if let Some(term) = self.pin(&block.inputs, number, own_order)? {
                    let term = self.modified(&pin.modifier, term);
                    given.push((pin.name.clone(), term));
                }
            }
            match &block.instance {
                Some(instance) => self.steps.push(Step::Call(instance.clone(), given)),
                None => {
                    let enable = given.iter().position(|(name, _)| name == "en");
                    let enable = enable.map(|at| (given.remove(at).1, format!("_{id}_eno")));
                    let terms = given.into_iter().map(|(_, term)| term).collect();
                    let result = format!("_{id}_out");
                    self.steps
                        .push(Step::Compute(block.type_name.clone(), terms, result, enable));
                }
            }
        }
        let named = block.outputs.iter().find(|pin| pin.name == output);
        let Some(pin) = named.or_else(|| block.outputs.first().filter(|_| output.is_empty())) else {
            return Ok(None);
        };
        let term = match &block.instance {
            Some(instance) => Term::Read(format!("{instance}.{}", pin.name)),
            None if pin.name == "eno" => Term::Read(format!("_{id}_eno")),
            None => Term::Read(format!("_{id}_out")),
        };
        Ok(Some(self.modified(&pin.modifier, term)))
    }
}

fn any(paths: Vec<Option<Term>>) -> Term {
    if paths.iter().any(Option::is_none) {
        return Term::Always;
    }
    let mut paths: Vec<Term> = paths.into_iter().flatten().collect();
    match paths.len() {
        1 => paths.remove(0),
        _ => Term::Or(paths),
    }
}
