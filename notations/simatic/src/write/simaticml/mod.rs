//! Units as SimaticML, the XML that the Openness of TIA Portal exports and imports.

mod access;
mod graph;
mod network;

use super::Made;
use super::document::title_and_comment;
use crate::model::{Body, Kind, Net, Network, Role, Type, Unit, Variable};
use crate::scope::{Library, Scope, plain};
use crate::standard::elementary;
use crate::xml::element_paths;
use ladder_notation::xml::XmlText;
use ladder_notation::{Companion, Outcome, Report, Writing};

/// The version that the files name: later ones take them, earlier ones do not.
const VERSION: &str = "V17";

/// The form of interfaces that it has.
const INTERFACE: &str = "http://www.siemens.com/automation/Openness/SW/Interface/v5";

/// The language of the texts.
const CULTURE: &str = "en-US";

/// A program as files.
pub(crate) fn writing(made: Made) -> Writing {
    let Made {
        program,
        others,
        callers,
        mut report,
    } = made;
    let mut library = Library::new();
    for unit in others.iter().chain([&program]).chain(&callers) {
        library.insert(unit.name.to_lowercase(), Ok(unit));
    }
    let companions = others
        .iter()
        .chain(&callers)
        .zip(2..)
        .map(|(unit, number)| Companion {
            name: format!("{}.xml", unit.name),
            bytes: file(unit, number, &library, &mut report).into(),
        });
    let companions = companions.collect();
    Writing {
        bytes: file(&program, 1, &library, &mut report),
        companions,
        report,
    }
}

/// The next numbers of what a file holds.
struct Ids(u32);

impl Ids {
    fn next(&mut self) -> String {
        let id = format!("{:X}", self.0);
        self.0 += 1;
        id
    }
}

/// The file of a unit.
fn file<'u>(unit: &'u Unit, number: usize, library: &Library<'u>, report: &mut Report) -> Vec<u8> {
    for variable in unit.variables.iter().filter(|own| own.initial.is_some()) {
        if let Type::Array(bounds, _) = &variable.ty
            && element_paths(bounds).is_none()
        {
            let why = format!(
                "`{}` has more first values than files there have: it is declared without",
                variable.name
            );
            report.refused(variable.place, format!("tag `{}`", variable.name), why);
        }
    }
    let mut xml = XmlText::start();
    let mut ids = Ids(0);
    let is_type = unit.kind == Kind::Type;
    let name = match unit.kind {
        Kind::Type => "SW.Types.PlcStruct",
        Kind::Data => "SW.Blocks.InstanceDB",
        Kind::Organization => "SW.Blocks.OB",
        _ => "SW.Blocks.FB",
    };
    xml.around("Document", &[], |xml| {
        xml.empty("Engineering", &[("version", VERSION)]);
        xml.around(name, &[("ID", &ids.next())], |xml| {
            xml.around("AttributeList", &[], |xml| {
                if !is_type {
                    xml.words("AutoNumber", &[], "true");
                }
                // A data block has the interface of the block that it belongs to.
                match &unit.returns {
                    Some(of) => {
                        xml.words("InstanceOfName", &[], of.to_string().trim_matches('"'));
                        xml.words("InstanceOfType", &[], "FB");
                    }
                    None => xml.around("Interface", &[], |xml| {
                        xml.around("Sections", &[("xmlns", INTERFACE)], |xml| sections(xml, unit));
                    }),
                }
                if !is_type {
                    xml.words("MemoryLayout", &[], "Optimized");
                }
                xml.words("Name", &[], &unit.name);
                if !is_type {
                    xml.words("Number", &[], &number.to_string());
                    let language = if unit.kind.is_code() { "LAD" } else { "DB" };
                    xml.words("ProgrammingLanguage", &[], language);
                    if unit.kind == Kind::Organization {
                        xml.words("SecondaryType", &[], "ProgramCycle");
                    }
                    if unit.kind.is_code() {
                        xml.words("SetENOAutomatically", &[], "false");
                    }
                }
            });
            let [title, comment] = title_and_comment(&unit.told);
            xml.around("ObjectList", &[], |xml| {
                text(xml, &mut ids, "Comment", comment.as_deref());
                let mut scope = Scope::of(unit, library);
                for own in &unit.networks {
                    compile_unit(xml, &mut ids, own, (unit, &mut scope), report);
                }
                text(xml, &mut ids, "Title", title.as_deref());
            });
        });
    });
    xml.finish().into_bytes()
}

/// The section of a role.
const fn section(role: Role) -> &'static str {
    match role {
        Role::Input => "Input",
        Role::Output => "Output",
        Role::InOut => "InOut",
        Role::Static => "Static",
        Role::Temp => "Temp",
        Role::Constant => "Constant",
    }
}

fn sections(xml: &mut XmlText, unit: &Unit) {
    if unit.kind == Kind::Type {
        xml.around("Section", &[("Name", "None")], |xml| {
            unit.variables.iter().for_each(|own| member(xml, own));
        });
        return;
    }
    let roles = [
        Role::Input,
        Role::Output,
        Role::InOut,
        Role::Static,
        Role::Temp,
        Role::Constant,
    ];
    let is_main = unit.kind == Kind::Organization;
    for role in roles {
        if is_main && matches!(role, Role::Output | Role::InOut | Role::Static) {
            continue;
        }
        xml.around("Section", &[("Name", section(role))], |xml| {
            let own = unit.variables.iter().filter(|own| own.role == role);
            own.for_each(|own| member(xml, own));
        });
    }
}

fn member(xml: &mut XmlText, variable: &Variable) {
    let ty = variable.ty.to_string();
    let mut attributes = vec![("Name", variable.name.as_str()), ("Datatype", ty.as_str())];
    if plain(&variable.ty).is_some_and(|own| elementary(own).is_none() && own != "STRING") {
        attributes.push(("Version", "1.0"));
    }
    if variable.retain {
        attributes.push(("Remanence", "Retain"));
    }
    xml.around("Member", &attributes, |xml| {
        if let Some(comment) = &variable.comment {
            xml.around("Comment", &[], |xml| {
                xml.words("MultiLanguageText", &[("Lang", CULTURE)], comment);
            });
        }
        match (&variable.initial, &variable.ty) {
            (Some(initial), Type::Array(bounds, _)) => elements(xml, initial, bounds),
            (Some(initial), _) => xml.words("StartValue", &[], initial),
            (None, _) => {}
        }
        if let Type::Structure(members) = &variable.ty {
            for own in members {
                member(xml, own);
            }
        }
    });
}

/// The values of an array, each at its element.
fn elements(xml: &mut XmlText, initial: &str, bounds: &[(String, String)]) {
    let inner = initial.trim_start_matches('[').trim_end_matches(']');
    let values = inner.split(',').flat_map(|value| {
        let value = value.trim();
        let run = value.strip_suffix(')').and_then(|rest| rest.split_once('('));
        let (count, value) = run.map_or((1, value), |(count, value)| (count.parse().unwrap_or(1), value));
        std::iter::repeat_n(value, count)
    });
    for (path, value) in element_paths(bounds).unwrap_or_default().iter().zip(values) {
        xml.around("Subelement", &[("Path", path)], |xml| {
            xml.words("StartValue", &[], value);
        });
    }
}

/// A text in a language, if there is one.
fn text(xml: &mut XmlText, ids: &mut Ids, name: &str, words: Option<&str>) {
    let Some(words) = words else { return };
    let own = [("ID", &*ids.next()), ("CompositionName", name)];
    xml.around("MultilingualText", &own, |xml| {
        xml.around("ObjectList", &[], |xml| {
            let own = [("ID", &*ids.next()), ("CompositionName", "Items")];
            xml.around("MultilingualTextItem", &own, |xml| {
                xml.around("AttributeList", &[], |xml| {
                    xml.words("Culture", &[], CULTURE);
                    xml.words("Text", &[], words);
                });
            });
        });
    });
}

/// So deep is the drawing of a network within a file.
const DEPTH: usize = 6;

/// A network without wires.
static NOTHING: Net = Net {
    points: 1,
    wires: Vec::new(),
};

/// A network with its texts. What is not written is a comment.
fn compile_unit<'u>(
    xml: &mut XmlText,
    ids: &mut Ids,
    own: &'u Network,
    (unit, scope): (&'u Unit, &mut Scope<'u>),
    report: &mut Report,
) {
    let [title, mut comment] = title_and_comment(&own.told);
    let label = own.label.as_ref().map(|(_, label)| label.as_str());
    let mut source = XmlText::within(DEPTH);
    let drawn = match &own.body {
        Body::Ladder(net) => network::network(&mut source, net, label, (unit, scope)),
        Body::Text(language, why) if language == "LAD" => Err(why.clone()),
        Body::Text(language, _) => Err(format!(
            "a text in {language} is not written there: write a source document, `--to simatic`"
        )),
    };
    if let Err(why) = &drawn {
        source = XmlText::within(DEPTH);
        // Others may jump to it.
        let is_marked =
            label.is_some() && network::network(&mut source, &NOTHING, label, (unit, scope)).is_ok();
        if !is_marked {
            source = XmlText::default();
        }
        let lines = comment.iter().map(String::as_str).chain([own.text.trim_end()]);
        comment = Some(lines.collect::<Vec<&str>>().join("\n"));
        let mut entries = report.entries.iter_mut();
        if let Some(entry) = entries.find(|entry| entry.place == own.place && entry.element == "network") {
            entry.outcome = Outcome::Refused(why.clone());
        }
    }
    let id = ids.next();
    let attributes = [("ID", id.as_str()), ("CompositionName", "CompileUnits")];
    xml.around("SW.Blocks.CompileUnit", &attributes, |xml| {
        xml.around("AttributeList", &[], |xml| {
            xml.around("NetworkSource", &[], |xml| {
                xml.append(&source);
            });
            xml.words("ProgrammingLanguage", &[], "LAD");
        });
        xml.around("ObjectList", &[], |xml| {
            text(xml, ids, "Comment", comment.as_deref());
            text(xml, ids, "Title", title.as_deref());
        });
    });
}
