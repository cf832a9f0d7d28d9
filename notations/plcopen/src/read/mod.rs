//! From XML to the model: TC6 2.0 and 2.01, what CODESYS puts into `addData`, and the form of IEC 61131-10.

mod body;
mod chart;
mod interface;
mod ten;

use super::model::{Body, Evaluation, Part, Project, Role, Task, Unit, UnitKind, WORKSHEET};
use super::own;
use ladder_notation::ReadError;
use ladder_notation::xml::{Element, Xml};
use roxmltree::Node;

/// How a namespace of PLCopen begins, and the one of IEC 61131-10.
const NAMESPACES: [&str; 2] = [
    "http://www.plcopen.org/xml/tc6",
    "www.iec.ch/public/TC65SC65BWG7TF10",
];

/// How many bytes are checked for the element of a project.
const HEAD: usize = 4_096;

/// Whether a file is a project, from what it begins with.
pub(super) fn recognises(bytes: &[u8]) -> bool {
    let head = &bytes[..bytes.len().min(HEAD)];
    let head = String::from_utf8_lossy(head);
    let head = head.trim_start_matches('\u{feff}').trim_start();
    let Some(start) = head.starts_with('<').then(|| {
        let names = ["<project", "<Project", ":project", ":Project"];
        names.iter().find_map(|name| head.find(name))
    }) else {
        return false;
    };
    start.is_some_and(|start| {
        let tag = &head[start..];
        let tag = &tag[..tag.find('>').unwrap_or(tag.len())];
        NAMESPACES.iter().any(|namespace| tag.contains(namespace)) || tag.contains("plcopen.org")
    })
}

/// Reads a project.
///
/// # Errors
///
/// If it is not XML, or no project.
pub(super) fn project(text: &str) -> Result<Project, ReadError> {
    let xml = Xml::parse(text)?;
    let root = xml.document.root_element();
    let place = xml.place(root);
    if !root.is("project") {
        let message = format!(
            "a PLCopen project begins with `<project>`, not with `<{}>`",
            Element::name(&root)
        );
        return Err(ReadError::at(place, message));
    }
    let mut reader = Reader {
        xml: &xml,
        project: Project::default(),
    };
    reader.project(root);
    let Project {
        types,
        globals,
        units,
        ..
    } = &reader.project;
    if types.is_empty() && globals.is_empty() && units.is_empty() {
        return Err(ReadError::at(
            place,
            "nothing is in the project: no program, no type, no variable",
        ));
    }
    Ok(reader.project)
}

struct Reader<'x, 't> {
    xml: &'x Xml<'t>,
    project: Project,
}

impl<'x> Reader<'x, '_> {
    fn project(&mut self, root: Node<'x, '_>) {
        let head = root.child("fileHeader");
        let attribute = |node: Option<Node<'_, '_>>, name: &str| {
            let value = node.and_then(|node| node.attribute(name).map(str::to_owned));
            value.filter(|value| !value.trim().is_empty())
        };
        let product = attribute(head, "productName");
        if product
            .as_deref()
            .is_some_and(|product| product.contains("CODESYS"))
        {
            self.project.evaluation = Evaluation::Once;
        }
        let company = head.and_then(|head| head.attribute("companyName"));
        self.project.is_own = company == Some(own::COMPANY) && product.as_deref() == Some("Unnamed");
        let is_telling = |name: &String| !name.trim().is_empty() && !name.eq_ignore_ascii_case("unnamed");
        let name = attribute(root.child("contentHeader"), "name").filter(is_telling);
        let product = product.filter(|product| is_telling(product) && Some(product) != name.as_ref());
        let from = product.map(|product| format!("from {product}"));
        let told: Vec<String> = name.into_iter().chain(from).collect();
        if !told.is_empty() {
            self.project.comments.push(told.join(", "));
        }
        if let Some(comment) = root.child("contentHeader").and_then(|head| head.child("Comment")) {
            self.project.comments.push(comment.words());
        }
        if root.tag_name().name() == "Project" {
            return self.ten(root);
        }
        let types = root.child("types");
        for node in types
            .iter()
            .filter_map(|types| types.child("dataTypes"))
            .flat_map(|list| list.elements())
        {
            self.data_type(node);
        }
        for node in types
            .iter()
            .filter_map(|types| types.child("pous"))
            .flat_map(|list| list.elements())
        {
            self.unit(node);
        }
        for instances in root.children_of("instances") {
            for node in instances.descendants().filter(Node::is_element) {
                if node.is("task") {
                    self.task(node);
                } else if node.is("globalVars") {
                    self.variables(node, Role::Global);
                } else if node.is("resource") {
                    self.programs_without_task(node);
                }
            }
        }
        // CODESYS keeps lists of globals, and units of libraries, in its own data.
        for data in root
            .descendants()
            .filter(|node| node.is_element() && node.is("addData"))
        {
            for node in data.descendants().filter(Node::is_element) {
                if node.is("globalVars") && !inside(node, "instances") {
                    self.variables(node, Role::Global);
                } else if node.is("pou") {
                    self.unit(node);
                }
            }
        }
    }

    /// A program, function or function block.
    fn unit(&mut self, node: Node<'x, '_>) {
        let place = self.xml.place(node);
        let name = node.attribute("name").unwrap_or_default().to_owned();
        let kind = match node.attribute("pouType") {
            Some("function") => UnitKind::Function,
            Some("functionBlock") => UnitKind::FunctionBlock,
            _ => UnitKind::Program,
        };
        let interface = node.child("interface");
        let returns = interface.and_then(|interface| interface.child("returnType"));
        let returns = returns.and_then(|node| node.elements().next());
        let returns = returns.map(|node| self.ty(node, 0));
        let mut variables = Vec::new();
        for list in interface.iter().flat_map(ladder_notation::xml::Element::elements) {
            if let Some(role) = role(list) {
                variables.extend(self.variable_list(list, role, 0));
            }
        }
        let told = node
            .child("documentation")
            .or_else(|| interface?.child("documentation"));
        let mut parts = Vec::new();
        for (list, what) in [("actions", "action"), ("transitions", "transition")] {
            for part in node.child(list).iter().flat_map(|list| list.children_of(what)) {
                parts.push(Part {
                    place: self.xml.place(part),
                    what,
                    name: part.attribute("name").unwrap_or_default().to_owned(),
                    body: self.first_body(part),
                });
            }
        }
        let bodies: Vec<Node<'_, '_>> = node.children_of("body").collect();
        let mut body = self.first_body(node);
        let mut sheets = Vec::new();
        for more in bodies.iter().skip(1) {
            let place = self.xml.place(*more);
            let name = more.attribute("WorksheetName").unwrap_or_default().to_owned();
            let more = self.body(*more);
            body = match (body, more) {
                (Body::Empty, more) => more,
                (Body::Graph(mut graph), Body::Graph(more)) if sheets.is_empty() => {
                    graph.append(more);
                    Body::Graph(graph)
                }
                (body, more) => {
                    sheets.push(Part {
                        place,
                        what: WORKSHEET,
                        name,
                        body: more,
                    });
                    body
                }
            };
        }
        parts.splice(0..0, sheets);
        self.project.units.push(Unit {
            place,
            name,
            kind,
            returns,
            variables,
            comment: told.map(|node| node.words()).filter(|told| !told.is_empty()),
            body,
            parts,
        });
    }

    fn first_body(&mut self, node: Node<'x, '_>) -> Body {
        match node.child("body") {
            Some(body) => self.body(body),
            None => Body::Empty,
        }
    }

    fn task(&mut self, node: Node<'x, '_>) {
        let place = self.xml.place(node);
        let programs = node
            .children_of("pouInstance")
            .map(|node| self.instance(node))
            .collect();
        self.project.tasks.push(Task {
            place,
            name: node.attribute("name").unwrap_or_default().to_owned(),
            interval: named(node, "interval"),
            priority: node
                .attribute("priority")
                .and_then(|number| number.parse().ok())
                .unwrap_or(0),
            event: named(node, "single"),
            programs,
        });
    }

    /// Programs of a resource that no task runs go on whenever there is time: as one more task, the last.
    fn programs_without_task(&mut self, node: Node<'x, '_>) {
        let programs: Vec<_> = node
            .children_of("pouInstance")
            .map(|node| self.instance(node))
            .collect();
        if !programs.is_empty() {
            self.project.tasks.push(Task {
                place: self.xml.place(node),
                name: String::new(),
                interval: None,
                event: None,
                priority: i64::MAX,
                programs,
            });
        }
    }

    /// The name of the program that an instance is of. In CODESYS the instance has its name, and the type is empty.
    fn instance(&self, node: Node<'x, '_>) -> (ladder_notation::LineColumn, String) {
        let named = |name| node.attribute(name).filter(|name| !name.is_empty());
        let name = named("typeName").or_else(|| named("name")).unwrap_or_default();
        (self.xml.place(node), name.to_owned())
    }

    fn variables(&mut self, node: Node<'x, '_>, role: Role) {
        let more = self.variable_list(node, role, 0);
        self.project.globals.extend(more);
    }
}

/// An attribute that says something.
pub(super) fn named(node: Node<'_, '_>, attribute: &str) -> Option<String> {
    let value = node.attribute(attribute).map(str::trim);
    value.filter(|value| !value.is_empty()).map(str::to_owned)
}

fn role(list: Node<'_, '_>) -> Option<Role> {
    let roles = [
        ("localVars", Role::Local),
        ("tempVars", Role::Temp),
        ("inputVars", Role::Input),
        ("outputVars", Role::Output),
        ("inOutVars", Role::InOut),
        ("externalVars", Role::External),
        ("globalVars", Role::Local),
        ("accessVars", Role::Local),
    ];
    roles
        .iter()
        .find(|(name, _)| list.is(name))
        .map(|(_, role)| *role)
}

fn inside(node: Node<'_, '_>, name: &str) -> bool {
    node.ancestors()
        .any(|around| around.is_element() && around.is(name))
}
