//! Arrays that are handed to an Add-On Instruction. There an array parameter takes an array of any size, here one of its
//! own: it gets the size of what is handed over, and of an instruction that gets several there is one for each.

use crate::calls::called;
use crate::mnemonic::Role;
use crate::model::{Aoi, Project, Tag, Usage};
use crate::operand::{Expr, Step};
use crate::scope::Tags;
use crate::types::Ty;
use crate::unit::{Owner, operand, units};
use std::collections::{HashMap, HashSet};

/// Parts of Add-On Instructions call others no deeper.
const DEEPEST: usize = 16;

/// An Add-On Instruction becomes no more blocks.
const MOST_SIZES: usize = 64;

/// The sizes of the parameters that are arrays, by their numbers.
type Sizes = Vec<(usize, Vec<u32>)>;

/// A call of an Add-On Instruction that has such parameters.
struct Call {
    aoi: usize,
    /// What declares the instance: a scope, and a name in capitals.
    instance: (usize, String),
    /// The instance is a member of a structure, whose type stays.
    is_member: bool,
    sizes: Sizes,
}

/// Gives all such parameters the sizes of what is handed over.
pub(crate) fn size_in_outs(project: &mut Project) {
    let has_arrays = |aoi: &Aoi| aoi.parameters.iter().any(is_array);
    if !project.aois.iter().any(has_arrays) {
        return;
    }
    // What programs hand over is known first, then what those that they call hand on.
    for mut level in levels(project) {
        level.retain(|aoi| has_arrays(&project.aois[*aoi]));
        if level.is_empty() {
            continue;
        }
        let calls = calls(project, &level);
        apply(project, calls);
    }
}

/// Whether a parameter is an array that is handed over.
fn is_array(tag: &Tag) -> bool {
    tag.usage == Usage::InOut && !tag.dimensions.is_empty()
}

/// The Add-On Instructions by their names in capitals.
fn by_name(project: &Project) -> HashMap<String, usize> {
    let names = project.aois.iter().map(|aoi| aoi.name.to_ascii_uppercase());
    names.enumerate().map(|(number, name)| (name, number)).collect()
}

/// The Add-On Instructions that are called from programs alone, then those that these call, and so on.
fn levels(project: &Project) -> Vec<HashSet<usize>> {
    let by_name = by_name(project);
    let mut callers: Vec<HashSet<usize>> = vec![HashSet::new(); project.aois.len()];
    for unit in units(project) {
        let Owner::Aoi(caller) = unit.owner else { continue };
        for (name, _) in called(&unit) {
            if let Some(aoi) = by_name.get(&name.to_ascii_uppercase()) {
                callers[*aoi].insert(caller);
            }
        }
    }
    let mut level = vec![0usize; project.aois.len()];
    for _ in 0..DEEPEST {
        for aoi in 0..level.len() {
            let above = callers[aoi].iter().map(|caller| level[*caller] + 1);
            level[aoi] = above.max().unwrap_or(0).min(DEEPEST);
        }
    }
    let deepest = level.iter().copied().max().unwrap_or(0);
    let of = |own: usize| {
        let all = level.iter().enumerate().filter(move |(_, level)| **level == own);
        all.map(|(aoi, _)| aoi).collect()
    };
    (0..=deepest).map(of).collect()
}

/// The calls of some Add-On Instructions with what they hand over.
fn calls(project: &Project, of: &HashSet<usize>) -> Vec<Call> {
    let mut tags = Tags::of(project);
    let by_name = by_name(project);
    let mut calls = Vec::new();
    for unit in units(project) {
        for (name, operands) in called(&unit) {
            let aoi = by_name.get(&name.to_ascii_uppercase()).copied();
            let Some(aoi) = aoi.filter(|aoi| of.contains(aoi)) else {
                continue;
            };
            let path = |text: &str| match operand(project.family, text) {
                Ok(Expr::Path(path)) => Some(path),
                _ => None,
            };
            let (instance, rest) = match operands.split_first() {
                Some((instance, rest)) => (path(instance), rest),
                None => continue,
            };
            let Some(instance) = instance else { continue };
            let is_member = instance.steps.iter().any(|step| matches!(step, Step::Member(_)));
            let Some((scope, mut name)) = tags.declared_as(unit.scope, &instance.root) else {
                continue;
            };
            if is_member {
                name = operands[0].to_ascii_uppercase();
            }
            let parameters = project.aois[aoi].parameters.iter().enumerate();
            let given = parameters.filter(|(_, tag)| tag.is_given());
            let mut sizes = Sizes::new();
            for ((number, tag), text) in given.zip(rest) {
                if !is_array(tag) {
                    continue;
                }
                let whole = text.strip_suffix("[0]").unwrap_or(text);
                let place = path(whole).and_then(|path| tags.place(unit.scope, &path, Role::Array).ok());
                if let Some(Ty::Array(_, own)) = place.map(|place| place.ty)
                    && own.len() == tag.dimensions.len()
                {
                    sizes.push((number, own));
                }
            }
            let instance = (scope, name);
            calls.push(Call {
                aoi,
                instance,
                is_member,
                sizes,
            });
        }
    }
    // The types of members stay: the instruction itself gets what they need.
    calls.sort_by_key(|call| !call.is_member);
    calls
}

/// The first sizes become those of the instruction itself; others those of a copy, which is the type of the instance.
fn apply(project: &mut Project, calls: Vec<Call>) {
    let mut known: HashMap<(usize, Sizes), usize> = HashMap::new();
    let mut counts: HashMap<usize, usize> = HashMap::new();
    let mut placed: HashMap<(usize, String), usize> = HashMap::new();
    for call in calls {
        if call.sizes.is_empty() || placed.contains_key(&call.instance) {
            continue;
        }
        let key = (call.aoi, call.sizes);
        let own = match known.get(&key) {
            Some(own) => *own,
            None => {
                let count = counts.entry(call.aoi).or_insert(0usize);
                *count += 1;
                let own = match *count {
                    1 => call.aoi,
                    // The calls with further sizes are not read.
                    count if count > MOST_SIZES => continue,
                    _ => copy(project, call.aoi, &key.1),
                };
                for (number, sizes) in &key.1 {
                    project.aois[own].parameters[*number].dimensions.clone_from(sizes);
                }
                known.insert(key, own);
                own
            }
        };
        if own != call.aoi {
            retype(project, &call.instance, call.aoi, own);
        }
        placed.insert(call.instance, own);
    }
}

/// Another Add-On Instruction that does the same. Its name is that of the first, with the sizes.
fn copy(project: &mut Project, of: usize, sizes: &Sizes) -> usize {
    let mut copy = project.aois[of].clone();
    for (_, sizes) in sizes {
        for size in sizes {
            copy.name.push_str(&format!("_{size}"));
        }
    }
    while project
        .aois
        .iter()
        .any(|aoi| aoi.name.eq_ignore_ascii_case(&copy.name))
    {
        copy.name.push('x');
    }
    copy.sized_from = Some(of);
    project.aois.push(copy);
    project.aois.len() - 1
}

/// Declares an instance, or the array of instances, as one of the copy.
fn retype(project: &mut Project, (scope, name): &(usize, String), from: usize, to: usize) {
    let programs = project.programs.len();
    let (from, to) = (project.aois[from].name.clone(), project.aois[to].name.clone());
    let tags = match *scope {
        0 => &mut project.tags,
        scope if scope <= programs => &mut project.programs[scope - 1].tags,
        scope => &mut project.aois[scope - 1 - programs].locals,
    };
    for tag in tags.iter_mut().filter(|tag| tag.name.eq_ignore_ascii_case(name)) {
        if tag.ty.eq_ignore_ascii_case(&from) {
            tag.ty.clone_from(&to);
        }
    }
}
