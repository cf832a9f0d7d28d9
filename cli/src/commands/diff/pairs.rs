//! Which files are compared with which.

use super::side::{File, Side};
use crate::findings::is_settings;
use crate::git::Git;
use crate::outcome::Failure;
use ladder_workspace::is_program;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::path::Path;

/// Two files that are compared. None: there is no such file on that side.
pub(super) struct Pair {
    pub(super) old: Option<File>,
    pub(super) new: Option<File>,
    /// It is one file of both folders, under another name.
    pub(super) renamed: bool,
}

/// Gone and new files are told to be one by what they hold if there are no more pairs of them.
const MOST_PAIRS: usize = 10_000;

/// So much of two files is the same if they are one under another name, as in git.
const ALIKE: f64 = 0.5;

/// The pairs of two sides.
///
/// # Errors
/// One is a file and the other a folder, or a file cannot be read.
pub(super) fn pairs(old: Side, new: Side, git: &Git) -> Result<Vec<Pair>, Failure> {
    let pair = |old, new| Pair {
        old,
        new,
        renamed: false,
    };
    match (old, new) {
        (Side::File(old), Side::File(new)) => Ok(vec![pair(Some(old), Some(new))]),
        (Side::Nothing, Side::File(new)) => Ok(vec![pair(None, Some(new))]),
        (Side::File(old), Side::Nothing) => Ok(vec![pair(Some(old), None)]),
        (Side::Nothing, Side::Nothing) => Ok(Vec::new()),
        (Side::Folder(mut old), Side::Folder(mut new)) => {
            let mut former = renamed(&old, &new, git)?;
            let taken: BTreeSet<String> = former.values().cloned().collect();
            let names: BTreeSet<String> = old.keys().chain(new.keys()).cloned().collect();
            let names = names.into_iter().filter(|name| !taken.contains(name));
            let pairs = names.map(|name| match former.remove(&name) {
                Some(was) => Pair {
                    old: old.remove(&was),
                    new: new.remove(&name),
                    renamed: true,
                },
                None => pair(old.remove(&name), new.remove(&name)),
            });
            Ok(pairs.collect())
        }
        _ => Err(Failure::new(
            "a file and a folder cannot be compared; name two files or two folders",
        )),
    }
}

impl Pair {
    /// Whether it is of settings files.
    pub(super) fn is_settings(&self) -> bool {
        self.files().any(|file| is_settings(Path::new(&file.name)))
    }

    /// Whether it is of ladder programs by their names.
    pub(super) fn is_program(&self) -> bool {
        self.files().all(|file| is_program(Path::new(&file.name)))
    }

    fn files(&self) -> impl Iterator<Item = &File> {
        [&self.old, &self.new].into_iter().flatten()
    }
}

/// Programs of the new folder that have another name in the old one: that name, by the new one.
fn renamed(
    old: &BTreeMap<String, File>,
    new: &BTreeMap<String, File>,
    git: &Git,
) -> Result<HashMap<String, String>, Failure> {
    let only = |one: &BTreeMap<String, File>, other: &BTreeMap<String, File>| -> Vec<String> {
        let names = one.keys().filter(|name| !other.contains_key(*name));
        names
            .filter(|name| is_program(Path::new(name)))
            .cloned()
            .collect()
    };
    let (gone, added) = (only(old, new), only(new, old));
    if gone.is_empty() || added.is_empty() || gone.len() * added.len() > MOST_PAIRS {
        return Ok(HashMap::new());
    }
    let contents = |names: &[String], files: &BTreeMap<String, File>| -> Result<Vec<_>, Failure> {
        let contents = names.iter().map(|name| Ok(Lines::of(&files[name].bytes(git)?)));
        contents.collect()
    };
    let (gone_lines, added_lines) = (contents(&gone, old)?, contents(&added, new)?);
    let mut likely = Vec::new();
    for (at, lines) in added_lines.iter().enumerate() {
        for (was, old_lines) in gone_lines.iter().enumerate() {
            let likeness = lines.likeness(old_lines);
            if likeness >= ALIKE {
                likely.push((likeness, was, at));
            }
        }
    }
    likely.sort_by(|a, b| b.0.total_cmp(&a.0).then_with(|| (a.1, a.2).cmp(&(b.1, b.2))));
    let mut former = HashMap::new();
    let mut taken = BTreeSet::new();
    for (_, was, is) in likely {
        if !former.contains_key(&added[is]) && taken.insert(was) {
            former.insert(added[is].clone(), gone[was].clone());
        }
    }
    Ok(former)
}

/// The lines of a file without the blanks around them, and how often each is there.
struct Lines {
    counts: HashMap<Vec<u8>, usize>,
    bytes: usize,
}

impl Lines {
    fn of(content: &[u8]) -> Lines {
        let mut lines = Lines {
            counts: HashMap::new(),
            bytes: 0,
        };
        for line in content.split(|byte| *byte == b'\n').map(<[u8]>::trim_ascii) {
            *lines.counts.entry(line.to_owned()).or_default() += 1;
            lines.bytes += line.len();
        }
        lines
    }

    /// How much of both is in both: 1 for all.
    fn likeness(&self, other: &Lines) -> f64 {
        let both = self.counts.iter().map(|(line, count)| {
            let also = other.counts.get(line).copied().unwrap_or(0);
            line.len() * also.min(*count)
        });
        let both: usize = both.sum();
        2.0 * both as f64 / (self.bytes + other.bytes).max(1) as f64
    }
}
