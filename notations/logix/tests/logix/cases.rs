//! The traces of small programs, scan by scan: `expected.csv` is what the controller shows after each scan.

use crate::run::{converted, trace};
use ladder_notation_logix::L5x;
use std::fs;
use std::path::Path;

#[test]
fn traces_of_the_cases() {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus/rockwell/cases");
    let mut count = 0;
    for case in fs::read_dir(cases).expect("the cases are there") {
        let case = case.expect("a folder").path();
        let file = |name: &str| fs::read_to_string(case.join(name)).expect("the file is there");
        let text = converted(&L5x, file("prog.L5X").as_bytes()).written.text;
        let expected = file("expected.csv");
        let (header, rows) = expected.split_once('\n').expect("a header");
        let scans = rows.lines().count() as u64;
        let shown = trace(&text, &file("in.csv"), scans, header);
        assert_eq!(shown, expected.trim_end(), "{}\n{text}", case.display());
        count += 1;
    }
    assert_eq!(count, 3);
}
