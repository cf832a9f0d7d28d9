//! What is in an operand's place.

use super::{accept, check, in_plant};
use expect_test::expect;

#[test]
fn tags_by_type_and_direction() {
    check(
        &in_plant("+--[ ]( $0"),
        expect![[r#"
            on             BOOL, VAR CONSTANT
            run            BOOL, VAR_OUTPUT
            start          BOOL, VAR_INPUT
            stop           BOOL, VAR_INPUT
            row            ARRAY[1..8] OF BOOL, VAR
            parts          CTU, VAR
            warmup         TON, VAR
            flags          WORD, VAR
            level          INT, VAR_INPUT
            limit          INT, VAR CONSTANT
            total          DINT, VAR
            SYS.FIRST_SCAN BOOL
            SYS.FAULT      BOOL
            SYS.ON         BOOL
            ... 21 in all
        "#]],
    );
    check(
        &in_plant("+--[ ]( start )--( )( $0 )--+"),
        expect![[r#"
        run            BOOL, VAR_OUTPUT
        row            ARRAY[1..8] OF BOOL, VAR
        flags          WORD, VAR
        total          DINT, VAR
        level          INT, VAR_INPUT
        start          BOOL, VAR_INPUT
        stop           BOOL, VAR_INPUT
    "#]],
    );
    check(
        &in_plant("+--[ ]( start )--(R)( $0 )--+"),
        expect![[r#"
        run            BOOL, VAR_OUTPUT
        parts          CTU, VAR
        row            ARRAY[1..8] OF BOOL, VAR
        warmup         TON, VAR
        flags          WORD, VAR
        total          DINT, VAR
        level          INT, VAR_INPUT
        start          BOOL, VAR_INPUT
        stop           BOOL, VAR_INPUT
    "#]],
    );
    check(
        &in_plant("+--[TON]( $0"),
        expect![[r#"
        warmup         TON, VAR
    "#]],
    );
    check(
        &in_plant("+--[TON]( warmup, $0"),
        expect![[r#"
            wait           TIME, VAR
            T#1s           literal
            level          INT, VAR_INPUT
            limit          INT, VAR CONSTANT
            total          DINT, VAR
            parts          CTU, VAR
            SYS.TIME       TIME
            SYS.SCAN_TIME  TIME
            warmup         TON, VAR
        "#]],
    );
    check(
        &in_plant("+--[ADD]( $0"),
        expect![[r#"
        total          DINT, VAR
        wait           TIME, VAR
        level          INT, VAR_INPUT
    "#]],
    );
    check(
        &in_plant("+--[ADD]( total, $0"),
        expect![[r#"
        total          DINT, VAR
        level          INT, VAR_INPUT
        limit          INT, VAR CONSTANT
        parts          CTU, VAR
        SYS.SCAN       DINT
    "#]],
    );
    check(
        &in_plant("+--[GT]( level, $0 )--+"),
        expect![[r#"
        limit          INT, VAR CONSTANT
        level          INT, VAR_INPUT
        flags          WORD, VAR
        total          DINT, VAR
        parts          CTU, VAR
        SYS.SCAN       DINT
    "#]],
    );
    check(
        &in_plant("+--[ ]( row[$0"),
        expect![[r#"
        level          INT, VAR_INPUT
        limit          INT, VAR CONSTANT
        total          DINT, VAR
        parts          CTU, VAR
        SYS.SCAN       DINT
    "#]],
    );
    check(
        &in_plant("+--(RES)( $0 )--+"),
        expect![[r#"
        parts          CTU, VAR
        warmup         TON, VAR
    "#]],
    );
    check(
        &in_plant("+--[FILL]( $0"),
        expect![[r#"
        row            ARRAY[1..8] OF BOOL, VAR
    "#]],
    );
    check(
        &in_plant("+--[ ]( st$0p )--+"),
        expect![[r#"
        start          BOOL, VAR_INPUT
        stop           BOOL, VAR_INPUT
        SYS.FIRST_SCAN BOOL
        SYS.FAULT      BOOL
    "#]],
    );
}

#[test]
fn what_is_being_written_is_not_proposed() {
    check(
        "+--[ ]( abc$0 )--( )( abcd )--+\n",
        expect![[r#"
        abcd           BOOL
    "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--+\n+--[ ]( $0a )--( )( z )--+\n",
        expect![[r#"
            a              BOOL
            y              BOOL
            z              BOOL
            SYS.FIRST_SCAN BOOL
            SYS.FAULT      BOOL
            SYS.ON         BOOL
            SYS.OFF        BOOL
            SYS.CLOCK_10MS BOOL
            SYS.CLOCK_100MS BOOL
            SYS.CLOCK_500MS BOOL
            SYS.CLOCK_1S   BOOL
            SYS.CLOCK_1M   BOOL
            SYS.CLOCK_1H   BOOL
        "#]],
    );
}

#[test]
fn an_unclosed_list_is_finished() {
    accept(
        &in_plant("+--[ ]( $0"),
        "start",
        expect![[r#"
        VAR_INPUT start, stop : BOOL; level : INT; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR
        VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR
        VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR
        +--[ ]( start )--$0
        VAR_INPUT start, stop : BOOL; level : INT; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR
        VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR
        VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR
        +--[ ]( start )--
    "#]],
    );
    accept(
        &in_plant("+--[TON]($0"),
        "warmup",
        expect![[r#"
        VAR_INPUT start, stop : BOOL; level : INT; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR
        VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR
        VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR
        +--[TON]( warmup, ${1:T#1s} )--$0
        VAR_INPUT start, stop : BOOL; level : INT; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR
        VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR
        VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR
        +--[TON]( warmup, T#1s )--
    "#]],
    );
    accept(
        &in_plant("+--[TON]( warmup, $0"),
        "wait",
        expect![[r#"
        VAR_INPUT start, stop : BOOL; level : INT; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR
        VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR
        VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR
        +--[TON]( warmup, wait )--$0
        VAR_INPUT start, stop : BOOL; level : INT; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR
        VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR
        VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR
        +--[TON]( warmup, wait )--
    "#]],
    );
    accept(
        &in_plant("+--[ ]( $0 )--( )( run )--+"),
        "start",
        expect![[r#"
        VAR_INPUT start, stop : BOOL; level : INT; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR
        VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR
        VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR
        +--[ ]( start )--( )( run )--+
        VAR_INPUT start, stop : BOOL; level : INT; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR
        VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR
        VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR
        +--[ ]( start )--( )( run )--+
    "#]],
    );
    accept(
        &in_plant("+--[ ]( st$0 --( )( run )--+"),
        "start",
        expect![[r#"
        VAR_INPUT start, stop : BOOL; level : INT; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR
        VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR
        VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR
        +--[ ]( start )$0 --( )( run )--+
        VAR_INPUT start, stop : BOOL; level : INT; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR
        VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR
        VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR
        +--[ ]( start ) --( )( run )--+
    "#]],
    );
    accept(
        &in_plant("+--( )( $0"),
        "run",
        expect![[r#"
        VAR_INPUT start, stop : BOOL; level : INT; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR
        VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR
        VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR
        +--( )( run )--+$0
        VAR_INPUT start, stop : BOOL; level : INT; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR
        VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR
        VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR
        +--( )( run )--+
    "#]],
    );
}

#[test]
fn members() {
    check(
        &in_plant("+--[ ]( warmup.$0 )--+"),
        expect![[r#"
        Q              BOOL
        IN             BOOL
        R              BOOL
        TT             BOOL
        DN             BOOL
        EN             BOOL
        ET             TIME
        PT             TIME
        ACC            TIME
        PRE            TIME
        AC             TIME
    "#]],
    );
    check(
        &in_plant("+--[GT]( parts.$0"),
        expect![[r#"
        Q              BOOL
        CV             DINT
        PV             DINT
        CU             BOOL
        CD             BOOL
        LD             BOOL
        R              BOOL
        CC             BOOL
        DN             BOOL
        EN             BOOL
        ACC            DINT
        PRE            DINT
        AC             DINT
    "#]],
    );
    check(
        &in_plant("+--[ ]( SYS.$0 )--+"),
        expect![[r#"
            FIRST_SCAN     BOOL
            FAULT          BOOL
            ON             BOOL
            OFF            BOOL
            CLOCK_10MS     BOOL
            CLOCK_100MS    BOOL
            CLOCK_500MS    BOOL
            CLOCK_1S       BOOL
            CLOCK_1M       BOOL
            CLOCK_1H       BOOL
            SCAN           DINT
            TIME           TIME
            SCAN_TIME      TIME
        "#]],
    );
    check(
        &in_plant("+--[ ]( flags.1$0 )--+"),
        expect![[r#"
        1              bit 1 of 16
        10             bit 10 of 16
        11             bit 11 of 16
        12             bit 12 of 16
        13             bit 13 of 16
        14             bit 14 of 16
        15             bit 15 of 16
    "#]],
    );
    check(
        &in_plant("+--[ ]( start.$0 )--+"),
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[ADD]( y, 3.$0 )--+\n",
        expect![[r#"
        nothing
    "#]],
    );
}

#[test]
fn labels_and_functions() {
    check(
        "+--[ ]( a )--<JMP>( $0\n+--<LBL>( done )--+\n+--<FUN>( dose )--<LBL>( inner )--+\n",
        expect![[r#"
            done           label on line 2
        "#]],
    );
    check(
        "+--<JMP>( done )--+\n+--<LBL>( $0 )--+\n",
        expect![[r#"
            done           jumped to on line 1
        "#]],
    );
    check(
        "+--<CALL>( $0 )--+\n+--<FUN>( dose )--+\n+--<FUN>( rinse )--+\n",
        expect![[r#"
        dose           function on line 2
        rinse          function on line 3
    "#]],
    );
    accept(
        "+--<CALL>( do$0\n+--<FUN>( dose )--+\n",
        "dose",
        expect![[r#"
        +--<CALL>( dose )--+$0
        +--<FUN>( dose )--+
        +--<CALL>( dose )--+
        +--<FUN>( dose )--+
    "#]],
    );
}

#[test]
fn named_operands() {
    check(
        &in_plant("+--[TON]( warmup, wait, $0 )--+"),
        expect![[r#"
        R :=           The reset, while it is high.
    "#]],
    );
    check(
        &in_plant("+--[CTUD]( c, 5, R := start, $0 )--+"),
        expect![[r#"
        CD :=          Counts down when it rises.
        LD :=          Loads PV, while it is high.
    "#]],
    );
    check(
        &in_plant("+--[TON]( warmup, wait, R := $0 )--+"),
        expect![[r#"
            on             BOOL, VAR CONSTANT
            run            BOOL, VAR_OUTPUT
            start          BOOL, VAR_INPUT
            stop           BOOL, VAR_INPUT
            row            ARRAY[1..8] OF BOOL, VAR
            parts          CTU, VAR
            flags          WORD, VAR
            level          INT, VAR_INPUT
            limit          INT, VAR CONSTANT
            total          DINT, VAR
            SYS.FIRST_SCAN BOOL
            SYS.FAULT      BOOL
            SYS.ON         BOOL
            SYS.OFF        BOOL
            ... 21 in all
        "#]],
    );
    accept(
        &in_plant("+--[TON]( warmup, wait, $0 )--+"),
        "R :=",
        expect![[r#"
        VAR_INPUT start, stop : BOOL; level : INT; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR
        VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR
        VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR
        +--[TON]( warmup, wait, R := ${1:tag} )--+
        VAR_INPUT start, stop : BOOL; level : INT; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR
        VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR
        VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR
        +--[TON]( warmup, wait, R := tag )--+
    "#]],
    );
    check(
        &in_plant("+--[SEARCH]( total, $0"),
        expect![[r#"
        EQ             equal
        NE             not equal
        GT             greater
        GE             greater or equal
        LT             less
        LE             less or equal
    "#]],
    );
}

#[test]
fn expressions() {
    check(
        &in_plant("+--[CALC]( total, SQ$0 )--+"),
        expect![[r#"
        SQRT(          Square root
    "#]],
    );
    accept(
        &in_plant("+--[CALC]( total, lim$0 )--+"),
        "LIMIT(",
        expect![[r#"
        VAR_INPUT start, stop : BOOL; level : INT; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR
        VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR
        VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR
        +--[CALC]( total, LIMIT(${1:low}, ${2:a}, ${3:high})$0 )--+
        VAR_INPUT start, stop : BOOL; level : INT; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR
        VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR
        VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR
        +--[CALC]( total, LIMIT(low, a, high) )--+
    "#]],
    );
    check(
        &in_plant("+--[CALC]( total, level $0 )--+"),
        expect![[r#"
        AND            operator
        OR             operator
        XOR            operator
        MOD            operator
        SHL            operator
        SHR            operator
    "#]],
    );
    check(
        &in_plant("+--[CALC]( total, MAX(level, $0 )--+"),
        expect![[r#"
        total          DINT, VAR
        level          INT, VAR_INPUT
        limit          INT, VAR CONSTANT
        parts          CTU, VAR
        SYS.SCAN       DINT
        MOV(           Move
        ADD(           Add
        MUL(           Multiply
        SUB(           Subtract
        DIV(           Divide
        EXP(           Power
        ROL(           Rotate left
        ROR(           Rotate right
        ABS(           Absolute value
        ... 48 in all
    "#]],
    );
}

#[test]
fn of_many_tags_the_best_are_proposed() {
    let mut rungs = String::new();
    for n in 0..500 {
        rungs.push_str(&format!("+--[ ]( a{n:03} )--[TON]( t{n}, 5s )--( )( y{n} )--+\n"));
    }
    let (_, found) = super::found(&format!("{rungs}+--[ ]( y499$0 )--( )( z )--+\n"));
    assert_eq!(found.items[0].label, "y499");
    let (_, all) = super::found(&format!("{rungs}+--[ ]( $0 )--( )( z )--+\n"));
    assert!(all.cut && all.items.len() < 200);
    assert_eq!(
        (all.items[0].label.as_str(), all.items[1].label.as_str()),
        ("a000", "a001")
    );
}

#[test]
fn tags_that_begin_as_written_come_before_all_that_hold_the_letters() {
    let mut rungs = String::from("+--[GT]( Start_level, 3 )--( )( done )--+\n");
    for n in 0..300 {
        rungs.push_str(&format!("+--[ ]( a_start_{n:03} )--( )( y{n} )--+\n"));
    }
    let (_, few) = super::found(&format!("{rungs}+--[ ]( sta$0 )--( )( z )--+\n"));
    let labels: Vec<&str> = few.items.iter().map(|item| item.label.as_str()).collect();
    // A number fits worse than a contact's own type, but it is what is written.
    assert_eq!(labels[..3], ["Start_level", "a_start_000", "a_start_001"]);
    assert!(few.cut);
    let (_, many) = super::found(&format!("{rungs}+--[ ]( A_s$0 )--( )( z )--+\n"));
    assert_eq!(many.items[127].label, "a_start_127");
    assert!(many.cut);
}
