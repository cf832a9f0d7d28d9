//! The page of an instruction, from its row in the table.

use super::look::Look;
use super::markdown;
use super::wrap::wrap;
use ladder_instructions::{Acts, Direction, Instruction, Presence, Shape, TABLE, lookup};
use std::io::{self, Write};

/// All rows that go by the name; brackets around it narrow them down.
pub(super) fn find(name: &str) -> Vec<&'static Instruction> {
    match bracketed(name) {
        Some((shape, mnemonic)) => lookup(shape, mnemonic).collect(),
        // A blank names the open contact and the coil, but only between brackets: as a whole name it is a slip.
        None if name.trim().is_empty() => Vec::new(),
        None => Shape::ALL
            .into_iter()
            .flat_map(|shape| lookup(shape, name))
            .collect(),
    }
}

/// The rows whose title has this word in it: `timer` is in "On-delay timer".
pub(super) fn with_word(word: &str) -> impl Iterator<Item = &'static Instruction> {
    let word = word.trim().to_lowercase();
    TABLE.iter().filter(move |row| {
        let title = row.title.to_lowercase();
        title
            .split(|c: char| !c.is_alphanumeric())
            .any(|part| part == word)
    })
}

/// `[TON]` and `[ ]( tag )` name their brackets too.
pub(super) fn bracketed(name: &str) -> Option<(Shape, &str)> {
    let name = name.trim();
    Shape::ALL.into_iter().find_map(|shape| {
        let (open, close) = shape.brackets();
        let (mnemonic, _operands) = name.strip_prefix(open)?.split_once(close)?;
        Some((shape, mnemonic))
    })
}

/// Writes the page.
pub(super) fn print(row: &Instruction, look: &Look, out: &mut impl Write) -> io::Result<()> {
    let Look {
        heading,
        code,
        columns,
    } = look;
    writeln!(
        out,
        "{code}{}{code:#}  {heading}{}{heading:#}",
        row.signature(),
        row.title
    )?;
    writeln!(out)?;
    markdown::print(row.doc.trim(), look, out)?;
    if !row.operands.is_empty() {
        writeln!(out, "\n{heading}Operands{heading:#}")?;
        let width = row
            .operands
            .iter()
            .map(|operand| operand.name.len())
            .max()
            .unwrap_or(0);
        for operand in row.operands {
            let direction = match operand.direction {
                Direction::In => "in",
                Direction::Out => "out",
                Direction::InOut => "in/out",
            };
            let presence = match operand.presence {
                Presence::Required => "",
                Presence::Repeated { .. } => " May be repeated.",
                Presence::Trailing => " May be left out.",
                Presence::Named => " Given by name; may be left out.",
            };
            // Filled without its colours, which take no columns.
            let name = format!("{:width$}", operand.name);
            let first = format!("  {name}  {direction:6}  ");
            let rest = " ".repeat(first.len());
            let text = wrap(&format!("{}{presence}", operand.doc), &first, &rest, *columns);
            let after = &text[2 + name.len()..];
            write!(out, "  {code}{name}{code:#}{after}")?;
        }
    }
    write!(
        out,
        "\n{heading}Power out{heading:#}\n{}",
        wrap(row.eno, "  ", "  ", *columns)
    )?;
    let acts = match row.acts {
        Acts::Always => "at every evaluation, powered or not",
        Acts::WhenPowered => "only while power enters it",
    };
    writeln!(out, "\n{heading}Acts{heading:#}\n  {acts}")?;
    let others: Vec<&str> = row.synonyms.iter().chain(row.aliases).copied().collect();
    if !others.is_empty() {
        let others = wrap(&others.join(" "), "  ", "  ", *columns);
        write!(out, "\n{heading}Also written{heading:#}\n{others}")?;
    }
    let profiles: Vec<(String, String)> = row
        .in_profiles()
        .map(|(profile, text)| (profile.name().to_owned(), markdown::plain(text)))
        .collect();
    if !profiles.is_empty() {
        writeln!(out, "\n{heading}In other profiles{heading:#}")?;
        markdown::print_table(&profiles, *columns, out)?;
    }
    writeln!(out, "\n{heading}Example{heading:#}")?;
    for line in row.example.trim_end().lines() {
        if line.is_empty() {
            writeln!(out)?;
        } else {
            writeln!(out, "  {code}{line}{code:#}")?;
        }
    }
    Ok(())
}
