//! Builds green nodes, one logical line after the other.
//!
//! rowan has a builder of its own. This one differs in two ways. It hands out each line's node when the line ends, so
//! that lines can be kept apart and put into another tree after an edit. And its caches, through which equal tokens
//! and small nodes become one, are tables of fixed size in which a newcomer takes the place of what was there:
//! they stay in the processor's cache however large the file is, where rowan's grow with it.

use crate::builder::Builder;
use crate::kind::SyntaxKind;
use rowan::{GreenNode, GreenToken, GreenTokenData, NodeOrToken};
use std::ops::Range;

type Element = NodeOrToken<GreenNode, GreenToken>;

/// The largest node that is looked up. `[ ]` and names repeat; to look up larger ones costs what it saves.
const CACHED_CHILDREN: usize = 3;

/// Runs of dashes up to this long have places of their own.
const LONGEST_WIRE: usize = 100;

/// A place after the last element, from which a node may be begun later.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Checkpoint(usize);

/// What is open and what is finished of one line, and the caches for all of them.
pub(crate) struct TreeBuilder {
    elements: Vec<Element>,
    /// The kinds of the open nodes, and where their elements begin.
    open: Vec<(SyntaxKind, usize)>,
    /// Tokens of one character, by kind: half of all, and nearly all of a kind are the same.
    characters: [Option<GreenToken>; SyntaxKind::SOURCE_FILE as usize],
    /// Wires, by length.
    wires: [Option<GreenToken>; LONGEST_WIRE],
    tokens: Table<GreenToken>,
    nodes: Table<GreenNode>,
    names: Names,
}

/// What becomes of names.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Names {
    /// Equal ones become one, as all other tokens: for trees that stay.
    Shared,
    /// Each is made by itself. Nearly every name of a line is another one than those before it, and where trees go as soon as
    /// they were read, to look for it costs more than to make it.
    Apart,
}

impl TreeBuilder {
    /// A builder for a text of this many bytes.
    pub(crate) fn new(text_len: usize, names: Names) -> TreeBuilder {
        TreeBuilder {
            elements: Vec::with_capacity(64),
            open: Vec::with_capacity(16),
            characters: [const { None }; SyntaxKind::SOURCE_FILE as usize],
            wires: [const { None }; LONGEST_WIRE],
            tokens: Table::new(text_len / 8),
            nodes: Table::new(text_len / 16),
            names,
        }
    }
}

impl Builder for TreeBuilder {
    type Line = GreenNode;
    type Checkpoint = Checkpoint;

    fn token(&mut self, kind: SyntaxKind, text: &str, place: Range<usize>) {
        let text = &text[place];
        let new = || GreenToken::new(kind.into(), text);
        let token = match (kind, text.as_bytes()) {
            (SyntaxKind::IDENT, _) if self.names == Names::Apart => new(),
            (SyntaxKind::WIRE, dashes) if dashes.len() < LONGEST_WIRE => {
                self.wires[dashes.len()].get_or_insert_with(new).clone()
            }
            (_, &[byte]) => {
                let slot = &mut self.characters[kind as usize];
                match slot {
                    Some(token) if token.text().as_bytes() == [byte] => token.clone(),
                    _ => slot.insert(new()).clone(),
                }
            }
            _ => {
                let slot = self.tokens.slot(text_hash(kind, text));
                match slot {
                    Some(token) if token.kind() == kind.into() && token.text() == text => token.clone(),
                    _ => slot.insert(new()).clone(),
                }
            }
        };
        self.elements.push(NodeOrToken::Token(token));
    }

    fn start_node(&mut self, kind: SyntaxKind) {
        self.open.push((kind, self.elements.len()));
    }

    fn checkpoint(&self) -> Checkpoint {
        Checkpoint(self.elements.len())
    }

    fn start_node_at(&mut self, checkpoint: Checkpoint, kind: SyntaxKind) {
        self.open.push((kind, checkpoint.0));
    }

    fn finish_node(&mut self) {
        let Some((kind, first)) = self.open.pop() else {
            debug_assert!(false, "a node is finished that was not begun");
            return;
        };
        let children = &self.elements[first..];
        let is_apart = kind == SyntaxKind::NAME_EXPR && self.names == Names::Apart;
        let hash = if is_apart {
            None
        } else {
            small_node_hash(kind, children)
        };
        let node = match hash {
            None => GreenNode::new(kind.into(), self.elements.drain(first..)),
            Some(hash) => match self.nodes.slot(hash) {
                Some(node) if is_node_of(node, kind, children) => {
                    self.elements.truncate(first);
                    node.clone()
                }
                slot => slot
                    .insert(GreenNode::new(kind.into(), self.elements.drain(first..)))
                    .clone(),
            },
        };
        self.elements.push(NodeOrToken::Node(node));
    }

    fn finish_line(&mut self, kind: SyntaxKind) -> GreenNode {
        debug_assert!(self.open.is_empty(), "a node is begun that was not finished");
        GreenNode::new(kind.into(), self.elements.drain(..))
    }
}

/// The hash of a node that holds nothing but a few tokens; none for any other.
fn small_node_hash(kind: SyntaxKind, children: &[Element]) -> Option<u64> {
    if children.len() > CACHED_CHILDREN {
        return None;
    }
    let mut hash = kind as u64;
    for child in children {
        let NodeOrToken::Token(token) = child else {
            return None;
        };
        hash = mix(hash, address(token) as u64);
    }
    Some(hash)
}

/// Where a token lives: equal tokens that came out of the table are one.
fn address(token: &GreenTokenData) -> usize {
    std::ptr::from_ref(token).addr()
}

/// Whether a node is of this kind and holds these very tokens.
fn is_node_of(node: &GreenNode, kind: SyntaxKind, children: &[Element]) -> bool {
    node.kind() == kind.into()
        && node.children().len() == children.len()
        && node.children().zip(children).all(|pair| match pair {
            (NodeOrToken::Token(a), NodeOrToken::Token(b)) => address(a) == address(b),
            _ => false,
        })
}

/// A cache of fixed size.
struct Table<T> {
    slots: Box<[Option<T>]>,
    shift: u32,
}

impl<T> Table<T> {
    /// A table with about this many slots.
    fn new(slots: usize) -> Table<T> {
        let slots = slots.next_power_of_two().clamp(16, 4096);
        Table {
            slots: std::iter::repeat_with(|| None).take(slots).collect(),
            shift: u64::BITS - slots.trailing_zeros(),
        }
    }

    /// The slot for a hash. Its upper bits are the best mixed ones.
    fn slot(&mut self, hash: u64) -> &mut Option<T> {
        &mut self.slots[(hash >> self.shift) as usize]
    }
}

/// Fibonacci hashing: 2^64 divided by the golden ratio.
const MULTIPLIER: u64 = 0x9E37_79B9_7F4A_7C15;

fn mix(hash: u64, word: u64) -> u64 {
    (hash.rotate_left(5) ^ word).wrapping_mul(MULTIPLIER)
}

fn text_hash(kind: SyntaxKind, text: &str) -> u64 {
    let bytes = text.as_bytes();
    let mut hash = (kind as u64) << 32 | bytes.len() as u64;
    let (words, rest) = bytes.as_chunks::<8>();
    for word in words {
        hash = mix(hash, u64::from_le_bytes(*word));
    }
    // The last bytes in two halves that may overlap.
    let rest = match (rest.first_chunk::<4>(), rest.last_chunk::<4>(), rest) {
        (Some(first), Some(last), _) => {
            u64::from(u32::from_le_bytes(*first)) << 32 | u64::from(u32::from_le_bytes(*last))
        }
        (_, _, [first, .., last]) => {
            u64::from(*first) << 16 | u64::from(rest[rest.len() / 2]) << 8 | u64::from(*last)
        }
        (_, _, [only]) => u64::from(*only),
        (_, _, []) => return hash.wrapping_mul(MULTIPLIER),
    };
    mix(hash, rest)
}
