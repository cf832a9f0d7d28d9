//! Programs with tags of `SYS`, for systems that have none of them: a block keeps them, which is written along, and an instance of it
//! runs first in each program and block that names one. Its name says so, for people and for [`again`], which makes tags of `SYS` of
//! its outputs where such a program is read.

pub(crate) mod again;

use crate::edited::{Edited, Edits, first_line, own_networks, write_edited};
use crate::{Entry, LineColumn, Lines, Outcome, WriteError, Writing};
use ladder_analysis::Analysis;
use ladder_analysis::context::Body;
use ladder_analysis::program::Place;
use ladder_analysis::program::SystemTag;
use ladder_syntax::TextRange;
use std::collections::HashSet;

/// The block.
const BLOCK: &str = "$LadderSys";
/// Its instances.
const INSTANCE: &str = "ladder_sys";
/// What the outputs begin with: `TIME` alone is no name.
const OUTPUT: &str = "sys_";
/// What the comment on it says.
const ABOUT: &str = "What ladder text has in SYS, as far as it is used";

/// Writes a program that names no number of the scan, no time and no clock of `SYS`, but for those that the system has,
/// or has in the body of a block that it knows itself.
///
/// # Errors
///
/// Those of `write`.
pub fn with_system_tags(
    analysis: &Analysis,
    has: impl Fn(Body, SystemTag) -> bool,
    write: impl Fn(&Analysis) -> Result<Writing, WriteError>,
) -> Result<Writing, WriteError> {
    let (edited, in_blocks) = kept(analysis, &has).unzip();
    let mut writing = write_edited(analysis, edited, &write)?;
    for (place, tag) in in_blocks.into_iter().flatten() {
        writing.report.entries.push(Entry {
            place,
            element: format!("SYS.{}", tag.name()),
            outcome: Outcome::Approximated("the block counts scans and time only while it runs".to_owned()),
        });
    }
    writing.report.entries.sort_by_key(|entry| entry.place);
    Ok(writing)
}

/// Whether the block keeps a tag of `SYS`: of the others one is high in the first scan, which each system knows, two are constants, and
/// no other system counts faults as ladder text does.
const fn is_kept(tag: SystemTag) -> bool {
    !matches!(
        tag,
        SystemTag::FirstScan | SystemTag::On | SystemTag::Off | SystemTag::Fault
    )
}

/// A program with the block, and what the bodies of blocks name of it. None: the program has no such tags, or something else has the
/// name of the block.
fn kept(
    analysis: &Analysis,
    has: &dyn Fn(Body, SystemTag) -> bool,
) -> Option<(Edited, Vec<(LineColumn, SystemTag)>)> {
    let context = &analysis.context;
    let mut named: Vec<(TextRange, SystemTag, Body)> = Vec::new();
    for (network, body) in own_networks(analysis)? {
        let body = match body {
            Body::Function(_) => Body::Main,
            body => body,
        };
        let bound = network.blocks.iter().flat_map(|block| &block.arguments);
        for (place, at) in bound.flat_map(|bound| bound.places()) {
            if let Place::System(tag) = place
                && is_kept(*tag)
                && !has(body, *tag)
            {
                named.push((at, *tag, body));
            }
        }
    }
    let text = context.parse.to_string();
    let lower = text.to_lowercase();
    if named.is_empty() || lower.contains(INSTANCE) || lower.contains(&BLOCK.to_lowercase()) {
        return None;
    }
    let places = Lines::of(&text);
    let mut edits = Edits::default();
    let (mut with_instance, mut in_blocks) = (HashSet::new(), Vec::new());
    for (at, tag, body) in &named {
        edits.instead.push((*at, format!("{INSTANCE}.{}", output(*tag))));
        if *body != Body::Main {
            in_blocks.push((places.place(&text, at.start().into()), *tag));
        }
        if with_instance.insert(*body) {
            edits.declare(*body, &format!("{INSTANCE} : {BLOCK};"));
            let mut networks = context.networks.iter();
            let first = networks.find(|network| context.bodies[network.index] == *body)?;
            let before = edits.before.entry(first_line(context, first.index)).or_default();
            before.push_str(&format!("+--[{BLOCK}]( {INSTANCE} )--+\n\n"));
        }
    }
    let mut tags: Vec<SystemTag> = SystemTag::ALL.to_vec();
    tags.retain(|tag| named.iter().any(|(_, other, _)| other == tag));
    edits.end = block(&tags);
    Some((edits.program(context)?, in_blocks))
}

/// The output for a tag.
fn output(tag: SystemTag) -> String {
    format!("{OUTPUT}{}", tag.name())
}

/// The block that keeps these tags.
fn block(tags: &[SystemTag]) -> String {
    let (mut outputs, mut locals, mut networks) = (String::new(), String::new(), String::new());
    // What the others follow from.
    let passed = output(SystemTag::ScanTime);
    if !tags.contains(&SystemTag::ScanTime) {
        locals.push_str(&format!("    {passed} : TIME;\n"));
    }
    let has_clock = tags.iter().any(|tag| matches!(tag, SystemTag::Clock(_)));
    if has_clock {
        locals.push_str("    milliseconds : DINT;\n");
        networks.push_str(&format!("\n+--[TYP]( milliseconds, {passed} )--+\n"));
    }
    for tag in tags {
        let name = output(*tag);
        let first = if *tag == SystemTag::Scan { " := -1" } else { "" };
        outputs.push_str(&format!("    {name} : {}{first};\n", tag.ty().name()));
        let network = match tag {
            SystemTag::Scan => format!("[ADD]( {name}, {name}, 1 )"),
            SystemTag::Time => format!("[ADD]( {name}, {name}, {passed} )"),
            SystemTag::Clock(clock) => {
                let phase = format!("in_{}", tag.name().to_lowercase());
                locals.push_str(&format!("    {phase} : DINT;\n"));
                let whole = clock.period() / 1_000_000;
                format!(
                    "[ADD]( {phase}, {phase}, milliseconds )--[MOD]( {phase}, {phase}, {whole} )--[GE]( {phase}, {} )--( )( {name} )",
                    whole / 2
                )
            }
            _ => continue,
        };
        networks.push_str(&format!("\n+--{network}--+\n"));
    }
    format!(
        "# {ABOUT} #\nFUNCTION_BLOCK [{BLOCK}]\nVAR_OUTPUT\n{outputs}END_VAR\nVAR\n{locals}{TIMERS}{networks}END_FUNCTION_BLOCK\n"
    )
}

/// The time since the scan before. A timer that has run out has to rest for a scan: two of them take turns.
const TIMERS: &str = "    one, two : TON;
    before_one, before_two : TIME;
    by_two : BOOL;
END_VAR

+--[/]( one.Q )--[TON]( one, T#1h )--+

+--\\--[LT]( one.ET, T#20m )--\\--[TON]( two, T#2h )--+
|  /--[GT]( one.ET, T#40m )--/                      |

+--\\--[LT]( one.ET, T#10m )--\\--( )( by_two )--+
|  /--[GT]( one.ET, T#50m )--/                 |

+--[ ]( by_two )--[SUB]( sys_SCAN_TIME, two.ET, before_two )--+

+--[/]( by_two )--[SUB]( sys_SCAN_TIME, one.ET, before_one )--+

+--[MOV]( before_one, one.ET )--[MOV]( before_two, two.ET )--+
";
