//! The tree of reasons in the words of the messages.

use std::sync::Arc;

use ladder_analysis::program::Location;
use ladder_analysis::values::value::Value;
use ladder_documents::position::Range;
use ladder_simulator::{Cause, Point, Reason, Since, Wording, Write};

use crate::engine::{Engine, point};
use crate::messages::{self, CauseKind, PassOrStop, Reading, TagReason, WriteReason};
use crate::request::Failure;
use crate::value::to_json;

impl Engine {
    /// Why a tag holds what it holds.
    pub(crate) fn why(&mut self, tag: &str) -> Result<messages::Why, Failure> {
        let point = point(self.session.simulation(), tag)?;
        let why = self.session.why(&point);
        let files = self.session.simulation().program().files.clone();
        let texts = self.line_map.running().texts(&files);
        let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
        let revision = Arc::clone(self.line_map.running());
        let places = |block: Location| {
            let (_, text) =
                revision.text_next_to(files.get(block.file as usize).filter(|_| block.file > 0)?)?;
            text.translated_place(block.range)
        };
        let tree = Tree {
            engine: self,
            wording: Wording::new(&texts, &files).with_places(&places),
        };
        Ok(messages::Why {
            tag: point.name,
            text: tree.wording.text(&why),
            blocks: tree.blocks(&why),
            reason: tree.tag(&why),
        })
    }
}

struct Tree<'e> {
    engine: &'e Engine,
    wording: Wording<'e>,
}

impl Tree<'_> {
    /// The blocks of the document that the first sentence is about.
    fn blocks(&self, why: &ladder_simulator::Why) -> Vec<Range> {
        let mut blocks = Vec::new();
        for write in why.writes() {
            let reasons = write.reasons.iter().flatten().map(|reason| reason.block);
            for block in std::iter::once(write.block).chain(reasons) {
                let (uri, range) = self.engine.place(block);
                if uri.is_none() && !blocks.contains(&range) {
                    blocks.push(range);
                }
            }
        }
        blocks
    }

    fn tag(&self, why: &ladder_simulator::Why) -> TagReason {
        let since = match why.since {
            Since::Start => messages::Since::Start {},
            Since::Longer => messages::Since::Longer {},
            Since::Scan { scan, time } => messages::Since::Scan {
                scan,
                time_ms: time as f64 / 1e6,
            },
        };
        let (cause, write) = match &why.cause {
            Cause::Initial => (CauseKind::Initial, None),
            Cause::Given => (CauseKind::Given, None),
            Cause::Forced => (CauseKind::Forced, None),
            Cause::System => (CauseKind::System, None),
            Cause::Unknown => (CauseKind::Unknown, None),
            Cause::Block(write) => (CauseKind::Block, Some(self.write(write))),
        };
        TagReason {
            tag: why.point.name.clone(),
            kind: why.point.ty.to_string(),
            value: to_json(&why.value, why.point.ty),
            since,
            cause,
            text: self.wording.why(why),
            write,
            now: why.now.as_ref().map(|now| self.write(now)),
        }
    }

    fn write(&self, write: &Write) -> WriteReason {
        let (uri, range) = self.engine.place(write.block);
        let ways = write.reasons.iter();
        WriteReason {
            scan: write.scan,
            uri,
            range,
            block: self.wording.drawn(write.block).to_owned(),
            power: write.power,
            ways: ways
                .map(|way| {
                    way.iter()
                        .map(|reason| self.reason(reason, !write.power))
                        .collect()
                })
                .collect(),
            read: readings(&[&write.read[..], &write.indices].concat()),
            because: write.because.iter().map(|why| self.tag(why)).collect(),
        }
    }

    fn reason(&self, reason: &Reason, stops: bool) -> PassOrStop {
        let (uri, range) = self.engine.place(reason.block);
        PassOrStop {
            uri,
            range,
            block: (!reason.is_rail).then(|| self.wording.drawn(reason.block).to_owned()),
            stops,
            text: self.wording.reason(reason),
            values: readings(&reason.values),
            because: reason.because.iter().map(|why| self.tag(why)).collect(),
        }
    }
}

fn readings(values: &[(Point, Value)]) -> Vec<Reading> {
    let readings = values.iter().map(|(point, value)| Reading {
        tag: point.name.clone(),
        kind: point.ty.to_string(),
        value: to_json(value, point.ty),
    });
    readings.collect()
}
