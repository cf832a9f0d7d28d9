//! What is read of a file, written, and read again: the same ladder text.

use crate::files::{corpus, read};
use ladder_format::Options;
use ladder_notation::{Notation, Source, convert};
use ladder_notation_logix::L5x;
use std::fs;

/// A ladder text as L5X, and that as ladder text again. None: it has errors.
pub(crate) fn back(text: &str) -> Option<(String, String)> {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "prog.clad");
    analysis.program()?;
    let writing = L5x
        .write(&analysis)
        .unwrap_or_else(|error| panic!("{error}\n{text}"));
    let file = String::from_utf8(writing.bytes).expect("it is UTF-8");
    let again = convert(&L5x, &Source::alone("prog", file.as_bytes()), &Options::default());
    let again = again.unwrap_or_else(|error| panic!("{error}\n{file}"));
    Some((file, again.written.text))
}

/// Without what tells the checks what they need not say, and without the controller's name: an export of a part has none.
fn bare(text: &str) -> String {
    let kept = text
        .lines()
        .filter(|line| !line.starts_with("# ladder: allow-file") && !line.starts_with("# Controller "));
    kept.collect::<Vec<_>>().join("\n").replace("#\n\n\n", "#\n\n")
}

/// Writes what was read, and reads that.
#[track_caller]
pub(crate) fn comes_back(text: &str) {
    let (file, again) = back(text).expect("it has no errors");
    let (text, again) = (bare(text), bare(&again));
    let mut lines = text.lines().zip(again.lines());
    let rungs: Vec<&str> = file.lines().filter(|line| line.contains(");]]>")).collect();
    if let Some((one, other)) = lines.find(|(one, other)| one != other) {
        panic!("{one}\n{other}\n{}", rungs.join("\n"));
    }
    assert_eq!(again.len(), text.len(), "{}", rungs.join("\n"));
}

/// Files that do not come back as they were, and why.
const OTHERWISE: &[&str] = &[
    // No program: a jump without a label.
    "invalid.ER013_invalid_jmp_target",
    // Labels of one name.
    "invalid.EC013_duplicate_jmp_label",
    // An instruction without its operand, which the reader refuses.
    "invalid.ER009_wrong_operand_count",
    // An empty leg goes below the others.
    "l5x2c.ex1",
    // A call of a routine that is in another program.
    "fanno.Plc_emulator",
    // Their first routine is unread, and has another name there.
    "L5Sharp.Routine_FBD_negative",
    "L5Sharp.Routine_SFC_negative",
    // Its diagrams name types, and there tags have such names.
    "hutcheb.ACDTestsWithAOI",
    // Programs of other tasks.
    "L5Sharp.Test",
];

#[test]
fn files_of_others() {
    let Some(folder) = corpus("rockwell") else { return };
    let mut count = 0;
    for entry in fs::read_dir(folder).expect("the folder can be read") {
        let path = entry.expect("an entry").path();
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let is_export = path.extension().is_some_and(|extension| extension == "L5X");
        if !is_export || OTHERWISE.contains(&name.as_str()) {
            continue;
        }
        let text = read(&L5x, &path).written.text;
        let (file, again) = back(&text).expect("it has no errors");
        assert_eq!(bare(&again), bare(&text), "{name}\n{file}");
        count += 1;
    }
    assert_eq!(count, 21);
}
