//! How fast a file is formatted, in bytes of text a second: as one types it, and when it is in form already.

use divan::Bencher;
use divan::counter::BytesCount;
use ladder_format::{Options, format, format_text};
use ladder_syntax::parse;

fn main() {
    divan::main();
}

const SIZE: usize = 1_000_000;

/// Parse, layout and new text, from a file that is crooked everywhere.
#[divan::bench]
fn crooked_text(bencher: Bencher<'_, '_>) {
    let text = program(SIZE);
    bencher
        .counter(BytesCount::of_str(&text))
        .bench(|| format_text(&text, &Options::default()));
}

/// The same for a file that is in form: nothing changes.
#[divan::bench]
fn canonical_text(bencher: Bencher<'_, '_>) {
    let text = format_text(&program(SIZE), &Options::default());
    bencher
        .counter(BytesCount::of_str(&text))
        .bench(|| format_text(&text, &Options::default()));
}

/// Layout alone: edits for a crooked file whose parse is there.
#[divan::bench]
fn edits_of_crooked_parse(bencher: Bencher<'_, '_>) {
    let text = program(SIZE);
    let parse = parse(&text);
    bencher
        .counter(BytesCount::of_str(&text))
        .bench(|| format(&parse, &Options::default()));
}

/// Layout alone: that a parsed file is in form.
#[divan::bench]
fn edits_of_canonical_parse(bencher: Bencher<'_, '_>) {
    let text = format_text(&program(SIZE), &Options::default());
    let parse = parse(&text);
    bencher
        .counter(BytesCount::of_str(&text))
        .bench(|| format(&parse, &Options::default()));
}

/// Parsing alone, to see what of the above it is.
#[divan::bench]
fn parse_alone(bencher: Bencher<'_, '_>) {
    let text = format_text(&program(SIZE), &Options::default());
    bencher.counter(BytesCount::of_str(&text)).bench(|| parse(&text));
}

/// One network of very many rungs, each tied to the next; time must grow with the size and not faster.
#[divan::bench(args = [1_000, 10_000])]
fn long_network(bencher: Bencher<'_, '_>, rungs: usize) {
    // To and fro, so that the drawing stays narrow: a staircase of so many rungs would be all blanks.
    let mut text = String::from("+--\\--[ ]( a0 )--( )( y )--+\n");
    for rung in 1..rungs {
        if rung % 2 == 1 {
            text.push_str(&format!("/-[ ]( a{rung} )--\\--( )( y{rung} )--+\n"));
        } else {
            text.push_str(&format!("+-\\--[ ]( a{rung} )--/\n"));
        }
    }
    text.push_str("/--[ ]( last )\n");
    bencher
        .counter(BytesCount::of_str(&text))
        .bench(|| format_text(&text, &Options::default()));
}

/// One rung of very many elements.
#[divan::bench(args = [1_000, 10_000])]
fn long_rung(bencher: Bencher<'_, '_>, elements: usize) {
    let text = format!("+-{}-( )( y )-+\n", "[ ]( a )- -[/](b)".repeat(elements / 2));
    bencher
        .counter(BytesCount::of_str(&text))
        .bench(|| format_text(&text, &Options::default()));
}

/// A crooked program of about this many bytes: sections, single rungs, branches, timers, comments. Always the
/// same one.
fn program(size: usize) -> String {
    let mut text = String::with_capacity(size + 1000);
    let mut state = 1u32;
    let mut choose = move |n: u32| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) % n
    };
    let contacts = [
        "[ ](start)",
        "[/]( stop_button )",
        "[ ]( level_high)",
        "[GT](level,-5)",
        "[P]( edge )",
        "[ ]( t1 . Q )",
    ];
    let coils = [
        "( )( run)",
        "(S)(alarm)",
        "[TON]( t1,T#5s )",
        "[ADD](total, total,n)",
        "[calc]( y,a+b*-c )",
    ];
    let mut number = 0;
    while text.len() < size {
        number += 1;
        let mut contact = || contacts[choose(6) as usize];
        let (a, b, c) = (contact(), contact(), contact());
        let coil = coils[choose(5) as usize];
        match choose(10) {
            0 => text.push_str(&format!("VAR\nlevel_{number} :INT:=5; start_{number},stop_{number} : bool;\nEND_VAR\n\n")),
            1 => text.push_str(&format!("# what the rung below does, number {number} #\n")),
            2..=4 => text.push_str(&format!("+--{a}-{b}--{coil}--+\n\n")),
            5 => text.push_str(&format!("+--{a}--{b}--{c}----{coil}--+ # after #\n")),
            6 | 7 => text.push_str(&format!("+--\\--{a}--\\--{b}---{coil}--+\n|  /--{c}--/\n\n")),
            8 => text.push_str(&format!("+--\\--{a}--\\--\\--{b}--\\--{coil}--+\n|  /--{c}--/  /--{a}--/      |\n\n")),
            _ => text.push_str(&format!(
                "+--\\--{a}--\\--\\--{coil}--\\--+\n|  |   |\n   /--\\--{b}--/  /--( )( z )--/ |\n    /--{c}--\\\n /--( )( w )--+\n\n"
            )),
        }
    }
    text
}
