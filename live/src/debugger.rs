//! What a debugger is to a simulation: it is lent the session, and says with it what stops a run.
//!
//! The simulation stays the only one that runs scans. While a debugger is there it asks that to do each of
//! them, and tells it of all that the editor's own commands do.

use std::fmt;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicUsize;

use ladder_host::Moment;
use ladder_simulator::Session;
use ladder_workspace::Member;
use serde_json::Value;

/// A debugger of a simulation.
pub trait Debugger: Send {
    /// Answers a message of the client. Whether the simulation may be another one after it.
    fn receive(&mut self, session: &mut Session, message: &Value) -> bool;

    /// Does a piece of a run: a scan, or up to what stops it.
    fn go_on(&mut self, session: &mut Session);

    /// Goes on to the next block or rung, for a command of the editor.
    fn step(&mut self, session: &mut Session, by_block: bool);

    /// Whether it wants scans.
    fn is_running(&self) -> bool;

    /// Whether the scans that it wants come at their times.
    fn keeps_to_clock(&self) -> bool;

    /// When a run goes on that has written more than the client can show.
    fn waits(&self) -> Option<Moment>;

    /// Whether it decides what stops a run: from its launch to the end of the program.
    fn is_live(&self) -> bool;

    /// Whether its client has left.
    fn is_gone(&self) -> bool;

    /// A command of the editor made it run.
    fn resumed(&mut self);

    /// A command of the editor stopped it, or has led elsewhere.
    fn halted(&mut self, why: Halt);

    /// A command of the editor gave tags other values.
    fn given(&mut self);

    /// The text of the program is another one. Of each line of the one before it has the line that is the same.
    fn moved(&mut self, session: &mut Session, files: Vec<ProgramFile>, lines: &[Option<u32>]);

    /// The simulation is over.
    fn ended(&mut self);
}

/// Why a program that is debugged is where it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Halt {
    /// A user wants it.
    Pause,
    /// It has gone as far as was asked.
    Step,
    /// It was led to another scan.
    Elsewhere,
}

/// A file of a program, as its simulation runs it.
#[derive(Debug)]
pub struct ProgramFile {
    /// Where it lies.
    pub path: PathBuf,
    /// Its text.
    pub text: Member,
}

/// What a debugger begins with.
#[derive(Debug)]
pub struct Ground<'s> {
    /// Whether it runs.
    pub is_running: bool,
    /// What it is lent.
    pub session: &'s mut Session,
    /// The files of the program, in its order.
    pub files: Vec<ProgramFile>,
    /// How many commands wait that a long scan is given up for.
    pub urgent: Arc<AtomicUsize>,
}

type Begin = dyn FnOnce(Ground<'_>) -> Result<Box<dyn Debugger>, String> + Send;

/// Makes a debugger, in a turn of the simulation.
pub struct Beginning(pub Box<Begin>);

impl fmt::Debug for Beginning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Beginning")
    }
}
