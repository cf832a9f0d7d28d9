//! Pages of programs. `UPDATE_EXPECT=1 cargo test -p ladder-picture` writes them again; look at them, as
//! `ladder render -o x.pdf` draws them, before you keep them.

use expect_test::{expect, expect_file};
use ladder_analysis::analyze;
use ladder_picture::picture;
use ladder_picture::shapes::{Extent, Form};
use ladder_picture::sheet::{Options, Orientation, Piece, Sheet, Size, sheets};
use ladder_picture::style::Look;
use ladder_syntax::parse;
use std::sync::Arc;

fn pages(text: &str, options: &Options<'_>) -> Vec<Sheet> {
    let analysis = analyze(&Arc::new(parse(text)), "program");
    let picture = picture(&analysis.context, &ladder_picture::Options::default());
    sheets(&analysis.context, &picture, options)
}

/// The pages before the cross-reference.
fn drawn(text: &str, options: &Options<'_>) -> Vec<Sheet> {
    let all = pages(text, options).into_iter();
    all.take_while(|sheet| !texts(sheet).contains("\nCross-reference\n"))
        .collect()
}

const A4: Options<'_> = Options {
    size: Size::A4,
    orientation: Orientation::Portrait,
    title: "program",
    note: "",
    block: &[],
};

/// Where a pixel of a piece is on its page, in points.
fn on_page(piece: &Piece, (x, y): (i32, i32)) -> (f32, f32) {
    let Piece {
        at, scale, window, ..
    } = piece;
    (
        at.0 + (x - window.left) as f32 * scale,
        at.1 + (y - window.top) as f32 * scale,
    )
}

/// The texts of a page from top to bottom and from left to right, those of a line on one line.
fn texts(sheet: &Sheet) -> String {
    let mut texts = Vec::new();
    for piece in &sheet.pieces {
        for shape in &piece.shapes {
            if let Form::Text { at, text, .. } = &shape.form {
                let (x, y) = on_page(piece, *at);
                texts.push((y.round() as i32, x, text.as_str()));
            }
        }
    }
    texts.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut out = String::new();
    let mut line = None;
    for (y, _, text) in texts {
        out.push_str(match line.replace(y) {
            None => "",
            Some(before) if before == y => "  ",
            Some(_) => "\n",
        });
        out.push_str(text);
    }
    out + "\n"
}

fn all(sheets: &[Sheet]) -> String {
    let pages: Vec<String> = sheets.iter().map(texts).collect();
    pages.join("-- page --\n")
}

/// Everything lies on its page, and no piece on another.
fn check(sheets: &[Sheet]) {
    for sheet in sheets {
        let mut pieces: Vec<(f32, f32)> = Vec::new();
        for piece in &sheet.pieces {
            let Extent { right, bottom, .. } = piece.window;
            let (x, y) = on_page(piece, (right, bottom));
            assert!(piece.at.0 >= 0.0 && x <= sheet.width, "{:?} to {x}", piece.at);
            assert!(piece.at.1 >= 0.0 && y <= sheet.height, "{:?} to {y}", piece.at);
            assert!(piece.scale >= 0.4, "nobody can read {}", piece.scale);
            pieces.push((piece.at.1, y));
        }
        pieces.sort_by(|a, b| a.0.total_cmp(&b.0));
        for pair in pieces.windows(2) {
            assert!(pair[0].1 <= pair[1].0 + 0.01, "{pair:?}");
        }
    }
}

/// How often a text is on the pages where it can be seen whole.
fn seen(sheets: &[Sheet], text: &str) -> usize {
    let pieces = sheets.iter().flat_map(|sheet| &sheet.pieces);
    let shapes = pieces.flat_map(|piece| piece.shapes.iter().map(move |shape| (piece, shape)));
    shapes
        .filter(|(_, shape)| matches!(&shape.form, Form::Text { text: it, .. } if it == text))
        .filter(|(piece, shape)| {
            let (it, window) = (shape.extent(), piece.window);
            it.left >= window.left
                && it.right <= window.right
                && it.top >= window.top
                && it.bottom <= window.bottom
        })
        .count()
}

#[test]
fn a_program_on_paper() {
    let text = include_str!("sheets/program.clad");
    let sheets = pages(
        text,
        &Options {
            note: "after 3 scans",
            ..A4
        },
    );
    check(&sheets);
    expect_file!["sheets/program.txt"].assert_eq(&all(&sheets));
}

#[test]
fn sizes_and_orientations() {
    let size = |size, orientation| {
        let options = Options {
            size,
            orientation,
            ..A4
        };
        let sheet = &pages("+--[ ]( a )--( )( y )--+\n", &options)[0];
        (sheet.width, sheet.height)
    };
    assert_eq!(size(Size::A4, Orientation::Portrait), (595.28, 841.89));
    assert_eq!(size(Size::A4, Orientation::Landscape), (841.89, 595.28));
    assert_eq!(size(Size::Letter, Orientation::Portrait), (612.0, 792.0));
    assert_eq!(size(Size::Letter, Orientation::Landscape), (792.0, 612.0));
}

#[test]
fn a_file_with_nothing_in_it_has_a_page() {
    let sheets = pages("", &A4);
    expect![[r#"
        program
        1 / 1
    "#]]
    .assert_eq(&all(&sheets));
}

#[test]
fn a_page_breaks_between_networks() {
    let network = "# a title #\n+--\\--[ ]( a )--\\--( )( y )--+\n   /--[ ]( b )--/\n\n";
    let sheets = drawn(&network.repeat(40), &A4);
    check(&sheets);
    assert!(sheets.len() > 2);
    for (number, sheet) in sheets.iter().enumerate() {
        let page = std::slice::from_ref(sheet);
        // The first page has the tags in a table too.
        let in_table = usize::from(number == 0);
        assert_eq!(seen(page, "a"), seen(page, "b"));
        assert_eq!(seen(page, "a title") + in_table, seen(page, "y"));
    }
    assert_eq!(seen(&sheets, "Network 40"), 1);
}

#[test]
fn a_network_higher_than_a_page_is_cut_between_rungs() {
    let mut text = "+--\\--[ ]( a0 )--\\--( )( y )--+\n".to_owned();
    for branch in 1..80 {
        text += &format!("   /--\\--[ ]( a{branch} )--\\--/\n");
    }
    text += "   /--[ ]( last )--/\n";
    let sheets = drawn(&text, &A4);
    check(&sheets);
    for branch in 0..80 {
        // Once in the list of tags, once in the network.
        assert_eq!(seen(&sheets, &format!("a{branch}")), 2, "a{branch}");
    }
    let texts = all(&sheets);
    assert!(texts.contains("Network 1, part 2 of "), "{texts}");
}

#[test]
fn a_box_higher_than_a_page_is_cut_between_its_rows() {
    let operands: Vec<String> = (0..200).map(|n| format!("v{n}")).collect();
    let sheets = drawn(&format!("+--[ADD]( y, {} )--+\n", operands.join(", ")), &A4);
    check(&sheets);
    for operand in operands {
        // Once in the list of tags, once in the box.
        assert_eq!(seen(&sheets, &operand), 2, "{operand}");
    }
}

#[test]
fn a_network_wider_than_a_page_is_cut_through_its_wires() {
    let rung = |name: &str, from: &str, to: &str| {
        let contacts: Vec<String> = (0..25)
            .map(|n| format!("{from}--[ ]( {name}_contact_{n} )--{to}"))
            .collect();
        contacts.join("--")
    };
    let below = rung("lower", "/", "/").replace("/--/", "/  /");
    let text = format!("+--{}--( )( y )--+\n   {below}\n", rung("upper", "\\", "\\"));
    let sheets = drawn(&text, &A4);
    check(&sheets);
    for contact in 0..25 {
        for name in ["upper", "lower"] {
            let name = format!("{name}_contact_{contact}");
            assert_eq!(seen(&sheets, &name), 2, "{name}");
        }
    }
    let parts = sheets.iter().map(texts).collect::<String>();
    assert!(parts.contains("Network 1, part 2 of "), "{parts}");
    // Both wires, at both ends.
    for number in ["1", "2"] {
        assert_eq!(seen(&sheets, &format!("→ {number}")), 1);
        assert_eq!(seen(&sheets, &format!("{number} →")), 1);
    }
}

#[test]
fn a_high_network_is_made_smaller_as_long_as_it_can_be_read() {
    let mut text = "+--\\--[ ]( a )--\\--( )( y )--+\n".to_owned();
    text += &"   /--\\--[ ]( b )--\\--/\n".repeat(28);
    text += "   /--[ ]( last )--/\n";
    let sheets = drawn(&text, &A4);
    check(&sheets);
    let piece = sheets
        .iter()
        .flat_map(|sheet| &sheet.pieces)
        .max_by_key(|piece| piece.shapes.len());
    let piece = piece.expect("there is a network");
    assert!((0.42..0.62).contains(&piece.scale), "{}", piece.scale);
    assert_eq!(seen(&sheets, "Network 1"), 1);
}

#[test]
fn a_network_with_an_error_is_text_on_paper_too() {
    let sheets = drawn("+--[ ]( a --( )( b )--+\n", &A4);
    check(&sheets);
    assert_eq!(seen(&sheets, "+--[ ]( a --( )( b )--+"), 1);
}

#[test]
fn networks_take_the_whole_width_of_a_page() {
    let analysis = analyze(&Arc::new(parse("+--[ ]( a )--( )( y )--+\n")), "program");
    for orientation in [Orientation::Portrait, Orientation::Landscape] {
        let options = Options { orientation, ..A4 };
        let drawn = ladder_picture::Options {
            rail: Some(options.rail()),
            ..ladder_picture::Options::default()
        };
        let sheet = &sheets(&analysis.context, &picture(&analysis.context, &drawn), &options)[0];
        let rails = sheet.pieces.iter().flat_map(|piece| {
            let rails = piece.shapes.iter().filter(|shape| shape.look == Look::Rail);
            rails.map(|rail| on_page(piece, (rail.extent().left, 0)).0)
        });
        let right = rails.fold(0.0, f32::max);
        // The blank on both sides is 42 points.
        assert!(
            (sheet.width - 42.0 - 12.0..=sheet.width - 42.0).contains(&right),
            "{right} of {}",
            sheet.width
        );
    }
}

#[test]
fn a_network_of_very_many_pages_is_not_drawn() {
    let stairs = "   /--[ ]( a )--\\--( )( y )--+\n".repeat(3000);
    let text = format!("+--\\--( )( y )--+\n{stairs}   /--( )( y )--+\n+--[ ]( y )--( )( z )--+\n");
    let sheets = drawn(&text, &A4);
    assert!(sheets.len() < 10, "{} pages", sheets.len());
    assert!(texts(&sheets[0]).contains("pages, and that of a network has at most 400."));
    let long = format!("+--[ADD]( y{} )--+\n", ", a".repeat(20_000));
    assert!(drawn(&long, &A4).len() < 400);
}
