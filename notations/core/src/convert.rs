//! From a file of another system to ladder text.

use super::encoding::in_utf8;
use super::file_name::file_name;
use super::functions::again::functions_again;
use super::loops::again::loops_again;
use super::system::again::system_tags_again;
use super::tasks::task_settings;
use super::{
    Companion, Content, Finding, LineColumn, Notation, ProjectFile, ProjectTask, ReadError, Reading, Report,
    Source,
};
use ladder_format::program::{Item, ProgramSketch, WrittenProgram};
use ladder_syntax::TextSize;
use std::borrow::Cow;
use std::collections::HashSet;
use std::ops::Range;

/// The rule about comments that switch off what is not found.
pub(super) const UNUSED: &str = "suppression-unused";

/// A foreign program as ladder text.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Converted {
    /// The text, and the places in it that were made from something.
    pub written: WrittenProgram,
    /// Where in the foreign file that something is.
    pub places: Vec<LineColumn>,
    /// See [`Reading::names`]; in their order.
    pub names: Vec<(LineColumn, String)>,
    /// What became of each element.
    pub report: Report,
    /// What the other system itself would complain about.
    pub findings: Vec<Finding>,
    /// The files of a project, for a folder; empty: the program is one file.
    pub files: Vec<Companion>,
    /// The tasks that run its programs, which the settings among the files have.
    pub tasks: Vec<ProjectTask>,
    /// See [`Reading::exact_in_files`].
    pub exact_in_files: Vec<(LineColumn, String)>,
}

impl Converted {
    /// The place of the foreign file that the text at an offset was made from; its beginning if it was made from
    /// nothing.
    pub fn place_of(&self, offset: TextSize) -> LineColumn {
        self.written
            .origin_at(offset)
            .and_then(|origin| self.places.get(origin as usize).copied())
            .unwrap_or(LineColumn::START)
    }
}

/// Reads a foreign program and writes it as ladder text.
///
/// # Errors
///
/// As [`Notation::read`].
pub fn convert(
    notation: &dyn Notation,
    source: &Source<'_>,
    options: &ladder_format::Options,
) -> Result<Converted, ReadError> {
    let Reading {
        mut program,
        places,
        mut names,
        report,
        findings,
        mut files,
        exact_in_files,
    } = match in_utf8(source.bytes) {
        Cow::Borrowed(_) => notation.read(source)?,
        Cow::Owned(bytes) => notation.read(&Source {
            bytes: &bytes,
            ..source.clone()
        })?,
    };
    functions_again(&mut [&mut program]);
    functions_again(&mut programs(&mut files).collect::<Vec<_>>());
    loops_again(&mut program.items);
    system_tags_again(&mut program, notation);
    programs(&mut files).for_each(|program| loops_again(&mut program.items));
    files.retain(|file| !matches!(&file.content, Content::Program(program) if program.items.is_empty()));
    let mut written = program.write(options);
    let idle = idle_directives(&program, &written.text);
    if are_among_others(&program, &idle) {
        idle.iter()
            .rev()
            .for_each(|(_, line)| cut(&mut written, line.clone()));
    } else if !idle.is_empty() {
        let mut number = 0;
        program.items.retain(|_| {
            number += 1;
            idle.iter().all(|(item, _)| item + 1 != number)
        });
        written = program.write(options);
    }
    names.sort_by_key(|(place, _)| *place);
    let mut taken = HashSet::new();
    let mut tasks = Vec::new();
    let files = files.into_iter().map(|file| Companion {
        name: file_name(&file.name, &mut taken),
        bytes: match file.content {
            Content::Program(program) => program.write(options).text.into(),
            Content::Text(text) => text.into(),
            Content::Settings(text, all) => {
                tasks = all;
                (text + &task_settings(&tasks)).into()
            }
        },
    });
    Ok(Converted {
        files: files.collect(),
        tasks,
        exact_in_files,
        written,
        places,
        names,
        report,
        findings,
    })
}

fn programs(files: &mut [ProjectFile]) -> impl Iterator<Item = &mut ProgramSketch> {
    files.iter_mut().filter_map(|file| match &mut file.content {
        Content::Program(program) => Some(program),
        Content::Text(_) | Content::Settings(..) => None,
    })
}

/// The importer's comments that switch off what is not found: a finding about them would be one about a line that nobody
/// wrote. Each as an item, and as a line of the text.
fn idle_directives(program: &ProgramSketch, text: &str) -> Vec<(usize, Range<usize>)> {
    let is_allow = |item: &Item| matches!(item, Item::Directive(told) if told.starts_with("allow"));
    if !program.items.iter().any(is_allow) {
        return Vec::new();
    }
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "");
    let found = analysis.diagnostics().iter();
    let idle: HashSet<usize> = found
        .filter(|found| found.rule.name() == UNUSED)
        .map(|found| usize::from(found.range.start()))
        .collect();
    let mut at = 0;
    let mut out = Vec::new();
    for (number, item) in program.items.iter().enumerate() {
        let Item::Directive(told) = item else { continue };
        let comment = format!("# ladder: {told} #");
        let Some(start) = text[at..].find(&comment).map(|start| at + start) else {
            continue;
        };
        at = start + comment.len();
        if idle.contains(&start) {
            let end = text[at..].find('\n').map_or(text.len(), |end| at + end + 1);
            out.push((number, start..end));
        }
    }
    out
}

/// Whether only lines are missing without them: they follow a directive that stays. Else blank lines may go, too.
fn are_among_others(program: &ProgramSketch, idle: &[(usize, Range<usize>)]) -> bool {
    let items = program.items.iter();
    let head = items
        .take_while(|item| matches!(item, Item::Directive(_)))
        .count();
    !idle.is_empty() && idle.iter().all(|(item, _)| (1..head).contains(item))
}

/// Takes a line out of a text.
fn cut(written: &mut WrittenProgram, line: Range<usize>) {
    let length = TextSize::new(line.len() as u32);
    for (place, _) in &mut written.places {
        if usize::from(place.start()) >= line.end {
            *place -= length;
        }
    }
    written.text.replace_range(line, "");
}

#[cfg(test)]
mod tests {
    use super::*;
    use ladder_format::Circuit;
    use ladder_format::program::{Block, Drawing, Element, Network, Path};

    #[test]
    fn without_a_line_the_text_is_as_if_it_had_not_been_written() {
        let program = |directives: &[&str]| {
            let directives = directives.iter().map(|told| Item::Directive((*told).to_owned()));
            let coil = Circuit::Element(Element::of(Block::coil(Path::tag("y")), Some(3)));
            let network = Network {
                comments: vec!["a lamp".to_owned()],
                drawing: Drawing::Circuit(Circuit::Series(vec![coil])),
            };
            let items = directives.chain([Item::Blank, Item::Network(network)]);
            ProgramSketch {
                items: items.collect(),
            }
        };
        let all = program(&["profile iec", "allow-file(never-read): why", "cycle 10ms"]);
        let options = ladder_format::Options::default();
        let mut written = all.write(&options);
        let idle = idle_directives(&all, &written.text);
        assert!(are_among_others(&all, &idle), "{idle:?}");
        for (_, line) in idle {
            cut(&mut written, line);
        }
        assert_eq!(written, program(&["profile iec", "cycle 10ms"]).write(&options));
    }
}
