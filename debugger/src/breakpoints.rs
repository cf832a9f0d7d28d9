//! All breakpoints of a target.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use ladder_simulator::{Breakpoint, Hit};
use serde_json::{Value as Json, json};

use crate::breakpoint_places::place;
use crate::marker::{Marker, Verdict};
use crate::messages::{DataBreakpoint, SourceBreakpoint};
use crate::sources::Counting;
use crate::target::Target;

/// All breakpoints of a target.
#[derive(Debug, Default)]
pub(crate) struct Table {
    by_file: BTreeMap<u32, Vec<Marker>>,
    data: Vec<Marker>,
    /// What the client asked for, with the numbers that it was given, to be placed again in another program.
    asked: BTreeMap<PathBuf, Vec<(i64, SourceBreakpoint)>>,
    asked_data: Vec<(i64, DataBreakpoint)>,
    ids: i64,
}

impl Table {
    /// These breakpoints in a file, in the place of those before. Returns what the protocol wants to know of each.
    pub(crate) fn set_in_file(
        &mut self,
        target: &Target,
        file: u32,
        wanted: Vec<SourceBreakpoint>,
        counting: Counting,
    ) -> Vec<Json> {
        let asked: Vec<_> = wanted.into_iter().map(|wanted| (self.new_id(), wanted)).collect();
        let reported = self.place_in_file(target, file, &asked, counting);
        self.asked.insert(target.source(file).path.clone(), asked);
        reported
    }

    fn new_id(&mut self) -> i64 {
        self.ids += 1;
        self.ids
    }

    fn place_in_file(
        &mut self,
        target: &Target,
        file: u32,
        asked: &[(i64, SourceBreakpoint)],
        counting: Counting,
    ) -> Vec<Json> {
        let mut markers = Vec::new();
        let mut reported = Vec::new();
        for (id, wanted) in asked {
            let line = counting.line(wanted.line);
            let column = wanted
                .column
                .filter(|_| target.source(file).is_ladder())
                .map(|column| counting.offset(target.source(file), line, column));
            let Some((breakpoint, location)) = place(target, file, line, column) else {
                reported.push(json!({
                    "id": id, "verified": false, "line": wanted.line,
                    "message": "there is no rung in this line or below it",
                }));
                continue;
            };
            let source = target.source(file);
            let mut shown = json!({"id": id, "verified": true, "source": source.json()});
            let range = counting.range(source, location.range);
            // A mark that nobody asked for within a line would move the drawing apart.
            let is_within = wanted.column.is_some() && matches!(breakpoint, Breakpoint::Block(_));
            for name in ["line", "column", "endLine", "endColumn"] {
                if is_within || name == "line" {
                    shown[name] = range[name].clone();
                }
            }
            match Marker::new(*id, breakpoint, target, Some(location), wanted) {
                Ok(marker) => markers.push(marker),
                Err(problem) => {
                    shown["verified"] = false.into();
                    shown["message"] = problem.into();
                }
            }
            reported.push(shown);
        }
        self.by_file.insert(file, markers);
        reported
    }

    /// These breakpoints on tags, in the place of those before.
    pub(crate) fn set_data(&mut self, target: &Target, wanted: Vec<DataBreakpoint>) -> Vec<Json> {
        let asked: Vec<_> = wanted.into_iter().map(|wanted| (self.new_id(), wanted)).collect();
        let reported = self.place_data(target, &asked);
        self.asked_data = asked;
        reported
    }

    fn place_data(&mut self, target: &Target, asked: &[(i64, DataBreakpoint)]) -> Vec<Json> {
        let mut markers = Vec::new();
        let mut reported = Vec::new();
        for (id, wanted) in asked {
            let next_to = SourceBreakpoint {
                condition: wanted.condition.clone(),
                hit_condition: wanted.hit_condition.clone(),
                ..SourceBreakpoint::default()
            };
            let point = target
                .simulation()
                .resolve(&wanted.data_id)
                .map_err(|unknown| unknown.message);
            let marker =
                point.and_then(|point| Marker::new(*id, Breakpoint::Change(point), target, None, &next_to));
            match marker {
                Ok(marker) => {
                    markers.push(marker);
                    reported.push(json!({"id": id, "verified": true}));
                }
                Err(problem) => reported.push(json!({"id": id, "verified": false, "message": problem})),
            }
        }
        self.data = markers;
        reported
    }

    /// The lines of a file are in other places: the breakpoints that were asked for go with them, to the next one below
    /// where one is no more.
    pub(crate) fn move_lines(
        &mut self,
        is_source: impl Fn(&Path) -> bool,
        lines: &[Option<u32>],
        counting: Counting,
    ) {
        for (path, asked) in &mut self.asked {
            if !is_source(path) {
                continue;
            }
            for (_, wanted) in asked {
                let after = lines.iter().skip(counting.line(wanted.line));
                if let Some(line) = after.flatten().next() {
                    wanted.line = counting.line_out(*line as usize);
                }
            }
        }
    }

    /// Places all of them in another program. Returns what has become of each.
    pub(crate) fn place_again(&mut self, target: &Target, counting: Counting) -> Vec<Json> {
        self.by_file.clear();
        let mut reported = Vec::new();
        for (path, asked) in std::mem::take(&mut self.asked) {
            if let Some(file) = target.file_of(&path) {
                reported.extend(self.place_in_file(target, file, &asked, counting));
            }
            self.asked.insert(path, asked);
        }
        let asked = std::mem::take(&mut self.asked_data);
        reported.extend(self.place_data(target, &asked));
        self.asked_data = asked;
        reported
    }

    fn all(&mut self) -> impl Iterator<Item = &mut Marker> {
        self.by_file.values_mut().flatten().chain(&mut self.data)
    }

    /// Tells the session where it is to stop.
    pub(crate) fn arm(&mut self, target: &mut Target) {
        target.session.clear_breakpoints();
        for marker in self.all() {
            target.session.add_breakpoint(marker.breakpoint.clone());
        }
    }

    /// What the breakpoints ask for that are met, with their numbers. Going back counts no hits and writes nothing.
    pub(crate) fn judge(&mut self, hit: &Hit, target: &Target, counts: bool) -> (Verdict, Vec<i64>) {
        let next = target.simulation().next_block();
        let is_met = |breakpoint: &Breakpoint| match (breakpoint, hit) {
            (Breakpoint::Network(network), Hit::Network(location)) => {
                target.simulation().program().networks[*network].location == *location
            }
            (Breakpoint::Block(block), Hit::Block(location)) => block == location,
            // Both are in front of the same instruction.
            (Breakpoint::Block(block), Hit::Network(_)) => next == Some(*block),
            (Breakpoint::Change(tag), Hit::Change { point, .. }) => tag.name == point.name,
            _ => false,
        };
        let mut ids = Vec::new();
        let mut logged = String::new();
        let mut remark = None;
        for marker in self.all().filter(|marker| is_met(&marker.breakpoint)) {
            match marker.judge(target, counts) {
                Verdict::Pass => {}
                Verdict::Log(line) => logged.push_str(&line),
                Verdict::Stop(problem) => {
                    ids.push(marker.id);
                    remark = remark.or(problem);
                }
            }
        }
        let verdict = match (ids.is_empty(), logged.is_empty()) {
            (false, _) => Verdict::Stop(remark),
            (true, false) => Verdict::Log(logged),
            (true, true) => Verdict::Pass,
        };
        (verdict, ids)
    }
}
