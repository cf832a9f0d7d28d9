//! The drawings by which the language is explained.

use ladder_format::{Options, format_text};

#[track_caller]
fn stays(text: &str) {
    assert_eq!(format_text(text, &Options::default()), text);
}

#[test]
fn canonical() {
    stays(
        r"+--[ ]( a )--\--[ ]( b )-----\-------------------( )( y )--+
|            /--[/]( x )--\--/                             |
+--[ ]( c )---------------/--[ ]( d )------------( )( z )--+

+--[ ]( a )--\--------------------------------( )( y )--\--+
|            /-----------------------( )( valve_open )--/  |

+--\--[ ]( a )--# was: b #--\--[/]( stop )-------( )( y )--+  # main pump #
|  /--[ ]( y )--------------/                              |  # seal-in #
",
    );
}

#[test]
fn start_stop() {
    stays(
        r"# Start/stop with a seal-in contact #
+--\--[ ]( start )--\--[/]( stop )-------------( )( run )--+
|  |                |                                      |
|  /--[ ]( run )----/                                      |

+--[ ]( run )---------[TON]( warmup, T#5s )--( )( ready )--+
",
    );
}
