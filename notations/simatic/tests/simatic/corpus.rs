//! Real blocks.

use super::{analysis, errors, read, read_xml, remarks};
use ladder_notation::{Companion, Notation};
use ladder_notation_simatic::SimaticMl;
use std::collections::BTreeMap;
use std::path::PathBuf;

fn corpus() -> Option<PathBuf> {
    let folder = std::env::var_os("LADDER_CORPUS").map(|folder| PathBuf::from(folder).join("simatic"));
    if folder.is_none() {
        eprintln!("skipped: LADDER_CORPUS names no folder of real programs");
    }
    folder
}

fn text(name: &str) -> Option<String> {
    let path = corpus()?.join(name);
    Some(std::fs::read_to_string(path).expect("the file can be read"))
}

fn document(stem: &str) -> Option<String> {
    // The text is read as a file of this name.
    let path = corpus()?.join(format!("{stem}.s7res"));
    let companions = std::fs::read(path).ok().map(|bytes| Companion {
        name: "block.s7res".into(),
        bytes: bytes.into(),
    });
    let converted = read(&text(&format!("{stem}.s7dcl"))?, companions.into_iter().collect());
    assert_eq!(
        errors(&converted.written.text),
        Vec::<String>::new(),
        "{}",
        converted.written.text
    );
    let remarks = remarks(&converted);
    Some(converted.written.text + &remarks)
}

/// Networks, contacts (of these negated), coils (set, reset), blocks besides.
fn counts(text: &str) -> String {
    let parse = ladder_syntax::parse(text);
    let count = |sign: &str| text.matches(sign).count();
    let contacts = count("[ ](") + count("[/](");
    let coils = count("( )(") + count("(S)(") + count("(R)(");
    let networks = parse.structure().networks.len();
    let others = text.matches("--[").count() - contacts;
    format!(
        "{networks}: {contacts} {}n, {coils} {}S {}R, {others}",
        count("[/]("),
        count("(S)("),
        count("(R)(")
    )
}

#[test]
fn counts_of_the_documents() {
    let expected = [
        ("MCPVerify_FC_LAD", "7: 6 0n, 5 1S 1R, 3"),
        ("MCPVerify_FB_LAD_v3", "4: 3 0n, 4 0S 0R, 4"),
        ("MCPVerify_Mixed_LADSCL", "4: 7 4n, 4 0S 0R, 4"),
        ("two_motor_stress", "4: 11 4n, 3 0S 0R, 2"),
    ];
    for (stem, counted) in expected {
        let Some(text) = document(stem) else { return };
        assert_eq!(counts(&text), counted, "{stem}\n{text}");
    }
}

#[test]
fn counts_of_the_exports() {
    let expected = [
        ("MCPVerify_FC_LAD.xml", "7: 6 0n, 5 1S 1R, 3"),
        ("MCPVerify_FB_LAD_v3.xml", "4: 3 0n, 4 0S 0R, 4"),
        ("MCPVerify_FC_LAD_v2.xml", "10: 2 1n, 5 0S 0R, 9"),
        ("MCPVerify_FC_LAD_v3.xml", "1: 0 0n, 1 0S 0R, 1"),
    ];
    for (name, counted) in expected {
        let Some(text) = text(name) else { return };
        let converted = read_xml(&text);
        let ladder = &converted.written.text;
        assert_eq!(errors(ladder), Vec::<String>::new(), "{ladder}");
        assert_eq!(counts(ladder), counted, "{name}\n{ladder}");
        assert_eq!(remarks(&converted), "", "{name}");
    }
}

#[test]
fn both_forms_of_a_block_are_one_program() {
    for stem in ["MCPVerify_FC_LAD", "MCPVerify_FB_LAD_v3"] {
        let (Some(document), Some(export)) = (document(stem), text(&format!("{stem}.xml"))) else {
            return;
        };
        assert_eq!(read_xml(&export).written.text, document);
    }
}

/// How often each part and each wired pin is in an export.
fn parts_and_pins(export: &str) -> BTreeMap<&str, usize> {
    let mut counts = BTreeMap::new();
    for element in export.split('<') {
        let is_part = element.starts_with("Part ") || element.starts_with("Call ");
        let is_other = ["NameCon ", "TemplateValue ", "Negated ", "OpenCon "]
            .iter()
            .any(|name| element.starts_with(name));
        if is_part || is_other {
            let name = element
                .split("Name=\"")
                .nth(1)
                .and_then(|rest| rest.split('"').next());
            *counts.entry(name.unwrap_or_default()).or_default() += 1;
        }
    }
    counts
}

#[test]
fn what_an_export_becomes_is_written_as_it_was() {
    for name in ["MCPVerify_FC_LAD.xml", "MCPVerify_FB_LAD_v3.xml"] {
        let Some(export) = text(name) else { return };
        let ladder = read_xml(&export).written.text;
        let writing = SimaticMl.write(&analysis(&ladder)).expect("it has no errors");
        let written = String::from_utf8(writing.bytes).expect("it is text");
        assert_eq!(parts_and_pins(&written), parts_and_pins(&export), "{name}");
        assert_eq!(read_xml(&written).written.text, ladder, "{name}");
    }
}
