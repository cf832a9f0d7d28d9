//! A program that passes have rewritten for a system that lacks something, and where its parts come from.

use crate::{Entry, LineColumn, Lines, Outcome, Report};
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

/// Where the parts of a rewritten program come from.
struct From {
    /// The text of the program itself.
    first: Rc<Text>,
    /// The rewritten text, and for each part of it where it was in the first.
    written: WrittenProgram,
    lines: Lines,
}

/// A program on its way through the passes.
pub(crate) struct Rewritten {
    pub(crate) analysis: Analysis,
    /// None: nothing is rewritten.
    from: Option<From>,
    /// What passes report, at places of the program itself, and of what was added of other files, with its number.
    report: Report,
    of_others: Vec<(usize, Entry)>,
}

impl Rewritten {
    /// The program itself.
    pub(crate) fn of(analysis: &Analysis) -> Rewritten {
        Rewritten {
            analysis: analysis.clone(),
            from: None,
            report: Report::default(),
            of_others: Vec::new(),
        }
    }

    /// Another program in its place. The origins of the sketch are offsets in the program before it, or [`ADDED`].
    pub(crate) fn with(&self, sketch: &ProgramSketch) -> Rewritten {
        let mut written = sketch.write(&Options::default());
        let context = &self.analysis.context;
        let options = AnalyzeOptions::new(&context.name).among(&context.others);
        let first = match &self.from {
            None => {
                let text = context.parse.to_string();
                let lines = Lines::of(&text);
                Rc::new(Text { text, lines })
            }
            Some(before) => {
                written.places.retain_mut(|(_, origin)| {
                    if *origin < ADDED {
                        let Some(before) = before.written.origin_around(TextSize::new(*origin)) else {
                            return false;
                        };
                        *origin = before;
                    }
                    true
                });
                Rc::clone(&before.first)
            }
        };
        let lines = Lines::of(&written.text);
        Rewritten {
            analysis: analyze(&parse(&written.text).into(), options),
            from: Some(From {
                first,
                written,
                lines,
            }),
            report: self.report.clone(),
            of_others: self.of_others.clone(),
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
        after.of_others = self.restore(&mut report);
        after.report = report;
        after
    }

    /// Makes the places of a report on the rewritten program those of the program, and adds what passes report. What is about parts
    /// of other files comes back, with their numbers. Of what passes made only that stays which has no counterpart.
    pub(crate) fn restore(&self, report: &mut Report) -> Vec<(usize, Entry)> {
        let mut of_others = self.of_others.clone();
        let Some(from) = &self.from else {
            return of_others;
        };
        report.entries.retain_mut(|entry| match from.source(entry.place) {
            Source::Own(place) => {
                entry.place = place;
                true
            }
            Source::Added(number) => {
                of_others.push((number, entry.clone()));
                false
            }
            Source::Pass => {
                entry.place = LineColumn::START;
                matches!(entry.outcome, Outcome::Refused(_))
            }
        });
        report.entries.extend(self.report.entries.iter().cloned());
        report.entries.sort_by_key(|entry| entry.place);
        report.entries.dedup();
        of_others
    }
}

impl From {
    /// Where a place of the rewritten text comes from.
    fn source(&self, place: LineColumn) -> Source {
        let From {
            first,
            written,
            lines,
        } = self;
        let at = TextSize::new(lines.offset(&written.text, place) as u32);
        let of = |origin: Origin, own: &dyn Fn(Origin) -> LineColumn| match origin.checked_sub(ADDED) {
            Some(number) => Source::Added(number as usize),
            None => Source::Own(own(origin)),
        };
        let place_of = |origin: Origin| first.lines.place(&first.text, origin as usize);
        if let Some((range, origin)) = written.place_around(at) {
            return of(origin, &|origin| {
                // As far into it as there, where that is spelled the same.
                let into = usize::from(at - range.start());
                let is_same = written.text[range].get(..into) == first.text[origin as usize..].get(..into);
                place_of(if is_same { origin + into as Origin } else { origin })
            });
        }
        // Next to something on its line.
        let line = line_around(&written.text, at);
        match written.first_in(line) {
            Some(origin) => of(origin, &|origin| LineColumn {
                column: place.column,
                ..place_of(origin)
            }),
            None => Source::Pass,
        }
    }
}

/// The networks of the file itself, and the number of each. None: the program has errors.
pub(crate) fn own_networks(analysis: &Analysis) -> Option<Vec<(&Network, usize)>> {
    let numbers: HashMap<TextSize, usize> = (analysis.context.networks.iter())
        .map(|network| (network.range.start(), network.index))
        .collect();
    let networks = analysis.program()?.networks.iter();
    let own = networks.filter(|network| network.location.file == 0);
    own.map(|network| Some((network, *numbers.get(&network.location.range.start())?)))
        .collect()
}
