//! The answer for machines. The names of the members are documented; nothing may be renamed.

use super::{contradicts, missing};
use crate::values::Given;
use ladder_analysis::values::value::Value;
use ladder_simulator::{Judged, Judgement, Point, Reason, Wording, value_text};
use serde::Serialize;

#[derive(Serialize)]
pub(super) struct Answer {
    contradiction: bool,
    missing: Vec<String>,
    unknown: Vec<Unknown>,
    constants: Vec<String>,
    /// The unread parts that may write the tag.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    unread_parts: Vec<String>,
    reason: Followed,
}

#[derive(Serialize)]
struct Unknown {
    name: String,
    line: u64,
}

#[derive(Serialize)]
struct Followed {
    tag: String,
    #[serde(rename = "type")]
    ty: String,
    value: String,
    given: bool,
    contradiction: bool,
    text: String,
    writes: Vec<Write>,
    because: Vec<Followed>,
}

#[derive(Serialize)]
struct Write {
    block: String,
    line: u32,
    column: u32,
    power: bool,
    writes: bool,
    leaves: String,
    ways: Vec<Vec<Passed>>,
    read: Vec<Read>,
}

#[derive(Serialize)]
struct Passed {
    /// None of the left rail.
    block: Option<String>,
    line: u32,
    column: u32,
    stops: bool,
    values: Vec<Read>,
}

#[derive(Serialize)]
struct Read {
    tag: String,
    value: String,
}

impl Answer {
    pub(super) fn of(
        judged: &Judged,
        given: &Given,
        unread_parts: Vec<String>,
        wording: &Wording<'_>,
    ) -> Answer {
        let unknown = given.unknown.iter().map(|(line, name)| Unknown {
            name: name.clone(),
            line: *line,
        });
        Answer {
            contradiction: contradicts(judged),
            missing: missing(judged),
            unknown: unknown.collect(),
            constants: given.constants.clone(),
            unread_parts,
            reason: tag(judged, wording),
        }
    }
}

fn tag(judged: &Judged, wording: &Wording<'_>) -> Followed {
    let write = |judgement: &Judgement| {
        let write = &judgement.write;
        let (line, column, block) = wording.place(write.block);
        let way = |way: &Vec<Reason>| {
            way.iter()
                .map(|reason| self::block(reason, !write.power, wording))
                .collect()
        };
        Write {
            block: block.to_owned(),
            line,
            column,
            power: write.power,
            writes: judgement.writes,
            leaves: value_text::cell(&judgement.leaves, judged.point.ty),
            ways: write.reasons.iter().map(way).collect(),
            read: write.read.iter().map(read).collect(),
        }
    };
    Followed {
        tag: judged.point.name.clone(),
        ty: judged.point.ty.to_string(),
        value: value_text::cell(&judged.value, judged.point.ty),
        given: judged.is_given,
        contradiction: judged.contradiction().is_some(),
        text: wording.judged(judged),
        writes: judged.judgements.iter().map(write).collect(),
        because: judged
            .because
            .iter()
            .map(|because| tag(because, wording))
            .collect(),
    }
}

fn block(reason: &Reason, stops: bool, wording: &Wording<'_>) -> Passed {
    let (line, column, block) = wording.place(reason.block);
    Passed {
        block: (!reason.is_rail).then(|| block.to_owned()),
        line,
        column,
        stops,
        values: reason.values.iter().map(read).collect(),
    }
}

fn read((point, value): &(Point, Value)) -> Read {
    Read {
        tag: point.name.clone(),
        value: value_text::cell(value, point.ty),
    }
}
