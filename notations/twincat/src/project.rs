//! A unit with what it uses of the other files of its project.

use crate::{system, unit};
use ladder_notation::xml::{Element, Xml};
use ladder_notation::{ReadError, Report, Source};
use ladder_notation_plcopen::model::{Evaluation, Project};
use ladder_notation_plcopen::neighbours::{Held, add_with_used};

/// How the names of files end that hold what a unit may use.
const ENDS: [&str; 3] = [".tcpou", ".tcdut", ".tcgvl"];

/// Whether a file may hold something that a unit uses.
pub(crate) fn is_file(name: &str) -> bool {
    let name = name.to_ascii_lowercase();
    ENDS.iter().any(|end| name.ends_with(end))
}

/// The project that a file is.
///
/// # Errors
///
/// If it is not XML, or no unit.
pub(crate) fn project(source: &Source<'_>) -> Result<Project, ReadError> {
    let text = source.text()?;
    let mut project = Project {
        evaluation: Evaluation::Once,
        ..Project::default()
    };
    let xml = Xml::parse(text)?;
    let root = xml.document.root_element();
    let Some(node) = root.child("POU") else {
        let what = root
            .elements()
            .next()
            .map_or("nothing", |inside| Element::name(&inside));
        let message = format!("only units (`<POU>`) are read, and this file has `<{what}>`");
        return Err(ReadError::at(xml.place(root), message));
    };
    let own = unit::unit(text, &xml, node, &mut project.report)?;
    add_with_used(&mut project, own, text, source, |_, text, report| {
        held(text, report)
    });
    system::types(&mut project, text);
    Ok(project)
}

/// What another file holds.
fn held(text: &str, report: &mut Report) -> Result<Held, ReadError> {
    let xml = Xml::parse(text)?;
    let root = xml.document.root_element();
    let mut held = Held::default();
    if let Some(node) = root.child("POU") {
        held.units.push(unit::unit(text, &xml, node, report)?);
    } else if let Some(node) = root.child("DUT") {
        let ty = unit::declared(text, &xml, node, |declared| declared.data_type(report))?;
        held.types.extend(ty);
    } else if let Some(node) = root.child("GVL") {
        held.globals = unit::declared(text, &xml, node, |declared| declared.globals(report))?;
    }
    Ok(held)
}
