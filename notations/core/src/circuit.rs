//! A network of the program model as what is in series and in parallel: what most notations can say.

use ladder_analysis::program::{Network, Step};
use ladder_format::Circuit;
use std::collections::HashMap;

/// The blocks of a network (indices into [`Network::blocks`]) in series and in parallel, from the left rail to wherever
/// power ends. Written from left to right and top to bottom they are in the order in which they are evaluated. None:
/// the network is a bridge, has a block that no power can reach, has an order that such a drawing would not keep, or is
/// very large.
pub fn series_parallel(network: &Network) -> Option<Circuit<usize>> {
    if network.steps.len() > MOST_STEPS {
        return None;
    }
    if network.blocks.is_empty() {
        return Some(Circuit::Series(Vec::new()));
    }
    let mut graph = Graph::of(network)?;
    graph.reduce();
    let circuit = graph.only_edge()?;
    let block_of = |step: usize| match network.steps[step] {
        Step::Block { block, .. } => Circuit::Element(block),
        Step::Start { .. } | Step::Join { .. } => Circuit::Series(Vec::new()),
    };
    in_order(&circuit).then(|| circuit.replaced(&block_of))
}

/// A network with more steps is not checked: circuits nest, and what walks them has only so much stack.
const MOST_STEPS: usize = 8_192;

/// Whether the elements are in their order when they are read from left to right and top to bottom.
pub fn in_order(circuit: &Circuit<usize>) -> bool {
    fn follow(circuit: &Circuit<usize>, last: &mut Option<usize>) -> bool {
        match circuit {
            Circuit::Element(element) => last.replace(*element) < Some(*element),
            Circuit::Series(parts) | Circuit::Parallel(parts) => parts.iter().all(|part| follow(part, last)),
        }
    }
    follow(circuit, &mut None)
}

/// The wires of a drawing, each from one point to another with the elements on it: from the left rail
/// ([`Wires::SOURCE`]) to wherever power ends ([`Wires::SINK`]).
pub struct Wires {
    /// For each point one that is the same, nearer to the one that stands for all of them.
    same: Vec<usize>,
    wires: Vec<(usize, usize, Vec<usize>)>,
}

impl Wires {
    /// The left rail.
    pub const SOURCE: usize = SOURCE;
    /// The right rail, and the end of every wire that leads nowhere.
    pub const SINK: usize = SINK;

    /// Without wires, and with this many points between the rails.
    pub fn new(points: usize) -> Wires {
        Wires {
            same: (0..points + 2).collect(),
            wires: Vec::new(),
        }
    }

    /// The n-th point between the rails.
    pub const fn point(n: usize) -> usize {
        n + 2
    }

    /// A wire with elements on it. They are numbered from left to right and from the upper wire to the lowest.
    pub fn add(&mut self, from: usize, to: usize, elements: Vec<usize>) {
        self.wires.push((from, to, elements));
    }

    /// Makes two points one.
    pub fn join(&mut self, one: usize, other: usize) {
        let (one, other) = (self.root(one), self.root(other));
        self.same[other.max(one)] = one.min(other);
    }

    fn root(&mut self, mut point: usize) -> usize {
        while self.same[point] != point {
            self.same[point] = self.same[self.same[point]];
            point = self.same[point];
        }
        point
    }

    /// What the wires make. None: they are a bridge, or some lead from nowhere.
    pub fn into_circuit(mut self) -> Option<Circuit<usize>> {
        let count = self.same.len();
        let mut goes_on = vec![false; count];
        let mut wires = std::mem::take(&mut self.wires);
        for (from, to, _) in &mut wires {
            (*from, *to) = (self.root(*from), self.root(*to));
            goes_on[*from] = true;
        }
        let mut graph = Graph::between(count);
        for (from, to, elements) in wires {
            let circuit = match elements[..] {
                [element] => Circuit::Element(element),
                _ => Circuit::Series(elements.into_iter().map(Circuit::Element).collect()),
            };
            let to = if goes_on[to] { to } else { SINK };
            graph.add(Edge { from, to, circuit });
        }
        graph.reduce();
        graph.only_edge()
    }
}

/// The first step of a circuit; a bare wire comes last.
fn first(circuit: &Circuit<usize>) -> usize {
    match circuit {
        Circuit::Element(step) => *step,
        Circuit::Series(parts) | Circuit::Parallel(parts) => parts.first().map_or(usize::MAX, first),
    }
}

/// What leads from one point to another: a circuit of steps.
struct Edge {
    from: usize,
    to: usize,
    circuit: Circuit<usize>,
}

/// The points of a network and what lies between them. It shrinks: what is in series or in parallel becomes one edge.
struct Graph {
    edges: Vec<Option<Edge>>,
    /// The edges that end and begin at each point. Those that are gone are skipped.
    into: Vec<Vec<usize>>,
    out_of: Vec<Vec<usize>>,
    between: HashMap<(usize, usize), usize>,
}

const SOURCE: usize = 0;
const SINK: usize = 1;

impl Graph {
    /// Without edges, between this many points.
    fn between(points: usize) -> Graph {
        Graph {
            edges: Vec::new(),
            into: vec![Vec::new(); points],
            out_of: vec![Vec::new(); points],
            between: HashMap::new(),
        }
    }

    fn of(network: &Network) -> Option<Graph> {
        // For each step the point whose power it gives; none where there never is any.
        let mut points: Vec<Option<usize>> = Vec::with_capacity(network.steps.len());
        let mut count = 2;
        let mut edges = Vec::new();
        for (index, step) in network.steps.iter().enumerate() {
            let point = match *step {
                Step::Start { rail } => rail.then_some(SOURCE),
                Step::Block { en, .. } => {
                    count += 1;
                    edges.push(Edge {
                        from: points[en]?,
                        to: count - 1,
                        circuit: Circuit::Element(index),
                    });
                    Some(count - 1)
                }
                Step::Join { upper, lower } => match (points[upper], points[lower]) {
                    (Some(upper), Some(lower)) if upper != lower => {
                        count += 1;
                        edges.extend([upper, lower].map(|from| Edge {
                            from,
                            to: count - 1,
                            circuit: Circuit::Series(Vec::new()),
                        }));
                        Some(count - 1)
                    }
                    (one, other) => one.or(other),
                },
            };
            points.push(point);
        }
        let mut goes_on = vec![false; count];
        for edge in &edges {
            goes_on[edge.from] = true;
        }
        let mut graph = Graph::between(count);
        for mut edge in edges {
            // Where power ends, it ends: whether at the rail or in the air makes no difference.
            if !goes_on[edge.to] {
                edge.to = SINK;
            }
            graph.add(edge);
        }
        Some(graph)
    }

    /// Adds an edge; next to another between the same points, it becomes a branch of that.
    fn add(&mut self, edge: Edge) {
        let (from, to) = (edge.from, edge.to);
        let index = self.edges.len();
        match self.between.get(&(from, to)).copied() {
            Some(other) => {
                if let Some(there) = self.edges[other].take() {
                    self.edges[other] = Some(next_to(there, edge));
                }
            }
            None => {
                self.between.insert((from, to), index);
                self.out_of[from].push(index);
                self.into[to].push(index);
                self.edges.push(Some(edge));
            }
        }
    }

    /// Makes one edge of what is in series, until nothing does.
    fn reduce(&mut self) {
        let mut waiting: Vec<usize> = (2..self.into.len()).rev().collect();
        while let Some(point) = waiting.pop() {
            let edges = &self.edges;
            self.into[point].retain(|edge| edges[*edge].is_some());
            self.out_of[point].retain(|edge| edges[*edge].is_some());
            let (&[before], &[after]) = (&self.into[point][..], &self.out_of[point][..]) else {
                continue;
            };
            let (Some(before), Some(after)) = (self.edges[before].take(), self.edges[after].take()) else {
                continue;
            };
            self.between.remove(&(before.from, point));
            self.between.remove(&(point, after.to));
            waiting.extend([before.from, after.to].iter().filter(|point| **point > SINK));
            self.add(Edge {
                from: before.from,
                to: after.to,
                circuit: after_each_other(before.circuit, after.circuit),
            });
        }
    }

    fn only_edge(self) -> Option<Circuit<usize>> {
        let mut left = self.edges.into_iter().flatten();
        match (left.next(), left.next()) {
            (Some(edge), None) if edge.from == SOURCE && edge.to == SINK => Some(edge.circuit),
            _ => None,
        }
    }
}

fn after_each_other(before: Circuit<usize>, after: Circuit<usize>) -> Circuit<usize> {
    let mut parts = match before {
        Circuit::Series(parts) => parts,
        one => vec![one],
    };
    match after {
        Circuit::Series(more) => parts.extend(more),
        one => parts.push(one),
    }
    match parts.len() {
        1 => parts.remove(0),
        _ => Circuit::Series(parts),
    }
}

/// Two edges between the same points as one: its branches from top to bottom in the order of evaluation.
fn next_to(there: Edge, more: Edge) -> Edge {
    let branches = |circuit| match circuit {
        Circuit::Parallel(branches) => branches,
        one => vec![one],
    };
    let mut all = branches(there.circuit);
    for branch in branches(more.circuit) {
        let at = first(&branch);
        all.insert(all.partition_point(|other| first(other) <= at), branch);
    }
    Edge {
        circuit: Circuit::Parallel(all),
        ..there
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};

    fn shown(circuit: &Circuit<usize>, names: &[&str]) -> String {
        let all = |parts: &[Circuit<usize>], between: &str| {
            let parts: Vec<String> = parts.iter().map(|part| shown(part, names)).collect();
            format!("({})", parts.join(between))
        };
        match circuit {
            Circuit::Element(block) => names[*block].to_owned(),
            Circuit::Series(parts) => all(parts, " "),
            Circuit::Parallel(branches) => all(branches, " | "),
        }
    }

    #[track_caller]
    fn check(text: &str, expected: Expect) {
        let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "test.clad");
        let program = analysis.program().expect("the program has no errors");
        let mut out = String::new();
        for network in &program.networks {
            let names: Vec<&str> = network
                .blocks
                .iter()
                .map(|block| {
                    text[block.location.range]
                        .split(['(', ')', ' '])
                        .rev()
                        .nth(2)
                        .unwrap_or("?")
                })
                .collect();
            match series_parallel(network) {
                Some(circuit) => out.push_str(&shown(&circuit, &names)),
                None => out.push_str("no"),
            }
            out.push('\n');
        }
        expected.assert_eq(&out);
    }

    #[test]
    fn series_and_branches() {
        check(
            r"
+--\--[ ]( start )--\--[/]( stop )--( )( run )--+
|  /--[ ]( run )----/                           |

+--\--[ ]( a )--------\--( )( y )--+
|  /--\--[ ]( b )--\--/            |
|     /--[ ]( c )--/               |

+--[ ]( a )--\--[ ]( b )--( )( p )--\--+
|            /--( )( q )------------/  |

+--[ ]( a )--\--( )( r )--+
+--[ ]( b )--/--( )( s )--+

+--[ ]( a )--\--------\--( )( t )--+
|            /--[ ]( b )--/        |
",
            expect![[r#"
                ((start | run) stop run)
                ((a | b | c) y)
                (a ((b p) | q))
                ((a | b) (r | s))
                (a (b | ()) t)
            "#]],
        );
    }

    #[test]
    fn bridges_and_dead_blocks_are_none() {
        check(
            r"
+--[ ]( a )--\--[ ]( b )-----\--( )( y )--+
|            /--[/]( x )--\--/            |
+--[ ]( c )---------------/--[ ]( d )--( )( z )--+
",
            expect![[r#"
                no
            "#]],
        );
    }

    #[test]
    fn many_branches_take_linear_work() {
        let mut text = "+--\\--[ ]( a0 )--\\--( )( y )--+\n".to_owned();
        for n in 1..2_000 {
            text.push_str(&format!("|  /--\\--[ ]( a{n} )--\\--/  |\n"));
        }
        text.push_str("|     /--[ ]( last )--/  |\n");
        let analysis = ladder_analysis::analyze(&ladder_syntax::parse(&text).into(), "test.clad");
        let program = analysis.program().expect("the program has no errors");
        let Some(Circuit::Series(parts)) = series_parallel(&program.networks[0]) else {
            panic!("branches before a coil are in series with it");
        };
        let Circuit::Parallel(branches) = &parts[0] else {
            panic!("the branches are in parallel");
        };
        assert_eq!(branches.len(), 2_001);
    }
}
