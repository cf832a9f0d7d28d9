//! An and-inverter graph: every function of bits is made of ANDs of two literals, and a literal may be negated.
//!
//! Nodes are shared (the same AND is one node), constants fold, and an AND looks one level into what it joins: so what is
//! the same by its form mostly is the same node, and needs no solver.

use rustc_hash::FxHashMap;

/// A node or its negation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Lit(u32);

impl Lit {
    /// Always low.
    pub(crate) const FALSE: Lit = Lit(0);
    /// Always high.
    pub(crate) const TRUE: Lit = Lit(1);

    /// One of the two.
    pub(crate) const fn constant(high: bool) -> Lit {
        if high { Lit::TRUE } else { Lit::FALSE }
    }

    /// Its value, if it has always the same.
    pub(crate) fn known(self) -> Option<bool> {
        (self.0 < 2).then_some(self == Lit::TRUE)
    }

    /// The number of its node.
    pub(crate) const fn node(self) -> usize {
        (self.0 >> 1) as usize
    }

    /// Whether it is the negation of its node.
    pub(crate) const fn is_negated(self) -> bool {
        self.0 & 1 == 1
    }

    /// This, or its negation.
    #[must_use]
    pub(crate) const fn negated_if(self, negated: bool) -> Lit {
        Lit(self.0 ^ negated as u32)
    }
}

impl std::ops::Not for Lit {
    type Output = Lit;

    fn not(self) -> Lit {
        Lit(self.0 ^ 1)
    }
}

/// What a node is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Node {
    /// The number 0: always low.
    False,
    /// Anything.
    Leaf,
    /// Both are high.
    And(Lit, Lit),
}

/// A graph. Each node uses only nodes before it.
#[derive(Debug, Clone)]
pub(crate) struct Graph {
    nodes: Vec<Node>,
    known: FxHashMap<(Lit, Lit), Lit>,
}

impl Default for Graph {
    fn default() -> Graph {
        Graph {
            nodes: vec![Node::False],
            known: FxHashMap::default(),
        }
    }
}

impl Graph {
    /// How many nodes there are.
    pub(crate) fn len(&self) -> usize {
        self.nodes.len()
    }

    /// What a node is.
    pub(crate) fn node(&self, number: usize) -> Node {
        self.nodes[number]
    }

    /// A literal that may be anything.
    pub(crate) fn leaf(&mut self) -> Lit {
        self.push(Node::Leaf)
    }

    fn push(&mut self, node: Node) -> Lit {
        self.nodes.push(node);
        Lit((self.nodes.len() as u32 - 1) << 1)
    }

    /// The two that a literal joins, if it is an AND as it stands.
    fn parts(&self, lit: Lit) -> Option<(Lit, Lit)> {
        match self.nodes[lit.node()] {
            Node::And(a, b) => Some((a, b)),
            _ => None,
        }
    }

    /// Both are high.
    pub(crate) fn and(&mut self, a: Lit, b: Lit) -> Lit {
        let (a, b) = if a <= b { (a, b) } else { (b, a) };
        if a == Lit::FALSE || a == !b {
            return Lit::FALSE;
        }
        if a == Lit::TRUE || a == b {
            return b;
        }
        if let Some(&known) = self.known.get(&(a, b)) {
            return known;
        }
        let lit = match self.simpler(a, b).or_else(|| self.simpler(b, a)) {
            Some(lit) => lit,
            None => self.push(Node::And(a, b)),
        };
        self.known.insert((a, b), lit);
        lit
    }

    /// What the AND is, if a look into the first shows that it is less than a node.
    #[allow(clippy::many_single_char_names, reason = "literals, as formulas have them")]
    fn simpler(&mut self, a: Lit, b: Lit) -> Option<Lit> {
        let (x, y) = self.parts(a)?;
        let other = self.parts(b);
        if !a.is_negated() {
            if b == x || b == y {
                return Some(a);
            }
            if b == !x || b == !y {
                return Some(Lit::FALSE);
            }
            let (u, v) = other?;
            if b.is_negated() {
                // (x & y) & !(u & v)
                if x == !u || x == !v || y == !u || y == !v {
                    return Some(a);
                }
                if x == u || y == u {
                    return Some(self.and(a, !v));
                }
                if x == v || y == v {
                    return Some(self.and(a, !u));
                }
                return None;
            }
            let contradicts = x == !u || x == !v || y == !u || y == !v;
            return contradicts.then_some(Lit::FALSE);
        }
        // !(x & y) & b
        if b == !x || b == !y {
            return Some(b);
        }
        if b == x {
            return Some(self.and(b, !y));
        }
        if b == y {
            return Some(self.and(b, !x));
        }
        // What b implies of the two is not a condition any more: a choice under its own guard.
        for (one, two) in [(x, y), (y, x)] {
            if one.is_negated() && self.parts(one).is_some_and(|(u, v)| u == !b || v == !b) {
                return Some(self.and(b, !two));
            }
        }
        let (u, v) = other.filter(|_| b.is_negated())?;
        // !(x & y) & !(x & !y)
        for (one, two) in [(x, y), (y, x)] {
            for (three, four) in [(u, v), (v, u)] {
                if one == three && two == !four {
                    return Some(!one);
                }
            }
        }
        None
    }

    /// One of them is high.
    pub(crate) fn or(&mut self, a: Lit, b: Lit) -> Lit {
        !self.and(!a, !b)
    }

    /// They differ.
    pub(crate) fn xor(&mut self, a: Lit, b: Lit) -> Lit {
        if let Some(a) = a.known() {
            return b.negated_if(a);
        }
        if let Some(b) = b.known() {
            return a.negated_if(b);
        }
        // One form for all four combinations of signs.
        let negated = a.is_negated() ^ b.is_negated();
        let (a, b) = (a.negated_if(a.is_negated()), b.negated_if(b.is_negated()));
        let (one, other) = (self.and(a, !b), self.and(!a, b));
        self.or(one, other).negated_if(negated)
    }

    /// They are the same.
    pub(crate) fn same(&mut self, a: Lit, b: Lit) -> Lit {
        !self.xor(a, b)
    }

    /// The one where the first is high, else the other.
    pub(crate) fn choose(&mut self, which: Lit, high: Lit, low: Lit) -> Lit {
        if high == low || which == Lit::TRUE {
            return high;
        }
        if which == Lit::FALSE {
            return low;
        }
        if high == !low {
            return self.same(which, high);
        }
        let (one, other) = (self.and(which, high), self.and(!which, low));
        self.or(one, other)
    }

    /// All are high.
    pub(crate) fn all(&mut self, lits: impl IntoIterator<Item = Lit>) -> Lit {
        lits.into_iter().fold(Lit::TRUE, |all, lit| self.and(all, lit))
    }

    /// One of them is high.
    pub(crate) fn any(&mut self, lits: impl IntoIterator<Item = Lit>) -> Lit {
        lits.into_iter().fold(Lit::FALSE, |any, lit| self.or(any, lit))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_the_same_by_its_form_is_one_node() {
        let mut graph = Graph::default();
        let [a, b, c] = [graph.leaf(), graph.leaf(), graph.leaf()];
        let ab = graph.and(a, b);
        assert_eq!(graph.and(b, a), ab);
        assert_eq!(graph.and(ab, a), ab);
        assert_eq!(graph.and(ab, !b), Lit::FALSE);
        let other = graph.and(a, !b);
        assert_eq!(graph.or(ab, other), a);
        assert_eq!(graph.choose(c, a, a), a);
        let xor = graph.xor(a, b);
        assert_eq!(graph.xor(!a, b), !xor);
        let chosen = graph.choose(a, b, c);
        assert_eq!(graph.and(a, chosen), ab);
    }

    /// Every AND of two small functions of three leaves is what it should be.
    #[test]
    fn looking_into_what_is_joined_changes_nothing() {
        let mut graph = Graph::default();
        let leaves = [graph.leaf(), graph.leaf(), graph.leaf()];
        let mut pool: Vec<Lit> = leaves.iter().flat_map(|&lit| [lit, !lit]).collect();
        for round in 0..2 {
            let before = pool.clone();
            let step = if round == 0 { 1 } else { 3 };
            for &a in before.iter().step_by(step) {
                for &b in &before {
                    let lit = graph.and(a, b);
                    let lits = [a, b, lit].map(|lit| value(&graph, &leaves, lit));
                    assert_eq!(lits[0] & lits[1], lits[2]);
                    if round == 0 {
                        pool.extend([lit, !lit]);
                    }
                }
            }
        }
    }

    /// The truth table of a literal.
    fn value(graph: &Graph, leaves: &[Lit], lit: Lit) -> u8 {
        let table = match graph.node(lit.node()) {
            Node::False => 0,
            Node::Leaf => {
                let at = leaves.iter().position(|leaf| leaf.node() == lit.node());
                [0b1010_1010, 0b1100_1100, 0b1111_0000][at.unwrap_or(0)]
            }
            Node::And(a, b) => value(graph, leaves, a) & value(graph, leaves, b),
        };
        if lit.is_negated() { !table } else { table }
    }
}
