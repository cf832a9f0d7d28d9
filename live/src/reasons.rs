//! The tree of reasons in the words of the messages.

use std::sync::Arc;

use ladder_analysis::program::Location;
use ladder_analysis::values::value::Value;
use ladder_documents::position::Range;
use ladder_simulator::{Cause, Judged, Point, Reason, Since, Wording, Write};

use crate::engine::{Engine, point};
use crate::messages::{self, CauseKind, PassOrStop, Reading, TagReason, WriteReason};
use crate::request::Failure;
use crate::value::to_json;

impl Engine {
    /// Why a tag holds what it holds.
    pub(crate) fn why(&mut self, tag: &str) -> Result<messages::Why, Failure> {
        let point = point(self.session.simulation(), tag)?;
        let why = match &mut self.controller {
            Some(controller) => Asked::Moment(controller.why(&point)),
            None => Asked::Run(self.session.why(&point)),
        };
        let files = self.session.simulation().program().files.clone();
        let texts = self.line_map.running().texts(&files);
        let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
        let revision = Arc::clone(self.line_map.running());
        let source = Arc::clone(self.line_map.source());
        let places = |block: Location| {
            if block.file == 0 {
                let opened = source.opened()?.as_ref().ok()?;
                return Some(opened.foreign().place(block.range));
            }
            let (_, text) =
                revision.text_next_to(files.get(block.file as usize).filter(|_| block.file > 0)?)?;
            text.translated_place(block.range)
        };
        let tree = Tree {
            engine: self,
            wording: Wording::new(&texts, &files).with_places(&places),
        };
        let (text, writes, reason) = match &why {
            Asked::Run(why) => (
                tree.wording.text(why),
                why.writes().collect::<Vec<_>>(),
                tree.tag(why),
            ),
            Asked::Moment(judged) => (
                tree.wording.judged_text(judged),
                judged.judgements.iter().map(|it| &it.write).collect(),
                tree.judged(judged),
            ),
        };
        Ok(messages::Why {
            tag: point.name,
            text,
            blocks: tree.blocks(&writes),
            reason,
        })
    }
}

/// Reasons from the scans of a simulation, or from one reading of a controller.
enum Asked {
    Run(ladder_simulator::Why),
    Moment(Judged),
}

struct Tree<'e> {
    engine: &'e Engine,
    wording: Wording<'e>,
}

impl Tree<'_> {
    /// The blocks of the document that the first sentence is about.
    fn blocks(&self, writes: &[&Write]) -> Vec<Range> {
        let mut blocks = Vec::new();
        for write in writes {
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

    /// Of a reading nothing is known of earlier ones.
    fn judged(&self, judged: &Judged) -> TagReason {
        let last = judged.judgements.iter().rfind(|judgement| judgement.writes);
        let last = last.or(judged.judgements.last());
        let write = last.map(|judgement| WriteReason {
            because: judged.because.iter().map(|it| self.judged(it)).collect(),
            ..self.write(&judgement.write)
        });
        TagReason {
            tag: judged.point.name.clone(),
            kind: judged.point.ty.to_string(),
            value: to_json(&judged.value, judged.point.ty),
            since: messages::Since::Longer {},
            cause: match write {
                Some(_) => CauseKind::Block,
                None if judged.is_given => CauseKind::Given,
                None => CauseKind::Unknown,
            },
            text: self.wording.judged(judged),
            write,
            now: None,
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
