//! The tags of user-defined blocks: they exist once for each place where a block is.

use super::Simulation;
use crate::groups::{Entry, Group};
use crate::layout::Home;
use crate::places::BlockAt;
use crate::tags::{Names, Point, UnknownTag};
use crate::tree::{Grown, Tree};
use ladder_analysis::program::{BlockKind, Location, TagId};
use ladder_syntax::Name;
use std::collections::{BTreeMap, HashMap};

/// A place where a user-defined block is, with tags of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Instance {
    /// The tag that is its state: `m1`. Without one the block's name and a number: `$RAMP#2` is the second place of `$RAMP` in the
    /// order of the code. Of a block in the body of another, the name of that is before it: `$OUTER#1.$RAMP#1`, `m1.inner`.
    pub name: String,
    /// The block: index into [`Program::blocks`](ladder_analysis::program::Program::blocks).
    pub block: usize,
    /// Where it is.
    pub location: Location,
    /// The block, after those in whose bodies it is.
    pub(crate) path: Vec<BlockAt>,
    tags: Vec<(TagId, Home)>,
}

impl Instance {
    /// Whether its state is a tag, whose name it has.
    pub fn is_tag(&self) -> bool {
        let last = self.name.rsplit('.').next().unwrap_or_default();
        !last.starts_with('$')
    }

    /// Its tags, in the order of their declaration: index into
    /// [`Program::tags`](ladder_analysis::program::Program::tags).
    pub fn tags(&self) -> impl Iterator<Item = TagId> {
        self.tags.iter().map(|(tag, _)| *tag)
    }
}

impl Simulation {
    /// The places where user-defined blocks are, in the order of the code. A block of another's body has a place for
    /// each of that one's. What is called by several places has one.
    pub fn instances(&self) -> &[Instance] {
        self.instances.get_or_init(|| self.find_instances())
    }

    fn find_instances(&self) -> Vec<Instance> {
        let places = &self.compiled.places;
        let mut by_path: BTreeMap<&[BlockAt], Vec<(TagId, Home)>> = BTreeMap::new();
        for (path, tag, home) in places.body_in_outs.iter().chain(&places.body_tags) {
            by_path.entry(path).or_default().push((*tag, *home));
        }
        let mut states: HashMap<&[BlockAt], TagId> = HashMap::new();
        for (path, state, homes) in &places.named {
            by_path.entry(path).or_default().extend(homes);
            states.insert(path, *state);
        }
        let mut names: HashMap<&[BlockAt], String> = HashMap::new();
        let mut numbers: HashMap<(String, usize), usize> = HashMap::new();
        let mut instances = Vec::with_capacity(by_path.len());
        for (path, mut tags) in by_path {
            let Some((last, outer)) = path.split_last() else {
                continue;
            };
            let drawn = &self.program.networks[last.network].blocks[last.block];
            let BlockKind::User(block) = drawn.kind else {
                continue;
            };
            tags.sort_by_key(|(tag, _)| *tag);
            let outer = names
                .get(outer)
                .map_or(String::new(), |outer| format!("{outer}."));
            let name = match states.get(path) {
                Some(state) => format!("{outer}{}", self.program.tags[state.0 as usize].name),
                None => {
                    let number = numbers.entry((outer.clone(), block)).or_default();
                    *number += 1;
                    format!("{outer}{}#{number}", self.program.blocks[block].name)
                }
            };
            names.insert(path, name.clone());
            instances.push(Instance {
                name,
                block,
                location: drawn.location,
                path: path.to_vec(),
                tags,
            });
        }
        instances
    }

    /// A tag of an instance, by a text such as `$RAMP#2.level`. None if the text does not begin as one.
    pub(super) fn resolve_in_instance(&self, text: &str) -> Option<Result<Point, UnknownTag>> {
        let text = text.trim();
        if !text.contains('$') {
            return None;
        }
        let typed = Name::new(text);
        let named = |instance: &&Instance| {
            let rest = typed.as_str().strip_prefix(Name::new(&instance.name).as_str());
            rest.is_some_and(|rest| rest.starts_with('.') && !rest.starts_with(".$"))
        };
        let Some(instance) = self.instances().iter().find(named) else {
            return Some(Err(UnknownTag {
                message: format!(
                    "there is no place `{text}`: write the block's name, its number and a tag of its body, as in $RAMP#1.level"
                ),
            }));
        };
        // A name and its spelling have as many dots.
        let dots = instance.name.matches('.').count();
        let tag = text.splitn(dots + 2, '.').last().unwrap_or_default();
        Some(self.resolve_within(instance, tag))
    }

    /// What the tags of an instance open into, by a path in the body, as [`Simulation::opened`]; an empty one stands for all of
    /// them. The names are those of the tags from outside: `$RAMP#2.level`.
    pub fn opened_within(&self, instance: &Instance, path: &str) -> Option<Vec<Entry>> {
        let (tree, homes) = (
            Tree::of_block(&self.program, instance.block),
            self.homes_of(instance),
        );
        let grown = Grown {
            tree: &tree,
            program: &self.program,
            homes: &homes,
        };
        let mut entries = match path {
            "" => grown.tags(),
            path => grown.entries_of(&tree.part(path)?),
        };
        for entry in &mut entries {
            let name = match entry {
                Entry::Value(point) => &mut point.name,
                Entry::Group(group) => &mut group.name,
            };
            *name = format!("{}.{name}", instance.name);
        }
        Some(entries)
    }

    /// What a path in the body of an instance names, if it opens; the name is that in the body.
    pub fn group_within(&self, instance: &Instance, path: &str) -> Option<Group> {
        let (tree, homes) = (
            Tree::of_block(&self.program, instance.block),
            self.homes_of(instance),
        );
        let grown = Grown {
            tree: &tree,
            program: &self.program,
            homes: &homes,
        };
        grown.group(&tree.part(path)?)
    }

    fn homes_of(&self, instance: &Instance) -> Vec<Home> {
        let mut homes = self.compiled.homes.clone();
        for (tag, home) in &instance.tags {
            homes[tag.0 as usize] = *home;
        }
        homes
    }

    /// A tag of an instance by its name in the body: `level`, `t1.ET`.
    ///
    /// # Errors
    /// The body has no such tag.
    pub fn resolve_within(&self, instance: &Instance, tag: &str) -> Result<Point, UnknownTag> {
        let homes = self.homes_of(instance);
        let names = Names::of_instance(&self.program, instance.block, instance.tags());
        let mut point = names.resolve(&self.program, &homes, tag)?;
        // A tag at an address is the program's, whatever a body calls it.
        let word = tag.trim().split('.').next().unwrap_or_default();
        let mut others = self.program.other_names_in(Some(instance.block));
        if !others.any(|(name, _)| Name::new(name) == Name::new(word)) {
            point.name = format!("{}.{}", instance.name, point.name);
        }
        Ok(point)
    }
}
