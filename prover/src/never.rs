//! Whether a function is low for all values of what it is made of, where that is quickly seen.

use crate::graph::{Graph, Lit, Node};
use crate::limits::{End, Limits};
use batsat::{Solver, SolverInterface, SolverOpts, lbool};
use rustc_hash::FxHashMap;

/// On a function of more nodes there is no verdict.
const MOST_NODES: usize = 4_000;
const CONFLICTS: u64 = 500;

/// False: it may be high, or that is not quickly seen.
pub(crate) fn is_never(graph: &Graph, lit: Lit, end: &End) -> bool {
    if let Some(known) = lit.known() {
        return !known;
    }
    let mut solver = Solver::new(SolverOpts::default(), Limits::new(end.clone(), CONFLICTS));
    let mut variables: FxHashMap<usize, batsat::Var> = FxHashMap::default();
    let mut stack = vec![lit.node()];
    while let Some(node) = stack.pop() {
        if variables.contains_key(&node) {
            continue;
        }
        if variables.len() == MOST_NODES {
            return false;
        }
        variables.insert(node, solver.new_var_default());
        if let Node::And(a, b) = graph.node(node) {
            stack.extend([a.node(), b.node()]);
        }
    }
    let of = |lit: Lit| batsat::Lit::new(variables[&lit.node()], !lit.is_negated());
    for (node, variable) in &variables {
        let it = batsat::Lit::new(*variable, true);
        match graph.node(*node) {
            Node::And(a, b) => {
                let (a, b) = (of(a), of(b));
                solver.add_clause_reuse(&mut vec![!it, a]);
                solver.add_clause_reuse(&mut vec![!it, b]);
                solver.add_clause_reuse(&mut vec![it, !a, !b]);
            }
            Node::False => {
                solver.add_clause_reuse(&mut vec![!it]);
            }
            Node::Leaf => {}
        }
    }
    solver.solve_limited(&[of(lit)]) == lbool::FALSE
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Number;

    #[test]
    fn the_smaller_of_two_is_not_larger_than_either() {
        let (mut graph, end) = (Graph::default(), End::default());
        let bits = (0..8).map(|_| graph.leaf()).collect();
        let few = Number::unsigned(bits);
        let five = Number::constant(5);
        let least = graph.min(&few, &five);
        let more = graph.less(&five, &least);
        assert!(is_never(&graph, more, &end));
        let less = graph.less(&least, &five);
        assert!(!is_never(&graph, less, &end));
        assert!(is_never(&graph, Lit::FALSE, &end) && !is_never(&graph, Lit::TRUE, &end));
    }
}
