//! What a unit gets beside its drawing.

use super::declare::named;
use super::names::Names;
use crate::model::{Type, Variable};
use crate::own;
use ladder_notation::LineColumn;
use std::rc::Rc;

/// See above.
#[derive(Default)]
pub(super) struct Added {
    pub(super) names: Rc<Names>,
    /// Variables that the ladder text does not have.
    pub(super) variables: Vec<Variable>,
    /// Tags that coils make retentive, as they are called in the project.
    pub(super) retentive: Vec<String>,
    /// What does not mean quite the same: the element, and why.
    pub(super) remarks: Vec<(String, String)>,
}

impl Added {
    pub(super) fn of(names: Names) -> Added {
        Added {
            names: Rc::new(names),
            ..Added::default()
        }
    }

    /// Takes over what a network made.
    pub(super) fn add(&mut self, network: Added) {
        Names::add(&mut self.names, Rc::unwrap_or_clone(network.names));
        self.variables.extend(network.variables);
        self.retentive.extend(network.retentive);
    }

    /// A variable that the ladder text does not have; comes back its name.
    pub(super) fn variable(&mut self, at: LineColumn, like: &str, ty: Type, comment: &str) -> String {
        let name = Rc::make_mut(&mut self.names).fresh(like);
        self.variables.push(Variable {
            comment: Some(comment.to_owned()),
            ..Variable::local(at, name.clone(), ty)
        });
        name
    }

    /// The variable that power ends in.
    pub(super) fn sink(&mut self, at: LineColumn) -> String {
        if let Some(name) = self.names.get(own::SINK) {
            return name.to_owned();
        }
        let name = self.variable(at, "unused", named("BOOL"), own::SINK);
        Rc::make_mut(&mut self.names).alias(own::SINK, &name);
        name
    }
}
