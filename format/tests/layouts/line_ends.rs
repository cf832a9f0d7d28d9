//! Line ends, the byte order mark, tabs and the end of the file: what an editor does not show.

use ladder_format::{Options, format_text};

#[track_caller]
fn becomes(text: &str, expected: &str) {
    let options = Options {
        width: 40,
        ..Options::default()
    };
    assert_eq!(format_text(text, &options), expected);
    assert_eq!(format_text(expected, &options), expected);
}

const RUNG: &str = "+--[ ]( a )------------------( )( y )--+";

#[test]
fn each_line_keeps_its_end() {
    becomes(
        "+-[ ]( a )-( )( y )-+  \r\n\r\n \r\n+-[ ]( a )-( )( y )-+\t\r+-[ ]( a )-( )( y )-+\n",
        &format!("{RUNG}\r\n\r\n{RUNG}\r{RUNG}\n"),
    );
}

#[test]
fn a_new_line_end_is_that_of_the_line_it_splits() {
    becomes("# c # +-[ ]( a )-( )( y )-+\r\n", &format!("# c #\r\n{RUNG}\r\n"));
    becomes("+\r# c # +-[ ]( a )-( )( y )-+\n", &format!("+\r# c #\n{RUNG}\n"));
    becomes(
        "VAR a:INT; b:INT; END_VAR\r\n",
        "VAR\r\n    a : INT;\r\n    b : INT;\r\nEND_VAR\r\n",
    );
}

#[test]
fn a_split_last_line_without_an_end_takes_the_one_before() {
    becomes("\r\n# c # +-[ ]( a )-( )( y )-+", &format!("# c #\r\n{RUNG}"));
    becomes("VAR END_VAR", "VAR\nEND_VAR");
}

#[test]
fn the_last_line_keeps_or_lacks_its_end() {
    becomes("+-[ ]( a )-( )( y )-+", RUNG);
    becomes("+-[ ]( a )-( )( y )-+\n\n|\n\t", &format!("{RUNG}\n"));
    becomes("# c #  ", "# c #");
    becomes("VAR END_VAR # c #", "VAR\nEND_VAR  # c #");
}

#[test]
fn nothing_comes_of_nothing() {
    becomes("", "");
    becomes("\n \n\t\r\n", "");
    becomes("|  |\n|", "");
    becomes("\u{feff}", "\u{feff}");
    becomes("\u{feff}\n\n", "\u{feff}");
}

#[test]
fn the_byte_order_mark_stays_first() {
    becomes(
        "\u{feff}\n  +-[ ]( a )-( )( y )-+\n",
        &format!("\u{feff}{RUNG}\n"),
    );
    becomes("\u{feff}   # c #\n", "\u{feff}# c #\n");
    becomes("\u{feff}var end_var\n", "\u{feff}VAR\nEND_VAR\n");
}

#[test]
fn tabs_are_blanks_but_not_in_comments() {
    becomes(
        "\t+--\t[\t]\t(\ta\t)--( )( y )--+\t# a\tb #\n",
        "+--  [ ]( a )----------------( )( y )--+  # a\tb #\n",
    );
}
