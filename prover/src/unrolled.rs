//! Scans one after the other: the machine's functions with the values of earlier scans put in, and a solver that knows them.

use crate::graph::{Graph, Lit, Node};
use crate::limits::{End, Limits};
use crate::model::Model;
use batsat::{Solver, SolverInterface, SolverOpts, lbool};
use rustc_hash::FxHashMap;

/// Where the scans begin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum From {
    /// From the cold start.
    Start,
    /// Anywhere.
    Anywhere,
}

/// More nodes, of all scans, are too many.
const MOST_NODES: usize = 10_000_000;

/// What came of a question.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Found {
    Yes,
    No,
    /// It took too long.
    Unknown,
}

/// See the module.
pub(crate) struct Unrolled<'m> {
    model: &'m Model,
    from: From,
    /// The functions of all scans.
    graph: Graph,
    /// For each scan what the nodes of the model are in it.
    scans: Vec<FxHashMap<usize, Lit>>,
    /// Of the leaves of the model the state that each is.
    states: FxHashMap<usize, usize>,
    solver: Solver<Limits>,
    /// What the solver calls a node of the graph.
    variables: FxHashMap<usize, batsat::Var>,
}

impl<'m> Unrolled<'m> {
    pub(crate) fn new(model: &'m Model, from: From, end: &End) -> Unrolled<'m> {
        let states = model.world.states.iter().enumerate();
        let limits = Limits::new(end.clone(), u64::MAX);
        Unrolled {
            model,
            from,
            graph: Graph::default(),
            scans: Vec::new(),
            states: states
                .map(|(number, state)| (state.leaf.node(), number))
                .collect(),
            solver: Solver::new(SolverOpts::default(), limits),
            variables: FxHashMap::default(),
        }
    }

    /// Adds a scan, in which all that is assumed holds. False: nothing that is assumed can hold in it.
    pub(crate) fn add_scan(&mut self) -> bool {
        self.scans.push(FxHashMap::default());
        let scan = self.scans.len() - 1;
        if self.from == From::Anywhere {
            for n in 0..self.model.lemmas.len() {
                let lemma = self.lit(scan, self.model.lemmas[n]);
                self.require(lemma);
            }
        }
        (0..self.model.assumed.len()).all(|n| {
            let assumed = self.lit(scan, self.model.assumed[n]);
            self.require(assumed)
        })
    }

    /// Adds a scan of which only what it begins with is used.
    pub(crate) fn add_next(&mut self) {
        self.scans.push(FxHashMap::default());
    }

    /// What a literal of the model is in a scan.
    pub(crate) fn lit(&mut self, scan: usize, lit: Lit) -> Lit {
        let mut stack = vec![(scan, lit.node())];
        while let Some(&(scan, node)) = stack.last() {
            if self.scans[scan].contains_key(&node) {
                stack.pop();
                continue;
            }
            let known = |scan: usize, lit: Lit| -> Option<Lit> {
                Some(self.scans[scan].get(&lit.node())?.negated_if(lit.is_negated()))
            };
            let value = match self.model.world.graph.node(node) {
                Node::False => Lit::FALSE,
                Node::And(a, b) => match (known(scan, a), known(scan, b)) {
                    (Some(a), Some(b)) => self.graph.and(a, b),
                    (one, other) => {
                        stack.extend(one.is_none().then_some((scan, a.node())));
                        stack.extend(other.is_none().then_some((scan, b.node())));
                        continue;
                    }
                },
                Node::Leaf => match self.states.get(&node) {
                    Some(&state) if scan > 0 => {
                        let next = self.model.world.states[state].next;
                        let Some(value) = known(scan - 1, next) else {
                            stack.push((scan - 1, next.node()));
                            continue;
                        };
                        value
                    }
                    Some(&state) if self.from == From::Start => {
                        Lit::constant(self.model.world.states[state].initial)
                    }
                    _ => self.graph.leaf(),
                },
            };
            self.scans[scan].insert(node, value);
            stack.pop();
        }
        self.scans[scan][&lit.node()].negated_if(lit.is_negated())
    }

    /// The same, if it was asked for already.
    pub(crate) fn knows(&self, scan: usize, lit: Lit) -> Option<Lit> {
        let found = self.scans.get(scan)?.get(&lit.node())?;
        Some(found.negated_if(lit.is_negated()))
    }

    /// Makes the solver know a literal in a scan. Whether that is new to it.
    pub(crate) fn make_known(&mut self, scan: usize, lit: Lit) -> bool {
        let lit = self.lit(scan, lit);
        if lit.known().is_some() || self.variables.contains_key(&lit.node()) {
            return false;
        }
        self.solver_lit(lit);
        true
    }

    /// What the solver calls a literal that is not known.
    fn solver_lit(&mut self, lit: Lit) -> batsat::Lit {
        let mut stack = vec![lit.node()];
        while let Some(&node) = stack.last() {
            if self.variables.contains_key(&node) {
                stack.pop();
                continue;
            }
            if let Node::And(a, b) = self.graph.node(node) {
                let missing = [a, b].map(Lit::node).into_iter();
                let missing: Vec<usize> = missing
                    .filter(|node| !self.variables.contains_key(node))
                    .collect();
                if !missing.is_empty() {
                    stack.extend(missing);
                    continue;
                }
                let of = |lit: Lit| batsat::Lit::new(self.variables[&lit.node()], !lit.is_negated());
                let (a, b) = (of(a), of(b));
                let variable = self.solver.new_var_default();
                let it = batsat::Lit::new(variable, true);
                self.solver.add_clause_reuse(&mut vec![!it, a]);
                self.solver.add_clause_reuse(&mut vec![!it, b]);
                self.solver.add_clause_reuse(&mut vec![it, !a, !b]);
                self.variables.insert(node, variable);
            } else {
                let variable = self.solver.new_var_default();
                self.variables.insert(node, variable);
            }
            stack.pop();
        }
        batsat::Lit::new(self.variables[&lit.node()], !lit.is_negated())
    }

    /// One of these holds from now on. False: nothing is left that could be.
    pub(crate) fn require_one(&mut self, lits: &[Lit]) -> bool {
        if lits.contains(&Lit::TRUE) {
            return self.solver.is_ok();
        }
        let lits: Vec<Lit> = lits.iter().copied().filter(|lit| *lit != Lit::FALSE).collect();
        let mut clause: Vec<batsat::Lit> = lits.into_iter().map(|lit| self.solver_lit(lit)).collect();
        self.solver.add_clause_reuse(&mut clause)
    }

    /// This holds from now on.
    pub(crate) fn require(&mut self, lit: Lit) -> bool {
        self.require_one(&[lit])
    }

    /// A literal that may be anything, in no scan.
    pub(crate) fn selector(&mut self) -> Lit {
        self.graph.leaf()
    }

    /// One of them differs.
    pub(crate) fn differ(&mut self, pairs: &[(Lit, Lit)]) -> Lit {
        let mut any = Lit::FALSE;
        for &(a, b) in pairs {
            let differs = self.graph.xor(a, b);
            any = self.graph.or(any, differs);
        }
        any
    }

    /// Whether all of these can hold.
    pub(crate) fn ask(&mut self, lits: &[Lit], conflicts: u64) -> Found {
        if lits.contains(&Lit::FALSE) || !self.solver.is_ok() {
            return Found::No;
        }
        let lits: Vec<Lit> = lits.iter().copied().filter(|lit| *lit != Lit::TRUE).collect();
        let assumptions: Vec<batsat::Lit> = lits.into_iter().map(|lit| self.solver_lit(lit)).collect();
        self.solver.cb().allow(conflicts);
        if self.solver.cb().is_over() {
            return Found::Unknown;
        }
        let answer = self.solver.solve_limited(&assumptions);
        if answer == lbool::TRUE {
            Found::Yes
        } else if answer == lbool::FALSE {
            Found::No
        } else {
            Found::Unknown
        }
    }

    /// What a literal of the model is in a scan of the run that was found. What that does not depend on is low.
    pub(crate) fn value(&self, scan: usize, lit: Lit) -> bool {
        let Some(of_scan) = self.scans[scan].get(&lit.node()) else {
            return false;
        };
        self.value_of(*of_scan) ^ lit.is_negated()
    }

    /// What a literal is in what was found.
    pub(crate) fn value_of(&self, lit: Lit) -> bool {
        if let Some(known) = lit.known() {
            return known;
        }
        let high = self.variables.get(&lit.node());
        let high = high.is_some_and(|variable| self.solver.value_var(*variable) == lbool::TRUE);
        high ^ lit.is_negated()
    }

    /// Whether there are so many functions that more scans are too many.
    pub(crate) fn is_full(&self) -> bool {
        self.graph.len() > MOST_NODES
    }

    /// How many steps the solver has made: what follows from what it tried.
    pub(crate) fn work(&self) -> u64 {
        self.solver.num_propagations()
    }

    /// How many clauses the solver was given.
    pub(crate) fn clauses(&self) -> u64 {
        self.solver.num_clauses()
    }
}
