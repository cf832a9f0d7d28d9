//! L5X: the XML that Logix Designer exports, of a whole controller or of a part of one.

use crate::model::{Aoi, DataType, Member, Program, Project, Raw, Routine, Rung, Tag, Usage};
use ladder_notation::ReadError;
use ladder_notation::xml::Xml;
use roxmltree::Node;
use std::collections::HashSet;

/// Values nest no deeper.
const DEEPEST: usize = 40;

/// The element that every file begins with.
pub(crate) const ROOT: &str = "RSLogix5000Content";

/// Reads a file.
///
/// # Errors
///
/// If it is no well-formed XML, or no export of Logix Designer. Entities of the file's own are not read.
pub(crate) fn read(text: &str) -> Result<Project, ReadError> {
    let xml = Xml::parse(text)?;
    let root = xml.document.root_element();
    if root.tag_name().name() != ROOT {
        return Err(ReadError::whole(format!(
            "it is XML, but no export of Logix Designer: those begin with <{ROOT}>"
        )));
    }
    let mut reader = Reader {
        text,
        project: Project::default(),
        read: HashSet::new(),
    };
    let Some(controller) = child(root, "Controller") else {
        return Err(ReadError::whole(
            "the file has no <Controller>: there is nothing to read",
        ));
    };
    reader.controller(controller);
    reader.rungs_elsewhere(root);
    Ok(reader.project)
}

struct Reader<'t> {
    text: &'t str,
    project: Project,
    /// Where the rungs are that were read.
    read: HashSet<usize>,
}

fn at(node: Node<'_, '_>) -> usize {
    node.range().start
}

fn child<'a, 'd>(node: Node<'a, 'd>, name: &str) -> Option<Node<'a, 'd>> {
    node.children().find(|child| child.has_tag_name(name))
}

fn attribute(node: Node<'_, '_>, name: &str) -> String {
    node.attribute(name).unwrap_or_default().to_owned()
}

/// The elements of a collection, wherever in its parent it is.
fn all<'a, 'd>(
    node: Node<'a, 'd>,
    collection: &'static str,
    name: &'static str,
) -> impl Iterator<Item = Node<'a, 'd>> {
    let collections = node
        .children()
        .filter(move |child| child.has_tag_name(collection));
    collections.flat_map(move |found| found.children().filter(move |child| child.has_tag_name(name)))
}

/// The text of an element, trimmed: that of its sections, or of the first of its translations.
fn text_of(node: Node<'_, '_>) -> Option<String> {
    let own: String = node
        .children()
        .filter(Node::is_text)
        .filter_map(|text| text.text())
        .collect();
    let own = own.trim();
    if !own.is_empty() {
        return Some(own.to_owned());
    }
    node.children().filter(Node::is_element).find_map(|inner| {
        let text = inner.text()?.trim();
        (!text.is_empty()).then(|| text.to_owned())
    })
}

fn described(node: Node<'_, '_>) -> Option<String> {
    text_of(child(node, "Description")?)
}

fn dimensions(node: Node<'_, '_>, name: &str) -> Vec<u32> {
    let text = node.attribute(name).unwrap_or_default();
    let numbers = text.split([' ', ',']).filter(|part| !part.is_empty());
    numbers
        .filter_map(|part| part.parse().ok())
        .filter(|size| *size > 0)
        .collect()
}

impl Reader<'_> {
    fn refuse(&mut self, node: Node<'_, '_>, what: String, why: &str) {
        let at = at(node);
        self.project.refused.push((at, what, why.to_owned()));
    }

    fn controller(&mut self, controller: Node<'_, '_>) {
        self.project.name = attribute(controller, "Name");
        for node in all(controller, "DataTypes", "DataType") {
            let read = Self::data_type(node);
            self.project.types.push(read);
        }
        for node in all(controller, "Modules", "Module") {
            self.module(node);
        }
        // Hand-made files have the shorter name.
        let definitions = ["AddOnInstructionDefinition", "AddOnInstruction"];
        let definitions = definitions.map(|name| all(controller, "AddOnInstructionDefinitions", name));
        for node in definitions.into_iter().flatten() {
            let read = self.aoi(node);
            self.project.aois.push(read);
        }
        for node in all(controller, "AddOnInstructionDefinitions", "EncodedData") {
            self.encoded(node);
        }
        for node in all(controller, "Tags", "Tag") {
            let read = Self::tag(node);
            self.project.tags.push(read);
        }
        for node in all(controller, "Programs", "Program") {
            let read = self.program(node);
            self.project.programs.push(read);
        }
        for node in all(controller, "Programs", "EncodedData") {
            self.encoded(node);
        }
        let unread = controller
            .children()
            .filter(|child| child.has_tag_name("ParameterConnections"));
        for node in unread.flat_map(|node| node.children().filter(Node::is_element)) {
            let what = format!("connection of {}", attribute(node, "EndPoint1"));
            self.refuse(
                node,
                what,
                "parameters of programs that are connected are not read",
            );
        }
        for task in all(controller, "Tasks", "Task") {
            if task.attribute("Type") == Some("PERIODIC") && self.project.rate.is_none() {
                self.project.rate = task.attribute("Rate").map(str::to_owned);
            }
            let scheduled = all(task, "ScheduledPrograms", "ScheduledProgram");
            self.project
                .scheduled
                .extend(scheduled.map(|program| attribute(program, "Name")));
        }
    }

    /// Rungs at places where none are expected: they must not get lost.
    fn rungs_elsewhere(&mut self, root: Node<'_, '_>) {
        for node in root.descendants().filter(|node| node.has_tag_name("Rung")) {
            if !self.read.contains(&node.range().start) {
                self.refuse(
                    node,
                    "Rung".to_owned(),
                    "it is at a place where no rungs are read",
                );
            }
        }
    }

    fn encoded(&mut self, node: Node<'_, '_>) {
        let what = format!("{} {}", attribute(node, "EncodedType"), attribute(node, "Name"));
        let why = "it is encoded: its source is protected, and only Logix Designer can read it";
        self.refuse(node, what, why);
    }

    fn data_type(node: Node<'_, '_>) -> DataType {
        let members = all(node, "Members", "Member").map(|member| Member {
            name: attribute(member, "Name"),
            ty: attribute(member, "DataType"),
            dimensions: dimensions(member, "Dimension"),
            hidden: member.attribute("Hidden") == Some("true"),
            bit: member
                .attribute("Target")
                .zip(member.attribute("BitNumber"))
                .and_then(|(target, number)| Some((target.to_owned(), number.parse().ok()?))),
            comment: described(member),
        });
        DataType {
            at: at(node),
            name: attribute(node, "Name"),
            is_string: node.attribute("Family") == Some("StringFamily"),
            members: members.collect(),
            comment: described(node),
        }
    }

    /// The tags that a module has: their names are written nowhere, they follow from its own.
    fn module(&mut self, module: Node<'_, '_>) {
        let parent = attribute(module, "ParentModule");
        let slot = module
            .descendants()
            .find(|node| node.has_tag_name("Port") && node.attribute("Upstream") == Some("true"))
            .and_then(|port| port.attribute("Address"))
            .filter(|address| address.parse::<u32>().is_ok());
        let name = match slot {
            Some(slot) if parent == "Local" || !parent.is_empty() => format!("{parent}:{slot}"),
            _ => attribute(module, "Name"),
        };
        for (element, letter) in [("ConfigTag", "C"), ("InputTag", "I"), ("OutputTag", "O")] {
            for node in module.descendants().filter(|node| node.has_tag_name(element)) {
                let value = Self::value(node);
                if let Some(Raw::Structure(ty, _)) = &value {
                    let tag = Tag {
                        at: at(node),
                        name: format!("{name}:{letter}"),
                        ty: ty.clone(),
                        value,
                        ..Tag::default()
                    };
                    self.project.tags.push(tag);
                }
            }
        }
    }

    fn aoi(&mut self, node: Node<'_, '_>) -> Aoi {
        let name = attribute(node, "Name");
        Aoi {
            at: at(node),
            parameters: all(node, "Parameters", "Parameter")
                .map(|tag| Self::tag(tag))
                .collect(),
            locals: all(node, "LocalTags", "LocalTag")
                .map(|tag| Self::tag(tag))
                .collect(),
            routines: self.routines(node, &format!("Add-On Instruction {name}")),
            comment: described(node),
            name,
        }
    }

    fn tag(node: Node<'_, '_>) -> Tag {
        Tag {
            at: at(node),
            name: attribute(node, "Name"),
            ty: attribute(node, "DataType"),
            dimensions: dimensions(node, "Dimensions"),
            alias: node.attribute("AliasFor").map(str::to_owned),
            usage: match node.attribute("Usage") {
                Some("Input") => Usage::Input,
                Some("Output") => Usage::Output,
                Some("InOut") => Usage::InOut,
                _ => Usage::Local,
            },
            required: node.attribute("Required") == Some("true"),
            constant: node.attribute("Constant") == Some("true"),
            value: Self::value(node),
            comment: described(node),
        }
    }

    /// The value of a tag as `Decorated` data has it, else as text.
    fn value(tag: Node<'_, '_>) -> Option<Raw> {
        let data = tag
            .children()
            .filter(|node| matches!(node.tag_name().name(), "Data" | "DefaultData"));
        let formats: Vec<Node<'_, '_>> = data.collect();
        let of = |format: &str| {
            formats
                .iter()
                .find(|node| node.attribute("Format") == Some(format))
        };
        if let Some(decorated) = of("Decorated") {
            let inner = decorated.children().find(Node::is_element)?;
            return raw(inner, 0);
        }
        let plain = of("L5K").or_else(|| of("String"))?;
        crate::l5k::value(plain.text()?.trim())
    }

    fn program(&mut self, node: Node<'_, '_>) -> Program {
        let name = attribute(node, "Name");
        Program {
            at: at(node),
            main: node.attribute("MainRoutineName").map(str::to_owned),
            tags: all(node, "Tags", "Tag").map(|tag| Self::tag(tag)).collect(),
            routines: self.routines(node, &format!("program {name}")),
            comment: described(node),
            name,
        }
    }

    fn routines(&mut self, owner: Node<'_, '_>, of: &str) -> Vec<Routine> {
        for node in all(owner, "Routines", "EncodedData") {
            self.encoded(node);
        }
        let mut routines = Vec::new();
        for node in all(owner, "Routines", "Routine") {
            let name = attribute(node, "Name");
            let language = match node.attribute("Type") {
                Some("FBD") => Some("a function block diagram"),
                Some("SFC") => Some("a sequential function chart"),
                Some("ST") => Some("structured text"),
                _ => None,
            };
            let other = node.children().find_map(|child| match child.tag_name().name() {
                "FBDContent" => Some("a function block diagram"),
                "SFCContent" => Some("a sequential function chart"),
                "STContent" => Some("structured text"),
                _ => None,
            });
            if let Some(language) = language.or(other) {
                let why = format!("it is {language}; only ladder logic is read");
                self.refuse(node, format!("routine {name} of {of}"), &why);
                continue;
            }
            let rungs = node
                .children()
                .filter(|child| child.has_tag_name("RLLContent"))
                .flat_map(|content| content.children().filter(|child| child.has_tag_name("Rung")));
            routines.push(Routine {
                at: at(node),
                rungs: rungs.map(|rung| self.rung(rung)).collect(),
                comment: described(node),
                name,
            });
        }
        routines
    }

    fn rung(&mut self, node: Node<'_, '_>) -> Rung {
        self.read.insert(node.range().start);
        let edit = node.attribute("Type").filter(|kind| !matches!(*kind, "N" | "IR"));
        let mut rung = Rung {
            at: at(node),
            comment: child(node, "Comment").and_then(text_of),
            edit: edit.map(str::to_owned),
            ..Rung::default()
        };
        if let Some(text) = child(node, "Text") {
            let content: String = text.children().filter_map(|node| node.text()).collect();
            let content = content.trim();
            let range = text.range();
            let start = self.text[range.clone()].find(content).unwrap_or(0);
            rung.at = range.start + start;
            content.clone_into(&mut rung.text);
        }
        rung
    }
}

/// A value as `Decorated` data has it.
fn raw(node: Node<'_, '_>, depth: usize) -> Option<Raw> {
    if depth > DEEPEST {
        return None;
    }
    let ty = || attribute(node, "DataType");
    match node.tag_name().name() {
        "Structure" | "StructureMember" => {
            let members = node.children().filter(Node::is_element).filter_map(|member| {
                let value = match member.tag_name().name() {
                    "DataValueMember" => raw_scalar(member),
                    _ => raw(member, depth + 1),
                };
                Some((attribute(member, "Name"), value?))
            });
            Some(Raw::Structure(ty(), members.collect()))
        }
        "Array" | "ArrayMember" => {
            let elements = node.children().filter(|child| child.has_tag_name("Element"));
            let elements = elements.map(|element| match element.attribute("Value") {
                Some(value) => Some(Raw::Scalar(String::new(), value.to_owned())),
                None => raw(element.children().find(Node::is_element)?, depth + 1),
            });
            let sizes = dimensions(node, "Dimensions");
            Some(Raw::Array(ty(), sizes, elements.collect::<Option<_>>()?))
        }
        _ => raw_scalar(node),
    }
}

fn raw_scalar(node: Node<'_, '_>) -> Option<Raw> {
    let value = node.attribute("Value").or_else(|| node.text().map(str::trim))?;
    Some(Raw::Scalar(attribute(node, "DataType"), value.to_owned()))
}
