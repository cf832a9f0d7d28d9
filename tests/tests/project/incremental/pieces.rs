//! The files that are edited, and what edits put in.

/// What a hand puts in.
pub(super) const PIECES: [&str; 50] = [
    "\n<<<<<<< a\n",
    "\n=======\n",
    "\n>>>>>>> b\n",
    "",
    "",
    "",
    "",
    "\\",
    "/",
    "-",
    "--",
    "+",
    "|",
    " ",
    "\n",
    "(",
    ")",
    "[",
    "]",
    "<",
    ">",
    "#",
    "# note #",
    ",",
    ":=",
    ";",
    "'",
    "a",
    "5",
    "T#5s",
    "é",
    "\r\n",
    "END_VAR\n",
    "VAR\n",
    "VAR\n    b : INT;\nEND_VAR\n",
    "FUNCTION_BLOCK [$F]\n",
    "END_FUNCTION_BLOCK\n",
    "+--[ ]( a )--( )( b )--+\n",
    "+--<FUN>( f )--+\n",
    "+--<LBL>( l )--+\n",
    "--<CALL>( f )--",
    "--[$F]( a )--",
    "# ladder: allow(never-read) #\n",
    "# ladder: allow-file(double-coil) #\n",
    "# ladder: profile ldmicro #\n",
    "VAR CONSTANT\n    n : INT := 5;\nEND_VAR\n",
    "[GT]( n, 5 )--",
    "[ ]( a )--[/]( a )--",
    "+--<MCR>--+\n",
    "+--\\--[ ]( a )--\\--( )( b )--+\n|  /--[ ]( A )--/\n",
];

/// Words of declarations, to be exchanged for each other.
pub(super) const WORDS: [&str; 12] = [
    "BOOL",
    "INT",
    "DINT",
    "REAL",
    "TIME",
    "STRING",
    "TON",
    "CTU",
    "RETAIN",
    "CONSTANT",
    "VAR_INPUT",
    "VAR_OUTPUT",
];

/// Declarations, definitions and comments.
pub(super) const OTHERS: &[&str] = &[
    "VAR TOM : BOOL; END_VAR\n",
    "VAR n : INT; END_VAR\n",
    "VAR t : TON; END_VAR\n",
    "VAR_INPUT a, x : BOOL; END_VAR\n",
    "VAR_OUTPUT y : BOOL; END_VAR\n",
    "VAR CONSTANT k : INT := 0; END_VAR\n",
    "VAR arr : ARRAY[1..5] OF BOOL; END_VAR\n",
    "VAR w AT %IW0 : INT; END_VAR\n",
    "VAR RETAIN n : DINT; END_VAR\n",
    "VAR_GLOBAL g : BOOL; END_VAR\n",
    "VAR_EXTERNAL g : BOOL; END_VAR\n",
    "FUNCTION_BLOCK [$F]\nVAR_INPUT a : BOOL; END_VAR\n+--[ ]( a )--( )( n )--+\nEND_FUNCTION_BLOCK\n",
    "FUNCTION_BLOCK [$F]\nVAR_INPUT a : BOOL; b : INT := 1; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\n\
     +--[ ]( a )--( )( q )--+\n+--<END>--+\nEND_FUNCTION_BLOCK\n",
    "FUNCTION_BLOCK <$G>\nVAR_INPUT a : BOOL; END_VAR\n+--[ ]( a )--<JMP>( l )--+\nEND_FUNCTION_BLOCK\n",
    "FUNCTION_BLOCK ($F)\nVAR_INPUT a : BOOL; END_VAR\n+--[ ]( a )--($F)( a )--+\nEND_FUNCTION_BLOCK\n",
    "# ladder: allow(double-coil): x #\n",
    "# ladder: profile click #\n",
    "# ladder: profile iot #\n",
    "# ladder: cycle 5ms #\n",
    "# +--[ ]( a )--( )( b )--+ #\n",
    "// text\n",
    "# note #\n",
];

/// Networks, without the blank line after them.
pub(super) const NETWORKS: &[&str] = &[
    "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[/]( a )--/",
    "+--[ ]( x )--<MCR>--+",
    "+--[TON]( t, T#7ms )--( )( z )--+",
    "+--[TOM]--( )( y )--+",
    "+--[ ]( TOM )--( )( b )--+",
    "+--[ ]( n )--( )( z )--+",
    "+--[GT]( n, 5 )--( )( z )--+",
    "+--[$F]( x )--( )( y )--+",
    "+--[$F]( x, q => y )--+",
    "+--[$F]( a := x, q := y )--+",
    "+--<$G>( x )--+",
    "+--[TON]( t, 5s )--( )( y )--+",
    "+--[TON]( t, 5ms )--( )( y )--+",
    "+--[ ]( t.Q )--( )( y )--+",
    "+--[ ]( t )--( )( z )--+",
    "+--[CTU]( t, 5 )--( )( y )--+",
    "+--[ ]( a )--(S)( y )--+",
    "+--[ ]( x )--(R)( y )--+",
    "+--[ ]( a )--[/]( a )--( )( y )--+",
    "+--<FUN>( f )--+",
    "+--[ ]( x )--<CALL>( f )--+",
    "+--<LBL>( l )--+",
    "+--[ ]( x )--<JMP>( l )--+",
    "+--<JMP>( l )--+",
    "+--<RET>--+",
    "+--<END>--+",
    "+--<FOR>( n, 1, 3 )--+",
    "+--<NEXT>--+",
    "+--<MCR>--+",
    "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( x )--/",
    "+--\\--[ ]( a )--\\--( )( y )--+\n|  /-----------/",
    "+--[ ]( a )--\\--( )( y )--+",
    "+--[ ]( x )--|--( )( z )--+",
    "|--[ ]( x )--( )( z )--+",
    "+--[DIV]( n, n, k )--+",
    "+--[MOV]( n, 70000 )--+",
    "+--[MOV]( w, n )--+",
    "+--[ ]( %IX0.1 )--( )( %QX0.1 )--+",
    "+--[ ]( arr[i] )--( )( z )--+",
    "+--[ ]( arr[3] )--( )( arr[9] )--+",
    "+--[ ]( undecl[2] )--( )( z )--+",
    "+--[ ]( tom )--( )( zz )--+",
    "+--[ ]( g )--( )( g )--+",
    "+--[EQ]( r, 0.1 )--( )( y )--+",
    "+--[CALC]( n, -n ^ 2 )--+",
    "+--[CALC]( r, 1.5 )--+",
    "+--[ADD]( n, n, 1 )--+",
    "+--[MOV]( d, T#5s )--+",
    "+--[MOV]( n, d )--+",
    "+--[ ]( n.3 )--( )( z )--+",
    "+--[ ]( q.Q )--( )( z )--+",
    "+--[TP]( q, 1s )--+",
    "+--[SET]( y, 1 )--+",
    "+--[ ]( y )--( )( x )--+",
    "+--[ ]( x )--( )( y )--[ ]( a )--( )( z )--+",
    "+--[ ]( a )--(M)( m )--+",
    "+--[PERSIST]( n )--+",
    "+--(RES)( t )--+",
    "+--[P]( a )--( )( y )--+",
    "+--[SR]( s )--+",
    "+--[ ]( start )--( )( stopp )--+",
    "+--[ ]( stop )--( )( start )--+",
    "+--[ ]( SYS.FIRST_SCAN )--( )( y )--+",
    "+--[ ]( x )--( )( SYS.ON )--+",
    "+--[MUX]( n, k, 1, 2 )--+",
    "+--[ ]( x )--",
    "+--[ ]( x )--( )( y )--( )( y )--+",
];

pub(super) const MAIN: &str = "\
VAR_INPUT go : BOOL; END_VAR
VAR_OUTPUT lamp : BOOL; END_VAR
VAR t : TON; END_VAR

+--[ ]( go )--<CALL>( count )--+

+--[$Hold]( go, lamp )--[GT]( total, 3 )--( )( alarm )--+

+--[ ]( alarm )--[TON]( t, T#1s )--( )( reset )--+

+--[ ]( go )--[/]( alarm )--(S)( latched )--+
";

pub(super) const LIBRARY: &str = "\
VAR_GLOBAL total : DINT; alarm, latched : BOOL; END_VAR

+--[ ]( SYS.ON )--[MOV]( 0, total )--+

+--[ ]( reset )--(R)( latched )--+

+--<FUN>( count )--[ADD]( total, total, 1 )--+

FUNCTION_BLOCK [$Hold]
VAR_INPUT a : BOOL; END_VAR
VAR_OUTPUT q : BOOL; END_VAR
VAR_EXTERNAL total : DINT; END_VAR
+--[ ]( a )--[GT]( total, 5 )--(S)( q )--+
END_FUNCTION_BLOCK
";

pub(super) const GLOBALS: &str = "\
VAR_GLOBAL reset : BOOL; total : INT; END_VAR
VAR_GLOBAL CONSTANT most : DINT := 5; END_VAR

+--[ ]( first )--( )( second )--+

+--[GT]( total, most )--(R)( latched )--+
";

/// What a hand puts in that concerns other files.
pub(super) const SEEN: [&str; 12] = [
    "VAR_GLOBAL alarm : BOOL; END_VAR\n",
    "VAR_GLOBAL go : BOOL; END_VAR\n",
    "VAR_EXTERNAL total : DINT; END_VAR\n",
    "VAR_EXTERNAL reset : INT; END_VAR\n",
    "+--[ ]( alarm )--( )( reset )--+\n",
    "+--<CALL>( count )--+\n",
    "+--<FUN>( count )--+\n",
    "+--[$Hold]( reset, alarm )--+\n",
    "+--[ ]( latched )--[/]( latched )--( )( lamp )--+\n",
    "FUNCTION_BLOCK [$Hold]\nVAR_INPUT a : INT; END_VAR\n+--[ ]( EN )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
    "+--[MOV]( 7, total )--+\n",
    "T",
];
