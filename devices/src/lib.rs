//! Ladder programs in real time, and what is at the other end of their wires.
//!
//! ```text
//!               scan thread                                 threads of the servers
//! Simulation --run--> before each scan: what was written  <--+
//!            --scan                                           +-- Image (one lock) <--requests-- clients
//!            --run--> after each scan: what there is to read --+
//!                         the same with what devices read     <--- Devices (a lock for each) --requests--> devices
//! ```
//!
//! - [`pace`] says when scans are due: at absolute times, so that lateness does not add up, and what was missed is counted and
//!   never caught up. [`lateness`] counts how late they were.
//! - [`real`] is the loop. It is a plain function on a thread of its own: an asynchronous runtime wakes up by a clock of 1 ms. A second
//!   thread watches it, and ends a scan that does not come back.
//! - [`modbus`] serves tags as coils and registers. Its requests see the image of one scan, and what they write is given to the
//!   program between two scans. It also asks devices, whose inputs and outputs are the program's.
//! - [`online`] watches running controllers: it reads them, and cannot write.
//! - [`system`] is what the operating system is asked and told: to wake up in time, and that the program runs.
//!
//! Nothing in here builds for WebAssembly; only `ladder run` and `ladder online` use it, the server for *Go online*, and what checks and writes
//! settings.
#![forbid(unsafe_code)]

pub mod lateness;
#[cfg(feature = "modbus")]
pub mod modbus;
pub mod online;
pub mod pace;
pub mod real;
mod source;
mod stuck;
pub mod system;
mod wrong;

#[cfg(test)]
mod tests {
    use ladder_simulator::{Options, Simulation};
    use std::sync::Arc;

    /// A program before its first scan, with an interval in nanoseconds.
    pub(crate) fn simulation(text: &str, interval: i64) -> Simulation {
        let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(text)), "program");
        let program = analysis.program().expect("a program without errors").clone();
        let options = Options {
            interval,
            ..Options::default()
        };
        Simulation::new(program, options).expect("a program that runs")
    }
}
