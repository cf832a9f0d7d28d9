//! What tags open into: structures, arrays and the states of blocks as a tree, by their paths.
//!
//! The tree has a node for each part that a declaration writes, one for all elements of an array: so an array of any length costs
//! one. Only what keeps a state has a node for each element, as it is a tag of its own.

use crate::groups::{Entry, Group, element, state_points};
use crate::layout::Home;
use crate::tags::{Point, canonical};
use ladder_analysis::program::{Program, Tag, TagId};
use ladder_analysis::values::compound::Compound;
use ladder_analysis::values::types::Type;
use ladder_syntax::Name;
use std::collections::{HashMap, HashSet};

/// A type, and how many indices of an array of several dimensions were given.
type Reached = (Type, usize);

/// Where a step goes to.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
enum Step {
    /// A tag, or a member.
    Name(Name),
    /// An element that is a tag of its own.
    At(i64),
    /// Any element.
    Any,
}

#[derive(Debug)]
struct Node {
    /// The part's name, as it is written.
    name: String,
    /// Its members, or the elements that are tags of their own.
    steps: Vec<usize>,
    /// Where this is such an element: its index.
    index: Option<i64>,
    /// Where its elements are one tag: the first and last of them, and their node.
    any: Option<(i64, i64, usize)>,
    /// The tag that this is, or an element of.
    tag: Option<TagId>,
    reached: Option<Reached>,
    /// The first tag in it, in the order of declarations.
    first: TagId,
}

impl Node {
    fn new(name: &str, first: TagId) -> Node {
        Node {
            name: name.to_owned(),
            steps: Vec::new(),
            index: None,
            any: None,
            tag: None,
            reached: None,
            first,
        }
    }
}

/// Tags by their paths. The first node is the root.
#[derive(Debug)]
pub(crate) struct Tree {
    nodes: Vec<Node>,
    next: HashMap<(usize, Step), usize>,
}

/// A part of a program: the nodes that stand for it, each with the indices that led there through any element.
#[derive(Debug, Clone)]
pub(crate) struct Part {
    /// Its path: `lines[2].delay`.
    path: String,
    nodes: Vec<(usize, Vec<i64>)>,
}

/// A tree with the memory that its tags have.
#[derive(Clone, Copy)]
pub(crate) struct Grown<'s> {
    pub(crate) tree: &'s Tree,
    pub(crate) program: &'s Program,
    pub(crate) homes: &'s [Home],
}

impl Tree {
    /// The tags that are seen from outside.
    pub(crate) fn of(program: &Program) -> Tree {
        Tree::of_tags(program, |tag| tag.block.is_none())
    }

    /// The tags of the body of a user-defined block.
    pub(crate) fn of_block(program: &Program, block: usize) -> Tree {
        Tree::of_tags(program, |tag| tag.block == Some(block))
    }

    fn of_tags(program: &Program, is_in: impl Fn(&Tag) -> bool) -> Tree {
        let mut tree = Tree {
            nodes: vec![Node::new("", TagId(0))],
            next: HashMap::new(),
        };
        for (id, tag) in (0..).map(TagId).zip(&program.tags) {
            if is_in(tag) {
                tree.add(id, tag);
            }
        }
        tree
    }

    fn add(&mut self, id: TagId, tag: &Tag) {
        let own = [match tag.ty {
            Type::Array { first, last, .. } => (first, last),
            _ => (0, 0),
        }];
        let (root, declared, dimensions) = match &tag.column {
            Some(column) => (column.root, column.declared, &*column.dimensions),
            None => (tag.name.len(), (tag.name.len(), tag.ty), &own[..]),
        };
        let (name, path) = tag.name.split_at(root);
        let mut dimensions = dimensions.iter();
        let mut end = root;
        let mut reached = (declared.0 == end).then_some((declared.1, 0));
        let mut node = self.enter(0, Step::Name(Name::new(name)), name, id, reached);
        let mut steps: Vec<&str> = path.split_inclusive(['.', '[', ',', ']']).collect();
        if tag.column.is_none() && matches!(tag.ty, Type::Array { .. }) {
            steps.extend(["[", "]"]);
        }
        for text in steps {
            end += text.len();
            let (inside, closes) = match text.strip_suffix([',', ']']) {
                Some(inside) => (inside.trim(), true),
                None => (text.trim_end_matches(['.', '[']), false),
            };
            let is_member = !closes;
            if is_member && inside.is_empty() {
                continue;
            }
            if is_member {
                // Up to the dot or bracket after it.
                end -= text.len() - inside.len();
                reached = reached.and_then(|reached| member_of(reached, inside));
            } else {
                reached = reached.and_then(element_of);
            }
            if declared.0 == end {
                reached = Some((declared.1, 0));
            }
            if is_member {
                node = self.enter(node, Step::Name(Name::new(inside)), inside, id, reached);
                end += text.len() - inside.len();
            } else if let Ok(index) = inside.parse() {
                node = self.enter(node, Step::At(index), inside, id, reached);
                self.nodes[node].index = Some(index);
            } else if let Some(&(first, last)) = dimensions.next() {
                let outer = node;
                node = self.enter(node, Step::Any, "", id, reached);
                self.nodes[outer].any = Some((first, last, node));
            }
        }
        self.nodes[node].tag.get_or_insert(id);
    }

    fn enter(&mut self, from: usize, step: Step, name: &str, id: TagId, reached: Option<Reached>) -> usize {
        let new = self.nodes.len();
        let is_any = step == Step::Any;
        let node = *self.next.entry((from, step)).or_insert(new);
        if node == new {
            self.nodes.push(Node::new(name, id));
            if !is_any {
                self.nodes[from].steps.push(new);
            }
        }
        let known = &mut self.nodes[node].reached;
        *known = known.or(reached);
        node
    }

    /// The part that a path names. None: there is no such part.
    pub(crate) fn part(&self, text: &str) -> Option<Part> {
        let text = canonical(text);
        // The name of a tag of another file has a dot.
        let ends = text
            .match_indices(['.', '['])
            .map(|(at, _)| at)
            .chain([text.len()]);
        let root = |end: &usize| self.next.contains_key(&(0, Step::Name(Name::new(&text[..*end]))));
        let end = ends.rev().find(root)?;
        let mut part = Part {
            path: String::new(),
            nodes: vec![(0, Vec::new())],
        };
        part = self.named(&part, &Name::new(&text[..end]))?;
        let mut is_index = false;
        for step in text[end..].split_inclusive(['.', '[', ',', ']']) {
            match step {
                "." => is_index = false,
                "[" => is_index = true,
                _ if is_index => {
                    let (index, after) = step.split_at(step.len() - 1);
                    part = self.at(&part, index.trim().parse().ok()?);
                    is_index = after == ",";
                }
                _ => {
                    part = self.named(&part, &Name::new(step.trim_end_matches(['.', '['])))?;
                    is_index = step.ends_with('[');
                }
            }
            if part.nodes.is_empty() {
                return None;
            }
        }
        Some(part)
    }

    fn named(&self, part: &Part, name: &Name) -> Option<Part> {
        let step = |(node, indices): &(usize, Vec<i64>)| {
            let next = self.next.get(&(*node, Step::Name(name.clone())))?;
            Some((*next, indices.clone()))
        };
        let nodes: Vec<_> = part.nodes.iter().filter_map(step).collect();
        let written = &self.nodes[nodes.first()?.0].name;
        let path = match part.path.as_str() {
            "" => written.clone(),
            path => format!("{path}.{written}"),
        };
        Some(Part { path, nodes })
    }

    fn at(&self, part: &Part, index: i64) -> Part {
        let mut nodes = Vec::new();
        for (node, indices) in &part.nodes {
            if let Some((first, last, next)) = self.nodes[*node].any
                && (first..=last).contains(&index)
            {
                let mut indices = indices.clone();
                indices.push(index);
                nodes.push((next, indices));
            }
            if let Some(next) = self.next.get(&(*node, Step::At(index))) {
                nodes.push((*next, indices.clone()));
            }
        }
        // Two pairs of brackets in a row are one: `g[1, 2]`.
        let path = match part.path.strip_suffix(']') {
            Some(path) => format!("{path}, {index}]"),
            None => format!("{}[{index}]", part.path),
        };
        Part { path, nodes }
    }

    /// The indices of the elements that a part has.
    fn indices(&self, part: &Part) -> Vec<i64> {
        let nodes = || part.nodes.iter().map(|(node, _)| &self.nodes[*node]);
        if let Some((first, last, _)) = nodes().find_map(|node| node.any) {
            return (first..=last).collect();
        }
        let steps = nodes()
            .flat_map(|node| &node.steps)
            .map(|step| &self.nodes[*step]);
        let mut indices: Vec<i64> = steps.filter_map(|node| node.index).collect();
        indices.sort_unstable();
        indices
    }

    /// The parts that a part opens into: its members in the order of their declaration, or its elements, row by row.
    fn opened(&self, part: &Part) -> Vec<Part> {
        let indices = self.indices(part);
        if !indices.is_empty() {
            let rows = indices.into_iter().map(|index| self.at(part, index));
            return rows.flat_map(|element| self.row(element)).collect();
        }
        let steps = part.nodes.iter().flat_map(|(node, _)| &self.nodes[*node].steps);
        let mut members: Vec<&Node> = steps.map(|step| &self.nodes[*step]).collect();
        members.sort_by_key(|node| node.first);
        let mut seen = HashSet::new();
        let names = members.into_iter().map(|node| Name::new(&node.name));
        let names = names.filter(|name| seen.insert(name.clone()));
        names.filter_map(|name| self.named(part, &name)).collect()
    }

    /// An element, or of an array of several dimensions those that begin with its index.
    fn row(&self, element: Part) -> Vec<Part> {
        if self.is_array(&element) {
            self.opened(&element)
        } else {
            vec![element]
        }
    }

    fn is_array(&self, part: &Part) -> bool {
        let mut nodes = part.nodes.iter().map(|(node, _)| &self.nodes[*node]);
        nodes.any(|node| {
            let first = node.steps.first().and_then(|step| self.nodes[*step].index);
            node.any.is_some() || first.is_some()
        })
    }

    /// How many parts it opens into, without looking at each.
    fn count(&self, part: &Part) -> u64 {
        if !self.is_array(part) {
            return self.opened(part).len() as u64;
        }
        let any = part.nodes.iter().find_map(|(node, _)| self.nodes[*node].any);
        let (first, length) = match any {
            Some((first, last, _)) => (first, last.abs_diff(first) + 1),
            None => {
                let indices = self.indices(part);
                (indices.first().copied().unwrap_or_default(), indices.len() as u64)
            }
        };
        let first = self.at(part, first);
        let each = if self.is_array(&first) {
            self.count(&first)
        } else {
            1
        };
        length.saturating_mul(each)
    }

    fn opens(&self, part: &Part) -> bool {
        let mut nodes = part.nodes.iter().map(|(node, _)| &self.nodes[*node]);
        nodes.any(|node| node.any.is_some() || !node.steps.is_empty())
    }
}

impl Grown<'_> {
    /// What the whole program opens into.
    pub(crate) fn tags(self) -> Vec<Entry> {
        self.entries_of(&Part {
            path: String::new(),
            nodes: vec![(0, Vec::new())],
        })
    }

    /// What a part opens into.
    pub(crate) fn entries_of(self, part: &Part) -> Vec<Entry> {
        if let Some(state) = self.state(part) {
            return state.into_iter().map(Entry::Value).collect();
        }
        let is_array = self.tree.is_array(part);
        // All elements of an array are of one type.
        let mut alike: Option<Group> = None;
        let mut entries = Vec::new();
        for part in self.tree.opened(part) {
            match (self.value(&part), &alike) {
                (Some(point), _) => entries.push(Entry::Value(point)),
                (None, Some(group)) => entries.push(Entry::Group(Group {
                    name: part.path,
                    ..group.clone()
                })),
                (None, None) => {
                    let Some(group) = self.group(&part) else { continue };
                    alike = is_array.then(|| group.clone());
                    entries.push(Entry::Group(group));
                }
            }
        }
        entries
    }

    /// Every value in a part.
    pub(crate) fn values(self, part: &Part) -> Vec<Point> {
        if let Some(point) = self.value(part) {
            return vec![point];
        }
        if let Some(state) = self.state(part) {
            return state;
        }
        let parts = self.tree.opened(part);
        parts.iter().flat_map(|part| self.values(part)).collect()
    }

    fn tag(self, part: &Part) -> Option<(TagId, &[i64])> {
        let mut nodes = part.nodes.iter();
        nodes.find_map(|(node, indices)| Some((self.tree.nodes[*node].tag?, indices.as_slice())))
    }

    /// The value that a part is.
    pub(crate) fn value(self, part: &Part) -> Option<Point> {
        let (id, indices) = self.tag(part)?;
        let tag = &self.program.tags[id.0 as usize];
        let index = match (tag.ty, &tag.column, indices) {
            (Type::Array { .. }, _, []) => return None,
            (_, Some(column), [_, _, ..]) => {
                let mut indices = indices.iter().zip(&column.dimensions);
                indices.try_fold(0i64, |all, (index, (first, last))| {
                    all.checked_mul(last - first + 1)?.checked_add(index - first)
                })?
            }
            (_, _, [index]) => *index,
            _ => 0,
        };
        element(tag, self.homes[id.0 as usize], index)
    }

    /// The members of a timer, counter or bistable that show what it does.
    fn state(self, part: &Part) -> Option<Vec<Point>> {
        let (id, _) = self.tag(part)?;
        let tag = &self.program.tags[id.0 as usize];
        let is_state = matches!(tag.ty, Type::State(_));
        is_state.then(|| state_points(self.program, tag, self.homes[id.0 as usize]).collect())
    }

    /// What a part is that opens.
    pub(crate) fn group(self, part: &Part) -> Option<Group> {
        let state = self.state(part);
        if state.is_none() && !self.tree.opens(part) {
            return None;
        }
        let nodes = || part.nodes.iter().map(|(node, _)| &self.tree.nodes[*node]);
        let some = &self.program.tags[nodes().next()?.first.0 as usize];
        let ty = nodes().find_map(|node| node.reached).map(|(ty, _)| ty);
        let own = self.tag(part).map(|(id, _)| self.program.tags[id.0 as usize].ty);
        Some(Group {
            name: part.path.clone(),
            ty: ty.or(own).map_or(String::new(), |ty| ty.to_string()),
            role: some.role,
            read_only: some.constant,
            parts: state
                .as_ref()
                .map_or_else(|| self.tree.count(part), |state| state.len() as u64),
            state: match own {
                Some(Type::State(state)) => Some(state),
                _ => None,
            },
        })
    }
}

/// The type of a member of a structure.
fn member_of((ty, given): Reached, name: &str) -> Option<Reached> {
    match ty {
        Type::Compound(id) if given == 0 => id.with(|ty| match ty {
            Compound::Structure(structure) => structure.member(name).map(|(_, member)| (member.ty, 0)),
            _ => None,
        }),
        _ => None,
    }
}

/// The type after one more index.
fn element_of((ty, given): Reached) -> Option<Reached> {
    let (dimensions, element) = ty.array()?;
    Some(if given + 1 < dimensions.len() {
        (ty, given + 1)
    } else {
        (element, 0)
    })
}
