//! Files that were made to break what reads them: all of them are refused, or read within bounds of size and depth.

use ladder_format::Options;
use ladder_notations::{NOTATIONS, Source, by_name, convert};

/// The reason for which a notation refuses a file; or how long the ladder text is.
#[track_caller]
fn read(notation: &str, bytes: &[u8]) -> Result<usize, String> {
    let notation = by_name(notation).expect("the notation is registered");
    let source = Source::alone("test", bytes);
    match convert(notation, &source, &Options::default()) {
        Ok(converted) => Ok(converted.written.text.len()),
        Err(error) => Err(error.to_string()),
    }
}

fn ldmicro(rungs: &str) -> Result<usize, String> {
    read("ldmicro", format!("LDmicro0.1\nPROGRAM\n{rungs}").as_bytes())
}

/// A text of LDmicro's with these lines between its rails.
fn drawing(lines: &[String]) -> Result<usize, String> {
    let mut text = "LDmicro export text\nno MCU assigned, 4.000000 MHz crystal, 10.0 ms cycle time\n\nLADDER DIAGRAM:\n\n".to_owned();
    for (number, line) in lines.iter().enumerate() {
        let before = if number == 1 { " 1 " } else { "   " };
        text.push_str(&format!("{before}||{line}||\n"));
    }
    read("ldmicro-text", text.as_bytes())
}

#[test]
fn branches_nested_a_hundred_thousand_deep() {
    let nested = 100_000;
    let error = "67:1: branches are nested deeper than 64";
    assert_eq!(
        ldmicro(&format!("RUNG\n{}", "PARALLEL\n".repeat(nested))),
        Err(error.to_owned())
    );
    let error = "1:65: parentheses are nested more than 64 deep";
    let text = format!("{}NO I1", "(".repeat(60_000));
    assert_eq!(read("iot", text.as_bytes()), Err(error.to_owned()));
    let error = "1:107: parentheses are nested more than 100 deep";
    let text = format!("start {}open contact I0.1", "(".repeat(nested));
    assert_eq!(read("textbook", text.as_bytes()), Err(error.to_owned()));
    // Each branch begins and ends within the one above it.
    let mut lines = vec![" ".repeat(17 * 200)];
    let ends = |depth: usize| [17 * depth - 1, 17 * (191 - depth) - 1];
    for depth in 0..90 {
        let (mut wire, mut below) = (vec![' '; 3400], vec![' '; 3400]);
        let [start, end] = if depth == 0 { [0, 3399] } else { ends(depth) };
        wire[start..=end].fill('-');
        let first = start.next_multiple_of(17);
        wire.splice(first + 4..first + 12, "+------+".chars());
        for end in ends(depth + 1) {
            (wire[end], below[end]) = ('+', '|');
        }
        if depth > 0 {
            (wire[start], wire[end]) = ('+', '+');
        }
        lines.extend([
            wire.iter().collect(),
            below.iter().collect(),
            below.iter().collect::<String>(),
        ]);
    }
    lines.push(format!("{:-<3400}", "------[END]"));
    let error = "7:1: the rung is not made of series and branches, or branches are nested too deep";
    assert_eq!(drawing(&lines), Err(error.to_owned()));
}

/// A project in PLCopen XML with a program of these elements.
fn plcopen(elements: &str) -> Result<usize, String> {
    let project = format!(
        "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"><types><pous><pou name=\"Main\" pouType=\"program\"><body><LD>\n\
         <leftPowerRail localId=\"0\"/>{elements}</LD></body></pou></pous></types></project>"
    );
    read("plcopen", project.as_bytes())
}

fn wired(kind: &str, id: usize, from: &str, tag: &str) -> String {
    let from = from
        .split_whitespace()
        .map(|id| format!("<connection refLocalId=\"{id}\"/>"));
    let from: Vec<String> = from.collect();
    format!(
        "<{kind} localId=\"{id}\"><connectionPointIn>{}</connectionPointIn><variable>{tag}</variable></{kind}>\n",
        from.concat()
    )
}

/// A reader of XML compares each attribute of an element with all others.
#[test]
fn an_element_of_very_many_attributes() {
    let many = (0..200_000)
        .map(|n| format!("\na{n}=''"))
        .collect::<Vec<_>>()
        .concat();
    let error = "an element of the file has more than 256 attributes; projects do not";
    for (notation, root) in [
        ("plcopen", "project xmlns=\"http://www.plcopen.org/xml/tc6_0201\""),
        ("l5x", "RSLogix5000Content"),
        ("simaticml", "Document"),
        ("twincat", "TcPlcObject"),
    ] {
        let text = format!("<?xml version=\"1.0\"?>\n<{root}{many}></{root}>");
        assert_eq!(
            read(notation, text.as_bytes()),
            Err(error.to_owned()),
            "{notation}"
        );
    }
}

#[test]
fn drawings_that_are_too_deep_too_wide_or_too_many() {
    let bounded = |elements: &[String]| {
        let text = elements.concat();
        let length = plcopen(&text).expect("it is read");
        assert!(
            length < 20 * text.len() + 10_000_000,
            "{length} of {}",
            text.len()
        );
    };
    let count = 2_000;
    let chain: Vec<String> = (1..count)
        .map(|id| wired("contact", id, &(id - 1).to_string(), "a"))
        .collect();
    bounded(&chain);
    let coils: Vec<String> = (1..count)
        .map(|id| wired("coil", id, &(id - 1).to_string(), "a"))
        .collect();
    bounded(&coils);
    let ids: Vec<String> = (1..count).map(|id| id.to_string()).collect();
    let mut wide: Vec<String> = (1..count).map(|id| wired("contact", id, "0", "a")).collect();
    wide.push(wired("coil", count, &ids.join(" "), "y"));
    bounded(&wide);
    // Each column is wired to all of the one before.
    let column = |at: usize| {
        (0..20)
            .map(|row| (1 + at * 20 + row).to_string())
            .collect::<Vec<_>>()
            .join(" ")
    };
    let mut mesh: Vec<String> = (0..40 * 20)
        .map(|id| {
            wired(
                "contact",
                id + 1,
                &if id < 20 {
                    "0".to_owned()
                } else {
                    column(id / 20 - 1)
                },
                "a",
            )
        })
        .collect();
    mesh.extend((0..40).map(|id| wired("coil", 1_000 + id, &column(39), "y")));
    bounded(&mesh);
    // A loop at every element.
    let loops: Vec<String> = (1..2_000)
        .map(|id| wired("contact", id, &format!("{} {}", id - 1, id + 1), "a"))
        .collect();
    bounded(&loops);
    let long = "a".repeat(100_000);
    let named: Vec<String> = (1..30)
        .map(|id| wired("contact", id, &(id - 1).to_string(), &long))
        .collect();
    bounded(&named);
    let deep = format!("PROGRAM main\n{{\"rungs\": {}", "[".repeat(100_000));
    assert!(read("openplc", deep.as_bytes()).is_err());
}

#[test]
fn a_line_of_five_megabytes() {
    let line = vec![b'A'; 5 << 20];
    for notation in NOTATIONS {
        for first in [
            &b""[..],
            b"LDmicro0.1\n",
            b"LDmicro export text\n",
            b"start ",
            b"NO I1 ; ",
            b"IN = { DI ",
        ] {
            let bytes = [first, &line[..]].concat();
            assert!(read(notation.name(), &bytes).is_err(), "{}", notation.name());
        }
    }
}

const DOCUMENT: &str =
    "FUNCTION_BLOCK a\nVAR\na, y : Bool;\nEND_VAR\n{ S7_Language := \"LAD\" }\nNETWORK\nRUNG wire#powerrail ";

/// What ends [`DOCUMENT`].
const DOCUMENT_END: &str = "\nEND_RUNG\nEND_NETWORK\nEND_FUNCTION_BLOCK\n";

#[test]
fn blocks_of_simatic_controllers_are_read_in_linear_time() {
    let rungs = |rung: &dyn Fn(usize) -> String, count: usize| {
        let inside: String = (0..count).map(rung).collect();
        let text =
            format!("{DOCUMENT}Contact( #a ) END_RUNG\n{inside}RUNG wire#powerrail Coil( #y ){DOCUMENT_END}");
        drop(read("simatic", text.as_bytes()));
    };
    rungs(
        &|n| format!("RUNG wire#powerrail Contact( #a ) wire#w{n} Coil( #y ) END_RUNG\n"),
        2_000,
    );
    rungs(
        &|n| format!("RUNG wire#w{n} Contact( #a ) END_RUNG wire#w{}\n", n + 1),
        4_000,
    );
    rungs(
        &|n| format!("RUNG wire#w{} Contact( #a ) END_RUNG wire#w{n}\n", n + 1),
        4_000,
    );
    rungs(
        &|n| {
            format!(
                "RUNG wire#w{} Contact( #a ) wire#w{} Coil( #y ) END_RUNG wire#w{}\n",
                n / 7,
                n / 3,
                n / 2
            )
        },
        1_500,
    );
    rungs(
        &|n| format!("RUNG wire#powerrail #c{n}.CTU( r := wire#w{n}, pv := 5, cv => ) END_RUNG\n"),
        2_000,
    );
    rungs(
        &|_| "RUNG wire#powerrail Unknown( #a ) END_RUNG\n".to_owned(),
        2_000,
    );
}

#[test]
fn a_long_line_of_short_words() {
    for (name, first, word) in [
        ("textbook", "start ", "( "),
        ("textbook", "start open contact I0.1 ", "& open contact I0.1 "),
        ("cplc-draft", "+", "--[ ]<a>"),
        ("cplc-draft", "IN = { ", "DI a, "),
        ("ascii", "|--| |--", "[(|"),
        ("ascii", "|--| |--\n", "+-|\n"),
        ("ascii", "", "+--+\n|a |-( )\n+--+\n"),
        ("ascii", "", "  a  b\n-| |-+-( )-+\n"),
        ("iot", "NO I1 ", "; NO I1 "),
        ("ldmicro", "LDmicro0.1\nPROGRAM\nRUNG\n", "CONTACTS "),
        ("simatic", DOCUMENT, "RUNG wire#powerrail Contact( #a ) END_RUNG "),
        (
            "simatic",
            DOCUMENT,
            "RUNG wire#powerrail Contact( #a ) wire#w END_RUNG\n",
        ),
        (
            "simatic",
            DOCUMENT,
            "RUNG wire#a Coil( #y ) wire#b END_RUNG wire#a\n",
        ),
        ("simatic", DOCUMENT, "Contact( #a )\n"),
        ("simatic", "FUNCTION_BLOCK a\nVAR\n", "a : Struct\n"),
        ("simatic", "FUNCTION_BLOCK a\nVAR\n", "{ S7_MLC := \"x\" }\n"),
        (
            "simatic",
            "FUNCTION_BLOCK a\nVAR\nEND_VAR\n",
            "{ S7_Language := \"LAD\" } NETWORK RUNG wire#powerrail Coil( #a[#a[0]] ) END_RUNG END_NETWORK\n",
        ),
    ] {
        let text = first.to_owned() + &word.repeat(300_000 / word.len());
        // That it ends is what counts.
        drop(read(name, text.as_bytes()));
    }
}

#[test]
fn nothing_and_zeros() {
    for notation in NOTATIONS {
        for bytes in [
            &b""[..],
            b"\0",
            b"\0\0\n\0",
            b"\xff\xfe",
            b"\xef\xbb\xbf",
            b"\n\n\n",
            b"\r",
        ] {
            assert!(
                read(notation.name(), bytes).is_err(),
                "{}: {bytes:?}",
                notation.name()
            );
        }
    }
    assert_eq!(
        ldmicro("RUNG\n CONTACTS X\0a 0\nEND\n").map(|length| length > 0),
        Ok(true)
    );
}

#[test]
fn a_million_rungs() {
    let many = 1_000_000;
    let large = Err("the file is larger than 4 MiB; programs are not".to_owned());
    assert_eq!(ldmicro(&"RUNG\nEND\n".repeat(many)), large);
    assert_eq!(read("iot", "NO I1\n".repeat(many).as_bytes()), large);
    let text = "start open contact I0.1 & active coil Q0 end\n";
    assert_eq!(read("textbook", text.repeat(many).as_bytes()), large);
    assert_eq!(
        read("cplc-draft", "+--( )<a>--+\n".repeat(many).as_bytes()),
        large
    );
    // As many as fit: what is made of them grows with them.
    let text = "RUNG\nCOIL Y 0 0 0\nEND\n".repeat(5_000);
    assert!(ldmicro(&text).expect("it can be read") < 5_000 * 100);
}

#[test]
fn wide_rungs_are_refused() {
    let refused = |read: Result<usize, String>| read.expect_err("it is too wide");
    let ended = |n: usize| format!("RUNG\n{}END\n", "OSR\n".repeat(n));
    assert!(refused(ldmicro(&ended(70))).contains("more than 64 parts"));
    let branches = format!("{}END\n", "PARALLEL\n".to_owned() + &"OSR\n".repeat(60) + "END\n");
    let wide = format!(
        "RUNG\n{}",
        branches.trim_end_matches("END\n").to_owned().repeat(5)
    );
    assert!(refused(ldmicro(&(wide + "END\n"))).len() > 10);
    let text = vec!["NO I1"; 70].join(" ; ");
    assert!(refused(read("iot", text.as_bytes())).contains("more than 64 parts"));
    let text = vec![format!("( {} )", vec!["NO I1"; 60].join(" ; ")); 60].join(" | ");
    assert!(refused(read("iot", text.as_bytes())).contains("more than 256 elements"));
}

/// Each type has ten members of the next, and the last is made of one that nobody has: a look at all of them would never end.
#[test]
fn types_of_types_that_are_not_known() {
    let mut types = String::new();
    for number in 1..=15 {
        let members = (0..10).map(|member| {
            format!(
                "<variable name=\"m{member}\"><type><derived name=\"T{}\"/></type></variable>",
                number + 1
            )
        });
        types.push_str(&format!(
            "<dataType name=\"T{number}\"><baseType><struct>{}</struct></baseType></dataType>",
            members.collect::<String>()
        ));
    }
    let text = format!(
        "<project><types><dataTypes>{types}</dataTypes><pous><pou name=\"Main\" pouType=\"program\"><interface><localVars>\
         <variable name=\"a\"><type><derived name=\"T1\"/></type></variable><variable name=\"b\"><type><BOOL/></type></variable>\
         </localVars></interface><body><ST><p>b := NOT b;</p></ST></body></pou></pous></types></project>"
    );
    assert!(read("plcopen", text.as_bytes()).is_ok());
}
