//! `ladder explain` without a name: what there is.

use super::look::Look;
use super::wrap::wrap;
use super::{markdown, rule};
use ladder_analysis::RuleGroup;
use ladder_analysis::library::SOURCES;
use ladder_instructions::{Group, Instruction, TABLE};
use std::io::{self, Write};

/// Writes the instructions and the rules, by their groups.
pub(super) fn print(look: &Look, out: &mut impl Write) -> io::Result<()> {
    let heading = look.heading;
    for group in Group::ALL {
        writeln!(out, "{heading}Instructions: {}{heading:#}\n", group.title())?;
        let rows = TABLE.iter().filter(|row| row.group == group).map(line);
        markdown::print_table(&rows.collect::<Vec<_>>(), look.columns, out)?;
        writeln!(out)?;
    }
    writeln!(out, "{heading}Blocks of the library{heading:#}\n")?;
    let blocks = SOURCES
        .iter()
        .map(|block| (block.name.to_owned(), block.summary()));
    markdown::print_table(&blocks.collect::<Vec<_>>(), look.columns, out)?;
    writeln!(out)?;
    for group in RuleGroup::ALL {
        writeln!(out, "{heading}Rules: {}{heading:#}\n", group.title())?;
        let rules = ladder_analysis::rules::ALL
            .iter()
            .filter(|rule| rule.group() == group);
        let lines = rules.map(|rule| (rule.name().to_owned(), rule::summary(*rule)));
        markdown::print_table(&lines.collect::<Vec<_>>(), look.columns, out)?;
        writeln!(out)?;
    }
    let end = "`ladder explain NAME` shows the page of one of them, for example `ladder explain TON`.";
    out.write_all(wrap(end, "", "", look.columns).as_bytes())
}

fn line(row: &Instruction) -> (String, String) {
    (row.block(), row.title.to_owned())
}
