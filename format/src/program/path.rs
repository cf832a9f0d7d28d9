//! A tag, a direct address, or a part of one: `cells[i].level.3`

use super::expression::List;
use super::{Expression, Invalid};
use ladder_syntax::{is_address, is_identifier, is_reserved};
use std::fmt::{self, Display, Formatter};

/// Where a value is.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Path {
    /// The name of the tag, or the address with its `%`.
    pub root: String,
    /// From there to the part.
    pub steps: Vec<Step>,
}

/// From a value to a part of it.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Step {
    /// `.name`
    Member(String),
    /// `.3`
    Bit(u32),
    /// `[i, j]`
    Index(Vec<Expression>),
    /// `[i, 3..9]`: indices of other dimensions, then the first and the last element
    Range(Vec<Expression>, Box<(Expression, Expression)>),
}

impl Path {
    /// A tag by its name, as [`Names`](crate::names::Names) makes them, or a direct address.
    pub fn tag(name: impl Into<String>) -> Path {
        Path {
            root: name.into(),
            steps: Vec::new(),
        }
    }

    /// A tag of the system: `SYS.FIRST_SCAN`
    pub fn system(name: &str) -> Path {
        Path::tag("SYS").member(name)
    }

    /// `self.name`
    #[must_use]
    pub fn member(self, name: impl Into<String>) -> Path {
        self.with(Step::Member(name.into()))
    }

    /// `self.3`
    #[must_use]
    pub fn bit(self, number: u32) -> Path {
        self.with(Step::Bit(number))
    }

    /// `self[i, j]`
    #[must_use]
    pub fn index<E: Into<Expression>>(self, indices: impl IntoIterator<Item = E>) -> Path {
        self.with(Step::Index(indices.into_iter().map(Into::into).collect()))
    }

    /// `self[3..9]`
    #[must_use]
    pub fn range(self, first: impl Into<Expression>, last: impl Into<Expression>) -> Path {
        self.with(Step::Range(Vec::new(), Box::new((first.into(), last.into()))))
    }

    /// The path with one more step.
    #[must_use]
    pub fn with(mut self, step: Step) -> Path {
        self.steps.push(step);
        self
    }

    /// The name of the tag, if it is meant as a whole.
    pub fn whole(&self) -> Option<&str> {
        self.steps.is_empty().then_some(&self.root)
    }

    /// The expressions in its brackets.
    pub fn indices(&self) -> impl Iterator<Item = &Expression> {
        self.steps.iter().flat_map(|step| match step {
            Step::Index(indices) => indices.iter().collect(),
            Step::Range(before, range) => before.iter().chain([&range.0, &range.1]).collect(),
            Step::Member(_) | Step::Bit(_) => Vec::new(),
        })
    }

    pub(super) fn indices_mut(&mut self) -> impl Iterator<Item = &mut Expression> {
        self.steps.iter_mut().flat_map(|step| match step {
            Step::Index(indices) => indices.iter_mut().collect(),
            Step::Range(before, range) => before.iter_mut().chain([&mut range.0, &mut range.1]).collect(),
            Step::Member(_) | Step::Bit(_) => Vec::new(),
        })
    }

    /// Whether it begins with a reserved word that is read as a name: `SYS.ON`, `PI`
    fn is_built_in(&self) -> bool {
        ["SYS", "PI"]
            .iter()
            .any(|word| self.root.eq_ignore_ascii_case(word))
    }

    /// Whether its own names can be written; those of its indices are asked for by themselves.
    pub(super) fn check(&self) -> Result<(), Invalid> {
        let is_name = is_identifier(&self.root) && (!is_reserved(&self.root) || self.is_built_in());
        if !is_name && !is_address(&self.root) {
            let root = &self.root;
            return Err(Invalid(format!(
                "`{root}` is not a name that a tag can have here"
            )));
        }
        for step in &self.steps {
            if let Step::Member(name) = step
                && !is_identifier(name)
            {
                return Err(Invalid(format!(
                    "`{name}` is not a name that a member can have here"
                )));
            }
        }
        Ok(())
    }
}

impl Display for Path {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.root)?;
        for step in &self.steps {
            match step {
                Step::Member(name) => write!(f, ".{name}"),
                Step::Bit(number) => write!(f, ".{number}"),
                Step::Index(indices) => write!(f, "[{}]", List(indices)),
                Step::Range(before, range) => {
                    let comma = if before.is_empty() { "" } else { ", " };
                    write!(f, "[{}{comma}{}..{}]", List(before), range.0, range.1)
                }
            }?;
        }
        Ok(())
    }
}
