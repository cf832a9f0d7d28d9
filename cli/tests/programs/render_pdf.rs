//! `ladder render -o x.pdf`: the document is read back by its structure, with nothing of the writer's.

use crate::harness::{Folder, MOTOR};
use expect_test::expect;
use flate2::read::ZlibDecoder;
use std::collections::BTreeMap;
use std::io::Read;

/// An object: its dictionary, and its stream unpacked.
struct Object {
    dictionary: String,
    stream: Vec<u8>,
}

/// The objects of a document by their numbers, each found where the cross-reference table says.
fn objects(bytes: &[u8]) -> BTreeMap<usize, Object> {
    let text = String::from_utf8_lossy(bytes);
    let number = |text: &str| text.trim().parse::<usize>().expect("a number");
    let (_, at) = text.rsplit_once("startxref").expect("a place of the table");
    let table = &bytes[number(at.trim_end().trim_end_matches("%%EOF"))..];
    let table = String::from_utf8_lossy(table);
    let (table, _) = table.split_once("trailer").expect("a trailer");
    let entries = table.lines().skip(2).enumerate();
    let mut objects = BTreeMap::new();
    for (id, entry) in entries.filter(|(_, entry)| entry.trim_end().ends_with('n')) {
        let object = &bytes[number(&entry[..10])..];
        let head = format!("{id} 0 obj\n");
        assert!(
            object.starts_with(head.as_bytes()),
            "object {id} is not where it should be"
        );
        let text = String::from_utf8_lossy(object);
        let (text, _) = text.split_once("\nendobj").expect("an end");
        let dictionary = text.split("\nstream\n").next().unwrap_or_default().to_owned();
        let mut stream = Vec::new();
        if let Some(at) = object.windows(8).position(|it| it == b"\nstream\n")
            && dictionary.contains("/Length")
        {
            let packed = &object[at + 8..];
            if dictionary.contains("/FlateDecode") {
                ZlibDecoder::new(packed)
                    .read_to_end(&mut stream)
                    .expect("it unpacks");
            } else {
                let (_, length) = dictionary.split_once("/Length ").expect("a length");
                let length = length.split_whitespace().next().map(number).expect("a length");
                stream.extend(&packed[..length]);
            }
        }
        objects.insert(id, Object { dictionary, stream });
    }
    objects
}

/// The object that a dictionary names by a key.
fn named<'o>(objects: &'o BTreeMap<usize, Object>, dictionary: &str, key: &str) -> &'o Object {
    let (_, rest) = dictionary
        .split_once(key)
        .unwrap_or_else(|| panic!("{key} in {dictionary}"));
    let id = rest.trim_start_matches([' ', '[']).split(' ').next();
    &objects[&id.and_then(|id| id.parse().ok()).expect("a number")]
}

/// The letters of a font: what each of its glyphs stands for.
fn letters(objects: &BTreeMap<usize, Object>, font: &Object) -> BTreeMap<u16, char> {
    let map = &named(objects, &font.dictionary, "/ToUnicode ").stream;
    let map = String::from_utf8_lossy(map);
    let pairs = map.lines().filter_map(|line| {
        let (glyph, letter) = line.strip_prefix('<')?.strip_suffix('>')?.split_once("> <")?;
        let glyph = u16::from_str_radix(glyph, 16).ok()?;
        let letter = u32::from_str_radix(letter, 16).ok()?;
        Some((glyph, char::from_u32(letter)?))
    });
    pairs.collect()
}

/// The bytes of a string object.
fn string(text: &[u8]) -> Vec<u8> {
    let hex = |digits: &[u8]| u8::from_str_radix(std::str::from_utf8(digits).unwrap(), 16).unwrap();
    if text.first() == Some(&b'<') {
        return text[1..text.len() - 1].chunks(2).map(hex).collect();
    }
    let mut bytes = Vec::new();
    let mut rest = text[1..text.len() - 1].iter().copied();
    while let Some(byte) = rest.next() {
        let escaped = if byte == b'\\' { rest.next() } else { None };
        bytes.push(match escaped {
            None => byte,
            Some(b'n') => b'\n',
            Some(b'r') => b'\r',
            Some(b't') => b'\t',
            Some(b'b') => 8,
            Some(b'f') => 12,
            Some(digit @ b'0'..=b'7') => {
                let digits = [digit, rest.next().unwrap(), rest.next().unwrap()];
                digits.iter().fold(0, |value, digit| value * 8 + (digit - b'0'))
            }
            Some(other) => other,
        });
    }
    bytes
}

/// The texts of each page, in the order in which they are drawn.
fn pages(bytes: &[u8]) -> Vec<Vec<String>> {
    let objects = objects(bytes);
    let is_page = |object: &&Object| object.dictionary.contains("/Type /Page\n");
    let pages = objects.values().filter(is_page);
    pages
        .map(|page| {
            let content = &named(&objects, &page.dictionary, "/Contents ").stream;
            let mut font = BTreeMap::new();
            let mut texts = Vec::new();
            for line in content.split(|&byte| byte == b'\n') {
                if let Some(name) = line.strip_suffix(b" 13 Tf").or(line.strip_suffix(b" 11 Tf")) {
                    let name = format!("{} ", String::from_utf8_lossy(name));
                    font = letters(&objects, named(&objects, &page.dictionary, &name));
                } else if let Some(shown) = line.strip_suffix(b" Tj") {
                    let glyphs = string(shown);
                    let glyphs = glyphs.chunks(2).map(|it| u16::from_be_bytes([it[0], it[1]]));
                    texts.push(glyphs.map(|glyph| font[&glyph]).collect());
                }
            }
            texts
        })
        .collect()
}

#[test]
fn pages_with_text_that_can_be_read_back() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let run = folder.ladder(&["render", "motor.clad", "-o", "motor.pdf"]);
    expect![[r#"
        exit status 0
    "#]]
    .assert_eq(&run.to_string());
    let bytes = std::fs::read(folder.path("motor.pdf")).unwrap();
    assert!(bytes.starts_with(b"%PDF-1."));
    let pages = pages(&bytes);
    let pages: Vec<String> = pages.iter().map(|texts| texts.join("\n")).collect();
    expect![[r#"
        Declarations
        Tag
        Type
        Address
        Initial value
        Comment
        Without declaration
        start
        BOOL
        input
        stop
        BOOL
        input
        run
        BOOL
        Network 1
        line 1
        start
        stop
        run
        run
        motor
        1 / 2
        motor.clad
        2026-11-26
        -- page --
        Cross-reference
        NETWORK/LINE; S sets, R resets, * reads and writes
        Tag
        Type
        Kind
        Written
        Read
        run
        BOOL
        internal
        1/1
        1/2
        start
        BOOL
        input
        1/1
        stop
        BOOL
        input
        1/1
        motor
        2 / 2
        motor.clad
        2026-11-26"#]]
    .assert_eq(&pages.join("\n-- page --\n"));
}

#[test]
fn letters_are_embedded_and_nothing_depends_on_the_day() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let document = |arguments: &[&str]| {
        let run = folder.ladder(&[&["render", "motor.clad", "-o", "motor.pdf"], arguments].concat());
        assert_eq!(run.status, Some(0), "{run}");
        std::fs::read(folder.path("motor.pdf")).unwrap()
    };
    let bytes = document(&[]);
    assert_eq!(bytes, document(&[]));
    let objects = objects(&bytes);
    let all: Vec<&str> = objects
        .values()
        .map(|object| object.dictionary.as_str())
        .collect();
    let all = all.join("\n");
    assert!(!all.contains("Date"), "{all}");
    assert_eq!(all.matches("/FontFile2 ").count(), 3, "{all}");
    assert_eq!(all.matches("/ToUnicode ").count(), 3, "{all}");
    for font in objects
        .values()
        .filter(|object| object.dictionary.contains("/Length1"))
    {
        assert!(font.stream.starts_with(&[0, 1, 0, 0]), "not a TrueType font");
    }
    assert!(all.contains("/MediaBox [0 0 595.28 841.89]"), "{all}");
    let turned = document(&["--paper", "letter", "--landscape", "--title", "(Pumps)"]);
    assert_eq!(
        pages(&turned)[0].iter().filter(|text| *text == "(Pumps)").count(),
        1
    );
    let turned = String::from_utf8_lossy(&turned).into_owned();
    assert!(turned.contains("/MediaBox [0 0 792 612]"), "{turned}");
}

#[test]
fn a_run_on_paper() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let arguments = [
        "render",
        "motor.clad",
        "-o",
        "motor.pdf",
        "--scans",
        "3",
        "--set",
        "start=1",
    ];
    let run = folder.ladder(&arguments);
    assert_eq!(run.status, Some(0), "{run}");
    let pages = pages(&std::fs::read(folder.path("motor.pdf")).unwrap());
    assert!(pages[0].contains(&"after 3 scans".to_owned()), "{pages:?}");
    assert!(pages[0].contains(&"= 1".to_owned()), "{pages:?}");
}

#[test]
fn a_letter_that_no_built_in_font_has() {
    let folder = Folder::with(&[("level.clad", "+--[ ]( 液位 )--( )( größe )--+\n")]);
    let run = folder.ladder(&["render", "level.clad", "-o", "level.pdf"]);
    expect![[r#"
        exit status 0
        -- stderr
        warning: level.clad: the built-in font has no letters for 位液: a PDF shows a mark in their place, an SVG has them from its reader's fonts
    "#]].assert_eq(&run.to_string());
    let bytes = std::fs::read(folder.path("level.pdf")).unwrap();
    let pages = pages(&bytes);
    assert!(pages[0].contains(&"größe".to_owned()), "{pages:?}");
    assert!(pages[0].contains(&"\u{fffd}\u{fffd}".to_owned()), "{pages:?}");
    // A reader who copies the text gets what was written.
    let content = objects(&bytes);
    let whole = content
        .values()
        .map(|object| String::from_utf8_lossy(&object.stream));
    assert!(whole.into_iter().any(|it| it.contains("/ActualText")));
}

#[test]
fn the_title_block_is_the_projects() {
    let folder = Folder::with(&[
        ("motor.clad", MOTOR),
        (
            "ladder.toml",
            "[project]\nname = \"Pumping station\"\nversion = \"1.2\"\n",
        ),
    ]);
    let run = folder.ladder(&["render", "motor.clad", "-o", "motor.pdf"]);
    assert_eq!(run.status, Some(0), "{run}");
    let bytes = std::fs::read(folder.path("motor.pdf")).unwrap();
    let page = pages(&bytes).remove(0);
    let foot = page.iter().skip_while(|text| *text != "1 / 2");
    expect![[r#"
        1 / 2
        Pumping station
        Version 1.2
        motor.clad
        2026-11-26"#]]
    .assert_eq(&foot.cloned().collect::<Vec<_>>().join("\n"));
}
