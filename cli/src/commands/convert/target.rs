//! Which programs are meant, and where each of them goes.

use crate::findings::FOREIGN;
use crate::form::{self, Form};
use crate::outcome::{Failure, Outcome};
use ladder_notations::{Companion, NOTATIONS, Reach, has_extension};
use ladder_workspace::{find_files, is_ladder_text, read_bytes, shown};
use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

/// One program to translate.
pub(super) struct Job {
    pub(super) input: PathBuf,
    pub(super) bytes: Vec<u8>,
    pub(super) from: Form,
    pub(super) to: Form,
    /// None: stdout.
    pub(super) output: Option<PathBuf>,
    /// Where the files of a project go, if it is one.
    pub(super) folder: Option<PathBuf>,
    /// The folder that was named for the output: nothing is written outside of it.
    pub(super) root: PathBuf,
    /// Whether it is one of several.
    is_one_of_several: bool,
}

impl Job {
    /// The file itself, if it is a project that goes into a folder: what is not read of it is there when that becomes one file again.
    pub(super) fn original(&self) -> Option<Companion> {
        let Form::Foreign(notation) = self.from else {
            return None;
        };
        let folder = self.folder.as_ref()?;
        // Of several in one folder none would be the one.
        let is_alone = !self.is_one_of_several
            || self
                .output
                .as_ref()
                .is_some_and(|output| output.parent() != Some(folder));
        let name = self.input.file_name()?.to_str()?.to_owned();
        (notation.has_projects() && is_alone).then(|| Companion {
            name,
            bytes: self.bytes.clone().into(),
        })
    }
}

/// The programs that the inputs stand for. What is wrong with single ones has been reported, and is in the outcome.
pub(super) fn jobs(
    inputs: &[PathBuf],
    output: Option<&Path>,
    from: Option<Form>,
    to: Option<Form>,
) -> Result<(Vec<Job>, Outcome), Failure> {
    let ladder_wanted =
        from.is_some_and(Form::is_ladder) || (from.is_none() && to.is_some_and(|to| !to.is_ladder()));
    let (files, errors) = find_files(inputs, &|path| match from {
        Some(form) => ends_like(path, form),
        None if ladder_wanted => is_ladder_text(path),
        None => NOTATIONS
            .iter()
            .any(|notation| notation.is_read() && ends_like(path, Form::Foreign(*notation))),
    });
    let searched = inputs.iter().filter(|input| input.is_dir()).cloned();
    FOREIGN.open(&searched.collect::<Vec<_>>());
    let mut outcome = Outcome::Fine;
    for error in errors {
        Failure::from(error).show();
        outcome = Outcome::Failed;
    }
    let several = inputs.len() > 1 || inputs.iter().any(|input| input.is_dir());
    if several && output.is_none_or(|output| output == Path::new("-")) && files.len() > 1 {
        return Err(Failure::new(
            "several programs need a folder to be written into: name it with -o",
        ));
    }
    if several && output.is_some_and(Path::is_file) {
        return Err(Failure::new(format!(
            "{}: this is a file; several programs need a folder to be written into",
            shown::path(output.unwrap_or(Path::new("")))
        )));
    }
    let mut jobs = Vec::new();
    let mut taken: HashMap<PathBuf, PathBuf> = HashMap::new();
    let named: HashSet<&Path> = inputs.iter().map(PathBuf::as_path).collect();
    for input in files {
        let is_named = named.contains(input.as_path());
        let folder = output.map(|output| output.join(folders_below(inputs, &input)));
        match job(
            &input,
            is_named,
            output,
            folder.as_deref().filter(|_| several),
            from,
            to,
        ) {
            Ok(None) => {}
            Ok(Some(job)) => {
                if let Some(output) = &job.output
                    && let Some(other) = taken.insert(output.clone(), input.clone())
                {
                    return Err(Failure::new(format!(
                        "{} and {} would both be written to {}: convert them one by one",
                        shown::path(&other),
                        shown::path(&input),
                        shown::path(output)
                    )));
                }
                jobs.push(job);
            }
            Err(failure) => {
                failure.show();
                outcome = Outcome::Failed;
            }
        }
    }
    without_companions(&mut jobs, &named);
    if jobs.is_empty() && outcome == Outcome::Fine {
        return Err(Failure::new(
            "there is no program to convert; name a file, or its notation with --from",
        ));
    }
    Ok((jobs, outcome))
}

/// The folders between one that was searched and a file that was found in it, so that the output has the same.
fn folders_below<'p>(inputs: &[PathBuf], file: &'p Path) -> &'p Path {
    let found = inputs.iter().filter_map(|input| file.strip_prefix(input).ok());
    let nearest = found.min_by_key(|below| below.components().count());
    nearest.and_then(Path::parent).unwrap_or(Path::new(""))
}

/// What was found in a folder next to a program, and belongs to it, is read with that. Two that belong to each other are both
/// programs, and so are one that is in another notation and all of a project.
fn without_companions(jobs: &mut Vec<Job>, named: &HashSet<&Path>) {
    let belongs = |job: &Job, program: &Job| match program.from {
        Form::Foreign(notation) => {
            !matches!(notation.reach(), Reach::Project(_))
                && job.from == program.from
                && FOREIGN.is_companion(notation, &program.input, &job.input)
        }
        Form::Ladder => false,
    };
    let is_whole = |job: &Job| {
        let mut all = jobs.iter();
        named.contains(job.input.as_path())
            || !all.any(|program| belongs(job, program) && !belongs(program, job))
    };
    let whole: Vec<bool> = jobs.iter().map(is_whole).collect();
    let mut whole = whole.into_iter();
    jobs.retain(|_| whole.next() == Some(true));
}

/// The job for a file; `folder` is where it goes if it is one of several. None: it was found in a folder under a name that others use too, and is not a program.
fn job(
    input: &Path,
    is_named: bool,
    output: Option<&Path>,
    folder: Option<&Path>,
    from: Option<Form>,
    to: Option<Form>,
) -> Result<Option<Job>, Failure> {
    let bytes = read_bytes(input)?;
    let Some(from) = from.or_else(|| Form::of(input, &bytes, is_ladder_text(input))) else {
        if !is_named {
            return Ok(None);
        }
        return Err(Failure::new(format!(
            "{}: this is in no notation that is known; if it is, name it with --from",
            shown::path(input)
        )));
    };
    // A folder may be called like a file.
    let file = output.filter(|output| folder.is_none() && !is_folder(output));
    let by_name = || file.and_then(form::by_extension);
    let Some(to) = to
        .or_else(by_name)
        .or((!from.is_ladder()).then_some(Form::Ladder))
    else {
        return Err(Failure::new(format!(
            "{}: this is ladder text already; name the notation to write with --to",
            shown::path(input)
        )));
    };
    let output = output.filter(|output| *output != Path::new("-"));
    let root = output.unwrap_or(Path::new("")).to_owned();
    let stem = input.file_stem().unwrap_or_default();
    let own_folder = match folder {
        Some(folder) => Some(folder.join(stem)),
        None => output.filter(|output| is_folder(output)).map(Path::to_owned),
    };
    let output = output.map(|output| {
        if own_folder.is_none() {
            return output.to_owned();
        }
        // A stem may have dots of its own.
        let mut name = stem.to_owned();
        name.push(".");
        name.push(to.extension());
        folder.unwrap_or(output).join(name)
    });
    Ok(Some(Job {
        input: input.to_owned(),
        bytes,
        from,
        to,
        output,
        folder: own_folder,
        root,
        is_one_of_several: folder.is_some(),
    }))
}

/// Whether a path is a folder, or is written as one.
fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.as_os_str().as_encoded_bytes().ends_with(b"/")
}

fn ends_like(path: &Path, form: Form) -> bool {
    let Some(extension) = path.extension().and_then(|extension| extension.to_str()) else {
        return false;
    };
    match form {
        Form::Ladder => is_ladder_text(path),
        Form::Foreign(notation) => has_extension(notation, extension),
    }
}
