//! `ladder diff` of files and folders.

mod neighbours;
mod other_systems;
mod runs;
mod texts;

use crate::harness::MOTOR;

fn edited() -> String {
    MOTOR.replace("[/]( stop )", "[ ]( stop )")
}
