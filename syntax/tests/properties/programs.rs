//! Programs without errors, to be spoiled by the properties.

/// Each uses another part of the language.
pub(crate) const PROGRAMS: [&str; 7] = [
    "\
TYPE
    Phase : (IDLE, FILLING, MIXING := 10) := FILLING; # steps #
    Motor : STRUCT
        speed, limit : REAL := 50.0; # rpm #
        delay : TON; on : ARRAY[1..3, 0..n] OF ARRAY[1..2] OF INT(0..9);
    END_STRUCT := (speed := 20.0,
        on := [1, 2(3)]);
END_TYPE
VAR pump : Motor := (on := [6(1)]); m : $Drive; END_VAR

+--[EQ]( step, Phase.FILLING )--[MOV]( pump.on[i + 1, 2][k], pump.on[1, 0..2] )--+
",
    "\
# Start/stop with a seal-in contact #
+--\\--[ ]( start )--\\--[/]( stop )-------------( )( run )--+
|  |                |                                      |
|  /--[ ]( run )----/                                      |

+--[ ]( run )---------[TON]( warmup, T#5s )--( )( ready )--+
",
    "\
VAR_INPUT RETAIN
    start, stop AT %IX0.3 : BOOL; # the panel #
    level : INT := -5;
    text
        : STRING[80]
        := 'it$'s # not a comment';
    a : ARRAY[1..100] OF INT := [1, 2, 98(0)];
END_VAR
VAR_OUTPUT  run : BOOL;  END_VAR

+--[GE]( level, 16#FF )--[MOV]( a[level], a[3] )--(S)( run )--+
",
    "\
FUNCTION_BLOCK [$Debounce]
VAR_INPUT   raw : BOOL;  wait : TIME;  END_VAR
VAR_OUTPUT  clean : BOOL;  END_VAR
VAR         t : TON;  END_VAR
+--[ ]( EN )--[ ]( raw )--[TON]( t, wait )--( )( clean )--( )( ENO )--+
END_FUNCTION_BLOCK

+--[$Debounce]( button, T#20ms, clean => pressed )--( )( light )--+
",
    "\
+--\\--[ ]( a )--\\-----\\--[ ]( c )--\\--( )( y )--+\r
|  /--[ ]( b )--/     /--[ ]( d )--/            |\r
\r
+--\\-----\\--[ ]( a )--\\-----\\--( )( y )--+\r
|  /--\\  /--[ ]( b )--/  \\--/            |\r
|     /--[ ]( c )--------/               |\r
",
    "\
+--[CALC]( y, (a + b * SQRT(c[i + 1])) ^ 2 / -d MOD 7 )--[CALC]( ok, NOT (x AND y) OR t1.Q )--+
+--[SEARCH]( y, GE, word.3, t[1..9], NEXT := TRUE, FOUND => hit )--( )( z )--+
+--[PWL]( y, x, 0, 0, 1.5e-3, 10, 2#1010, T#1h30m )--<JMP>( again )--<RET>--+
",
    "\
+--[ ]( a )--# in the
wire #--( )( y )--+  # after #
+--# c ## d #--[P]( öl )--(/)( 温度 )--+
   # alone #
|  |
+--<LBL>( l )--[OSR]--(R)( %QX1.7 )--+",
];
