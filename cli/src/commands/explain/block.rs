//! The page of a user-defined block: of a program that is named, or of those in the current folder; else of the library.

use super::look::Look;
use super::markdown;
use crate::outcome::Failure;
use ladder_analysis::library::SOURCES;
use ladder_analysis::{Analysis, analyze};
use ladder_ide::{Topic, documentation};
use ladder_syntax::{Name, parse};
use ladder_workspace::{Workspace, find_programs};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// `$Alarm`, `[$Alarm]`, `[$Alarm]( a )`: the name of the block; none if a rule or an instruction is meant.
pub(super) fn named(name: &str) -> Option<&str> {
    let (_, name) =
        super::instruction::bracketed(name).unwrap_or((ladder_instructions::Shape::Logical, name));
    Some(name.trim()).filter(|name| name.starts_with('$'))
}

/// The page of a block whose name was given without its `$`, if there is one in this folder or in the library.
pub(super) fn without_sign(name: &str) -> Option<String> {
    let (_, name) =
        super::instruction::bracketed(name).unwrap_or((ladder_instructions::Shape::Logical, name));
    page(&format!("${}", name.trim()), None).ok()
}

/// The block's page, from the program or another file of its workspace; without a program from the programs in the current
/// folder and below it.
///
/// # Errors
/// The program or its settings cannot be read, or there is no such block.
pub(super) fn page(name: &str, program: Option<&Path>) -> Result<String, Failure> {
    let (programs, place) = match program {
        Some(program) => {
            // Said here, before others of its workspace are read.
            ladder_workspace::read(program)?;
            (vec![program.to_owned()], program.display().to_string())
        }
        None => (find_programs(&[PathBuf::from(".")]).0, "this folder".to_owned()),
    };
    let mut blocks: Vec<String> = Vec::new();
    for program in &programs {
        let analysis = analysis(program)?;
        let context = &analysis.context;
        if let Some(page) = documentation(context, &Topic::UserBlock(name.to_owned())) {
            // That of another file says where it is.
            let file = format!("**User-defined block** in `{}`\n", analysis.context.name);
            return Ok(page.replacen("**User-defined block**\n", &file, 1));
        }
        let own = context.user_blocks[..context.own_blocks].iter();
        blocks.extend(own.map(|block| block.name.clone()));
    }
    let alone = analyze(&Arc::new(parse("")), "");
    if let Some(page) = documentation(&alone.context, &Topic::UserBlock(name.to_owned())) {
        return Ok(page);
    }
    blocks.extend(SOURCES.iter().map(|block| block.name.to_owned()));
    blocks.sort_by_key(|block| Name::new(block));
    blocks.dedup();
    let near = blocks.iter().map(|block| {
        (
            strsim::osa_distance(&block.to_lowercase(), &name.to_lowercase()),
            block,
        )
    });
    let near = near.filter(|(slips, _)| *slips <= 2).min();
    let help = match (near, program) {
        (Some((_, near)), _) => format!("; did you mean `{near}`?"),
        (None, None) => "; name a program that has it: `ladder explain '$Alarm' plant.clad`".to_owned(),
        (None, Some(_)) => String::new(),
    };
    Err(Failure::new(format!(
        "no block is called `{name}` in {place}{help}"
    )))
}

fn analysis(program: &Path) -> Result<Arc<Analysis>, Failure> {
    let workspace = Workspace::of(program)?;
    Ok(match workspace.program_at(program) {
        Some(source) => workspace.analysis(source),
        None => {
            let text = ladder_workspace::read(program)?;
            workspace.analyze_guest(&text, &program.display().to_string())
        }
    })
}

/// Writes the page.
pub(super) fn print(page: &str, look: &Look, out: &mut impl Write) -> io::Result<()> {
    markdown::print(page, look, out)?;
    if !page.ends_with('\n') {
        return Ok(());
    }
    writeln!(out)
}
