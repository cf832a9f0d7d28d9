//! What a chart is, with divergences and convergences resolved.

use ladder_format::Circuit;
use ladder_format::program::{Element, Expression, Item, Origin, Path};

/// A chart. Steps and actions are named by their places in these lists.
#[derive(Debug, Default)]
pub struct Chart {
    /// In the order in which what they do is decided.
    pub steps: Vec<Step>,
    /// In the order of the source.
    pub transitions: Vec<Transition>,
    /// In the order in which their bodies run.
    pub actions: Vec<Action>,
    /// Whether a step is active for whole seconds only in the scan after: generators add so.
    pub counts_late: bool,
}

/// A step.
#[derive(Debug)]
pub struct Step {
    /// What the other system calls it.
    pub name: String,
    /// The tag that says whether it is active: `Step.X`.
    pub active: String,
    /// The tag that holds for how long: `Step.T`. It is there only if something needs it.
    pub elapsed: String,
    /// Whether it is active from the beginning.
    pub is_initial: bool,
    /// What is done while it is active, or when it begins or ends.
    pub associations: Vec<Association>,
    /// What it was made from.
    pub origin: Option<Origin>,
}

/// A transition: where all steps that it leads from are active and its condition holds, they end and those that it leads to begin.
#[derive(Debug)]
pub struct Transition {
    /// Steps that it leads from.
    pub from: Vec<usize>,
    /// Steps that it leads to.
    pub to: Vec<usize>,
    /// Of those with one the smallest is first, and keeps the others from going on.
    pub priority: Option<u32>,
    /// When it may happen.
    pub condition: Condition,
    /// What it was made from.
    pub origin: Option<Origin>,
}

/// The condition of a transition.
#[derive(Debug, Default)]
pub struct Condition {
    /// What has to run first, where something has.
    pub before: Vec<Item>,
    /// What has power if it holds; one after the other.
    pub power: Vec<Circuit<Element>>,
}

/// What a step does with an action.
#[derive(Debug)]
pub struct Association {
    /// Which action.
    pub action: usize,
    /// How.
    pub qualifier: Qualifier,
}

/// How a step does an action; times are TIMEs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Qualifier {
    /// `N`: while it is active.
    While,
    /// `S`: from now on.
    Stored,
    /// `R`: no longer.
    Reset,
    /// `P1`, `P`: in the scan in which it begins.
    AtBegin,
    /// `P0`: in the scan in which it ends.
    AtEnd,
    /// `L`: while it is active, but no longer than this.
    Limited(Expression),
    /// `D`: while it is active, after this time.
    Delayed(Expression),
    /// `SL`: from now on, but no longer than this.
    StoredLimited(Expression),
    /// `SD`: from this time on, active or not.
    StoredDelayed(Expression),
    /// `DS`: from this time on, if it is active until then.
    DelayedStored(Expression),
}

impl Qualifier {
    /// The qualifier that is written so, in any case, with its time.
    ///
    /// # Errors
    ///
    /// If there is none, or if it lacks its time.
    pub fn read(written: &str, time: Option<Expression>) -> Result<Qualifier, String> {
        let upper = written.trim().to_ascii_uppercase();
        let timed = |of: fn(Expression) -> Qualifier| match time {
            Some(time) => Ok(of(time)),
            None => Err(format!("the qualifier {upper} has no time")),
        };
        match upper.as_str() {
            "N" => Ok(Qualifier::While),
            "S" => Ok(Qualifier::Stored),
            "R" => Ok(Qualifier::Reset),
            "P" | "P1" => Ok(Qualifier::AtBegin),
            "P0" => Ok(Qualifier::AtEnd),
            "L" => timed(Qualifier::Limited),
            "D" => timed(Qualifier::Delayed),
            "SL" => timed(Qualifier::StoredLimited),
            "SD" => timed(Qualifier::StoredDelayed),
            "DS" => timed(Qualifier::DelayedStored),
            _ => Err(format!("there is no qualifier `{}`", written.trim())),
        }
    }

    /// Whether it reads for how long a step is active.
    pub(super) const fn reads_elapsed(&self) -> bool {
        matches!(self, Qualifier::Limited(_) | Qualifier::Delayed(_))
    }
}

/// An action.
#[derive(Debug)]
pub struct Action {
    /// What the other system calls it.
    pub name: String,
    /// What it is.
    pub act: Act,
    /// What it was made from.
    pub origin: Option<Origin>,
}

/// What an action is.
#[derive(Debug)]
pub enum Act {
    /// A BOOL.
    Variable(Path),
    /// Networks.
    Body(Vec<Item>),
}
