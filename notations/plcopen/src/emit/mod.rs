//! From the model to XML: TC6 2.01, as the editors of Beremiz and OpenPLC have it.

mod body;
mod layout;

use crate::model::{Body, Initial, Project, Role, Task, Type, TypeDeclaration, Unit, UnitKind, Variable};
use crate::standard;
use ladder_format::program::Qualifier;
use ladder_notation::xml::XmlText;

/// Every file says when it was made; the same program makes the same file.
const WHEN: &str = "2000-01-01T00:00:00";

/// A whole project.
pub(super) fn project(project: Project) -> String {
    let Project {
        types,
        globals,
        units,
        tasks,
        ..
    } = project;
    let mut xml = XmlText::start();
    let name = units.last().map_or("Main", |unit| &unit.name).to_owned();
    let namespaces = [
        ("xmlns", "http://www.plcopen.org/xml/tc6_0201"),
        ("xmlns:xhtml", "http://www.w3.org/1999/xhtml"),
    ];
    xml.around("project", &namespaces, |xml| {
        let head = [
            ("companyName", crate::own::COMPANY),
            ("productName", "Unnamed"),
            ("productVersion", env!("CARGO_PKG_VERSION")),
            ("creationDateTime", WHEN),
        ];
        xml.empty("fileHeader", &head);
        xml.around("contentHeader", &[("name", name.as_str())], |xml| {
            xml.around("coordinateInfo", &[], |xml| {
                for language in ["fbd", "ld", "sfc"] {
                    xml.around(language, &[], |xml| {
                        xml.empty("scaling", &[("x", "10"), ("y", "10")]);
                    });
                }
            });
        });
        xml.around("types", &[], |xml| {
            xml.around("dataTypes", &[], |xml| {
                for ty in &types {
                    declared(xml, ty);
                }
            });
            xml.around("pous", &[], |xml| {
                for made in units {
                    unit(xml, made);
                }
            });
        });
        xml.around("instances", &[], |xml| {
            xml.around("configurations", &[], |xml| {
                xml.around("configuration", &[("name", "config")], |xml| {
                    xml.around("resource", &[("name", "resource1")], |xml| {
                        for it in &tasks {
                            task(xml, it);
                        }
                    });
                    lists(xml, &globals, |_| "globalVars");
                });
            });
        });
    });
    xml.finish()
}

/// A unit alone.
pub(super) fn unit_text(of: Unit) -> String {
    let mut xml = XmlText::start();
    unit(&mut xml, of);
    xml.finish()
}

/// A type alone.
pub(super) fn type_text(of: &TypeDeclaration) -> String {
    let mut xml = XmlText::start();
    declared(&mut xml, of);
    xml.finish()
}

fn declared(xml: &mut XmlText, declared: &TypeDeclaration) {
    xml.around("dataType", &[("name", declared.name.as_str())], |xml| {
        xml.around("baseType", &[], |xml| ty(xml, &declared.ty));
        initial(xml, declared.initial.as_ref());
        told(xml, "documentation", declared.comment.as_deref());
    });
}

fn task(xml: &mut XmlText, task: &Task) {
    let priority = task.priority.to_string();
    let mut attributes = vec![("name", task.name.as_str()), ("priority", &priority)];
    if let Some(interval) = &task.interval {
        attributes.push(("interval", interval));
    }
    xml.around("task", &attributes, |xml| {
        for (number, (_, program)) in task.programs.iter().enumerate() {
            let instance = format!("instance{number}");
            xml.empty("pouInstance", &[("name", &instance), ("typeName", program)]);
        }
    });
}

fn unit(xml: &mut XmlText, unit: Unit) {
    let kind = match unit.kind {
        UnitKind::Program => "program",
        UnitKind::Function => "function",
        UnitKind::FunctionBlock => "functionBlock",
    };
    xml.around("pou", &[("name", &unit.name), ("pouType", kind)], |xml| {
        xml.around("interface", &[], |xml| {
            if let Some(returns) = &unit.returns {
                xml.around("returnType", &[], |xml| ty(xml, returns));
            }
            lists(xml, &unit.variables, |role| match role {
                Role::Input => "inputVars",
                Role::Output => "outputVars",
                Role::InOut => "inOutVars",
                Role::External => "externalVars",
                Role::Temp => "tempVars",
                Role::Global => "globalVars",
                Role::Local => "localVars",
            });
        });
        xml.around("body", &[], |xml| match unit.body {
            Body::Graph(graph) => body::body(xml, graph),
            Body::Text("ST", text, _) => xml.around("ST", &[], |xml| xml.words("xhtml:p", &[], &text)),
            _ => xml.empty("LD", &[]),
        });
        told(xml, "documentation", unit.comment.as_deref());
    });
}

/// Variables, those of one kind that stand next to each other in one list. Those that have an address are in lists of their
/// own: compilers declare them apart.
fn lists(xml: &mut XmlText, variables: &[Variable], name: impl Fn(Role) -> &'static str) {
    let same = |one: &Variable, other: &Variable| {
        (one.role, one.qualifier, one.address.is_some())
            == (other.role, other.qualifier, other.address.is_some())
    };
    for list in variables.chunk_by(same) {
        let attributes: &[(&str, &str)] = match list[0].qualifier {
            None => &[],
            Some(Qualifier::Constant) => &[("constant", "true")],
            Some(Qualifier::Retain) => &[("retain", "true")],
        };
        xml.around(name(list[0].role), attributes, |xml| {
            for variable in list {
                let mut attributes = vec![("name", variable.name.as_str())];
                attributes.extend(variable.address.as_deref().map(|address| ("address", address)));
                xml.around("variable", &attributes, |xml| {
                    xml.around("type", &[], |xml| ty(xml, &variable.ty));
                    initial(xml, variable.initial.as_ref());
                    told(xml, "documentation", variable.comment.as_deref());
                });
            }
        });
    }
}

fn told(xml: &mut XmlText, name: &str, words: Option<&str>) {
    if let Some(words) = words {
        xml.around(name, &[], |xml| xml.words("xhtml:p", &[], words));
    }
}

fn ty(xml: &mut XmlText, of: &Type) {
    match of {
        Type::Named(name) => match standard::elementary(name) {
            Some(known) if known == name => xml.empty(known, &[]),
            _ => xml.empty("derived", &[("name", name)]),
        },
        Type::Text(None) => xml.empty("string", &[]),
        Type::Text(Some(length)) => xml.empty("string", &[("length", &length.to_string())]),
        Type::Array(bounds, element) => xml.around("array", &[], |xml| {
            for (lower, upper) in bounds {
                xml.empty("dimension", &[("lower", lower), ("upper", upper)]);
            }
            xml.around("baseType", &[], |xml| ty(xml, element));
        }),
        Type::Enumeration(values) => xml.around("enum", &[], |xml| {
            xml.around("values", &[], |xml| {
                for (name, number) in values {
                    let mut attributes = vec![("name", name.as_str())];
                    attributes.extend(number.as_deref().map(|number| ("value", number)));
                    xml.empty("value", &attributes);
                }
            });
        }),
        Type::Structure(members) => xml.around("struct", &[], |xml| {
            for member in members {
                xml.around("variable", &[("name", member.name.as_str())], |xml| {
                    xml.around("type", &[], |xml| ty(xml, &member.ty));
                    initial(xml, member.initial.as_ref());
                    told(xml, "documentation", member.comment.as_deref());
                });
            }
        }),
        Type::Range(base, lower, upper) => {
            let kind = if base.starts_with(['U', 'u']) {
                "subrangeUnsigned"
            } else {
                "subrangeSigned"
            };
            xml.around(kind, &[], |xml| {
                xml.empty("range", &[("lower", lower), ("upper", upper)]);
                xml.around("baseType", &[], |xml| ty(xml, &Type::Named(base.clone())));
            });
        }
        // The writer makes none.
        Type::Other(_) => {}
    }
}

fn initial(xml: &mut XmlText, value: Option<&Initial>) {
    if let Some(value) = value {
        xml.around("initialValue", &[], |xml| value_in(xml, value));
    }
}

fn value_in(xml: &mut XmlText, value: &Initial) {
    match value {
        Initial::Simple(text) => xml.empty("simpleValue", &[("value", text)]),
        Initial::Array(values) => xml.around("arrayValue", &[], |xml| {
            for (times, value) in values {
                let times = times.to_string();
                let attributes: &[(&str, &str)] = if times == "1" {
                    &[]
                } else {
                    &[("repetitionValue", &times)]
                };
                xml.around("value", attributes, |xml| value_in(xml, value));
            }
        }),
        Initial::Structure(values) => xml.around("structValue", &[], |xml| {
            for (member, value) in values {
                xml.around("value", &[("member", member)], |xml| value_in(xml, value));
            }
        }),
    }
}
