//! A unit: what it declares, its body, and what else the file has.

use crate::archive::Object;
use crate::network;
use ladder_notation::xml::{Element, Xml, in_words};
use ladder_notation::{LineColumn, Lines, ReadError, Report};
use ladder_notation_plcopen::declarations::{Declared, without_comments};
use ladder_notation_plcopen::model::{Body, Part, Unit};
use roxmltree::Node;

/// The unit that an element `POU` is.
///
/// # Errors
///
/// If it declares nothing, or no unit.
pub(crate) fn unit(
    text: &str,
    xml: &Xml<'_>,
    node: Node<'_, '_>,
    report: &mut Report,
) -> Result<Unit, ReadError> {
    let mut unit = declared(text, xml, node, |declared| declared.unit(report))??;
    if unit.name.is_empty() {
        node.attribute("Name")
            .unwrap_or_default()
            .clone_into(&mut unit.name);
    }
    let implementation = node.child("Implementation");
    unit.body = match implementation.and_then(|implementation| implementation.elements().next()) {
        Some(language) => body(xml, language, report),
        None => {
            let why = "there is none: what the unit declares is read";
            report.refused(xml.place(node), "body", why);
            Body::Empty
        }
    };
    for part in node.elements() {
        let kinds = ["action", "method", "property", "transition"];
        let Some(what) = kinds.into_iter().find(|what| part.is(what)) else {
            continue;
        };
        let language = part.child("Implementation").and_then(|it| it.elements().next());
        let body = match language {
            // What has variables of its own is not drawn as part of the unit.
            Some(language) if part.child("Declaration").is_none() => body(xml, language, report),
            Some(language) if !language.is("ST") => Body::Text("LD", in_words(part), xml.place(part)),
            _ => Body::Text("ST", part.words(), xml.place(part)),
        };
        unit.parts.push(Part {
            place: xml.place(part),
            what,
            name: part.attribute("Name").unwrap_or_default().to_owned(),
            body,
        });
    }
    Ok(unit)
}

/// What an element declares.
///
/// # Errors
///
/// If it declares nothing.
pub(crate) fn declared<T>(
    text: &str,
    xml: &Xml<'_>,
    node: Node<'_, '_>,
    read: impl FnOnce(&Declared<'_>) -> T,
) -> Result<T, ReadError> {
    let declaration = node.child("Declaration");
    let declaration =
        declaration.ok_or_else(|| ReadError::at(xml.place(node), "the unit has no declaration"))?;
    let told = declaration.text().unwrap_or_default();
    let start = text[declaration.range().start..]
        .find(told)
        .map(|at| at + declaration.range().start);
    let lines = Lines::of(text);
    let place = |offset: usize| -> LineColumn {
        match start {
            Some(start) => lines.place(text, start + offset),
            None => xml.place(declaration),
        }
    };
    Ok(read(&Declared {
        text: told,
        // A pragma says nothing of what runs.
        plain: &without_pragmas(&without_comments(told)),
        place: &place,
    }))
}

/// Blanks in the place of `{attribute 'hide'}`.
fn without_pragmas(text: &str) -> String {
    let mut depth = 0_u32;
    let blank = |c: char| {
        match c {
            '{' => depth += 1,
            '}' if depth > 0 => {
                depth -= 1;
                return " ".to_owned();
            }
            _ => {}
        }
        if depth == 0 || c == '\n' {
            c.to_string()
        } else {
            " ".repeat(c.len_utf8())
        }
    };
    text.chars().map(blank).collect()
}

fn body(xml: &Xml<'_>, language: Node<'_, '_>, report: &mut Report) -> Body {
    match Element::name(&language) {
        "NWL" => {
            let mut all = language.descendants().filter(Node::is_element);
            let archive = all.find(|node| node.attribute("t") == Some("NWLImplementationObject"));
            match archive {
                Some(archive) => Body::Graph(network::graph(xml, Object::of(archive), report)),
                None => {
                    let why = "the body has no networks in it";
                    report.refused(xml.place(language), "body", why);
                    Body::Empty
                }
            }
        }
        "ST" => Body::Text("ST", language.words(), xml.place_of_words(language)),
        "CFC" => Body::Text("CFC", in_words(language), xml.place(language)),
        "SFC" => Body::Text("SFC", in_words(language), xml.place(language)),
        _ => Body::Text("a language of its own", in_words(language), xml.place(language)),
    }
}
