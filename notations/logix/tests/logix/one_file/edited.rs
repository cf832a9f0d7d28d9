//! Rungs and tags of an export that are edited, and what is not edited.

use super::{Files, back, cell, check, difference, folder, text};
use crate::files::corpus_files;
use expect_test::expect;
use ladder_notation::{Source, write_one_file};
use ladder_notation_logix::L5x;

#[test]
fn what_is_not_edited_stays_to_the_letter() {
    let mut count = 0;
    for (name, export) in corpus_files() {
        let mut files = folder(&export);
        assert_eq!(text(&back(&export, &files)), export, "{name}");
        // A blank line is no edit.
        files[0].1.push('\n');
        if name.contains("ER013") {
            continue;
        }
        let written = back(&export, &files);
        assert_eq!(text(&written), export, "{name}");
        assert_eq!(difference(&export, &written), "", "{name}");
        count += 1;
    }
    assert!(count == 0 || count == 48, "{count}");
}

/// The lines about what runs: without comments for the tools, and a number that stands for rungs.
fn bare(files: &Files) -> Vec<String> {
    let told = ["# ladder: allow", "# Controller", "# the checksum"];
    let lines = files.iter().flat_map(|(_, text)| text.lines());
    let kept = lines.filter(|line| !line.is_empty() && !told.iter().any(|begin| line.starts_with(begin)));
    // Tags that are new are declared after the others.
    let mut kept: Vec<String> = kept.map(|line| line.split_whitespace().collect()).collect();
    kept.sort();
    kept
}

/// Of each file the first contacts are made their opposites, one by one: one rung is otherwise then, and is read again as it was edited.
#[test]
fn one_contact_changes_one_rung() {
    let mut tried = 0;
    for (name, export) in corpus_files() {
        if name.contains("ER013") {
            continue;
        }
        let files = folder(&export);
        let places = files.iter().enumerate().flat_map(|(number, (_, text))| {
            let rungs = text.find("FUNCTION_BLOCK").map_or(&text[..], |end| &text[..end]);
            rungs
                .match_indices("--[ ]( ")
                .map(move |(at, _)| (number, at + 2))
        });
        for (number, at) in places.take(4) {
            let mut files = files.clone();
            // What never runs is the order of the tasks.
            if files[number].1[at..].starts_with("[ ]( SYS.OFF )") {
                continue;
            }
            tried += 1;
            files[number].1.replace_range(at..at + 3, "[/]");
            let written = back(&export, &files);
            let told = difference(&export, &written);
            let is_drawn = told.contains("it is ladder logic there now");
            assert!(is_drawn || told.lines().count() == 2, "{name}\n{told}");
            let again = bare(&folder(&text(&written)));
            // A branch without anything on it is not drawn again, and what was structured text in another way.
            if !is_drawn && !name.contains("l5x2c.ex1") {
                let is = bare(&files);
                let other = again.iter().zip(&is).find(|(again, is)| again != is);
                assert!(
                    other.is_none() && again.len() == is.len(),
                    "{name}\n{told}{other:?}"
                );
            }
        }
    }
    assert!(tried == 0 || tried > 50, "{tried}");
}

#[test]
fn a_rung_is_edited_added_and_taken_out() {
    let pump = "Pump.clad";
    check(
        &cell(),
        &[(pump, "( )( run )", "+--[ ]( go )--(S)( run )--+")],
        expect![[r#"
        -<![CDATA[XIC(go)OTE(run);]]>
        +<![CDATA[XIC(go)OTL(run);]]>
    "#]],
    );
    check(
        &cell(),
        &[(
            pump,
            "[$TON]( timer )",
            "# a new one #\n+--[ ]( go )--( )( lamp )--+\n\n+--[$TON]( timer )--+",
        )],
        expect![[r#"
            +<Tag Name="lamp" TagType="Base" DataType="BOOL" Radix="Decimal" Constant="false" ExternalAccess="Read/Write">
            +<Data Format="Decorated">
            +<DataValue DataType="BOOL" Radix="Decimal" Value="0"/>
            +</Data>
            +</Tag>
            +<Comment>
            +<![CDATA[a new one]]>
            +</Comment>
            -<![CDATA[TON(timer,100,0);]]>
            +<![CDATA[XIC(go)OTE(lamp);]]>
            +<![CDATA[TON(timer,100,0);]]>
            +</Text>
            +</Rung>
            +<Rung Number="3" Type="N">
            +<Text>
        "#]],
    );
    check(
        &cell(),
        &[(pump, "[$TON]( timer )", "")],
        expect![[r#"
            -<![CDATA[TON(timer,100,0);]]>
            -</Text>
            -</Rung>
            -<Rung Number="2" Type="N">
            -<Text>
        "#]],
    );
}

#[test]
fn tags_are_changed_renamed_and_taken_out() {
    let pump = "Pump.clad";
    check(
        &cell(),
        &[(pump, "DINT  := 7", "    Pump_step : DINT := 8;  # step #")],
        expect![[r#"
        -<Data Format="L5K">
        -<![CDATA[7]]>
        -</Data>
        -<DataValue DataType="DINT" Radix="Hex" Value="7"/>
        +<DataValue DataType="DINT" Radix="Decimal" Value="8"/>
    "#]],
    );
    check(
        &cell(),
        &[
            (pump, "DINT  := 7", "    count : DINT := 7;"),
            (
                pump,
                "[ ]( timer.DN )",
                "+--[ ]( timer.DN )--[CALC]( count, count + 1 )--+",
            ),
        ],
        expect![[r#"
            -<Tag Name="step" TagType="Base" DataType="DINT" ExternalAccess="Read Only">
            +<Tag Name="count" TagType="Base" DataType="DINT" ExternalAccess="Read Only">
            -<![CDATA[XIC(timer.DN)ADD(step,1,step);]]>
            +<![CDATA[XIC(timer.DN)CPT(count,count + 1);]]>
        "#]],
    );
}

#[test]
fn an_original_that_is_none_says_so() {
    let files = folder(&cell());
    let with = |original: &str| {
        let source = Source::alone("cell", original.as_bytes());
        let error =
            write_one_file(&L5x, &files, &[], "cell", Some(&source)).expect_err("it cannot be written");
        format!("{error}\n")
    };
    let jump = cell().replace("XIC(go)OTE(run);", "XIC(go)JMP(nowhere);");
    expect![[r#"
        the file that the programs come from: it is XML, but no export of Logix Designer: those begin with <RSLogix5000Content>
        the file that the programs come from: 1:1: this is not XML as it must be: unknown token
        the file that the programs come from: Pump.clad:22:69: there is no label `nowhere` to jump to
    "#]].assert_eq(&[with("<a/>"), with("none"), with(&jump)].concat());
}
