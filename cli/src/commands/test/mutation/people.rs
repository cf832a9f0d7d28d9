//! What came of the changes, for people: what no scenario notices, in the drawing, with a run that would show it; and the score.

use super::super::coverage::excerpt;
use super::fate::Fate;
use super::{Change, Mutated};
use anstyle::{AnsiColor, Style};
use ladder_simulator::scenario::LineKind;
use ladder_workspace::shown;
use std::io::{self, Write};

const BAD: Style = AnsiColor::Red.on_default().bold();
const UNSURE: Style = AnsiColor::Yellow.on_default();
const FAINT: Style = AnsiColor::BrightBlack.on_default();
const BOLD: Style = Style::new().bold();

/// See the module.
pub(in super::super) struct People<'m> {
    pub(in super::super) mutated: &'m [Mutated],
    pub(in super::super) colours: bool,
}

impl People<'_> {
    fn paint(&self, style: Style, text: &str) -> String {
        if self.colours {
            format!("{style}{text}{style:#}")
        } else {
            text.to_owned()
        }
    }

    /// Writes all of it.
    pub(in super::super) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let all = || {
            self.mutated
                .iter()
                .flat_map(|mutated| mutated.changes.iter().map(move |it| (mutated, it)))
        };
        if all().any(|(_, (_, fate))| matches!(fate, Fate::Missed(_))) {
            writeln!(out, "\n{}", self.paint(BOLD, "Changes that no scenario notices"))?;
            for (mutated, (change, fate)) in all() {
                if let Fate::Missed(run) = fate {
                    self.element(mutated, change, out)?;
                    for line in &run.drawing {
                        let style = match line.kind {
                            LineKind::Given => FAINT,
                            LineKind::Got => BOLD,
                            LineKind::Marks => BAD,
                            LineKind::Expected | LineKind::Sentence => Style::new(),
                        };
                        writeln!(out, "      {}", self.paint(style, &shown::line(&line.text)))?;
                    }
                }
            }
        }
        if all().any(|(_, (_, fate))| matches!(fate, Fate::Unknown(_))) {
            writeln!(
                out,
                "\n{}",
                self.paint(
                    BOLD,
                    "Changes of which it is not known whether they change anything"
                )
            )?;
            for (mutated, (change, fate)) in all() {
                if let Fate::Unknown(why) = fate {
                    self.element(mutated, change, out)?;
                    writeln!(out, "      {}", self.paint(UNSURE, &shown::line(why)))?;
                }
            }
        }
        self.scores(out)
    }

    /// The rung with the changed element marked, and what is in its place.
    fn element(&self, mutated: &Mutated, change: &Change, out: &mut dyn Write) -> io::Result<()> {
        let source = &mutated.subject.source;
        let found = excerpt(source, &mutated.place(change), &change.title);
        writeln!(out, "  {}\n    {}", found.title, found.rung)?;
        writeln!(out, "    {}", self.paint(BAD, &found.marks))?;
        let before: String = found.marks.chars().take_while(|c| *c != '^').collect();
        let after = change.after(source);
        writeln!(out, "    {before}{}", self.paint(BOLD, &shown::line(&after)))
    }

    /// A line for each program.
    fn scores(&self, out: &mut dyn Write) -> io::Result<()> {
        let headings = ["caught", "missed", "the same", "not known", "score", ""].map(str::to_owned);
        let mut rows: Vec<[String; 6]> = vec![headings];
        for mutated in self.mutated {
            let score = mutated.score();
            let percent = match (score.percent(), &mutated.subject.fails) {
                (_, Some(_)) => "-".to_owned(),
                (Some(percent), _) => format!("{percent} %"),
                (None, _) => "-".to_owned(),
            };
            let name = shown::line(&mutated.subject.source.file).into_owned();
            let counts =
                [score.caught, score.missed, score.same, score.unknown].map(|count| count.to_string());
            let [caught, missed, same, unknown] = counts;
            let fails = mutated.subject.fails.as_ref();
            let name = fails.map_or(name.clone(), |fails| {
                format!(
                    "{name}: nothing was changed, for \"{}\" fails as it is",
                    shown::line(fails)
                )
            });
            rows.push([caught, missed, same, unknown, percent, name]);
        }
        writeln!(out, "\n{}", self.paint(BOLD, "Mutation"))?;
        let width = |column: usize| rows.iter().map(|row| row[column].len()).max().unwrap_or(0);
        for row in &rows {
            let mut line = String::new();
            for (column, cell) in row.iter().take(5).enumerate() {
                line.push_str(&format!("  {cell:>0$}", width(column)));
            }
            let line = format!("{line}  {}", row[5]);
            writeln!(out, "{}", line.trim_end())?;
        }
        Ok(())
    }
}
