//! A project as L5X: elements and attributes in the order in which Logix Designer wants them.

use crate::l5x::ROOT;
use crate::model::{
    Aoi, DataType, Foreign, Language, Program, Project, Raw, Routine, Rung, Tag, Task, TaskKind, Usage,
};
use ladder_notation::xml::{escape, section};

/// The version of Logix Designer whose names of instructions are written.
const REVISION: &str = "33.01";

/// A whole file.
pub(super) fn file(project: &Project) -> String {
    let mut out = Out(String::from(
        "\u{feff}<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n",
    ));
    let name = &project.name;
    let head = [
        ("SchemaRevision", "1.0"),
        ("SoftwareRevision", REVISION),
        ("TargetName", name),
        ("TargetType", "Controller"),
        ("ContainsContext", "false"),
        (
            "ExportOptions",
            "DecoratedData ForceProtectedEncoding AllProjDocTrans",
        ),
    ];
    out.open(ROOT, &head);
    let (major, minor) = REVISION.split_once('.').unwrap_or((REVISION, "0"));
    let controller = [
        ("Use", "Target"),
        ("Name", name),
        ("ProcessorType", "1756-L83E"),
        ("MajorRev", major),
        ("MinorRev", minor.trim_start_matches('0')),
    ];
    out.open("Controller", &controller);
    out.open("DataTypes", &[]);
    project.types.iter().for_each(|ty| out.data_type(ty));
    out.close("DataTypes");
    out.leaf("Modules", &[]);
    out.open("AddOnInstructionDefinitions", &[]);
    project.aois.iter().for_each(|aoi| out.aoi(aoi));
    out.close("AddOnInstructionDefinitions");
    out.open("Tags", &[]);
    project.tags.iter().for_each(|tag| out.tag(tag));
    out.close("Tags");
    out.open("Programs", &[]);
    project.programs.iter().for_each(|program| out.program(program));
    out.close("Programs");
    out.tasks(project);
    out.close("Controller");
    out.close(ROOT);
    out.0
}

/// The file that is being written.
struct Out(String);

impl Out {
    fn start(&mut self, name: &str, attributes: &[(&str, &str)]) {
        self.0.push('<');
        self.0.push_str(name);
        for (attribute, value) in attributes {
            self.0.push_str(&format!(" {attribute}=\""));
            escape(&mut self.0, value);
            self.0.push('"');
        }
    }

    fn open(&mut self, name: &str, attributes: &[(&str, &str)]) {
        self.start(name, attributes);
        self.0.push_str(">\n");
    }

    fn leaf(&mut self, name: &str, attributes: &[(&str, &str)]) {
        self.start(name, attributes);
        self.0.push_str("/>\n");
    }

    fn close(&mut self, name: &str) {
        self.0.push_str(&format!("</{name}>\n"));
    }

    /// Text that must be there as a section, even an empty one.
    fn text(&mut self, name: &str, text: &str) {
        self.0.push_str(&format!("<{name}>\n"));
        section(&mut self.0, text);
        self.0.push_str(&format!("\n</{name}>\n"));
    }

    fn described(&mut self, comment: Option<&String>) {
        if let Some(comment) = comment {
            self.text("Description", comment);
        }
    }

    fn data_type(&mut self, ty: &DataType) {
        let family = if ty.is_string { "StringFamily" } else { "NoFamily" };
        self.open(
            "DataType",
            &[("Name", &ty.name), ("Family", family), ("Class", "User")],
        );
        self.described(ty.comment.as_ref());
        self.open("Members", &[]);
        for member in &ty.members {
            let dimension = member.dimensions.first().copied().unwrap_or(0).to_string();
            let hidden = if member.hidden { "true" } else { "false" };
            let number = member.bit.as_ref().map(|(_, bit)| bit.to_string());
            let mut attributes = vec![
                ("Name", member.name.as_str()),
                ("DataType", &member.ty),
                ("Dimension", &dimension),
            ];
            attributes.extend(radix(&member.ty).map(|radix| ("Radix", radix)));
            attributes.push(("Hidden", hidden));
            if let (Some((host, _)), Some(number)) = (&member.bit, &number) {
                attributes.extend([("Target", host.as_str()), ("BitNumber", number)]);
            }
            attributes.push(("ExternalAccess", "Read/Write"));
            self.open("Member", &attributes);
            self.described(member.comment.as_ref());
            self.close("Member");
        }
        self.close("Members");
        self.close("DataType");
    }

    fn aoi(&mut self, aoi: &Aoi) {
        let when_off = aoi.routines.iter().any(|routine| routine.name == "EnableInFalse");
        let attributes = [
            ("Name", aoi.name.as_str()),
            ("Revision", "1.0"),
            ("ExecutePrescan", "false"),
            ("ExecutePostscan", "false"),
            ("ExecuteEnableInFalse", if when_off { "true" } else { "false" }),
            ("SoftwareRevision", "v33.01"),
        ];
        self.open("AddOnInstructionDefinition", &attributes);
        self.described(aoi.comment.as_ref());
        self.open("Parameters", &[]);
        aoi.parameters.iter().for_each(|tag| self.parameter(tag));
        self.close("Parameters");
        self.open("LocalTags", &[]);
        aoi.locals.iter().for_each(|tag| self.local(tag));
        self.close("LocalTags");
        self.open("Routines", &[]);
        aoi.routines.iter().for_each(|routine| self.routine(routine));
        self.close("Routines");
        self.close("AddOnInstructionDefinition");
    }

    fn parameter(&mut self, tag: &Tag) {
        let sizes = sizes(tag, " ");
        let usage = match tag.usage {
            Usage::Output => "Output",
            Usage::InOut => "InOut",
            Usage::Input | Usage::Local => "Input",
        };
        let required = if tag.required { "true" } else { "false" };
        let mut attributes = vec![
            ("Name", tag.name.as_str()),
            ("TagType", "Base"),
            ("DataType", &tag.ty),
        ];
        attributes.extend(sizes.as_ref().map(|sizes| ("Dimensions", sizes.as_str())));
        attributes.push(("Usage", usage));
        attributes.extend(radix(&tag.ty).map(|radix| ("Radix", radix)));
        attributes.extend([("Required", required), ("Visible", required)]);
        attributes.push(match tag.usage {
            Usage::InOut => ("Constant", "false"),
            Usage::Output => ("ExternalAccess", "Read Only"),
            Usage::Input | Usage::Local => ("ExternalAccess", "Read/Write"),
        });
        self.open("Parameter", &attributes);
        self.described(tag.comment.as_ref());
        if tag.usage != Usage::InOut {
            self.data("DefaultData", tag);
        }
        self.close("Parameter");
    }

    fn local(&mut self, tag: &Tag) {
        let sizes = sizes(tag, " ");
        let mut attributes = vec![("Name", tag.name.as_str()), ("DataType", &tag.ty)];
        attributes.extend(sizes.as_ref().map(|sizes| ("Dimensions", sizes.as_str())));
        attributes.extend(radix(&tag.ty).map(|radix| ("Radix", radix)));
        attributes.push(("ExternalAccess", "None"));
        self.open("LocalTag", &attributes);
        self.described(tag.comment.as_ref());
        self.data("DefaultData", tag);
        self.close("LocalTag");
    }

    fn tag(&mut self, tag: &Tag) {
        let sizes = sizes(tag, " ");
        let mut attributes = vec![
            ("Name", tag.name.as_str()),
            ("TagType", "Base"),
            ("DataType", &tag.ty),
        ];
        attributes.extend(sizes.as_ref().map(|sizes| ("Dimensions", sizes.as_str())));
        attributes.extend(radix(&tag.ty).map(|radix| ("Radix", radix)));
        match tag.usage {
            Usage::Input => attributes.push(("Usage", "Input")),
            Usage::Output => attributes.push(("Usage", "Output")),
            Usage::InOut | Usage::Local => {}
        }
        attributes.push(("Constant", if tag.constant { "true" } else { "false" }));
        attributes.push(("ExternalAccess", "Read/Write"));
        self.open("Tag", &attributes);
        self.described(tag.comment.as_ref());
        self.data("Data", tag);
        self.close("Tag");
    }

    /// The value of a tag; one without says nothing: it is 0.
    fn data(&mut self, element: &str, tag: &Tag) {
        let Some(value) = &tag.value else { return };
        self.open(element, &[("Format", "Decorated")]);
        self.value(value, None);
        self.close(element);
    }

    /// A value, or that of a member.
    fn value(&mut self, value: &Raw, member: Option<&str>) {
        let named = |element: &'static str, of_member: &'static str| {
            if member.is_some() { of_member } else { element }
        };
        let mut attributes: Vec<(&str, &str)> = member.iter().map(|name| ("Name", *name)).collect();
        match value {
            Raw::Scalar(ty, text) => {
                attributes.push(("DataType", ty));
                attributes.extend(radix(ty).map(|radix| ("Radix", radix)));
                attributes.push(("Value", text));
                self.leaf(named("DataValue", "DataValueMember"), &attributes);
            }
            Raw::Structure(ty, members) => {
                let name = named("Structure", "StructureMember");
                attributes.push(("DataType", ty));
                self.open(name, &attributes);
                for (own, value) in members {
                    match value {
                        // The characters of a text.
                        Raw::Scalar(text, characters) if own == "DATA" => {
                            let attributes =
                                [("Name", "DATA"), ("DataType", text.as_str()), ("Radix", "ASCII")];
                            self.start("DataValueMember", &attributes);
                            self.0.push_str(">\n");
                            section(&mut self.0, &format!("'{characters}'"));
                            self.0.push_str("\n</DataValueMember>\n");
                        }
                        value => self.value(value, Some(own)),
                    }
                }
                self.close(name);
            }
            Raw::Array(ty, dimensions, elements) => {
                let name = named("Array", "ArrayMember");
                let sizes: Vec<String> = dimensions.iter().map(u32::to_string).collect();
                let sizes = sizes.join(",");
                attributes.extend([("DataType", ty.as_str()), ("Dimensions", sizes.as_str())]);
                attributes.extend(radix(ty).map(|radix| ("Radix", radix)));
                self.open(name, &attributes);
                for (number, element) in elements.iter().enumerate() {
                    let index = index(number, dimensions);
                    match element {
                        Raw::Scalar(_, text) => self.leaf("Element", &[("Index", &index), ("Value", text)]),
                        other => {
                            self.open("Element", &[("Index", &index)]);
                            self.value(other, None);
                            self.close("Element");
                        }
                    }
                }
                self.close(name);
            }
            Raw::List(_) => {}
        }
    }

    fn program(&mut self, program: &Program) {
        let mut attributes = vec![("Name", program.name.as_str()), ("TestEdits", "false")];
        attributes.extend(
            program
                .main
                .as_ref()
                .map(|main| ("MainRoutineName", main.as_str())),
        );
        attributes.extend([("Disabled", "false"), ("UseAsFolder", "false")]);
        self.open("Program", &attributes);
        self.described(program.comment.as_ref());
        self.open("Tags", &[]);
        program.tags.iter().for_each(|tag| self.tag(tag));
        self.close("Tags");
        self.open("Routines", &[]);
        program.routines.iter().for_each(|routine| self.routine(routine));
        self.close("Routines");
        self.close("Program");
    }

    fn routine(&mut self, routine: &Routine) {
        let kind = match routine.foreign.as_ref().map(|foreign| foreign.language) {
            None => "RLL",
            Some(Language::StructuredText) => "ST",
            Some(Language::FunctionBlocks) => "FBD",
            Some(Language::Chart) => "SFC",
            Some(Language::Protected) => return self.as_it_is(routine),
        };
        self.open("Routine", &[("Name", &routine.name), ("Type", kind)]);
        self.described(routine.comment.as_ref());
        match &routine.foreign {
            None => {}
            Some(Foreign {
                language: Language::StructuredText,
                text,
            }) => {
                self.open("STContent", &[]);
                for (number, line) in text.split('\n').enumerate() {
                    self.start("Line", &[("Number", &number.to_string())]);
                    self.0.push_str(">\n");
                    section(&mut self.0, line);
                    self.0.push_str("\n</Line>\n");
                }
                self.close("STContent");
                return self.close("Routine");
            }
            Some(_) => {
                self.as_it_is(routine);
                return self.close("Routine");
            }
        }
        self.open("RLLContent", &[]);
        for (number, rung) in routine.rungs.iter().enumerate() {
            self.rung(number, rung);
        }
        self.close("RLLContent");
        self.close("Routine");
    }

    /// What a routine is in a file that it was read from.
    fn as_it_is(&mut self, routine: &Routine) {
        self.0
            .extend(routine.foreign.iter().map(|foreign| foreign.text.as_str()));
        self.0.push('\n');
    }

    fn rung(&mut self, number: usize, rung: &Rung) {
        self.open("Rung", &[("Number", &number.to_string()), ("Type", "N")]);
        if let Some(comment) = &rung.comment {
            self.text("Comment", comment);
        }
        self.text("Text", &rung.text);
        self.close("Rung");
    }

    fn tasks(&mut self, project: &Project) {
        self.open("Tasks", &[]);
        let all = [Task {
            name: "MainTask".to_owned(),
            programs: project
                .programs
                .iter()
                .map(|program| program.name.clone())
                .collect(),
            ..Task::default()
        }];
        let tasks = if project.tasks.is_empty() {
            &all[..]
        } else {
            &project.tasks
        };
        // The one that runs as often as the program says.
        let is_timed = |task: &&Task| task.kind == TaskKind::Periodic;
        let timed = tasks.iter().find(is_timed).or(tasks.first());
        for task in tasks {
            let of_program = project.rate.as_ref();
            let of_program = of_program.filter(|_| timed.is_some_and(|timed| timed.name == task.name));
            let rate = task.rate.as_ref().or(of_program);
            let kind = match task.kind {
                TaskKind::Event => "EVENT",
                TaskKind::Periodic => "PERIODIC",
                TaskKind::Continuous if rate.is_some() => "PERIODIC",
                TaskKind::Continuous => "CONTINUOUS",
            };
            let priority = task.priority.unwrap_or(10).to_string();
            let mut attributes = vec![("Name", task.name.as_str()), ("Type", kind)];
            attributes.extend(rate.map(|rate| ("Rate", rate.as_str())));
            attributes.extend([("Priority", priority.as_str()), ("Watchdog", "500")]);
            attributes.extend([("DisableUpdateOutputs", "false"), ("InhibitTask", "false")]);
            self.open("Task", &attributes);
            self.open("ScheduledPrograms", &[]);
            for name in &task.programs {
                self.leaf("ScheduledProgram", &[("Name", name)]);
            }
            self.close("ScheduledPrograms");
            self.close("Task");
        }
        self.close("Tasks");
    }
}

/// `3 5`, if it is an array.
fn sizes(tag: &Tag, between: &str) -> Option<String> {
    let sizes: Vec<String> = tag.dimensions.iter().map(u32::to_string).collect();
    (!sizes.is_empty()).then(|| sizes.join(between))
}

/// `[1,3]`
fn index(number: usize, dimensions: &[u32]) -> String {
    let mut rest = number;
    let mut indices: Vec<String> = Vec::new();
    for size in dimensions.iter().rev().map(|size| *size as usize) {
        indices.insert(0, (rest % size.max(1)).to_string());
        rest /= size.max(1);
    }
    format!("[{}]", indices.join(","))
}

/// How numbers of a type are shown; structures have none.
fn radix(ty: &str) -> Option<&'static str> {
    Some(match ty {
        "REAL" | "LREAL" => "Float",
        "BOOL" | "BIT" | "SINT" | "INT" | "DINT" | "LINT" | "USINT" | "UINT" | "UDINT" | "ULINT" => "Decimal",
        _ => return None,
    })
}
