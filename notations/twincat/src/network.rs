//! Networks: trees of boxes as elements and wires.

use crate::archive::Object;
use crate::flag;
use ladder_notation::xml::Xml;
use ladder_notation::{LineColumn, Report};
use ladder_notation_plcopen::graph::{Code, Edge, End, Graph, Kind, Modifier, Node, Output, Pin, Storage};
use std::collections::{HashMap, HashSet};

/// Trees are no deeper.
const DEEPEST: usize = 100;

/// More branches that end in a wire do so at a point of their own.
const WIDEST: usize = 16;

/// From the top of one network to the next.
const HEIGHT: f64 = 100.0;

/// All networks of a body.
pub(crate) fn graph(xml: &Xml<'_>, archive: Object<'_>, report: &mut Report) -> Graph {
    let mut reader = Reader {
        xml,
        report,
        graph: Graph::default(),
        top: 0.0,
        rail: End { node: 0, output: 0 },
        wires: HashMap::new(),
    };
    let told = archive.text("NetworkListComment");
    if !told.is_empty() {
        reader.comment(archive, told.to_owned());
    }
    let networks = archive.field("NetworkList");
    if networks.is_none() {
        let place = reader.place(archive);
        reader
            .report
            .refused(place, "body", "there is no list of networks in it");
    }
    for network in networks.iter().flat_map(|list| list.elements()) {
        reader.top += HEIGHT;
        reader.network(network);
    }
    let Reader {
        mut graph, report, ..
    } = reader;
    graph.open(report);
    graph
}

struct Reader<'r, 'x> {
    xml: &'r Xml<'x>,
    report: &'r mut Report,
    graph: Graph,
    /// Where the network is.
    top: f64,
    /// Its left rail.
    rail: End,
    /// Its wires that have a name.
    wires: HashMap<String, Vec<End>>,
}

impl Reader<'_, '_> {
    fn place(&self, object: Object<'_>) -> LineColumn {
        self.xml.place(object.node)
    }

    /// An element; comes back its first output.
    fn push(&mut self, object: Object<'_>, kind: Kind, inputs: Vec<Pin>) -> End {
        let node = self.graph.nodes.len();
        let mut drawn = Node::new(self.place(object), kind, inputs);
        drawn.position = (0.0, self.top);
        self.graph.nodes.push(drawn);
        End { node, output: 0 }
    }

    fn comment(&mut self, object: Object<'_>, told: String) {
        self.push(object, Kind::Comment(told), Vec::new());
    }

    fn network(&mut self, network: Object<'_>) {
        let place = self.place(network);
        self.graph.networks.push(place);
        for told in [network.text("Title"), network.text("Comment")] {
            if !told.is_empty() {
                self.comment(network, told.to_owned());
            }
        }
        let label = network.text("Label");
        if !label.is_empty() {
            self.push(network, Kind::Label(label.to_owned()), Vec::new());
        }
        let before = self.graph.nodes.len();
        let items: Vec<Object<'_>> = match network.field("NetworkItems") {
            Some(items) => items.elements().filter(|item| !item.is_nothing()).collect(),
            None => Vec::new(),
        };
        let shown = items
            .iter()
            .map(|item| shown(*item, 0))
            .collect::<Vec<_>>()
            .join("; ");
        if network.is("OutCommented") {
            let why = "it is commented out there: a comment here";
            self.report.approximated(place, format!("network {shown}"), why);
            self.comment(network, format!("Commented out: {shown}"));
            return;
        }
        if network.is("ILActive") {
            self.refuse(network, before, "it is written in IL, which is not read");
            return;
        }
        self.rail = self.push(network, Kind::LeftRail, Vec::new());
        self.wires.clear();
        self.report.translated(place, "network");
        for item in items {
            if let Err(why) = self.item(item) {
                self.refuse(network, before, &format!("{why}: {shown}"));
                return;
            }
        }
    }

    /// A network stays as a comment: part of it would be another network.
    fn refuse(&mut self, network: Object<'_>, before: usize, why: &str) {
        self.graph.nodes.truncate(before);
        let place = self.place(network);
        self.report.refused(place, "network", why);
        self.comment(network, format!("A network is not read: {why}"));
    }

    /// What is in a network by itself.
    fn item(&mut self, item: Object<'_>) -> Result<(), String> {
        if item.kind() != "BoxTreeAssign" {
            return self.value(item, 0).map(drop);
        }
        if item.flags() != 0 {
            return Err(format!(
                "an assignment has the flags {}, which are not known",
                item.flags()
            ));
        }
        let power = match item.field("RValue") {
            Some(value) => self.value(value, 0)?,
            None => Vec::new(),
        };
        let targets = item
            .field("OutputItems")
            .and_then(|list| list.field("OutputItems"));
        for target in targets
            .iter()
            .flat_map(|list| list.elements())
            .filter(|target| !target.is_nothing())
        {
            self.target(target, power.clone())?;
        }
        Ok(())
    }

    /// What is written, or a jump.
    fn target(&mut self, target: Object<'_>, power: Vec<End>) -> Result<(), String> {
        let text = target.text("Operand").to_owned();
        let none = Modifier::default();
        let kind = match target.flags() {
            0 if target.is("Boolean") || target.text("Type").eq_ignore_ascii_case("BOOL") => {
                Kind::Coil(text, none, Storage::None)
            }
            0 => Kind::Variable(text, false),
            flag::NEGATED => Kind::Coil(
                text,
                Modifier {
                    negated: true,
                    ..none
                },
                Storage::None,
            ),
            flag::SET => Kind::Coil(text, none, Storage::Set),
            flag::RESET => Kind::Coil(text, none, Storage::Reset),
            flag::JUMP => Kind::Jump(text, false),
            flag::RETURN => Kind::Return(false),
            other => return Err(format!("`{text}` has the flags {other}, which are not known")),
        };
        self.push(target, kind, vec![pin("", power)]);
        Ok(())
    }

    /// The power or value that an object of a tree has.
    fn value(&mut self, object: Object<'_>, depth: usize) -> Result<Vec<End>, String> {
        if depth > DEEPEST {
            return Err(format!("more than {DEEPEST} boxes are one in the other"));
        }
        match object.kind() {
            "BoxTreeOperand" => match object.field("Operand") {
                Some(operand) => self.operand(operand),
                None => Ok(Vec::new()),
            },
            "Operand" => self.operand(object),
            "BoxTreeBox" => match self.gate(object, depth)? {
                Some(power) => Ok(power),
                None => self.tree_box(object, depth),
            },
            "BoxTreeTerminator" => match object.field("Input") {
                Some(input) => self.value(input, depth + 1),
                None => Ok(vec![self.rail]),
            },
            "BoxTreeDemux" => {
                let id = object.text("VarId").to_owned();
                let Some(input) = object.field("Input") else {
                    let known = self.wires.get(&id).cloned();
                    return known.ok_or_else(|| format!("the wire {id} begins nowhere"));
                };
                let mut power = self.value(input, depth + 1)?;
                if power.len() > WIDEST {
                    power = vec![self.push(object, Kind::Joint, vec![pin("", power)])];
                }
                self.wires.insert(id, power.clone());
                Ok(power)
            }
            "BoxTreeParallel" => self.parallel(object, depth),
            "BoxTreeAssign" => Err("an assignment stands within another".to_owned()),
            other => Err(format!("a `{other}` is not known")),
        }
    }

    fn operand(&mut self, operand: Object<'_>) -> Result<Vec<End>, String> {
        let text = operand.text("Operand").to_owned();
        let modifier = modifier(operand)?;
        if modifier.edge == Edge::None && !operand.is("Boolean") {
            let value = Kind::Value(text, modifier.negated);
            return Ok(vec![self.push(operand, value, Vec::new())]);
        }
        let rail = vec![self.rail];
        Ok(vec![self.push(
            operand,
            Kind::Contact(text, modifier),
            vec![pin("", rail)],
        )])
    }

    /// Branches next to each other, after what is before them all.
    fn parallel(&mut self, object: Object<'_>, depth: usize) -> Result<Vec<End>, String> {
        let before = match object.field("Input") {
            Some(input) => Some(self.value(input, depth + 1)?),
            None => None,
        };
        let trees = object.field("Trees");
        let mut powers = Vec::new();
        let first = self.graph.nodes.len();
        for tree in trees
            .iter()
            .flat_map(|trees| trees.elements())
            .filter(|tree| !tree.is_nothing())
        {
            powers.extend(self.value(tree, depth + 1)?);
        }
        let Some(before) = before.filter(|before| *before != [self.rail]) else {
            return Ok(powers);
        };
        // Without the power before them they would run, too.
        let acts = |node: &Node| matches!(&node.kind, Kind::Block { name, .. } if !is_condition(name));
        if self.graph.nodes[first..].iter().any(acts) {
            return Err("a box that acts stands in a branch, whose power is not known".to_owned());
        }
        let kind = Kind::Block {
            name: "AND".to_owned(),
            instance: None,
            code: None,
        };
        Ok(vec![self.push(
            object,
            kind,
            vec![pin("IN1", before), pin("IN2", powers)],
        )])
    }

    /// Contacts in series, or branches, as ladder diagrams have them: `AND` of contacts after power, `OR` of powers. None: it is a box.
    fn gate(&mut self, object: Object<'_>, depth: usize) -> Result<Option<Vec<End>>, String> {
        let name = object.text("BoxType").to_ascii_uppercase();
        let is_plain = object.flags() == 0
            && object.names("InputParam").is_empty()
            && object
                .field("InputFlags")
                .is_none_or(|flags| flags.elements().next().is_none());
        let items = object.field("InputItems");
        let items: Vec<Object<'_>> = items.iter().flat_map(|items| items.elements()).collect();
        let taken = object
            .field("OutputItems")
            .and_then(|list| list.field("OutputItems"));
        let is_taken = taken
            .iter()
            .flat_map(|list| list.elements())
            .any(|taken| !taken.is_nothing());
        if !is_plain || is_taken || items.is_empty() || !items.iter().all(|item| is_power(*item, 0)) {
            return Ok(None);
        }
        if name == "OR" {
            let mut all = Vec::new();
            for item in items {
                all.extend(self.value(item, depth + 1)?);
            }
            let mut met = HashSet::new();
            all.retain(|end| met.insert(*end));
            return Ok(Some(all));
        }
        let follow = items.iter().skip(1).map(|item| contact(*item));
        let Some(follow) = follow.collect::<Option<Vec<_>>>().filter(|_| name == "AND") else {
            return Ok(None);
        };
        let mut power = self.value(items[0], depth + 1)?;
        for operand in follow {
            let kind = Kind::Contact(operand.text("Operand").to_owned(), modifier(operand)?);
            power = vec![self.push(operand, kind, vec![pin("", power)])];
        }
        Ok(Some(power))
    }

    fn tree_box(&mut self, object: Object<'_>, depth: usize) -> Result<Vec<End>, String> {
        let name = object.text("BoxType").to_owned();
        if object
            .field("InputFlags")
            .is_some_and(|flags| flags.elements().next().is_some())
        {
            return Err(format!("{name} has flags at its inputs, which may invert them"));
        }
        let given = object.names("InputParam");
        let mut inputs = Vec::new();
        let items = object.field("InputItems");
        for (number, item) in items.iter().flat_map(|items| items.elements()).enumerate() {
            let from = if item.is_nothing() || item.field("Operand").is_some_and(is_blank) {
                Vec::new()
            } else {
                self.value(item, depth + 1)?
            };
            let has_enable = given.first().is_some_and(|name| name.eq_ignore_ascii_case("EN"));
            let own = given.get(number).filter(|name| !name.is_empty());
            let name = own.map_or_else(
                || format!("IN{}", number + usize::from(!has_enable)),
                |name| (*name).to_owned(),
            );
            inputs.push(pin(&name, from));
        }
        let code = object.is("ProvidesSTSnippet") || object.field("STSnippet").is_some();
        let instance = object
            .field("Instance")
            .map_or("", |instance| instance.text("Operand"));
        let kind = Kind::Block {
            code: code.then(|| Code {
                text: snippet(object),
                place: None,
            }),
            instance: Some(instance.to_owned()).filter(|instance| !instance.is_empty()),
            name: name.clone(),
        };
        let end = self.push(object, kind, inputs);
        let targets = object
            .field("OutputItems")
            .and_then(|list| list.field("OutputItems"));
        let targets: Vec<Object<'_>> = targets.iter().flat_map(|list| list.elements()).collect();
        let names = object.names("OutputParam");
        let count = names.len().max(targets.len()).max(1);
        let is_negated = match object.flags() {
            0 => false,
            flag::NEGATED => true,
            other => return Err(format!("{name} has the flags {other}, which are not known")),
        };
        self.graph.nodes[end.node].outputs = (0..count)
            .map(|number| Output {
                name: match names.get(number) {
                    Some(name) if !name.is_empty() => (*name).to_owned(),
                    _ if number == 0 => first_output(&name).to_owned(),
                    _ => String::new(),
                },
                negated: is_negated && number == 0,
            })
            .collect();
        for (output, target) in targets
            .into_iter()
            .enumerate()
            .filter(|(_, target)| !target.is_nothing() && !is_blank(*target))
        {
            self.target(target, vec![End { output, ..end }])?;
        }
        Ok(vec![end])
    }
}

/// Whether an operand at a pin is drawn and not filled in.
fn is_blank(operand: Object<'_>) -> bool {
    operand.text("Operand").trim().is_empty() && !matches!(operand.flags(), flag::JUMP | flag::RETURN)
}

fn pin(name: &str, from: Vec<End>) -> Pin {
    Pin {
        name: name.to_owned(),
        from,
        ..Pin::default()
    }
}

/// The operand that a tree is, if it is drawn as a contact.
fn contact(tree: Object<'_>) -> Option<Object<'_>> {
    let operand = match tree.kind() {
        "BoxTreeOperand" => tree.field("Operand")?,
        _ => return None,
    };
    operand.is("Boolean").then_some(operand)
}

/// Whether a tree is power, and no number: it ends in contacts, or in boxes that decide.
fn is_power(tree: Object<'_>, depth: usize) -> bool {
    let is_of_power = || {
        let items = tree.field("InputItems");
        let mut items = items.iter().flat_map(|items| items.elements());
        depth < DEEPEST && items.all(|item| is_power(item, depth + 1))
    };
    match tree.kind() {
        "BoxTreeTerminator" | "BoxTreeDemux" => true,
        "BoxTreeBox" => match &*tree.text("BoxType").to_ascii_uppercase() {
            "AND" | "OR" | "XOR" | "NOT" => is_of_power(),
            "EQ" | "NE" | "GT" | "GE" | "LT" | "LE" => true,
            _ => {
                tree.is("ENO")
                    || tree
                        .field("CallType")
                        .is_some_and(|kind| kind.value() == "FunctionBlock")
            }
        },
        _ => contact(tree).is_some(),
    }
}

/// What is done to the power at a contact.
fn modifier(operand: Object<'_>) -> Result<Modifier, String> {
    let (negated, edge) = match operand.flags() {
        0 => (false, Edge::None),
        flag::NEGATED => (true, Edge::None),
        flag::RISING => (false, Edge::Rising),
        flag::FALLING => (false, Edge::Falling),
        other => {
            let text = operand.text("Operand");
            return Err(format!("`{text}` has the flags {other}, which are not known"));
        }
    };
    Ok(Modifier { negated, edge })
}

/// Whether a box only decides.
fn is_condition(name: &str) -> bool {
    ["AND", "OR", "XOR", "NOT", "EQ", "NE", "GT", "GE", "LT", "LE"]
        .iter()
        .any(|known| known.eq_ignore_ascii_case(name))
}

/// What the first output is called where the file has no name for it.
fn first_output(name: &str) -> &'static str {
    match name.to_ascii_uppercase().as_str() {
        "SR" | "RS" => "Q1",
        "CTUD" => "QU",
        "TON" | "TOF" | "TP" | "CTU" | "CTD" | "R_TRIG" | "F_TRIG" => "Q",
        _ => "",
    }
}

/// The text in a box that is written in ST.
fn snippet(object: Object<'_>) -> String {
    let Some(snippet) = object.field("STSnippet") else {
        return String::new();
    };
    let all = snippet
        .node
        .descendants()
        .filter(|node| node.attribute("n") == Some("Text"));
    let lines: Vec<&str> = all.map(|node| Object::of(node).value()).collect();
    lines.join("\n")
}

/// A tree in words: `xoutput := OR(xtest, xtest2)`.
fn shown(object: Object<'_>, depth: usize) -> String {
    if depth > 8 || object.is_nothing() {
        return "..".to_owned();
    }
    let field = |name| {
        object
            .field(name)
            .map_or_else(|| "..".to_owned(), |inside| shown(inside, depth + 1))
    };
    let list = |name: &str| {
        let items = object.field(name);
        let items = items.iter().flat_map(|items| items.elements());
        items
            .take(20)
            .map(|item| shown(item, depth + 1))
            .collect::<Vec<_>>()
            .join(", ")
    };
    match object.kind() {
        "BoxTreeAssign" => {
            let targets = object
                .field("OutputItems")
                .and_then(|list| list.field("OutputItems"));
            let targets = targets.iter().flat_map(|list| list.elements());
            let targets: Vec<&str> = targets.take(20).map(|target| target.text("Operand")).collect();
            format!("{} := {}", targets.join(", "), field("RValue"))
        }
        "BoxTreeBox" => format!("{}({})", object.text("BoxType"), list("InputItems")),
        "BoxTreeOperand" => field("Operand"),
        "BoxTreeParallel" => format!("branches({})", list("Trees")),
        "Operand" => object.text("Operand").to_owned(),
        "BoxTreeTerminator" | "BoxTreeDemux" => "wire".to_owned(),
        other => other.to_owned(),
    }
}
