//! From what blocks name to points, and back.

use crate::simulation::{Scope, Simulation};
use crate::tags::Point;
use ladder_analysis::program::{Argument, Block, BlockKind, Expr, ExprKind, Place, RangeRef, TagId};
use ladder_analysis::values::value::Value;
use ladder_instructions::Group;

/// The tags that an argument names, or may name.
pub(super) fn argument_tags(argument: &Argument) -> Vec<TagId> {
    match argument {
        Argument::Parts(parts) => parts.iter().flat_map(argument_tags).collect(),
        Argument::ChosenState(chosen) => {
            let all = 0..chosen.count;
            all.map(|n| TagId(chosen.first.0 + n * chosen.step)).collect()
        }
        argument => argument.root().into_iter().collect(),
    }
}

/// What a block reads, with the values of now. Of a timer or counter how far it has come.
pub(super) fn values_read(simulation: &Simulation, scope: &Scope, block: &Block) -> Vec<(Point, Value)> {
    let mut reads = Reads::of(simulation, scope);
    for bound in &block.arguments {
        let BlockKind::Instruction(row) = block.kind else {
            reads.argument(&bound.argument);
            continue;
        };
        match &bound.argument {
            argument @ (Argument::State(_) | Argument::ChosenState(_)) if row.group == Group::State => {
                let state = scope.argument_name(simulation, argument);
                let members = state
                    .into_iter()
                    .flat_map(|state| ["ET", "CV"].map(|member| format!("{state}.{member}")));
                reads.names.extend(members);
            }
            Argument::Place(place, _) if row.group == Group::Condition => {
                reads.names.extend(scope.name(simulation, place));
            }
            argument => reads.argument(argument),
        }
    }
    reads.values()
}

/// What an argument is made of, with the values of now.
pub(super) fn argument_values(
    simulation: &Simulation,
    scope: &Scope,
    argument: &Argument,
) -> Vec<(Point, Value)> {
    let mut reads = Reads::of(simulation, scope);
    reads.argument(argument);
    reads.values()
}

/// What the indices are made of in a place that an argument names.
pub(super) fn index_values(
    simulation: &Simulation,
    scope: &Scope,
    argument: &Argument,
) -> Vec<(Point, Value)> {
    let mut reads = Reads::of(simulation, scope);
    match argument {
        Argument::Place(place, _) => reads.indices(place),
        Argument::ChosenState(chosen) => reads.expr(&chosen.number),
        _ => {}
    }
    reads.values()
}

/// The names that are read somewhere.
struct Reads<'s> {
    simulation: &'s Simulation,
    scope: &'s Scope,
    names: Vec<String>,
}

impl<'s> Reads<'s> {
    fn of(simulation: &'s Simulation, scope: &'s Scope) -> Reads<'s> {
        Reads {
            simulation,
            scope,
            names: Vec::new(),
        }
    }

    fn argument(&mut self, argument: &Argument) {
        match argument {
            Argument::Value(expr) => self.expr(expr),
            Argument::Range(range) => self.range(range),
            Argument::Parts(parts) => parts.iter().for_each(|part| self.argument(part)),
            _ => {}
        }
    }

    fn indices(&mut self, place: &Place) {
        match place {
            Place::Element(_, index) => self.expr(index),
            Place::Chosen(chosen) | Place::ChosenMember(chosen, _) => self.expr(&chosen.number),
            Place::Bit(inner, ..) | Place::As(inner, ..) => self.indices(inner),
            Place::Tag(_) | Place::Member(..) | Place::System(_) => {}
        }
    }

    fn expr(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Constant(_) => {}
            ExprKind::Read(place) => self.names.extend(self.scope.name(self.simulation, place)),
            ExprKind::Pass(inner) | ExprKind::Unary(_, inner) => self.expr(inner),
            ExprKind::Binary(_, left, right) | ExprKind::Compare(_, left, right) => {
                self.expr(left);
                self.expr(right);
            }
            ExprKind::Call(_, arguments) => arguments.iter().for_each(|argument| self.expr(argument)),
            ExprKind::Sum(range) => self.range(range),
            ExprKind::Offset(subscripts) => {
                for subscript in subscripts {
                    self.expr(&subscript.index);
                }
            }
        }
    }

    /// The first elements of a range stand for all.
    fn range(&mut self, range: &RangeRef) {
        const SHOWN: i64 = 16;
        let names = range_names(self.simulation, self.scope, range, SHOWN);
        self.names.extend(names);
    }

    fn values(self) -> Vec<(Point, Value)> {
        let mut values: Vec<(Point, Value)> = Vec::new();
        let points = self
            .names
            .iter()
            .filter_map(|name| self.simulation.resolve(name).ok());
        for point in points {
            if values.iter().all(|(known, _)| *known != point) {
                let value = self.simulation.value(&point);
                values.push((point, value));
            }
        }
        values
    }
}

/// The names of the elements of a range, but of no more than this.
pub(super) fn range_names(
    simulation: &Simulation,
    scope: &Scope,
    range: &RangeRef,
    most: i64,
) -> Vec<String> {
    let first = scope.number(simulation, &range.first);
    let last = range
        .last
        .as_ref()
        .and_then(|last| scope.number(simulation, last));
    let (Some(first), Some(last)) = (first, last) else {
        return Vec::new();
    };
    let elements = first..=last.min(first.saturating_add(most - 1));
    elements
        .map(|index| scope.element(simulation, range.tag, index))
        .collect()
}
