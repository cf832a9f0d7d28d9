//! What is known of a drawing, what stands for its parts, and what became of it so far.

use crate::expression::Typed;
use crate::graph::{End, Graph, Kind};
use crate::model::Type;
use ladder_format::Circuit;
use ladder_format::program::{Block, Element, Path};
use ladder_notation::Outcome;
use std::collections::{HashMap, HashSet};

/// What is known of a drawing before anything of it is drawn.
pub(super) struct Facts {
    /// The elements that take what leaves an output.
    pub(super) uses: HashMap<End, Vec<usize>>,
    /// All elements in the order of execution, and the place of each in it.
    pub(super) order: Vec<usize>,
    pub(super) places: Vec<usize>,
    /// The elements that read a tag by its name in small letters, and those that write it.
    pub(super) readers: HashMap<String, Vec<usize>>,
    pub(super) writers: HashMap<String, Vec<usize>>,
    /// Whether a contact sees falls, and whether something reads by name what a block writes.
    pub(super) has_falls: bool,
    pub(super) has_turns: bool,
}

impl Facts {
    pub(super) fn of(graph: &Graph) -> Facts {
        let mut uses: HashMap<End, Vec<usize>> = HashMap::new();
        for (index, node) in graph.nodes.iter().enumerate() {
            if node.kind != Kind::RightRail {
                let ends = node.inputs.iter().flat_map(|pin| &pin.from);
                ends.for_each(|end| uses.entry(*end).or_default().push(index));
            }
        }
        Facts {
            uses,
            order: graph.in_order(),
            places: vec![usize::MAX; graph.nodes.len()],
            readers: HashMap::new(),
            writers: HashMap::new(),
            has_falls: false,
            has_turns: false,
        }
    }
}

/// What stands for parts of the drawing.
#[derive(Default)]
pub(super) struct Tags {
    /// The tags that hold results, and power at points of the drawing.
    pub(super) results: HashMap<End, Path>,
    /// The tags that are high while a contact sees its edge, for the next network.
    pub(super) edges: HashMap<usize, Path>,
    /// The tags for power after blocks.
    pub(super) holders: HashMap<End, Path>,
    /// Those of them for what is read in the scan after.
    pub(super) fed_back: Vec<(End, Path)>,
    /// What else is written where a block has power: the variables that take its result.
    pub(super) moves: HashMap<usize, Vec<Block>>,
    /// The power with which variables take a result that was made above.
    pub(super) guards: HashMap<usize, End>,
    /// The operands at pins.
    pub(super) operands: HashMap<(usize, usize), Typed>,
    /// The tags that are the instances of blocks.
    pub(super) instances: HashMap<usize, Path>,
    /// The types of what leaves outputs, where they were asked for.
    pub(super) types: HashMap<End, Option<Type>>,
}

/// How far a drawing has come.
pub(super) struct State {
    /// What became of each element, where it is not the same.
    pub(super) outcomes: Vec<Option<Outcome>>,
    /// The blocks that stand in a network above.
    pub(super) executed: Vec<bool>,
    /// Variables that are written together with the block before them.
    pub(super) merged: Vec<bool>,
    /// The boxes with texts that something jumps past.
    pub(super) jumped: HashSet<usize>,
    /// The elements that stand somewhere, or are operands.
    pub(super) seen: Vec<bool>,
    /// How many elements had their turn.
    pub(super) turn: usize,
    /// How many elements were passed through, and how many points taken apart.
    pub(super) work: usize,
    pub(super) pieces: usize,
    /// The characters of all networks so far.
    pub(super) characters: usize,
}

impl State {
    /// That of a drawing with so many elements, of which nothing is drawn.
    pub(super) fn of(count: usize) -> State {
        State {
            outcomes: vec![None; count],
            executed: vec![false; count],
            merged: vec![false; count],
            jumped: HashSet::new(),
            seen: vec![false; count],
            turn: 0,
            work: 0,
            pieces: 0,
            characters: 0,
        }
    }
}

/// The next network.
#[derive(Default)]
pub(super) struct Next {
    /// What is done in it, and what feeds that.
    pub(super) group: Vec<usize>,
    pub(super) shown: HashSet<usize>,
    /// The comments above it, and above the one after it.
    pub(super) comments: Vec<String>,
    pub(super) further: Vec<String>,
    /// The labels that it begins with.
    pub(super) labels: Vec<Circuit<Element>>,
    /// The drawing is taken apart.
    pub(super) is_in_pieces: bool,
}
