//! What is wrong with a file of scenarios lies in the file, and what is right is run.
//!
//! The first part of the input is the text of the file; the second, if there is one, that of the program.

use crate::input::{parts, text};
use crate::simulation::is_small;
use crate::trace::compile;
use ladder_simulator::scenario::{self, ScenarioError};
use ladder_simulator::{Options, Simulation};
use std::ops::Range;

/// The program of those who bring none.
const PROGRAM: &str = "VAR_INPUT start, stop : BOOL; n : INT; level : REAL; END_VAR\nVAR_OUTPUT run : BOOL; END_VAR\n\
    VAR t : TON; c : CTU; s : STRING[8]; a : ARRAY[0..3] OF INT; w : WORD; d : TIME; END_VAR\n\
    +--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----/                        |\n\
    +--[ ]( run )--[TON]( t, 50ms )--[CTU]( c, 2, R := stop )--[ADD]( a[1], n, 1 )--+\n\
    +--[GT]( level, 1.5 )--[MOV]( s, 'high' )--[MOV]( d, t.ET )--( )( w.3 )--+\n";

/// So many scans of a file are run.
const MOST_SCANS: u64 = 2_000;

pub(crate) fn check(data: &[u8]) {
    let parts = parts(data);
    let file = text(parts[0]);
    let suite = scenario::parse(&file);
    lie_in(&file, &suite.errors);
    let program = parts.get(1).map_or_else(|| PROGRAM.to_owned(), |part| text(part));
    let Some(program) = compile(&program).filter(|program| is_small(program)) else {
        return;
    };
    let options = Options {
        interval: suite
            .interval
            .map_or(Options::default().interval, |(interval, _)| interval),
        watchdog: 2_000,
    };
    let Ok(mut simulation) = Simulation::new(program, options) else {
        return;
    };
    let (cases, errors) = scenario::bind(&suite, &simulation);
    lie_in(&file, &errors);
    let (mut watched, of_properties) = scenario::bind_properties(&suite, &simulation);
    lie_in(&file, &of_properties);
    if !suite.errors.is_empty() || !errors.is_empty() || !of_properties.is_empty() {
        return;
    }
    let mut left = MOST_SCANS;
    for case in &cases {
        let scans = case.scans();
        if scans > left {
            return;
        }
        left -= scans;
        let ran = scenario::run(case, &mut watched, &mut simulation, Simulation::scan);
        assert!(ran.scans <= scans, "{file}");
        for width in [20, 100] {
            let drawn = scenario::draw(case, &ran, options.interval, width);
            assert!(
                ran.passed() || !drawn.is_empty(),
                "nothing is shown of what differs:\n{file}"
            );
        }
        for difference in &ran.differences {
            let lies = file.get(Range::<usize>::from(difference.range)).is_some();
            assert!(lies, "{difference:?} in:\n{file}");
            assert!(!scenario::sentence(case, &ran, difference, options.interval).is_empty());
        }
    }
}

fn lie_in(file: &str, errors: &[ScenarioError]) {
    for error in errors {
        let lies = file.get(Range::<usize>::from(error.range)).is_some();
        assert!(lies, "{error:?} in:\n{file}");
        assert!(!error.message.is_empty(), "{error:?} in:\n{file}");
    }
}
