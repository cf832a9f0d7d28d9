//! Blocks, by their brackets and on a wire.

use super::{HOLD, accept, check, found};
use expect_test::expect;

#[test]
fn what_is_used_more_comes_first() {
    check(
        "+--[T$0",
        expect![[r#"
            [TON]          On-delay timer
            [TOF]          Off-delay timer
            [TP]           Pulse timer
            [TYP]          Convert type
            [TRUNC]        Truncate
            [TAN]          Tangent
            [$RunTime]     An hour meter
            [$Toggle]      A switch made of a push button
            [$Total]       An amount from a rate
            [$Tank]        A tank
            [NOT]          Inverter
            [RTO]          Retentive on-delay timer
            [RTOF]         Retentive off-delay timer
            [CTU]          Up counter
            ... 42 in all
        "#]],
    );
    check(
        "+--[C$0",
        expect![[r#"
            [CTU]          Up counter
            [CTD]          Down counter
            [CTUD]         Up-down counter
            [CTC]          Circular counter
            [COS]          Cosine
            [CALC]         Calculate
            [CONCAT]       Join strings
            [$Cylinder]    A pneumatic cylinder with a switch at each end
            [TRUNC]        Truncate
            [ACOS]         Arc cosine
            [REPLACE]      Replace in a string
            [PACK]         Pack a range
            [UNPACK]       Unpack into a range
            [SEARCH]       Search a range
            ... 19 in all
        "#]],
    );
}

#[test]
fn mnemonics_by_the_brackets() {
    check(
        "+--[$0",
        expect![[r#"
            [ ]            Open contact
            [/]            Closed contact
            [P]            Rising-edge contact
            [N]            Falling-edge contact
            [NOT]          Inverter
            [OSR]          One shot rising
            [OSF]          One shot falling
            [TON]          On-delay timer
            [TOF]          Off-delay timer
            [TP]           Pulse timer
            [RTO]          Retentive on-delay timer
            [RTOF]         Retentive off-delay timer
            [CTU]          Up counter
            [CTD]          Down counter
            ... 110 in all
        "#]],
    );
    check(
        "+--($0",
        expect![[r#"
        ( )            Coil
        (/)            Negated coil
        (S)            Set coil
        (R)            Reset coil
        (P)            Rising-edge coil
        (N)            Falling-edge coil
        (M)            Retentive coil
        (SM)           Set retentive coil
        (RM)           Reset retentive coil
        (RES)          Reset timer or counter
    "#]],
    );
    check(
        "+--<$0",
        expect![[r#"
        <LBL>          Label
        <JMP>          Jump
        <FUN>          Function
        <CALL>         Call a function
        <RET>          Return
        <END>          End of the program
        <FOR>          Loop
        <NEXT>         End of a loop
        <MCR>          Master control relay
    "#]],
    );
    check(
        "+--[TO$0",
        expect![[r#"
            [TON]          On-delay timer
            [TOF]          Off-delay timer
            [RTO]          Retentive on-delay timer
            [$Toggle]      A switch made of a push button
            [$Total]       An amount from a rate
            [RTOF]         Retentive off-delay timer
            [$FirstOut]    Which condition came first
            [$Motor]       A motor with its overload relay
        "#]],
    );
    check(
        "+--[to$0",
        expect![[r#"
            [TON]          On-delay timer
            [TOF]          Off-delay timer
            [RTO]          Retentive on-delay timer
            [$Toggle]      A switch made of a push button
            [$Total]       An amount from a rate
            [RTOF]         Retentive off-delay timer
            [$FirstOut]    Which condition came first
            [$Motor]       A motor with its overload relay
        "#]],
    );
    check(
        "+--[MOVE$0",
        expect![[r#"
            [MOV]          Move
            [BMOV]         Move a range
            [SHIFT]        Shift register
        "#]],
    );
    check(
        "+--[/$0",
        expect![[r#"
        [/]            Closed contact
    "#]],
    );
    check(
        "+--[timer$0",
        expect![[r#"
        [TON]          On-delay timer
        [TOF]          Off-delay timer
        [TP]           Pulse timer
        [RTO]          Retentive on-delay timer
        [RTOF]         Retentive off-delay timer
    "#]],
    );
    check(
        "+--[ count$0",
        expect![[r#"
            [CTU]          Up counter
            [CTD]          Down counter
            [CTUD]         Up-down counter
            [CTC]          Circular counter
            [RTOF]         Retentive off-delay timer
            [MUX]          Select one of many
            [LUT]          Look-up table
        "#]],
    );
    check(
        "+--greater$0",
        expect![[r#"
        [GT]           Greater than
        [GE]           Greater or equal
    "#]],
    );
    check(
        "+--(set$0",
        expect![[r#"
            (S)            Set coil
            (SM)           Set retentive coil
        "#]],
    );
}

#[test]
fn a_list_begins_at_the_bracket() {
    for (fixture, written) in [
        ("+--[$0", "["),
        ("+--[TO$0]( t, 5s )--+", "[TO"),
        ("+--[ ]( a )--($0)", "("),
        ("+--< J$0", "< J"),
    ] {
        let (text, found) = found(fixture);
        for item in found.items {
            assert!(
                text[item.range].starts_with(written),
                "{} in {fixture}",
                item.label
            );
            let found = item.filter.starts_with(&written[..1]) && item.filter.len() > 1;
            assert!(found || item.filter == written, "{} in {fixture}", item.filter);
        }
    }
}

#[test]
fn an_accepted_block_is_whole() {
    accept(
        "+--[TO$0\n",
        "[TON]",
        expect![[r#"
        +--[TON]( ${1:t}, ${2:T#1s} )--$0
        +--[TON]( t, T#1s )--
    "#]],
    );
    accept(
        "+--[TO$0]\n",
        "[TON]",
        expect![[r#"
        +--[TON]( ${1:t}, ${2:T#1s} )--$0
        +--[TON]( t, T#1s )--
    "#]],
    );
    accept(
        "+--[TO$0]--( )( y )--+\n",
        "[TON]",
        expect![[r#"
        +--[TON]( ${1:t}, ${2:T#1s} )$0--( )( y )--+
        +--[TON]( t, T#1s )--( )( y )--+
    "#]],
    );
    accept(
        "+--[TO$0--( )( y )--+\n",
        "[TON]",
        expect![[r#"
        +--[TON]( ${1:t}, ${2:T#1s} )$0--( )( y )--+
        +--[TON]( t, T#1s )--( )( y )--+
    "#]],
    );
    accept(
        "+--[TO$0F]( t, 5s )--( )( y )--+\n",
        "[TON]",
        expect![[r#"
        +--[TON]( t, 5s )--( )( y )--+
        +--[TON]( t, 5s )--( )( y )--+
    "#]],
    );
    accept(
        "+--[TO$0( t, 5s )--( )( y )--+\n",
        "[TON]",
        expect![[r#"
        +--[TON]( t, 5s )--( )( y )--+
        +--[TON]( t, 5s )--( )( y )--+
    "#]],
    );
    accept(
        "+--[$0]\n",
        "[ ]",
        expect![[r#"
        +--[ ]( ${1:tag} )--$0
        +--[ ]( tag )--
    "#]],
    );
    accept(
        "+--[ $0 ]--\\\n",
        "[ ]",
        expect![[r#"
        +--[ ]( ${1:tag} )$0--\
        +--[ ]( tag )--\
    "#]],
    );
    accept(
        "+--[ ]( a )--($0\n",
        "( )",
        expect![[r#"
        +--[ ]( a )--( )( ${1:tag} )--+$0
        +--[ ]( a )--( )( tag )--+
    "#]],
    );
    accept(
        "+--[ ]( a )--($0)\n",
        "(S)",
        expect![[r#"
        +--[ ]( a )--(S)( ${1:tag} )--+$0
        +--[ ]( a )--(S)( tag )--+
    "#]],
    );
    accept(
        "+--[ ]( a )--<J$0\n",
        "<JMP>",
        expect![[r#"
        +--[ ]( a )--<JMP>( ${1:name} )--+$0
        +--[ ]( a )--<JMP>( name )--+
    "#]],
    );
    accept(
        "|  /--[$0\n",
        "[/]",
        expect![[r#"
        |  /--[/]( ${1:tag} )--$0
        |  /--[/]( tag )--
    "#]],
    );
    accept(
        "+--[OS$0\n",
        "[OSR]",
        expect![[r#"
        +--[OSR]--$0
        +--[OSR]--
    "#]],
    );
    accept(
        "+--[SEAR$0\n",
        "[SEARCH]",
        expect![[r#"
        +--[SEARCH]( ${1:y}, ${2:EQ}, ${3:a}, ${4:t[1..8]} )--$0
        +--[SEARCH]( y, EQ, a, t[1..8] )--
    "#]],
    );
}

#[test]
fn an_empty_rung() {
    check(
        "+--$0",
        expect![[r#"
            [ ]            Open contact
            [/]            Closed contact
            [P]            Rising-edge contact
            [N]            Falling-edge contact
            [NOT]          Inverter
            [OSR]          One shot rising
            [OSF]          One shot falling
            ( )            Coil
            (/)            Negated coil
            (S)            Set coil
            (R)            Reset coil
            (P)            Rising-edge coil
            (N)            Falling-edge coil
            (M)            Retentive coil
            ... 128 in all
        "#]],
    );
    accept(
        "+--$0\n",
        "[ ]",
        expect![[r#"
        +--[ ]( ${1:tag} )--$0
        +--[ ]( tag )--
    "#]],
    );
    accept(
        "+--[ ]( a )$0--+\n",
        "( )",
        expect![[r#"
        +--[ ]( a )--( )( ${1:tag} )$0--+
        +--[ ]( a )--( )( tag )--+
    "#]],
    );
    accept(
        "+--to$0\n",
        "[TON]",
        expect![[r#"
        +--[TON]( ${1:t}, ${2:T#1s} )--$0
        +--[TON]( t, T#1s )--
    "#]],
    );
    accept(
        "+$0\n",
        "[ ]",
        expect![[r#"
        +--[ ]( ${1:tag} )--$0
        +--[ ]( tag )--
    "#]],
    );
}

#[test]
fn user_defined_blocks() {
    let with = |rung: &str| format!("{HOLD}{rung}\n");
    check(
        &with("+--[$H$0"),
        expect![[r#"
            [$Hold]        User-defined block
            [$Hysteresis]  A switch with two thresholds
            [$Heater]      Something that is heated
        "#]],
    );
    check(
        &with("+--($$0"),
        expect![[r#"
        nothing
    "#]],
    );
    accept(
        &with("+--[$H$0"),
        "[$Hold]",
        expect![[r#"
        FUNCTION_BLOCK [$Hold]
        VAR_INPUT raw : BOOL; wait : TIME := T#1s; END_VAR
        VAR_OUTPUT clean : BOOL; END_VAR
        +--[ ]( raw )--( )( clean )--+
        END_FUNCTION_BLOCK
        +--[\$Hold]( ${1:raw}, ${2:wait}, ${3:clean} )--$0
        FUNCTION_BLOCK [$Hold]
        VAR_INPUT raw : BOOL; wait : TIME := T#1s; END_VAR
        VAR_OUTPUT clean : BOOL; END_VAR
        +--[ ]( raw )--( )( clean )--+
        END_FUNCTION_BLOCK
        +--[$Hold]( raw, wait, clean )--
    "#]],
    );
    check(
        &with("+--[$Hold]( $0 )--+"),
        expect![[r#"
            raw :=         BOOL
            wait :=        TIME
            clean =>       BOOL
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
    check(
        &with("+--[$Hold]( raw := a, $0 )--+"),
        expect![[r#"
            a              DINT
            wait :=        TIME
            clean =>       BOOL
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
    check(
        &with("+--[$Hold]( a, $0 )--+"),
        expect![[r#"
        SYS.TIME       TIME
        SYS.SCAN_TIME  TIME
        T#1s           literal
    "#]],
    );
    // Not in its own body.
    check(
        &HOLD.replace("[ ]( raw )", "[$$0"),
        expect![[r#"
            [$Alarm]       An alarm with delay, latch and acknowledgement
            [$Alternate]   Machines that take turns
            [$Average]     The average of the last n runs
            [$Blink]       A square wave while EN is high
            [$Debounce]    A signal without its bounces
            [$Drum]        A drum with up to 16 steps
            [$FirstOut]    Which condition came first
            [$Hysteresis]  A switch with two thresholds
            [$Interval]    How long ago the last run was
            [$PID]         A controller in parallel form
            [$Ramp]        A value that changes no faster than allowed
            [$RunTime]     An hour meter
            [$Scale]       A value on another scale, kept within its limits
            [$Step]        One step of a chain
            ... 24 in all
        "#]],
    );
}

#[test]
fn only_what_the_profile_has() {
    for (profile, has, has_not) in [
        ("iec", "[TP] [CTUD] [SIN] [SCANTIME] [RTO]", ""),
        (
            "ldmicro",
            "[TON] [TOF] [RTO] [CTC] [OSR] [LUT]",
            "[TP] [CTUD] [SIN] [P] [SCANTIME]",
        ),
        (
            "iot",
            "[TON] [TOF] [CTD] [P] [SCANTIME]",
            "[RTO] [CTC] [OSR] [LUT] [SIN]",
        ),
    ] {
        let fixture = format!("# ladder: profile {profile} #\n+--[$0\n");
        let (_, found) = found(&fixture);
        let offered = |block: &str| found.items.iter().any(|item| item.label == block);
        for block in has.split_whitespace() {
            assert!(offered(block), "{block} is offered in {profile}");
        }
        for block in has_not.split_whitespace() {
            assert!(!offered(block), "{block} is not offered in {profile}");
        }
    }
}

#[test]
fn members_have_the_types_of_the_profile() {
    let types = |profile: &str| {
        let fixture = format!(
            "# ladder: profile {profile} #\nVAR t : TON; c : CTU; END_VAR\n+--[MOV]( y, t.$0 )--[MOV]( z, c.CV )--+\n"
        );
        let (_, found) = found(&fixture);
        let elapsed = found.items.iter().find(|item| item.label == "ET");
        elapsed.map(|item| item.detail.clone()).unwrap_or_default()
    };
    assert_eq!(
        [types("iec"), types("ldmicro"), types("iot")],
        ["TIME", "INT", "DINT"]
    );
}
