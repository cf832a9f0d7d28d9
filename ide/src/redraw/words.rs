//! What a person types or pastes, as ladder text: a piece of a rung, networks, mnemonics, or a drawing of other characters.

use ladder_drawings::{Look, look, may_be_rung_text, read, read_entry, read_rung_text};
use ladder_format::Options;

/// Rungs from the left rail on.
///
/// # Errors
/// What cannot be read.
pub(super) fn as_rungs(text: &str) -> Result<String, String> {
    let text = text.trim_matches(['\n', '\r']).trim_end();
    let lines: Vec<&str> = text.lines().collect();
    let Some(first) = lines
        .iter()
        .map(|line| line.trim_start())
        .find(|line| !line.is_empty())
    else {
        return Err("there is nothing to draw".to_owned());
    };
    let options = Options::default();
    // What was copied from Logix has its meaning there.
    if may_be_rung_text(first)
        && let Some(read) = read_rung_text(text)
        && read.problems.is_empty()
    {
        return Ok(read.program.write(&options).text);
    }
    let drawn: Vec<&str> = lines
        .iter()
        .copied()
        .filter(|line| !line.trim().is_empty())
        .collect();
    if look(&drawn) == Look::Drawn {
        let read = read(text);
        if let Some(problem) = read.problems.first() {
            return Err(format!("`{}`: {}", problem.text.trim(), problem.why));
        }
        return Ok(read.program.write(&options).text);
    }
    if may_be_rung_text(first) || begins_with_word(first) {
        let program = read_entry(text).map_err(|wrong| wrong.message)?;
        return Ok(program.write(&options).text);
    }
    if lines.iter().any(|line| line.trim_start().starts_with('+')) {
        return Ok(text.to_owned());
    }
    let (first, rest) = lines.split_first().unwrap_or((&"", &[]));
    let rest = rest.iter().map(|line| format!("   {line}\n"));
    Ok(format!("+--{}--+\n{}", first.trim(), rest.collect::<String>()))
}

/// Whether a line begins with a word, as mnemonics do and ladder text does not.
fn begins_with_word(line: &str) -> bool {
    line.starts_with(|c: char| c.is_alphabetic())
}
