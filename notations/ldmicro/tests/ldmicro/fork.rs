//! A program with all that only LDmicro's fork has, read and written.

use crate::programs::{read, there_and_back};
use expect_test::expect;
use ladder_notation_ldmicro::resaved;

pub(crate) const EVERYTHING: &str = "\
LDmicro0.2
CYCLE=10000 us at Timer1
CRYSTAL=4000000
BAUD=2400

VAR LIST
  2 bytes n
  4 bytes big
END

IO LIST
  Xa at 2 0 0
  Xb at 3 0 0
END

PROGRAM
RUNG 1
  COMMENT The fork.
END
RUNG 2
  CONTACTS Xa 0 0
  PARALLEL
    MOD n m 7
    SHL n m 3
    SR0 n m k
    SHR n n 2
    ROL n m 4
    ROR n m 16
    AND n m 255
    OR n m 1
    XOR n n -1
    NOT n m
    NEG n m
    SET_BIT n 3
    CLEAR_BIT n 15
    BIN2BCD n m
    BCD2BIN n m
    SERIES
      IF_BIT_SET n 3
      IF_BIT_CLEAR n 0
      COIL Yt 0 0 0 1
    END
  END
END
RUNG 3
  OSL
  OSC
  COIL Yo 0 0 0 0
END
RUNG 4
  CONTACTS Xb 0 1
  TON Ta 100000 0
  TON Tb 100000 -1
  TON Tc n 0
  TOF Td 50000 2
  RTL Te 40000 0
  TCY Tf 30000 1
  THI Tg 50000 0
  TLO Th k 0
  COIL Yo 0 0 0 0
END
RUNG 5
  CTU Ca 10 0 /
  CTD Cb 0 5 \\
  CTC Cc n 1 -
  CTR Cd -3 k o
  RES Ca
  RES Cb
  RES Cd
END
RUNG 6
  CONTACTS Xa 0 0
  GOTO 11
END
RUNG 7
  COMMENT A part of its own.
END
RUNG 8
  SUBPROG #sub
END
RUNG 9
  CONTACTS Xa 0 0
  RETURN
END
RUNG 10
  ENDSUB #sub
END
RUNG 11
  COMMENT passed
END
RUNG 12
  LABEL here
  GOSUB #sub
END
RUNG 13
  CONTACTS Xb 0 0
  GOTO here
  GOTO 99
END
RUNG 14
  SWAP n m
  SET_PWM n 1000 P1 16
  READ_ADC Ain 1
  UART_SEND n 1 0
  UART_SEND n 2 0
  LOOK_UP_TABLE n m 3 0 1 2 3 tab
  FORMATTED_STRING n a\\x20\\3\\t
  RES P1
  MOVE #PORTA 5
END
";

#[test]
fn every_element() {
    expect![[r#"
        # ldmicro: LDmicro0.2 #
        # ldmicro: CYCLE=10000 us at Timer1 #
        # ldmicro: CRYSTAL=4000000 #
        # ldmicro: BAUD=2400 #
        # ldmicro: VAR LIST #
        # ldmicro: 2 bytes n #
        # ldmicro: 4 bytes big #
        # ldmicro: END #
        # ldmicro: NAME _PORTA = \x23PORTA #
        # ladder: profile ldmicro #

        VAR_INPUT
            Xa : BOOL;  # pin 2 0 0 #
            Xb : BOOL := TRUE;  # pin 3 0 0 #
        END_VAR
        VAR_OUTPUT
            Yt : BOOL;
            Yo : BOOL;
        END_VAR
        VAR
            n      : INT;
            m      : INT;
            k      : INT;
            Ta     : TON;
            Tb     : TON;
            Tc     : INT;
            Td     : TOF;
            Te     : INT;
            Tf     : INT;
            Tg     : INT;
            Th     : INT;
            Ca     : INT;
            Cb     : INT := 5;
            Cc     : INT := 1;
            Cd     : INT;
            Ain    : INT;
            _PORTA : INT;
        END_VAR

        # The fork. #
        +--[ ]( Xa )--\---------------------------------------------------------------------------------------------------------------------------[MOD]( n, m, 7 )--\--+
        |             /--\---------------------------------------------------------------------------------------------------------------------[SHL]( n, m, 3 )--\--/  |
        |                /--\---------------------------------------------------------------------------------------------------------------[SHR]( n, m, k )--\--/     |
        |                   /--\--------------------------------------------------------------------------------------------------------[$SHR]( n, n, 2 )--\--/        |
        |                      /--\---------------------------------------------------------------------------------------------------[ROL]( n, m, 4 )--\--/           |
        |                         /--\--------------------------------------------------------------------------------------------[ROR]( n, m, 16 )--\--/              |
        |                            /--\-------------------------------------------------------------------------------------[AND]( n, m, 255 )--\--/                 |
        |                               /--\----------------------------------------------------------------------------------[OR]( n, m, 1 )--\--/                    |
        |                                  /--\--------------------------------------------------------------------------[XOR]( n, n, -1 )--\--/                       |
        |                                     /--\------------------------------------------------------------------------[NOT]( n, m )--\--/                          |
        |                                        /--\------------------------------------------------------------------[NEG]( n, m )--\--/                             |
        |                                           /--\---------------------------------------------------------------(S)( n.3 )--\--/                                |
        |                                              /--\--------------------------------------------------------(R)( n.15 )--\--/                                   |
        |                                                 /--\-------------------------------------------[$BIN2BCD]( n, m )--\--/                                      |
        |                                                    /--\-------------------------------------[$BCD2BIN]( n, m )--\--/                                         |
        |                                                       /--[ ]( n.3 )--[/]( n.0 )---------------------($T)( Yt )--/                                            |

        +---------------------------------------------------[$OSL]--[$OSC]--( )( Yo )--+

        +--[ ]( Xb )--# was: CONTACTS Xb 0 1 #---[TON]( Ta, T#110ms )--[TON]( Tb, T#100ms )--# was: TON Tb 100000 -1 #--[$TON]( Tc, n )--[TOF]( Td, T#80ms )--# was: TOF Td 50000 2 #--[$RTL]( Te, 4 )--[$TCY]( Tf, 4 )--# was: TCY Tf 30000 1 #--[$THI]( Tg, 5 )--[$TLO]( Th, k )--( )( Yo )--+

        +--------[$CTU]( Ca, 10 )--[$CTDfall]( Cb, 0 )--[$CTChigh]( Cc, n, 1 )--[$CTRlowfrom]( Cd, -3, k )--[MOV]( Ca, 0 )--# was: RES Ca #--[MOV]( Cb, 5 )--# was: RES Cb #--[MOV]( Cd, k )--# was: RES Cd #--+

        +--[ ]( Xa )--------------------------------<JMP>( rung12 )--# was: GOTO 11 #--+

        # A part of its own. #

        # ldmicro: SUBPROG \x23sub #

        # passed #
        +--<LBL>( rung12 )--# was: RUNG 12 #--<LBL>( here )--------<CALL>( _sub )--# was: GOSUB \x23sub #--+

        +--[ ]( Xb )---------------------------<JMP>( here )--<RET>--# was: GOTO 99 #--+

        +--------------------[$SWAP]( n, m )--[PWM]( n, 1000, CH := 1 )--# was: SET_PWM n 1000 P1 16 #--[ADC]( Ain, 0 )--# was: READ_ADC Ain 1 #--[USND]( n )--[$UARTSEND]( 'n 2 0' )--[LUT]( n, m, 1, 2, 3 )--# was: LOOK_UP_TABLE n m 3 0 1 2 3 tab #--[FMT]( 'a \3$09', n )--# was: FORMATTED_STRING n a\x20\3\t #--[$RES]( 'P1' )--[MOV]( _PORTA, 5 )--+

        +--<FUN>( _sub )---------------------------------------------------------------+

        +--[ ]( Xa )------------------------------------------------------------<RET>--+

        FUNCTION_BLOCK ($T)
        # Each time power comes, the tag changes over. #
        VAR_IN_OUT
            q : BOOL;
        END_VAR
        +--[ ]( EN )--[OSR]---------------------------------------[XOR]( q, q, TRUE )--+
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$OSL]
        # When power goes, its own stays away for one scan. #
        VAR
            low, seen : BOOL;
        END_VAR
        +--[ ]( low )--[/]( EN )-------------------------------------------(S)( ENO )--+
        +--[/]( EN )--[ ]( seen )------------------------------------------( )( low )--+
        +--[ ]( EN )----------------------------------------------[MOV]( seen, TRUE )--+
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$OSC]
        # While power is there, its own comes and goes with each scan. #
        VAR
            on : BOOL;
        END_VAR
        +--[ ]( EN )--[/]( on )---------------------------------( )( on )--( )( ENO )--+
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$SHR]
        # Shifts to the right; the sign stays. #
        VAR_IN_OUT
            y : INT;
        END_VAR
        VAR_INPUT
            a, n : INT;
        END_VAR
        +--[ ]( EN )--[GE]( a, 0 )-----------------------------------[SHR]( y, a, n )--+
        +--[ ]( EN )--[LT]( a, 0 )-----[NOT]( y, a )--[SHR]( y, y, n )--[NOT]( y, y )--+
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$BIN2BCD]
        # The last two digits of a number, a byte each. #
        VAR_IN_OUT
            y : INT;
        END_VAR
        VAR_INPUT
            a : INT;
        END_VAR
        +--[ ]( EN )----------------------[CALC]( y, a MOD 10 + a / 10 MOD 10 * 256 )--+
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$BCD2BIN]
        # The number whose two digits are given, a byte each. #
        VAR_IN_OUT
            y : INT;
        END_VAR
        VAR_INPUT
            a : INT;
        END_VAR
        +--[ ]( EN )------------------[CALC]( y, (a AND 15) + (a SHR 8 AND 15) * 10 )--+
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$SWAP]
        # The low byte of a number and its high one change places. #
        VAR_IN_OUT
            y : INT;
        END_VAR
        VAR_INPUT
            a : INT;
        END_VAR
        +--[ ]( EN )-------------------------------------------------[ROL]( y, a, 8 )--+
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$TON]
        # Power comes once it has been there for p scans. #
        VAR_IN_OUT
            t : INT;
        END_VAR
        VAR_INPUT
            p : INT;
        END_VAR
        +--[ ]( EN )--[GE]( t, p )-----------------------------------------( )( ENO )--+
        +--[ ]( EN )--[/]( ENO )-------------------------------------[ADD]( t, t, 1 )--+
        +--[/]( EN )----------------------------------------------------[MOV]( t, 0 )--+
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$RTL]
        # Counts scans without power; its own comes after p of them, and stays. #
        VAR_IN_OUT
            t : INT;
        END_VAR
        VAR_INPUT
            p : INT;
        END_VAR
        +--[GE]( t, p )----------------------------------------------------( )( ENO )--+
        +--[/]( EN )--[LT]( t, p )-----------------------------------[ADD]( t, t, 1 )--+
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$TCY]
        # While power is there, its own changes over every p + 1 scans. #
        VAR_IN_OUT
            t : INT;
        END_VAR
        VAR_INPUT
            p : INT;
        END_VAR
        VAR
            on, over : BOOL;
        END_VAR
        +--[ ]( EN )--[GE]( t, p )----------------------------------------( )( over )--+
        +--[/]( EN )----------------------------------------------------[MOV]( t, 0 )--+
        +--[ ]( over )---------------------------[MOV]( t, 0 )--[XOR]( on, on, TRUE )--+
        +--[ ]( EN )--[/]( over )------------------------------------[ADD]( t, t, 1 )--+
        +--[ ]( EN )--[ ]( on )--------------------------------------------( )( ENO )--+
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$THI]
        # When power comes, its own is there for p scans. #
        VAR_IN_OUT
            t : INT;
        END_VAR
        VAR_INPUT
            p : INT;
        END_VAR
        VAR
            run : BOOL;
        END_VAR
        +--[ ]( EN )-------------------------------------------------------(S)( run )--+
        +--[ ]( run )--[LT]( t, p )----------------------( )( ENO )--[ADD]( t, t, 1 )--+
        +--[ ]( run )--[/]( ENO )--[/]( EN )----------------[MOV]( t, 0 )--(R)( run )--+
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$TLO]
        # When power goes, its own is away for p scans. #
        VAR_IN_OUT
            t : INT;
        END_VAR
        VAR_INPUT
            p : INT;
        END_VAR
        VAR
            seen, run, low : BOOL;
        END_VAR
        +--[/]( EN )--[ ]( seen )------------------------------------------(S)( run )--+
        +--[ ]( EN )----------------------------------------------[MOV]( seen, TRUE )--+
        +--[ ]( run )--[LT]( t, p )----------------------( )( low )--[ADD]( t, t, 1 )--+
        +--[ ]( seen )--[/]( low )-----------------------------------------( )( ENO )--+
        +--[ ]( run )--[/]( low )--[ ]( EN )----------------[MOV]( t, 0 )--(R)( run )--+
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$CTU]
        # Counts up to max; there is power from then on. #
        VAR_IN_OUT
            c : INT;
        END_VAR
        VAR_INPUT
            max : INT;
        END_VAR
        +--[ ]( EN )--[OSR]--[LT]( c, max )--------------------------[ADD]( c, c, 1 )--+
        +--[GE]( c, max )--------------------------------------------------( )( ENO )--+
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$CTDfall]
        # Counts down to max; there is power until then. #
        VAR_IN_OUT
            c : INT;
        END_VAR
        VAR_INPUT
            max : INT;
        END_VAR
        +--[ ]( EN )--[OSF]--[GT]( c, max )--------------------------[SUB]( c, c, 1 )--+
        +--[GT]( c, max )--------------------------------------------------( )( ENO )--+
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$CTChigh]
        # Counts up; beyond max it begins again at init, with power for one scan. #
        VAR_IN_OUT
            c : INT;
        END_VAR
        VAR_INPUT
            max, init : INT;
        END_VAR
        +--[ ]( EN )--[ADD]( c, c, 1 )--[GT]( c, max )---( )( ENO )--[MOV]( c, init )--+
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$CTRlowfrom]
        # Counts down; below max it begins again at init, with power for one scan. #
        VAR_IN_OUT
            c : INT;
        END_VAR
        VAR_INPUT
            max, init : INT;
        END_VAR
        VAR
            begun : BOOL;
        END_VAR
        +--[/]( begun )------------------------[MOV]( c, init )--[MOV]( begun, TRUE )--+
        +--[/]( EN )--[SUB]( c, c, 1 )--[LT]( c, max )---( )( ENO )--[MOV]( c, init )--+
        END_FUNCTION_BLOCK

        # UART_SEND: it is not run here, and no power comes out of it: it is about several bytes, or waits for the line #
        FUNCTION_BLOCK [$UARTSEND]
        VAR_INPUT
            operands : STRING[254] := '';
        END_VAR
        # ladder: unread, writes n #
        +------------------------------------------------------------------(R)( ENO )--+
        END_FUNCTION_BLOCK

        # RES: it is not run here, and power passes: no block here ends pulses #
        FUNCTION_BLOCK [$RES]
        VAR_INPUT
            operands : STRING[254] := '';
        END_VAR
        # ladder: unread, writes #
        END_FUNCTION_BLOCK
        1:1 #PORTA: approximated: it is spelled `_PORTA` here
        1:1 big: approximated: it has 4 bytes in LDmicro, and 16 bits here
        25:1 SR0 n m k: approximated: where the number of bits is below 0, there is a fault here
        26:1 SHR n n 2: approximated: that the sign of a number below 0 stays is what SR0 next to it suggests
        36:1 BIN2BCD n m: approximated: its digits are a byte each in LDmicro, and 16 bits hold two of them
        37:1 BCD2BIN n m: approximated: its digits are a byte each in LDmicro, and 16 bits hold two of them
        102:1 SET_PWM n 1000 P1 16: approximated: its duty is not in percent in LDmicro; here it is
        105:1 UART_SEND n 2 0: approximated: it is not run here, and no power comes out of it: it is about several bytes, or waits for the line
        107:1 FORMATTED_STRING n a\x20\3\t: approximated: here it is also sent once at the start; the fork waits until power comes
        108:1 RES P1: approximated: it is not run here, and power passes: no block here ends pulses
        109:1 MOVE #PORTA 5: approximated: #PORTA is a register of the controller; here it is a tag
        65:1 ldmicro-rightmost: CTC must be the rightmost element of its rung
        67:1 ldmicro-rightmost: RES must be the rightmost element of its rung
        68:1 ldmicro-rightmost: RES must be the rightmost element of its rung
        102:1 ldmicro-rightmost: SET_PWM must be the rightmost element of its rung
        103:1 ldmicro-rightmost: READ_ADC must be the rightmost element of its rung
        106:1 ldmicro-rightmost: LOOK_UP_TABLE must be the rightmost element of its rung
        106:1 ldmicro-unassigned: Variable 'm' not assigned to, e.g. with a MOV statement, an ADD statement, etc. This is probably a programming error; now it will always be zero.
        108:1 ldmicro-rightmost: RES must be the rightmost element of its rung
    "#]].assert_eq(&read(EVERYTHING));
}

#[test]
fn every_element_comes_back() {
    assert_eq!(
        resaved(EVERYTHING.as_bytes()).as_deref(),
        Ok(EVERYTHING.as_bytes())
    );
    assert_eq!(there_and_back(EVERYTHING.as_bytes()).as_deref(), Ok(EVERYTHING));
    // Version 0.1 with the fork's elements.
    let older = EVERYTHING.replace("LDmicro0.2", "LDmicro0.1");
    let older = resaved(older.as_bytes()).expect("it can be read");
    let older = String::from_utf8(older).expect("it is text");
    assert_eq!(there_and_back(older.as_bytes()), Ok(older));
}
