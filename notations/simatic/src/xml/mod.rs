//! SimaticML: blocks as XML.

mod access;
mod network;

use crate::cursor::{Cursor, Result};
use crate::model::{Kind, Role, Type, Unit, Variable};
use crate::read::resource::Texts;
use crate::read::type_of;
use crate::scope::plain;
use ladder_notation::xml::{Element, Xml};
use ladder_notation::{Lines, ReadError};
use roxmltree::Node;
use std::collections::HashMap;

/// Structures nest no deeper.
const DEEPEST: usize = 16;

/// The elements that are blocks.
const BLOCKS: [(&str, Kind); 6] = [
    ("SW.Blocks.FB", Kind::FunctionBlock),
    ("SW.Blocks.FC", Kind::Function),
    ("SW.Blocks.OB", Kind::Organization),
    ("SW.Blocks.GlobalDB", Kind::Data),
    ("SW.Blocks.InstanceDB", Kind::Data),
    ("SW.Types.PlcStruct", Kind::Type),
];

/// Whether a text is such a file, from what it begins with.
pub(crate) fn recognises(head: &str) -> bool {
    let head = head.trim_start_matches('\u{feff}').trim_start();
    head.starts_with('<')
        && head.contains("<Document")
        && (head.contains("<SW.") || head.contains("<Engineering"))
        && !holds_tags(head)
}

/// Whether a text is a table of tags, which is not a program, from what it begins with.
pub(crate) fn holds_tags(head: &str) -> bool {
    head.contains("<SW.Tags.PlcTagTable")
}

/// The tags and constants of a table.
///
/// # Errors
///
/// If it is not XML.
pub(crate) fn tags(text: &str) -> Result<Vec<Unit>> {
    let xml = Xml::parse(text)?;
    let all = xml
        .document
        .descendants()
        .filter(|node| node.is("SW.Tags.PlcTag") || node.is("SW.Tags.PlcUserConstant"));
    let tags = all.filter_map(|tag| {
        let attributes = tag.child("AttributeList")?;
        let ty = attributes.child("DataTypeName")?.words();
        let ty = Type::Named(ty.trim_matches('"').to_owned());
        let name = attributes.child("Name")?.words();
        let value = attributes.child("Value").map(|value| Variable {
            place: xml.place(tag),
            name: name.clone(),
            role: Role::Constant,
            ty: ty.clone(),
            initial: Some(value.words()),
            ..Variable::default()
        });
        Some(Unit {
            place: xml.place(tag),
            kind: Kind::Tag,
            name,
            returns: Some(ty),
            variables: value.into_iter().collect(),
            ..Unit::default()
        })
    });
    Ok(tags.collect())
}

/// Reads a block.
///
/// # Errors
///
/// If it is not XML, or holds no block.
pub(crate) fn unit(text: &str) -> Result<Unit> {
    let xml = Xml::parse(text)?;
    let root = xml.document.root_element();
    let mut blocks = root.elements().filter_map(|node| {
        let kind = BLOCKS.iter().find(|(name, _)| node.is(name));
        kind.map(|(_, kind)| (node, *kind))
    });
    let Some((node, kind)) = blocks.next() else {
        let message =
            "the file holds no block of a program: no SW.Blocks.FB, FC, OB or DB, and no SW.Types.PlcStruct";
        return Err(ReadError::at(xml.place(root), message));
    };
    let attributes = node.child("AttributeList");
    let attribute = |name: &str| {
        attributes
            .and_then(|list| list.child(name))
            .map(|node| node.words())
    };
    let mut unit = Unit {
        place: xml.place(node),
        kind,
        name: attribute("Name").unwrap_or_default(),
        told: told(node),
        ..Unit::default()
    };
    if kind == Kind::Data {
        unit.returns = attribute("InstanceOfName").map(Type::Named);
    }
    for (other, _) in blocks {
        let name = other.child("AttributeList").and_then(|list| list.child("Name"));
        let shown = format!("block {}", name.map(|node| node.words()).unwrap_or_default());
        let why = "the first block of a file is read: export each into a file of its own";
        unit.report.refused(xml.place(other), shown, why);
    }
    let sections = attributes
        .and_then(|list| list.child("Interface"))
        .and_then(|interface| interface.child("Sections"));
    for section in sections.iter().flat_map(|list| list.children_of("Section")) {
        interface(&xml, section, &mut unit)?;
    }
    let units = node.child("ObjectList");
    for compile in units
        .iter()
        .flat_map(|list| list.children_of("SW.Blocks.CompileUnit"))
    {
        let network = network::network(&xml, compile, &mut unit);
        unit.networks.push(network);
    }
    Ok(unit)
}

/// Title and comment of a block or a network.
fn told(node: Node<'_, '_>) -> Vec<String> {
    let mut told: Vec<String> = Vec::new();
    let texts = node.child("ObjectList");
    for name in ["Title", "Comment"] {
        let is = |text: &Node<'_, '_>| text.attribute("CompositionName") == Some(name);
        let all = texts.iter().flat_map(|list| list.children_of("MultilingualText"));
        for text in all.filter(is) {
            let items = text
                .descendants()
                .filter(|node| node.is_element() && node.is("AttributeList"));
            let items = items.filter_map(|item| {
                let text = item.child("Text")?.words();
                let is_english = item
                    .child("Culture")
                    .is_some_and(|culture| culture.words() == "en-US");
                (!text.is_empty()).then_some((is_english, text))
            });
            let items: Vec<(bool, String)> = items.collect();
            let text = items.iter().find(|(is_english, _)| *is_english).or(items.first());
            told.extend(
                text.map(|(_, text)| text.clone())
                    .filter(|text| !told.contains(text)),
            );
        }
    }
    told
}

fn interface(xml: &Xml<'_>, section: Node<'_, '_>, unit: &mut Unit) -> Result<()> {
    let role = match section.attribute("Name").unwrap_or_default() {
        "Input" => Role::Input,
        "Output" => Role::Output,
        "InOut" => Role::InOut,
        "Temp" => Role::Temp,
        "Constant" => Role::Constant,
        "Return" => {
            if let Some(result) = section.child("Member") {
                let ty = member(xml, result, Role::Output, 0)?.ty;
                unit.returns = Some(ty).filter(|ty| *ty != Type::Named("Void".to_owned()));
            }
            return Ok(());
        }
        _ => Role::Static,
    };
    for node in section.children_of("Member") {
        unit.variables.push(member(xml, node, role, 0)?);
    }
    Ok(())
}

fn member(xml: &Xml<'_>, node: Node<'_, '_>, role: Role, depth: usize) -> Result<Variable> {
    let place = xml.place(node);
    if depth > DEEPEST {
        return Err(ReadError::at(
            place,
            format!("structures nest deeper than {DEEPEST}"),
        ));
    }
    let written = node.attribute("Datatype").unwrap_or_default();
    let whole = |error: ReadError| ReadError::at(place, error.message);
    let has_members = written.len() >= 6 && written.to_ascii_lowercase().ends_with("struct");
    let ty = if has_members {
        let mut members = Vec::new();
        for inner in node.children_of("Member") {
            members.push(member(xml, inner, Role::Static, depth + 1)?);
        }
        let text = format!("{written} END_STRUCT");
        within(type_text(&text).map_err(whole)?, Type::Structure(members))
    } else {
        type_text(written).map_err(whole)?
    };
    let text = |name: &str| {
        node.child(name)
            .map(|node| node.words())
            .filter(|text| !text.is_empty())
    };
    Ok(Variable {
        place,
        name: node.attribute("Name").unwrap_or_default().to_owned(),
        role,
        retain: node.attribute("Remanence") == Some("Retain"),
        initial: text("StartValue").or_else(|| of_elements(node, &ty)),
        ty,
        comment: text("Comment"),
    })
}

/// An array with more elements has no first values.
const MOST_ELEMENTS: usize = 10_000;

/// The first values of an array, row by row, from those of its elements: `<Subelement Path="0,1">`
fn of_elements(node: Node<'_, '_>, ty: &Type) -> Option<String> {
    let Type::Array(bounds, of) = ty else { return None };
    let values: HashMap<&str, String> = node
        .children_of("Subelement")
        .filter_map(|element| Some((element.attribute("Path")?, element.child("StartValue")?.words())))
        .collect();
    let zero = match plain(of)? {
        "BOOL" => "FALSE",
        "TIME" => "T#0ms",
        "STRING" => "''",
        "REAL" | "LREAL" => "0.0",
        "DATE" => "D#1990-01-01",
        "TOD" => "TOD#00:00:00",
        "DT" => "DT#1990-01-01-00:00:00",
        _ => "0",
    };
    if values.is_empty() {
        return None;
    }
    let mut paths = element_paths(bounds)?;
    while paths.pop_if(|path| !values.contains_key(path.as_str())).is_some() {}
    let all = paths
        .iter()
        .map(|path| values.get(path.as_str()).map_or(zero, String::as_str));
    Some(format!("[{}]", all.collect::<Vec<&str>>().join(", ")))
}

/// The indices of each element of an array, row by row: `0,1`. None: it has too many, or bounds that are names.
pub(crate) fn element_paths(bounds: &[(String, String)]) -> Option<Vec<String>> {
    let mut paths = vec![String::new()];
    for (low, high) in bounds {
        let (low, high): (i64, i64) = (low.parse().ok()?, high.parse().ok()?);
        let count = usize::try_from(high.checked_sub(low)?.checked_add(1)?).ok()?;
        if paths.len().checked_mul(count)? > MOST_ELEMENTS {
            return None;
        }
        let with = |path: &String| -> Vec<String> {
            let comma = if path.is_empty() { "" } else { "," };
            (low..=high)
                .map(|index| format!("{path}{comma}{index}"))
                .collect()
        };
        paths = paths.iter().flat_map(with).collect();
    }
    Some(paths)
}

/// An array of empty structures as one of this.
fn within(ty: Type, of: Type) -> Type {
    match ty {
        Type::Array(bounds, inner) => Type::Array(bounds, Box::new(within(*inner, of))),
        _ => of,
    }
}

fn type_text(text: &str) -> Result<Type> {
    let lines = Lines::of(text);
    type_of(&mut Cursor::new(text, &lines), &Texts::default(), 0)
}
