//! Every literal form, operator and name as tokens, in an operand list; and what a `#` belongs to.

use crate::show::check_tokens;
use expect_test::expect;
use ladder_syntax::{NodeOrToken, SyntaxKind, parse};
use std::fmt::Write as _;

/// The tokens between the parentheses of `[MOV]( .. )`.
#[track_caller]
fn check_operands(operands: &[&str], expect: expect_test::Expect) {
    let mut out = String::new();
    for operand in operands {
        let text = format!("[MOV]({operand})");
        let parse = parse(&text);
        let list = parse
            .syntax()
            .descendants()
            .find(|n| n.kind() == SyntaxKind::OPERAND_LIST)
            .expect("an operand list");
        let _ = write!(out, "{operand}  =>");
        for token in list.descendants_with_tokens().filter_map(NodeOrToken::into_token) {
            if !matches!(
                token.kind(),
                SyntaxKind::L_PAREN | SyntaxKind::R_PAREN | SyntaxKind::WHITESPACE
            ) {
                let _ = write!(out, "  {:?} {}", token.kind(), token.text());
            }
        }
        for error in parse.errors() {
            let _ = write!(out, "  !{:?}", error.kind);
        }
        out.push('\n');
    }
    expect.assert_eq(&out);
}

/// A `#` directly after a tag opens a comment; directly after a number or the word of a type it belongs to a literal.
#[test]
fn comments_directly_after_something() {
    check_operands(
        &[
            "a# note #",
            "a#note#",
            "v1# note #",
            "%IX0.3# note #",
            "word.3# note #",
            "t1.INT# note #",
            "t1. INT# note #",
            "a[1..16#0F]",
            "# c #16#0F",
            "5s# note #",
            "5# note #",
            "2.5# note #",
            "T#5s# note #",
            "16#FF# note #",
            "16#5# note #",
            "INT#5# note #",
            "WORD#16#FF# note #",
            "WORD#16# note #",
            "INT#2# note #",
            "D#2026-11-21# note #",
            "TOD#13:45:00# note #",
            "TRUE# note #",
            "a - 16#FF",
            "Phase#IDLE#",
            "a[3# note #]",
            "'x'# note #",
        ],
        expect![[r#"
            a# note #  =>  IDENT a  COMMENT # note #
            a#note#  =>  IDENT a  COMMENT #note#
            v1# note #  =>  IDENT v1  COMMENT # note #
            %IX0.3# note #  =>  ADDRESS %IX0.3  COMMENT # note #
            word.3# note #  =>  IDENT word  DOT .  LITERAL 3  COMMENT # note #
            t1.INT# note #  =>  IDENT t1  DOT .  IDENT INT  COMMENT # note #
            t1. INT# note #  =>  IDENT t1  DOT .  IDENT INT  COMMENT # note #
            a[1..16#0F]  =>  IDENT a  L_BRACKET [  LITERAL 1  DOT_DOT ..  LITERAL 16#0F  R_BRACKET ]
            # c #16#0F  =>  COMMENT # c #  LITERAL 16#0F
            5s# note #  =>  LITERAL 5s  COMMENT # note #
            5# note #  =>  LITERAL 5#  IDENT note  !MissingComma  !UnclosedComment
            2.5# note #  =>  LITERAL 2.5  COMMENT # note #
            T#5s# note #  =>  LITERAL T#5s  COMMENT # note #
            16#FF# note #  =>  LITERAL 16#FF  COMMENT # note #
            16#5# note #  =>  LITERAL 16#5  COMMENT # note #
            INT#5# note #  =>  LITERAL INT#5  COMMENT # note #
            WORD#16#FF# note #  =>  LITERAL WORD#16#FF  COMMENT # note #
            WORD#16# note #  =>  LITERAL WORD#16  COMMENT # note #
            INT#2# note #  =>  LITERAL INT#2  COMMENT # note #
            D#2026-11-21# note #  =>  LITERAL D#2026-11-21  COMMENT # note #
            TOD#13:45:00# note #  =>  LITERAL TOD#13:45:00  COMMENT # note #
            TRUE# note #  =>  LITERAL TRUE  COMMENT # note #
            a - 16#FF  =>  IDENT a  MINUS -  LITERAL 16#FF
            Phase#IDLE#  =>  IDENT Phase  COMMENT #IDLE#
            a[3# note #]  =>  IDENT a  L_BRACKET [  LITERAL 3#  IDENT note  !UnclosedBlock { closing: R_BRACKET }  !MissingComma  !UnclosedComment
            'x'# note #  =>  STRING 'x'  COMMENT # note #
        "#]],
    );
}

#[test]
fn literals() {
    check_operands(
        &[
            "TRUE",
            "false",
            "42",
            "-7",
            "1_000",
            "16#FF",
            "8#17",
            "2#1010_0101",
            "3.14",
            "-1.0e-3",
            "1e5",
            "2.5E+7",
            "16#1E-3",
            "T#5s",
            "T#1h30m",
            "TIME#-250ms",
            "T#1.5s",
            "T#2d_4h",
            "t#5S",
            "5s",
            "1h30m",
            "250ms",
            "-1.5s",
            "D#2026-11-21",
            "DATE#2026-11-21",
            "TOD#13:45:00.5",
            "TIME_OF_DAY#1:2:3",
            "DT#2026-11-21-13:45:00",
            "DATE_AND_TIME#2026-11-21-13:45:00",
            "'text'",
            "''",
            "'it$'s $$5 $L$N$R$T$P$41'",
            "'a # b'",
            "'$$'",
            "INT#5",
            "INT#-5",
            "WORD#16#00FF",
            "REAL#1",
            "REAL#-1.5e-3",
            "BOOL#1",
            "BOOL#TRUE",
        ],
        expect![[r#"
            TRUE  =>  LITERAL TRUE
            false  =>  LITERAL false
            42  =>  LITERAL 42
            -7  =>  MINUS -  LITERAL 7
            1_000  =>  LITERAL 1_000
            16#FF  =>  LITERAL 16#FF
            8#17  =>  LITERAL 8#17
            2#1010_0101  =>  LITERAL 2#1010_0101
            3.14  =>  LITERAL 3.14
            -1.0e-3  =>  MINUS -  LITERAL 1.0e-3
            1e5  =>  LITERAL 1e5
            2.5E+7  =>  LITERAL 2.5E+7
            16#1E-3  =>  LITERAL 16#1E  MINUS -  LITERAL 3
            T#5s  =>  LITERAL T#5s
            T#1h30m  =>  LITERAL T#1h30m
            TIME#-250ms  =>  LITERAL TIME#-250ms
            T#1.5s  =>  LITERAL T#1.5s
            T#2d_4h  =>  LITERAL T#2d_4h
            t#5S  =>  LITERAL t#5S
            5s  =>  LITERAL 5s
            1h30m  =>  LITERAL 1h30m
            250ms  =>  LITERAL 250ms
            -1.5s  =>  MINUS -  LITERAL 1.5s
            D#2026-11-21  =>  LITERAL D#2026-11-21
            DATE#2026-11-21  =>  LITERAL DATE#2026-11-21
            TOD#13:45:00.5  =>  LITERAL TOD#13:45:00.5
            TIME_OF_DAY#1:2:3  =>  LITERAL TIME_OF_DAY#1:2:3
            DT#2026-11-21-13:45:00  =>  LITERAL DT#2026-11-21-13:45:00
            DATE_AND_TIME#2026-11-21-13:45:00  =>  LITERAL DATE_AND_TIME#2026-11-21-13:45:00
            'text'  =>  STRING 'text'
            ''  =>  STRING ''
            'it$'s $$5 $L$N$R$T$P$41'  =>  STRING 'it$'s $$5 $L$N$R$T$P$41'
            'a # b'  =>  STRING 'a # b'
            '$$'  =>  STRING '$$'
            INT#5  =>  LITERAL INT#5
            INT#-5  =>  LITERAL INT#-5
            WORD#16#00FF  =>  LITERAL WORD#16#00FF
            REAL#1  =>  LITERAL REAL#1
            REAL#-1.5e-3  =>  LITERAL REAL#-1.5e-3
            BOOL#1  =>  LITERAL BOOL#1
            BOOL#TRUE  =>  LITERAL BOOL#TRUE
        "#]],
    );
}

#[test]
fn near_literals() {
    check_operands(
        &[
            "5abc",
            "1.2.3",
            "1..9",
            "3.",
            ".5",
            "16#",
            "16#GG",
            "T#",
            "D#2026-11",
            "1e",
            "1e-",
            "5-3",
            "5 -3",
            "a-3",
            "1e5-3",
            "T#5s-3",
            "2#1-1",
            "'open",
            "'open$'",
            "5.a",
        ],
        expect![[r#"
            5abc  =>  LITERAL 5abc
            1.2.3  =>  LITERAL 1.2.3
            1..9  =>  LITERAL 1  ERROR ..  LITERAL 9  !UnexpectedCharacter { place: Operands, after_comment: false }
            3.  =>  LITERAL 3  DOT .  !MissingOperand { place: Member }
            .5  =>  ERROR .  LITERAL 5  !UnexpectedCharacter { place: Operands, after_comment: false }
            16#  =>  LITERAL 16#
            16#GG  =>  LITERAL 16#GG
            T#  =>  LITERAL T#
            D#2026-11  =>  LITERAL D#2026-11
            1e  =>  LITERAL 1e
            1e-  =>  LITERAL 1e  MINUS -  !MissingOperand { place: Operator }
            5-3  =>  LITERAL 5  MINUS -  LITERAL 3
            5 -3  =>  LITERAL 5  MINUS -  LITERAL 3
            a-3  =>  IDENT a  MINUS -  LITERAL 3
            1e5-3  =>  LITERAL 1e5  MINUS -  LITERAL 3
            T#5s-3  =>  LITERAL T#5s  MINUS -  LITERAL 3
            2#1-1  =>  LITERAL 2#1  MINUS -  LITERAL 1
            'open  =>  STRING 'open  !UnclosedString
            'open$'  =>  STRING 'open$'  !UnclosedString
            5.a  =>  LITERAL 5  DOT .  IDENT a
        "#]],
    );
}

#[test]
fn names_and_addresses() {
    check_operands(
        &[
            "a",
            "_a1",
            "Öl",
            "温度",
            "a.b",
            "t1.Q",
            "word.3",
            "a[3]",
            "a[i].Q",
            "a[3..9]",
            "%IX0.3",
            "%qw12",
            "%M",
            "%",
            "%IX0.",
            "SYS.FIRST_SCAN",
            "$B",
            "x\u{301}y",
            "²",
            "٣",
        ],
        expect![[r#"
            a  =>  IDENT a
            _a1  =>  IDENT _a1
            Öl  =>  IDENT Öl
            温度  =>  IDENT 温度
            a.b  =>  IDENT a  DOT .  IDENT b
            t1.Q  =>  IDENT t1  DOT .  IDENT Q
            word.3  =>  IDENT word  DOT .  LITERAL 3
            a[3]  =>  IDENT a  L_BRACKET [  LITERAL 3  R_BRACKET ]
            a[i].Q  =>  IDENT a  L_BRACKET [  IDENT i  R_BRACKET ]  DOT .  IDENT Q
            a[3..9]  =>  IDENT a  L_BRACKET [  LITERAL 3  DOT_DOT ..  LITERAL 9  R_BRACKET ]
            %IX0.3  =>  ADDRESS %IX0.3
            %qw12  =>  ADDRESS %qw12
            %M  =>  ADDRESS %M
            %  =>  ERROR %  !UnexpectedCharacter { place: Operands, after_comment: false }
            %IX0.  =>  ADDRESS %IX0  DOT .  !MissingOperand { place: Member }
            SYS.FIRST_SCAN  =>  IDENT SYS  DOT .  IDENT FIRST_SCAN
            $B  =>  ERROR $  IDENT B  !UnexpectedCharacter { place: Operands, after_comment: false }
            x́y  =>  IDENT x́y
            ²  =>  ERROR ²  !UnexpectedCharacter { place: Operands, after_comment: false }
            ٣  =>  ERROR ٣  !UnexpectedCharacter { place: Operands, after_comment: false }
        "#]],
    );
}

#[test]
fn operators() {
    check_operands(
        &[
            "a := b",
            "a => b",
            "a+b-c*d/e^f",
            "a<b<=c>d>=e=f<>g",
            "a AND b or c Xor d",
            "NOT a",
            "a MOD b SHL c SHR d",
            "a : b ; c",
            "ANDY, notes, ORB",
            "a=>b",
            "a:=-1",
            "a>=-1",
            "a<-1",
        ],
        expect![[r#"
            a := b  =>  IDENT a  ASSIGN :=  IDENT b
            a => b  =>  IDENT a  ARROW =>  IDENT b
            a+b-c*d/e^f  =>  IDENT a  PLUS +  IDENT b  MINUS -  IDENT c  STAR *  IDENT d  SLASH /  IDENT e  CARET ^  IDENT f
            a<b<=c>d>=e=f<>g  =>  IDENT a  LESS <  IDENT b  LESS_EQUAL <=  IDENT c  GREATER >  IDENT d  GREATER_EQUAL >=  IDENT e  EQUAL =  IDENT f  NOT_EQUAL <>  IDENT g
            a AND b or c Xor d  =>  IDENT a  WORD_OPERATOR AND  IDENT b  WORD_OPERATOR or  IDENT c  WORD_OPERATOR Xor  IDENT d
            NOT a  =>  WORD_OPERATOR NOT  IDENT a
            a MOD b SHL c SHR d  =>  IDENT a  WORD_OPERATOR MOD  IDENT b  WORD_OPERATOR SHL  IDENT c  WORD_OPERATOR SHR  IDENT d
            a : b ; c  =>  IDENT a  ERROR :  IDENT b  ERROR ;  IDENT c  !UnexpectedCharacter { place: Operands, after_comment: false }  !UnexpectedCharacter { place: Operands, after_comment: false }
            ANDY, notes, ORB  =>  IDENT ANDY  COMMA ,  IDENT notes  COMMA ,  IDENT ORB
            a=>b  =>  IDENT a  ARROW =>  IDENT b
            a:=-1  =>  IDENT a  ASSIGN :=  MINUS -  LITERAL 1
            a>=-1  =>  IDENT a  GREATER_EQUAL >=  MINUS -  LITERAL 1
            a<-1  =>  IDENT a  LESS <  MINUS -  LITERAL 1
        "#]],
    );
}

/// A `#` directly after a letter or digit belongs to a literal, one in quotes to the string, and every other one
/// opens a comment.
#[test]
fn number_signs() {
    check_operands(
        &[
            "T#5s",
            "T #5s#",
            "a# c #",
            "a_# c #",
            "a[3]# c #",
            "a[3# c #]",
            "5# c #",
            "16#FF# c #",
            "%IX0# c #",
            "'a'# c #",
            "'#', b",
            "a, # c # b",
            "# c #",
            "##",
            "a##",
            "€5#x",
            "é#x",
            "٣#x",
            "(a)# c #",
            "a # c 5#, b",
        ],
        expect![[r#"
            T#5s  =>  LITERAL T#5s
            T #5s#  =>  IDENT T  COMMENT #5s#
            a# c #  =>  IDENT a  COMMENT # c #
            a_# c #  =>  IDENT a_  COMMENT # c #
            a[3]# c #  =>  IDENT a  L_BRACKET [  LITERAL 3  R_BRACKET ]  COMMENT # c #
            a[3# c #]  =>  IDENT a  L_BRACKET [  LITERAL 3#  IDENT c  !UnclosedBlock { closing: R_BRACKET }  !MissingComma  !UnclosedComment
            5# c #  =>  LITERAL 5#  IDENT c  !MissingComma  !UnclosedComment
            16#FF# c #  =>  LITERAL 16#FF  COMMENT # c #
            %IX0# c #  =>  ADDRESS %IX0  COMMENT # c #
            'a'# c #  =>  STRING 'a'  COMMENT # c #
            '#', b  =>  STRING '#'  COMMA ,  IDENT b
            a, # c # b  =>  IDENT a  COMMA ,  COMMENT # c #  IDENT b
            # c #  =>  COMMENT # c #
            ##  =>  COMMENT ##
            a##  =>  IDENT a  COMMENT ##
            €5#x  =>  ERROR €  LITERAL 5#x  !UnexpectedCharacter { place: Operands, after_comment: false }
            é#x  =>  IDENT é  !UnclosedComment
            ٣#x  =>  ERROR ٣  !UnexpectedCharacter { place: Operands, after_comment: false }  !UnclosedComment
            (a)# c #  =>  IDENT a  COMMENT # c #
            a # c 5#, b  =>  IDENT a  COMMENT # c 5#  COMMA ,  IDENT b
        "#]],
    );
}

#[test]
fn on_a_rung_and_in_a_head() {
    check_tokens(
        &[
            "+--\\--/--|",
            "[T#c#]",
            "(S#c#)",
            "(T#5s)",
            "<J#c#MP>",
            "[/](a)",
            "[$B1]",
            "[$]",
            "[$1]",
            "[$a_b]",
            "a#c#",
            "5#c#",
            "[ ]#c#",
            "hello, world!",
            "\u{feff}--",
            "--\u{feff}",
            "\0",
            "a\u{a0}b",
            "-\t -",
            "\r\r\n\n",
        ],
        expect![[r##"
            "+--\\--/--|": RAIL_CONNECTOR "+" WIRE "--" DOWN "\\" WIRE "--" UP "/" WIRE "--" RAIL "|"
            "[T#c#]": L_BRACKET "[" MNEMONIC "T" COMMENT "#c#" R_BRACKET "]"
            "(S#c#)": L_PAREN "(" MNEMONIC "S" COMMENT "#c#" R_PAREN ")"
            "(T#5s)": L_PAREN "(" ERROR "T#5s" R_PAREN ")"
            "<J#c#MP>": L_ANGLE "<" MNEMONIC "J" COMMENT "#c#" ERROR "MP" R_ANGLE ">"
            "[/](a)": L_BRACKET "[" MNEMONIC "/" R_BRACKET "]" L_PAREN "(" IDENT "a" R_PAREN ")"
            "[$B1]": L_BRACKET "[" BLOCK_NAME "$B1" R_BRACKET "]"
            "[$]": L_BRACKET "[" ERROR "$" R_BRACKET "]"
            "[$1]": L_BRACKET "[" ERROR "$1" R_BRACKET "]"
            "[$a_b]": L_BRACKET "[" BLOCK_NAME "$a_b" R_BRACKET "]"
            "a#c#": ERROR "a" COMMENT "#c#"
            "5#c#": ERROR "5" COMMENT "#c#"
            "[ ]#c#": L_BRACKET "[" R_BRACKET "]" COMMENT "#c#"
            "hello, world!": ERROR "hello," ERROR "world!"
            "\u{feff}--": BOM "\u{feff}" WIRE "--"
            "--\u{feff}": WIRE "--" ERROR "\u{feff}"
            "\0": ERROR "\0"
            "a\u{a0}b": ERROR "a\u{a0}b"
            "-\t -": WIRE "-" WIRE "-"
            "\r\r\n\n": NEWLINE "\r" NEWLINE "\r\n" NEWLINE "\n"
        "##]],
    );
}
