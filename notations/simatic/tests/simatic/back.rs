//! Programs there and back.

use super::{errors, networks, read_as, remarks, write};
use ladder_notation::Writing;
use std::path::Path;

/// What was written, read again.
fn again(writing: &Writing) -> String {
    let text = String::from_utf8(writing.bytes.clone()).expect("it is text");
    // The texts of blocks next to it have their own numbers.
    let converted = read_as("test", &text, writing.companions.clone());
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
                let ladder = again(&writing);
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

#[test]
fn every_example() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .expect("the folder is there")
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|end| end == "clad"))
        .collect();
    files.sort();
    let mut out = String::new();
    for path in files {
        let text = std::fs::read_to_string(&path).expect("it can be read");
        let why = refused(&text);
        out.push_str(&format!(
            "{}: {why}\n",
            path.file_name().unwrap_or_default().display()
        ));
    }
    expect_test::expect_file!["examples.txt"].assert_eq(&out);
}
