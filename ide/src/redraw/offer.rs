//! What can be done with what is selected in the diagram, and why the rest cannot.

use super::change::{Change, change};
use super::declaring::Declared;
use super::editable::drawing;
use super::fragment::{Fragment, Given};
use super::lines::{network_at, with_heading};
use crate::drawing::beside::Side;
use crate::drawing::carry::{self, NOT_A_RUN};
use crate::drawing::gap::Gap;
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::region::Region;
use crate::drawing::remove::{Spot, branch_around};
use crate::drawing::rows::{Drawing, lines_text};
use crate::drawing::selection::things;
use crate::drawing::term::rows;
use crate::refactor::names::new_tag;
use ladder_analysis::context::Context;
use ladder_analysis::networks::NetworkAt;
use ladder_format::{Circuit, Options};
use ladder_instructions::Group;
use ladder_syntax::{TextRange, TextSize};

/// What is asked about.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Asked {
    /// A place in a wire.
    At(TextSize),
    /// Things of a network.
    What(Vec<TextRange>),
    /// A network.
    Network(TextSize),
}

/// Something that can be done, or why it cannot.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Offer {
    /// What: `insert`, `parallelBelow` ..
    pub op: &'static str,
    /// Why not.
    pub why: Option<String>,
}

/// All that is known about what is asked about.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Offered {
    /// What can be done.
    pub offers: Vec<Offer>,
    /// It as ladder text.
    pub text: Option<String>,
    /// The places in the wires before and behind it.
    pub before: Option<TextSize>,
    /// See `before`.
    pub behind: Option<TextSize>,
    /// The next larger group.
    pub larger: Option<TextRange>,
    /// The things of that group, one by one.
    pub larger_things: Vec<TextRange>,
    /// All that acts on its line, at the right rail.
    pub acting: Option<TextRange>,
    /// The networks next to one that is asked about.
    pub neighbours: Option<Neighbours>,
    /// The new names of a text that is to be put in, as they would be declared.
    pub declares: Vec<Declared>,
    /// A name that is free.
    pub name: String,
}

/// Where the networks next to one begin, of its program, function or block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Neighbours {
    /// The one above.
    pub above: Option<TextSize>,
    /// The one below.
    pub below: Option<TextSize>,
    /// The one below that.
    pub after: Option<TextSize>,
}

/// A contact to try things with: it names no tag that would be declared.
const TRIAL: &str = "[ ]( %I0.0 )";

/// What can be done; `text` is what a person wants to put in.
///
/// # Errors
///
/// That there is no network.
pub fn offer(
    context: &Context,
    asked: &Asked,
    text: Option<&str>,
    options: &Options,
) -> Result<Offered, String> {
    let desk = Desk { context, options };
    let mut offered = match asked {
        Asked::At(at) => desk.at(*at)?,
        Asked::What(what) => desk.what(what)?,
        Asked::Network(network) => desk.network(*network)?,
    };
    let place = match asked {
        Asked::At(place) | Asked::Network(place) => *place,
        Asked::What(what) => what.first().map_or(TextSize::new(0), |range| range.start()),
    };
    offered.name = new_tag(context, &[], "contact");
    if let Some(text) = text {
        let given = Given {
            text: text.to_owned(),
            ..Given::default()
        };
        let scope = network_at(context, place)?.scope;
        offered.declares = Fragment::read(context, scope, &given, options)?.declared;
    }
    Ok(offered)
}

const NO_ABOVE: &str = "no network of its program, function or block is above it";
const NO_BELOW: &str = "no network of its program, function or block is below it";

struct Desk<'c> {
    context: &'c Context,
    options: &'c Options,
}

impl Desk<'_> {
    /// Whether a change can be made.
    fn tried(&self, op: &'static str, what: Result<Change, &'static str>) -> Offer {
        let done = what.map_err(str::to_owned);
        let done = done.and_then(|what| change(self.context, &what, self.options).map(|_| ()));
        Offer { op, why: done.err() }
    }

    fn at(&self, at: TextSize) -> Result<Offered, String> {
        let network = network_at(self.context, at)?;
        let insert = self.tried("insert", Ok(Change::Insert { at, given: trial() }));
        let split = self.tried("split", Ok(Change::Split { at }));
        let mut offered = Offered {
            offers: vec![insert, split],
            ..Offered::default()
        };
        if let Ok(drawing) = drawing(self.context, network)
            && let Some(gap) = Gap::on_line(&drawing, at)
        {
            offered.acting = acting(network, &drawing, gap.row, gap.index);
        }
        Ok(offered)
    }

    fn what(&self, what: &[TextRange]) -> Result<Offered, String> {
        let first = what.first().ok_or("nothing is selected")?;
        let network = network_at(self.context, first.start())?;
        let drawing = match drawing(self.context, network) {
            Ok(drawing) => drawing,
            Err(why) => {
                let ops = [
                    "insert",
                    "parallelBelow",
                    "parallelAbove",
                    "delete",
                    "move",
                    "operand",
                    "head",
                    "split",
                ];
                let offers = ops.map(|op| Offer {
                    op,
                    why: Some(why.clone()),
                });
                return Ok(Offered {
                    offers: offers.into(),
                    ..Offered::default()
                });
            }
        };
        let mut spots: Vec<Spot> = what.iter().flat_map(|range| things(&drawing, *range)).collect();
        spots.sort_unstable();
        spots.dedup();
        let run = carry::copied(&drawing, &spots);
        let around = gaps_around(&drawing, &spots);
        let anchors = around.map(|gaps| gaps.map(|gap| gap.anchor(&drawing)));
        let parallel = |side| {
            let [from, to] = anchors.ok_or(NOT_A_RUN)?;
            Ok(Change::Parallel {
                from,
                to,
                side,
                given: trial(),
            })
        };
        let behind = anchors.map(|[_, behind]| behind);
        let at_behind = |make: fn(TextSize) -> Change| behind.map(make).ok_or(NOT_A_RUN);
        let is_one = spots.len() == 1;
        let one = |op| Offer {
            op,
            why: (!is_one).then(|| "select one block".to_owned()),
        };
        let moves = Offer {
            op: "move",
            why: run.as_ref().err().map(|why| (*why).to_owned()),
        };
        let offers = vec![
            self.tried("insert", at_behind(|at| Change::Insert { at, given: trial() })),
            self.tried("parallelBelow", parallel(Side::Below)),
            self.tried("parallelAbove", parallel(Side::Above)),
            self.tried("delete", Ok(Change::Delete { what: what.to_vec() })),
            moves,
            one("operand"),
            one("head"),
            self.tried(
                "split",
                anchors.map(|[at, _]| Change::Split { at }).ok_or(NOT_A_RUN),
            ),
        ];
        let larger = larger(&drawing, around);
        let of_larger = larger.map(|range| things(&drawing, range)).unwrap_or_default();
        let of_larger = of_larger
            .iter()
            .map(|&(row, index)| drawing.rows[row].items[index].at);
        let [before, behind] = anchors.map_or([None, None], |anchors| anchors.map(Some));
        Ok(Offered {
            offers,
            text: run.ok().map(|run| text_of(&drawing, run)),
            before,
            behind,
            larger_things: of_larger.collect(),
            larger,
            acting: around.and_then(|[_, to]| acting(network, &drawing, to.row, to.index)),
            ..Offered::default()
        })
    }

    fn network(&self, place: TextSize) -> Result<Offered, String> {
        let context = self.context;
        let network = network_at(context, place)?;
        let start = |network: NetworkAt<'_>| network.range.start();
        let network_there = |is_above| Change::Network {
            near: Some(start(network)),
            is_above,
            given: trial(),
        };
        let body = context.bodies[network.index];
        let neighbour = |number: Option<usize>| {
            let number = number.filter(|number| context.bodies.get(*number) == Some(&body))?;
            context.networks.get(number).map(start)
        };
        let neighbours = Neighbours {
            above: neighbour(network.index.checked_sub(1)),
            below: neighbour(Some(network.index + 1)),
            after: neighbour(Some(network.index + 2)),
        };
        let Neighbours { above, below, after } = neighbours;
        let moved = |before: Option<TextSize>| Change::MoveNetwork {
            network: start(network),
            before,
        };
        let offers = vec![
            self.tried("networkAbove", Ok(network_there(true))),
            self.tried("networkBelow", Ok(network_there(false))),
            self.tried(
                "comment",
                Ok(Change::Comment {
                    network: start(network),
                    text: "x".to_owned(),
                }),
            ),
            self.tried("moveUp", above.map(|above| moved(Some(above))).ok_or(NO_ABOVE)),
            self.tried("moveDown", below.map(|_| moved(after)).ok_or(NO_BELOW)),
            self.tried(
                "duplicate",
                Ok(Change::Duplicate {
                    network: start(network),
                }),
            ),
            self.tried(
                "merge",
                below
                    .map(|below| Change::Merge {
                        networks: vec![start(network), below],
                    })
                    .ok_or(NO_BELOW),
            ),
            self.tried(
                "delete",
                Ok(Change::DeleteNetwork {
                    network: start(network),
                }),
            ),
        ];
        let text = lines_text(&context.parse, with_heading(context, network));
        Ok(Offered {
            offers,
            text: Some(text.trim_start_matches('\u{feff}').to_owned()),
            neighbours: Some(neighbours),
            ..Offered::default()
        })
    }
}

fn trial() -> Given {
    Given {
        text: TRIAL.to_owned(),
        ..Given::default()
    }
}

/// The gaps around some things: of those that follow each other on a row, or of all that their branches are.
fn gaps_around(drawing: &Drawing, spots: &[Spot]) -> Option<[Gap; 2]> {
    let &(top, first) = spots.first()?;
    let own = spots.iter().filter(|(row, _)| *row == top);
    let last = own.map(|(_, index)| *index).max()?;
    let is_held = |region: &Region| {
        let held = region.things(drawing);
        let mut blocks = spots
            .iter()
            .filter(|&&(row, index)| drawing.rows[row].items[index].is_block());
        let are_in = blocks.all(|spot| held.contains(spot));
        are_in && held.iter().all(|spot| spots.contains(spot))
    };
    // A group begins with the line that leads down, perhaps several.
    for start in (0..=first).rev() {
        let items = &drawing.rows[top].items;
        if start < first && items[start].kind != ItemKind::Down {
            break;
        }
        for end in last + 1..=items.len() {
            if end > last + 1 && items[end - 1].kind != ItemKind::Down {
                break;
            }
            if let Some(region) = Region::of(drawing, top, start..end).filter(|region| is_held(region)) {
                return Some(region.gaps());
            }
        }
    }
    None
}

/// The smallest branch around what is between two gaps, or the group of branches where that is a whole branch.
fn larger(drawing: &Drawing, around: Option<[Gap; 2]>) -> Option<TextRange> {
    let [from, to] = around?;
    let branch = branch_around(drawing, from.row, from.index..to.index)?;
    let range = |row: usize, range: std::ops::Range<usize>| {
        let items = &drawing.rows[row].items[range];
        Some(items.first()?.at.cover(items.last()?.at))
    };
    if branch.region.top == from.row && branch.region.on_top() != (from.index..to.index) {
        return range(branch.region.top, branch.region.on_top());
    }
    let (row, group) = branch.group();
    range(row, group)
}

/// The coils before the right rail on a line, or what leaves the program there: power goes through all else that acts.
fn acting(network: NetworkAt<'_>, drawing: &Drawing, row: usize, index: usize) -> Option<TextRange> {
    let items = &drawing.rows[row].items;
    let segment = drawing.segment(row, index.min(items.len() - 1));
    let end = segment.end - usize::from(items[segment.end - 1].kind == ItemKind::RightRail);
    let acts = |item: &Item| match item.kind {
        ItemKind::Block(Some(number)) => {
            let block = &network.facts().blocks[number];
            let row = block.instruction();
            row.is_some_and(|row| row.coil.is_some() || row.group == Group::Flow)
        }
        ItemKind::Down | ItemKind::Comment => true,
        _ => false,
    };
    let mut start = (segment.start..end)
        .rev()
        .take_while(|&at| acts(&items[at]))
        .last()?;
    // A group that begins further left is in part conditions.
    while start < end && Region::of(drawing, row, start..end).is_none() {
        start += 1;
    }
    let region = Region::of(drawing, row, start..end)?;
    let all_act = region.items(drawing).all(|item| !item.is_block() || acts(item));
    let has_block = region.items(drawing).any(Item::is_block);
    (all_act && has_block).then(|| items[start].at.cover(items[end - 1].at))
}

/// Parts of a drawing as ladder text.
fn text_of(drawing: &Drawing, run: Vec<Circuit<Item>>) -> String {
    drawing
        .with_rows(rows(&Circuit::Series(run)))
        .text()
        .trim_start()
        .to_owned()
}
