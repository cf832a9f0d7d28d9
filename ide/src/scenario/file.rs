//! A scenario file with what is known of it.

use crate::neighbour::Workspace;
use ladder_analysis::context::Context;
use ladder_simulator::scenario::Suite;

/// A scenario file as features read it.
#[derive(Clone, Copy)]
pub struct Scenarios<'t> {
    /// What it says.
    pub text: &'t str,
    /// What was read from that.
    pub suite: &'t Suite,
    /// The program that it names, if that was found.
    pub program: Option<&'t Context>,
    /// The files next to the program.
    pub workspace: &'t dyn Workspace,
}
