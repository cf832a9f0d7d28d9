//! The parts of a tag that its places mean: members, elements, bits. For the rules about tags each is a tag of its own
//! (LANGUAGE §4): `a.b` and `a.c` are different places, a copy of the whole touches both, and a computed index each element.

use crate::boolean::written::written;
use crate::names::context::{Body, Context};
use crate::names::operand_value::{Number, number};
use crate::names::scope::TagFacts;
use crate::networks::named::path_at;
use crate::networks::network::Formal;
use crate::networks::use_kind::{Effect, Extent};
use crate::networks::use_place::{Use, UseRef};
use crate::values::types::Type;
use crate::written::facts::{Node, NodeKind};
use ladder_instructions::Accepts;
use ladder_syntax::Name;
use rustc_hash::FxHashMap;
use smol_str::{SmolStr, ToSmolStr};

/// Of a tag with more different ranges and computed indices than this each of its places counts as touching all others.
const MOST_SPANS: usize = 32;

/// One step from a tag towards a part.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
enum Step {
    /// A member, or a bit.
    Member(Name),
    /// The elements from the first to the last: one, those of a range, or for a computed index all.
    Elements(i64, i64),
}

impl Step {
    const COMPUTED: Step = Step::Elements(i64::MIN, i64::MAX);

    fn meets(&self, other: &Step) -> bool {
        match (self, other) {
            (Step::Elements(a, b), Step::Elements(c, d)) => a <= d && c <= b,
            _ => self == other,
        }
    }

    /// Whether it may be another part at another time, or several at once.
    fn is_span(&self) -> bool {
        matches!(self, Step::Elements(first, last) if first != last)
    }
}

/// What places do with a part together.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Touched {
    pub(super) reads: usize,
    pub(super) writes: usize,
    /// Those of the writing ones that set it.
    pub(super) sets: usize,
    /// Those that reset it.
    pub(super) resets: usize,
    /// Those that keep a state in it.
    pub(super) keeps: usize,
    /// The topmost that reads it.
    pub(super) first_read: Option<UseRef>,
    /// The topmost that writes it.
    pub(super) first_write: Option<UseRef>,
    body: Option<Body>,
    /// There are several bodies, ranges or computed indices among them.
    pub(super) scattered: bool,
}

impl Touched {
    /// What all places do with a tag. A timer or counter is not set.
    pub(super) fn of(context: &Context, tag: &TagFacts) -> Touched {
        let mut touched = Touched::default();
        for place in &tag.uses.0 {
            touched.add(&Touched::one(context, *place, place.extent() == Extent::Elements));
        }
        if matches!(tag.ty, Some(Type::State(_))) {
            (touched.sets, touched.resets) = (0, 0);
        }
        touched
    }

    fn one(context: &Context, place: UseRef, is_span: bool) -> Touched {
        let (access, effect) = (place.access(), place.effect());
        let writes = |is: Effect| usize::from(access.writes() && effect == is);
        Touched {
            reads: usize::from(access.reads()),
            writes: usize::from(access.writes()),
            sets: writes(Effect::Sets),
            resets: writes(Effect::Resets),
            keeps: writes(Effect::KeepsState),
            first_read: access.reads().then_some(place),
            first_write: access.writes().then_some(place),
            body: Some(context.bodies[place.network as usize]),
            scattered: is_span,
        }
    }

    pub(super) fn add(&mut self, other: &Touched) {
        let first =
            |a: Option<UseRef>, b: Option<UseRef>| a.into_iter().chain(b).min_by_key(|use_| use_.network);
        self.reads += other.reads;
        self.writes += other.writes;
        self.sets += other.sets;
        self.resets += other.resets;
        self.keeps += other.keeps;
        self.first_read = first(self.first_read, other.first_read);
        self.first_write = first(self.first_write, other.first_write);
        self.scattered |= other.scattered || (self.body.zip(other.body).is_some_and(|(a, b)| a != b));
        self.body = self.body.or(other.body);
    }
}

/// A part in the tree of those that places mean.
#[derive(Debug, Default)]
struct Knot {
    step: Option<Step>,
    /// Next to the root itself it is 0 as well.
    parent: usize,
    below: FxHashMap<Step, usize>,
    /// Those of `below` that are ranges and computed indices.
    spans: Vec<usize>,
    name: SmolStr,
    own: Vec<UseRef>,
    of_own: Touched,
    /// What is done with it and the parts in it.
    of_all: Touched,
    is_span: bool,
    /// It is an element of an array, and not in a structure.
    is_element: bool,
}

/// The parts of a tag that its places mean, the tag as a whole first.
#[derive(Debug)]
pub(super) struct Parts(Vec<Knot>);

/// A part that places mean.
pub(super) struct Part<'p> {
    /// As its first place writes it.
    pub(super) name: &'p str,
    /// The places that mean just this part.
    pub(super) own: &'p [UseRef],
    /// What is done with it, with what it is in, and with what is in it.
    pub(super) touched: Touched,
    /// A range, or a computed index.
    pub(super) is_span: bool,
    /// An element with a number for its index, in a tag that is an array.
    pub(super) is_element: bool,
}

impl Parts {
    /// Of a tag that all places together use so.
    pub(super) fn of(context: &Context, tag: &TagFacts, all: &Touched) -> Parts {
        let mut parts = Parts(vec![Knot {
            name: tag.name.clone(),
            ..Knot::default()
        }]);
        // A timer is one with its members, and so are all the names of a direct address.
        let is_one =
            matches!(tag.ty, Some(Type::State(_))) || context.others_at_address(tag).next().is_some();
        let is_whole = |place: &UseRef| place.extent() == Extent::Whole;
        if is_one || tag.uses.0.iter().all(is_whole) {
            let root = &mut parts.0[0];
            root.own = tag.uses.0.to_vec();
            (root.of_own, root.of_all) = (*all, *all);
            return parts;
        }
        let mut spans = 0;
        for place in &tag.uses.0 {
            let knot = if is_whole(place) {
                0
            } else {
                parts.enter(context, *place, &mut spans)
            };
            let knot = &mut parts.0[knot];
            knot.own.push(*place);
            knot.of_own.add(&Touched::one(context, *place, knot.is_span));
        }
        for index in (0..parts.0.len()).rev() {
            let own = parts.0[index].of_own;
            parts.0[index].of_all.add(&own);
            if index > 0 {
                let (all, parent) = (parts.0[index].of_all, parts.0[index].parent);
                parts.0[parent].of_all.add(&all);
            }
        }
        parts
    }

    /// Enters the part that a place means. `spans` counts the ranges and computed indices.
    fn enter(&mut self, context: &Context, place: UseRef, spans: &mut usize) -> usize {
        let place = context.networks.use_of(place);
        let network = context.networks.at(place.network);
        let block = network.block(place.block);
        let Some(path) = path_of(context, &place) else {
            return 0;
        };
        let mut steps = steps(context, network.scope, path);
        let opens = matches!(block.formals[place.operand], Formal::Operand(row)
            if matches!(row.accepts, Accepts::Range | Accepts::RangeOrValue));
        if let Some((Step::Elements(_, last), _)) = steps.last_mut().filter(|_| opens) {
            // An index alone is where a range begins.
            *last = if matches!(path.kind, NodeKind::Index(..)) {
                i64::MAX
            } else {
                *last
            };
        }
        let mut at = 0;
        for (step, node) in steps {
            let known = self.0[at].below.get(&step).copied();
            at = known.unwrap_or_else(|| {
                // More than these are one, which is any of them.
                let step = if step.is_span() && *spans >= MOST_SPANS {
                    Step::COMPUTED
                } else {
                    step
                };
                if let Some(known) = self.0[at].below.get(&step) {
                    return *known;
                }
                let new = self.0.len();
                let is_span = step.is_span();
                if is_span {
                    *spans += 1;
                    self.0[at].spans.push(new);
                }
                let is_element = matches!(step, Step::Elements(..)) && (at == 0 || self.0[at].is_element);
                self.0.push(Knot {
                    step: Some(step.clone()),
                    parent: at,
                    name: written(context, network.scope, node).to_smolstr(),
                    is_span: is_span || self.0[at].is_span,
                    is_element,
                    ..Knot::default()
                });
                self.0[at].below.insert(step, new);
                new
            });
        }
        at
    }

    /// The parts that places mean just so.
    pub(super) fn each(&self) -> impl Iterator<Item = Part<'_>> {
        let meant = (0..self.0.len()).filter(|index| !self.0[*index].own.is_empty());
        meant.map(|index| {
            let knot = &self.0[index];
            Part {
                name: &knot.name,
                own: &knot.own,
                touched: self.touched(index),
                is_span: knot.is_span,
                is_element: knot.is_element && !knot.is_span,
            }
        })
    }

    /// The places in groups: no place of one has something in common with one of another.
    pub(super) fn groups(&self) -> Vec<Vec<UseRef>> {
        let mut groups = Vec::new();
        let mut open = vec![(0, false)];
        while let Some((index, joined)) = open.pop() {
            let knot = &self.0[index];
            let joins = joined || !knot.own.is_empty() || !knot.spans.is_empty();
            if joins && !joined {
                groups.push(Vec::new());
            }
            if let Some(group) = groups.last_mut().filter(|_| joins) {
                group.extend_from_slice(&knot.own);
            }
            // What is in a knot is taken before all others: a group is whole before the next one begins.
            open.extend(knot.below.values().map(|below| (*below, joins)));
        }
        groups
    }

    /// What is done with a part, with what it is in, and with what is in it.
    fn touched(&self, index: usize) -> Touched {
        let mut way: Vec<&Step> = Vec::new();
        let mut at = index;
        while let Some(step) = &self.0[at].step {
            way.push(step);
            at = self.0[at].parent;
        }
        let mut touched = Touched::default();
        let mut met = vec![0];
        for step in way.into_iter().rev() {
            let mut next = Vec::new();
            for at in met {
                let knot = &self.0[at];
                touched.add(&knot.of_own);
                if step.is_span() {
                    next.extend(
                        knot.below
                            .iter()
                            .filter(|(other, _)| step.meets(other))
                            .map(|(_, at)| *at),
                    );
                } else {
                    next.extend(knot.below.get(step));
                    let spans = knot.spans.iter().copied();
                    next.extend(
                        spans.filter(|at| self.0[*at].step.as_ref().is_some_and(|other| step.meets(other))),
                    );
                }
            }
            met = next;
        }
        for at in met {
            touched.add(&self.0[at].of_all);
        }
        touched
    }
}

/// The whole path that begins with the name at a place.
pub(super) fn path_of<'c>(context: &'c Context, place: &Use) -> Option<&'c Node> {
    let block = context.networks.at(place.network).block(place.block);
    let operand = &block.bound().facts.operands[place.operand].value;
    path_at(operand, place.range - block.base)
}

/// The steps of a path, with the path up to each. A timer or counter is one with its members.
fn steps<'n>(context: &Context, scope: usize, path: &'n Node) -> Vec<(Step, &'n Node)> {
    let mut steps = Vec::new();
    let mut at = path;
    loop {
        let int = |node: &Node| match number(context, scope, node) {
            Some(Number::Int(n)) => i64::try_from(n).ok(),
            _ => None,
        };
        at = match &at.kind {
            NodeKind::Member(base, word) => {
                if matches!(context.path_type(scope, base), Some(Type::State(_))) {
                    steps.clear();
                } else {
                    steps.push((Step::Member(Name::new(&word.text)), at));
                }
                base
            }
            NodeKind::Index(base, index) => {
                let step = int(index).map_or(Step::COMPUTED, |n| Step::Elements(n, n));
                steps.push((step, at));
                base
            }
            NodeKind::Range(base, first, last) => {
                let step = int(first).zip(int(last));
                steps.push((
                    step.map_or(Step::COMPUTED, |(first, last)| Step::Elements(first, last)),
                    at,
                ));
                base
            }
            NodeKind::Paren(inner) => inner,
            _ => break,
        };
    }
    steps.reverse();
    steps
}

/// Which part of its tag a place means, as text after the tag's name with the indices as numbers: empty for the whole. None if
/// that depends on values, or if it is a range.
pub(super) fn fixed(context: &Context, scope: usize, place: &Node) -> Option<String> {
    let mut part = String::new();
    for (step, node) in steps(context, scope, place) {
        match (step, &node.kind) {
            (Step::Elements(first, last), _) if first == last => part.push_str(&format!("[{first}]")),
            (Step::Member(_), NodeKind::Member(_, word)) => part.push_str(&format!(".{}", word.text)),
            _ => return None,
        }
    }
    Some(part)
}

/// As [`fixed`], of a place where a tag is used.
pub(super) fn fixed_at(context: &Context, place: &Use) -> Option<String> {
    let scope = context.networks.at(place.network).scope;
    fixed(context, scope, path_of(context, place)?)
}

/// Whether two parts of a tag, as [`fixed`] writes them, have nothing in common.
pub(super) fn apart(one: Option<&str>, other: Option<&str>) -> bool {
    let (Some(one), Some(other)) = (one, other) else {
        return false;
    };
    let (one, other) = (Name::new(one), Name::new(other));
    let (short, long) = if one.as_str().len() < other.as_str().len() {
        (&one, &other)
    } else {
        (&other, &one)
    };
    let rest = long.as_str().strip_prefix(short.as_str());
    !rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}
