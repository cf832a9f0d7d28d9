//! Brackets, comments, characters, wires.

use crate::check::{check, clean};
use expect_test::expect;

#[test]
fn first_part_that_is_not_closed() {
    check(
        "+--[TON( t, T#5s )--( )( y )--+\n",
        expect![[r#"
            > +--[TON( t, T#5s )--( )( y )--+
                 ^^^^ error[unclosed-block]: `[TON` is not closed: `]` is missing
                help: a block is closed on its own line
                safe fix: Insert `]`
                  +--------------------------------------------------[TON]( t, T#5s )--( )( y )--+
        "#]],
    );
    check(
        "+--[ ]( a )--<JMP( there )--+\n\n+--<LBL>( there )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--<JMP( there )--+
                           ^^^^ error[unclosed-block]: `<JMP` is not closed: `>` is missing
                help: a block is closed on its own line
                safe fix: Insert `>`
                  +--[ ]( a )----------------------------------------------------<JMP>( there )--+
        "#]],
    );
    check(
        "+--[ ]( a )--( ( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--( ( y )--+
                           ^ error[unclosed-block]: `(` is not closed: `)` is missing
                help: a block is closed on its own line
                safe fix: Insert `)`
                  +--[ ]( a )----------------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--[TON)( t, T#5s )--( )( y )--+\n",
        expect![[r#"
            > +--[TON)( t, T#5s )--( )( y )--+
                     ^ error[unclosed-block]: `)` is where `]` closes the block
                help: a block ends with the partner of the bracket that it begins with
                fix: Replace `)` with `]`
                  +--------------------------------------------------[TON]( t, T#5s )--( )( y )--+
        "#]],
    );
}

#[test]
fn operand_list_that_is_not_closed() {
    check(
        "+--[ ]( start --( )( y )--+\n",
        expect![[r#"
            > +--[ ]( start --( )( y )--+
                    ^^^^^^^^ error[unclosed-block]: `( start` is not closed: `)` is missing
                help: a block is closed on its own line
                safe fix: Insert `)`
                  +--[ ]( start )------------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--[TON]( warmup, T#5s--( )( y )--+\n",
        expect![[r#"
            > +--[TON]( warmup, T#5s--( )( y )--+
                      ^^^^^^^^^^^^^^ error[unclosed-block]: `( warmup, T#5s` is not closed: `)` is missing
                help: a block is closed on its own line
                safe fix: Insert `)`
                  +---------------------------------------------[TON]( warmup, T#5s )--( )( y )--+
        "#]],
    );
    check(
        "+--[ ]( a[3 )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a[3 )--( )( y )--+
                       ^^ error[unclosed-block]: `[3` is not closed: `]` is missing
                help: a block is closed on its own line
                fix: Insert `]`
                  +--[ ]( a[3] )-------------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--[ ]( a )--( )( y",
        expect![[r#"
            > +--[ ]( a )--( )( y
                              ^^^ error[unclosed-block]: `( y` is not closed: `)` is missing
                help: a block is closed on its own line
                safe fix: Insert `)`
                  +--[ ]( a )--( )( y )
        "#]],
    );
}

#[test]
fn wire_between_brackets() {
    check(
        "+--[|]( a )--[\\]( b )--( )( y )--+\n",
        expect![[r#"
        > +--[|]( a )--[\]( b )--( )( y )--+
             ^^^ error[unclosed-block]: `[|]` is no block
            help: a contact is [ ], or [/] where it lets power through while its tag is low
    "#]],
    );
    check(
        "+--[ ]( a )--[\\]( b )--( )( y )--+\n",
        expect![[r#"
        > +--[ ]( a )--[\]( b )--( )( y )--+
                       ^^^ error[unclosed-block]: `[\]` is no block
            help: a contact that lets power through while its tag is low is [/]
            fix: Write `[/]`
              +--[ ]( a )--[/]( b )------------------------------------------------( )( y )--+
    "#]],
    );
}

#[test]
fn unclosed_block_brings_nothing_else() {
    check(
        "+--\\--[ ]( a --\\--( )( y )--+\n|  /--[ ]( b )--/            |\n",
        expect![[r#"
            > +--\--[ ]( a --\--( )( y )--+
                       ^^^^ error[unclosed-block]: `( a` is not closed: `)` is missing
                help: a block is closed on its own line
                safe fix: Insert `)`
                  +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
                  |  /--[ ]( b )--/                                                              |
        "#]],
    );
}

#[test]
fn a_file_in_the_first_draft() {
    check(
        "// a motor\nIN = {DI start}\nOUT = {DO run}\n\n+---[ ]<start>---()<run>---+\n",
        expect![[r#"
            > IN = {DI start}
              ^^^^^^^^^^^^^^^ error[unexpected-character]: this is a program in the first draft of CPLC-LD, which ladder text has moved on from
                help: `ladder convert --from cplc-draft` writes it as ladder text, and says what becomes of each element
        "#]],
    );
    // A slip in a program of our own is one.
    check(
        "+--[ ]( a )--( )( y )--+\n+--[ ]<a>--( )( z )--+\n",
        expect![[r#"
            > +--[ ]<a>--( )( z )--+
                 ^^^ error[bad-arity]: [ ] takes 1 operand, none is given
                help: it is written [ ]( tag )
                fix: Add tag
                  +--[ ]( ? )<a>--( )( z )--+
            > +--[ ]<a>--( )( z )--+
                   ^^ warning[missing-wire]: two blocks touch without a wire between them
                help: draw a `-` between them
                safe fix: Insert wire
                  +--[ ]----------------------------------------------------------<a>--( )( z )--+
            > +--[ ]<a>--( )( z )--+
                    ^^^ error[unknown-instruction]: there is no instruction <a>
                help: a block in < > is <LBL>, <JMP>, <FUN>, <CALL>, <RET>, <END>, <FOR>, <NEXT> or <MCR>
        "#]],
    );
}

#[test]
fn comment_that_is_not_closed() {
    check(
        "+--[ ]( a )--( )( y )--+  # the motor\n",
        expect![[r#"
            > +--[ ]( a )--( )( y )--+  # the motor
                                        ^ error[unclosed-comment]: this comment is never closed: all that follows is read as comment
                help: close it with a second `#`
        "#]],
    );
    check(
        "# start\n+--[ ]( a )--( )( y )--+\n# stop #\n+--[ ]( b )--<JMP>( nowhere )--+\n",
        expect![[r#"
            > # start
              ^ error[unclosed-comment]: this comment holds lines of drawing: its closing `#` is probably missing
                help: close it after its text; until then nothing after this place is checked
                at 3:8 `#`: this `#` is left without a partner
        "#]],
    );
    // What is before is still found; what a name means may be after.
    check(
        "+--[TOM]( t, 5s )--<JMP>( there )--+\n# mark\n+--<LBL>( there )--( )( y )--+\n",
        expect![[r#"
            > +--[TOM]( t, 5s )--<JMP>( there )--+
                 ^^^^^ error[unknown-instruction]: there is no instruction [TOM]
                help: did you mean [TON] (on-delay timer)?
            > # mark
              ^ error[unclosed-comment]: this comment is never closed: all that follows is read as comment
                help: close it with a second `#`
        "#]],
    );
    check(
        "+--[ ]( a # b )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a # b )--( )( y )--+
                        ^ error[unclosed-comment]: this comment is never closed: all that follows is read as comment
                help: close it with a second `#`
        "#]],
    );
}

#[test]
fn stray_characters() {
    check(
        "+--[ ]( a )--?--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--?--( )( y )--+
                           ^ error[unexpected-character]: `?` means nothing on a rung
                help: a rung is drawn with - + | \ / and blocks; text is in # comments #
        "#]],
    );
    check(
        "+--start--( )( y )--+\n",
        expect![[r#"
            > +--start--( )( y )--+
                 ^^^^^ error[unexpected-character]: `start` is outside of any block
                help: a contact is written [ ]( start ), a coil ( )( start )
        "#]],
    );
    check(
        "hello world\n\n+--[ ]( a )--( )( y )--+\n",
        expect![[r#"
            > hello world
              ^^^^^^^^^^^ error[unexpected-character]: `hello world` means nothing on a rung
                help: a rung is drawn with - + | \ / and blocks; text is in # comments #
        "#]],
    );
    check(
        "+──[ ]( a )──( )( y )--+\n",
        expect![[r#"
            > +──[ ]( a )──( )( y )--+
               ^^ error[unexpected-character]: `──` means nothing on a rung
                help: a drawing uses plain characters: write `--`
                safe fix: Replace with `--`
                  +--[ ]( a )──( )( y )--+
            > +──[ ]( a )──( )( y )--+
                         ^^ error[unexpected-character]: `──` means nothing on a rung
                help: a drawing uses plain characters: write `--`
                safe fix: Replace with `--`
                  +──[ ]( a )--( )( y )--+
        "#]],
    );
    check(
        "+--[T!ON]( t, 5s )--( )( y )--+\n",
        expect![[r#"
            > +--[T!ON]( t, 5s )--( )( y )--+
                   ^^^ error[unexpected-character]: `!ON` means nothing in the first part of a block
        "#]],
    );
    check(
        "+--[ ]( a & b )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a & b )--( )( y )--+
                        ^ error[unexpected-character]: `&` means nothing among operands
        "#]],
    );
    check(
        "+--[$my__block]( a )--( )( y )--+\n",
        expect![[r#"
            > +--[$my__block]( a )--( )( y )--+
                  ^^^^^^^^^^ error[unexpected-character]: `$my__block` is not a name for a block
                help: a block's name is a `$` and a letter, then letters, digits and `_`, which is not last and not twice in a row: $FB_Ramp
        "#]],
    );
    // The comment of a commented-out timer ends at the # of its literal.
    check(
        "# +--[TON]( t, T#5s )--( )( y )--+ #\n+--[ ]( a )--( )( y )--+\n",
        expect![[r#"
            > # +--[TON]( t, T#5s )--( )( y )--+ #
                               ^^^^ error[unexpected-character]: `5s )` means nothing on a rung
                help: the `#` before it ended a comment: a comment ends at the very next `#`, so write 5s and not T#5s in it
            > # +--[TON]( t, T#5s )--( )( y )--+ #
                                                 ^ error[unclosed-comment]: this comment is never closed: all that follows is read as comment
                help: close it with a second `#`
        "#]],
    );
}

#[test]
fn blocks_that_touch() {
    check(
        "+--[ ]( a )[ ]( b )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )[ ]( b )--( )( y )--+
                        ^^ warning[missing-wire]: two blocks touch without a wire between them
                help: draw a `-` between them
                safe fix: Insert wire
                  +--[ ]( a )--[ ]( b )------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--\\[ ]( a )\\--( )( y )+\n|  /[ ]( b )/           |\n",
        expect![[r#"
            > +--\[ ]( a )\--( )( y )+
                 ^^ warning[missing-wire]: `\` and a block touch without a wire between them
                help: draw a `-` between them
                safe fix: Insert wire
                  +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
                  |  /--[ ]( b )--/                                                              |
            > +--\[ ]( a )\--( )( y )+
                         ^^ warning[missing-wire]: a block and `\` touch without a wire between them
                help: draw a `-` between them
                safe fix: Insert wire
                  +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
                  |  /--[ ]( b )--/                                                              |
            > +--\[ ]( a )\--( )( y )+
                                    ^^ warning[missing-wire]: a block and `+` touch without a wire between them
                help: draw a `-` between them
                safe fix: Insert wire
                  +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
                  |  /--[ ]( b )--/                                                              |
            > |  /[ ]( b )/           |
                 ^^ warning[missing-wire]: `/` and a block touch without a wire between them
                help: draw a `-` between them
                safe fix: Insert wire
                  +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
                  |  /--[ ]( b )--/                                                              |
            > |  /[ ]( b )/           |
                         ^^ warning[missing-wire]: a block and `/` touch without a wire between them
                help: draw a `-` between them
                safe fix: Insert wire
                  +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
                  |  /--[ ]( b )--/                                                              |
        "#]],
    );
    check(
        "+--[ ]( a )--[OSR]( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--[OSR]( )( y )--+
                                ^^^^^^^^ error[missing-wire]: [OSR] takes the next parentheses as its operands: the wire between them is missing
                help: [OSR] has no operands: keep a `-` after it
                safe fix: Insert wire after [OSR]
                  +--[ ]( a )--[OSR]---------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--[ ]( a )--[NOT] (S)( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--[NOT] (S)( y )--+
                                 ^^^^^^^^ error[missing-wire]: [NOT] takes the next parentheses as its operands: the wire between them is missing
                help: [NOT] has no operands: keep a `-` after it
                safe fix: Insert wire after [NOT]
                  +--[ ]( a )--[NOT]---------------------------------------------------(S)( y )--+
        "#]],
    );
    // A comment is wire.
    clean("+--[ ]( a )# here #[ ]( b )--( )( y )--+\n");
}

#[test]
fn declarations_that_cannot_be_read() {
    check(
        "VAR\n    a BOOL;\n    b : ;\n    : INT;\n    c : INT\nEND_VAR\n",
        expect![[r#"
            >     a BOOL;
                    ^^^^ error[bad-declaration]: expected `:` and a type, found `BOOL`
                help: a declaration is written: start : BOOL; the types are BOOL, INT, DINT, REAL, TIME, TON, CTU and others
            >     b : ;
                      ^ error[bad-declaration]: expected `:` and a type, found `;`
                help: a declaration is written: start : BOOL; the types are BOOL, INT, DINT, REAL, TIME, TON, CTU and others
            >     : INT;
                  ^ error[bad-declaration]: expected the name of a tag, found `:`
                help: a declaration is written: start, stop : BOOL;
            >     c : INT
                         ^ error[bad-declaration]: `;` is missing here
                help: every declaration ends with `;`
                safe fix: Insert `;`
                      c : INT;
        "#]],
    );
    check(
        "VAR\n    a : ARRAY[1 .. OF INT;\n    b AT : BOOL;\n    c : INT := ;\nEND_VAR\n",
        expect![[r#"
            >     a : ARRAY[1 .. OF INT;
                                 ^^ error[bad-declaration]: expected a whole number in brackets, found `OF`
                help: bounds are written ARRAY[1..10] OF INT, lengths STRING[80]
            >     b AT : BOOL;
                       ^ error[bad-declaration]: expected an address, found `:`
                help: after AT comes an address such as %IX0.0, %QW1 or %MD2
            >     c : INT := ;
                             ^ error[bad-declaration]: expected a value, found `;`
                help: after `:=` comes the value at the start: limit : INT := 80;
        "#]],
    );
    check(
        "VAR\n    a : BOOL;\n\n+--[ ]( a )--( )( a )--+\n",
        expect![[r#"
            > +--[ ]( a )--( )( a )--+
              ^ error[bad-declaration]: the declarations above are not closed: END_VAR is missing
                help: a section ends with END_VAR on a line of its own
                fix: Insert END_VAR
                  END_VAR
        "#]],
    );
    check(
        "END_VAR\nFUNCTION_BLOCK\nEND_FUNCTION_BLOCK\nEND_FUNCTION_BLOCK\n",
        expect![[r#"
            > END_VAR
              ^^^^^^^ error[bad-declaration]: END_VAR ends no section
                help: a section begins with VAR, VAR_INPUT, VAR_OUTPUT, VAR_IN_OUT, VAR_GLOBAL or VAR_EXTERNAL
            > FUNCTION_BLOCK
                            ^ error[bad-declaration]: expected the block with its brackets here
                help: a definition begins with its shape: FUNCTION_BLOCK [$Name], ($Name) or <$Name>
            > END_FUNCTION_BLOCK
              ^^^^^^^^^^^^^^^^^^ error[bad-declaration]: END_FUNCTION_BLOCK ends no definition
                help: a definition begins with FUNCTION_BLOCK [$Name]
        "#]],
    );
    check(
        "FUNCTION_BLOCK [$A]\nFUNCTION_BLOCK [$B]\n",
        expect![[r#"
            > FUNCTION_BLOCK [$B]
              ^^^^^^^^^^^^^^^^^^^ error[bad-declaration]: a block cannot be defined inside another
                help: close the definition above with END_FUNCTION_BLOCK first
        "#]],
    );
    check(
        "VAR a : BOL; END : INT; b : STRING[0]; END_VAR\n",
        expect![[r#"
            > VAR a : BOL; END : INT; b : STRING[0]; END_VAR
                      ^^^ error[unknown-type]: there is no type `BOL`: did you mean BOOL?
                fix: Replace with BOOL
                  VAR
                      a   : BOOL;
                      END : INT;
                      b   : STRING[0];
                  END_VAR
            > VAR a : BOL; END : INT; b : STRING[0]; END_VAR
                                          ^^^^^^^^^ error[bad-declaration]: a STRING holds 1 to 32767 characters
        "#]],
    );
}

#[test]
fn a_number_sign_in_the_value_of_an_enumeration() {
    check(
        "TYPE\n    Phase : (IDLE, RUN);\nEND_TYPE\n+--[EQ]( s, Phase#IDLE )--[NE]( s, Phase#RUN )--( )( Q1 )--+\n",
        expect![[r#"
            > +--[EQ]( s, Phase#IDLE )--[NE]( s, Phase#RUN )--( )( Q1 )--+
                                                       ^^^ error[bad-operand]: a comma is missing before this operand
                help: the `#` before it closed a comment; the value of an enumeration is written Phase.RUN
        "#]],
    );
}

#[test]
fn literals() {
    clean("+--[MOV]( a, LTIME#5s )--[MOV]( b, STRING#'1, #2' )--[MOV]( c, STRING#'x'# note # )--+\n");
    check(
        "+--[MOV]( b, STRING#'open )--[MOV]( c, STRING#5 )--+\n",
        expect![[r#"
            > +--[MOV]( b, STRING#'open )--[MOV]( c, STRING#5 )--+
                                  ^^^^^ error[bad-literal]: this text is not closed: `'` is missing
                help: a text ends on its own line; a quote in it is written $'
                fix: Insert `'`
                  +-----------------------------[MOV]( b, STRING#'open' )--[MOV]( c, STRING#5 )--+
        "#]],
    );
    check(
        "+--[EQ]( s, 'open )--( )( y )--+\n",
        expect![[r#"
            > +--[EQ]( s, 'open )--( )( y )--+
                          ^^^^^ error[bad-literal]: this text is not closed: `'` is missing
                help: a text ends on its own line; a quote in it is written $'
                fix: Insert `'`
                  +--[EQ]( s, 'open' )-------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--[GT]( n, 12x )--[TON]( t, T#5x )--( )( y )--+\n",
        expect![[r#"
            > +--[GT]( n, 12x )--[TON]( t, T#5x )--( )( y )--+
                          ^^^ error[bad-literal]: a duration has the units d h m s ms us ns, not `x`
            > +--[GT]( n, 12x )--[TON]( t, T#5x )--( )( y )--+
                                           ^^^^ error[bad-literal]: a duration has the units d h m s ms us ns, not `x`
        "#]],
    );
}

#[test]
fn a_merge_that_is_not_decided() {
    check(
        "# <<<<<<< ours #\n+--[ ]( a )--( )( y )--+\n# ======= #\n+--[/]( a )--( )( y )--+\n# >>>>>>> theirs #\n",
        expect![[r#"
            > # <<<<<<< ours #
              ^^^^^^^^^^^^^^^^ error[merge-conflict]: a merge left both forms of something here: it is not decided which one holds
                help: keep one of the two, or make one of them, and remove the lines of signs around them
                fix: Keep ours
                  +--[ ]( a )----------------------------------------------------------( )( y )--+
                fix: Keep theirs
                  +--[/]( a )----------------------------------------------------------( )( y )--+
                fix: Keep both
                  +--[ ]( a )----------------------------------------------------------( )( y )--+
                  +--[/]( a )----------------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "VAR\n<<<<<<< HEAD\n    a : BOOOL;\n||||||| 1a2b\n=======\n    b : BOOL;\n>>>>>>> theirs\nEND_VAR\n\
         +--\\--[ ]( b )--( )( y )--+\n<<<<<<< HEAD\n|  /--[ ]( c )--(S)( y )--+\n=======\n# open\n>>>>>>> theirs\n",
        expect![[r#"
            > <<<<<<< HEAD
              ^^^^^^^^^^^^ error[merge-conflict]: a merge left both forms of something here: it is not decided which one holds
                help: keep one of the two, or make one of them, and remove the lines of signs around them
                fix: Keep ours
                      a : BOOOL;
                fix: Keep theirs
                      b : BOOL;
                fix: Keep both
                      a : BOOOL;
                      b : BOOL;
            > +--\--[ ]( b )--( )( y )--+
                         ^ warning[undeclared-tag]: `b` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `b : BOOL` in VAR_INPUT
                  VAR_INPUT
                      b : BOOL;
                  END_VAR
            > +--\--[ ]( b )--( )( y )--+
                                   ^ warning[undeclared-tag]: `y` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `y : BOOL` in VAR_OUTPUT
                  VAR_OUTPUT
                      y : BOOL;
                  END_VAR
            > <<<<<<< HEAD
              ^^^^^^^^^^^^ error[merge-conflict]: a merge left both forms of something here: it is not decided which one holds
                help: keep one of the two, or make one of them, and remove the lines of signs around them
                fix: Keep ours
                  +--\--[ ]( b )-------------------------------------------------------( )( y )--+
                  |  /--[ ]( c )-------------------------------------------------------(S)( y )--+
                fix: Keep theirs
                  # open
                fix: Keep both
                  +--\--[ ]( b )-------------------------------------------------------( )( y )--+
                  |  /--[ ]( c )-------------------------------------------------------(S)( y )--+
                  # open
        "#]],
    );
    // Unfinished ones. After one nothing is read.
    check(
        "<<<<<<< HEAD\n+--[ ]( a )--( )( y )--+\n+--[ ]( b )--(\n>>>>>>> theirs\n=======\n+--[ ]( y )--( )( a )--+\n\
         <<<<<<< HEAD\n=======\n+--(",
        expect![[r#"
            > <<<<<<< HEAD
              ^^^^^^^^^^^^ error[merge-conflict]: a merge left a conflict here, of which lines of signs are missing
                help: make of it what should be here, and remove this line
            > =======
              ^^^^^^^ error[merge-conflict]: a merge left a conflict here, of which lines of signs are missing
                help: make of it what should be here, and remove this line
            > <<<<<<< HEAD
              ^^^^^^^^^^^^ error[merge-conflict]: a merge left a conflict here, of which lines of signs are missing
                help: put `>>>>>>>` below theirs: until then nothing after `=======` is read
        "#]],
    );
    // A part of one, and what only looks like one.
    check(
        "# <<<<<<< ours #\n+--[ ]( a )--( )( y )--+\n\n# ======= #\n# >>>>>>> theirs #\n# >>>>>>> theirs #\n\
         +--[ ]( y )--( )( z )--+\n# <<<<<<< ours #\n",
        expect![[r#"
            > # <<<<<<< ours #
              ^^^^^^^^^^^^^^^^ error[merge-conflict]: a merge left both forms of something here: it is not decided which one holds
                help: keep one of the two, or make one of them, and remove the lines of signs around them
                fix: Keep ours
                  +--[ ]( a )----------------------------------------------------------( )( y )--+

                fix: Keep theirs
                fix: Keep both
                  +--[ ]( a )----------------------------------------------------------( )( y )--+

            > # >>>>>>> theirs #
              ^^^^^^^^^^^^^^^^^^ error[merge-conflict]: a merge left a conflict here, of which lines of signs are missing
                help: make of it what should be here, and remove this line
            > # <<<<<<< ours #
              ^^^^^^^^^^^^^^^^ error[merge-conflict]: a merge left a conflict here, of which lines of signs are missing
                help: make of it what should be here, and remove this line
        "#]],
    );
    check(
        "# Pumps #\n# ======= #\n# >>> see below, <<<<<<< and not above #\n# >>>>>>>>> #\n+--[ ]( a )--( )( y )--+\n",
        expect![[r#""#]],
    );
}

#[test]
fn rungs_of_other_systems_as_text() {
    check(
        "XIC(a)XIO(b)TON(t1,5000,0)OTE(b);\n",
        expect![[r#"
        > XIC(a)XIO(b)TON(t1,5000,0)OTE(b);
          ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ error[unexpected-character]: this is a rung as Rockwell's software writes it as text, not a drawing
            help: the fix draws it; a timer keeps its preset, and what follows one gets the power that it gets
            fix: Draw it as a rung
              +--[ ]( a )--[/]( b )--\---------------------------------[TON]( t1, T#5s )--\--+
              |                      /------------------------------------------( )( b )--/  |
    "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--+\n\nXIC(a)OTE(x);\n[XIC(b),XIC(c)]OTL(z);\n\n+--[ ]( b )--( )( w )--+\n",
        expect![[r#"
            > XIC(a)OTE(x);
              ^^^^^^^^^^^^^ error[unexpected-character]: this is a rung as Rockwell's software writes it as text, not a drawing
                help: the fix draws it; a timer keeps its preset, and what follows one gets the power that it gets
                fix: Draw it as a rung
                  +--[ ]( a )----------------------------------------------------------( )( x )--+

                  +--\--[ ]( b )--\----------------------------------------------------(S)( z )--+
                  |  /--[ ]( c )--/                                                              |
        "#]],
    );
    check(
        "XIC(a)JSR(Fill,0)OTE(b);\n",
        expect![[r#"
        > XIC(a)JSR(Fill,0)OTE(b);
          ^^^^^^^^^^^^^^^^^^^^^^^^ error[unexpected-character]: this is a rung as Rockwell's software writes it as text, not a drawing
            help: draw it with blocks: `JSR(Fill,0)` is not read: draw it with <CALL>
    "#]],
    );
}

#[test]
fn an_instruction_outside_of_brackets_is_no_tag() {
    check(
        "XIC\n",
        expect![[r#"
        > XIC
          ^^^ error[unexpected-character]: `XIC` is outside of any block
            help: the open contact is written [ ]( tag )
    "#]],
    );
    check(
        "+--XIC--( )( y )--+\n",
        expect![[r#"
        > +--XIC--( )( y )--+
             ^^^ error[unexpected-character]: `XIC` is outside of any block
            help: the open contact is written [ ]( tag )
    "#]],
    );
    check(
        "+--TON( t, T#5s )--( )( y )--+\n",
        expect![[r#"
        > +--TON( t, T#5s )--( )( y )--+
             ^^^ error[unexpected-character]: `TON` is outside of any block
            help: the on-delay timer is written [TON]( t, PT, R := )
    "#]],
    );
}

#[test]
fn signs_in_the_place_of_names() {
    for (sign, name) in [
        (">=", "GE"),
        ("=>", "GE"),
        ("≥", "GE"),
        (">", "GT"),
        ("<", "LT"),
        ("<=", "LE"),
        ("≤", "LE"),
        ("=", "EQ"),
        ("==", "EQ"),
        ("<>", "NE"),
        ("!=", "NE"),
        ("≠", "NE"),
        ("+", "ADD"),
        ("-", "SUB"),
        ("*", "MUL"),
        ("×", "MUL"),
        ("÷", "DIV"),
    ] {
        let text = format!("+--[{sign}]( level, 50 )--( )( y )--+\n");
        let analysis =
            ladder_analysis::analyze(&std::sync::Arc::new(ladder_syntax::parse(&text)), "test.clad");
        let found = analysis.diagnostics();
        let fixes: Vec<&str> = found
            .iter()
            .flat_map(|found| &found.fixes)
            .map(|fix| &*fix.title)
            .collect();
        assert_eq!(fixes, [format!("Write [{name}]")], "{sign}");
    }
}

#[test]
fn a_missing_end_is_written_where_it_belongs() {
    check(
        "VAR_INPUT\n    a : BOOL;\n\n# it runs #\n+--[ ]( a )--( )( y )--+\n",
        expect![[r#"
        > +--[ ]( a )--( )( y )--+
          ^ error[bad-declaration]: the declarations above are not closed: END_VAR is missing
            help: a section ends with END_VAR on a line of its own
            fix: Insert END_VAR
              END_VAR
    "#]],
    );
    check(
        "VAR_INPUT\n    a : BOOL;\nVAR_OUTPUT\n    y : BOOL;\nEND_VAR\n",
        expect![[r#"
        > VAR_OUTPUT
          ^^^^^^^^^^ error[bad-declaration]: the declarations above are not closed: END_VAR is missing
            help: a section ends with END_VAR on a line of its own
            fix: Insert END_VAR
              END_VAR
    "#]],
    );
    check(
        "VAR_INPUT\n    a : BOOL;",
        expect![[r#"
        > VAR_INPUT
          ^^^^^^^^^ error[bad-declaration]: the declarations above are not closed: END_VAR is missing
            help: a section ends with END_VAR on a line of its own
            fix: Insert END_VAR
              END_VAR
    "#]],
    );
    check(
        "VAR a : BOOL;\r\n\r\n+--[ ]( a )--( )( y )--+\r\n",
        expect![[r#"
        > +--[ ]( a )--( )( y )--+
          ^ error[bad-declaration]: the declarations above are not closed: END_VAR is missing
            help: a section ends with END_VAR on a line of its own
            fix: Insert END_VAR
              VAR
                  a : BOOL;
              END_VAR
    "#]],
    );
    check(
        "FUNCTION_BLOCK [$X]\nVAR_INPUT\n    r : BOOL;\n+--[ ]( r )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        expect![[r#"
        > +--[ ]( r )--( )( ENO )--+
          ^ error[bad-declaration]: the declarations above are not closed: END_VAR is missing
            help: a section ends with END_VAR on a line of its own
            fix: Insert END_VAR
              END_VAR
    "#]],
    );
    check(
        "VAR\n    a : BOOL;\nFUNCTION_BLOCK [$X]\n+--[ ]( EN )--( )( ENO )--+\n\n",
        expect![[r#"
        > FUNCTION_BLOCK [$X]
          ^^^^^^^^^^^^^^ error[bad-declaration]: the declarations above are not closed: END_VAR is missing
            help: a section ends with END_VAR on a line of its own
            fix: Insert END_VAR
              END_VAR
        > FUNCTION_BLOCK [$X]
          ^^^^^^^^^^^^^^^^^^^ error[bad-declaration]: this block definition is not closed: END_FUNCTION_BLOCK is missing
            help: write END_FUNCTION_BLOCK on a line of its own after the last rung of the block
            fix: Insert END_FUNCTION_BLOCK
              END_FUNCTION_BLOCK
    "#]],
    );
}
