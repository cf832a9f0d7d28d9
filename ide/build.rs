//! Makes a table of the rules' pages in the book, so that `ladder explain` and editors show what the book says.

use std::fmt::Write;
use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    // A package of this crate has them where a link is here; that is a plain file where git makes no links.
    let folder = ["rules", "../docs/src/rules"]
        .into_iter()
        .map(Path::new)
        .find(|folder| folder.is_dir());
    let folder = folder.expect("the book has pages of rules");
    println!("cargo::rerun-if-changed={}", folder.display());
    let mut pages: Vec<_> = fs::read_dir(folder)?
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
