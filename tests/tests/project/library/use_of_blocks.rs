//! Blocks of the library in programs: where they may stand, and which block a name means.

use ladder_analysis::{analyze, link};
use ladder_simulator::value_text::display;
use ladder_simulator::{Options, Simulation};
use ladder_syntax::parse;
use ladder_workspace::Workspace;
use std::sync::Arc;

/// What a tag holds after so many scans of 100 ms each.
fn after(simulation: &mut Simulation, scans: usize, tag: &str) -> String {
    for _ in 0..scans {
        assert!(simulation.scan());
    }
    assert!(simulation.take_faults().is_empty());
    let point = simulation.resolve(tag).expect("a tag of the program");
    display(&simulation.value(&point), point.ty)
}

fn options() -> Options {
    Options {
        interval: 100_000_000,
        ..Options::default()
    }
}

fn runs(program: &str) -> Simulation {
    let analysis = Arc::new(analyze(&Arc::new(parse(program)), "program"));
    let program = link(&analysis, &|_| None).unwrap_or_else(|_| panic!("{:#?}", analysis.diagnostics()));
    Simulation::new(program, options()).expect("it compiles")
}

#[test]
fn a_name_is_read_in_any_case() {
    let mut simulation = runs("+--[$tOGGLE]( )--( )( lamp )--+\n+--[$pid]( 20.0, 10.0, 2.0, Y => out )--+\n");
    assert_eq!(after(&mut simulation, 1, "lamp"), "TRUE");
    assert_eq!(after(&mut simulation, 1, "out"), "20.0");
}

#[test]
fn in_a_loop_it_is_one_block() {
    // Its state belongs to the place in the text, and no time passes between two turns.
    let mut simulation = runs(
        "VAR inputs, ramps : ARRAY[1..3] OF LREAL; k : DINT; END_VAR\n\
         +--[FILL]( inputs[1..3], 5.0 )--+\n\
         +--<FOR>( 3, I => k )--+\n\
         +--[$Ramp]( inputs[k], 10.0, 10.0, ramps[k] )--+\n\
         +--<NEXT>--+\n",
    );
    assert_eq!(after(&mut simulation, 4, "ramps[3]"), "3.0");
    assert_eq!(after(&mut simulation, 0, "ramps[1]"), "3.0");
}

#[test]
fn a_loop_in_its_body_does_not_end_the_loop_around_it() {
    let mut simulation = runs(
        "VAR k, turns : DINT; END_VAR\n\
         +--<FOR>( 3, I => k )--+\n\
         +--[$Alternate]( 2, 3, RUN1 => a, RUN2 => b, RUN3 => c )--[ADD]( turns, turns, k )--+\n\
         +--<NEXT>--+\n",
    );
    assert_eq!(after(&mut simulation, 1, "turns"), "6");
    assert_eq!(after(&mut simulation, 0, "b"), "TRUE");
    assert_eq!(after(&mut simulation, 0, "c"), "FALSE");
}

#[test]
fn in_functions_and_in_other_blocks_each_place_has_its_own_state() {
    let mut simulation = runs(
        "FUNCTION_BLOCK [$Twice]\n\
         VAR_OUTPUT hours, half : LREAL; END_VAR\n\
         VAR slow : BOOL; END_VAR\n\
         +--[ ]( EN )--[$RunTime]( HOURS => hours )--+\n\
         +--[$Blink]( 100ms, 100ms, slow )--[$RunTime]( HOURS => half )--+\n\
         END_FUNCTION_BLOCK\n\
         +--[$Twice]( first )--+\n\
         +--[ ]( never )--[$Twice]( second )--+\n\
         +--<CALL>( count )--+\n\
         +--<FUN>( count )--[$RunTime]( STARTS => starts )--+\n",
    );
    assert_eq!(after(&mut simulation, 37, "first"), "0.001");
    assert_eq!(after(&mut simulation, 0, "second"), "0.0");
    assert_eq!(after(&mut simulation, 0, "starts"), "1");
}

#[test]
fn in_a_program_of_any_profile_it_does_the_same() {
    let delayed = |profile: &str| {
        let mut simulation = runs(&format!(
            "# ladder: profile {profile} #\n+--[$Debounce]( SYS.ON, 300ms, clean )--+\n\
             +--[TON]( t, T#300ms )--( )( plain )--+\n"
        ));
        [3, 1].map(|scans| {
            (
                after(&mut simulation, scans, "clean"),
                after(&mut simulation, 0, "plain"),
            )
        })
    };
    let [iec, ldmicro] = ["iec", "ldmicro"].map(delayed);
    assert_eq!([&iec[0].0, &iec[1].0], ["FALSE", "TRUE"]);
    assert_eq!([&ldmicro[0].0, &ldmicro[1].0], ["FALSE", "TRUE"]);
    // The timers of the programs themselves do differ.
    assert_ne!([&iec[0].1, &iec[1].1], [&ldmicro[0].1, &ldmicro[1].1]);
}

#[test]
fn a_controller_by_hand_holds_its_own_output() {
    let mut simulation = runs(
        "VAR y : LREAL; END_VAR\n\
         +--[GE]( SYS.SCAN, 2 )--( )( hand )--+\n\
         +--[$PID]( 20.0, 10.0, 2.0, 1.0, 0.0, 0.0, 100.0, hand, y, y )--+\n",
    );
    assert_eq!(after(&mut simulation, 2, "y"), "21.0");
    assert_eq!(after(&mut simulation, 5, "y"), "21.0");
}

#[test]
fn a_block_of_the_workspace_takes_precedence() {
    let own =
        "FUNCTION_BLOCK [$toggle]\nVAR_OUTPUT n : DINT; END_VAR\n+--[MOV]( n, 7 )--+\nEND_FUNCTION_BLOCK\n";
    let used = "VAR n : DINT; END_VAR\n+--[$Toggle]( n )--+\n+--[$Scale]( n, 0, 14, 0, 100, percent )--+\n";
    let mut simulation = runs(&format!("{own}{used}"));
    assert_eq!(after(&mut simulation, 1, "n"), "7");
    // The same with its definition in another file.
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("blocks.clad"), own).unwrap();
    let program = folder.path().join("program.clad");
    std::fs::write(&program, used).unwrap();
    let workspace = Workspace::of(&program).unwrap();
    let analysis = workspace.analysis(workspace.program_at(&program).unwrap());
    assert!(!analysis.has_errors(), "{:#?}", analysis.diagnostics());
    let linked = workspace
        .link(&analysis)
        .unwrap_or_else(|_| panic!("it is whole"));
    let mut simulation = Simulation::new(linked.program, options()).unwrap();
    assert_eq!(after(&mut simulation, 1, "n"), "7");
    assert_eq!(after(&mut simulation, 0, "percent"), "50.0");
}
