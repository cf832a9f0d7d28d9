//! Makes a table of the rules' pages in the book, so that `ladder explain` and editors show what the book says.

use std::fmt::Write;
use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let folder = Path::new(&env::var("CARGO_MANIFEST_DIR").expect("set by Cargo")).join("../docs/src/rules");
    println!("cargo::rerun-if-changed={}", folder.display());
    let mut pages: Vec<_> = fs::read_dir(&folder)?
        .map(|entry| Ok(entry?.path()))
        .collect::<io::Result<_>>()?;
    pages.sort();
    let mut table = String::from("static RULE_PAGES: &[(&str, &str)] = &[\n");
    for page in pages {
        let name = page.file_stem().unwrap_or_default().to_string_lossy();
        if page.extension().is_some_and(|extension| extension == "md") && name != "index" {
            let file = page.canonicalize()?;
            let file = file.to_string_lossy();
            let _ = writeln!(table, "    ({name:?}, include_str!({file:?})),");
        }
    }
    table.push_str("];\n");
    fs::write(
        Path::new(&env::var("OUT_DIR").expect("set by Cargo")).join("rule_pages.rs"),
        table,
    )
}
