//! L5X: the XML that Logix Designer exports, of a whole controller or of a part of one.

use crate::model::{
    Aoi, DataType, Foreign, Language, Member, Program, Project, Protected, Raw, Routine, Rung, Tag, Task,
    TaskKind, Usage,
};
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
            self.project.protected.push(Protected {
                at: at(node),
                name: attribute(node, "Name"),
                text: self.source(node),
            });
        }
        for node in all(controller, "Tags", "Tag") {
            self.message(node);
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
            let programs = all(task, "ScheduledPrograms", "ScheduledProgram");
            self.project.tasks.push(Task {
                name: attribute(task, "Name"),
                kind: TaskKind::named(task.attribute("Type").unwrap_or_default()),
                inhibited: task.attribute("InhibitTask") == Some("true"),
                rate: task.attribute("Rate").map(str::to_owned),
                priority: task
                    .attribute("Priority")
                    .and_then(|priority| priority.parse().ok()),
                programs: programs.map(|program| attribute(program, "Name")).collect(),
            });
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

    /// An element as the file has it.
    fn source(&self, node: Node<'_, '_>) -> String {
        self.text[node.range()].to_owned()
    }

    /// What a message writes, if the tag is one: what it fetches, besides its own bits.
    fn message(&mut self, tag: Node<'_, '_>) {
        let mut inside = tag.descendants();
        if let Some(message) = inside.find(|node| node.has_tag_name("MessageParameters")) {
            let is_fetched = |kind: &str| !kind.to_ascii_lowercase().contains("write");
            let targets = ["LocalElement", "DestinationTag"];
            let mut written: Vec<String> = Vec::new();
            if message.attribute("MessageType").is_none_or(is_fetched) {
                written.extend(
                    targets
                        .iter()
                        .filter_map(|name| message.attribute(*name))
                        .map(str::to_owned),
                );
            }
            let key = attribute(tag, "Name").to_ascii_uppercase();
            self.project.messages.insert(key, written);
        }
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
            routines: self.routines(node),
            comment: described(node),
            sized_from: None,
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
            inhibited: node.attribute("Disabled") == Some("true"),
            main: node.attribute("MainRoutineName").map(str::to_owned),
            tags: all(node, "Tags", "Tag").map(|tag| Self::tag(tag)).collect(),
            routines: self.routines(node),
            comment: described(node),
            name,
        }
    }

    fn routines(&mut self, owner: Node<'_, '_>) -> Vec<Routine> {
        let mut routines = Vec::new();
        for node in all(owner, "Routines", "EncodedData") {
            routines.push(Routine {
                at: at(node),
                name: attribute(node, "Name"),
                foreign: Some(Foreign {
                    language: Language::Protected,
                    text: self.source(node),
                }),
                ..Routine::default()
            });
        }
        for node in all(owner, "Routines", "Routine") {
            let rungs = node
                .children()
                .filter(|child| child.has_tag_name("RLLContent"))
                .flat_map(|content| content.children().filter(|child| child.has_tag_name("Rung")));
            routines.push(Routine {
                at: at(node),
                name: attribute(node, "Name"),
                rungs: rungs.map(|rung| self.rung(rung)).collect(),
                foreign: self.foreign(node),
                comment: described(node),
            });
        }
        routines
    }

    /// What is in a routine that is not ladder logic.
    fn foreign(&self, routine: Node<'_, '_>) -> Option<Foreign> {
        let languages = [
            ("ST", "STContent", Language::StructuredText),
            ("FBD", "FBDContent", Language::FunctionBlocks),
            ("SFC", "SFCContent", Language::Chart),
        ];
        languages.into_iter().find_map(|(kind, element, language)| {
            let content = child(routine, element);
            if content.is_none() && routine.attribute("Type") != Some(kind) {
                return None;
            }
            let text = match (content, language) {
                (None, _) => String::new(),
                (Some(content), Language::StructuredText) => {
                    let lines = content.children().filter(|child| child.has_tag_name("Line"));
                    let lines: Vec<String> = lines.map(|line| self.line(line)).collect();
                    lines.join("\n")
                }
                (Some(content), _) => self.source(content),
            };
            Some(Foreign { language, text })
        })
    }

    /// A line of structured text, with its indentation: what is in the section, if it is in one.
    fn line(&self, line: Node<'_, '_>) -> String {
        let source = &self.text[line.range()];
        let inside = source
            .split_once("<![CDATA[")
            .and_then(|(_, rest)| rest.rsplit_once("]]>"));
        match inside {
            Some((inside, _)) => inside.replace("]]]]><![CDATA[>", "]]>"),
            None => line
                .text()
                .unwrap_or_default()
                .trim_matches(['\r', '\n'])
                .to_owned(),
        }
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
