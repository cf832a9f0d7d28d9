//! Why a program cannot run in the simulator.

use ladder_analysis::program::Location;

/// Why a program cannot run in the simulator.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CompileError {
    /// What is wrong and what to do.
    pub message: String,
    /// Where.
    pub location: Location,
}

impl std::fmt::Display for CompileError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for CompileError {}
