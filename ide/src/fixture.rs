//! Texts of tests: several files, a cursor, and how places are shown.

use crate::neighbour::{ScenarioFile, Which, Workspace};
use ladder_analysis::context::Context;
use ladder_analysis::{Analysis, AnalyzeOptions, Exported, analyze, exports};
use ladder_simulator::Simulation;
use ladder_simulator::scenario::{Watched, bind, run};
use ladder_syntax::{TextRange, TextSize, parse};
use std::sync::Arc;

/// The files of a workspace, the first of them the one that is asked about.
pub(crate) struct Fixture {
    pub(crate) files: Vec<(Arc<Analysis>, String)>,
    pub(crate) scenarios: Vec<(String, String)>,
    /// Where `$0` was, and in which file.
    pub(crate) cursor: Option<(usize, TextSize)>,
}

impl Fixture {
    /// Files begin with `%% name.clad`; a text without that is `main.clad`.
    pub(crate) fn new(text: &str) -> Fixture {
        let mut texts: Vec<(String, String)> = Vec::new();
        for line in text.split_inclusive('\n') {
            match line.strip_prefix("%% ") {
                Some(name) => texts.push((name.trim().to_owned(), String::new())),
                None => {
                    if texts.is_empty() {
                        texts.push(("main.clad".to_owned(), String::new()));
                    }
                    texts.last_mut().unwrap().1.push_str(line);
                }
            }
        }
        if texts.is_empty() {
            texts.push(("main.clad".to_owned(), String::new()));
        }
        let mut cursor = None;
        for (index, (_, text)) in texts.iter_mut().enumerate() {
            if let Some(at) = text.find("$0") {
                text.replace_range(at..at + 2, "");
                cursor = Some((index, TextSize::new(at as u32)));
            }
        }
        Fixture::of(texts, cursor)
    }

    /// A text that ends in `.ladder-test` is not a program: a line in it names the one that it is about.
    pub(crate) fn of(texts: Vec<(String, String)>, cursor: Option<(usize, TextSize)>) -> Fixture {
        let (scenarios, texts): (Vec<_>, Vec<_>) = texts
            .into_iter()
            .partition(|(name, _)| name.ends_with(".ladder-test"));
        let parses: Vec<_> = texts.iter().map(|(_, text)| Arc::new(parse(text))).collect();
        let exported = texts
            .iter()
            .zip(&parses)
            .map(|((name, _), parse)| Arc::new(exports(parse, name)));
        let exported = Arc::new(Exported::new(exported.collect()));
        let files = texts
            .into_iter()
            .zip(parses)
            .map(|((name, text), parse)| {
                let analysis = analyze(
                    &parse,
                    AnalyzeOptions::new(&name).among(&exported.others_of(&name)),
                );
                (Arc::new(analysis), text)
            })
            .collect();
        Fixture {
            files,
            scenarios,
            cursor,
        }
    }

    /// The file with the cursor, the offset in it, and the others.
    pub(crate) fn ask(&self) -> (&Context, TextSize, Others<'_>) {
        let (file, offset) = self.cursor.expect("a cursor");
        (&self.files[file].0.context, offset, self.others(file))
    }

    pub(crate) fn others(&self, own: usize) -> Others<'_> {
        Others { fixture: self, own }
    }

    pub(crate) fn text(&self, file: &str) -> &str {
        let mut files = self.files.iter();
        if let Some((_, text)) = files.find(|(analysis, _)| *analysis.context.name == *file) {
            return text;
        }
        if let Some(source) = ladder_analysis::library::source(file) {
            return source.text;
        }
        let mut scenarios = self.scenarios.iter();
        &scenarios.find(|(name, _)| name == file).unwrap().1
    }

    /// A place as `main.clad:3:7 run`: line and column from 1, and what is there.
    pub(crate) fn show(&self, file: &str, range: TextRange) -> String {
        let text = self.text(file);
        let before = &text[..usize::from(range.start())];
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap().chars().count() + 1;
        let what = &text[range].replace('\r', "");
        let what = match what.split_once('\n') {
            Some((first, rest)) => format!("{first} ... {}", rest.lines().last().unwrap_or_default()),
            None => what.clone(),
        };
        format!("{file}:{line}:{column} {}", what.trim_end())
    }
}

/// All files but one.
pub(crate) struct Others<'f> {
    fixture: &'f Fixture,
    own: usize,
}

impl Workspace for Others<'_> {
    fn file(&self, name: &str) -> Option<Arc<Context>> {
        let mut files = self.fixture.files.iter();
        let (analysis, _) = files.find(|(analysis, _)| *analysis.context.name == *name)?;
        Some(Arc::clone(&analysis.context))
    }

    fn show(&self, which: Which<'_>, look: &(dyn Fn(usize, &Arc<Context>) + Sync)) {
        // Nothing relies on their order.
        for (index, (analysis, text)) in self.fixture.files.iter().enumerate().rev() {
            if index != self.own && which.takes(|| text.into()) {
                look(index, &analysis.context);
            }
        }
    }

    fn scenarios(&self) -> Vec<ScenarioFile> {
        let file = |(name, text): &(String, String)| ScenarioFile {
            name: Arc::from(name.as_str()),
            program: text
                .lines()
                .find_map(|line| line.strip_prefix("program "))
                .map(Arc::from),
            text: text.clone(),
            suite: Arc::new(ladder_simulator::scenario::parse(text)),
        };
        self.fixture.scenarios.iter().map(file).collect()
    }
}

/// What comes of a program's scenarios: `ok` and the name of each, or what is wrong.
pub(crate) fn played(program: &str, scenarios: &str) -> String {
    let analysis = analyze(&Arc::new(parse(program)), "main.clad");
    let Some(program) = analysis.program() else {
        return format!("{:?}\n", analysis.diagnostics());
    };
    let suite = ladder_simulator::scenario::parse(scenarios);
    let options = ladder_simulator::Options::default();
    let mut simulation = Simulation::new(program.clone(), options).expect("it compiles");
    let (cases, errors) = bind(&suite, &simulation);
    let mut shown = String::new();
    for error in suite.errors.iter().chain(&errors) {
        shown.push_str(&format!("{}\n", error.message));
    }
    for case in &cases {
        let passed = run(case, &mut Watched::default(), &mut simulation, Simulation::scan).passed();
        shown.push_str(&format!(
            "{} {}\n",
            if passed { "ok" } else { "FAILED" },
            case.name
        ));
    }
    shown
}
