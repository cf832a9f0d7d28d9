//! A program that passes have rewritten for a system that lacks something, and where its parts come from.

use crate::{Entry, LineColumn, Lines, Outcome, Report};
use ladder_analysis::context::Body;
use ladder_analysis::program::Network;
use ladder_analysis::{Analysis, AnalyzeOptions, analyze};
use ladder_format::Options;
use ladder_format::program::{Origin, ProgramSketch, WrittenProgram};
use ladder_syntax::{TextSize, line_around, parse};
use std::collections::HashMap;
use std::rc::Rc;

/// What is added of other files has origins from here on: no text is so large.
pub(crate) const ADDED: Origin = 1 << 31;

/// Where a place of a rewritten program comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Source {
    /// The program itself.
    Own(LineColumn),
    /// What was added of other files, by its number.
    Added(usize),
    /// A pass: the program has nothing like it.
    Pass,
}

/// A text, and where its lines begin.
struct Text {
    text: String,
    lines: Lines,
}

impl Text {
    fn of(text: String) -> Text {
        let lines = Lines::of(&text);
        Text { text, lines }
    }
}

/// A program on its way through the passes.
pub(crate) struct Rewritten {
    pub(crate) analysis: Analysis,
    text: Text,
    /// The text of the program itself, and for each part of the rewritten text where it was there. None: nothing is rewritten.
    from: Option<(Rc<Text>, WrittenProgram)>,
    /// What passes report, at places of the program itself.
    report: Report,
}

impl Rewritten {
    /// The program itself.
    pub(crate) fn of(analysis: &Analysis) -> Rewritten {
        Rewritten {
            analysis: analysis.clone(),
            text: Text::of(analysis.context.parse.to_string()),
            from: None,
            report: Report::default(),
        }
    }

    /// Another program in its place. The origins of the sketch are offsets in the program before it, or [`ADDED`].
    pub(crate) fn with(&self, sketch: &ProgramSketch) -> Rewritten {
        let mut written = sketch.write(&Options::default());
        let context = &self.analysis.context;
        let options = AnalyzeOptions::new(&context.name).among(&context.others);
        let first = match &self.from {
            None => Rc::new(Text::of(self.text.text.clone())),
            Some((first, before)) => {
                written.places.retain_mut(|(_, origin)| {
                    if *origin < ADDED {
                        let Some(before) = before.origin_around(TextSize::new(*origin)) else {
                            return false;
                        };
                        *origin = before;
                    }
                    true
                });
                Rc::clone(first)
            }
        };
        Rewritten {
            analysis: analyze(&parse(&written.text).into(), options),
            text: Text::of(written.text.clone()),
            from: Some((first, written)),
            report: self.report.clone(),
        }
    }

    /// The program after a pass. It stays as it is where the pass has nothing to do, or makes something with an error.
    pub(crate) fn after(
        self,
        pass: impl FnOnce(&Analysis, &mut Report) -> Option<ProgramSketch>,
    ) -> Rewritten {
        let mut report = Report::default();
        let Some(sketch) = pass(&self.analysis, &mut report) else {
            return self;
        };
        let mut after = self.with(&sketch);
        if after.analysis.program().is_none() {
            return self;
        }
        self.restore(&mut report);
        after.report = report;
        after
    }

    /// Where a place of the rewritten text comes from.
    fn source(&self, place: LineColumn) -> Source {
        let Some((first, written)) = &self.from else {
            return Source::Own(place);
        };
        let at = TextSize::new(self.text.lines.offset(&self.text.text, place) as u32);
        let own = |origin: Origin| first.lines.place(&first.text, origin as usize);
        match written.place_around(at) {
            Some((_, origin)) if origin >= ADDED => return Source::Added((origin - ADDED) as usize),
            Some((range, origin)) => {
                // As far into it as there, where that is spelled the same.
                let into = usize::from(at - range.start());
                let is_same = self.text.text[range].get(..into) == first.text[origin as usize..].get(..into);
                return Source::Own(own(if is_same { origin + into as Origin } else { origin }));
            }
            None => {}
        }
        // Next to something on its line.
        let line = line_around(&self.text.text, at);
        let mut near = written
            .places
            .iter()
            .filter(|(range, _)| line.contains_range(*range));
        match near.next() {
            Some((_, origin)) if *origin >= ADDED => Source::Added((origin - ADDED) as usize),
            Some((_, origin)) => Source::Own(LineColumn {
                column: place.column,
                ..own(*origin)
            }),
            None => Source::Pass,
        }
    }

    /// Makes the places of a report on the rewritten program those of the program, and adds what passes report. What is about parts
    /// of other files comes back, with their numbers. Of what passes made only that stays which has no counterpart.
    pub(crate) fn restore(&self, report: &mut Report) -> Vec<(usize, Entry)> {
        let mut added = Vec::new();
        report.entries.retain_mut(|entry| match self.source(entry.place) {
            Source::Own(place) => {
                entry.place = place;
                true
            }
            Source::Added(number) => {
                added.push((number, entry.clone()));
                false
            }
            Source::Pass => {
                entry.place = LineColumn::START;
                matches!(entry.outcome, Outcome::Refused(_))
            }
        });
        report.entries.extend(self.report.entries.iter().cloned());
        report.entries.sort_by_key(|entry| entry.place);
        if self.from.is_some() {
            report.entries.dedup();
        }
        added
    }
}

/// The networks of the file itself, and what each is in. None: the program has errors.
pub(crate) fn own_networks(analysis: &Analysis) -> Option<Vec<(&Network, Body)>> {
    let context = &analysis.context;
    let bodies: HashMap<TextSize, Body> = (context.networks.iter())
        .map(|network| (network.range.start(), context.bodies[network.index]))
        .collect();
    let networks = analysis.program()?.networks.iter();
    let own = networks.filter(|network| network.location.file == 0);
    own.map(|network| Some((network, *bodies.get(&network.location.range.start())?)))
        .collect()
}
