//! One simulation, which goes on by turns: on a thread of its own where there are threads.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use futures::channel::mpsc::{UnboundedSender, unbounded};
use futures::channel::oneshot;
use ladder_analysis::Cancel;
use ladder_documents::Revision;
use ladder_documents::position::Range;
use ladder_host::newest::{Receiver, newest};
use ladder_host::{Busy, Host};

use crate::action::{Action, Answer, Pace};
use crate::engine::Engine;
use crate::messages::{Options, State, Status};
use crate::queue::Queue;
use crate::request::Failure;
use crate::retention::Keeping;
use crate::runner::Runner;
use crate::running_program::{Detail, Simulation};

/// A command on its way to the runner, and where its answer goes.
pub(crate) struct Command {
    pub(crate) action: Action,
    pub(crate) cancel: Cancel,
    pub(crate) reply: oneshot::Sender<Result<Answer, Failure>>,
}

/// What there is to tell of a session that has begun.
#[derive(Debug)]
pub struct Begun {
    /// The newest state, from before the first scan on.
    pub states: Receiver<State>,
    /// Sentences for the person.
    pub notes: Vec<String>,
    /// Where the first rung is.
    pub first: Option<Range>,
}

/// The handle of a session. That ends when it is asked to stop, or when the handle is dropped.
#[derive(Debug)]
pub struct Session {
    /// Its name.
    pub id: String,
    /// The document it runs.
    pub uri: Arc<str>,
    commands: UnboundedSender<Command>,
    queue: Arc<Queue>,
    /// Whether the client has shown what it was sent last.
    has_shown: Arc<AtomicBool>,
}

impl Session {
    /// Starts a program. Compiles it first: for a blocking thread. `running` counts the session until it has let go of everything.
    ///
    /// # Errors
    /// The program cannot run, or there is no thread for it: a sentence for the person.
    pub fn start(
        id: String,
        revision: Arc<Revision>,
        options: &Options,
        keeping: &Keeping,
        host: &dyn Host,
        running: &Busy,
    ) -> Result<(Self, Begun), Failure> {
        let (commands, inbox) = unbounded();
        let queue = Queue::new(host);
        let uri = revision.uri.clone();
        let (mut engine, notes) = Engine::start(revision, options, keeping, host.world())?;
        engine.obey(queue.cancel_of_run());
        let first = engine.first_rung();
        let mut simulation = Simulation {
            id: id.clone(),
            engine,
            status: Status::Paused,
            hit: None,
            debugging: None,
            pace: Pace::default(),
            answers: 0,
        };
        let (states, receiver) = newest(simulation.state(Detail::Picture));
        let has_shown = Arc::new(AtomicBool::new(true));
        let mut runner = Runner {
            simulation,
            run: None,
            inbox,
            queue: queue.clone(),
            has_shown: has_shown.clone(),
            owes: false,
            shown: host.world().clock.now(),
            clock: host.world().clock.clone(),
            states,
            _running: running.begin(),
        };
        // A controller runs by itself.
        if runner.simulation.engine.controller.is_some() {
            runner.start_run(None, None);
        }
        host.give_turns(format!("simulation {id}"), Box::new(runner))
            .map_err(|error| Failure::Failed(format!("no thread for the simulation: {error}")))?;
        let session = Session {
            id,
            uri,
            commands,
            queue,
            has_shown,
        };
        let begun = Begun {
            states: receiver,
            notes,
            first,
        };
        Ok((session, begun))
    }

    /// Hands over an action and returns where its answer will arrive. An answer that nobody waits for is no
    /// error; `cancel` stops a step before its end.
    pub fn ask(&self, action: Action, cancel: Cancel) -> oneshot::Receiver<Result<Answer, Failure>> {
        let (reply, answer) = oneshot::channel();
        self.queue.enter(&action);
        if matches!(action, Action::HasShown) {
            // A long step does not look at what waits.
            self.has_shown.store(true, Ordering::SeqCst);
        }
        // When the runner is gone, so is the other end of `reply`: the caller sees that.
        let _ = self.commands.unbounded_send(Command {
            action,
            cancel,
            reply,
        });
        answer
    }
}
