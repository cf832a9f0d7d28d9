use super::{prepare_rename, rename};
use crate::fixture::Fixture;
use expect_test::{Expect, expect};
use ladder_format::{Options, apply};

fn renamed(text: &str, new: &str) -> String {
    let fixture = Fixture::new(text);
    let (context, offset, others) = fixture.ask();
    match rename(context, offset, new, &others, &Options::default()) {
        Err(refused) => format!("refused: {refused}\n"),
        Ok(files) => {
            let several = fixture.files.len() > 1;
            let show = files.iter().map(|file| {
                let head = if several {
                    format!("%% {}\n", file.file)
                } else {
                    String::new()
                };
                head + &apply(fixture.text(&file.file), &file.edits)
            });
            show.collect::<Vec<_>>().concat()
        }
    }
}

fn check(text: &str, new: &str, expected: Expect) {
    expected.assert_eq(&renamed(text, new));
}

#[test]
fn the_drawing_follows() {
    check(
        "\
+--\\--[ ]( start )--\\-----------------( )( r$0un )--+
|  /--[ ]( run )----/                             |

+--[ ]( run )--------------------------( )( x )--+
",
        "motor_is_running",
        expect![[r#"
            +--\--[ ]( start )-------------\----------------------( )( motor_is_running )--+
            |  /--[ ]( motor_is_running )--/                                               |

            +--[ ]( motor_is_running )-------------------------------------------( )( x )--+
        "#]],
    );
    check(
        "VAR_INPUT\n    start : BOOL;  # ö #\n    b     : BOOL;\nEND_VAR\n\n+--[ ]( sta$0rt )--( )( b )--+\n",
        "go",
        expect![[r#"
            VAR_INPUT
                go : BOOL;  # ö #
                b  : BOOL;
            END_VAR

            +--[ ]( go )---------------------------------------------------------( )( b )--+
        "#]],
    );
}

#[test]
fn a_network_that_nobody_laid_out_is_left_alone() {
    check(
        "+--[ ]( a$0 )------------------( )( b )--+\n\n+-[ ]( c )-( )( d )-+\n\n+--[ ]( e )------------------( )( f )--+\n",
        "longer",
        expect![[r#"
            +--[ ]( longer )-----------------------------------------------------( )( b )--+

            +-[ ]( c )-( )( d )-+

            +--[ ]( e )------------------( )( f )--+
        "#]],
    );
}

#[test]
fn what_is_as_wide_as_before_moves_nothing() {
    check(
        "VAR a,b:BOOL; END_VAR\n+-[ ]( a$0 )-(S)( b )-+\n",
        "x",
        expect![[r#"
            VAR x,b:BOOL; END_VAR
            +-[ ]( x )-(S)( b )-+
        "#]],
    );
    check(
        "VAR a,b:BOOL; END_VAR\n+-[ ]( a$0 )-(S)( b )-+\n",
        "xy",
        expect![[r#"
            VAR xy,b:BOOL; END_VAR
            +--[ ]( xy )---------------------------------------------------------(S)( b )--+
        "#]],
    );
}

#[test]
fn all_files() {
    let plant = "%% a.clad\nVAR_GLOBAL\n    total : DINT;\nEND_VAR\n\
        %% b.clad\nVAR_EXTERNAL\n    total : DINT;\nEND_VAR\n+--[GT]( total, 3 )------------( )( y )--+\n\
        %% c.clad\nVAR total : INT; END_VAR\n+--[GT]( total, 3 )------------( )( y )--+\n";
    check(
        &plant.replace(
            "  total : DINT;\nEND_VAR\n%% b",
            "  tot$0al : DINT;\nEND_VAR\n%% b",
        ),
        "sum",
        expect![[r#"
            %% a.clad
            VAR_GLOBAL
                sum : DINT;
            END_VAR
            %% b.clad
            VAR_EXTERNAL
                sum : DINT;
            END_VAR
            +--[GT]( sum, 3 )----------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "%% lib.clad\nFUNCTION_BLOCK [$Wait]\nVAR_INPUT\n    raw : BOOL;\nEND_VAR\n+--[ ]( raw )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\
         %% main.clad\n+--[$Wait]( ra$0w := x )-------------( )( y )--+\n",
        "button",
        expect![[r#"
            %% main.clad
            +--------------------------------------------[$Wait]( button := x )--( )( y )--+
            %% lib.clad
            FUNCTION_BLOCK [$Wait]
            VAR_INPUT
                button : BOOL;
            END_VAR
            +--[ ]( button )---------------------------------------------------( )( ENO )--+
            END_FUNCTION_BLOCK
        "#]],
    );
    check(
        "%% lib.clad\nFUNCTION_BLOCK [$Wait]\nVAR_INPUT raw : BOOL; END_VAR\n+--[ ]( raw )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\
         %% main.clad\n+--[$wa$0it]( x )--------------------( )( y )--+\n",
        "Pause",
        expect![[r#"
            %% main.clad
            +-----------------------------------------------------[$Pause]( x )--( )( y )--+
            %% lib.clad
            FUNCTION_BLOCK [$Pause]
            VAR_INPUT raw : BOOL; END_VAR
            +--[ ]( raw )--( )( ENO )--+
            END_FUNCTION_BLOCK
        "#]],
    );
    check(
        "%% lib.clad\n+--<FUN>( count )--+\n%% main.clad\n+--[ ]( a )--------------<CALL>( cou$0nt )--+\n",
        "add_one",
        expect![[r#"
            %% main.clad
            +--[ ]( a )-------------------------------------------------<CALL>( add_one )--+
            %% lib.clad
            +--<FUN>( add_one )------------------------------------------------------------+
        "#]],
    );
}

#[test]
fn scenarios_follow() {
    let plant = "%% lib.clad\nVAR_GLOBAL total : DINT; END_VAR\n+--<FUN>( f )--( )( lamp )--+\n\
        %% main.clad\n+--[ ]( start )-------<CALL>( f )--[TON]( t, 5s )--( )( run )--+\n\
        %% motor.ladder-test\nprogram main.clad\nstep 100ms\n\nscenario \"starts\"\nstart     _-_\nrun    => _--\nt.ET   => 0s 1s 2s\n\
        lib.lamp => _-_\n\nscenario \"other\"\ntotal => 1 2 3\n\
        %% other.ladder-test\nprogram other.clad\nscenario \"x\"\nrun => _-\n";
    let at = |place: &str| plant.replacen(place, &format!("{place}$0"), 1);
    check(
        &at("( )( run"),
        "motor_runs",
        expect![[r#"
        %% main.clad
        +--[ ]( start )----------------<CALL>( f )--[TON]( t, 5s )--( )( motor_runs )--+
        %% motor.ladder-test
        program main.clad
        step 100ms

        scenario "starts"
        start         _-_
        motor_runs => _--
        t.ET       => 0s 1s 2s
        lib.lamp     => _-_

        scenario "other"
        total => 1 2 3
    "#]],
    );
    check(
        &at("[TON]( t"),
        "q",
        expect![[r#"
        %% main.clad
        +--[ ]( start )-------<CALL>( f )--[TON]( q, 5s )--( )( run )--+
        %% motor.ladder-test
        program main.clad
        step 100ms

        scenario "starts"
        start     _-_
        run    => _--
        q.ET   => 0s 1s 2s
        lib.lamp => _-_

        scenario "other"
        total => 1 2 3
    "#]],
    );
    check(
        &at("( )( lamp"),
        "l",
        expect![[r#"
            %% lib.clad
            VAR_GLOBAL total : DINT; END_VAR
            +--<FUN>( f )--------------------------------------------------------( )( l )--+
            %% motor.ladder-test
            program main.clad
            step 100ms

            scenario "starts"
            start     _-_
            run    => _--
            t.ET   => 0s 1s 2s
            lib.l    => _-_

            scenario "other"
            total => 1 2 3
        "#]],
    );
    check(
        &at("VAR_GLOBAL total"),
        "a_longer_name",
        expect![[r#"
        %% lib.clad
        VAR_GLOBAL a_longer_name : DINT; END_VAR
        +--<FUN>( f )--( )( lamp )--+
        %% motor.ladder-test
        program main.clad
        step 100ms

        scenario "starts"
        start     _-_
        run    => _--
        t.ET   => 0s 1s 2s
        lib.lamp => _-_

        scenario "other"
        a_longer_name => 1 2 3
    "#]],
    );
}

#[test]
fn labels() {
    check(
        "+--<LBL>( top )--[ ]( a )-----<JMP>( t$0op )--+\n\n+--<FUN>( f )--<JMP>( top )--+\n",
        "again",
        expect![[r#"
            +--<LBL>( again )--[ ]( a )------------------------------------<JMP>( again )--+

            +--<FUN>( f )--<JMP>( top )--+
        "#]],
    );
    // The block jumps to the label of each place where it is.
    check(
        "FUNCTION_BLOCK <$Go>\n+--[ ]( EN )--<JMP>( out )--+\nEND_FUNCTION_BLOCK\n\
         FUNCTION_BLOCK <$Via>\n+--<$Go>--+\nEND_FUNCTION_BLOCK\n\
         +--<$Go>--<LBL>( o$0ut )--+\n+--<FUN>( f )--<$Via>--<LBL>( out )--+\n+--<FUN>( g )--<LBL>( out )--+\n",
        "done",
        expect![[r#"
            FUNCTION_BLOCK <$Go>
            +--[ ]( EN )----------------------------------------------------<JMP>( done )--+
            END_FUNCTION_BLOCK
            FUNCTION_BLOCK <$Via>
            +--<$Go>--+
            END_FUNCTION_BLOCK
            +--<$Go>--<LBL>( done )--------------------------------------------------------+
            +--<FUN>( f )--<$Via>--<LBL>( done )-------------------------------------------+
            +--<FUN>( g )--<LBL>( out )--+
        "#]],
    );
}

#[test]
fn names_that_are_refused() {
    let tag = "VAR a, b : BOOL; END_VAR\n+--[ ]( a$0 )--( )( b )--+\n";
    for (new, expected) in [
        (
            "",
            expect![[r#"
            refused: a name is needed
        "#]],
        ),
        (
            "1a",
            expect![[r#"
            refused: `1a` is not a name: write a letter or `_`, then letters, digits and `_`
        "#]],
        ),
        (
            "a b",
            expect![[r#"
            refused: `a b` is not a name: write a letter or `_`, then letters, digits and `_`
        "#]],
        ),
        (
            "true",
            expect![[r#"
            refused: `true` is a word of the language: choose another name
        "#]],
        ),
        (
            "Var",
            expect![[r#"
            refused: `Var` is a word of the language: choose another name
        "#]],
        ),
        (
            "B",
            expect![[r#"
            refused: there is a tag `B` on line 1 of main.clad already: both would become one
        "#]],
        ),
    ] {
        check(tag, new, expected);
    }
    let block = "FUNCTION_BLOCK [$B]\nVAR_INPUT raw$0 : BOOL; END_VAR\n+--[ ]( raw )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n";
    check(
        block,
        "eno",
        expect![[r#"
        refused: a block has `eno` of its own: choose another name
    "#]],
    );
    let block = block.replace("raw$0", "raw").replace("[$B]", "[$$0B]");
    check(
        &block,
        "$B_1",
        expect![[r#"
        refused: `$B_1` cannot name a block: write `$`, a letter, then letters and digits
    "#]],
    );
    check(
        &block,
        "1",
        expect![[r#"
        refused: `1` cannot name a block: write `$`, a letter, then letters and digits
    "#]],
    );
    check(
        "+--[ ]( a$0 )--<CALL>( f )--+\n",
        "é",
        expect![[r#"
            +--[ ]( é )--<CALL>( f )--+
        "#]],
    );
}

#[test]
fn names_that_something_else_has() {
    let plant = "%% a.clad\nVAR_GLOBAL total : DINT; END_VAR\n+--<FUN>( count )--+\n\
        FUNCTION_BLOCK [$Hold]\nEND_FUNCTION_BLOCK\n\
        %% b.clad\nVAR mine : DINT; END_VAR\n+--[GT]( total, mine )--( )( y )--+\n+--<LBL>( l )--<JMP>( m )--+\n\
        +--<FUN>( own )--+\nFUNCTION_BLOCK [$Own]\nVAR_INPUT i : BOOL; END_VAR\nEND_FUNCTION_BLOCK\n\
        %% c.clad\n+--[ ]( other )--( )( y )--+\n";
    let at = |place: &str| plant.replacen(place, &format!("{place}$0"), 1);
    check(
        &at("VAR mine"),
        "total",
        expect![[r#"
        refused: there is a tag `total` in a.clad already: both would become one
    "#]],
    );
    check(
        &at("VAR mine"),
        "y",
        expect![[r#"
        refused: there is a tag `y` on line 2 of b.clad already: both would become one
    "#]],
    );
    check(
        &at("VAR_GLOBAL total"),
        "other",
        expect![[r#"
        refused: there is a tag `other` on line 1 of c.clad already: both would become one
    "#]],
    );
    check(
        &at("VAR_GLOBAL total"),
        "mine",
        expect![[r#"
        refused: there is a tag `mine` on line 1 of b.clad already: both would become one
    "#]],
    );
    check(
        &at("<FUN>( own"),
        "count",
        expect![[r#"
        refused: there is a function `count` on line 2 of a.clad already: both would become one
    "#]],
    );
    check(
        &at("<FUN>( count"),
        "own",
        expect![[r#"
        refused: there is a function `own` on line 4 of b.clad already: both would become one
    "#]],
    );
    check(
        &at("[$Own"),
        "hold",
        expect![[r#"
        refused: there is a user-defined block `$hold` on line 3 of a.clad already: both would become one
    "#]],
    );
    check(
        &at("<LBL>( l"),
        "m",
        expect![[r#"
        refused: the jump on line 3 of b.clad names `m`, which is not there: it would mean this one
    "#]],
    );
    // A body's own tag may hide a global one that it does not name.
    check(
        &at("VAR_INPUT i"),
        "total",
        expect![[r#"
            %% b.clad
            VAR mine : DINT; END_VAR
            +--[GT]( total, mine )--( )( y )--+
            +--<LBL>( l )--<JMP>( m )--+
            +--<FUN>( own )--+
            FUNCTION_BLOCK [$Own]
            VAR_INPUT total : BOOL; END_VAR
            END_FUNCTION_BLOCK
        "#]],
    );
    // Another case of the same name is the same name.
    check(
        "+--[ ]( Run$0 )---------------------( )( rUN )--+\n",
        "RUN",
        expect![[r#"
            +--[ ]( RUN )---------------------( )( RUN )--+
        "#]],
    );
}

#[test]
fn a_type_that_follows_from_the_name() {
    let check = |text: &str, new: &str, expected: Expect| check(text, new, expected);
    check(
        "+--[MOV]( MI1$0, 3 )--+\n",
        "MF1",
        expect![[r#"
        refused: `MI1` is not declared, and is an internal tag of type DINT; the name `MF1` would make it an internal tag of type LREAL: declare it first
    "#]],
    );
    check(
        "+--[MOV]( MF1$0, 3 )--+\n",
        "speed",
        expect![[r#"
        refused: `MF1` is not declared, and is an internal tag of type LREAL; the name `speed` would make it an internal tag of type DINT: declare it first
    "#]],
    );
    check(
        "+--[ ]( M1$0 )--------------------------( )( y )--+\n",
        "start",
        expect![[r#"
            refused: `M1` is not declared, and is an internal tag of type BOOL; the name `start` would make it an input of type BOOL: declare it first
        "#]],
    );
    check(
        "+--[ ]( start$0 )--------------------( )( y )--+\n",
        "I7",
        expect![[r#"
            +--[ ]( I7 )---------------------------------------------------------( )( y )--+
        "#]],
    );
}

#[test]
fn what_keeps_its_name() {
    let check = |text: &str, expected: Expect| {
        let fixture = Fixture::new(text);
        let (context, offset, _) = fixture.ask();
        let prepared = match prepare_rename(context, offset) {
            Err(refused) => format!("refused: {refused}\n"),
            Ok(None) => "nothing\n".to_owned(),
            Ok(Some(it)) => format!("{} `{}`\n", fixture.show("main.clad", it.range), it.name),
        };
        expected.assert_eq(&prepared);
        if prepared.starts_with("refused") || prepared.starts_with("nothing") {
            assert!(renamed(text, "x").starts_with("refused"));
        }
    };
    check(
        "+--[ ]( r$0un )--+\n",
        expect![[r#"
        main.clad:1:9 run `run`
    "#]],
    );
    check(
        "+--[$Ho$0ld]( run )--+\n",
        expect![[r#"
        main.clad:1:5 $Hold `$Hold`
    "#]],
    );
    check(
        "+--[ ]( %IX0$0.0 )--+\n",
        expect![[r#"
        refused: `%IX0.0` is a direct address: it says where the signal is. Declare a tag with AT to give it a name
    "#]],
    );
    check(
        "+--[ ]( t.Q$0 )--+\n",
        expect![[r#"
        refused: the members of a timer, counter or bistable, and the bits of a tag, keep their names
    "#]],
    );
    check(
        "+--[ ]( SYS.ON$0 )--+\n",
        expect![[r#"
        refused: the tags of SYS keep their names
    "#]],
    );
    check(
        "+--[TON$0]( t, 1s )--+\n",
        expect![[r#"
        refused: instructions keep their names
    "#]],
    );
    check(
        "FUNCTION_BLOCK [$B]\n+--[ ]( EN$0 )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        expect![[r#"
            refused: EN and ENO belong to every block: they keep their names
        "#]],
    );
    check(
        "+--$0[ ]( a )--+\n",
        expect![[r#"
        refused: instructions keep their names
    "#]],
    );
    check(
        "+-$0-[ ]( a )--+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[CALC]( y, SQ$0RT(a) )--+\n",
        expect![[r#"
        nothing
    "#]],
    );
}

#[test]
fn an_address_stays_where_it_is_written() {
    let text = "VAR lamp AT %QX0.1 : BOOL; END_VAR\n+--[ ]( lamp )--[ ]( %QX0.1 )--( )( y )--+\n";
    check(
        &text.replacen("lamp", "la$0mp", 1),
        "light",
        expect![[r#"
            VAR light AT %QX0.1 : BOOL; END_VAR
            +--[ ]( light )--[ ]( %QX0.1 )---------------------------------------( )( y )--+
        "#]],
    );
    check(
        &text.replacen("( %QX", "( %Q$0X", 1),
        "light",
        expect![[r#"
        refused: `%QX0.1` is a direct address: it says where the signal is. Declare a tag with AT to give it a name
    "#]],
    );
}

#[test]
fn the_library_keeps_its_names() {
    for text in [
        "+--[$Deb$0ounce]( button )--( )( y )--+\n",
        "+--[$Debounce]( button, w$0ait := 5ms )--( )( y )--+\n",
    ] {
        assert_eq!(
            renamed(text, "$Other"),
            "refused: the blocks of the library and their operands keep their names\n"
        );
    }
}

const TYPES: &str = "TYPE\n    Phase : (IDLE, FILLING, MIXING := 10);\n    Motor : STRUCT\n        speed   : REAL;\n        running : BOOL;\n        delay   : TON;\n    END_STRUCT;\nEND_TYPE\n\nVAR\n    pump  : Motor := (speed := 20.0);\n    lines : ARRAY[1..4] OF Motor;\n    step  : Phase := FILLING;\n    k     : INT;\nEND_VAR\n\n";

#[test]
fn types_members_and_values() {
    let check = |rest: &str, new: &str, expected: Expect| check(&format!("{TYPES}{rest}"), new, expected);
    let rungs = |cursor: &str| {
        let text = "+--[ ]( pump.running )--[EQ]( step, FILLING )--[MOV]( step, Phase.MIXING )--( )( lines[k].running )--+\n";
        text.replacen(cursor, &format!("{cursor}$0"), 1)
    };
    check(
        &rungs("pump.running"),
        "is_on",
        expect![[r#"
        TYPE
            Phase : (IDLE, FILLING, MIXING := 10);
            Motor : STRUCT
                speed : REAL;
                is_on : BOOL;
                delay : TON;
            END_STRUCT;
        END_TYPE

        VAR
            pump  : Motor := (speed := 20.0);
            lines : ARRAY[1..4] OF Motor;
            step  : Phase := FILLING;
            k     : INT;
        END_VAR

        +--[ ]( pump.is_on )--[EQ]( step, FILLING )----[MOV]( step, Phase.MIXING )--( )( lines[k].is_on )--+
    "#]],
    );
    check(
        &rungs("step, FILLING"),
        "FULL",
        expect![[r#"
        TYPE
            Phase : (IDLE, FULL, MIXING := 10);
            Motor : STRUCT
                speed   : REAL;
                running : BOOL;
                delay   : TON;
            END_STRUCT;
        END_TYPE

        VAR
            pump  : Motor := (speed := 20.0);
            lines : ARRAY[1..4] OF Motor;
            step  : Phase := FULL;
            k     : INT;
        END_VAR

        +--[ ]( pump.running )--[EQ]( step, FULL )---[MOV]( step, Phase.MIXING )--( )( lines[k].running )--+
    "#]],
    );
    check(
        &rungs("step, Phase"),
        "State",
        expect![[r#"
        TYPE
            State : (IDLE, FILLING, MIXING := 10);
            Motor : STRUCT
                speed   : REAL;
                running : BOOL;
                delay   : TON;
            END_STRUCT;
        END_TYPE

        VAR
            pump  : Motor := (speed := 20.0);
            lines : ARRAY[1..4] OF Motor;
            step  : State := FILLING;
            k     : INT;
        END_VAR

        +--[ ]( pump.running )--[EQ]( step, FILLING )--[MOV]( step, State.MIXING )--( )( lines[k].running )--+
    "#]],
    );
    check(
        &rungs("step, FILLING"),
        "idle",
        expect![[r#"
        refused: there is a member `idle` on line 2 of main.clad already: both would become one
    "#]],
    );
    check(
        &rungs("step, FILLING"),
        "k",
        expect![[r#"
        refused: there is a tag `k` on line 14 of main.clad already: both would become one
    "#]],
    );
    check(
        &rungs("pump.running"),
        "speed",
        expect![[r#"
        refused: there is a member `speed` on line 4 of main.clad already: both would become one
    "#]],
    );
}

#[test]
fn types_of_other_files() {
    check(
        "%% types.clad\nTYPE\n    Motor : STRUCT\n        on$0 : BOOL;\n    END_STRUCT;\nEND_TYPE\n%% main.clad\nVAR\n    m : Motor := (on := TRUE);\nEND_VAR\n+--[ ]( m.on )--( )( Q1 )--+\n",
        "running",
        expect![[r#"
            %% types.clad
            TYPE
                Motor : STRUCT
                    running : BOOL;
                END_STRUCT;
            END_TYPE
            %% main.clad
            VAR
                m : Motor := (running := TRUE);
            END_VAR
            +--[ ]( m.running )-------------------------------------------------( )( Q1 )--+
        "#]],
    );
}
