//! What an expression was in the scan before: `was(e)`, and with what it is now `rises(e)` and `falls(e)`.

use super::Expression;
use crate::simulation::Simulation;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;

/// Which of the functions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PastKind {
    /// It is high and was low.
    Rises,
    /// It is low and was high.
    Falls,
    /// What it was.
    Was,
}

impl PastKind {
    /// By the name of the function, in any case.
    pub fn from_name(name: &str) -> Option<PastKind> {
        let all = [
            ("rises", PastKind::Rises),
            ("falls", PastKind::Falls),
            ("was", PastKind::Was),
        ];
        let mut all = all.into_iter();
        all.find_map(|(of, kind)| of.eq_ignore_ascii_case(name).then_some(kind))
    }
}

/// An expression with what it was in the scan before: FALSE or 0 before the first one.
#[derive(Debug)]
pub struct Past {
    /// Which function.
    pub kind: PastKind,
    /// Of what.
    pub of: Expression,
    before: Option<Value>,
}

impl Past {
    pub(super) fn new(kind: PastKind, of: Expression) -> Past {
        Past {
            kind,
            of,
            before: None,
        }
    }

    /// The type of its value.
    pub fn ty(&self) -> Scalar {
        match self.kind {
            PastKind::Was => self.of.ty(),
            PastKind::Rises | PastKind::Falls => Scalar::Bool,
        }
    }

    pub(super) fn for_each_before(&mut self, each: &mut dyn FnMut(&mut Option<Value>)) {
        each(&mut self.before);
        self.of.for_each_before(each);
    }

    /// Its value after a scan. Where a fault happens in the expression it counts as FALSE or 0.
    pub(super) fn step(&mut self, simulation: &Simulation) -> Value {
        let zero = || Value::zero(self.of.ty());
        let before = self.before.take().unwrap_or_else(zero);
        let now = self.of.evaluate(simulation);
        let now = now.map_or_else(|_| Value::zero(self.of.ty()), |now| now.value);
        let value = match self.kind {
            PastKind::Was => before,
            PastKind::Rises => Value::Bool(now == Value::Bool(true) && before == Value::Bool(false)),
            PastKind::Falls => Value::Bool(now == Value::Bool(false) && before == Value::Bool(true)),
        };
        self.before = Some(now);
        value
    }
}
