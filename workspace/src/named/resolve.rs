//! Following a name, link by link, without touching what lies outside.

use super::name::PathComponent;
use crate::error::Problem;
use crate::root::without_parents;
use std::collections::VecDeque;
use std::ffi::OsString;
use std::io;
use std::path::{Component, Path, PathBuf};

/// More links than these go round in a circle.
const LINKS: usize = 40;

/// Where the parts of a name lead, seen from a folder of the workspace. No link is left in the path below `root`, and the
/// last part need not be there.
pub(super) fn inside(root: &Path, folder: &Path, parts: Vec<PathComponent>) -> Result<PathBuf, Problem> {
    follow(&whole(root)?, &whole(folder)?, parts, &link_at)
}

/// The same where there are no links; the paths are whole ones.
pub(super) fn without_links(
    root: &Path,
    folder: &Path,
    parts: Vec<PathComponent>,
) -> Result<PathBuf, Problem> {
    follow(root, folder, parts, &|_| Ok(None))
}

/// Where a link leads; nothing for what is not a link, or not there.
fn link_at(path: &Path) -> io::Result<Option<PathBuf>> {
    match path.symlink_metadata() {
        Ok(metadata) if metadata.is_symlink() => path.read_link().map(Some),
        Ok(_) => Ok(None),
        Err(error)
            if matches!(
                error.kind(),
                io::ErrorKind::NotFound | io::ErrorKind::NotADirectory
            ) =>
        {
            Ok(None)
        }
        Err(error) => Err(error),
    }
}

fn follow(
    root: &Path,
    folder: &Path,
    parts: Vec<PathComponent>,
    link_at: &dyn Fn(&Path) -> io::Result<Option<PathBuf>>,
) -> Result<PathBuf, Problem> {
    let mut pending: VecDeque<PathComponent> = below(root, folder).ok_or(Problem::Outside)?.into();
    pending.extend(parts);
    let mut here: Vec<OsString> = Vec::new();
    let mut links = 0;
    while let Some(part) = pending.pop_front() {
        let name = match part {
            PathComponent::Up if here.pop().is_none() => return Err(Problem::Outside),
            PathComponent::Up => continue,
            PathComponent::Name(name) => name,
        };
        let mut at = root.to_owned();
        at.extend(&here);
        at.push(&name);
        let Some(target) = link_at(&at).map_err(Problem::Read)? else {
            here.push(name);
            continue;
        };
        links += 1;
        if links > LINKS {
            return Err(Problem::Read(io::Error::other("too many links lead on from it")));
        }
        let on = if target.has_root() || target.is_absolute() {
            here.clear();
            absolute_link(root, &target).ok_or(Problem::Outside)?
        } else {
            parts_of(&target).ok_or(Problem::Outside)?
        };
        for part in on.into_iter().rev() {
            pending.push_front(part);
        }
    }
    if here.is_empty() {
        return Err(Problem::Directory);
    }
    let mut path = root.to_owned();
    path.extend(&here);
    Ok(path)
}

/// The path from the top of the disk on, as [`Root::of`](crate::root::Root::of) has it; none at all is the current folder.
fn whole(path: &Path) -> Result<PathBuf, Problem> {
    let path = if path.as_os_str().is_empty() {
        Path::new(".")
    } else {
        path
    };
    let path = std::path::absolute(path).map_err(Problem::Read)?;
    Ok(without_parents(&path))
}

/// A link that names its target from the top of the disk: inside if it begins with the workspace's folder, by any of its
/// names.
fn absolute_link(root: &Path, target: &Path) -> Option<Vec<PathComponent>> {
    below(root, target).or_else(|| below(&root.canonicalize().ok()?, target))
}

/// The way from a folder down to a path below it.
fn below(folder: &Path, path: &Path) -> Option<Vec<PathComponent>> {
    parts_of(path.strip_prefix(folder).ok()?)
}

fn parts_of(path: &Path) -> Option<Vec<PathComponent>> {
    let mut parts = Vec::new();
    for component in path.components() {
        match component {
            Component::CurDir => {}
            Component::ParentDir => parts.push(PathComponent::Up),
            Component::Normal(name) => parts.push(PathComponent::Name(name.to_owned())),
            Component::Prefix(_) | Component::RootDir => return None,
        }
    }
    Some(parts)
}
