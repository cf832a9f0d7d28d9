//! The machine of bits with values: to compare it with the simulator, cell by cell.

use crate::encode::Times;
use crate::graph::{Lit, Node};
use crate::model::{Model, build_with_points};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::{Point, Simulation};

/// A program as the prover sees it, with values.
#[derive(Debug)]
pub struct Concrete {
    model: Model,
    /// The bits of each point after a scan, from the lowest on.
    points: Vec<(Point, Vec<Lit>)>,
    /// Of each node whether it is high, and whether that is not known: something was left open.
    nodes: Vec<(bool, bool)>,
    /// The same of what is remembered.
    states: Vec<(bool, bool)>,
}

impl Concrete {
    /// Before its first scan.
    ///
    /// # Errors
    /// It cannot be followed: why.
    pub fn new(simulation: &Simulation) -> Result<Concrete, String> {
        let (model, points) = build_with_points(simulation, Times::Exact);
        if let Some(gap) = model.world.blocked {
            return Err(gap.what);
        }
        Ok(Concrete {
            points,
            nodes: vec![(false, false); model.world.graph.len()],
            states: model
                .world
                .states
                .iter()
                .map(|state| (state.initial, false))
                .collect(),
            model,
        })
    }

    /// The tags that go in.
    pub fn inputs(&self) -> impl Iterator<Item = &str> {
        self.model
            .world
            .inputs
            .iter()
            .map(|input| input.tag.name.as_str())
    }

    /// One scan, in which each input has the value that is given for its name.
    pub fn scan(&mut self, mut given: impl FnMut(&str) -> Value) {
        let world = &self.model.world;
        self.nodes.fill((false, false));
        for input in &world.inputs {
            let number = match given(&input.tag.name) {
                Value::Bool(high) => i64::from(high),
                Value::Int(number) => number,
                Value::Real(real) => real.to_bits() as i64,
                Value::Text(_) => 0,
            };
            for (n, bit) in input.bits.iter().enumerate() {
                self.nodes[bit.node()].0 = number >> n & 1 != 0;
            }
        }
        for (state, value) in world.states.iter().zip(&self.states) {
            self.nodes[state.leaf.node()] = *value;
        }
        for node in world.open.keys() {
            self.nodes[*node].1 = true;
        }
        for node in 0..world.graph.len() {
            if let Node::And(a, b) = world.graph.node(node) {
                let ((a, a_open), (b, b_open)) = (self.of(a), self.of(b));
                let is_low = (!a && !a_open) || (!b && !b_open);
                self.nodes[node] = (a && b, !is_low && (a_open || b_open));
            }
        }
        self.states = world.states.iter().map(|state| self.of(state.next)).collect();
    }

    fn of(&self, lit: Lit) -> (bool, bool) {
        let (high, is_open) = self.nodes[lit.node()];
        (high ^ lit.is_negated(), is_open)
    }

    /// Each point with what it holds after the scan; none where that depends on what was left open.
    pub fn values(&self) -> impl Iterator<Item = (&Point, Option<Value>)> {
        self.points.iter().map(|(point, bits)| {
            let mut number = 0i64;
            let mut is_open = false;
            for (n, bit) in bits.iter().enumerate() {
                let (high, open) = self.of(*bit);
                is_open |= open;
                number |= i64::from(high) << n;
            }
            let value = match point.ty {
                Scalar::Bool => Value::Bool(number != 0),
                Scalar::Real | Scalar::Lreal => Value::Real(f64::from_bits(number as u64)),
                _ => Value::Int(number),
            };
            (point, (!is_open).then_some(value))
        })
    }
}
