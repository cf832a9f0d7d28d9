//! The files of others: what is read of each.

use crate::run::errors;
use expect_test::expect;
use ladder_format::Options;
use ladder_notation::{Converted, Notation, Outcome, Source, convert};
use ladder_notation_logix::{L5x, Rslogix500};
use std::collections::HashMap;
use std::fs;
use std::path::PathBuf;

/// The files of others, if they are here.
pub(crate) fn corpus(folder: &str) -> Option<PathBuf> {
    let Some(root) = std::env::var_os("LADDER_CORPUS") else {
        eprintln!("skipped: LADDER_CORPUS does not say where the files of others are");
        return None;
    };
    Some(PathBuf::from(root).join(folder))
}

pub(crate) fn read(notation: &dyn Notation, path: &std::path::Path) -> Converted {
    let bytes = fs::read(path).expect("the file can be read");
    let stem = path.file_stem().expect("a name").to_string_lossy().into_owned();
    convert(notation, &Source::alone(&stem, &bytes), &Options::default())
        .unwrap_or_else(|error| panic!("{stem}: {error}"))
}

/// What is drawn of a file: rungs, contacts, coils, further legs of branches; what was approximated and refused.
fn drawn(converted: &Converted) -> String {
    let text = &converted.written.text;
    let entries = converted.report.entries.iter();
    let elements: HashMap<_, _> = entries
        .map(|entry| (entry.place, entry.element.as_str()))
        .collect();
    let (mut contacts, mut coils) = (0, 0);
    let mut starts = Vec::new();
    for (range, origin) in &converted.written.places {
        let block = &text[*range];
        let place = converted.places[*origin as usize];
        let element = elements.get(&place).copied().unwrap_or_default();
        let is = |names: &[&str]| names.iter().any(|name| element.starts_with(name));
        contacts += usize::from(is(&["XIC"]) && block.starts_with("[ ]("));
        contacts += usize::from(is(&["XIO"]) && block.starts_with("[/]("));
        coils += usize::from(is(&["OTE", "OTL", "OTU"]) && block.starts_with('('));
        if !block.starts_with("<FUN>") {
            starts.push(usize::from(range.start()));
        }
    }
    let (mut rungs, mut legs, mut at) = (0, 0, 0);
    for network in text.split("\n\n") {
        let range = at..at + network.len();
        at = range.end + 2;
        let is_drawn = network.lines().any(|line| line.starts_with('+'));
        if is_drawn && starts.iter().any(|start| range.contains(start)) {
            rungs += 1;
            let lines = network.lines().filter(|line| line.starts_with(['+', '|']));
            legs += lines.map(|line| outside(line, '\\')).sum::<usize>() / 2;
        }
    }
    let mut counts = [0; 2];
    for entry in &converted.report.entries {
        match entry.outcome {
            Outcome::Translated => {}
            Outcome::Approximated(_) => counts[0] += 1,
            Outcome::Refused(_) => counts[1] += 1,
        }
    }
    let [approximated, refused] = counts;
    format!("{rungs}/{contacts}/{coils}/{legs}, {approximated} approximated, {refused} refused")
}

/// How often a character is on a line outside of comments.
fn outside(line: &str, wanted: char) -> usize {
    let parts = line.split('#').step_by(2);
    parts.map(|part| part.matches(wanted).count()).sum()
}

#[test]
fn rungs_contacts_coils_and_legs() {
    let Some(folder) = corpus("rockwell") else { return };
    let mut lines = Vec::new();
    for entry in fs::read_dir(folder).expect("the folder can be read") {
        let path = entry.expect("an entry").path();
        if path.extension().is_none_or(|extension| extension != "L5X") {
            continue;
        }
        let converted = read(&L5x, &path);
        let errors = errors(&converted.written.text);
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let mut line = format!("{name}: {}", drawn(&converted));
        for error in errors {
            line.push_str(&format!("; {error}"));
        }
        lines.push(line);
    }
    lines.sort();
    expect![[r#"
        L5Sharp.Routine_FBD_negative: 5/1/2/0, 1 approximated, 0 refused
        L5Sharp.Routine_Main: 1/1/0/0, 0 approximated, 0 refused
        L5Sharp.Routine_SFC_negative: 1/0/0/0, 1 approximated, 0 refused
        L5Sharp.Rung2_from_Main: 5/1/2/0, 0 approximated, 0 refused
        L5Sharp.Test: 24/6/9/3, 5 approximated, 1 refused
        L5Sharp.TestProgram: 4/1/2/0, 0 approximated, 0 refused
        L5Sharp.aoi_Test: 4/1/2/0, 0 approximated, 0 refused
        Rung0_from_Main: 1/1/0/0, 0 approximated, 0 refused
        Rung1_from_Main: 18/48/33/31, 0 approximated, 0 refused
        alex-optim.BOOLS_2_DINT: 32/32/32/0, 0 approximated, 0 refused
        alex-optim.DINT_2_BOOLS: 32/32/32/0, 0 approximated, 0 refused
        alex-optim.DUTY_CYCLE: 76/86/71/14, 0 approximated, 0 refused
        fanno.Plc_emulator: 211/64/72/35, 61 approximated, 0 refused
        hutcheb.ACDTestsWithAOI: 7/2/2/0, 3 approximated, 0 refused
        invalid.EC013_duplicate_jmp_label: 2/0/0/0, 0 approximated, 0 refused
        invalid.ER009_wrong_operand_count: 1/0/1/0, 0 approximated, 1 refused
        invalid.ER013_invalid_jmp_target: 1/0/0/0, 0 approximated, 0 refused; 8:68: there is no label `BadLabel` to jump to: BadLabel
        invalid.ER014_otl_without_otu: 1/0/1/0, 0 approximated, 0 refused
        invalid.WR003_output_never_driven: 1/2/1/0, 0 approximated, 0 refused
        l5x-lint.Message_Rung: 1/0/0/0, 1 approximated, 0 refused
        l5x-lint.rungs_process: 6/4/0/0, 1 approximated, 0 refused
        l5x-lint.rungs_prog_control: 7/5/0/0, 1 approximated, 0 refused
        l5x2c.ex1: 5/11/5/5, 0 approximated, 0 refused
        rockwell.raC_Opr_HTTP_Client_no_deps: 0/0/0/0, 4 approximated, 0 refused
        rockwell.sample_implicit_deps_no_export_option: 4/0/0/0, 0 approximated, 0 refused
        rockwell.sample_no_dependencies: 2/0/0/0, 0 approximated, 0 refused
        rockwell.sample_with_aoi_dependencies: 5/0/0/0, 0 approximated, 0 refused
        rockwell.sample_with_dependencies: 2/0/0/0, 0 approximated, 0 refused
        rungs_compare: 7/7/7/0, 0 approximated, 0 refused
        rungs_math: 6/6/0/0, 1 approximated, 0 refused"#]].assert_eq(&lines.join("\n"));
}

#[test]
fn text_of_rslogix_500() {
    let Some(folder) = corpus("rslogix500") else {
        return;
    };
    let converted = read(&Rslogix500, &folder.join("public-rungs.txt"));
    assert_eq!(errors(&converted.written.text), [""; 0]);
    expect!["15/36/11/10, 1 approximated, 1 refused"].assert_eq(&drawn(&converted));
    let refused = converted
        .report
        .remarks()
        .map(|entry| format!("{}: {:?}", entry.place, entry.outcome));
    expect![[r#"
        6:15: Approximated("here ACC of a timer may pass PRE, where a controller stops it")
        20:14: Refused("the branch that begins here has no end")"#]]
    .assert_eq(&refused.collect::<Vec<_>>().join("\n"));
}

/// The exports of the corpus, each with its name. None: the corpus is not there.
pub(crate) fn corpus_files() -> Vec<(String, String)> {
    let Some(folder) = corpus("") else {
        return Vec::new();
    };
    let mut found = Vec::new();
    let mut folders = vec![folder];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("the folder can be read") {
            let path = entry.expect("an entry").path();
            let is_export = path
                .extension()
                .is_some_and(|extension| extension.eq_ignore_ascii_case("l5x"));
            if path.is_dir() {
                folders.push(path);
            } else if is_export {
                let name = path.display().to_string();
                found.push((name, fs::read_to_string(&path).expect("it is UTF-8")));
            }
        }
    }
    found.sort();
    found
}
