//! Programs there and back.

use super::{analysis, errors, networks, read_with, remarks, write};
use ladder_notation::{Notation, Writing};
use ladder_notation_simatic::{Simatic, SimaticMl};
use std::path::Path;

/// What was written, read again.
fn again(notation: &dyn Notation, writing: &Writing) -> String {
    let text = String::from_utf8(writing.bytes.clone()).expect("it is text");
    // The texts of blocks next to it have their own numbers.
    let converted = read_with(notation, "test", &text, writing.companions.clone());
    assert_eq!(remarks(&converted), "", "{text}\n{}", converted.written.text);
    let ladder = converted.written.text;
    assert_eq!(errors(&ladder), Vec::<String>::new(), "{ladder}\nof\n{text}");
    ladder
}

/// What is refused of a program, or why it is as a whole.
fn refused(text: &str) -> String {
    match write(text) {
        Err(why) => why,
        Ok(writing) => {
            let remarks: Vec<String> = writing
                .report
                .remarks()
                .map(|entry| format!("{} {}: {:?}", entry.place, entry.element, entry.outcome))
                .collect();
            if remarks.is_empty() {
                let ladder = again(&Simatic, &writing);
                assert_eq!(
                    networks(&ladder),
                    networks(text),
                    "{}",
                    String::from_utf8_lossy(&writing.bytes)
                );
                return String::new();
            }
            remarks.join("\n")
        }
    }
}

/// The texts of all examples, by their names.
fn examples() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .expect("the folder is there")
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|end| end == "clad"))
        .collect();
    files.sort();
    let texts = files.into_iter().map(|path| {
        let name = path.file_name().unwrap_or_default().display().to_string();
        (name, std::fs::read_to_string(&path).expect("it can be read"))
    });
    texts.collect()
}

#[test]
fn every_example() {
    let mut out = String::new();
    for (name, text) in examples() {
        out.push_str(&format!("{name}: {}\n", refused(&text)));
    }
    expect_test::expect_file!["examples.txt"].assert_eq(&out);
}

/// Both forms of a program are read as one, and what there is to say of them is the same.
#[track_caller]
fn both(name: &str, text: &str) {
    let forms: [&dyn Notation; 2] = [&Simatic, &SimaticMl];
    let [document, export] = forms.map(|notation| {
        let writing = notation.write(&analysis(text));
        let writing = writing.unwrap_or_else(|error| panic!("{name}: {error}"));
        let told: Vec<_> = writing.report.remarks().cloned().collect();
        (again(notation, &writing), told)
    });
    assert_eq!(document, export, "{name}");
}

#[test]
fn both_forms_of_every_example_are_one_program() {
    for (name, text) in examples() {
        both(&name, &text);
    }
}

#[test]
fn both_forms_of_the_blocks_of_the_library_are_one_program() {
    for source in ladder_analysis::library::SOURCES {
        both(source.name, source.example);
    }
}
