//! Hovers, with `$0` where the pointer is.

use super::hover;
use expect_test::{Expect, expect};
use ladder_syntax::TextSize;
use std::sync::Arc;

fn check(fixture: &str, expected: Expect) {
    let at = fixture.find("$0").expect("a fixture has its $0");
    let text = fixture.replacen("$0", "", 1);
    let parse = Arc::new(ladder_syntax::parse(&text));
    let analysis = ladder_analysis::analyze(&parse, "test.clad");
    let shown = match hover(&analysis.context, TextSize::new(at as u32)) {
        Some(hover) => format!("{}\n\n{}\n", &text[hover.range], hover.markdown),
        None => "nothing\n".to_owned(),
    };
    expected.assert_eq(&shown);
}

#[test]
fn instruction_card() {
    check(
        "+--[ ]( a )--[T$0ON]( t, 5s )--( )( y )--+\n",
        expect![[r#"
            [TON]( t, 5s )

            ```clad
            [TON]( t, PT, R := )
            ```
            **On-delay timer**

            Q goes high once EN has been high for the time PT.

            ```text
            PT = 3 columns
            EN   _-------___--___
            Q    ____----________
            ET   0012333300001000
            ```

            - The scan in which EN rises starts the time at 0; Q goes high in the first scan that is PT or more later.
              When EN falls, Q and ET fall at once.
            - While R is high ET is 0 and Q low. If R ends under a high EN, the time starts again in that scan.
            - PT is read at every evaluation, so it may be a tag. Lengthening it does not take back a Q that is already
              high. With PT of 0 or less Q follows EN.
            - ET is the time run so far, at most PT. ENO is Q; other rungs read `t.Q` and `t.ET`.
            - Where the block is jumped over, the time runs on and is brought up to date when the block is next reached.

            Each timer tag belongs to one block. IEC 61131-3: TON.

            - `t`, read and written: The timer's tag, of type TON.
            - `PT`: The preset time; a plain integer is milliseconds.
            - `R`, optional: The reset, while it is high.

            Power out (ENO): Q

            ```clad
            VAR_INPUT
                run : BOOL;
            END_VAR
            VAR
                warmup : TON;
            END_VAR
            VAR_OUTPUT
                ready : BOOL;
            END_VAR

            +--[ ]( run )-----------------------------[TON]( warmup, T#5s )--( )( ready )--+
            ```
        "#]],
    );
}

#[test]
fn tag_with_uses() {
    check(
        "VAR_INPUT start : BOOL; END_VAR\n+--[ ]( st$0art )--( )( run )--+\n+--[/]( start )--( )( idle )--+\n",
        expect![[r#"
            start

            ```clad
            start : BOOL
            ```
            Input (declared in VAR_INPUT on line [1](#L1))  
            Written: nowhere  
            Read: lines [2](#L2), [3](#L3)

            ```clad
            +--[/]( start )--( )( idle )--+
            ```

            ---

            `tag` of `[ ]`: The bit that is asked; of a range, every bit.
        "#]],
    );
    check(
        "+--[ ]( a )--[TON]( t, 5$0s )--( )( t.Q )--+\n",
        expect![[r#"
            5s

            TIME literal, 5000 ms

            ---

            `PT` of `[TON]`: The preset time; a plain integer is milliseconds.
        "#]],
    );
    check(
        "+--[ ]( t.Q$0 )--( )( y )--+\n+--[ ]( a )--[TON]( t, 5s )--+\n",
        expect![[r#"
            t.Q

            Member `Q` of

            ```clad
            t : TON
            ```
            Internal tag (not declared; its type follows from its use)  
            Written: line [2](#L2)  
            Read: lines [1](#L1), [2](#L2)

            ```clad
            +--[ ]( a )--[TON]( t, 5s )--+
            ```

            ---

            `tag` of `[ ]`: The bit that is asked; of a range, every bit.
        "#]],
    );
    check(
        "+--[ ]( SYS.FIRST$0_SCAN )--( )( y )--+\n",
        expect![[r#"
            SYS.FIRST_SCAN

            ```clad
            SYS.FIRST_SCAN
            ```
            BOOL. High in the first scan.

            ---

            `tag` of `[ ]`: The bit that is asked; of a range, every bit.
        "#]],
    );
    check(
        "+--[ ]( a )--<JMP>( do$0ne )--+\n+--<LBL>( done )--+\n",
        expect![[r#"
            done

            ```clad
            <LBL>( done )
            ```
            Label on line [2](#L2)

            ---

            `name` of `<JMP>`: The label to go on at.
        "#]],
    );
}

#[test]
fn connectors() {
    let seal = "+--\\--[ ]( a )--$0\\--( )( y )--+\n|  /--[ ]( y )--/\n";
    check(
        seal,
        expect![[r#"
            \

            Connector: the 2nd `\` of this line is joined with the 2nd `/` of line [2](#L2) below.

            Both wires after the pair carry power if one of the wires before it does.

            Power: `a OR y`
        "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( y )--$0/\n",
        expect![[r#"
            /

            Connector: the 2nd `/` of this line is joined with the 2nd `\` of line [1](#L1) above.

            Both wires after the pair carry power if one of the wires before it does.

            Power: `a OR y`
        "#]],
    );
    check(
        "+--\\--[ ]( a )--\\$0--( )( y )--+\n|  /--[ ]( y )--\n",
        expect![[r#"
        \

        Connector without a partner: this is the 2nd `\` of its line, and the rung below has fewer `/`.
    "#]],
    );
}

#[test]
fn keywords_and_declarations() {
    check(
        "VAR RET$0AIN\n    a : INT;\nEND_VAR\n",
        expect![[r#"
        RETAIN

        ```clad
        RETAIN
        ```
        The tags of this section keep their values over a warm restart.
    "#]],
    );
    check(
        "VAR\n    a : IN$0T;\nEND_VAR\n",
        expect![[r#"
        INT

        ```clad
        INT
        ```
        An integer of 16 bits: -32768 to 32767.
    "#]],
    );
    check(
        "VAR\n    $0a AT %MW1 : INT;\nEND_VAR\n",
        expect![[r#"
            a

            ```clad
            a AT %MW1 : INT
            ```
            Internal tag (declared in VAR on line [2](#L2))  
            Written: nowhere  
            Read: nowhere
        "#]],
    );
}

#[test]
fn block_of_the_library() {
    check(
        "+--[ ]( a )--[$to$0ggle]( )--( )( y )--+\n",
        expect![[r#"
        [$toggle]( )

        ```clad
        [$Toggle]( reset, q )
        ```
        **Block** of the library

        A switch made of a push button: each time EN goes high, `q` changes. It begins low; EN that is high in the very first run
        counts as pressed. While `reset` is high `q` is low. The power that leaves the block is `q`.

        - `reset`: BOOL, input, may be left out: switches off
        - `q`: BOOL, output: switched on

        ```clad
        VAR_INPUT
            button : BOOL;
            off    : BOOL;  # all lamps off #
        END_VAR
        VAR_OUTPUT
            lamp : BOOL;
        END_VAR
        +--[ ]( button )--------------------------------[$Toggle]( off )--( )( lamp )--+
        ```

        A column is 10ms:

        ```text
        button    __--___-__---_-
        off       _______________
        lamp   => __-----___----_
        ```
    "#]],
    );
}

#[test]
fn user_block() {
    check(
        "FUNCTION_BLOCK [$Hold]\nVAR_INPUT raw : BOOL; wait : TIME := T#1s; END_VAR\nVAR_OUTPUT clean : BOOL; END_VAR\n\
         +--[ ]( raw )--( )( clean )--+\nEND_FUNCTION_BLOCK\n+--[$H$0old]( a, 2s, b )--+\n",
        expect![[r#"
            [$Hold]( a, 2s, b )

            ```clad
            [$Hold]( raw, wait, clean )
            ```
            **User-defined block**

            - `raw`: BOOL, input
            - `wait`: TIME, input, may be left out
            - `clean`: BOOL, output
        "#]],
    );
}

#[test]
fn nothing_there() {
    check(
        "+-$0-[ ]( a )--( )( y )--+\n",
        expect![[r#"
            --

            Power: always

            ```text
            y := a
            ```
        "#]],
    );
    check(
        "$0\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[FOO]( $0a )--+\n",
        expect![[r#"
            a

            ```clad
            a : DINT
            ```
            Internal tag (not declared; its type follows from its use)  
            Written: line [1](#L1)  
            Read: line [1](#L1)
        "#]],
    );
}

#[test]
fn names_of_other_files() {
    use ladder_analysis::{AnalyzeOptions, Exported, analyze, exports};
    let library = "VAR_GLOBAL total : DINT; END_VAR\n+--<FUN>( count )--[ADD]( total, total, 1 )--+\n\
                   FUNCTION_BLOCK [$Hold]\nVAR_INPUT raw : BOOL; END_VAR\n+--[ ]( raw )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n";
    let text = "+--<CALL>( count )--[$Hold]( x )--[GT]( total, 3 )--( )( y )--+\n";
    let parse = |text| std::sync::Arc::new(ladder_syntax::parse(text));
    let exported = Exported::new(vec![std::sync::Arc::new(exports(
        &parse(library),
        "library.clad",
    ))]);
    let others = std::sync::Arc::new(exported).others_of("main.clad");
    let analysis = analyze(&parse(text), AnalyzeOptions::new("main.clad").among(&others));
    let shown: Vec<String> = ["count", "$Hold", "x )", "total"]
        .iter()
        .map(|word| {
            super::hover(&analysis.context, (text.find(word).unwrap() as u32).into())
                .unwrap()
                .markdown
        })
        .collect();
    expect_test::expect![[r#"
        ```clad
        <FUN>( count )
        ```
        Function in `library.clad`

        ---

        `name` of `<CALL>`: The function that is run.
        ====
        ```clad
        [$Hold]( raw )
        ```
        **User-defined block** in `library.clad`

        - `raw`: BOOL, input
        ====
        ```clad
        x : BOOL
        ```
        Input (not declared; its type follows from its use)  
        Written: nowhere  
        Read: line [1](#L1)

        ---

        `raw` of `[$Hold]`
        ====
        ```clad
        total : DINT
        ```
        Internal tag (declared in VAR_GLOBAL in `library.clad`)  
        Written in this file: nowhere  
        Read in this file: line [1](#L1)

        ---

        `a` of `[GT]`: The left side."#]]
    .assert_eq(&shown.join("\n====\n"));
}

#[test]
fn a_card_tells_how_the_profile_differs() {
    let card = |profile: &str, block: &str| {
        let text = format!("# ladder: profile {profile} #\n+--{block}--( )( y )--+\n");
        let at = TextSize::new(text.find(block).expect("it is there") as u32 + 1);
        let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(&text)), "test.clad");
        let markdown = hover(&analysis.context, at).expect("there is a card").markdown;
        let lines = markdown
            .lines()
            .filter(|line| line.starts_with("[T") || line.contains("In profile"));
        lines.fold(String::new(), |all, line| all + line + "\n")
    };
    expect![[r#"
        [TOF]( t, PT )
        **In profile `ldmicro`:** ET counts scans and is an integer: with PT of n scan intervals Q is low from the n-th scan in a row without power. It begins as if its time were over. PT is 2 scan intervals at least; a part of one is cut off. Other instructions may write ET, and several blocks use one tag.
    "#]].assert_eq(&card("ldmicro", "[TOF]( t, 5s )"));
    expect![[r#"
        [TOF]( t, PT, B := )
        **In profile `iot`:** No off-delay: the power after it is EN until the time is over, and then low. It counts as TON does; Q is that the time is over.
    "#]].assert_eq(&card("iot", "[TOF]( t, 5 )"));
    expect![[r#"
        **In profile `iot`:** The system has no such instruction.
    "#]]
    .assert_eq(&card("iot", "[SIN]( x, y )"));
    expect![[r#"
        [TOF]( t, PT, R := )
    "#]]
    .assert_eq(&card("iec", "[TOF]( t, 5s )"));
}

const TYPES: &str = "TYPE\n    Phase : (IDLE, FILLING, MIXING := 10);\n    Motor : STRUCT\n        speed   : REAL;\n        running : BOOL;\n        delay   : TON;\n    END_STRUCT;\nEND_TYPE\n\nVAR\n    pump  : Motor := (speed := 20.0);\n    lines : ARRAY[1..4] OF Motor;\n    step  : Phase := FILLING;\n    k     : INT;\nEND_VAR\n\n";

#[test]
fn types_members_and_values() {
    let check = |rest: &str, expected: Expect| check(&format!("{TYPES}{rest}"), expected);
    check(
        "+--[ ]( pump.runn$0ing )--( )( Q1 )--+\n",
        expect![[r#"
        running

        ```clad
        Motor.running : BOOL
        ```

        ---

        ```clad
        Motor : STRUCT
            speed : REAL;
            running : BOOL;
            delay : TON;
        END_STRUCT
        ```
        Type, declared in this file; 2 values
    "#]],
    );
    check(
        "+--[EQ]( step, FILL$0ING )--( )( Q1 )--+\n",
        expect![[r#"
        FILLING

        ```clad
        Phase.FILLING = 1
        ```

        ---

        ```clad
        Phase : (IDLE := 0, FILLING := 1, MIXING := 10)
        ```
        Type, declared in this file
    "#]],
    );
    check(
        "+--[ ]( lines[k].delay.$0Q )--( )( Q1 )--+\n",
        expect![[r#"
        lines[k].delay.Q

        ```clad
        .Q : BOOL
        ```

        ---

        `tag` of `[ ]`: The bit that is asked; of a range, every bit.
    "#]],
    );
    check(
        "+--[ ]( li$0nes[k].delay.Q )--( )( Q1 )--+\n",
        expect![[r#"
        lines

        ```clad
        lines : ARRAY[1..4] OF Motor
        ```
        Internal tag (declared in VAR on line [12](#L12))  
        Written: nowhere  
        Read: line [17](#L17)

        ---

        `tag` of `[ ]`: The bit that is asked; of a range, every bit.
    "#]],
    );
}
