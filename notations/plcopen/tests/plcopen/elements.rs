//! What each element becomes.

use crate::harness::{check, program, project, unit};
use expect_test::{Expect, expect};

#[track_caller]
fn body(variables: &str, body: &str, expected: Expect) {
    check(&project("", &program(variables, body), ""), expected);
}

#[test]
fn contacts_and_coils() {
    body(
        "a : BOOL
         q : BOOL",
        "leftPowerRail 1
         contact 2 from=1 a
         coil 3 from=2 q
         contact 4 from=1 negated=true a
         coil 5 from=4 negated=true q
         contact 6 from=1 edge=rising a
         coil 7 from=6 storage=set q
         contact 8 from=1 edge=falling a
         coil 9 from=8 storage=reset q
         contact 10 from=1 a
         contact 11 from=10 edge=falling a
         coil 12 from=11 edge=rising q
         contact 13 from=1 TRUE
         coil 14 from=13 edge=falling q
         contact 15 from=1 NOT(a)
         coil 16 from=15 negated=true storage=set q
         rightPowerRail 99 from=3,5",
        expect![[r#"
            VAR
                a    : BOOL;
                q    : BOOL;
                fell : BOOL;  # a contact sees that its tag falls #
            END_VAR

            +--[ ]( a )----------------------------------------------------------( )( q )--+

            +--[/]( a )----------------------------------------------------------(/)( q )--+

            +--[P]( a )----------------------------------------------------------(S)( q )--+

            +--[/]( a )--[OSR]---------------------------------------------------(R)( q )--+

            +--[/]( a )--[OSR]------------------------------------------------( )( fell )--+

            +--[ ]( a )--[ ]( fell )---------------------------------------------(P)( q )--+

            +--[ ]( SYS.ON )--[NOT]----------------------------------------------(P)( q )--+

            +--[/]( a )----------------------------------------------------------(/)( q )--+
            approximated coil q, set, negated: it is negated, latched or of an edge at once: only the first of these counts
        "#]],
    );
}

#[test]
fn branches_and_bridges() {
    body(
        "a : BOOL
         b : BOOL
         c : BOOL
         d : BOOL
         x : BOOL
         q : BOOL
         r : BOOL",
        "leftPowerRail 1
         contact 2 from=1 a
         contact 3 from=1 b
         contact 4 from=2,3 c
         coil 5 from=4,1 q
         coil 6 from=5 r
         contact 12 from=1 a
         contact 13 from=1 c
         contact 14 from=12 x
         contact 15 from=12 b
         contact 16 from=13,14 d
         coil 17 from=15,16 q
         coil 18 from=12 r",
        expect![[r#"
            VAR
                a     : BOOL;
                b     : BOOL;
                c     : BOOL;
                d     : BOOL;
                x     : BOOL;
                q     : BOOL;
                r     : BOOL;
                point : BOOL;  # power at a point of the drawing #
            END_VAR

            +--\-----\--[ ]( a )--\--[ ]( c )--\-----------------------( )( q )--( )( r )--+
            |  /--\  /--[ ]( b )--/  \---------/                                           |
            |     /------------------/                                                     |

            +--[ ]( a )------------------------------------------------------( )( point )--+

            +--\--[ ]( point )--[ ]( b )------------------\----------------------( )( q )--+
            |  /--\--[ ]( c )----------------\--[ ]( d )--/                                |
            |     /--[ ]( point )--[ ]( x )--/                                             |

            +--[ ]( a )----------------------------------------------------------( )( r )--+
        "#]],
    );
}

#[test]
fn what_is_written_is_read_again() {
    body(
        "a : BOOL
         q : BOOL",
        "leftPowerRail 1
         contact 2 from=1 a
         coil 3 from=2 negated=true a
         coil 4 from=2 q",
        expect![[r#"
            VAR
                a : BOOL;
                q : BOOL;
            END_VAR

            +--[ ]( a )----------------------------------------------------------(/)( a )--+

            +--[ ]( a )----------------------------------------------------------( )( q )--+
        "#]],
    );
}

#[test]
fn gates() {
    body(
        "a : BOOL
         b : BOOL
         c : BOOL
         q : BOOL
         w : WORD
         v : WORD",
        "leftPowerRail 1
         inVariable 2 a
         inVariable 3 b
         contact 4 from=1 edge=rising c
         block 5 OR IN1=2 IN2!negated=3 / OUT
         block 6 AND IN1=5 IN2=4 / OUT!negated
         outVariable 7 from=6 q
         block 8 OR IN1=2 IN2=3 / OUT
         block 9 NOT IN=8 / OUT
         block 10 AND IN1=4 IN2=9 / OUT
         coil 11 from=10 q
         block 12 XOR IN1=4 IN2=3 / OUT
         coil 13 from=12 storage=set q
         inVariable 14 w
         inVariable 15 16#FF
         block 16 AND IN1=14 IN2=15 / OUT
         outVariable 17 from=16 v
         block 18 AND IN1=4 IN2!rising=5 / OUT
         coil 19 from=18 q",
        expect![[r#"
            VAR
                a       : BOOL;
                b       : BOOL;
                c       : BOOL;
                q       : BOOL;
                w       : WORD;
                v       : WORD;
                NOT_IN  : BOOL;  # what comes to a pin #
                XOR_IN1 : BOOL;  # what comes to a pin #
                _xor    : BOOL;  # the result of XOR #
                AND_IN2 : BOOL;  # what comes to a pin #
            END_VAR

            +--\--[ ]( a )--\--[P]( c )--[NOT]-----------------------------------( )( q )--+
            |  /--[/]( b )--/                                                              |

            +--\--[ ]( a )--\-----------------------------------------------( )( NOT_IN )--+
            |  /--[ ]( b )--/                                                              |

            +--[P]( c )--[/]( NOT_IN )-------------------------------------------( )( q )--+

            +--[P]( c )----------------------------------------------------( )( XOR_IN1 )--+

            +-----------------------------------------------[CALC]( _xor, XOR_IN1 XOR b )--+

            +--[ ]( _xor )-------------------------------------------------------(S)( q )--+

            +--------------------------------------------------------[AND]( v, w, 16#FF )--+

            +--\--[ ]( a )--\--[OSR]---------------------------------------( )( AND_IN2 )--+
            |  /--[/]( b )--/                                                              |

            +--[P]( c )--[ ]( AND_IN2 )------------------------------------------( )( q )--+
        "#]],
    );
}

#[test]
fn counters_whose_count_is_read_stop_as_there() {
    let body = "leftPowerRail 1\ncontact 2 from=1 a\ninVariable 3 2\nblock 4 CTU c CU=2 PV=3 / Q CV\ncoil 5 from=4.Q q\noutVariable 6 from=4.CV n";
    check(
        &project("", &program("a : BOOL\nq : BOOL\nn : INT\nc : CTU", body), ""),
        expect![[r#"
            # Counts up as the compilers of Beremiz and OpenPLC do: no further than PV. Q is high from PV on. #
            FUNCTION_BLOCK [$CountUp]
            VAR_INPUT
                R  : BOOL := FALSE;
                PV : INT  := 0;
            END_VAR
            VAR_OUTPUT
                Q  : BOOL;
                CV : INT;
            END_VAR
            +--[ ]( EN )--[OSR]--[/]( R )--[LT]( CV, PV )--------------[ADD]( CV, CV, 1 )--+
            +--[ ]( R )----------------------------------------------------[MOV]( CV, 0 )--+
            +--[GE]( CV, PV )----------------------------------------( )( Q )--( )( ENO )--+
            END_FUNCTION_BLOCK

            VAR
                a : BOOL;
                q : BOOL;
                n : INT;
                c : $CountUp;
            END_VAR

            +--[ ]( a )--------------------------------[$CountUp]( c, PV := 2 )--( )( q )--+

            +------------------------------------------------------------[TYP]( n, c.CV )--+
        "#]],
    );
    let body = "leftPowerRail 1\ncontact 2 from=1 a\ninVariable 3 2\nblock 4 CTU c CU=2 PV=3 / Q CV\ncoil 5 from=4.Q q";
    check(
        &project("", &program("a : BOOL\nq : BOOL\nc : CTU", body), ""),
        expect![[r#"
            VAR
                a : BOOL;
                q : BOOL;
                c : CTU;
            END_VAR

            +--[ ]( a )-------------------------------------------[CTU]( c, 2 )--( )( q )--+
        "#]],
    );
}

#[test]
fn blocks_that_are_brought_along_have_no_errors() {
    let counter = |id: usize, ty: &str, first: &str| {
        format!(
            "contact {id}1 from=1 a\ninVariable {id}2 2\nblock {id}3 {ty} c{id} {first}={id}1 PV={id}2 / Q QU CV\noutVariable {id}4 from={id}3.CV n{id}\n"
        )
    };
    let counters = [("CTU_DINT", "CU"), ("CTD_UDINT", "CD"), ("CTUD_LINT", "CU")];
    let mut body = "leftPowerRail 1\ninVariable 2 a\ninVariable 3 DT#2026-01-31-12:30:00\nblock 4 RTC clock IN=2 PDT=3 / Q CDT\noutVariable 5 from=4.Q q\n".to_owned();
    let mut variables = "a : BOOL\nq : BOOL\nclock : RTC".to_owned();
    for (number, (ty, first)) in counters.iter().enumerate() {
        let id = number + 1;
        body.push_str(&counter(id, ty, first));
        let own = ty.split('_').nth(1).unwrap_or_default();
        variables.push_str(&format!("\nc{id} : {ty}\nn{id} : <{own}/>"));
    }
    let text = crate::harness::text(&project("", &program(&variables, &body), ""));
    assert!(!text.contains("\nerror") && !text.contains("\nrefused"), "{text}");
    for name in ["$IecRTC", "$CountUpDINT", "$CountDownUDINT", "$CountUpDownLINT"] {
        assert!(text.contains(name), "{text}");
    }
}

#[test]
fn functions() {
    body(
        "a : BOOL
         n : INT
         m : INT
         x : REAL
         q : BOOL
         r : BOOL",
        "leftPowerRail 1
         contact 2 from=1 a
         inVariable 3 n
         inVariable 4 2
         block 5 ADD EN=2 IN1=3 IN2=4 / ENO OUT
         outVariable 6 from=5.OUT m
         coil 7 from=5.ENO q
         block 8 GT IN1=5.OUT IN2=4 / OUT
         coil 9 from=8 r
         inVariable 10 (n + 1) * 2
         block 11 INT_TO_REAL IN=10 / OUT
         outVariable 12 from=11 x
         block 13 GE EN=2 IN1=3 IN2=4 / ENO OUT
         coil 14 from=13.OUT q
         inVariable 15 a
         block 16 SEL G=15 IN0=3 IN1=5.OUT / OUT
         outVariable 17 from=16 m
         outVariable 18 from=16 n
         block 19 MYSTERY IN=3 / OUT
         outVariable 20 from=19 n",
        expect![[r#"
            # MYSTERY is not read: a scan runs past it, and what it may write is not known. #
            FUNCTION_BLOCK [$MYSTERY]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread #
            END_FUNCTION_BLOCK

            VAR
                a     : BOOL;
                n     : INT;
                m     : INT;
                x     : REAL;
                q     : BOOL;
                r     : BOOL;
                add   : INT;  # the result of ADD #
                value : INT;  # the value of an expression #
                sel   : INT;  # the result of SEL #
            END_VAR

            +-------------------------------------------------------------[MOV]( add, 0 )--+

            +--[ ]( a )---------------------[ADD]( add, n, 2 )--[MOV]( m, add )--( )( q )--+

            +--[GT]( add, 2 )----------------------------------------------------( )( r )--+

            +------------------------------------------------[CALC]( value, (n + 1) * 2 )--+

            +-----------------------------------------------------------[TYP]( x, value )--+

            +--[ ]( a )--[GE]( n, 2 )--------------------------------------------( )( q )--+

            +-----------------------------------------------------[SEL]( sel, a, n, add )--+

            +-------------------------------------------------------------[MOV]( m, sel )--+

            +-------------------------------------------------------------[MOV]( n, sel )--+

            +-------------------------------------------[$MYSTERY]( 'IN := n, OUT => n' )--+
            approximated block MYSTERY: neither the project nor ladder text has a block `MYSTERY`: a scan runs past it, and what it may write is not known
        "#]],
    );
}

#[test]
fn timers_counters_and_edges() {
    body(
        "a : BOOL
         b : BOOL
         q : BOOL
         n : INT
         t : TIME
         T1 : TON
         C1 : CTU_INT
         S1 : SR
         E1 : R_TRIG
         E2 : F_TRIG",
        "leftPowerRail 1
         contact 2 from=1 a
         contact 20 from=1 b
         contact 21 from=20 a
         inVariable 3 T#2s
         block 4 TON T1 IN=2 PT=3 / Q ET
         coil 5 from=4.Q q
         outVariable 6 from=4.ET t
         inVariable 7 10
         block 8 CTU_INT C1 CU=2 R=21 PV=7 / Q CV
         coil 9 from=8.Q storage=set q
         outVariable 10 from=8.CV n
         block 11 SR S1 S1=2 R=20 / Q1
         coil 12 from=11 q
         block 13 R_TRIG E1 CLK=2 / Q
         coil 14 from=13.Q q
         coil 15 from=13.Q a
         block 16 F_TRIG E2 CLK=20 / Q
         contact 17 from=16.Q b
         coil 18 from=17 storage=reset q
         contact 19 from=1 E1.Q
         coil 22 from=19 q
         block 23 TON EN=20 IN=2 PT=3 / ENO Q ET
         coil 24 from=23.Q q",
        expect![[r#"
            # Counts up as the compilers of Beremiz and OpenPLC do: no further than PV. Q is high from PV on. #
            FUNCTION_BLOCK [$CountUp]
            VAR_INPUT
                R  : BOOL := FALSE;
                PV : INT  := 0;
            END_VAR
            VAR_OUTPUT
                Q  : BOOL;
                CV : INT;
            END_VAR
            +--[ ]( EN )--[OSR]--[/]( R )--[LT]( CV, PV )--------------[ADD]( CV, CV, 1 )--+
            +--[ ]( R )----------------------------------------------------[MOV]( CV, 0 )--+
            +--[GE]( CV, PV )----------------------------------------( )( Q )--( )( ENO )--+
            END_FUNCTION_BLOCK

            VAR
                a    : BOOL;
                b    : BOOL;
                q    : BOOL;
                n    : INT;
                t    : TIME;
                T1   : TON;
                C1   : $CountUp;
                S1   : SR;
                E1_Q : BOOL;  # the output of E1 #
                _ton : TON;  # a block that the project does not declare #
                C1_R : BOOL;  # what comes to a pin #
            END_VAR

            +--[ ]( a )---------------------------------------[TON]( T1, T#2s )--( )( q )--+

            +-----------------------------------------------------------[MOV]( t, T1.ET )--+

            +--[ ]( b )--[ ]( a )---------------------------------------------( )( C1_R )--+

            +--[ ]( a )-------------------[$CountUp]( C1, R := C1_R, PV := 10 )--(S)( q )--+

            +--\-----------------------------------------------------[TYP]( n, C1.CV )--\--+
            |  /--[ ]( a )--\--------------------------[SR]( S1, R := b )--( )( q )--\--/  |
            |               /--[OSR]--\------------------------------( )( E1_Q )--\--/     |
            |                         /--\---------------------------( )( q )--\--/        |
            |                            /---------------------------( )( a )--/           |

            +--[ ]( b )--[NOT]--[OSR]--[ ]( b )----------------------------------(R)( q )--+

            +--[ ]( E1_Q )-------------------------------------------------------( )( q )--+

            +--[ ]( b )--[ ]( a )---------------------------[TON]( _ton, T#2s )--( )( q )--+
            approximated block TON: without EN it stands still there; here EN and its first input are in series
        "#]],
    );
}

#[test]
fn jumps_labels_returns_connectors() {
    body(
        "a : BOOL
         q : BOOL",
        "leftPowerRail 1
         comment 2 What the # does
         contact 3 from=1 a
         jump 4 from=3 label=later
         coil 5 from=1 q
         label 6 label=later
         contact 7 from=1 a
         connector 8 from=7 name=over
         continuation 9 name=over
         coil 10 from=9 q
         return 11 from=3
         continuation 12 name=nowhere
         inVariable 13 a
         comment 14 the end",
        expect![[r#"
            VAR
                a : BOOL;
                q : BOOL;
            END_VAR

            # What the \x23 does #
            +--[ ]( a )----------------------------------------------------<JMP>( later )--+

            +--------------------------------------------------------------------( )( q )--+

            +--<LBL>( later )--------------------------------------------------------------+

            +--[ ]( a )----------------------------------------------------------( )( q )--+

            # a, which nothing is wired to #
            +--[ ]( a )-------------------------------------------------------------<RET>--+

            # the end #
            refused continuation nowhere: no connector has this name
            approximated input a: nothing is wired to it: it is a comment
        "#]],
    );
}

#[test]
fn loops_and_open_ends() {
    body(
        "a : BOOL
         q : BOOL
         T1 : TON",
        "leftPowerRail 1
         contact 2 from=1,3 a
         contact 3 from=2 q
         coil 4 from=2 q
         coil 5 a
         contact 6 from=77 a
         contact 10 from=1 a
         contact 11 from=12.Q a
         block 12 TON T1 IN=10,11 PT=13 / Q ET
         inVariable 13 T#1s
         contact 6 from=1 q",
        expect![[r#"
            VAR
                a  : BOOL;
                q  : BOOL;
                T1 : TON;
            END_VAR

            +--\--[ ]( SYS.OFF )--[ ]( q )--\--[ ]( a )--------------------------( )( q )--+
            |  /----------------------------/                                              |

            +--[ ]( SYS.OFF )----------------------------------------------------( )( a )--+

            +--[ ]( SYS.OFF )--[ ]( a )----------------------------------------------------+

            +--\--[ ]( a )---------------\------------------------------[TON]( T1, T#1s )--+
            |  /--[ ]( T1.Q )--[ ]( a )--/                                                 |

            +--[ ]( q )--------------------------------------------------------------------+
            refused wire: its power comes back to it, without a block between: that wire is left out
            approximated contact q: nothing is wired to it: no power comes there
            approximated coil a: nothing is wired to it: no power comes there
            approximated contact a: nothing is wired to it: no power comes there
            refused connection to 77: no element has this localId
            approximated localId 6: the element at 9:1 has this localId too, and wires end at that
        "#]],
    );
}

#[test]
fn blocks_of_the_project() {
    let motor = unit(
        "functionBlock",
        "Motor_2",
        "inputVars start : BOOL
         inputVars EN : BOOL
         inOutVars count : INT
         outputVars run : BOOL
         delay : TON",
        "<ST>run := start;</ST>",
    );
    let average = format!(
        "<pou name=\"Average\" pouType=\"function\"><interface><returnType><INT/></returnType><inputVars><variable name=\"x\"><type><INT/></type></variable></inputVars></interface><body><FBD>{}</FBD></body></pou>",
        crate::harness::short("inVariable 1 x\nblock 2 ADD IN1=1 IN2=1 / OUT\noutVariable 3 from=2 Average")
    );
    let main = program(
        "a : BOOL
         n : INT
         q : BOOL
         M1 : Motor_2",
        "leftPowerRail 1
         contact 2 from=1 edge=rising a
         inVariable 3 n
         block 4 Motor_2 M1 start=2 count=3 / run
         coil 5 from=4.run q
         block 6 Average x=3 / OUT
         outVariable 7 from=6 n
         contact 8 from=1 M1.run
         coil 9 from=8 q
         block 10 Motor_2 M2 start=2 / run",
    );
    check(
        &project("", &(motor + &average + &main), ""),
        expect![[r#"
            FUNCTION_BLOCK [$Motor_2]
            VAR_INPUT
                start : BOOL := FALSE;
            END_VAR
            VAR_IN_OUT
                count : INT;
            END_VAR
            VAR_OUTPUT
                run : BOOL;
            END_VAR
            VAR
                delay : TON;
            END_VAR

            +--[ ]( start )----------------------------------------------------( )( run )--+
            END_FUNCTION_BLOCK

            FUNCTION_BLOCK [$Average]
            VAR_INPUT
                x : INT := 0;
            END_VAR
            VAR_OUTPUT
                Average : INT;  # what the function returns #
            END_VAR

            +------------------------------------------------------[ADD]( Average, x, x )--+
            END_FUNCTION_BLOCK

            # Motor_2 M2: nothing is wired to `count`, which is read and written; it is not run here. #
            FUNCTION_BLOCK [$Motor_2_M2]
            # ladder: unread #
            END_FUNCTION_BLOCK

            VAR
                a        : BOOL;
                n        : INT;
                q        : BOOL;
                M1       : $Motor_2;
                M2       : $Motor_2;  # a block that the project does not declare #
                M1_start : BOOL;  # what comes to a pin #
                M2_start : BOOL;  # what comes to a pin #
            END_VAR

            +--[P]( a )---------------------------------------------------( )( M1_start )--+

            +-----------------------------[$Motor_2]( M1, start := M1_start, count := n )--+

            +--[ ]( M1.run )-----------------------------------------------------( )( q )--+

            +------------------------------------------[$Average]( x := n, Average => n )--+

            +--[ ]( M1.run )-----------------------------------------------------( )( q )--+

            +--[P]( a )---------------------------------------------------( )( M2_start )--+

            +---------------------------------------------------------------[$Motor_2_M2]--+
            approximated Motor_2 M2: nothing is wired to `count`, which is read and written: it is not run
        "#]],
    );
}

#[test]
fn names_that_cannot_be_spelled() {
    body(
        "ton : BOOL
         Ton-2 : BOOL
         SYS : BOOL",
        "leftPowerRail 1
         contact 2 from=1 TON
         coil 3 from=2 sys
         contact 4 from=1 a;b
         coil 5 from=4 undeclared
         contact 6 from=1 Ton-2
         coil 7 from=6 TON",
        expect![[r#"
            # contact a;b: `;` has no place in an expression here; it is not run here. #
            FUNCTION_BLOCK [$contact_a_b]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread, writes #
            +------------------------------------------------------------------(R)( ENO )--+
            END_FUNCTION_BLOCK

            VAR
                _ton  : BOOL;  # ton in the project #
                Ton_2 : BOOL;  # Ton-2 in the project #
                _SYS  : BOOL;  # SYS in the project #
            END_VAR

            +--[ ]( _ton )----------------------------------------------------( )( _SYS )--+

            +----------------------------------[$contact_a_b]( 'a;b' )--( )( undeclared )--+

            +--[ ]( Ton_2 )---------------------------------------------------( )( _ton )--+
            approximated variable ton: it is spelled `_ton` here
            approximated variable Ton-2: it is spelled `Ton_2` here
            approximated variable SYS: it is spelled `_SYS` here
            approximated contact a;b: `;` has no place in an expression here: it is not run
        "#]],
    );
}

#[test]
fn names_of_several_words() {
    body(
        "pump-1 : BOOL
         n+1 : INT
         n : INT
         localVars my timer : TON
         t2 : TON
         y : BOOL",
        "leftPowerRail 1
         contact 2 from=1 PUMP-1
         coil 3 from=2 y
         contact 4 from=1 my timer.Q
         coil 5 from=4 pump-1
         inVariable 6 n+1 + n
         inVariable 7 n + 1
         block 8 GT IN1=6 IN2=7 / OUT
         coil 9 from=8.OUT y
         contact 10 from=1 y
         inVariable 11 T#1s
         block 12 TON t2 IN=10 PT=11 / Q ET
         coil 13 from=12.Q y",
        expect![[r#"
            VAR
                pump_1   : BOOL;  # pump-1 in the project #
                n_1      : INT;  # n+1 in the project #
                n        : INT;
                my_timer : TON;  # my timer in the project #
                t2       : TON;
                y        : BOOL;
                value    : INT;  # the value of an expression #
                value_2  : INT;  # the value of an expression #
            END_VAR

            +--[ ]( pump_1 )-----------------------------------------------------( )( y )--+

            +--[ ]( my_timer.Q )--------------------------------------------( )( pump_1 )--+

            +----------------------------------------------------[CALC]( value, n_1 + n )--+

            +----------------------------------------------------[CALC]( value_2, n + 1 )--+

            +--[GT]( value, value_2 )--------------------------------------------( )( y )--+

            +--[ ]( y )---------------------------------------[TON]( t2, T#1s )--( )( y )--+
            approximated variable pump-1: it is spelled `pump_1` here
            approximated variable n+1: it is spelled `n_1` here
            approximated variable my timer: it is spelled `my_timer` here
        "#]],
    );
}

#[test]
fn formulas() {
    let formulas = [
        "x ** y ** 2",
        "-x ** 2 + -(y)",
        "-5",
        "x * -5 - (y - 1)",
        "INT_TO_REAL(n + 1) * x",
        "MAX(x, ABS(y))",
        "x y",
        "(x, y)",
        "x + AND",
        "(x",
    ];
    let mut drawn = String::from("leftPowerRail 1");
    for (number, formula) in formulas.iter().enumerate() {
        let (value, variable) = (10 + number, 30 + number);
        drawn.push_str(&format!(
            "\ninVariable {value} {formula}\nblock {} MOVE IN={value} / OUT\noutVariable {variable} from={} z",
            50 + number,
            50 + number
        ));
    }
    body(
        "n : INT\nx : REAL\ny : REAL\nz : REAL",
        &drawn,
        expect![[r#"
            # block MOVE: it is no expression; it is not run here. #
            FUNCTION_BLOCK [$block_MOVE]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread #
            END_FUNCTION_BLOCK

            # output z: nothing holds what `MOVE` has at `OUT`; it is not run here. #
            FUNCTION_BLOCK [$output_z]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread, writes z #
            END_FUNCTION_BLOCK

            # block MOVE: something is missing in it; it is not run here. #
            FUNCTION_BLOCK [$block_MOVE2]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread #
            END_FUNCTION_BLOCK

            # block MOVE: its parentheses do not match; it is not run here. #
            FUNCTION_BLOCK [$block_MOVE3]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread #
            END_FUNCTION_BLOCK

            VAR
                n : INT;
                x : REAL;
                y : REAL;
                z : REAL;
            END_VAR

            +----------------------------------------------------[CALC]( z, (x ^ y) ^ 2 )--+

            +----------------------------------------------------[CALC]( z, -x ^ 2 + -y )--+

            +--------------------------------------------------------------[MOV]( z, -5 )--+

            +-----------------------------------------------[CALC]( z, x * -5 - (y - 1) )--+

            +----------------------------------------------------[CALC]( z, (n + 1) * x )--+

            +-------------------------------------------------[CALC]( z, MAX(x, ABS(y)) )--+

            +--------------------------------------[$block_MOVE]( 'IN := x y, OUT => z' )--+

            +------------------[$block_MOVE]( 'IN := x y, OUT => z' )--[$output_z]( 'z' )--+

            +-----------------------------------[$block_MOVE]( 'IN := (x, y), OUT => z' )--+

            +---------------[$block_MOVE]( 'IN := (x, y), OUT => z' )--[$output_z]( 'z' )--+

            +---------------------------------[$block_MOVE2]( 'IN := x + AND, OUT => z' )--+

            +-------------[$block_MOVE2]( 'IN := x + AND, OUT => z' )--[$output_z]( 'z' )--+

            +--------------------------------------[$block_MOVE3]( 'IN := (x, OUT => z' )--+

            +------------------[$block_MOVE3]( 'IN := (x, OUT => z' )--[$output_z]( 'z' )--+
            approximated block MOVE: it is no expression: it is not run
            approximated output z: nothing holds what `MOVE` has at `OUT`: it is not run
            approximated block MOVE: it is no expression: it is not run
            approximated output z: nothing holds what `MOVE` has at `OUT`: it is not run
            approximated block MOVE: something is missing in it: it is not run
            approximated output z: nothing holds what `MOVE` has at `OUT`: it is not run
            approximated block MOVE: its parentheses do not match: it is not run
            approximated output z: nothing holds what `MOVE` has at `OUT`: it is not run
        "#]],
    );
}

#[test]
fn eno_of_a_conversion_that_the_writer_added_is_that_of_the_function() {
    let body = "leftPowerRail 1
         contact 2 from=1 a
         inVariable 3 s
         block 4 LEN EN=2 IN=3 / ENO OUT
         block 5 INT_TO_DINT EN=4.ENO IN=4.OUT / ENO OUT
         outVariable 6 from=5.OUT n
         coil 7 from=5.ENO q
         rightPowerRail 99 from=7";
    let variables = "a : BOOL
         q : BOOL
         n : DINT
         s : <string/>";
    let header = "<fileHeader companyName=\"\" productName=\"Unnamed\" productVersion=\"0.1.0\"/>\n<types>";
    let own = project("", &program(variables, body), "").replacen("<types>", header, 1);
    check(
        &own,
        expect![[r#"
        VAR
            a : BOOL;
            q : BOOL;
            n : DINT;
            s : STRING;
        END_VAR

        +--[ ]( a )-------------------------------------------[LEN]( n, s )--( )( q )--+
    "#]],
    );
}
