//! What lies between two nets, in series and in parallel, with the direction in which power passes it.

/// A part of a circuit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Subcircuit {
    pub(super) kind: Kind,
    /// Its first contact in the order of reading; of a bare wire the largest number.
    first: usize,
    /// How many contacts it has.
    contacts: usize,
}

/// What a part is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Kind {
    /// A contact by its number in the netlist.
    Contact {
        contact: usize,
        /// Power passes it from its right edge to its left one.
        reversed: bool,
    },
    /// One after the other. None: a bare wire.
    Series(Vec<Subcircuit>),
    /// Between the same two points, in the order of their first contacts.
    Parallel(Vec<Subcircuit>),
}

impl Subcircuit {
    pub(super) const fn contact(contact: usize) -> Subcircuit {
        Subcircuit {
            kind: Kind::Contact {
                contact,
                reversed: false,
            },
            first: contact,
            contacts: 1,
        }
    }

    pub(super) const fn wire() -> Subcircuit {
        Subcircuit {
            kind: Kind::Series(Vec::new()),
            first: usize::MAX,
            contacts: 0,
        }
    }

    /// How many contacts it has.
    pub(super) const fn contacts(&self) -> usize {
        self.contacts
    }

    /// What is in series in it.
    pub(super) fn into_series(self) -> Vec<Subcircuit> {
        match self.kind {
            Kind::Series(parts) => parts,
            _ => vec![self],
        }
    }

    /// Passed the other way.
    pub(super) fn reversed(self) -> Subcircuit {
        let kind = match self.kind {
            Kind::Contact { contact, reversed } => Kind::Contact {
                contact,
                reversed: !reversed,
            },
            Kind::Series(parts) => Kind::Series(parts.into_iter().rev().map(Subcircuit::reversed).collect()),
            Kind::Parallel(parts) => Kind::Parallel(parts.into_iter().map(Subcircuit::reversed).collect()),
        };
        Subcircuit { kind, ..self }
    }

    /// This, then another.
    pub(super) fn after(self, next: Subcircuit) -> Subcircuit {
        let (first, contacts) = (self.first.min(next.first), self.contacts + next.contacts);
        let mut parts = self.into_series();
        parts.extend(next.into_series());
        let kind = Kind::Series(parts);
        Subcircuit {
            kind,
            first,
            contacts,
        }
    }

    /// This, and another between the same points.
    pub(super) fn next_to(self, other: Subcircuit) -> Subcircuit {
        let (first, contacts) = (self.first.min(other.first), self.contacts + other.contacts);
        let mut branches = self.into_branches();
        for branch in other.into_branches() {
            let at = branches.partition_point(|there| there.first <= branch.first);
            branches.insert(at, branch);
        }
        let kind = Kind::Parallel(branches);
        Subcircuit {
            kind,
            first,
            contacts,
        }
    }

    /// Branches between the same points, in this order. One is itself.
    pub(super) fn any(mut branches: Vec<Subcircuit>) -> Subcircuit {
        if branches.len() == 1 {
            return branches.remove(0);
        }
        Subcircuit {
            first: branches
                .iter()
                .map(|branch| branch.first)
                .min()
                .unwrap_or(usize::MAX),
            contacts: branches.iter().map(Subcircuit::contacts).sum(),
            kind: Kind::Parallel(branches),
        }
    }

    fn into_branches(self) -> Vec<Subcircuit> {
        match self.kind {
            Kind::Parallel(branches) => branches,
            _ => vec![self],
        }
    }
}
