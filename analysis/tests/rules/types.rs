//! Types of one's own: structures, enumerations, arrays of anything.

use crate::check::{check, check_files, check_program, clean, clean_program, found};
use expect_test::expect;

const MOTOR: &str = "TYPE\n    Phase : (IDLE, FILLING, MIXING := 10);\n    Motor : STRUCT\n        speed   : REAL := 50.0;\n        running : BOOL;\n        delay   : TON;\n        status  : WORD;\n    END_STRUCT;\nEND_TYPE\n";

#[track_caller]
fn check_with_motor(rest: &str, expected: expect_test::Expect) {
    check(&format!("{MOTOR}{rest}"), expected);
}

#[test]
fn what_the_language_page_shows() {
    clean_program(
        "TYPE\n    Phase  : (IDLE, FILLING, MIXING := 10, EMPTYING);\n    Recipe : ARRAY[1..8] OF REAL;\n    Motor  : STRUCT\n        speed, limit : REAL := 50.0;  # rpm #\n        running      : BOOL;\n        delay        : TON;\n    END_STRUCT;\nEND_TYPE\n\nVAR\n    pump  : Motor := (speed := 20.0);\n    lines : ARRAY[1..4] OF Motor;\n    step  : Phase := FILLING;\n    mix   : Recipe := [1.5, 2.0, 6(0.0)];\nEND_VAR\nVAR_INPUT\n    k : INT;\nEND_VAR\n\n+--[EQ]( step, FILLING )--[ ]( lines[k].running )--[TON]( lines[2].delay, T#5s )--[MOV]( step, MIXING )--+\n\n+--[GT]( pump.speed, mix[1] )--( )( lines[k].running )--+\n",
    );
}

#[test]
fn declarations() {
    check(
        "TYPE\n    A : STRUCT\n        x : INT;\n        x : BOOL;\n    END_STRUCT;\n    B : STRUCT\n    END_STRUCT;\n    a : INT;\n    C : (ONE, TWO := 0);\n    D, E : INT;\n    F : INT(5..300000);\n    G : BOOL(0..1);\n    INT : REAL;\nEND_TYPE\n",
        expect![[r#"
            >         x : BOOL;
                      ^ error[duplicate-declaration]: `x` is declared twice
                help: remove one of the declarations, or give one tag another name; capitals do not tell names apart
                at 3:9 `x`: `x` is first declared here
            >     B : STRUCT
                  ^ error[bad-declaration]: `B` has no members: a structure has at least one
            >     a : INT;
                  ^ error[duplicate-type]: the type `a` is declared twice
                help: remove one of the declarations, or give one type another name; capitals do not tell names apart
                at 2:5 `A`: it is first declared here
            >     C : (ONE, TWO := 0);
                            ^^^ error[bad-declaration]: `TWO` has the number 0, which is that of `ONE`
            >     D, E : INT;
                     ^ error[bad-declaration]: a type is declared by itself: write `E` on a line of its own
            >     F : INT(5..300000);
                      ^^^^^^^^^^^^^^ error[bad-declaration]: 5..300000 is no range within INT, which holds -32768 to 32767
            >     G : BOOL(0..1);
                      ^^^^^^^^^^ error[bad-declaration]: BOOL is no integer: only those have a range of values
            >     INT : REAL;
                  ^^^ error[bad-declaration]: `INT` is a word of the language: choose another name
        "#]],
    );
}

#[test]
fn circles_and_unknown_types() {
    check(
        "TYPE\n    A : STRUCT\n        b : B;\n    END_STRUCT;\n    B : ARRAY[1..2] OF A;\n    C : STRUCT\n        m : Motr;\n    END_STRUCT;\n    Motor : STRUCT\n        c : INT;\n    END_STRUCT;\nEND_TYPE\n",
        expect![[r#"
            >     B : ARRAY[1..2] OF A;
                                     ^ error[recursive-type]: the type `A` contains itself: it contains `B`, which contains `A`
                help: a tag of such a type would have parts without end: break the circle, for instance with an index
            >         m : Motr;
                          ^^^^ error[unknown-type]: there is no type `Motr`: did you mean Motor?
                fix: Replace with Motor
                      A     : STRUCT
                          b : B;
                      END_STRUCT;
                      B     : ARRAY[1..2] OF A;
                      C     : STRUCT
                          m : Motor;
        "#]],
    );
}

#[test]
fn messages_that_people_met_before() {
    check(
        "VAR\n    m : STRUCT\n        on : BOOL;\n    END_STRUCT;\n    s : (IDLE, RUN);\nEND_VAR\n+--[ ]( m.on )--( )( Q1 )--+\n",
        expect![[r#"
            >     m : STRUCT
                      ^^^^^^ error[bad-declaration]: a STRUCT is not declared among tags
                help: declare it in a section TYPE .. END_TYPE as Motor : STRUCT, and the tag as pump : Motor;
            >     s : (IDLE, RUN);
                      ^ error[bad-declaration]: the values of an enumeration are not listed here
                help: declare it in a section TYPE .. END_TYPE as Phase : (IDLE, FILLING); and the tag as step : Phase;
        "#]],
    );
    check(
        "TYPE\n    M : STRUCT\n        on : BOOL;\nEND_TYPE\n",
        expect![[r#"
            > END_TYPE
              ^^^^^^^^ error[bad-declaration]: the STRUCT above is not closed: END_STRUCT; is missing
                help: after its last member a structure ends with END_STRUCT; on a line of its own
                fix: Insert END_STRUCT;
                      END_STRUCT;
        "#]],
    );
    check(
        "TYPE\n    M : INT;\n",
        expect![[r#"
            > TYPE
              ^^^^ error[bad-declaration]: the types above are not closed: END_TYPE is missing
                help: a section of types ends with END_TYPE on a line of its own
                fix: Insert END_TYPE
                  END_TYPE
        "#]],
    );
}

#[test]
fn members_and_elements() {
    check_with_motor(
        "VAR\n    pump  : Motor;\n    lines : ARRAY[1..4, 0..1] OF Motor;\n    k     : INT;\nEND_VAR\n\
         +--[ ]( pump.runing )--[ ]( lines[5, 0].running )--[ ]( lines[1].running )--( )( Q1 )--+\n\
         +--[ ]( lines.running )--[ ]( pump )--[ ]( pump.delay )--[ ]( pump.status.16 )--( )( Q2 )--+\n\
         +--[ ]( lines[k, k + 1].delay.Q )--[ ]( pump.delay.QQ )--[ ]( pump.speed )--( )( Q3 )--+\n",
        expect![[r#"
            > +--[ ]( pump.runing )--[ ]( lines[5, 0].running )--[ ]( lines[1].running )--( )( Q1 )--+
                           ^^^^^^ error[unknown-member]: Motor has no member `runing`
                help: did you mean running?
            > +--[ ]( pump.runing )--[ ]( lines[5, 0].running )--[ ]( lines[1].running )--( )( Q1 )--+
                                                ^ error[bad-operand]: `lines` has the elements 1 to 4, there is no 5
            > +--[ ]( pump.runing )--[ ]( lines[5, 0].running )--[ ]( lines[1].running )--( )( Q1 )--+
                                                                               ^^^^^^^ error[unknown-member]: an ARRAY[1..4, 0..1] OF Motor has no member `running`
                help: write the index of an element before the point
            > +--[ ]( lines.running )--[ ]( pump )--[ ]( pump.delay )--[ ]( pump.status.16 )--( )( Q2 )--+
                            ^^^^^^^ error[unknown-member]: an ARRAY[1..4, 0..1] OF Motor has no member `running`
                help: write the index of an element before the point
            > +--[ ]( lines.running )--[ ]( pump )--[ ]( pump.delay )--[ ]( pump.status.16 )--( )( Q2 )--+
                                            ^^^^ error[type-mismatch]: `pump` is a Motor, a value is expected here
                help: name one of its members
            > +--[ ]( lines.running )--[ ]( pump )--[ ]( pump.delay )--[ ]( pump.status.16 )--( )( Q2 )--+
                                                         ^^^^^^^^^^ error[type-mismatch]: `pump.delay` is the state of a TON, a value is expected here
                help: `pump.delay.Q` is its output, `pump.delay.ET` its elapsed time
            > +--[ ]( lines.running )--[ ]( pump )--[ ]( pump.delay )--[ ]( pump.status.16 )--( )( Q2 )--+
                                                                                        ^^ error[unknown-member]: WORD has the bits 0 to 15, there is no `16`
            > +--[ ]( lines[k, k + 1].delay.Q )--[ ]( pump.delay.QQ )--[ ]( pump.speed )--( )( Q3 )--+
                                                                 ^^ error[unknown-member]: `pump.delay` is a TON and has no member `QQ`
                help: its members are IN PT Q ET R TT
            > +--[ ]( lines[k, k + 1].delay.Q )--[ ]( pump.delay.QQ )--[ ]( pump.speed )--( )( Q3 )--+
                                                                            ^^^^^^^^^^ error[type-mismatch]: this is REAL, BOOL is expected here
                help: convert it with [TYP]( result, value ) into a BOOL first
        "#]],
    );
}

#[test]
fn enumerations_pass_to_themselves() {
    clean(&format!(
        "{MOTOR}VAR\n    step : Phase := MIXING;\n    all  : ARRAY[1..3] OF Phase := [FILLING, 2(Phase.IDLE)];\n    n    : INT;\n    s    : STRING;\n    run  : BOOL;\nEND_VAR\n\
         +--[EQ]( step, filling )--[MOV]( step, all[2] )--[SEL]( step, run, IDLE, MIXING )--[TYP]( n, step )--[TYP]( s, step )--+\n\
         +--[CALC]( run, step = IDLE OR step <> all[1] )--[TYP]( step, n )--[FILL]( all[1..3], MIXING )--+\n"
    ));
    check_with_motor(
        "VAR\n    step : Phase;\n    n    : INT;\nEND_VAR\n\
         +--[GT]( step, IDLE )--[MOV]( step, 1 )--[MOV]( n, step )--[ADD]( step, step, 1 )--+\n\
         +--[EQ]( step, FILING )--[MOV]( step, Phase.NONE )--[MOV]( n, IDLE )--[EQ]( step, n )--( )( Q1 )--+\n",
        expect![[r#"
            > +--[GT]( step, IDLE )--[MOV]( step, 1 )--[MOV]( n, step )--[ADD]( step, step, 1 )--+
                             ^^^^ error[type-mismatch]: `IDLE` is the tag of this name here, a DINT
                help: for the value of Phase write `Phase.IDLE`
                fix: Replace with `Phase.IDLE`
                  +--[GT]( step, Phase.IDLE )------------[MOV]( step, 1 )--[MOV]( n, step )--[ADD]( step, step, 1 )--+
            > +--[GT]( step, IDLE )--[MOV]( step, 1 )--[MOV]( n, step )--[ADD]( step, step, 1 )--+
                                                  ^ error[type-mismatch]: the number 1 is given, Phase is expected
            > +--[GT]( step, IDLE )--[MOV]( step, 1 )--[MOV]( n, step )--[ADD]( step, step, 1 )--+
                                                                 ^^^^ error[type-mismatch]: `step` is Phase, and `a` of [MOV] takes INT
                help: convert it with [TYP]( result, value ) into an INT first
            > +--[GT]( step, IDLE )--[MOV]( step, 1 )--[MOV]( n, step )--[ADD]( step, step, 1 )--+
                                                                                ^^^^ error[type-mismatch]: the result is Phase, this block gives a number or a TIME
            > +--[EQ]( step, FILING )--[MOV]( step, Phase.NONE )--[MOV]( n, IDLE )--[EQ]( step, n )--( )( Q1 )--+
                             ^^^^^^ warning[undeclared-tag]: `FILING` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `FILING : Phase` in VAR_INPUT
                  VAR_INPUT
                      FILING : Phase;
                  END_VAR
            > +--[EQ]( step, FILING )--[MOV]( step, Phase.NONE )--[MOV]( n, IDLE )--[EQ]( step, n )--( )( Q1 )--+
                                                    ^^^^^^^^^^ error[bad-operand]: Phase has no value `NONE`
                help: its values are IDLE FILLING MIXING
            > +--[EQ]( step, FILING )--[MOV]( step, Phase.NONE )--[MOV]( n, IDLE )--[EQ]( step, n )--( )( Q1 )--+
                                                                            ^^^^ error[type-mismatch]: `IDLE` is DINT, and `a` of [MOV] takes INT
                help: convert it with [TYP]( result, value ) into an INT first
            > +--[EQ]( step, FILING )--[MOV]( step, Phase.NONE )--[MOV]( n, IDLE )--[EQ]( step, n )--( )( Q1 )--+
                                                                            ^^^^ warning[undeclared-tag]: `IDLE` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `IDLE : DINT` in VAR_INPUT
                  VAR_INPUT
                      IDLE : DINT;
                  END_VAR
            > +--[EQ]( step, FILING )--[MOV]( step, Phase.NONE )--[MOV]( n, IDLE )--[EQ]( step, n )--( )( Q1 )--+
                                                                                    ^^^^^^^^^^^^^^^ error[type-mismatch]: Phase and INT cannot be compared
                help: convert one of them with [TYP] first
        "#]],
    );
}

#[test]
fn an_undeclared_tag_takes_the_type_of_a_value() {
    clean(&format!(
        "{MOTOR}+--[ ]( I1 )--[MOV]( step, Phase.FILLING )--[EQ]( step, Phase.IDLE )--( )( Q1 )--+\n"
    ));
}

#[test]
fn whole_structures_and_arrays() {
    clean(
        "TYPE\n    P : STRUCT\n        x : INT;\n        l : ARRAY[1..3] OF REAL;\n    END_STRUCT;\nEND_TYPE\nVAR\n    a, b : P;\n    c    : ARRAY[1..2] OF P;\n    k    : INT;\nEND_VAR\n\
         +--[MOV]( a, b )--[MOV]( c[k], a )--[MOV]( a.l, c[1].l )--[BMOV]( a.l, b.l )--+\n",
    );
    check_with_motor(
        "VAR\n    a, b : Motor;\n    l, m : ARRAY[1..3] OF INT;\n    n    : ARRAY[1..4] OF INT;\nEND_VAR\n\
         +--[MOV]( a, b )--[MOV]( l, n )--[EQ]( l, m )--[MOV]( l, a )--+\n",
        expect![[r#"
            > +--[MOV]( a, b )--[MOV]( l, n )--[EQ]( l, m )--[MOV]( l, a )--+
                        ^ error[type-mismatch]: Motor holds a timer, counter or block, whose state is not copied: give it as a VAR_IN_OUT, or copy members
            > +--[MOV]( a, b )--[MOV]( l, n )--[EQ]( l, m )--[MOV]( l, a )--+
                           ^ error[type-mismatch]: Motor holds a timer, counter or block, whose state is not copied: give it as a VAR_IN_OUT, or copy members
            > +--[MOV]( a, b )--[MOV]( l, n )--[EQ]( l, m )--[MOV]( l, a )--+
                                          ^ error[type-mismatch]: this is ARRAY[1..4] OF INT, ARRAY[1..3] OF INT is expected here
            > +--[MOV]( a, b )--[MOV]( l, n )--[EQ]( l, m )--[MOV]( l, a )--+
                                                     ^ error[type-mismatch]: `l` is an array: name an element such as l[1]
            > +--[MOV]( a, b )--[MOV]( l, n )--[EQ]( l, m )--[MOV]( l, a )--+
                                                        ^ error[type-mismatch]: `m` is an array: name an element such as m[1]
            > +--[MOV]( a, b )--[MOV]( l, n )--[EQ]( l, m )--[MOV]( l, a )--+
                                                                       ^ error[type-mismatch]: this is Motor, ARRAY[1..3] OF INT is expected here
        "#]],
    );
}

#[test]
fn values_at_the_start() {
    check_with_motor(
        "VAR\n    a : Motor := (speed := 1, sped := 2);\n    b : Motor := 5;\n    c : ARRAY[1..2] OF Motor := [(speed := 1), 2((speed := 2))];\n    d : Phase := DONE;\n    e : Motor := (delay := 5);\n    f : Motor := (speed := 1, speed := 2);\nEND_VAR\n",
        expect![[r#"
            >     a : Motor := (speed := 1, sped := 2);
                                            ^^^^ error[bad-declaration]: Motor has no member `sped`
            >     b : Motor := 5;
                               ^ error[bad-declaration]: the values of Motor belong in parentheses: (speed := ...)
            >     c : ARRAY[1..2] OF Motor := [(speed := 1), 2((speed := 2))];
                                              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ error[bad-declaration]: there are 3 values for 2 elements
            >     d : Phase := DONE;
                               ^^^^ error[bad-declaration]: Phase has no value `DONE`
            >     e : Motor := (delay := 5);
                                         ^ error[bad-declaration]: a TON starts cleared: it has no initial value
            >     f : Motor := (speed := 1, speed := 2);
                                            ^^^^^ error[bad-declaration]: `speed` has a value already
        "#]],
    );
}

#[test]
fn one_timer_one_block() {
    check_with_motor(
        "VAR\n    lines : ARRAY[1..2] OF Motor;\nEND_VAR\n\
         +--[TON]( lines[1].delay, 5s )--( )( Q1 )--+\n+--[TON]( lines[2].delay, 5s )--( )( Q2 )--+\n\
         +--[TON]( Lines[1].delay, 5s )--( )( Q3 )--+\n",
        expect![[r#"
            > +--[TON]( Lines[1].delay, 5s )--( )( Q3 )--+
                        ^^^^^ error[duplicate-timer]: the timer `lines[1].delay` has a second block: both would work on one TON
                help: give this block a timer of its own; to use the timer on another rung read `lines[1].delay.Q`; if both are meant to work on it, write `# ladder: allow(duplicate-timer): reason #` above this network
                at 13:11 `lines`: the timer `lines[1].delay` belongs to this block
        "#]],
    );
}

#[test]
fn a_computed_index_chooses_a_timer() {
    check_with_motor(
        "VAR\n    lines : ARRAY[1..2] OF Motor;\n    k     : INT;\nEND_VAR\n\
         +--[TON]( lines[k].delay, 5s )--( )( Q1 )--+\n",
        expect![""],
    );
}

#[test]
fn types_of_other_files() {
    check_files(
        "%% types.clad\nTYPE\n    Motor : STRUCT\n        phase : Phase;\n    END_STRUCT;\nEND_TYPE\nVAR_GLOBAL\n    pump : Motor := (phase := RUN);\nEND_VAR\n\
         FUNCTION_BLOCK [$Go]\nVAR_IN_OUT\n    m : Motor;\nEND_VAR\n+--[MOV]( m.phase, RUN )--+\nEND_FUNCTION_BLOCK\n\
         %% phase.clad\nTYPE\n    Phase : (IDLE, RUN);\nEND_TYPE\n\
         %% main.clad\nVAR\n    mine : Motor;\nEND_VAR\n+--[EQ]( pump.phase, RUN )--[$Go]( mine )--[$Go]( pump )--[EQ]( mine.phase, IDLE )--( )( Q1 )--+\n\
         +--[ ]( pump.fase )--( )( Q2 )--+\n",
        expect![[r#"
            == main.clad
            > +--[ ]( pump.fase )--( )( Q2 )--+
                           ^^^^ error[unknown-member]: Motor has no member `fase`
                help: did you mean phase?
        "#]],
    );
    check_files(
        "%% a.clad\nTYPE\n    M : (A, B);\nEND_TYPE\n%% b.clad\nTYPE\n    M : (A, C);\nEND_TYPE\n%% main.clad\nVAR\n    m : M;\nEND_VAR\n",
        expect![[r#"
            == main.clad
            >     m : M;
                      ^ error[duplicate-type]: several files declare the type `M`, and not alike: which one is meant is open
                help: rename all but one of them, or declare the type in this file
                at a.clad:2:5 `M`: it is declared here
                at b.clad:2:5 `M`: it is declared here
        "#]],
    );
    // A member that cannot be read is an error where it is declared, and only there.
    check_files(
        "%% a.clad\nTYPE\n    M : STRUCT\n        n : ARRAY[5..1] OF INT;\n    END_STRUCT;\nEND_TYPE\n%% main.clad\nVAR\n    m : M;\nEND_VAR\n",
        expect![[r#"
            == a.clad
            >         n : ARRAY[5..1] OF INT;
                          ^^^^^^^^^^^^^^^^^^ error[bad-declaration]: the last index 1 is below the first 5: swap them
        "#]],
    );
}

#[test]
fn types_that_nothing_uses() {
    check_program(
        "TYPE\n    A : INT;\n    B : ARRAY[1..2] OF A;\n    C : (ONE, TWO);\nEND_TYPE\n+--[ ]( I1 )--( )( Q1 )--+\n",
        expect![[r#"
        >     B : ARRAY[1..2] OF A;
              ^ info[unused-type]: nothing in this file uses the type `B`
            help: declare a tag with it, or remove it
        >     C : (ONE, TWO);
              ^ info[unused-type]: nothing in this file uses the type `C`
            help: declare a tag with it, or remove it
    "#]],
    );
}

#[test]
fn types_in_a_block() {
    check(
        "FUNCTION_BLOCK [$B]\nTYPE\n    A : INT;\nEND_TYPE\n+--[ ]( EN )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        expect![[r#"
        > TYPE
          ^^^^ error[wrong-place]: types are not declared in a block
            help: move the section before FUNCTION_BLOCK: every block sees the types of the workspace
    "#]],
    );
}

#[test]
fn in_outs_outside_of_blocks() {
    check(
        "VAR_IN_OUT\n    x : BOOL;\nEND_VAR\n+--[ ]( x )--( )( Q1 )--+\n",
        expect![[r#"
            > VAR_IN_OUT
              ^^^^^^^^^^ error[wrong-place]: VAR_IN_OUT belongs in the body of a block
                help: a program has no caller that could hand it a tag: write VAR, or move the section into FUNCTION_BLOCK
        "#]],
    );
}

#[test]
fn values_next_to_undeclared_tags() {
    check(
        "TYPE\n    Phase : (IDLE, RUN);\nEND_TYPE\n+--[MOV]( step, Phase.RUN )--[EQ]( step, run )--( )( Q1 )--+\n",
        expect![[r#"
            > +--[MOV]( step, Phase.RUN )--[EQ]( step, run )--( )( Q1 )--+
                                                       ^^^ error[undeclared-tag]: `run` is a tag of its own here, not the value Phase.run
                help: nothing declared says which type is asked for here: write the value with its type
                fix: Write Phase.run
                  +--[MOV]( step, Phase.RUN )--[EQ]( step, Phase.run )----------------( )( Q1 )--+
        "#]],
    );
    // A name that is written is a tag.
    clean(
        "TYPE\n    Phase : (IDLE, RUN);\nEND_TYPE\n+--[MOV]( run, Phase.RUN )--[EQ]( run, Phase.IDLE )--( )( Q1 )--+\n",
    );
}

const GO: &str = "FUNCTION_BLOCK [$Go]\nVAR_INPUT\n    on : BOOL;\nEND_VAR\nVAR_OUTPUT\n    n : INT;\nEND_VAR\nVAR_IN_OUT\n    x : INT;\nEND_VAR\n+--[P]( on )--[ADD]( n, n, 1 )--[ADD]( x, x, 1 )--+\nEND_FUNCTION_BLOCK\n";

#[test]
fn instances() {
    clean(&format!(
        "{GO}VAR\n    a : $Go;\n    b : ARRAY[1..2] OF $Go;\n    i : INT;\nEND_VAR\n+--[$Go]( a, I1, x := i )--[$Go]( b[1], on := I2, x := i )--[$Go]( I3, i, x := i )--+\n\
         +--[GT]( a.n, b[2].n )--[ ]( a.on )--( )( Q1 )--+\n"
    ));
    check(
        &format!(
            "{GO}VAR\n    a : $Go;\n    b : $Gone;\n    i : INT;\nEND_VAR\n+--[$Go]( a, I1, x := i )--[$Go]( a, I2, x := i )--+\n\
             +--[MOV]( a.n, 5 )--[GT]( a.x, 1 )--[GT]( a.m, 1 )--[ ]( a )--[MOV]( i, a )--( )( a.on )--+\n"
        ),
        expect![[r#"
            >     b : $Gone;
                      ^^^^^ error[unknown-type]: there is no block $Gone whose state this could be
                help: correct the name, or define it: FUNCTION_BLOCK [$Gone], its declarations and rungs, END_FUNCTION_BLOCK
            > +--[$Go]( a, I1, x := i )--[$Go]( a, I2, x := i )--+
                                                ^ warning[duplicate-instance]: a second [$Go] works on `a`: what one does the other sees
                help: give each block a state of its own, unless both are meant to share it
                at 18:11 `a`: `a` is the state of this block
            > +--[MOV]( a.n, 5 )--[GT]( a.x, 1 )--[GT]( a.m, 1 )--[ ]( a )--[MOV]( i, a )--( )( a.on )--+
                        ^^^ error[constant-write]: `a.n` is written by its block alone
                help: write a tag of your own; of a block only the inputs are written from outside
            > +--[MOV]( a.n, 5 )--[GT]( a.x, 1 )--[GT]( a.m, 1 )--[ ]( a )--[MOV]( i, a )--( )( a.on )--+
                                          ^ error[unknown-member]: $Go has no input or output `x`
                help: what a block declares in VAR, and its in-outs, is its own
            > +--[MOV]( a.n, 5 )--[GT]( a.x, 1 )--[GT]( a.m, 1 )--[ ]( a )--[MOV]( i, a )--( )( a.on )--+
                                                          ^ error[unknown-member]: $Go has no input or output `m`
                help: what a block declares in VAR, and its in-outs, is its own
            > +--[MOV]( a.n, 5 )--[GT]( a.x, 1 )--[GT]( a.m, 1 )--[ ]( a )--[MOV]( i, a )--( )( a.on )--+
                                                                       ^ error[type-mismatch]: `a` is a $Go, a value is expected here
                help: name one of its members
            > +--[MOV]( a.n, 5 )--[GT]( a.x, 1 )--[GT]( a.m, 1 )--[ ]( a )--[MOV]( i, a )--( )( a.on )--+
                                                                                      ^ error[type-mismatch]: `a` is a $Go, a value is expected here
                help: name one of its members
            > +--[MOV]( a.n, 5 )--[GT]( a.x, 1 )--[GT]( a.m, 1 )--[ ]( a )--[MOV]( i, a )--( )( a.on )--+
                                                                                                ^ warning[input-written]: `a.on` is an input of $Go, and is written here: the block is given it again each time it runs
                help: leave `on` out where the block is, or give it the value there
                at 18:11 `a`: the block is given `on` here
        "#]],
    );
}

/// Inputs of a state that is a tag may be left out and written from outside, unless the block is given them as well.
#[test]
fn inputs_of_instances_are_written() {
    const RAMP: &str = "FUNCTION_BLOCK [$Ramp]\nVAR_INPUT\n    go : BOOL;\n    step, most : INT;\nEND_VAR\nVAR_OUTPUT\n    n : INT;\nEND_VAR\n\
         +--[ ]( go )--[ADD]( n, n, step )--[GT]( n, most )--[MOV]( most, 0 )--+\nEND_FUNCTION_BLOCK\n";
    clean(&format!(
        "{RAMP}VAR\n    a : $Ramp;\n    b : ARRAY[1..2] OF $Ramp;\n    i : INT;\nEND_VAR\n\
         +--[ ]( I1 )--( )( a.go )--[MOV]( b[i].most, 5 )--(S)( b[1].go )--+\n+--[ ]( I2 )--(R)( b[1].go )--+\n\
         +--[$Ramp]( a, step := 2 )--[$Ramp]( b[1] )--[$Ramp]( b[2], I2 )--[MOV]( i, a.n )--+\n"
    ));
    check(
        &format!(
            "{RAMP}VAR\n    a : $Ramp;\nEND_VAR\n+--[ ]( I1 )--( )( a.go )--+\n+--[$Ramp]( a, I2, step := 3, most := 2 )--[$Ramp]( I1 )--+\n+--[MOV]( a.n.3, 0 )--+\n"
        ),
        expect![[r#"
            > +--[ ]( go )--[ADD]( n, n, step )--[GT]( n, most )--[MOV]( most, 0 )--+
                                                                         ^^^^ warning[input-written]: `most` is an input of the block, and is written here: its caller gives it again each time the block runs
                help: write a tag of its own, and read that instead of the input where it is needed
                at 4:11 `most`: `most` is declared as an input here
            > +--[ ]( I1 )--( )( a.go )--+
                                 ^ warning[input-written]: `a.go` is an input of $Ramp, and is written here: the block is given it again each time it runs
                help: leave `go` out where the block is, or give it the value there
                at 15:13 `a`: the block is given `go` here
            > +--[$Ramp]( a, I2, step := 3, most := 2 )--[$Ramp]( I1 )--+
                                                         ^^^^^^^^^^^^^ error[bad-arity]: the operands `step`, `most` of [$Ramp] are missing
                help: it is written [$Ramp]( go, step, most, n )
                at 1:16 `[$Ramp]`: the block is defined here
            > +--[MOV]( a.n.3, 0 )--+
                        ^^^^^ error[constant-write]: `a.n.3` is written by its block alone
                help: write a tag of your own; of a block only the inputs are written from outside
        "#]],
    );
}

#[test]
fn a_block_does_not_hold_itself() {
    check(
        "FUNCTION_BLOCK [$A]\nVAR\n    b : $B;\nEND_VAR\n+--[ ]( EN )--( )( ENO )--+\nEND_FUNCTION_BLOCK\nFUNCTION_BLOCK [$B]\nVAR\n    l : ARRAY[1..2] OF $A;\nEND_VAR\n+--[ ]( EN )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n+--[$A]--( )( Q1 )--+\n",
        expect![[r#"
            > FUNCTION_BLOCK [$A]
                             ^^^^ error[recursive-block]: the block `$A` uses itself: it uses `$B`, which uses `$A`
                help: every place of a block has a state of its own, so a block cannot contain itself: break the circle
                at 3:5 `b`: `$B` is used here
                at 9:5 `l`: `$A` is used here
        "#]],
    );
}

#[test]
fn edges_of_elements() {
    check(
        "VAR CONSTANT\n    two : INT := 2;\nEND_VAR\nVAR_INPUT\n    key : ARRAY[1..4] OF BOOL;\n    k   : INT;\nEND_VAR\n+--[P]( key[1] )--[N]( key[two] )--[P]( key[k] )--( )( Q1 )--+\n",
        expect![[r#"
            > +--[P]( key[1] )--[N]( key[two] )--[P]( key[k] )--( )( Q1 )--+
                                                          ^ warning[edge-of-varying-index]: the index of this edge contact is computed: where it changes, two elements are compared
                help: the edge belongs to the contact: put a contact with a fixed index before [OSR], or one for each element
        "#]],
    );
}

#[test]
fn values_that_nothing_asks_for() {
    // The inputs are written nowhere; the tag itself is.
    let text = |rungs: &str| {
        format!("TYPE\n    P : (ONE, TWO, THREE);\nEND_TYPE\nVAR_INPUT\n    p : P;\nEND_VAR\n{rungs}")
    };
    check_program(
        &text(
            "+--[EQ]( p, ONE )--( )( Q1 )--+\n+--[EQ]( P.TWO, p )--( )( Q2 )--+\n+--[ ]( I1 )--( )( Q4 )--+\n+--[EQ]( p, ONE )--( )( Q5 )--+\n",
        ),
        expect![[r#"
            > +--[EQ]( p, ONE )--( )( Q1 )--+
                 ^^^^^^^^^^^^^^ info[unhandled-value]: these 2 networks ask for values of `p`, and none for THREE
                help: add a network for each, if something is to happen then
        "#]],
    );
    clean_program(&text(
        "+--[EQ]( p, ONE )--( )( Q1 )--+\n+--[EQ]( p, TWO )--( )( Q2 )--+\n+--[EQ]( p, THREE )--( )( Q3 )--+\n",
    ));
    // One value alone, and an answer for all others.
    for rungs in [
        "+--[EQ]( p, ONE )--( )( Q1 )--+\n+--[EQ]( p, ONE )--( )( Q2 )--+\n",
        "+--[EQ]( p, ONE )--( )( Q1 )--+\n+--[EQ]( p, TWO )--( )( Q2 )--+\n+--[NE]( p, ONE )--[NE]( p, TWO )--( )( Q3 )--+\n",
        "+--[EQ]( p, ONE )--( )( Q1 )--+\n+--[EQ]( p, TWO )--[NOT]--( )( Q2 )--+\n",
        "+--[EQ]( p, ONE )--( )( Q1 )--+\n+--[EQ]( p, TWO )--( )( Q2 )--+\n+--[CALC]( Q3, NOT (p = one) AND p <> TWO )--+\n",
    ] {
        clean_program(&text(rungs));
    }
}

/// `DN` of a timer is its `Q`; of a structure it is a member like any other.
#[test]
fn members_with_the_names_of_a_timers() {
    clean(
        "TYPE\n    Pump : STRUCT\n        DN, Q : BOOL;\n    END_STRUCT;\nEND_TYPE\nVAR_INPUT\n    p : Pump;\nEND_VAR\n+--[ ]( p.DN )--[/]( p.Q )--( )( Q1 )--+\n",
    );
    check(
        "VAR\n    t : TON;\nEND_VAR\n+--[TON]( t, 5s )--( )( Q1 )--+\n+--[ ]( t.DN )--[/]( t.Q )--( )( Q2 )--+\n",
        expect![[r#"
            > +--[ ]( t.DN )--[/]( t.Q )--( )( Q2 )--+
                              ^^^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what is before it does not
                help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
                at 5:4 `[ ]( t.DN )`: this is off whenever the other is on
        "#]],
    );
}

/// Constants are checked where they are written; what is computed is not.
#[test]
fn values_within_limits() {
    check(
        "TYPE\n    Percent : INT(0..100);\n    Valve : STRUCT\n        open : Percent := 101;\n        all  : ARRAY[1..2, 1..2] OF USINT(1..5);\n    END_STRUCT;\nEND_TYPE\n\
         FUNCTION_BLOCK [$Set]\nVAR_INPUT\n    to : Percent;\nEND_VAR\n+--[GT]( to, 5 )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\
         VAR\n    p : Percent := -1;\n    v : Valve := (open := 5, all := [1, 2(6)]);\n    n : INT;\n    a : ARRAY[1..3] OF Percent := [100, 2(100)];\nEND_VAR\n\
         +--[MOV]( p, 100 )--[MOV]( p, 101 )--[MOV]( v.open, -1 )--[MOV]( v.all[1, n], 0 )--[FILL]( a[1..2], 200 )--+\n\
         +--[SEL]( p, I1, 0, 300 )--[ADD]( p, p, 200 )--[MOV]( p, n )--[CALC]( p, 200 )--[MUX]( p, 500, 1, 2 )--[GT]( p, 200 )--[$Set]( 200 )--+\n",
        expect![[r#"
            >         open : Percent := 101;
                                        ^^^ error[literal-out-of-range]: 101 is none of the values 0..100 that an INT here may have
            >     p : Percent := -1;
                                 ^^ error[literal-out-of-range]: -1 is none of the values 0..100 that an INT here may have
            >     v : Valve := (open := 5, all := [1, 2(6)]);
                                                        ^ error[literal-out-of-range]: 6 is none of the values 1..5 that a USINT here may have
            > +--[MOV]( p, 100 )--[MOV]( p, 101 )--[MOV]( v.open, -1 )--[MOV]( v.all[1, n], 0 )--[FILL]( a[1..2], 200 )--+
                                            ^^^ error[literal-out-of-range]: 101 is none of the values 0..100 that an INT here may have
            > +--[MOV]( p, 100 )--[MOV]( p, 101 )--[MOV]( v.open, -1 )--[MOV]( v.all[1, n], 0 )--[FILL]( a[1..2], 200 )--+
                                                                  ^^ error[literal-out-of-range]: -1 is none of the values 0..100 that an INT here may have
            > +--[MOV]( p, 100 )--[MOV]( p, 101 )--[MOV]( v.open, -1 )--[MOV]( v.all[1, n], 0 )--[FILL]( a[1..2], 200 )--+
                                                                                            ^ error[literal-out-of-range]: 0 is none of the values 1..5 that a USINT here may have
            > +--[MOV]( p, 100 )--[MOV]( p, 101 )--[MOV]( v.open, -1 )--[MOV]( v.all[1, n], 0 )--[FILL]( a[1..2], 200 )--+
                                                                                                                  ^^^ error[literal-out-of-range]: 200 is none of the values 0..100 that an INT here may have
            > +--[SEL]( p, I1, 0, 300 )--[ADD]( p, p, 200 )--[MOV]( p, n )--[CALC]( p, 200 )--[MUX]( p, 500, 1, 2 )--[GT]( p, 200 )--[$Set]( 200 )--+
                                  ^^^ error[literal-out-of-range]: 300 is none of the values 0..100 that an INT here may have
            > +--[SEL]( p, I1, 0, 300 )--[ADD]( p, p, 200 )--[MOV]( p, n )--[CALC]( p, 200 )--[MUX]( p, 500, 1, 2 )--[GT]( p, 200 )--[$Set]( 200 )--+
                                                                                       ^^^ error[literal-out-of-range]: 200 is none of the values 0..100 that an INT here may have
            > +--[SEL]( p, I1, 0, 300 )--[ADD]( p, p, 200 )--[MOV]( p, n )--[CALC]( p, 200 )--[MUX]( p, 500, 1, 2 )--[GT]( p, 200 )--[$Set]( 200 )--+
                                                                                                                                             ^^^ error[literal-out-of-range]: 200 is none of the values 0..100 that an INT here may have
        "#]],
    );
}

/// The search of a value; and what other systems write.
#[test]
fn values_that_are_searched_and_written_with_a_sharp() {
    check(
        "TYPE\n    Phase : (IDLE, FULL);\nEND_TYPE\nVAR\n    steps : ARRAY[1..3] OF Phase;\n    found : INT;\nEND_VAR\n\
         +--[SEARCH]( found, EQ, FULL, steps[1..3] )--[GT]( found, 0 )--( )( Q1 )--+\n\
         +--[SEARCH]( found, GT, FULL, steps[1..3] )--[MOV]( steps[1], Phase#IDLE )--+\n",
        expect![[r#"
            > +--[SEARCH]( found, GT, FULL, steps[1..3] )--[MOV]( steps[1], Phase#IDLE )--+
                                                                                 ^ error[unclosed-comment]: this comment is never closed: all that follows is read as comment
                help: close it with a second `#`; the value of an enumeration is written Phase.IDLE
        "#]],
    );
}

#[test]
fn what_is_right_of_a_type_is_kept() {
    check(
        "TYPE\n    Phase : (IDLE, FILLING, IDLE, DONE := x, INT, LAST := 1);\n    Motor : STRUCT\n        speed : REAL;\n        bad   : ARRAY[5..1] OF INT;\n        on    : Nothing;\n        run   : BOOL;\n    END_STRUCT;\nEND_TYPE\nVAR\n    p : Phase := FILLING;\n    m : Motor := (speed := 1.0, bad := [1], on := 3);\nEND_VAR\n+--[EQ]( p, IDLE )--[NE]( p, DONE )--[NE]( p, LAST )--[GT]( m.speed, m.bad[1] )--[ ]( m.on )--( )( m.run )--+\n",
        expect![[r#"
            >     Phase : (IDLE, FILLING, IDLE, DONE := x, INT, LAST := 1);
                                          ^^^^ error[bad-declaration]: the value `IDLE` is there twice
            >     Phase : (IDLE, FILLING, IDLE, DONE := x, INT, LAST := 1);
                                                        ^ error[bad-declaration]: `x` is no CONSTANT of this file with a whole number as its value
            >     Phase : (IDLE, FILLING, IDLE, DONE := x, INT, LAST := 1);
                                                           ^^^ error[bad-declaration]: `INT` is a word of the language: choose another name
            >     Phase : (IDLE, FILLING, IDLE, DONE := x, INT, LAST := 1);
                                                                ^^^^ error[bad-declaration]: `LAST` has the number 1, which is that of `FILLING`
            >         bad   : ARRAY[5..1] OF INT;
                              ^^^^^^^^^^^^^^^^^^ error[bad-declaration]: the last index 1 is below the first 5: swap them
            >         on    : Nothing;
                              ^^^^^^^ error[unknown-type]: there is no type `Nothing`
                help: the types are BOOL, INT, DINT, REAL, TIME, TON, CTU and others; declare one of your own in TYPE Nothing : .. END_TYPE
        "#]],
    );
    // What is no member all the same.
    check(
        "TYPE\n    Motor : STRUCT\n        speed : REAL;\n        run   : BOOL;\n    END_STRUCT;\nEND_TYPE\nVAR\n    m : Motor := (bad := 1);\nEND_VAR\n+--[ ]( m.on )--( )( m.run )--+\n",
        expect![[r#"
            >     m : Motor := (bad := 1);
                                ^^^ error[bad-declaration]: Motor has no member `bad`
            > +--[ ]( m.on )--( )( m.run )--+
                        ^^ error[unknown-member]: Motor has no member `on`
                help: its members are speed run
        "#]],
    );
}

#[test]
fn members_may_be_called_like_types_and_instructions() {
    clean_program(
        "TYPE\n    Motor : STRUCT\n        ton : TON;\n        int : INT := 3;\n        eq  : BOOL;\n        en  : BOOL;\n    END_STRUCT;\nEND_TYPE\nVAR\n    m : Motor := (int := 4);\nEND_VAR\n+--[ ]( m.en )--[TON]( m.ton, 5s )--[GT]( m.int, 3 )--( )( m.eq )--+\n",
    );
    check(
        "TYPE\n    Motor : STRUCT\n        pi     : REAL;\n        struct : INT;\n        speed  : REAL;\n    END_STRUCT;\nEND_TYPE\n",
        expect![[r#"
            >         pi     : REAL;
                      ^^ error[bad-declaration]: `pi` is a word of the language: choose another name
            >         struct : INT;
                      ^^^^^^ error[bad-declaration]: `struct` is a word of the language: choose another name
        "#]],
    );
}

#[test]
fn a_range_is_last() {
    check(
        "VAR\n    g : ARRAY[1..3, 1..4] OF INT;\n    b : ARRAY[1..3, 1..4] OF BOOL;\nEND_VAR\n+--[ ]( b[1..2, 2] )--[FILL]( g[1..2, 2..3], 0 )--[BMOV]( g[1..2][2], g[1, 2..3] )--[FILL]( g[1, 2..3], 0 )--( )( b[1, 1] )--+\n",
        expect![[r#"
            > +--[ ]( b[1..2, 2] )--[FILL]( g[1..2, 2..3], 0 )--[BMOV]( g[1..2][2], g[1, 2..3] )--[FILL]( g[1, 2..3], 0 )--( )( b[1, 1] )--+
                      ^^^^^^ error[bad-operand]: a range is in the last dimension, at the end: name one element here
            > +--[ ]( b[1..2, 2] )--[FILL]( g[1..2, 2..3], 0 )--[BMOV]( g[1..2][2], g[1, 2..3] )--[FILL]( g[1, 2..3], 0 )--( )( b[1, 1] )--+
                                            ^^^^^^ error[bad-operand]: a range is in the last dimension, at the end: name one element here
            > +--[ ]( b[1..2, 2] )--[FILL]( g[1..2, 2..3], 0 )--[BMOV]( g[1..2][2], g[1, 2..3] )--[FILL]( g[1, 2..3], 0 )--( )( b[1, 1] )--+
                                                                        ^^^^^^^ error[bad-operand]: a range is in the last dimension, at the end: name one element here
        "#]],
    );
}

#[test]
fn a_tag_with_the_name_of_a_value() {
    check(
        "TYPE\n    Phase : (IDLE, FILLING);\nEND_TYPE\nVAR\n    p    : Phase;\n    idle : INT;\n    on   : BOOL;\nEND_VAR\n+--[EQ]( p, IDLE )--[MOV]( p, idle )--[CALC]( on, p <> idle )--[EQ]( p, Phase.IDLE )--[NE]( p, on )--( )( on )--+\n",
        expect![[r#"
            > +--[EQ]( p, IDLE )--[MOV]( p, idle )--[CALC]( on, p <> idle )--[EQ]( p, Phase.IDLE )--[NE]( p, on )--( )( on )--+
                          ^^^^ error[type-mismatch]: `IDLE` is the tag of this name here, an INT
                help: for the value of Phase write `Phase.IDLE`
                fix: Replace with `Phase.IDLE`
                  +--[EQ]( p, Phase.IDLE )--[MOV]( p, idle )--[CALC]( on, p <> idle )--[EQ]( p, Phase.IDLE )--[NE]( p, on )---( )( on )--+
            > +--[EQ]( p, IDLE )--[MOV]( p, idle )--[CALC]( on, p <> idle )--[EQ]( p, Phase.IDLE )--[NE]( p, on )--( )( on )--+
                                            ^^^^ error[type-mismatch]: `idle` is the tag of this name here, an INT
                help: for the value of Phase write `Phase.IDLE`
                fix: Replace with `Phase.IDLE`
                  +--[EQ]( p, IDLE )--[MOV]( p, Phase.IDLE )--[CALC]( on, p <> idle )--[EQ]( p, Phase.IDLE )--[NE]( p, on )---( )( on )--+
            > +--[EQ]( p, IDLE )--[MOV]( p, idle )--[CALC]( on, p <> idle )--[EQ]( p, Phase.IDLE )--[NE]( p, on )--( )( on )--+
                                                                     ^^^^ error[type-mismatch]: `idle` is the tag of this name here, an INT
                help: for the value of Phase write `Phase.IDLE`
                fix: Replace with `Phase.IDLE`
                  +--[EQ]( p, IDLE )--[MOV]( p, idle )--[CALC]( on, p <> Phase.IDLE )--[EQ]( p, Phase.IDLE )--[NE]( p, on )---( )( on )--+
            > +--[EQ]( p, IDLE )--[MOV]( p, idle )--[CALC]( on, p <> idle )--[EQ]( p, Phase.IDLE )--[NE]( p, on )--( )( on )--+
                                                                                                    ^^^^^^^^^^^^^ error[type-mismatch]: Phase and BOOL cannot be compared
                help: convert one of them with [TYP] first
        "#]],
    );
}

/// What is asked for elsewhere in the program is not left out.
#[test]
fn another_network_between_those_that_ask() {
    let text = |rungs: &str| {
        format!("TYPE\n    P : (ONE, TWO, THREE, FOUR);\nEND_TYPE\nVAR_INPUT\n    p : P;\nEND_VAR\n{rungs}")
    };
    let ask = |value: &str, coil: u8| format!("+--[EQ]( p, {value} )--( )( Q{coil} )--+\n");
    let (one, two, three) = (ask("ONE", 1), ask("TWO", 2), ask("THREE", 3));
    let other = "+--[ ]( I1 )--( )( Q5 )--+\n";
    clean_program(&text(&format!("{one}{two}{other}{three}{}", ask("FOUR", 4))));
    let again = format!("{}{}", ask("ONE", 6), ask("TWO", 7));
    check_program(
        &text(&format!("{one}{two}{other}{three}{again}")),
        expect![[r#"
            > +--[EQ]( p, ONE )--( )( Q1 )--+
                 ^^^^^^^^^^^^^^ info[unhandled-value]: these 2 networks ask for values of `p`, and none for FOUR
                help: add a network for each, if something is to happen then
        "#]],
    );
}

/// The index of an operand is read, whatever the block does with the operand.
#[test]
fn a_tag_in_its_own_index() {
    let unit = "TYPE\n    Unit : STRUCT\n        tt : ARRAY[1..2] OF TON;\n        ct : ARRAY[1..2] OF CTU;\n        b  : ARRAY[1..2] OF $B;\n        m  : ARRAY[0..1, 1..2] OF INT := [4(1)];\n        on : ARRAY[1..2] OF BOOL;\n    END_STRUCT;\nEND_TYPE\nVAR\n    u : Unit;\n    k : INT;\n    f : ARRAY[1..4] OF BOOL;\nEND_VAR\nVAR_INPUT\n    a, clear : BOOL;\nEND_VAR\n";
    let body = "FUNCTION_BLOCK [$B]\nVAR_OUTPUT\n    q : BOOL;\nEND_VAR\n+--[ ]( EN )--( )( q )--+\nEND_FUNCTION_BLOCK\n";
    for rung in [
        "+--[ ]( a )--[TON]( u.tt[u.m[1, 2]], T#30ms )--( )( Q1 )--+\n",
        "+--[ ]( a )--[CTU]( u.ct[u.m[1, 2]], 3; R := clear )--( )( Q1 )--+\n",
        "+--[ ]( a )--[$B]( u.b[u.m[1, 2]] )--( )( Q1 )--+\n",
        "+--[ ]( a )--[ADD]( u.m[1, u.m[0, 1]], 1, 1 )--( )( u.on[u.m[0, 2]] )--[ ]( u.on[1] )--( )( Q1 )--+\n",
        "+--[MOV]( k, 2 )--[ ]( a )--(S)( f[k] )--+\n\n+--[ ]( clear )--(R)( f[1..4] )--+\n\n+--[ ]( f[2] )--( )( Q1 )--+\n",
    ] {
        let text = format!("{unit}{body}{rung}");
        for rule in [
            "duplicate-timer",
            "duplicate-counter",
            "duplicate-instance",
            "set-without-reset",
            "double-coil",
        ] {
            assert_eq!(found(&text, rule), [""; 0], "{rung}");
        }
    }
}

#[test]
fn members_of_what_is_kept_that_nothing_uses() {
    clean_program(
        "TYPE\n    Kept : STRUCT\n        hours, spare : INT;\n    END_STRUCT;\nEND_TYPE\nVAR RETAIN\n    all : ARRAY[1..3] OF Kept;\nEND_VAR\n+--[ADD]( all[1].hours, all[1].hours, 1 )--+\n",
    );
}

#[test]
fn operands_in_the_order_of_other_systems() {
    let program = |rung: &str| {
        format!(
            "TYPE\n    Phase : (IDLE, RUN);\nEND_TYPE\nVAR step : Phase; a, b, y : INT; END_VAR\nVAR CONSTANT most : INT := 9; END_VAR\n{rung}\n"
        )
    };
    check(
        &program("+--[MOV]( RUN, step )--+"),
        expect![[r#"
        > +--[MOV]( RUN, step )--+
                    ^^^^^^^^^ error[bad-operand]: `RUN` and `step` are swapped
            help: the result comes first
            fix: Swap `RUN` and `step`
              +----------------------------------------------------------[MOV]( step, RUN )--+
    "#]],
    );
    check(
        &program("+--[MOV]( Phase.RUN, step )--+"),
        expect![[r#"
        > +--[MOV]( Phase.RUN, step )--+
                    ^^^^^^^^^^^^^^^ error[bad-operand]: `Phase.RUN` and `step` are swapped
            help: the result comes first
            fix: Swap `Phase.RUN` and `step`
              +----------------------------------------------------[MOV]( step, Phase.RUN )--+
    "#]],
    );
    check(
        &program("+--[MOV]( most, y )--+"),
        expect![[r#"
        > +--[MOV]( most, y )--+
                    ^^^^^^^ error[bad-operand]: `most` and `y` are swapped
            help: the result comes first
            fix: Swap `most` and `y`
              +------------------------------------------------------------[MOV]( y, most )--+
    "#]],
    );
    check(
        &program("+--[CALC]( a + b, y )--+"),
        expect![[r#"
        > +--[CALC]( a + b, y )--+
                     ^^^^^^^^ error[bad-operand]: `a + b` and `y` are swapped
            help: the result comes first
            fix: Swap `a + b` and `y`
              +----------------------------------------------------------[CALC]( y, a + b )--+
    "#]],
    );
    check(
        &program("+--[ADD]( 5, a, y )--+"),
        expect![[r#"
        > +--[ADD]( 5, a, y )--+
                    ^^^^^^^ error[bad-operand]: the result `y` is last here
            help: the result comes first
            fix: Put `y` first
              +------------------------------------------------------------[ADD]( y, 5, a )--+
    "#]],
    );
    check(
        &program("+--[SUB]( most, a, y )--+"),
        expect![[r#"
        > +--[SUB]( most, a, y )--+
                    ^^^^^^^^^^ error[bad-operand]: the result `y` is last here
            help: the result comes first
            fix: Put `y` first
              +---------------------------------------------------------[SUB]( y, most, a )--+
    "#]],
    );
}
