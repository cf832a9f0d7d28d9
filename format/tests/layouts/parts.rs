//! A large file is formatted part by part; a plain block is read off its text. Neither shows.

use ladder_format::{Options, apply, format, format_ranges, format_text};
use ladder_syntax::{TextRange, TextSize, parse};

/// Checks that the parts of a text come out as the text as a whole does, and returns that.
#[track_caller]
fn check(text: &str) -> String {
    let options = Options::default();
    let new = format_text(text, &options);
    let read = parse(text);
    let everything = TextRange::up_to(TextSize::of(text));
    // Ranges are formatted with the whole file at hand.
    let at_once = apply(text, &format_ranges(&read, &options, &[everything]));
    assert!(new == at_once, "parts differ from the whole");
    assert!(
        apply(text, &format(&read, &options)) == new,
        "edits differ from the text"
    );
    assert!(
        format_text(&new, &options) == new,
        "a second time changes something"
    );
    new
}

/// So many lines are several parts.
const MANY: usize = 5000;

#[test]
fn networks_and_sections() {
    let mut text = String::new();
    for n in 0..MANY {
        text.push_str(match n % 7 {
            0 => "VAR\na:INT;long_name :BOOL;\nEND_VAR\n",
            1 => "+--\\--[ ](a)--\\--( )( y )--+\n\n   /--[ ]( b )--/\n\n",
            2 => "# a comment #\n|\n|\n",
            3 => "FUNCTION_BLOCK [$B]\nVAR_INPUT a:BOOL; END_VAR\n+--[ ](en)--( )( eno )--+\n\n+--[ ]( a)--( )( eno )--+\nEND_FUNCTION_BLOCK\n",
            4 => "+-[TON](t,T#5s)-( )(y)-+ # after #\n",
            5 => "+--[ ]( x )--\n\n\n\n",
            _ => "+--[ ( broken )--+\n+-[ ]( en )-( )( eno )-+\n",
        });
    }
    let new = check(&text);
    assert!(new.contains("+--[ ]( EN )"), "a body in a later part");
    assert!(new.contains("+--[ ]( en )"), "a program in a later part");
}

#[test]
fn switched_off_over_parts() {
    let rung = "+-[ ](a)-( )(y)-+\n";
    let text = format!(
        "{}# ladder: fmt off #\n{}# ladder: fmt on #\n{}",
        rung.repeat(MANY),
        rung.repeat(MANY),
        rung.repeat(MANY)
    );
    let new = check(&text);
    assert_eq!(new.matches(rung).count(), MANY);
}

/// Where the comment that is never closed is reported decides from where on nothing is formatted.
#[test]
fn a_comment_that_is_never_closed() {
    let rung = "+-[ ](a)-( )(y)-+\n";
    let text = format!(
        "{}# one too many\n{}+-[ ](a)-+ # #\n",
        rung.repeat(MANY),
        rung.repeat(MANY)
    );
    let new = check(&text);
    assert_eq!(new.matches("+-[ ](a)").count(), MANY + 1);
}

#[test]
fn one_part_that_is_large() {
    // A chain of rungs has no place where it could be cut.
    let mut text = String::from("+--\\--[ ](a)--( )( y )--+\n");
    for _ in 0..MANY {
        text.push_str("/-[ ](b)--\\--( )(y)--+\n+-\\--[ ](c)--/\n");
    }
    text.push_str("/--[ ](d)\n");
    check(&text);
}

/// A mnemonic in small letters makes that a block is not plain; it comes out in capitals.
#[test]
fn plain_blocks_come_out_as_others() {
    let operands = [
        "",
        " ",
        "a",
        "a,b",
        " a , b ",
        "a,-5",
        "t1.Q,T#5s",
        "a ,\t16#FF",
        "a,  2.5,x_1 ",
        "5",
        "-5 , 5s",
    ];
    for blank in ["", " ", "\t "] {
        for operands in operands {
            for mnemonic in ["TON", "ADD", "GT", "NOT", "OSR", "UNKNOWN_"] {
                let block = |word: &str| {
                    format!("+--[ ]( x )--[{blank}{word}{blank}]{blank}({operands})--( )( y )--+\n")
                };
                let options = Options::default();
                let small = format_text(&block(&mnemonic.to_ascii_lowercase()), &options);
                let expected = small.replace("unknown_", "UNKNOWN_");
                assert_eq!(format_text(&block(mnemonic), &options), expected);
            }
        }
    }
}
