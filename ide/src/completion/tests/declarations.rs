//! Declarations and addresses, and where nothing is proposed.

use super::{accept, check};
use expect_test::expect;

#[test]
fn declarations() {
    check(
        "V$0",
        expect![[r#"
        VAR_INPUT      inputs
        VAR_OUTPUT     outputs
        VAR            internal tags
        VAR_GLOBAL     tags of the whole workspace
        VAR_EXTERNAL   tags of a VAR_GLOBAL section
    "#]],
    );
    check(
        "$0",
        expect![[r#"
            VAR_INPUT      inputs
            VAR_OUTPUT     outputs
            VAR            internal tags
            VAR_GLOBAL     tags of the whole workspace
            VAR_EXTERNAL   tags of a VAR_GLOBAL section
            TYPE           types of your own
            FUNCTION_BLOCK [$Name] block definition
            FUNCTION_BLOCK ($Name) block definition
            FUNCTION_BLOCK <$Name> block definition
            rung           a contact and a coil
            branch         either of two contacts
            seal-in        start, held until stop
            timer          a coil that follows its contact after a time
            counter        counts up at every press, until it is reset
            ... 16 in all
        "#]],
    );
    accept(
        "VAR_IN$0\n",
        "VAR_INPUT",
        expect![[r#"
        VAR_INPUT
            ${1:name} : ${2:BOOL};
        END_VAR$0
        VAR_INPUT
            name : BOOL;
        END_VAR
    "#]],
    );
    check(
        "VAR $0\n    a : INT;\nEND_VAR\n",
        expect![[r#"
        RETAIN         values are kept over a warm restart
        CONSTANT       values are never written
    "#]],
    );
    check(
        "VAR\n    a : $0\nEND_VAR\n",
        expect![[r#"
            BOOL           type
            INT            type
            DINT           type
            REAL           type
            TIME           type
            BYTE           type
            WORD           type
            DWORD          type
            LWORD          type
            SINT           type
            LINT           type
            USINT          type
            UINT           type
            UDINT          type
            ... 56 in all
        "#]],
    );
    check(
        "VAR\n    a : ARRAY[1..8] $0\nEND_VAR\n",
        expect![[r#"
        OF             the type of the elements
    "#]],
    );
    check(
        "VAR\n    a : ARRAY[1..8] OF $0\nEND_VAR\n",
        expect![[r#"
            BOOL           type
            INT            type
            DINT           type
            REAL           type
            TIME           type
            BYTE           type
            WORD           type
            DWORD          type
            LWORD          type
            SINT           type
            LINT           type
            USINT          type
            UINT           type
            UDINT          type
            ... 55 in all
        "#]],
    );
    check(
        "VAR\n    a $0\nEND_VAR\n",
        expect![[r#"
        AT             a direct address
    "#]],
    );
    check(
        "VAR\n    a AT %$0 : BOOL;\nEND_VAR\n",
        expect![[r#"
        %IX            input, bit
        %IB            input, 8 bits
        %IW            input, 16 bits
        %ID            input, 32 bits
        %IL            input, 64 bits
        %QX            output, bit
        %QB            output, 8 bits
        %QW            output, 16 bits
        %QD            output, 32 bits
        %QL            output, 64 bits
        %MX            memory, bit
        %MB            memory, 8 bits
        %MW            memory, 16 bits
        %MD            memory, 32 bits
        ... 15 in all
    "#]],
    );
    check(
        "VAR\n    a : BOOL := $0;\nEND_VAR\n",
        expect![[r#"
        TRUE           literal
        FALSE          literal
    "#]],
    );
    check(
        "VAR\n    a : BOOL;\n    $0\n",
        expect![[r#"
        END_VAR        end of the section
    "#]],
    );
    check(
        "VAR\n    a : BOOL;\nEND$0\n",
        expect![[r#"
        END_VAR        end of the section
    "#]],
    );
    check(
        "FUNCTION_BLOCK [$B]\n$0\n",
        expect![[r#"
            VAR_INPUT      inputs
            VAR_OUTPUT     outputs
            VAR            internal tags
            VAR_IN_OUT     the caller's own tags
            VAR_GLOBAL     tags of the whole workspace
            VAR_EXTERNAL   tags of a VAR_GLOBAL section
            END_FUNCTION_BLOCK end of a block definition
            rung           a contact and a coil
            branch         either of two contacts
            seal-in        start, held until stop
            timer          a coil that follows its contact after a time
            counter        counts up at every press, until it is reset
            function       networks that are run where they are called
        "#]],
    );
}

#[test]
fn addresses() {
    check(
        "+--[ ]( %$0 )--( )( %QX0.0 )--+\n",
        expect![[r#"
        %QX0.0         BOOL
        %IX            input, bit
        %IB            input, 8 bits
        %IW            input, 16 bits
        %ID            input, 32 bits
        %IL            input, 64 bits
        %QX            output, bit
        %QB            output, 8 bits
        %QW            output, 16 bits
        %QD            output, 32 bits
        %QL            output, 64 bits
        %MX            memory, bit
        %MB            memory, 8 bits
        %MW            memory, 16 bits
        ... 16 in all
    "#]],
    );
    accept(
        "+--[ ]( %I$0 )--( )( %QX0.0 )--+\n",
        "%IX",
        expect![[r#"
        +--[ ]( %IX${1:0.0}$0 )--( )( %QX0.0 )--+
        +--[ ]( %IX0.0 )--( )( %QX0.0 )--+
    "#]],
    );
}

#[test]
fn nothing_in_comments_strings_and_numbers() {
    check(
        "# TO$0",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--# [TO$0 #--( )( y )--+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[FMT]( 'st$0' )--+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[TON]( t, T#1$0 )--+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[GT]( a, 12$0 )--+\n",
        expect![[r#"
        nothing
    "#]],
    );
}
