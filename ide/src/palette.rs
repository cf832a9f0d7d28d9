//! What can be drawn: the instructions of a program's profile and the blocks that it sees, in sections, and by the words
//! of a person who looks for one.

use crate::completion::{operands_of, operands_of_user};
use ladder_analysis::context::Context;
use ladder_analysis::library;
use ladder_analysis::written::user_block::UserBlockFacts;
use ladder_format::names::Names;
use ladder_instructions::{
    Accepts, Group, Instruction, Op, Purpose, TABLE, name_in_us, names_elsewhere, purpose,
};
use ladder_syntax::Name;
use rustc_hash::FxHashSet;

/// One thing that can be drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PaletteRow {
    /// The heading that it is under.
    pub section: &'static str,
    /// As it is drawn without operands: `[TON]`.
    pub block: String,
    /// In a few words: "On-delay timer".
    pub title: String,
    /// What it is called elsewhere: `XIC`.
    pub elsewhere: Vec<&'static str>,
    /// What it is called in the United States, where that is another name.
    pub us: Option<&'static str>,
    /// What its parentheses hold until a person writes something else; empty for one tag that is to be named. None: it has none.
    pub operands: Option<String>,
}

const CONTACTS: &str = "Contacts";
const COMPARE: &str = "Compare";
const OWN_BLOCKS: &str = "Blocks of this workspace";
const LIBRARY: &str = "Library";

/// The sections in the order in which electricians look for something.
const SECTIONS: [&str; 9] = [
    CONTACTS,
    Group::Coil.title(),
    Group::State.title(),
    COMPARE,
    Group::Data.title(),
    Group::Flow.title(),
    Group::Port.title(),
    OWN_BLOCKS,
    LIBRARY,
];

/// All that can be drawn in a program, section by section; with words to look for only what they lead to, the likest first.
pub fn palette(context: &Context, search: &str) -> Vec<PaletteRow> {
    let search = search.trim();
    let mut rows: Vec<(u8, PaletteRow)> = Vec::new();
    let taken = taken(context);
    for row in TABLE.iter().filter(|row| row.profiles.contain(context.profile)) {
        if let Some(likeness) = of_row(row, search) {
            rows.push((likeness, instruction(&taken, row)));
        }
    }
    for (block, file) in blocks(context) {
        let row = user_block(&taken, block, file);
        let is_like = |text: &str| text.to_lowercase().contains(&search.to_lowercase());
        if is_like(&row.block) || is_like(&row.title) {
            rows.push((if row.section == OWN_BLOCKS { 1 } else { 2 }, row));
        }
    }
    let section = |row: &PaletteRow| SECTIONS.iter().position(|own| *own == row.section);
    rows.sort_by_key(|(likeness, row)| (if search.is_empty() { 0 } else { *likeness }, section(row)));
    rows.into_iter().map(|(_, row)| row).collect()
}

/// How much an instruction is what is looked for, 0 the most. None: not at all.
fn of_row(row: &Instruction, search: &str) -> Option<u8> {
    if search.is_empty() {
        return Some(0);
    }
    let spelled = search.trim_matches(['[', ']', '(', ')', '<', '>', '$']);
    let begins = |name: &str| {
        name.len() >= spelled.len()
            && name.is_char_boundary(spelled.len())
            && name[..spelled.len()].eq_ignore_ascii_case(spelled)
    };
    if row.block().eq_ignore_ascii_case(search)
        || row.spellings().any(|name| name.eq_ignore_ascii_case(spelled))
    {
        return Some(0);
    }
    if !spelled.is_empty() && row.spellings().any(begins) {
        return Some(1);
    }
    // Each word must lead to it, but those of two letters, which say nothing: "count up".
    let words = search.split(|c: char| !c.is_alphanumeric());
    let words = words.filter(|word| word.len() > 2 || *word == search);
    let found: Option<Vec<Purpose>> = words.map(|word| purpose(row, word)).collect();
    let worst = found?.into_iter().max()?;
    // The timer itself is meant, and not what resets it.
    let is_rare = row.op == Op::Res;
    Some(match worst {
        Purpose::Title => 1 + u8::from(is_rare),
        Purpose::Sentence => 3,
    })
}

fn instruction(taken: &FxHashSet<Name>, row: &Instruction) -> PaletteRow {
    let section = match (row.group, row.op) {
        (Group::Condition, Op::Eq | Op::Ne | Op::Gt | Op::Ge | Op::Lt | Op::Le) => COMPARE,
        (Group::Condition, _) => CONTACTS,
        (group, _) => group.title(),
    };
    let operands = operands_of(row).map(|mut operands| {
        let accepts = |index: usize| row.positional(index).map(|operand| operand.accepts);
        if operands.len() == 1 && !matches!(accepts(0), Some(Accepts::State(_))) {
            // The tag of a contact or coil is what a person writes first.
            return String::new();
        }
        for (index, operand) in operands.iter_mut().enumerate() {
            if let Some(Accepts::State(_)) = accepts(index) {
                *operand = free(taken, operand);
            }
        }
        operands.join(", ")
    });
    PaletteRow {
        section,
        block: row.block(),
        title: row.title.to_owned(),
        elsewhere: names_elsewhere(row).collect(),
        us: name_in_us(row),
        operands,
    }
}

/// The names that the program's tags have.
fn taken(context: &Context) -> FxHashSet<Name> {
    let tags = context.scopes.iter().flat_map(|scope| &scope.tags);
    tags.map(|tag| Name::new(&tag.name)).collect()
}

/// A name that no tag has, like this one.
fn free(taken: &FxHashSet<Name>, like: &str) -> String {
    let like = Names::default().fresh(like);
    let numbered = (2..).map(|number| format!("{like}_{number}"));
    let mut names = std::iter::once(like.clone()).chain(numbered);
    names
        .find(|name| !taken.contains(&Name::new(name)))
        .unwrap_or(like)
}

/// The blocks that the program sees, each with the file that defines it if that is another one.
fn blocks(context: &Context) -> Vec<(&UserBlockFacts, Option<&str>)> {
    let mut seen = FxHashSet::default();
    let own = context
        .user_blocks
        .iter()
        .map(|block| (block, block.file().map(|file| &**file)));
    let others = context
        .others
        .all_blocks()
        .map(|(file, block)| (&block.facts, Some(&*file.file)));
    let mut blocks: Vec<(&UserBlockFacts, Option<&str>)> = own.chain(others).collect();
    blocks.retain(|(block, _)| block.name.len() > 1 && seen.insert(&block.key));
    blocks
}

fn user_block(taken: &FxHashSet<Name>, block: &UserBlockFacts, file: Option<&str>) -> PaletteRow {
    let (open, close) = block.shape.brackets();
    let source = file.and_then(library::source);
    let mut operands = operands_of_user(block);
    // Each use has a state of its own.
    operands.insert(0, free(taken, &block.name[1..].to_lowercase()));
    PaletteRow {
        section: if source.is_some() { LIBRARY } else { OWN_BLOCKS },
        block: format!("{open}{}{close}", block.name),
        title: match (source, file) {
            (Some(source), _) => source.summary().replace('`', ""),
            (None, Some(file)) => format!("Block in {file}"),
            (None, None) => "Block of this program".to_owned(),
        },
        elsewhere: Vec::new(),
        us: None,
        operands: Some(operands.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::palette;
    use expect_test::{Expect, expect};
    use ladder_analysis::context;

    fn check(text: &str, search: &str, expected: Expect) {
        let parse = std::sync::Arc::new(ladder_syntax::parse(text));
        let rows = palette(&context(&parse, "test.clad"), search);
        let rows = rows.iter().take(8).map(|row| {
            let operands = row
                .operands
                .as_deref()
                .map_or_else(String::new, |own| format!("( {own} )"));
            format!("{}{operands}  {}  {}\n", row.block, row.title, row.section)
        });
        expected.assert_eq(&rows.collect::<String>());
    }

    #[test]
    fn what_people_look_for_comes_first() {
        check(
            "",
            "",
            expect![[r#"
            [ ](  )  Open contact  Contacts
            [/](  )  Closed contact  Contacts
            [P](  )  Rising-edge contact  Contacts
            [N](  )  Falling-edge contact  Contacts
            [NOT]  Inverter  Contacts
            [OSR]  One shot rising  Contacts
            [OSF]  One shot falling  Contacts
            ( )(  )  Coil  Coils
        "#]],
        );
        check(
            "",
            "XIC",
            expect![[r#"
            [ ](  )  Open contact  Contacts
        "#]],
        );
        check(
            "VAR\n    timer : TON;\nEND_VAR\n",
            "timer",
            expect![[r#"
                [TON]( t, T#1s )  On-delay timer  Timers, counters, bistables
                [TOF]( t, T#1s )  Off-delay timer  Timers, counters, bistables
                [TP]( t, T#1s )  Pulse timer  Timers, counters, bistables
                [RTO]( t, T#1s )  Retentive on-delay timer  Timers, counters, bistables
                [RTOF]( t, T#1s )  Retentive off-delay timer  Timers, counters, bistables
                (RES)(  )  Reset timer or counter  Coils
            "#]],
        );
        check(
            "",
            "counter up",
            expect![[r#"
            [CTU]( c, 10 )  Up counter  Timers, counters, bistables
            [CTD]( c, 10 )  Down counter  Timers, counters, bistables
            [CTUD]( c, 10 )  Up-down counter  Timers, counters, bistables
            [CTC]( c, 10 )  Circular counter  Timers, counters, bistables
            (RES)(  )  Reset timer or counter  Coils
        "#]],
        );
        check(
            "",
            "pid",
            expect![[r#"
                [$PID]( pid, sp, pv, kp, ki, kd, low, high, manual, manual_value, y )  A controller in parallel form  Library
            "#]],
        );
        check("", "nothing like it", expect![[""]]);
    }

    #[test]
    fn every_instruction_is_in_it_once() {
        let parse = std::sync::Arc::new(ladder_syntax::parse(""));
        let rows = palette(&context(&parse, "test.clad"), "");
        for row in ladder_instructions::TABLE {
            let is_there = row.profiles.contain(ladder_instructions::Profile::Iec);
            let is_row = |own: &&super::PaletteRow| own.block == row.block() && own.title == row.title;
            let count = rows.iter().filter(is_row).count();
            assert_eq!(count, usize::from(is_there), "{}", row.block());
        }
    }
}
