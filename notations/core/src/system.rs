//! Programs with tags of `SYS`, for systems that have none of them: a block keeps them, which is written along, and an instance of it
//! runs first in each program and block that names one. Its name says so, for people and for [`again`], which makes tags of `SYS` of
//! its outputs where such a program is read.

pub(crate) mod again;

use crate::elements::{Around, Declared, change, put_around, rung};
use crate::rewritten::own_networks;
use crate::target::Target;
use crate::{Lines, Report};
use ladder_analysis::Analysis;
use ladder_analysis::context::Body;
use ladder_analysis::program::{Place, SystemTag};
use ladder_format::program::{
    Block, Declaration, Expression, Invalid, Item, Path, ProgramSketch, Section, SectionKind, Step,
};
use ladder_instructions::Op;
use std::collections::{HashMap, HashSet};

/// The block.
const BLOCK: &str = "$LadderSys";
/// Its instances.
const INSTANCE: &str = "ladder_sys";
/// What the outputs begin with: `TIME` alone is not a name.
const OUTPUT: &str = "sys_";
/// What the comment on it says.
const ABOUT: &str = "What ladder text has in SYS, as far as it is used";

/// Whether the block keeps a tag of `SYS`: of the others one is high in the first scan, which each system knows, two are constants, and
/// no other system counts faults as ladder text does.
const fn is_kept(tag: SystemTag) -> bool {
    !matches!(
        tag,
        SystemTag::FirstScan | SystemTag::On | SystemTag::Off | SystemTag::Fault
    )
}

/// A program that names no number of the scan, no time and no clock of `SYS`, but for those that the target has, and in bodies of
/// blocks that are instructions there. None: the program has no such tags, or something else has the name of the block.
pub(crate) fn with_block(analysis: &Analysis, target: &Target, report: &mut Report) -> Option<ProgramSketch> {
    let context = &analysis.context;
    if SystemTag::ALL.iter().all(|tag| (target.has_system_tag)(*tag)) {
        return None;
    }
    let stays = (target.stays)(context);
    let is_instruction = |body| matches!(body, Body::Block(block) if stays.blocks.contains(&block));
    // A function is run by the program.
    let body_of = |network: usize| match context.bodies[network] {
        Body::Function(_) => Body::Main,
        body => body,
    };
    let mut named = HashSet::new();
    let text = context.parse.to_string();
    let places = Lines::of(&text);
    for (network, number) in own_networks(analysis)? {
        let body = body_of(number);
        let bound = network.blocks.iter().flat_map(|block| &block.arguments);
        for (place, at) in bound.flat_map(|bound| bound.places()) {
            if let Place::System(tag) = place
                && is_kept(*tag)
                && !(target.has_system_tag)(*tag)
                && !is_instruction(body)
            {
                named.insert((body, *tag));
                if body != Body::Main {
                    let why = "the block counts scans and time only while it runs";
                    let place = places.place(&text, at.start().into());
                    report.approximated(place, format!("SYS.{}", tag.name()), why);
                }
            }
        }
    }
    let lower = text.to_lowercase();
    if named.is_empty() || lower.contains(INSTANCE) || lower.contains(&BLOCK.to_lowercase()) {
        return None;
    }
    let mut tags: Vec<SystemTag> = SystemTag::ALL.to_vec();
    tags.retain(|tag| named.iter().any(|(_, other)| other == tag));
    let mut sketch = ProgramSketch::of_text(&context.parse);
    change(&mut sketch.items, &mut |network, block| {
        block.change_paths(|path| {
            if let Some(tag) = system_tag(path)
                && named.contains(&(body_of(network), tag))
            {
                INSTANCE.clone_into(&mut path.root);
                path.steps[0] = Step::Member(output(tag));
            }
        });
    });
    let (mut around, mut declared) = (HashMap::new(), Declared::default());
    for body in named.iter().map(|(body, _)| *body).collect::<HashSet<Body>>() {
        let mut networks = context.networks.iter();
        let first = networks.find(|network| body_of(network.index) == body)?;
        let above = vec![rung([call()?], None), Item::Blank];
        around.insert(
            first.index,
            Around {
                above,
                ..Around::default()
            },
        );
        declared.add(body, [Declaration::new(INSTANCE, BLOCK)]);
    }
    put_around(&mut sketch.items, &mut around);
    declared.put(&mut sketch.items);
    sketch
        .items
        .extend([Item::Blank, Item::Comment(ABOUT.to_owned()), block(&tags).ok()?]);
    Some(sketch)
}

/// The call of the block.
fn call() -> Option<Block> {
    Block::user(&BLOCK[1..], [Path::tag(INSTANCE)]).ok()
}

/// Which tag of `SYS` a path is, if it is one.
fn system_tag(path: &Path) -> Option<SystemTag> {
    let Some(Step::Member(name)) = path.steps.first() else {
        return None;
    };
    let mut tags = SystemTag::ALL.iter().copied();
    let is_system = path.root.eq_ignore_ascii_case("SYS");
    tags.find(|tag| is_system && tag.name().eq_ignore_ascii_case(name))
}

/// The output for a tag.
fn output(tag: SystemTag) -> String {
    format!("{OUTPUT}{}", tag.name())
}

/// The block that keeps these tags.
fn block(tags: &[SystemTag]) -> Result<Item, Invalid> {
    let (mut outputs, mut locals) = (
        Section::new(SectionKind::VarOutput),
        Section::new(SectionKind::Var),
    );
    let mut networks = Vec::new();
    let tag = |name: &str| Expression::from(Path::tag(name));
    // What the others follow from.
    let passed = output(SystemTag::ScanTime);
    if !tags.contains(&SystemTag::ScanTime) {
        locals.declarations.push(Declaration::new(&passed, "TIME"));
    }
    if tags.iter().any(|tag| matches!(tag, SystemTag::Clock(_))) {
        locals.declarations.push(Declaration::new("milliseconds", "DINT"));
        networks.push(vec![Block::of(Op::Typ, [tag("milliseconds"), tag(&passed)])?]);
    }
    for system in tags {
        let name = output(*system);
        outputs.declarations.push(Declaration {
            initial: (*system == SystemTag::Scan).then(|| "-1".to_owned()),
            ..Declaration::new(&name, system.ty().name())
        });
        let add = |to: &str, more: Expression| Block::of(Op::Add, [tag(to), tag(to), more]);
        networks.push(match system {
            SystemTag::Scan => vec![add(&name, 1.into())?],
            SystemTag::Time => vec![add(&name, tag(&passed))?],
            SystemTag::Clock(clock) => {
                let phase = format!("in_{}", system.name().to_lowercase());
                let whole = clock.period() / 1_000_000;
                let of_phase = |op, number: i64| Block::of(op, [tag(&phase), number.into()]);
                locals.declarations.push(Declaration::new(&phase, "DINT"));
                vec![
                    add(&phase, tag("milliseconds"))?,
                    Block::of(Op::Mod, [tag(&phase), tag(&phase), whole.into()])?,
                    of_phase(Op::Ge, whole / 2)?,
                    Block::coil(tag(&name)),
                ]
            }
            _ => continue,
        });
    }
    locals.declarations.extend([
        Declaration {
            names: vec!["one".to_owned(), "two".to_owned()],
            ..Declaration::new("", "TON")
        },
        Declaration {
            names: vec!["before_one".to_owned(), "before_two".to_owned()],
            ..Declaration::new("", "TIME")
        },
        Declaration::new("by_two", "BOOL"),
    ]);
    let mut items = vec![
        Item::Section(outputs),
        Item::Section(locals),
        Item::Text(TIMERS.to_owned()),
    ];
    for network in networks {
        items.extend([Item::Blank, rung(network, None)]);
    }
    Ok(Item::Block {
        header: format!("[{BLOCK}]"),
        origin: None,
        items,
    })
}

/// The time since the scan before. A timer that has run out has to rest for a scan: two of them take turns.
const TIMERS: &str = "
+--[/]( one.Q )--[TON]( one, T#1h )--+

+--\\--[LT]( one.ET, T#20m )--\\--[TON]( two, T#2h )--+
|  /--[GT]( one.ET, T#40m )--/                      |

+--\\--[LT]( one.ET, T#10m )--\\--( )( by_two )--+
|  /--[GT]( one.ET, T#50m )--/                 |

+--[ ]( by_two )--[SUB]( sys_SCAN_TIME, two.ET, before_two )--+

+--[/]( by_two )--[SUB]( sys_SCAN_TIME, one.ET, before_one )--+

+--[MOV]( before_one, one.ET )--[MOV]( before_two, two.ET )--+
";
