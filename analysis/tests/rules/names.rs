//! Declarations, undeclared tags, operands by name.

use crate::check::{check, clean};
use expect_test::expect;

#[test]
fn in_a_file_that_declares() {
    check(
        "VAR_INPUT\n    start, stop : BOOL;\nEND_VAR\n\n+--[ ]( strat )--[/]( stop )--( )( run )--+\n",
        expect![[r#"
            > +--[ ]( strat )--[/]( stop )--( )( run )--+
                      ^^^^^ warning[undeclared-tag]: `strat` is not declared
                help: did you mean `start`?
                fix: Replace with `start`
                  +--[ ]( start )--[/]( stop )---------------------------------------( )( run )--+
                fix: Declare `strat : BOOL` in VAR_INPUT
                      strat       : BOOL;
            > +--[ ]( strat )--[/]( stop )--( )( run )--+
                                                 ^^^ warning[undeclared-tag]: `run` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `run : BOOL` in VAR_OUTPUT
                  VAR_OUTPUT
                      run : BOOL;
                  END_VAR
        "#]],
    );
    check(
        "VAR\n    t : TON;\nEND_VAR\n\n# The pump #\n+--[ ]( warm )--[TON]( t, wait )--( )( pump )--+\n\n+--[ ]( warm )--[MOV]( n, 5 )--+\n",
        expect![[r#"
            > +--[ ]( warm )--[TON]( t, wait )--( )( pump )--+
                      ^^^^ warning[undeclared-tag]: `warm` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `warm : BOOL` in VAR_INPUT
                  VAR_INPUT
                      warm : BOOL;
                  END_VAR
            > +--[ ]( warm )--[TON]( t, wait )--( )( pump )--+
                                        ^^^^ warning[undeclared-tag]: `wait` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `wait : TIME` in VAR_INPUT
                  VAR_INPUT
                      wait : TIME;
                  END_VAR
            > +--[ ]( warm )--[TON]( t, wait )--( )( pump )--+
                                                     ^^^^ warning[undeclared-tag]: `pump` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `pump : BOOL` in VAR_OUTPUT
                  VAR_OUTPUT
                      pump : BOOL;
                  END_VAR
            > +--[ ]( warm )--[MOV]( n, 5 )--+
                                     ^ warning[undeclared-tag]: `n` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `n : DINT` in VAR
                      n : DINT;
        "#]],
    );
    // Names that say their type, and addresses, need no declaration.
    clean(
        "VAR\n    t : TON;\nEND_VAR\n\n+--[ ]( I1 )--[TON]( t, T#5s )--( )( Q3 )--( )( %QX0.0 )--[MOV]( MI1, 5 )--+\n",
    );
}

#[test]
fn arrays() {
    check(
        "+--[ ]( a )--[MOV]( level[3], 5 )--[MOV]( n, level[7] )--+\n",
        expect![[r#"
            > +--[ ]( a )--[MOV]( level[3], 5 )--[MOV]( n, level[7] )--+
                                  ^^^^^ error[undeclared-tag]: the array `level` is not declared
                help: declare it with its bounds: level : ARRAY[1..7] OF DINT;
                fix: Declare `level : ARRAY[1..7] OF DINT` in VAR
                  VAR
                      level : ARRAY[1..7] OF DINT;
                  END_VAR
      
        "#]],
    );
    check(
        "+--[ ]( flag[i] )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( flag[i] )--( )( y )--+
                      ^^^^ error[undeclared-tag]: the array `flag` is not declared
                help: declare it with its bounds: flag : ARRAY[1..10] OF BOOL;
                fix: Declare `flag : ARRAY[1..10] OF BOOL` in VAR
                  VAR
                      flag : ARRAY[1..10] OF BOOL;
                  END_VAR
      
        "#]],
    );
    check(
        "+--[ ]( flag[1..8] )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( flag[1..8] )--( )( y )--+
                      ^^^^ error[undeclared-tag]: the array `flag` is not declared
                help: declare it with its bounds: flag : ARRAY[1..8] OF BOOL;
                fix: Declare `flag : ARRAY[1..8] OF BOOL` in VAR
                  VAR
                      flag : ARRAY[1..8] OF BOOL;
                  END_VAR
      
        "#]],
    );
}

#[test]
fn in_a_body() {
    check(
        "+--[ ]( outside )--( )( y )--+\n\nFUNCTION_BLOCK [$A]\nVAR_INPUT\n    a : BOOL;\nEND_VAR\n+--[ ]( a )--[ ]( outside )--( )( I1 )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        expect![[r#"
            > +--[ ]( a )--[ ]( outside )--( )( I1 )--( )( ENO )--+
                                ^^^^^^^ error[undeclared-tag]: `outside` is not declared in the block `$A`
                help: a block sees its own tags and VAR_GLOBAL tags only: declare it in the block
                at 1:9 `outside`: a tag of this name is in the program: the block does not see it
                fix: Declare `outside : BOOL` in VAR
                  VAR
                      outside : BOOL;
                  END_VAR
            > +--[ ]( a )--[ ]( outside )--( )( I1 )--( )( ENO )--+
                                                ^^ error[undeclared-tag]: `I1` is not declared in the block `$A`
                help: a block sees its own tags and VAR_GLOBAL tags only: declare it in the block
                fix: Declare `I1 : BOOL` in VAR
                  VAR
                      I1 : BOOL;
                  END_VAR
        "#]],
    );
    check(
        "FUNCTION_BLOCK [$A]\n+--[ ]( a )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        expect![[r#"
            > +--[ ]( a )--( )( ENO )--+
                      ^ error[undeclared-tag]: `a` is not declared in the block `$A`
                help: a block sees its own tags and VAR_GLOBAL tags only: declare it in the block
                fix: Declare `a : BOOL` in VAR
                  VAR
                      a : BOOL;
                  END_VAR
      
        "#]],
    );
    clean(
        "VAR_GLOBAL\n    all : BOOL;\nEND_VAR\n\nFUNCTION_BLOCK [$A]\n+--[ ]( ALL )--[ ]( %IX0.0 )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\n+--[$A]--( )( all )--+\n",
    );
    // A block may introduce a global tag.
    clean(
        "VAR\n    x : BOOL;\nEND_VAR\n\nFUNCTION_BLOCK [$A]\nVAR_GLOBAL\n    count : INT;\nEND_VAR\n+--[ADD]( count, count, 1 )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\n+--[$A]--[GT]( count, 5 )--( )( x )--+\n",
    );
}

#[test]
fn slips_in_a_file_without_declarations() {
    check(
        "+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( rum )----/                           |\n\n+--[ ]( run )--[ ]( start )--( )( lamp1 )--+\n\n+--[ ]( run )--( )( lamp2 )--( )( lamp1 )--+\n",
        expect![[r#"
            > |  /--[ ]( rum )----/                           |
                         ^^^ info[undeclared-tag]: `rum` is here only, and looks like `run`
                help: a typing error makes a new tag: correct it, or declare the tags of the file
                fix: Replace with `run`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
            > +--[ ]( run )--( )( lamp2 )--( )( lamp1 )--+
                                                ^^^^^ warning[double-coil]: `lamp1` is written by 2 coils: the last one alone decides
                help: combine all conditions into one coil, joined with \ and /; or use (S) and (R)
                at 4:35 `lamp1`: `lamp1` is written here as well
        "#]],
    );
    clean("+--[ ]( a )--[ ]( c )--( )( b )--+\n");
}

#[test]
fn the_new_section_finds_its_place() {
    check(
        "VAR a : BOOL; END_VAR\n+--[ ]( a )--[ ]( b )--[ADD]( c, c, 1 )--+\n",
        expect![[r#"
            > +--[ ]( a )--[ ]( b )--[ADD]( c, c, 1 )--+
                                ^ warning[undeclared-tag]: `b` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `b : BOOL` in VAR_INPUT
                  VAR_INPUT
                      b : BOOL;
                  END_VAR
            > +--[ ]( a )--[ ]( b )--[ADD]( c, c, 1 )--+
                                            ^ warning[undeclared-tag]: `c` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `c : DINT` in VAR
                  VAR
                      a : BOOL;
                      c : DINT;
                  END_VAR
        "#]],
    );
    check("VAR RETAIN a : BOOL; END_VAR", expect![[r#""#]]);
    check(
        "VAR CONSTANT\n    limit : INT := 5;\nEND_VAR\r\n+--[GT]( n, limit )--( )( y )--+\r\n",
        expect![[r#"
            > +--[GT]( n, limit )--( )( y )--+
                       ^ warning[undeclared-tag]: `n` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `n : DINT` in VAR_INPUT
                  VAR_INPUT
                      n : DINT;
                  END_VAR
            > +--[GT]( n, limit )--( )( y )--+
                                        ^ warning[undeclared-tag]: `y` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `y : BOOL` in VAR_OUTPUT
                  VAR_OUTPUT
                      y : BOOL;
                  END_VAR
        "#]],
    );
    check(
        "VAR\n    a : BOOL;\n\n+--[ ]( b )--( )( a )--+\n",
        expect![[r#"
            > +--[ ]( b )--( )( a )--+
              ^ error[bad-declaration]: the declarations above are not closed: END_VAR is missing
                help: a section ends with END_VAR on a line of its own
                fix: Insert END_VAR
                  END_VAR
        "#]],
    );
}

#[test]
fn declared_twice() {
    check(
        "VAR\n    a, b : BOOL;\n    A : INT;\nEND_VAR\nVAR_INPUT\n    b : BOOL;\nEND_VAR\n\n+--[ ]( a )--( )( b )--+\n",
        expect![[r#"
            >     A : INT;
                  ^ error[duplicate-declaration]: `A` is declared twice
                help: remove one of the declarations, or give one tag another name; capitals do not tell names apart
                at 2:5 `a`: `a` is first declared here
            >     b : BOOL;
                  ^ error[duplicate-declaration]: `b` is declared twice
                help: remove one of the declarations, or give one tag another name; capitals do not tell names apart
                at 2:8 `b`: `b` is first declared here
        "#]],
    );
    check(
        "VAR\n    sys : BOOL;\n    int : INT;\n    END_VAR\n",
        expect![[r#"
            >     sys : BOOL;
                  ^^^ error[bad-declaration]: `sys` is a word of the language: choose another name
            >     int : INT;
                  ^^^ error[bad-declaration]: `int` is a word of the language: choose another name
        "#]],
    );
}

#[test]
fn operands_by_name() {
    check(
        "+--[TON]( t, T#5s, Q := y )--( )( z )--+\n",
        expect![[r#"
            > +--[TON]( t, T#5s, Q := y )--( )( z )--+
                                 ^ error[bad-operand]: [TON] has no operand of the name `Q`
                help: by name it takes R
        "#]],
    );
    check(
        "+--[TON]( t, PT := T#5s )--( )( z )--+\n",
        expect![[r#"
            > +--[TON]( t, PT := T#5s )--( )( z )--+
                           ^^ error[bad-operand]: `PT` of [TON] is given by its place, without a name
                help: the first operands come in their order; only the optional ones are given by name
                safe fix: Remove `PT :=`
                  +--------------------------------------------------[TON]( t, T#5s )--( )( z )--+
        "#]],
    );
    check(
        "+--[TON]( t, T#5s, R => y )--( )( z )--+\n",
        expect![[r#"
            > +--[TON]( t, T#5s, R => y )--( )( z )--+
                                 ^^^^^^ error[bad-operand]: `R` is an operand that [TON] reads
                help: `:=` gives an operand, `=>` takes a result
                fix: Replace `=>` with `:=`
                  +------------------------------------------[TON]( t, T#5s, R := y )--( )( z )--+
        "#]],
    );
    check(
        "+--[CTUD]( c, 5, CU := y )--( )( z )--+\n",
        expect![[r#"
            > +--[CTUD]( c, 5, CU := y )--( )( z )--+
                               ^^ error[bad-operand]: [CTUD] has no operand of the name `CU`
                help: did you mean `CD`?
        "#]],
    );
    check(
        "+--[TON]( t, T#5s, R := a, R := b )--( )( z )--+\n",
        expect![[r#"
            > +--[TON]( t, T#5s, R := a, R := b )--( )( z )--+
                                         ^^^^^^ error[bad-arity]: the operand `R` of [TON] is given twice
                help: leave one of them out
                at 1:20 `R := a`: it is given here before
        "#]],
    );
    check(
        "+--[ ]( tag := a )--( )( z )--+\n",
        expect![[r#"
            > +--[ ]( tag := a )--( )( z )--+
                      ^^^ error[bad-operand]: `tag` of [ ] is given by its place, without a name
                help: the first operands come in their order; only the optional ones are given by name
                safe fix: Remove `tag :=`
                  +--[ ]( a )----------------------------------------------------------( )( z )--+
        "#]],
    );
}

#[test]
fn a_error_in_a_type_is_reported_once() {
    check(
        "+--[TON]( delay, T#5s )--[ ]( dleay.Q )--[ ]( delay.QU )--( )( y )--+\n",
        expect![[r#"
            > +--[TON]( delay, T#5s )--[ ]( dleay.Q )--[ ]( delay.QU )--( )( y )--+
                                                  ^ error[unknown-member]: `dleay` has no `Q`: no block makes it a timer or counter, and it is not declared
                help: did you mean `delay`?
                fix: Replace with `delay`
                  +--[TON]( delay, T#5s )--[ ]( delay.Q )--[ ]( delay.QU )-------------( )( y )--+
            > +--[TON]( delay, T#5s )--[ ]( dleay.Q )--[ ]( delay.QU )--( )( y )--+
                                                                  ^^ error[unknown-member]: `delay` is a TON and has no member `QU`
                help: its members are IN PT Q ET R TT
        "#]],
    );
    check(
        "+--[TON]( t, T#5s )--[ ]( t )--( )( y )--+\n",
        expect![[r#"
            > +--[TON]( t, T#5s )--[ ]( t )--( )( y )--+
                                        ^ error[type-mismatch]: `t` is used as BOOL here, and as TON before
                help: for the output of the TON write `t.Q`
                at 1:11 `t`: here it is TON
                fix: Use the output of `t`
                  +--[TON]( t, T#5s )--[ ]( t.Q )--------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--[MOV]( 5, a )--+\n",
        expect![[r#"
            > +--[MOV]( 5, a )--+
                        ^^^^ error[bad-operand]: `5` and `a` are swapped
                help: the result comes first
                fix: Swap `5` and `a`
                  +---------------------------------------------------------------[MOV]( a, 5 )--+
        "#]],
    );
    check(
        "VAR CONSTANT\n    limit : INT := 5;\nEND_VAR\n\n+--[MOV]( limit, 6 )--+\n",
        expect![[r#"
            > +--[MOV]( limit, 6 )--+
                        ^^^^^ error[constant-write]: `limit` is a constant: no block may write it
                help: declare it in a VAR section without CONSTANT, or write another tag
                at 2:5 `limit`: `limit` is declared CONSTANT here
        "#]],
    );
    check(
        "VAR\n    n : INT;\nEND_VAR\n\n+--[MOV]( n, 70000 )--[ ]( n )--[ ]( n.16 )--[ ]( n.Q )--+\n",
        expect![[r#"
            > +--[MOV]( n, 70000 )--[ ]( n )--[ ]( n.16 )--[ ]( n.Q )--+
                           ^^^^^ error[literal-out-of-range]: 70000 is outside of INT, which holds -32768 to 32767
            > +--[MOV]( n, 70000 )--[ ]( n )--[ ]( n.16 )--[ ]( n.Q )--+
                                         ^ error[type-mismatch]: this is INT, BOOL is expected here
                help: compare it ([NE]( tag, 0 )), or name one of its bits (tag.0)
            > +--[MOV]( n, 70000 )--[ ]( n )--[ ]( n.16 )--[ ]( n.Q )--+
                                                     ^^ error[unknown-member]: INT has the bits 0 to 15, there is no `16`
            > +--[MOV]( n, 70000 )--[ ]( n )--[ ]( n.16 )--[ ]( n.Q )--+
                                                                  ^ error[unknown-member]: INT has the bits 0 to 15, there is no `Q`
        "#]],
    );
}

#[test]
fn a_error_in_a_declaration_brings_no_other() {
    check(
        "VAR\n    a BOOL;\n    b : BOL;\n    n : ARRAY[5..1] OF INT;\nEND_VAR\n\n+--[ ]( a )--[MOV]( n[1], 5 )--( )( b )--+\n",
        expect![[r#"
            >     a BOOL;
                    ^^^^ error[bad-declaration]: expected `:` and a type, found `BOOL`
                help: a declaration is written: start : BOOL; the types are BOOL, INT, DINT, REAL, TIME, TON, CTU and others
            >     b : BOL;
                      ^^^ error[unknown-type]: there is no type `BOL`: did you mean BOOL?
                fix: Replace with BOOL
                      b : BOOL;
            >     n : ARRAY[5..1] OF INT;
                      ^^^^^^^^^^^^^^^^^^ error[bad-declaration]: the last index 1 is below the first 5: swap them
        "#]],
    );
    // What an unknown block does with its operands nobody knows.
    check(
        "VAR\n    a : BOOL;\nEND_VAR\n\n+--[ ]( a )--[FROBNICATE]( x )--[ ]( a, z )--+\n",
        expect![[r#"
            > +--[ ]( a )--[FROBNICATE]( x )--[ ]( a, z )--+
                           ^^^^^^^^^^^^ error[unknown-instruction]: there is no instruction [FROBNICATE]
                help: contacts are [ ] and [/]; the language reference lists all instructions
            > +--[ ]( a )--[FROBNICATE]( x )--[ ]( a, z )--+
                                                      ^ error[bad-arity]: [ ] takes 1 operand, 2 are given
                help: it is written [ ]( tag )
        "#]],
    );
}
