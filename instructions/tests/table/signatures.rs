//! Every signature at a glance: what the language reference and the editors show.

use std::fmt::Write;

use expect_test::expect;
use ladder_instructions::{Role, TABLE};

#[test]
fn signatures() {
    let mut text = String::new();
    for row in TABLE {
        let role = match row.role {
            Role::Condition => "condition",
            Role::Acting => "acts",
        };
        let always = if row.always_acts() { ", always" } else { "" };
        let line = format!("{:50} {role}{always}; ENO: {}", row.signature(), row.eno);
        text.push_str(line.trim_end());
        text.push('\n');
    }
    expect![[r#"
        [ ]( tag )                                         condition; ENO: EN and tag
        [/]( tag )                                         condition; ENO: EN and not tag
        [P]( tag )                                         condition, always; ENO: EN and tag rose
        [N]( tag )                                         condition, always; ENO: EN and tag fell
        [NOT]                                              condition, always; ENO: not EN
        [OSR]                                              condition, always; ENO: EN rose
        [OSF]                                              condition, always; ENO: EN fell
        [EQ]( a, b, ... )                                  condition; ENO: EN and a = b
        [NE]( a, b )                                       condition; ENO: EN and a <> b
        [GT]( a, b, ... )                                  condition; ENO: EN and a > b
        [GE]( a, b, ... )                                  condition; ENO: EN and a >= b
        [LT]( a, b, ... )                                  condition; ENO: EN and a < b
        [LE]( a, b, ... )                                  condition; ENO: EN and a <= b
        [MOV]( y, a )                                      acts; ENO: EN, low on a fault
        [TYP]( y, a )                                      acts; ENO: EN, low on a fault
        [WRAP]( y, a )                                     acts; ENO: EN, low on a fault
        [ADD]( y, a, b, ... )                              acts; ENO: EN, low on a fault
        [MUL]( y, a, b, ... )                              acts; ENO: EN, low on a fault
        [SUB]( y, a, b, ... )                              acts; ENO: EN, low on a fault
        [DIV]( y, a, b, ... )                              acts; ENO: EN, low on a fault
        [MOD]( y, a, b )                                   acts; ENO: EN, low on a fault
        [EXP]( y, a, b, ... )                              acts; ENO: EN, low on a fault
        [NOT]( y, a )                                      acts; ENO: EN, low on a fault
        [AND]( y, a, b, ... )                              acts; ENO: EN, low on a fault
        [OR]( y, a, b, ... )                               acts; ENO: EN, low on a fault
        [XOR]( y, a, b, ... )                              acts; ENO: EN, low on a fault
        [SHL]( y, a, n )                                   acts; ENO: EN, low on a fault
        [SHR]( y, a, n )                                   acts; ENO: EN, low on a fault
        [ROL]( y, a, n )                                   acts; ENO: EN, low on a fault
        [ROR]( y, a, n )                                   acts; ENO: EN, low on a fault
        [ABS]( y, a )                                      acts; ENO: EN, low on a fault
        [NEG]( y, a )                                      acts; ENO: EN, low on a fault
        [TRUNC]( y, a )                                    acts; ENO: EN, low on a fault
        [SQRT]( y, a )                                     acts; ENO: EN, low on a fault
        [LN]( y, a )                                       acts; ENO: EN, low on a fault
        [LOG]( y, a )                                      acts; ENO: EN, low on a fault
        [EXPE]( y, a )                                     acts; ENO: EN, low on a fault
        [SIN]( y, a )                                      acts; ENO: EN, low on a fault
        [COS]( y, a )                                      acts; ENO: EN, low on a fault
        [TAN]( y, a )                                      acts; ENO: EN, low on a fault
        [ASIN]( y, a )                                     acts; ENO: EN, low on a fault
        [ACOS]( y, a )                                     acts; ENO: EN, low on a fault
        [ATAN]( y, a )                                     acts; ENO: EN, low on a fault
        [RAD]( y, a )                                      acts; ENO: EN, low on a fault
        [DEG]( y, a )                                      acts; ENO: EN, low on a fault
        [MIN]( y, a, b, ... )                              acts; ENO: EN, low on a fault
        [MAX]( y, a, b, ... )                              acts; ENO: EN, low on a fault
        [LIMIT]( y, low, a, high )                         acts; ENO: EN, low on a fault
        [SEL]( y, g, a, b )                                acts; ENO: EN, low on a fault
        [MUX]( y, k, a, b, ... )                           acts; ENO: EN, low on a fault
        [CALC]( y, expression )                            acts; ENO: EN, low on a fault
        [LEN]( y, a )                                      acts; ENO: EN, low on a fault
        [LEFT]( y, a, n )                                  acts; ENO: EN, low on a fault
        [RIGHT]( y, a, n )                                 acts; ENO: EN, low on a fault
        [MID]( y, a, n, p )                                acts; ENO: EN, low on a fault
        [CONCAT]( y, a, b, ... )                           acts; ENO: EN, low on a fault
        [INSERT]( y, a, b, p )                             acts; ENO: EN, low on a fault
        [DELETE]( y, a, n, p )                             acts; ENO: EN, low on a fault
        [REPLACE]( y, a, b, n, p )                         acts; ENO: EN, low on a fault
        [FIND]( y, a, b )                                  acts; ENO: EN, low on a fault
        [BMOV]( y, a )                                     acts; ENO: EN, low on a fault
        [FILL]( y, a )                                     acts; ENO: EN, low on a fault
        [PACK]( y, a )                                     acts; ENO: EN, low on a fault
        [UNPACK]( y, a )                                   acts; ENO: EN, low on a fault
        [SHIFT]( y, d )                                    acts; ENO: EN, low on a fault
        [SEARCH]( y, op, a, t, NEXT :=, FOUND => )         acts; ENO: EN, low on a fault
        [LUT]( y, i, v0, v1, ... )                         acts; ENO: EN, low on a fault
        [PWL]( y, x, x0, y0, x1, y1, ... )                 acts; ENO: EN, low on a fault
        [TON]( t, PT, R := )                               acts, always; ENO: Q
        [TOF]( t, PT, R := )                               acts, always; ENO: Q
        [TP]( t, PT, R := )                                acts, always; ENO: Q
        [RTO]( t, PT, R := )                               acts, always; ENO: Q
        [RTOF]( t, PT, R := )                              acts, always; ENO: Q
        [CTU]( c, PV, R := )                               acts, always; ENO: Q
        [CTD]( c, PV, LD :=, R := )                        acts, always; ENO: Q
        [CTUD]( c, PV, CD :=, R :=, LD := )                acts, always; ENO: Q
        [CTC]( c, PV, R := )                               acts, always; ENO: Q
        [SR]( b, R := )                                    acts, always; ENO: Q1
        [RS]( b, R := )                                    acts, always; ENO: Q1
        ( )( tag )                                         acts, always; ENO: EN
        (/)( tag )                                         acts, always; ENO: EN
        (S)( tag )                                         acts, always; ENO: the tag
        (R)( tag )                                         acts, always; ENO: EN
        (P)( tag )                                         acts, always; ENO: EN
        (N)( tag )                                         acts, always; ENO: EN
        (M)( tag )                                         acts, always; ENO: EN
        (SM)( tag )                                        acts, always; ENO: the tag
        (RM)( tag )                                        acts, always; ENO: EN
        (RES)( tag )                                       acts, always; ENO: EN
        <LBL>( name )                                      condition; ENO: EN
        <JMP>( name )                                      acts; ENO: EN, if it does not jump
        <FUN>( name )                                      condition; ENO: EN
        <CALL>( name )                                     acts; ENO: EN
        <RET>                                              acts; ENO: EN, if it does not return
        <END>                                              acts; ENO: EN, if the program goes on
        <FOR>( n, I => )                                   acts; ENO: EN
        <NEXT>                                             acts; ENO: EN
        <MCR>                                              acts, always; ENO: EN
        [ADC]( y, channel )                                acts; ENO: EN
        [PWM]( duty, frequency, CH := )                    acts; ENO: EN
        [USND]( n )                                        acts; ENO: EN
        [URCV]( y )                                        acts; ENO: EN and a byte came
        [FMT]( text, a, ... )                              acts; ENO: EN
        [PERSIST]( tag )                                   acts; ENO: EN
        [SCANTIME]( y )                                    acts; ENO: EN
    "#]]
    .assert_eq(&text);
}

#[test]
fn spellings_next_to_the_canonical_ones() {
    let mut text = String::new();
    for row in TABLE.iter().filter(|row| row.spellings().count() > 1) {
        writeln!(
            text,
            "{}: equal {:?}, also accepted {:?}",
            row.block(),
            row.synonyms,
            row.aliases
        )
        .unwrap();
    }
    expect![[r#"
        [OSR]: equal [], also accepted ["R_TRIG"]
        [OSF]: equal [], also accepted ["F_TRIG"]
        [EQ]: equal [], also accepted ["EQU"]
        [NE]: equal [], also accepted ["NEQ"]
        [GT]: equal [], also accepted ["GRT"]
        [GE]: equal [], also accepted ["GEQ"]
        [LT]: equal [], also accepted ["LES"]
        [LE]: equal [], also accepted ["LEQ"]
        [MOV]: equal ["SET"], also accepted ["MOVE"]
        [EXP]: equal [], also accepted ["EXPT"]
    "#]]
    .assert_eq(&text);
}
