//! What becomes of single lines that only LDmicro's fork has, and how they come back.

use crate::programs::{converted, read, there_and_back, write};
use expect_test::{Expect, expect};
use ladder_notation::Outcome;

#[track_caller]
fn check(text: &str, expected: Expect) {
    expected.assert_eq(&read(text));
}

/// A program with these rungs, each given by its elements.
pub(crate) fn program(rungs: &[&str]) -> String {
    let mut text =
        "LDmicro0.2\nCYCLE=10000\nCRYSTAL=4000000\nBAUD=2400\n\nIO LIST\nEND\n\nPROGRAM\n".to_owned();
    for (index, rung) in rungs.iter().enumerate() {
        text.push_str(&format!("RUNG {}\n", index + 1));
        for line in rung.lines() {
            text.push_str(&format!("  {line}\n"));
        }
        text.push_str("END\n");
    }
    text
}

/// What becomes of one element, and that it comes back.
#[test]
fn one_by_one() {
    let elements = [
        "TON Ta 100000 0",
        "TON Ta 100000 -1",
        "TON Ta 100000",
        "TON Ta 5000 0",
        "TON Ta v 0",
        "TOF Ta v 0",
        "RTO Ta 20000 3",
        "TCY Ta 20000",
        "THI Ta 25000 0",
        "TLO Ta 1000 0",
        "RTL Ta v 0",
        "TIME2COUNT n 25000",
        "TIME2COUNT n 50000 1",
        "TIME2COUNT n 50000 0",
        "TIME2COUNT n v",
        "SWAP n m",
        "SWAP 5 m",
        "OPPOSITE n 0x0F",
        "7SEGMENTS n m C",
        "7SEGMENTS n m A",
        "7SEGMENTS n 'C' C",
        "7SEGMENTS #PORTB 5 A",
        "CTU Ca 5",
        "CTU Ca 5 2",
        "CTU Ca v 0 o",
        "CTD Ca 5 v \\",
        "CTC Ca 5 0 -",
        "CTR Ca 0 5 /",
        "CTR Ca 0 5 x",
        "CTU Ca 70000 0 /",
        "COIL Ya 0 0 0 1",
        "COIL Ya 1 0 0 1",
        "CONTACTS Xa 1 1",
        "CONTACTS ROverflowFlagV 0 0",
        "SHL n m 17",
        "SHL n m -1",
        "SET_BIT n 16",
        "SET_BIT n v",
        "CLEAR_BIT n v",
        "IF_BIT_SET n v",
        "IF_BIT_CLEAR 5 v",
        "SET_BIT 5 1",
        "AND 5 n m",
        "MOD n m 0x1F",
        "NOT n 'A'",
        "OSL",
        "ODF",
        "ODR",
        "UART_SEND n",
        "UART_SEND n 1 1",
        "UART_RECV n 1 1",
        "SET_PWM d 1000 P1 8",
        "SET_PWM d f P1 8",
        "SET_PWM d 1000 Pled 0-100%",
        "READ_ADC Aa",
        "READ_ADC Aa 2",
        "PIECEWISE_LINEAR n m 2 0 0 5 9 tab",
        "FORMATTED_STRING (none) a\\x20b\\?",
        "RETURN",
        "GOSUB 2",
    ];
    let mut out = String::new();
    for element in elements {
        let text = program(&[element]);
        let converted = converted(text.as_bytes()).expect("it can be read");
        let ladder = converted.written.text;
        let networks = ladder
            .lines()
            .filter(|line| line.starts_with('+') && line.contains("--"));
        let network = networks.take(1).collect::<String>();
        let network = network.trim_matches(['+', '-', ' ']).to_owned();
        out.push_str(&format!("{element}: {network}\n"));
        for entry in &converted.report.entries {
            match &entry.outcome {
                Outcome::Translated => {}
                Outcome::Approximated(why) => out.push_str(&format!("    nearly: {why}\n")),
                Outcome::Refused(why) => out.push_str(&format!("    not: {why}\n")),
            }
        }
        assert_eq!(write(&ladder), Ok(text), "{ladder}");
    }
    expect![[r#"
        TON Ta 100000 0: [TON]( Ta, T#110ms )
        TON Ta 100000 -1: [TON]( Ta, T#100ms )--# was: TON Ta 100000 -1 #
        TON Ta 100000: [TON]( Ta, T#110ms )--# was: TON Ta 100000 #
        TON Ta 5000 0: [TON]( Ta, T#15ms )
        TON Ta v 0: [$TON]( Ta, v )
        TOF Ta v 0: # ldmicro: TOF Ta v 0 #
            not: LDmicro's fork works out from its delay what it begins with, and stops where that is a variable
        RTO Ta 20000 3: [RTO]( Ta, T#60ms )--# was: RTO Ta 20000 3 #
        TCY Ta 20000: [$TCY]( Ta, 2 )--# was: TCY Ta 20000 #
        THI Ta 25000 0: [$THI]( Ta, 2 )--# was: THI Ta 25000 0 #
        TLO Ta 1000 0: # ldmicro: TLO Ta 1000 0 #
            not: its delay is 0 cycles: 1 to 32767 are possible
        RTL Ta v 0: # ldmicro: RTL Ta v 0 #
            not: its delay is not a number, and LDmicro's fork takes nothing else here
        TIME2COUNT n 25000: [$TIME2COUNT]( n, 2 )--# was: TIME2COUNT n 25000 #
        TIME2COUNT n 50000 1: [$TIME2COUNT]( n, 6 )--# was: TIME2COUNT n 50000 1 #
        TIME2COUNT n 50000 0: [$TIME2COUNT]( n, 5 )
        TIME2COUNT n v: # ldmicro: TIME2COUNT n v #
            not: its delay is not a number
        SWAP n m: [$SWAP]( n, m )
        SWAP 5 m: # ldmicro: SWAP 5 m #
            not: 5 is a number and cannot be written
        OPPOSITE n 0x0F: [$OPPOSITE]( n, 15 )--# was: OPPOSITE n 0x0F #
        7SEGMENTS n m C: [$SEGMENTS7]( n, m )
        7SEGMENTS n m A: [$SEGMENTS7anode]( n, m )
        7SEGMENTS n 'C' C: [$SEGMENTS7of]( n, 67 )--# was: 7SEGMENTS n 'C' C #
        7SEGMENTS #PORTB 5 A: [$SEGMENTS7anodeof]( _PORTB, 5 )
            nearly: it is spelled `_PORTB` here
            nearly: #PORTB is a register of the controller; here it is a tag
        CTU Ca 5: [$CTU]( Ca, 5 )--# was: CTU Ca 5 #
        CTU Ca 5 2: [$CTU]( Ca, 5 )--# was: CTU Ca 5 2 #
        CTU Ca v 0 o: [$CTUlow]( Ca, v )
        CTD Ca 5 v \: [$CTDfallfrom]( Ca, 5, v )
        CTC Ca 5 0 -: [$CTChigh]( Ca, 5, 0 )
        CTR Ca 0 5 /: [$CTR]( Ca, 0, 5 )
        CTR Ca 0 5 x: # ldmicro: CTR Ca 0 5 x #
            not: its last field is none of `/`, `\`, `-` and `o`
        CTU Ca 70000 0 /: # ldmicro: CTU Ca 70000 0 / #
            not: 70000 does not fit 16 bits
        COIL Ya 0 0 0 1: ($T)( Ya )
        COIL Ya 1 0 0 1: (/)( Ya )--# was: COIL Ya 1 0 0 1 #
        CONTACTS Xa 1 1: [/]( Xa )--# was: CONTACTS Xa 1 1 #
        CONTACTS ROverflowFlagV 0 0: [ ]( ROverflowFlagV )
            nearly: LDmicro's fork makes it high when a sum or difference does not fit; here nothing does
        SHL n m 17: # ldmicro: SHL n m 17 #
            not: 17 is not a number of bits to shift 16 bits by: 0 to 16
        SHL n m -1: # ldmicro: SHL n m -1 #
            not: -1 is not a number of bits to shift 16 bits by: 0 to 16
        SET_BIT n 16: # ldmicro: SET_BIT n 16 #
            not: bit 16 is outside of 16 bits
        SET_BIT n v: [$SETBIT]( n, v )
        CLEAR_BIT n v: [$CLEARBIT]( n, v )
        IF_BIT_SET n v: [$IFBITSET]( n, v )
        IF_BIT_CLEAR 5 v: # ldmicro: IF_BIT_CLEAR 5 v #
            not: 5 is a number and has no bits to change
        SET_BIT 5 1: # ldmicro: SET_BIT 5 1 #
            not: 5 is a number and has no bits to change
        AND 5 n m: # ldmicro: AND 5 n m #
            not: 5 is a number and cannot be written
        MOD n m 0x1F: [MOD]( n, m, 31 )--# was: MOD n m 0x1F #
        NOT n 'A': [NOT]( n, 65 )--# was: NOT n 'A' #
        OSL: [$OSL]
        ODF: [$OSL]--# was: ODF #
        ODR: [$ODR]
        UART_SEND n: [USND]( n )--# was: UART_SEND n #
        UART_SEND n 1 1: [$UARTSEND]( 'n 1 1' )
            nearly: it is not run here, and no power comes out of it: it is about several bytes, or waits for the line
        UART_RECV n 1 1: [URCV]( n )--# was: UART_RECV n 1 1 #
        SET_PWM d 1000 P1 8: [PWM]( d, 1000, CH := 1 )--# was: SET_PWM d 1000 P1 8 #
            nearly: its duty is not in percent in LDmicro; here it is
        SET_PWM d f P1 8: [$SETPWM]( 'd f P1 8' )
            nearly: it is not run here, and power passes: its frequency is a variable
        SET_PWM d 1000 Pled 0-100%: [PWM]( d, 1000, CH := 0 )
        READ_ADC Aa: [ADC]( Aa, 0 )--# was: READ_ADC Aa #
        READ_ADC Aa 2: [ADC]( Aa, 0 )--# was: READ_ADC Aa 2 #
        PIECEWISE_LINEAR n m 2 0 0 5 9 tab: [PWL]( n, m, 0, 0, 5, 9 )--# was: PIECEWISE_LINEAR n m 2 0 0 5 9 tab #
        FORMATTED_STRING (none) a\x20b\?: [FMT]( 'a b?' )--# was: FORMATTED_STRING (none) a\x20b\? #
            nearly: here it is also sent once at the start; the fork waits until power comes
        RETURN: # ldmicro: RETURN #
            not: it is in no subprogram
        GOSUB 2: # ldmicro: GOSUB 2 #
            not: there is no subprogram `2` that could be made a function
    "#]].assert_eq(&out);
}

/// What is outside of a program becomes an unread part: what it writes is named, the program has no errors, and the element
/// comes back.
#[test]
fn what_is_outside_of_a_program_is_unread() {
    let elements = [
        "BUS n m 7 6 5 4 3 2 1 0",
        "9SEGMENTS n m C",
        "TIME2DELAY d 100",
        "DELAY d",
        "SLEEP",
        "SLEEP Td 5000",
        "CLRWDT",
        "LOCK",
        "RSFR n 5",
        "RANDOM n",
        "SEED_RANDOM n 5",
        "NPULSE n 5 Ya",
        "PULSER 1 1 1 n Ya",
        "STEPPER s 5 1 1 1 Ya",
        "QUAD_ENCOD n 0 Xa Xb Xz Ya / 5",
        "SPI SPI1 a b Master 0 8 MSB 1000",
        "I2C_RD I2C1 - \\'$ #PORTA 0x20 255 MSB 1000",
        "UART_RECV_AVAIL",
        "UART_SEND_BUSY",
        "UART_SENDn n",
        "UART_SEND n 4 1",
        "UART_RECV n 2 0",
        "SET_PWM d f",
        "STRING s n 3 97 98 99",
        "STRING s n naïve  text",
    ];
    let mut out = String::new();
    for element in elements {
        let text = program(&[&format!(
            "CONTACTS Xa 0 0\nTON Ta 100000 0\n{element}\nCOIL Yb 0 0 0 0"
        )]);
        let converted = converted(text.as_bytes()).expect("it can be read");
        let ladder = converted.written.text;
        let block = ladder.split("--").find(|block| block.starts_with("[$"));
        let block = block.unwrap_or_default().trim_end_matches('-');
        let unread = ladder
            .split_once("# ladder: unread")
            .map_or("", |(_, after)| after);
        let writes = unread.split('#').next().unwrap_or_default().trim();
        let remarks = converted.report.remarks();
        let remarks: Vec<String> = remarks.map(|entry| format!("{:?}", entry.outcome)).collect();
        out.push_str(&format!("{block}{writes}\n    {}\n", remarks.join("; ")));
        let analysis = ladder_analysis::analyze(&ladder_syntax::parse(&ladder).into(), "test.clad");
        assert!(analysis.program().is_some(), "{ladder}");
        assert_eq!(write(&ladder), Ok(text));
    }
    expect![[r#"
        [$BUS]( 'n m 7 6 5 4 3 2 1 0' ), writes
            Approximated("it is not run here, and power passes: LDmicro itself makes nothing of it")
        [$SEGMENTS9]( 'n m C' ), writes
            Approximated("it is not run here, and power passes: LDmicro itself lacks the characters of this display")
        [$TIME2DELAY]( 'd 100' ), writes
            Approximated("it is not run here, and power passes: how many loops it counts depends on the controller")
        [$DELAY]( 'd' ), writes
            Approximated("it is not run here, and power passes: it is about the hardware of the controller")
        [$SLEEP], writes
            Approximated("it is not run here, and power passes: it is about the hardware of the controller")
        [$SLEEP]( 'Td 5000' ), writes
            Approximated("it is not run here, and power passes: it is about the hardware of the controller")
        [$CLRWDT], writes
            Approximated("it is not run here, and power passes: it is about the hardware of the controller")
        [$LOCK]
            Approximated("it is not run here, and power passes: it is about the hardware of the controller")
        [$RSFR]( 'n 5' ), writes
            Approximated("it is not run here, and power passes: it is about a register of the controller")
        [$RANDOM]( 'n' ), writes
            Approximated("it is not run here, and power passes: there are no random numbers here")
        [$SEEDRANDOM]( 'n 5' ), writes
            Approximated("it is not run here, and power passes: there are no random numbers here")
        [$NPULSE]( 'n 5 Ya' ), writes
            Approximated("it is not run here, and power passes: there are no pulses here")
        [$PULSER]( '1 1 1 n Ya' ), writes
            Approximated("it is not run here, and no power comes out of it: there are no pulses here")
        [$STEPPER]( 's 5 1 1 1 Ya' ), writes
            Approximated("it is not run here, and no power comes out of it: there are no pulses here")
        [$QUADENCOD]( 'n 0 Xa Xb Xz Ya / 5' ), writes Xa
            Approximated("it is not run here, and no power comes out of it: there are no pulses here")
        [$SPI]( 'SPI1 a b Master 0 8 MSB 1000' ), writes
            Approximated("it is not run here, and power passes: it is about the hardware of the controller")
        [$I2CRD]( 'I2C1 - \$'$$ #PORTA 0x20 255 MSB 1000' ), writes
            Approximated("it is not run here, and power passes: it is about the hardware of the controller")
        [$UARTRECVAVAIL], writes
            Approximated("it is not run here, and no power comes out of it: no byte is ever waiting here")
        [$UARTSENDBUSY], writes
            Approximated("it is not run here, and power passes: the serial line is always free here")
        [$UARTSENDn]( 'n' ), writes
            Approximated("it is not run here, and no power comes out of it: it is about several bytes, or waits for the line")
        [$UARTSEND]( 'n 4 1' ), writes
            Approximated("it is not run here, and no power comes out of it: it is about several bytes, or waits for the line")
        [$UARTRECV]( 'n 2 0' ), writes
            Approximated("it is not run here, and no power comes out of it: it is about several bytes, or waits for the line")
        [$SETPWM]( 'd f' ), writes
            Approximated("it is not run here, and power passes: its frequency is a variable")
        [$STRING]( 's n 3 97 98 99' ), writes
            Approximated("it is not run here, and power passes: LDmicro writes a number into a text as C does")
        [$STRING]( 's n naïve  text' ), writes
            Approximated("it is not run here, and power passes: LDmicro writes a number into a text as C does")
    "#]].assert_eq(&out);
}

/// What a hand puts into the fields of such a block is not a line of its own.
#[test]
fn fields_are_one_line() {
    let text = program(&["DELAY d"]);
    let ladder = converted(text.as_bytes()).expect("it can be read").written.text;
    let written = write(&ladder.replace("'d'", "'d$NEND'")).expect("it can be written");
    assert!(written.contains("COMMENT +--"), "{written}");
}

#[test]
fn jumps_that_lead_nowhere() {
    let rungs = [
        "GOTO nowhere\nGOTO inside\nGOTO 4\nGOTO 0",
        "LABEL twice\nGOTO twice",
        "SUBPROG sub",
        "LABEL inside\nGOTO twice\nGOTO 1\nGOTO 5",
        "ENDSUB sub",
        "LABEL twice\nGOSUB other",
        "SUBPROG outer",
        "SUBPROG inner",
        "ENDSUB inner",
        "ENDSUB outer",
        "SUBPROG beside\nOSR",
        "ENDSUB beside",
        "MASTER_RELAY",
    ];
    let text = program(&rungs);
    check(
        &text,
        expect![[r#"
            # ldmicro: LDmicro0.2 #
            # ldmicro: CYCLE=10000 #
            # ldmicro: CRYSTAL=4000000 #
            # ldmicro: BAUD=2400 #
            # ladder: profile ldmicro #

            +--# ldmicro: GOTO nowhere #--# ldmicro: GOTO inside #--# ldmicro: GOTO 4 #--# ldmicro: GOTO 0 #---+

            +--<LBL>( twice )----------------------------------------------<JMP>( twice )--+

            # ldmicro: SUBPROG sub #

            +--# ldmicro: LABEL twice #--# ldmicro: GOSUB other #--------------------------+

            +--# ldmicro: SUBPROG outer #--------------------------------------------------+

            # ldmicro: SUBPROG inner #

            +--# ldmicro: ENDSUB outer #---------------------------------------------------+

            +--# ldmicro: SUBPROG beside #--[OSR]------------------------------------------+

            +--# ldmicro: ENDSUB beside #--------------------------------------------------+

            +-----------------------------------------------------------------------<MCR>--+

            +--<FUN>( sub )----------------------------------------------------------------+

            +--<LBL>( inside )--# ldmicro: GOTO twice #--# ldmicro: GOTO 1 #-----------<RET>--# was: GOTO 5 #--+

            +--<FUN>( inner )--------------------------------------------------------------+
            11:1 GOTO nowhere: refused: there is no label `nowhere`
            12:1 GOTO inside: refused: it leads out of its subprogram, or into one, to `inside`
            13:1 GOTO 4: refused: rung 4 is in another subprogram, or in none
            14:1 GOTO 0: refused: rungs are counted from 1
            25:1 GOTO twice: refused: it leads out of its subprogram, or into one, to `twice`
            26:1 GOTO 1: refused: rung 1 is in another subprogram, or in none
            33:1 LABEL twice: refused: there is another label `twice`, which the jumps lead to
            34:1 GOSUB other: refused: there is no subprogram `other` that could be made a function
            37:1 SUBPROG outer: refused: a function is made of one SUBPROG and one ENDSUB after it, each alone in its rung, with no other between them
            46:1 ENDSUB outer: refused: a function is made of one SUBPROG and one ENDSUB after it, each alone in its rung, with no other between them
            49:1 SUBPROG beside: refused: a function is made of one SUBPROG and one ENDSUB after it, each alone in its rung, with no other between them
            53:1 ENDSUB beside: refused: a function is made of one SUBPROG and one ENDSUB after it, each alone in its rung, with no other between them
            11:1 ldmicro-element: `GOTO nowhere` stays as a comment: there is no label `nowhere`
            11:1 ldmicro-jump: GOTO 'nowhere': there is no LABEL 'nowhere'
            12:1 ldmicro-element: `GOTO inside` stays as a comment: it leads out of its subprogram, or into one, to `inside`
            13:1 ldmicro-element: `GOTO 4` stays as a comment: rung 4 is in another subprogram, or in none
            14:1 ldmicro-element: `GOTO 0` stays as a comment: rungs are counted from 1
            14:1 ldmicro-jump: GOTO '0': there is no LABEL '0'
            25:1 ldmicro-element: `GOTO twice` stays as a comment: it leads out of its subprogram, or into one, to `twice`
            26:1 ldmicro-element: `GOTO 1` stays as a comment: rung 1 is in another subprogram, or in none
            33:1 ldmicro-element: `LABEL twice` stays as a comment: there is another label `twice`, which the jumps lead to
            33:1 ldmicro-jump: LABEL 'twice' is there already, on line 17
            34:1 ldmicro-element: `GOSUB other` stays as a comment: there is no subprogram `other` that could be made a function
            34:1 ldmicro-jump: GOSUB 'other': there is no SUBPROG 'other'
            37:1 ldmicro-element: `SUBPROG outer` stays as a comment: a function is made of one SUBPROG and one ENDSUB after it, each alone in its rung, with no other between them
            46:1 ldmicro-element: `ENDSUB outer` stays as a comment: a function is made of one SUBPROG and one ENDSUB after it, each alone in its rung, with no other between them
            49:1 ldmicro-element: `SUBPROG beside` stays as a comment: a function is made of one SUBPROG and one ENDSUB after it, each alone in its rung, with no other between them
            49:1 ldmicro-jump: SUBPROG must be alone in its rung
            53:1 ldmicro-element: `ENDSUB beside` stays as a comment: a function is made of one SUBPROG and one ENDSUB after it, each alone in its rung, with no other between them
        "#]],
    );
    assert_eq!(there_and_back(text.as_bytes()), Ok(text));
}

#[test]
fn a_relay_in_a_subprogram_and_branches_that_go_on() {
    let rungs = [
        "SUBPROG sub",
        "CONTACTS Xa 0 0\nMASTER_RELAY",
        "ENDSUB sub",
        "PARALLEL\nCOIL Ya 0 0 0 0\nCOIL Yb 0 0 0 0\nEND\nCOIL Yc 0 0 0 0",
    ];
    check(
        &program(&rungs),
        expect![[r#"
            # ldmicro: LDmicro0.2 #
            # ldmicro: CYCLE=10000 #
            # ldmicro: CRYSTAL=4000000 #
            # ldmicro: BAUD=2400 #
            # ladder: profile ldmicro #

            VAR_INPUT
                Xa : BOOL;
            END_VAR
            VAR_OUTPUT
                Ya : BOOL;
                Yb : BOOL;
                Yc : BOOL;
            END_VAR

            # ldmicro: SUBPROG sub #

            +--\--------------------------------------------------( )( Ya )--\--( )( Yc )--+
            |  /--------------------------------------------------( )( Yb )--/             |

            +--<FUN>( sub )----------------------------------------------------------------+

            +--[ ]( Xa )------------------------------------------------------------<MCR>--+
            11:1 SUBPROG sub: approximated: what its MASTER_RELAY does ends with the function here
            22:1 PARALLEL: approximated: what is after these branches has the power that comes out of any of them here; in LDmicro's fork it has what goes in
            22:1 ldmicro-rightmost: COIL must be the rightmost element of its rung
            23:1 ldmicro-rightmost: COIL must be the rightmost element of its rung
        "#]],
    );
}

#[test]
fn only_its_own_definitions_are_elements() {
    let text = program(&["CONTACTS Xa 0 0\nTCY Ta 30000 0\nCOIL Ya 0 0 0 0"]);
    let ladder = converted(text.as_bytes()).expect("it can be read").written.text;
    assert_eq!(write(&ladder), Ok(text));
    let other = ladder.replace("[ADD]( t, t, 1 )", "[ADD]( t, t, 2 )");
    assert_ne!(other, ladder);
    let written = write(&other).expect("it can be written");
    assert!(written.contains("COMMENT +--[ ]( Xa )--"), "{written}");
}

#[test]
fn a_line_says_what_it_was_only_while_it_is() {
    let text = program(&[
        "CONTACTS Xa 0 0\nTON Ta 100000 -1\nRES Ca",
        "GOTO 1",
        "CTU Ca 5 2 /",
    ]);
    let ladder = converted(text.as_bytes()).expect("it can be read").written.text;
    assert_eq!(write(&ladder), Ok(text));
    let changed = ladder
        .replace("T#100ms", "T#200ms")
        .replace("INT := 2", "INT := 3")
        .replace("+--<JMP>", "+--[ ]( Xa )--( )( Ya )--+\n\n+--<JMP>");
    let written = write(&changed).expect("it can be written");
    let rungs = written.split("PROGRAM\n").nth(1).unwrap_or_default();
    expect![[r#"
        RUNG 1
          CONTACTS Xa 0 0
          TON Ta 190000 0
          MOVE Ca 2
        END
        RUNG 2
          GOTO 1
        END
        RUNG 3
          CTU Ca 5 3 /
        END
    "#]]
    .assert_eq(rungs);
}
