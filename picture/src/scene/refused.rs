//! Files of which nothing is shown, and why.

use super::finding::Finding;
use super::{MOST_ELEMENTS, Scene, text_range};
use ladder_syntax::TextRange;
use roxmltree::Error;

pub(super) fn refused(range: TextRange, message: String, help: &'static str) -> Scene {
    Scene {
        findings: vec![Finding::error(range, message, help)],
        ..Scene::default()
    }
}

pub(super) fn too_many(range: TextRange) -> Scene {
    refused(
        range,
        format!("the drawing has more than {MOST_ELEMENTS} elements"),
        "simplify it: join paths, and use <symbol> for what is there many times",
    )
}

pub(super) fn not_xml(text: &str, error: &Error) -> Scene {
    let position = error.pos();
    let line_start: usize = text
        .split_inclusive('\n')
        .take(position.row.saturating_sub(1) as usize)
        .map(str::len)
        .sum();
    let line = text
        .get(line_start..)
        .unwrap_or_default()
        .lines()
        .next()
        .unwrap_or_default();
    let column = line.char_indices().nth(position.col.saturating_sub(1) as usize);
    let start = line_start + column.map_or(line.len(), |(at, _)| at);
    let length = text[start..].chars().next().map_or(0, char::len_utf8);
    let range = text_range(start..start + length);
    match error {
        Error::DtdDetected => refused(
            range,
            "the file has a document type (`<!DOCTYPE`)".to_owned(),
            "take it out: a scene needs none",
        ),
        Error::NodesLimitReached => too_many(range),
        Error::UnknownNamespace(prefix, _) if prefix == "l" => refused(
            range,
            "the prefix `l` is not declared".to_owned(),
            "write xmlns:l=\"https://ladder.example/scene\" in the element `svg`",
        ),
        other => {
            let told = other.to_string();
            let told = told.rsplit_once(" at ").map_or(told.as_str(), |(told, _)| told);
            refused(
                range,
                format!("this is not XML as it must be: {told}"),
                "the file is read as XML: each element is closed, and each value in quotes",
            )
        }
    }
}
