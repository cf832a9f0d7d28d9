//! What must hold before a block may act, and what is computed on the way: a fault keeps it from acting (LANGUAGE §5.2).

use crate::project::Service;
use crate::term::{Binding, Term};
use crate::unit::Unit;
use ladder_analysis::values::types::Scalar;

/// A step on the way.
#[derive(Debug, Clone)]
pub(crate) enum Check {
    /// Must hold, else it is a fault.
    Holds(Term),
    /// Statements that compute something.
    Lines(Vec<String>),
}

pub(crate) type Checks = Vec<Check>;

impl Unit<'_, '_> {
    /// A value that is one of its type, and may be read as often as one likes.
    pub(crate) fn settle(&mut self, term: Term, ty: Scalar, checks: &mut Checks) -> Term {
        if !term.is_raw {
            return term;
        }
        let held = self.held(&term, ty, checks);
        if ty.is_real() {
            checks.push(Check::Holds(self.is_finite(&held, ty)));
        }
        held
    }

    /// A value as a name, or as it is where it is one already.
    pub(crate) fn named(&mut self, term: Term, ty: Scalar, checks: &mut Checks) -> Term {
        let is_name = term.text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        if is_name && !term.is_risky && !term.is_raw {
            return term;
        }
        if term.is_raw {
            return self.settle(term, ty, checks);
        }
        self.held(&term, ty, checks)
    }

    /// A value in a variable of its own.
    pub(crate) fn held(&mut self, term: &Term, ty: Scalar, checks: &mut Checks) -> Term {
        let name = self.value_temporary(ty);
        checks.push(Check::Lines(vec![format!("{name} := {};", term.text)]));
        Term::variable(&name)
    }

    pub(crate) fn is_finite(&mut self, term: &Term, ty: Scalar) -> Term {
        let piece = if ty == Scalar::Real {
            "LADDER_IS_REAL"
        } else {
            "LADDER_IS_LREAL"
        };
        self.project.used.pieces.insert(piece);
        Term::call(piece, &[term])
    }

    /// Writes statements that are run if all that is checked holds, and the power that a step leaves after them. Where it does not
    /// hold, that is low. `done` is its variable, if anything asks.
    pub(crate) fn all_or_low(
        &mut self,
        checks: Checks,
        mut lines: Vec<String>,
        power: &Term,
        (step, done): (usize, Option<String>),
    ) {
        if let Some(done) = &done {
            self.line(format!("{done} := FALSE;"));
            lines.push(format!("{done} := {};", power.text));
        }
        self.guarded(None, checks, &lines, None);
        self.is_done(step, done);
    }

    /// Writes statements that are run with this power, if what is checked before holds. Whether it does is what comes back, if it
    /// is asked for.
    pub(crate) fn guarded(
        &mut self,
        en: Option<&Term>,
        checks: Checks,
        lines: &[String],
        done: Option<&str>,
    ) {
        if let Some(done) = done {
            self.line(format!("{done} := FALSE;"));
        }
        let counts = self
            .project
            .used
            .faults_count
            .then(|| self.service(Service::Faulted));
        let mut depth = 0;
        let mut waiting: Vec<Term> = en.cloned().into_iter().collect();
        let mut is_fault = false;
        let mut else_of: Vec<bool> = Vec::new();
        for check in checks {
            match check {
                Check::Holds(term) => {
                    // A fault is told apart from a low power.
                    if counts.is_some() && !is_fault && !waiting.is_empty() {
                        self.open_if(&mut waiting);
                        else_of.push(false);
                        depth += 1;
                    }
                    is_fault = true;
                    waiting.push(term);
                }
                Check::Lines(all) => {
                    if !waiting.is_empty() {
                        self.open_if(&mut waiting);
                        else_of.push(is_fault);
                        depth += 1;
                        is_fault = false;
                    }
                    for line in &all {
                        self.line(line);
                    }
                }
            }
        }
        if !waiting.is_empty() {
            self.open_if(&mut waiting);
            else_of.push(is_fault);
            depth += 1;
        }
        for line in lines {
            self.line(line);
        }
        if let Some(done) = done {
            self.line(format!("{done} := TRUE;"));
        }
        for _ in 0..depth {
            if let (Some(true), Some(faulted)) = (else_of.pop(), &counts) {
                self.other();
                let faulted = format!("{faulted} := TRUE;");
                self.line(faulted);
            }
            self.close("END_IF;");
        }
    }

    fn open_if(&mut self, waiting: &mut Vec<Term>) {
        if let Some(all) = Term::all(waiting) {
            self.open(format!("IF {} THEN", all.text));
        }
        waiting.clear();
    }
}

/// `a >= first AND a <= last`
pub(crate) fn is_within(term: &Term, first: i128, last: i128, ty: Scalar) -> Option<Term> {
    let (least, most) = ty.bounds().unwrap_or((i128::MIN, i128::MAX));
    // Compilers refuse to compare an unsigned number with one below 0.
    if last < least || first > most {
        return Some(Term::whole("FALSE"));
    }
    let low =
        (first > least).then(|| Term::binary(term, ">=", &Term::whole(first.to_string()), Binding::Order));
    let high =
        (last < most).then(|| Term::binary(term, "<=", &Term::whole(last.to_string()), Binding::Order));
    let both: Vec<Term> = low.into_iter().chain(high).collect();
    Term::all(&both)
}
