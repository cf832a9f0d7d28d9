//! Direct addresses: one tag of the whole program each, whatever its names and the files that name it (LANGUAGE §4).

use crate::support::{check, force, get, linked, set, simulation, simulation_of, unforce};
use expect_test::expect;
use ladder_simulator::{Options, Simulation};

/// What is called by the main programs of these tests.
const CALLS: &str = "+--<CALL>( work )--+\n";

#[test]
fn names_of_one_file_are_one_tag() {
    check(
        "VAR\n    a AT %MW3 : INT := 5;\n    b AT %mw003 : INT;\n    c, d AT %QX0.0 : BOOL;\nEND_VAR\n\
         +--[ADD]( a, b, 1 )--[GT]( b, 7 )--( )( c )--+\n+--[ ]( %QX00.0 )--[MOV]( b, 0 )--+\n+--[ ]( d )--( )( e )--+\n",
        "6",
        "a b %MW3 %MW03 c d e",
        expect![[r#"
            a      6 7 0 1 2 3
            b      6 7 0 1 2 3
            %MW3   6 7 0 1 2 3
            %MW03  6 7 0 1 2 3
            c      __-___
            d      __-___
            e      __-___
        "#]],
    );
}

#[test]
fn a_body_means_the_same_address_at_every_place() {
    let mut simulation = simulation(
        "VAR a AT %MW3 : INT; END_VAR\n+--[$Count]( )--[$Count]( )--[$Bare]( )--[ADD]( n, a, 0 )--+\n\
         FUNCTION_BLOCK [$Count]\nVAR own AT %MW3 : INT; END_VAR\n+--[ ]( EN )--[ADD]( own, own, 1 )--+\nEND_FUNCTION_BLOCK\n\
         FUNCTION_BLOCK [$Bare]\n+--[ ]( EN )--[ADD]( %MW3, %MW3, 10 )--+\nEND_FUNCTION_BLOCK\n",
    );
    simulation.scan();
    simulation.scan();
    let names = ["a", "n", "%MW3", "$Count#1.own", "$Count#2.own"];
    assert_eq!(names.map(|name| get(&simulation, name)), ["24"; 5]);
    force(&mut simulation, "$Count#2.own", "7");
    simulation.scan();
    assert_eq!(names.map(|name| get(&simulation, name)), ["7"; 5]);
}

/// What a body calls so is not what the program calls so.
#[test]
fn a_name_of_a_body_is_another_one_outside() {
    let simulation = simulation(
        "VAR own : INT := 3; END_VAR\n+--[$Count]( )--[ADD]( own, own, 0 )--+\n\
         FUNCTION_BLOCK [$Count]\nVAR own AT %MW3 : INT := 8; END_VAR\n+--[ ]( EN )--[MOV]( own, own )--+\nEND_FUNCTION_BLOCK\n",
    );
    assert_eq!(get(&simulation, "own"), "3");
    assert_eq!(get(&simulation, "$Count#1.own"), "8");
    let program = simulation.program();
    let body = &program.networks[program.blocks[0].networks.start];
    let ladder_analysis::program::Argument::Place(place, _) = &body.blocks[1].arguments[0].argument else {
        panic!("MOV writes a place");
    };
    assert_eq!(simulation.point_at(place, "own"), None);
}

#[test]
fn files_share_an_address() {
    let declared = "VAR level AT %MW3 : INT; lamp AT %QX0.1 : BOOL; END_VAR\n";
    let counts = "+--<FUN>( work )--[ADD]( %MW3, %MW3, 1 )--[GT]( %MW3, 1 )--( )( %QX0.1 )--+\n";
    // The file that declares it is the program's, or the other one; or both do.
    let bare =
        format!("VAR seen : WORD; END_VAR\n{CALLS}+--[MOV]( seen, %MW3 )--[ ]( %qx00.1 )--( )( on )--+\n");
    let named = format!(
        "{declared}VAR seen : INT; END_VAR\n{CALLS}+--[MOV]( seen, level )--[ ]( lamp )--( )( on )--+\n"
    );
    let adds = "+--<FUN>( work )--[ADD]( level, level, 1 )--[GT]( level, 1 )--( )( lamp )--+\n";
    for (main, other, names) in [
        (
            &named,
            counts
                .replace("[ADD]( %MW3, %MW3, 1 )", "[ADD]( n, n, 1 )--[TYP]( %MW3, n )")
                .replace("[GT]( %MW3", "[GT]( n"),
            "level lamp",
        ),
        (&bare, format!("{declared}{adds}"), "library.level library.lamp"),
        (
            &named,
            format!("{declared}{adds}"),
            "level lamp library.level library.lamp",
        ),
        (
            &named,
            format!(
                "VAR_GLOBAL g AT %MW3 : INT; END_VAR\n{}",
                adds.replace("level", "g").replace("lamp", "%QX0.1")
            ),
            "g level lamp",
        ),
        (
            &bare,
            format!(
                "VAR_GLOBAL g AT %MW3 : INT; END_VAR\n{}",
                adds.replace("level", "g").replace("lamp", "%QX0.1")
            ),
            "g %QX0.1",
        ),
    ] {
        let mut simulation = simulation_of(&[("main.clad", main), ("library.clad", &other)]);
        simulation.scan();
        assert_eq!(get(&simulation, "seen"), "1", "{main}{other}");
        assert_eq!(get(&simulation, "on"), "0", "{main}{other}");
        simulation.scan();
        assert_eq!(get(&simulation, "seen"), "2", "{main}{other}");
        assert_eq!(get(&simulation, "on"), "1", "{main}{other}");
        for name in names.split(' ') {
            let value = get(&simulation, name);
            assert!(
                value == "2" || value == "1" && name.contains(['Q', 'p']),
                "{name} is {value}\n{main}{other}"
            );
        }
    }
}

/// A global of another file, of which nothing runs here but what names its tag.
#[test]
fn a_global_at_an_address_is_the_address() {
    let main = "+--[MOV]( level, 5 )--[NE]( %MW3, 16#0 )--( )( on )--+\n";
    let mut simulation = simulation_of(&[
        ("main.clad", main),
        ("globals.clad", "VAR_GLOBAL level AT %MW3 : INT; END_VAR\n"),
    ]);
    simulation.scan();
    assert_eq!(
        (get(&simulation, "on"), get(&simulation, "%MW3")),
        ("1".into(), "5".into())
    );
}

#[test]
fn three_files_share_an_address() {
    let main = "VAR a AT %MW3 : INT; n : WORD; END_VAR\n+--[MOV]( a, -1 )--[$Bits]( n )--<CALL>( work )--+\n";
    let bits = "FUNCTION_BLOCK [$Bits]\nVAR_OUTPUT read : WORD; END_VAR\nVAR b AT %MW3 : WORD; END_VAR\n\
                +--[ ]( EN )--[MOV]( read, %MW3 )--( )( b.15 )--(R)( b.0 )--+\nEND_FUNCTION_BLOCK\n";
    let third = "VAR c AT %MW3 : UINT; seen : UINT; END_VAR\n\
                 +--<FUN>( work )--[MOV]( seen, c )--[ADD]( c, c, 3 )--[GT]( c, 0 )--( )( wrapped )--+\n";
    let mut simulation = simulation_of(&[("main.clad", main), ("bits.clad", bits), ("third.clad", third)]);
    simulation.scan();
    // The same bits in each type.
    assert_eq!(get(&simulation, "n"), "65535");
    assert_eq!(get(&simulation, "third.seen"), "65534");
    assert_eq!(get(&simulation, "third.wrapped"), "1");
    for name in ["a", "%MW3", "third.c"] {
        assert_eq!(get(&simulation, name), "1", "{name}");
    }
    // The names of a body in another file.
    assert_eq!(get(&simulation, "$Bits#1.read"), "65535");
    assert_eq!(get(&simulation, "$Bits#1.b"), "1");
    // A forced one reads as forced by all its names, in each type.
    force(&mut simulation, "third.c", "-2");
    simulation.scan();
    assert_eq!(get(&simulation, "n"), "65534");
    assert_eq!(get(&simulation, "a"), "-2");
}

#[test]
fn an_in_out_may_be_an_address_of_another_type() {
    let main = "VAR a AT %MW3 : INT; END_VAR\n+--[MOV]( a, -1 )--<CALL>( work )--+\n";
    let other = "+--<FUN>( work )--[$More]( %MW3 )--+\n\
                 FUNCTION_BLOCK [$More]\nVAR_IN_OUT w : WORD; END_VAR\nVAR_OUTPUT high : BOOL; END_VAR\n\
                 +--[EQ]( w, 16#FFFF )--[MOV]( w, 16#8000 )--(S)( w.0 )--+\nEND_FUNCTION_BLOCK\n";
    let mut simulation = simulation_of(&[("main.clad", main), ("other.clad", other)]);
    simulation.scan();
    assert_eq!(get(&simulation, "a"), "-32767");
}

#[test]
fn a_force_holds_all_names() {
    let mut simulation = simulation(
        "VAR_INPUT a AT %IX0.0 : BOOL; END_VAR\nVAR b AT %IX0.0 : BOOL; y, z : BOOL; END_VAR\n\
         +--[ ]( a )--( )( y )--+\n+--[ ]( b )--( )( z )--+\n",
    );
    let seen = |simulation: &Simulation| ["a", "b", "%IX0.0", "y", "z"].map(|name| get(simulation, name));
    set(&mut simulation, "b", "1");
    simulation.scan();
    assert_eq!(seen(&simulation), ["1"; 5]);
    force(&mut simulation, "b", "0");
    let point = simulation.resolve("a").unwrap();
    assert!(simulation.is_forced(&point));
    // Inputs go on arriving underneath, by any name.
    set(&mut simulation, "a", "0");
    set(&mut simulation, "%IX0.0", "1");
    simulation.scan();
    assert_eq!(seen(&simulation), ["0"; 5]);
    unforce(&mut simulation, "a");
    simulation.scan();
    assert_eq!(seen(&simulation), ["1"; 5]);
    assert_eq!(simulation.forced().count(), 0);
}

#[test]
fn one_retentive_name_keeps_the_address() {
    let text = "VAR a AT %MW3 : INT; END_VAR\nVAR RETAIN b AT %MW3 : INT; END_VAR\n+--[ADD]( a, a, 1 )--+\n\
                +--[$Keeps]( )--+\nFUNCTION_BLOCK [$Keeps]\nVAR RETAIN c AT %MD7 : DINT := 40; END_VAR\n\
                +--[ ]( EN )--[ADD]( c, c, 2 )--+\nEND_FUNCTION_BLOCK\n";
    let mut before = simulation(text);
    before.scan();
    before.scan();
    let kept = before.retained();
    before.warm_restart();
    assert_eq!(
        (get(&before, "b"), get(&before, "%MD7")),
        ("2".into(), "44".into())
    );
    let mut other = simulation(text);
    assert_eq!(other.warm_start(&kept), Vec::<String>::new());
    assert_eq!(
        (get(&other, "a"), get(&other, "$Keeps#1.c")),
        ("2".into(), "44".into())
    );
}

/// Files that do not agree on an address make no program.
#[test]
fn files_agree_on_an_address() {
    let other = |declaration: &str| {
        format!("{declaration}\n+--<FUN>( work )--[EQ]( x, x )--[EQ]( %MD4, 16#1 )--( )( q )--+\n")
    };
    for (own, others, message) in [
        (
            "VAR a AT %MD3 : REAL; END_VAR",
            "VAR x AT %MD3 : DINT; END_VAR",
            "`library.x` is DINT, and `a` at the same address %MD3 is REAL",
        ),
        (
            "VAR a AT %MD4 : REAL; x : REAL; END_VAR",
            "VAR x : DINT; END_VAR",
            "`%MD4` is DWORD here, and `a` at this address is REAL",
        ),
        (
            "VAR a AT %MD3 : DINT := 5; END_VAR",
            "VAR x AT %MD03 : DINT := 6; END_VAR",
            "`library.x` starts with another value than `a` at the same address %MD03",
        ),
        (
            "VAR CONSTANT a AT %MD3 : DINT := 5; END_VAR",
            "VAR x AT %MD3 : DINT; END_VAR",
            "`a` is CONSTANT, and `library.x` at the same address %MD3 is not",
        ),
        // One that says nothing of it agrees.
        (
            "VAR a AT %MD3 : DINT; END_VAR",
            "VAR x AT %MD3 : DWORD := 16#FFFFFFFF; END_VAR",
            "",
        ),
        (
            "VAR CONSTANT a AT %MD4 : DINT := 5; END_VAR",
            "VAR x : DINT; END_VAR",
            "",
        ),
    ] {
        let main = format!("{own}\n{CALLS}+--[EQ]( a, a )--( )( on )--+\n");
        let program = linked(&[("main.clad", &main), ("library.clad", &other(others))]).unwrap();
        let found = match Simulation::new(program, Options::default()) {
            Ok(_) => String::new(),
            Err(refused) => refused.message,
        };
        let (told, _) = found
            .split_once(": an address is one tag")
            .unwrap_or((&found, ""));
        assert_eq!(told, message, "{own} {others}");
    }
}
