//! What a simulation reports about its past, and where it stops.

use ladder_analysis::values::types::Scalar;
use ladder_documents::position::Range;
use ladder_simulator::scenario::{self, Wanted};
use ladder_simulator::{Breakpoint, Hit, value_text};

use crate::engine::{Engine, point};
use crate::messages;
use crate::request::Failure;
use crate::value::to_json;

/// An answer holds this many values of the past at most, a long text counted as several.
const MOST_VALUES: u64 = 200_000;

/// For how many values one of a type counts.
fn size(ty: Scalar) -> u64 {
    match ty {
        Scalar::String(most) => 1 + u64::from(most) / 64,
        _ => 1,
    }
}

impl Engine {
    /// What tags held after each of the last scans; refused if that is more than an answer should hold.
    pub(crate) fn past(&self, tags: &[String], scans: u64) -> Result<messages::History, Failure> {
        let simulation = self.session.simulation();
        let points = tags
            .iter()
            .map(|tag| point(simulation, tag))
            .collect::<Result<Vec<_>, _>>()?;
        let kept = (self.behind() as u64 + 1).min(scans);
        let of_scan: u64 = points.iter().map(|point| size(point.ty)).sum();
        if kept.saturating_mul(of_scan) > MOST_VALUES {
            return Err(Failure::Invalid(format!(
                "the values of {} tags in {kept} scans are too many for an answer; ask for fewer tags, or the last {} scans",
                points.len(),
                MOST_VALUES / of_scan
            )));
        }
        let past = self
            .session
            .past(&points, usize::try_from(scans).unwrap_or(usize::MAX));
        let known = past.first().map_or(0, Vec::len);
        let tags = points
            .into_iter()
            .zip(past)
            .map(|(point, values)| messages::PastValues {
                kind: point.ty.to_string(),
                values: values.iter().map(|value| to_json(value, point.ty)).collect(),
                name: point.name,
            });
        Ok(messages::History {
            first_scan: simulation.scans().saturating_sub(known as u64),
            tags: tags.collect(),
        })
    }

    /// What was done so far as a scenario.
    pub(crate) fn record(
        &self,
        name: &str,
        outputs: Option<&[String]>,
    ) -> Result<messages::Recorded, Failure> {
        let program = self.line_map.shown().file_name();
        let wanted = Wanted {
            program: &program,
            name,
            outputs,
        };
        let recorded = scenario::record(&self.session, wanted).map_err(Failure::Failed)?;
        let offered = scenario::recordable(&self.session).into_iter();
        let offered = offered.map(|it| messages::Offered {
            name: it.name,
            kind: it.ty.to_string(),
            output: it.is_output,
        });
        Ok(messages::Recorded {
            file: scenario::recorded_file(&program),
            text: recorded.text,
            outputs: recorded.expected,
            offered: offered.collect(),
            notes: recorded.notes,
        })
    }

    /// Where the program begins.
    pub(crate) fn first_rung(&self) -> Option<Range> {
        let program = self.session.simulation().program();
        let first = program.networks.get(program.main.clone())?.first()?.location;
        (first.file == 0).then(|| self.line_map.range(first.range))?
    }

    /// What runs next in the scan that is open.
    pub(crate) fn next(&self) -> Option<Range> {
        let location = self.session.simulation().next_block()?;
        (location.file == 0).then(|| self.line_map.range(location.range))?
    }

    /// The breakpoints that are set.
    pub(crate) fn breakpoints(&self) -> Vec<messages::Breakpoint> {
        let breakpoints = self.session.breakpoints().iter();
        breakpoints
            .map(|breakpoint| match breakpoint {
                Breakpoint::Network(network) => {
                    let location = self.session.simulation().program().networks[*network].location;
                    messages::Breakpoint {
                        range: Some(self.line_map.range_or_near(location.range)),
                        tag: None,
                    }
                }
                Breakpoint::Block(location) => messages::Breakpoint {
                    range: Some(self.place(*location).1),
                    tag: None,
                },
                Breakpoint::Change(point) => messages::Breakpoint {
                    range: None,
                    tag: Some(point.name.clone()),
                },
            })
            .collect()
    }

    /// Why a run stopped, in words; the hits of a session are counted.
    pub(crate) fn hit(&self, number: u64, hit: &Hit) -> messages::Hit {
        let in_front = |what: &str, location| {
            let (_, range) = self.place(location);
            messages::Hit {
                number,
                message: format!("stopped in front of the {what} in line {}", range.start.line + 1),
                range: Some(range),
            }
        };
        match hit {
            Hit::Network(location) => in_front(self.a_network(), *location),
            Hit::Block(location) => in_front("block", *location),
            Hit::Change {
                point,
                before,
                after,
                block,
            } => {
                let range = block.map(|block| self.place(block).1);
                let line = range.map_or(String::new(), |range| {
                    format!(" in line {}", range.start.line + 1)
                });
                let value = |it| value_text::display(it, point.ty);
                messages::Hit {
                    number,
                    message: format!(
                        "{} changed from {} to {}{line}",
                        point.name,
                        value(before),
                        value(after)
                    ),
                    range,
                }
            }
        }
    }
}
