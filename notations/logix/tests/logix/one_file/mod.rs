//! The files of a folder as one export, and as the one that they come from.

mod edited;
mod new;
mod programs;

use crate::exports::routine;
use expect_test::Expect;
use ladder_format::Options;
use ladder_notation::{OneFile, Outcome, Source, convert, write_one_file};
use ladder_notation_logix::L5x;

type Files = Vec<(String, String)>;

/// The files that an export becomes.
fn folder(export: &str) -> Files {
    let source = Source::alone("cell", export.as_bytes());
    let converted = convert(&L5x, &source, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
    let programs = converted.files.iter().filter(|file| file.name != "ladder.toml");
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).expect("it is UTF-8");
    let files: Files = programs
        .map(|file| (file.name.clone(), text(&file.bytes)))
        .collect();
    if files.is_empty() {
        return vec![("cell.clad".to_owned(), converted.written.text)];
    }
    files
}

/// Writes files into the export that they come from.
fn back(export: &str, files: &Files) -> OneFile {
    let source = Source::alone("cell", export.as_bytes());
    write_one_file(&L5x, files, &[], "cell", Some(&source)).unwrap_or_else(|error| panic!("{error}"))
}

fn text(written: &OneFile) -> String {
    String::from_utf8(written.bytes.clone()).expect("it is UTF-8")
}

/// The lines that are otherwise, and what there is to say.
fn difference(before: &str, written: &OneFile) -> String {
    let after = text(written);
    let mut out = String::new();
    for change in similar::TextDiff::from_lines(before, &after).iter_all_changes() {
        let sign = match change.tag() {
            similar::ChangeTag::Equal => continue,
            similar::ChangeTag::Delete => '-',
            similar::ChangeTag::Insert => '+',
        };
        out.push_str(&format!("{sign}{}", change.value()));
    }
    for (file, report) in &written.reports {
        for entry in report.remarks() {
            let (Outcome::Approximated(why) | Outcome::Refused(why)) = &entry.outcome else {
                continue;
            };
            out.push_str(&format!("{file}:{}: {}: {why}\n", entry.place, entry.element));
        }
    }
    out
}

/// Edits the ladder text of an export: in the file of this name the line with something becomes another one.
#[track_caller]
fn check(export: &str, edits: &[(&str, &str, &str)], expected: Expect) {
    let mut files = folder(export);
    for (name, from, to) in edits {
        let file = files.iter_mut().find(|(own, _)| own == name);
        let (_, text) = file.unwrap_or_else(|| panic!("there is no {name}"));
        // Wires are as long as their line has room for.
        let from = text
            .lines()
            .find(|line| line.replace("--", "").contains(&from.replace("--", "")));
        let from = from.unwrap_or_else(|| panic!("{text}")).to_owned();
        *text = text.replacen(&from, to, 1);
    }
    let written = back(export, &files);
    expected.assert_eq(&difference(export, &written));
}

/// Two programs and a task, a module, and a routine that is a diagram.
fn cell() -> String {
    let diagram = "<Routine Name=\"Level\" Type=\"FBD\">\n<FBDContent SheetSize=\"A\"/>\n</Routine>\n";
    let program = |name: &str, tags: &str, routines: &str| {
        format!(
            "<Program Name=\"{name}\" MainRoutineName=\"Main\" Disabled=\"false\">\n<Tags>\n{tags}</Tags>\n<Routines>\n{routines}</Routines>\n</Program>\n"
        )
    };
    let tag = |name: &str, ty: &str, value: &str| {
        format!(
            "<Tag Name=\"{name}\" TagType=\"Base\" DataType=\"{ty}\" ExternalAccess=\"Read Only\">\n<Data Format=\"L5K\">\n<![CDATA[{value}]]>\n</Data>\n\
             <Data Format=\"Decorated\">\n<DataValue DataType=\"{ty}\" Radix=\"Hex\" Value=\"{value}\"/>\n</Data>\n</Tag>\n"
        )
    };
    let pump = [
        routine("Main", &["JSR(Sub,0);", "JSR(Level,0);"]),
        diagram.to_owned(),
        routine(
            "Sub",
            &[
                "XIC(go)OTE(run);",
                "TON(timer,100,0);",
                "XIC(timer.DN)ADD(step,1,step);",
            ],
        ),
    ];
    let valve = [
        routine("Main", &["XIO(run)OTE(shut);"]),
        routine("Sub", &["MOV(3,step);"]),
    ];
    format!(
        "\u{feff}<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n<RSLogix5000Content SchemaRevision=\"1.0\" \
         TargetName=\"Cell\">\n<Controller Use=\"Target\" Name=\"Cell\" ProcessorType=\"1769-L33ER\">\n<Modules>\n<Module Name=\"Local\" \
         CatalogNumber=\"1769-L33ER\"/>\n</Modules>\n<Tags>\n{}{}</Tags>\n<Programs>\n{}{}</Programs>\n<Tasks>\n<Task Name=\"Fast\" \
         Type=\"PERIODIC\" Rate=\"5\" Priority=\"3\">\n<ScheduledPrograms>\n<ScheduledProgram Name=\"Pump\"/>\n<ScheduledProgram \
         Name=\"Valve\"/>\n</ScheduledPrograms>\n</Task>\n</Tasks>\n</Controller>\n</RSLogix5000Content>\n",
        tag("go", "BOOL", "0"),
        tag("run", "BOOL", "0"),
        program(
            "Pump",
            &(tag("step", "DINT", "7") + "<Tag Name=\"timer\" TagType=\"Base\" DataType=\"TIMER\"/>\n"),
            &pump.concat()
        ),
        program(
            "Valve",
            &(tag("step", "DINT", "1") + &tag("shut", "BOOL", "0")),
            &valve.concat()
        ),
    )
}
