//! What a session is asked, and what it answers.

use std::sync::Arc;

use ladder_documents::Revision;
use ladder_picture::scene::Scene;
use ladder_syntax::TextSize;
use serde::Serialize;
use serde_json::Value;

use crate::debugger::Beginning;
use crate::debugging::Effect;
use crate::diagram_text::{DiagramText, DrawnText};
use crate::messages::{Found, History, Recorded, SceneShown, Search, Shown, State, Trace, Traced, Why};

/// How fast a run goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pace {
    /// So many times as fast as real time.
    Times(f64),
    /// As fast as it goes.
    Full,
}

impl Default for Pace {
    fn default() -> Self {
        Pace::Times(1.0)
    }
}

/// A value for a tag.
#[derive(Debug)]
pub enum Given {
    /// As JSON.
    Json(Value),
    /// As a person types it.
    Typed(String),
}

/// What a session is asked to do.
#[derive(Debug)]
pub enum Action {
    /// Do this many scans, then pause.
    Step(u64),
    /// Go on to the next block.
    StepBlock,
    /// Go on to the next rung.
    StepRung,
    /// Go back this many scans.
    Back(u64),
    /// Go to the state after this many scans.
    GoTo(u64),
    /// These lines of rungs and these tags stop a run.
    Breakpoints(Vec<u32>, Vec<String>),
    /// Say why a tag holds what it holds.
    Why(String),
    /// Make a scenario of this name of what was done so far, which expects something of these tags.
    Record(String, Option<Vec<String>>),
    /// Say what tags held in the last scans.
    History(Vec<String>, u64),
    /// Record tags, and say what is drawn of them.
    Trace(Trace),
    /// Draw lines with characters.
    DiagramText(DiagramText),
    /// Show the scene of this address from now on.
    Scene(String, Box<Scene>),
    /// Scan until another action comes.
    Run {
        /// Pause after this many scans.
        scans: Option<u64>,
        /// As fast as before if there is none.
        pace: Option<Pace>,
    },
    /// Run as fast as this from now on.
    Pace(Pace),
    /// Stop scanning.
    Pause,
    /// Give a tag a value.
    Set(String, Given),
    /// Give a tag of BOOL its other value for one scan.
    Pulse(String),
    /// Hold a tag at a value.
    Force(String, Given),
    /// Let a tag go, or all.
    Unforce(Option<String>),
    /// Nothing: only answer.
    State,
    /// Tell only of this from now on.
    Show(Shown),
    /// The client has shown what it was sent.
    HasShown,
    /// List tags.
    Tags(Search),
    /// Say what the operand at a place holds.
    ValuesAt(TextSize),
    /// Start again from cold.
    Reset,
    /// Start again with what is retentive.
    WarmRestart,
    /// The text in the editor is another one.
    Follow(Arc<Revision>),
    /// Other files are other ones: what the program uses of them may be, too. The text is the editor's as it is now.
    FollowOthers(Arc<Revision>),
    /// Serve tags to clients on this computer, or no more.
    Serve(bool),
    /// Lend the session to a debugger.
    Debug(Beginning),
    /// Give the debugger a message; with whether a long scan is given up for it.
    Message(Value, bool),
    /// End.
    Stop,
}

impl Action {
    /// Whether a step that is under way gives way to it.
    pub(crate) fn is_urgent(&self) -> bool {
        matches!(
            self,
            Action::Pause
                | Action::Reset
                | Action::WarmRestart
                | Action::Back(_)
                | Action::GoTo(_)
                | Action::Stop
                | Action::Message(_, true)
        )
    }

    /// Whether only a simulation can do it: what is watched is neither written nor stopped.
    pub(crate) fn is_for_a_simulation(&self) -> bool {
        matches!(
            self,
            Action::Step(_)
                | Action::StepBlock
                | Action::StepRung
                | Action::Back(_)
                | Action::GoTo(_)
                | Action::Breakpoints(..)
                | Action::Record(..)
                | Action::Set(..)
                | Action::Pulse(_)
                | Action::Force(..)
                | Action::Unforce(_)
                | Action::Reset
                | Action::WarmRestart
                | Action::Debug(_)
                | Action::Serve(_)
        )
    }

    /// Whether who sent it waits for the answer, and longer than a moment.
    pub(crate) fn is_awaited(&self) -> bool {
        !matches!(
            self,
            Action::ValuesAt(_)
                | Action::HasShown
                | Action::Follow(_)
                | Action::FollowOthers(_)
                | Action::Message(..)
        )
    }

    /// What the debugger of the simulation sees of it.
    pub(crate) fn effect(&self) -> Effect {
        match self {
            Action::Step(_) => Effect::Steps,
            Action::Back(_) | Action::GoTo(_) | Action::Reset | Action::WarmRestart => Effect::Leads,
            Action::Set(..) | Action::Pulse(_) | Action::Force(..) | Action::Unforce(_) => Effect::Gives,
            Action::Stop => Effect::End,
            _ => Effect::Nothing,
        }
    }

    /// Whether the simulation is differently after it.
    pub(crate) fn changes(&self) -> bool {
        !matches!(
            self,
            Action::State
                | Action::Why(_)
                | Action::Record(..)
                | Action::History(..)
                | Action::Trace(_)
                | Action::DiagramText(_)
                | Action::Scene(..)
                | Action::Tags(_)
                | Action::ValuesAt(_)
        )
    }
}

/// What a session answers.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub enum Answer {
    /// How it is.
    State(Box<State>),
    /// A debugger is there.
    Debugged,
    /// Reasons.
    Why(Box<Why>),
    /// A scenario.
    Recorded(Recorded),
    /// Values of the past.
    History(History),
    /// What is drawn of tags.
    Trace(Box<Traced>),
    /// Lines of a diagram.
    DiagramText(DrawnText),
    /// A scene.
    Scene(Box<SceneShown>),
    /// Tags that were searched for.
    Found(Found),
    /// Values, in words.
    Values(Vec<String>),
}
