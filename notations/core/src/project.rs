//! The files of a folder as one program, for systems that have a whole project in one file.
//!
//! What belongs to no other file stays as it is; where two files have a name for different things, those of the second get another
//! one. What runs first in a file that another one calls nothing of is a function of its own.

use crate::elements::{change, is_comment, rename, rung};
use crate::functions::taken_out;
use crate::whole::{called_name, declaration, is_shared};
use crate::{LineColumn, Lines, Names, ProjectTask, Report, WriteError};
use ladder_analysis::context::{Body, Callee, Context};
use ladder_analysis::{Analysis, AnalyzeOptions, Exported, analyze, exports, link_files};
use ladder_format::Options;
use ladder_format::program::{Block, Drawing, Item, Origin, ProgramSketch, RungPiece, WrittenProgram};
use ladder_instructions::Op;
use ladder_syntax::{Name, TextSize, parse};
use std::collections::HashMap;
use std::sync::Arc;

/// The files of a folder, and the one program that they are.
#[derive(Debug)]
pub struct Project {
    /// The program.
    pub analysis: Analysis,
    /// The files. The first is the one whose networks run the others.
    files: Vec<File>,
    /// The file of each function, and what it is called there.
    functions: HashMap<Name, (usize, String)>,
    /// The file of each tag that only its file sees, and what it is called there.
    tags: HashMap<Name, (usize, String)>,
    /// The tasks that run the files; none: each runs in each scan.
    tasks: Vec<ProjectTask>,
    /// The files, each among the others.
    analyses: Vec<Arc<Analysis>>,
    written: WrittenProgram,
    lines: Lines,
}

/// A file of a project.
#[derive(Debug)]
struct File {
    name: String,
    text: String,
    /// What the folder has, where that is not ladder text: the text is what it becomes.
    written: Option<String>,
    lines: Lines,
    /// Where its origins begin.
    first: Origin,
    /// The function that its networks outside of functions are in the program; none: they are the first to run, or there are none.
    main: Option<Name>,
}

impl Project {
    /// The project of some files, each with its name in the folder and its ladder text, and of the tasks that run them.
    ///
    /// # Errors
    ///
    /// If one has errors, or they cannot be one program: they count and time in different ways, or two declare a block, a type or a global
    /// of one name.
    pub fn of(files: &[(String, String)], tasks: &[ProjectTask]) -> Result<Project, WriteError> {
        let analyses = analysed(files)?;
        let order = order(&analyses);
        let mut project = Project {
            analysis: Analysis::clone(&analyses[order[0]]),
            files: Vec::new(),
            functions: HashMap::new(),
            tags: HashMap::new(),
            tasks: tasks.to_vec(),
            analyses: Vec::new(),
            written: WrittenProgram::default(),
            lines: Lines::of(""),
        };
        let mut first = 0;
        for number in &order {
            let (name, text) = &files[*number];
            project.files.push(File {
                name: name.clone(),
                text: text.clone(),
                written: None,
                lines: Lines::of(text),
                first,
                main: None,
            });
            first += text.len() as Origin + 1;
        }
        let ordered: Vec<Arc<Analysis>> = order
            .iter()
            .map(|number| Arc::clone(&analyses[*number]))
            .collect();
        let sketch = ProgramSketch {
            items: project.joined(&ordered),
        };
        project.analyses = ordered;
        project.written = sketch.write(&Options::default());
        project.lines = Lines::of(&project.written.text);
        let stem = project.stem(0).to_owned();
        project.analysis = analyze(&parse(&project.written.text).into(), AnalyzeOptions::new(&stem));
        if let Some(error) = project.analysis.errors().next() {
            let place = project
                .lines
                .place(&project.written.text, error.range.start().into());
            let (file, place) = project.locate(place);
            return Err(WriteError::new(format!(
                "{}:{place}: among the other files as one program: {}",
                project.files[file].name, error.message
            )));
        }
        Ok(project)
    }

    /// The tasks, in the order in which those run that are due together. None: each file runs in each scan.
    pub fn tasks(&self) -> &[ProjectTask] {
        &self.tasks
    }

    /// The file of this name.
    pub fn number_of(&self, name: &str) -> Option<usize> {
        self.files.iter().position(|file| file.name == name)
    }

    /// How many files there are.
    pub fn count(&self) -> usize {
        self.files.len()
    }

    /// A file with what it uses of the others.
    ///
    /// # Errors
    ///
    /// If that has errors.
    pub fn linked(&self, number: usize) -> Result<Analysis, WriteError> {
        let analysis = &self.analyses[number];
        let by_name = |name: &str| {
            self.analyses
                .iter()
                .find(|file| &*file.context.name == name)
                .cloned()
        };
        let linked = link_files(analysis, &by_name);
        let linked = linked.map_err(|_| WriteError::new(format!("{}: it has errors", self.file(number))))?;
        Ok(analysis.with_others(linked))
    }

    /// A file among the others.
    pub fn analysis_of(&self, number: usize) -> &Analysis {
        &self.analyses[number]
    }

    /// The text of a file of the folder, where that is not ladder text.
    pub fn written(&self, number: usize) -> Option<&str> {
        self.files[number].written.as_deref()
    }

    /// Says of files what the folder has, where that is not ladder text.
    pub(crate) fn keep_written(&mut self, files: &[(String, String)]) {
        for file in &mut self.files {
            let there = files.iter().find(|(name, _)| *name == file.name);
            file.written = there
                .map(|(_, text)| text.clone())
                .filter(|text| *text != file.text);
        }
    }

    /// What a file is called in its folder.
    pub fn file(&self, number: usize) -> &str {
        &self.files[number].name
    }

    /// The same without folders and ending: what a person calls the program in it.
    pub fn stem(&self, number: usize) -> &str {
        let name = &self.files[number].name;
        let name = name.rsplit(['/', '\\']).next().unwrap_or_default();
        name.rsplit_once('.').map_or(name, |(stem, _)| stem)
    }

    /// The file of a function, and what it is called there.
    pub fn home_of_function(&self, name: &str) -> Option<(usize, &str)> {
        let home = self.functions.get(&Name::new(name));
        home.map(|(file, own)| (*file, own.as_str()))
    }

    /// The file of a tag, if it is the file's own, and what it is called there.
    pub fn home_of_tag(&self, name: &str) -> Option<(usize, &str)> {
        let home = self.tags.get(&Name::new(name));
        home.map(|(file, own)| (*file, own.as_str()))
    }

    /// The function that stands for what runs first in a file, but for the first one.
    pub fn main(&self, number: usize) -> Option<&Name> {
        self.files[number].main.as_ref()
    }

    /// Where a place of the program is: the file, and the place in it.
    pub fn locate(&self, place: LineColumn) -> (usize, LineColumn) {
        let at = TextSize::new(self.lines.offset(&self.written.text, place) as u32);
        let origin = self.written.origin_at(at).unwrap_or_default();
        let number = self.files.partition_point(|file| file.first <= origin).max(1) - 1;
        let file = &self.files[number];
        let place = file.lines.place(&file.text, (origin - file.first) as usize);
        (number, place)
    }

    /// A report about the program as one for each file, with the places in it.
    pub fn reports(&self, report: &Report) -> Vec<Report> {
        let mut reports = vec![Report::default(); self.files.len()];
        for entry in &report.entries {
            let (file, place) = match entry.place {
                LineColumn::START => (0, entry.place),
                place => self.locate(place),
            };
            let mut entry = entry.clone();
            entry.place = place;
            reports[file].entries.push(entry);
        }
        reports
    }

    /// All files as one list of items.
    fn joined(&mut self, analyses: &[Arc<Analysis>]) -> Vec<Item> {
        let (mut called, mut tags) = (Names::default(), Names::default());
        let functions: Vec<Vec<String>> = analyses
            .iter()
            .map(|analysis| {
                let functions = analysis.context.functions.iter();
                functions.map(|function| called.fresh(&function.name)).collect()
            })
            .collect();
        let by_file: HashMap<&str, usize> = analyses
            .iter()
            .enumerate()
            .map(|(number, file)| (&*file.context.name, number))
            .collect();
        let (mut main, mut others, mut bodies) = (Vec::new(), Vec::new(), Vec::new());
        for (number, analysis) in analyses.iter().enumerate() {
            let context = &analysis.context;
            for (name, own) in functions[number].iter().zip(&context.functions) {
                self.functions
                    .insert(Name::new(name), (number, own.name.to_string()));
            }
            let mut renamed = HashMap::new();
            let mut is_declared_elsewhere = false;
            for tag in &context.scopes[0].tags {
                if tag.name.starts_with('%') || tag.name.eq_ignore_ascii_case("SYS") {
                    continue;
                }
                if is_shared(context, tag) {
                    is_declared_elsewhere |= tag.cold.foreign.is_some();
                    continue;
                }
                let name = tags.fresh(&tag.name);
                self.tags.insert(Name::new(&name), (number, tag.name.to_string()));
                if *name != *tag.name {
                    renamed.insert(Name::new(&tag.name), name);
                }
            }
            let (mut items, own) = taken_out(context);
            if is_declared_elsewhere || !renamed.is_empty() {
                items = declared_again(context, items, &renamed);
            }
            let name_of = |name: &str| match context.callee(&Name::new(name))? {
                Callee::Own(function) => Some(&functions[number][function]),
                Callee::Other(import) => functions[*by_file.get(&*import.file)?].get(import.item),
            };
            let as_here = |items: &mut Vec<Item>| {
                shift(items, self.files[number].first);
                let mut networks: Vec<Item> = std::mem::take(items);
                for item in networks
                    .iter_mut()
                    .filter(|item| matches!(item, Item::Network(_)))
                {
                    change(std::slice::from_mut(item), &mut |_, block| {
                        rename(block, &renamed);
                        if let Some(name) = called_name(block).and_then(name_of) {
                            *block = match block.op() {
                                Some(Op::Fun) => Block::function(name),
                                _ => Block::call(name),
                            };
                        }
                    });
                }
                *items = networks;
            };
            as_here(&mut items);
            let own = own.into_values().map(|mut body| {
                as_here(&mut body);
                body
            });
            let own: Vec<Vec<Item>> = own.collect();
            if number == 0 {
                main = items;
            } else {
                items.retain(|item| !is_for_the_file(item));
                if items.iter().any(|item| matches!(item, Item::Network(_))) {
                    let stem = self.stem(number).to_owned();
                    let name = called.fresh(&stem);
                    self.functions.insert(Name::new(&name), (number, stem));
                    self.files[number].main = Some(Name::new(&name));
                    let (networks, rest) = parted(items);
                    others.extend(rest);
                    let first = self.files[number].first;
                    bodies.extend([Item::Blank, rung([Block::function(&name)], Some(first))]);
                    bodies.extend(networks);
                } else {
                    others.append(&mut items);
                }
            }
            for body in own {
                bodies.push(Item::Blank);
                bodies.extend(body);
            }
        }
        main.extend(others);
        main.extend(bodies);
        main
    }
}

/// The files among each other.
fn analysed(files: &[(String, String)]) -> Result<Vec<Arc<Analysis>>, WriteError> {
    let parsed: Vec<_> = files.iter().map(|(_, text)| Arc::new(parse(text))).collect();
    let all = parsed
        .iter()
        .zip(files)
        .map(|(parse, (name, _))| Arc::new(exports(parse, name)));
    let exported = Arc::new(Exported::new(all.collect()));
    let mut analyses: Vec<Arc<Analysis>> = Vec::new();
    for (parse, (name, _)) in parsed.iter().zip(files) {
        let others = exported.others_of(name);
        let analysis = analyze(parse, AnalyzeOptions::new(name).among(&others));
        if let Some(error) = analysis.errors().next() {
            let place = Lines::of(&files[analyses.len()].1)
                .place(&files[analyses.len()].1, error.range.start().into());
            return Err(WriteError::new(format!("{name}:{place}: {}", error.message)));
        }
        if let Some(first) = analyses.first()
            && first.context.profile != analysis.context.profile
        {
            return Err(WriteError::new(format!(
                "{name} has the profile {}, and {} the profile {}: what is written counts and times in one way; give all files one profile",
                analysis.context.profile.name(),
                first.context.name,
                first.context.profile.name(),
            )));
        }
        analyses.push(Arc::new(analysis));
    }
    if analyses.is_empty() {
        return Err(WriteError::new("there are no programs"));
    }
    Ok(analyses)
}

/// The files in their order, first the one that runs the others: that calls functions of other files, else the first with networks of its own.
fn order(analyses: &[Arc<Analysis>]) -> Vec<usize> {
    let rank = |context: &Context| {
        let mut main = context
            .networks
            .iter()
            .filter(|network| context.bodies[network.index] == Body::Main);
        let is_main = main.clone().next().is_some();
        let calls = main.any(|network| {
            network.blocks().any(|block| {
                matches!(
                    crate::whole::used_by(context, block),
                    Some(crate::whole::Used::Function(Callee::Other(_)))
                )
            })
        });
        match (calls, is_main) {
            (true, _) => 0,
            (_, true) => 1,
            _ => 2,
        }
    };
    let mut order: Vec<usize> = (0..analyses.len()).collect();
    let first = order
        .iter()
        .copied()
        .min_by_key(|number| rank(&analyses[*number].context));
    if let Some(first) = first {
        order.retain(|number| *number != first);
        order.insert(0, first);
    }
    order
}

/// A comment that tells the tools about its file.
fn is_for_the_file(item: &Item) -> bool {
    let told = match item {
        Item::Kept(line, _) if is_comment(item) => line.trim_start_matches(['#', ' ']),
        _ => return false,
    };
    ["ladder: profile", "ladder: cycle", "ladder: allow-file"]
        .iter()
        .any(|begin| told.starts_with(begin))
}

/// The networks with what is above them, and all else.
fn parted(items: Vec<Item>) -> (Vec<Item>, Vec<Item>) {
    let (mut networks, mut rest, mut above) = (Vec::new(), Vec::new(), Vec::new());
    for item in items {
        match &item {
            Item::Network(_) => {
                networks.append(&mut above);
                networks.push(item);
            }
            Item::Blank | Item::Comment(_) | Item::Directive(_) => above.push(item),
            Item::Kept(..) if is_comment(&item) => above.push(item),
            _ => {
                rest.append(&mut above);
                rest.push(item);
            }
        }
    }
    rest.append(&mut above);
    (networks, rest)
}

/// The items with other declarations: under other names, and without those of what another file declares.
fn declared_again(context: &Context, items: Vec<Item>, renamed: &HashMap<Name, String>) -> Vec<Item> {
    let structure = context.parse.structure();
    let lines = context.parse.lines();
    let is_of_tags = |section: &&ladder_syntax::Section| {
        let text = lines[section.lines.start].text().trim_start();
        section.block.is_none()
            && text
                .get(..3)
                .is_some_and(|begin| begin.eq_ignore_ascii_case("VAR"))
    };
    let sections: Vec<_> = structure
        .sections
        .iter()
        .filter(is_of_tags)
        .map(|section| section.lines.clone())
        .collect();
    let is_declaration = |item: &Item| match item {
        Item::Kept(_, origin) => {
            let line = context.parse.line_at(TextSize::new(*origin));
            line.is_some_and(|line| sections.iter().any(|section| section.contains(&line)))
        }
        _ => false,
    };
    let own = context.scopes[0].tags.iter();
    let own = own.filter(|tag| tag.is_declared() && tag.cold.foreign.is_none());
    let mut declarations = own.filter_map(|tag| {
        let name = renamed
            .get(&Name::new(&tag.name))
            .map_or(&*tag.name, String::as_str);
        declaration(context, tag, name, Some(context.place_of(tag).start().into()))
    });
    let mut out: Vec<Item> = Vec::new();
    let mut has_declared = false;
    for item in items {
        if is_declaration(&item) {
            if !has_declared {
                out.extend(declarations.by_ref());
                has_declared = true;
            }
        } else {
            out.push(item);
        }
    }
    out
}

/// Sets the origins of items to those of all files.
fn shift(items: &mut [Item], by: Origin) {
    for item in items {
        match item {
            Item::Kept(_, origin) => *origin += by,
            Item::Block { origin, items, .. } => {
                *origin = origin.map(|origin| origin + by);
                shift(items, by);
            }
            Item::Section(section) => {
                for declaration in &mut section.declarations {
                    declaration.origin = declaration.origin.map(|origin| origin + by);
                }
            }
            Item::Network(network) => {
                if let Drawing::Rungs(rungs) = &mut network.drawing {
                    for piece in rungs.iter_mut().flatten() {
                        if let RungPiece::Element(element) = piece {
                            element.origin = element.origin.map(|origin| origin + by);
                        }
                    }
                }
            }
            _ => {}
        }
    }
}
