//! What is found in the ladder text of a program is shown where the program itself has it.

use ladder_notations::{Foreign, Source, by_name};
use ladder_syntax::{TextRange, TextSize};

fn read(notation: &str, bytes: &[u8]) -> Foreign {
    let notation = by_name(notation).expect("the notation is registered");
    Foreign::read(notation, &Source::alone("test", bytes)).unwrap_or_else(|error| panic!("{error}"))
}

/// What the first part of the ladder text with this spelling was made from.
fn origin<'f>(foreign: &'f Foreign, spelling: &str) -> &'f str {
    let at = foreign.ladder().find(spelling).expect("it is in the ladder text");
    let range = TextRange::at(TextSize::new(at as u32), TextSize::of(spelling));
    &foreign.text()[foreign.range(range)]
}

#[test]
fn what_something_was_made_from() {
    let foreign = read("textbook", b"start open contact I0.1 &\r\n  active coil Q0 end\n");
    assert_eq!(origin(&foreign, "[ ]( I0 )"), "open contact I0.1");
    assert_eq!(origin(&foreign, "( )( Q0 )"), "active coil Q0");
}

#[test]
fn a_tag_that_is_declared_nowhere_is_where_it_is_used() {
    let foreign = read(
        "ldmicro",
        b"LDmicro0.1\nIO LIST\nEND\nPROGRAM\nRUNG\n    CONTACTS Xa 0\n    COIL Rb 0 0 0\nEND\n",
    );
    assert!(foreign.ladder().contains("Rb : BOOL;"));
    assert_eq!(origin(&foreign, "Rb"), "COIL Rb 0 0 0");
}

#[test]
fn old_encodings() {
    let program =
        b"LDmicro0.1\nIO LIST\nEND\nPROGRAM\nRUNG\n COMMENT T\xfcr\nEND\nRUNG\n    COIL Y\xfc 0 0 0\nEND\n";
    let foreign = read("ldmicro", program);
    assert!(foreign.text().contains("COMMENT Tür"));
    assert_eq!(origin(&foreign, "( )("), "COIL Yü 0 0 0");
}
