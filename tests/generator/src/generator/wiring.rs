//! Networks of any wiring that power can reach.

use super::dice::Dice;
use super::drawing::{Item, Network, parts};
use crate::reference::evaluate;

const COMMENTS: [&str; 4] = ["# c #", "##", "# [ ]( x )--+ #", "# größer #"];

/// A network of up to five rungs that holds the given blocks, in their order of the text, and blocks that are drawn
/// where more are wanted. Every wire can have power.
pub(super) fn network(
    dice: &mut Dice,
    given: &[String],
    block: &mut dyn FnMut(&mut Dice) -> String,
) -> Network {
    for _ in 0..40 {
        let mut network = draft(dice);
        if is_live(&network) {
            fill(dice, &mut network, given, block);
            return network;
        }
    }
    // Seldom: no draft had power everywhere.
    let mut network = vec![vec![Item::Rail, Item::Block(String::new()), Item::Rail]];
    fill(dice, &mut network, given, block);
    network
}

/// Rungs whose connectors pair, with empty blocks.
fn draft(dice: &mut Dice) -> Network {
    let rungs = dice.of(&[1, 1, 1, 2, 2, 2, 3, 3, 4, 5]);
    let mut ups = 0;
    (0..rungs)
        .map(|rung| {
            let downs = if rung + 1 < rungs { 1 + dice.below(3) } else { 0 };
            let items = line(dice, ups, downs, rung == 0);
            ups = downs;
            items
        })
        .collect()
}

fn line(dice: &mut Dice, ups: usize, downs: usize, is_first: bool) -> Vec<Item> {
    let mut items = vec![Item::Up; ups];
    items.extend(vec![Item::Down; downs]);
    let least = usize::from(ups + downs == 0);
    items.extend(vec![Item::Block(String::new()); least + dice.below(4)]);
    if dice.one_in(8) {
        items.push(Item::Comment(dice.of(&COMMENTS).to_owned()));
    }
    dice.shuffle(&mut items);
    let mut rung = Vec::new();
    let is_railed = if is_first {
        !dice.one_in(12)
    } else {
        dice.one_in(3)
    };
    if is_railed {
        rung.push(Item::Rail);
    }
    for item in items {
        let begins = matches!(item, Item::Up | Item::Down);
        if begins && !rung.is_empty() && dice.one_in(5) {
            if dice.one_in(4) {
                rung.push(Item::Stub);
            }
            rung.push(Item::Gap);
        }
        rung.push(item);
    }
    match dice.below(4) {
        0 => {}
        1 => rung.push(Item::Stub),
        _ => rung.push(Item::Rail),
    }
    rung
}

/// Whether power can reach all of it: with every block a piece of wire.
fn is_live(network: &Network) -> bool {
    let parts = parts(network);
    if parts.iter().any(Vec::is_empty) {
        return false;
    }
    // A comment that nothing is before or after is not a wire.
    let loose = |rung: &Vec<Item>| {
        let edge = |item: Option<&Item>| matches!(item, None | Some(Item::Gap));
        (0..rung.len()).any(|n| {
            matches!(rung[n], Item::Comment(_))
                && (edge(n.checked_sub(1).map(|n| &rung[n])) || edge(rung.get(n + 1)))
        })
    };
    let power = evaluate(&parts, &mut |_, enabled| enabled);
    let is_dark = |rung: &Vec<Item>, power: &Vec<bool>| {
        rung.iter()
            .zip(power)
            .any(|(item, power)| *item != Item::Gap && !power)
    };
    !network.iter().any(loose)
        && !network
            .iter()
            .zip(&power)
            .any(|(rung, power)| is_dark(rung, power))
}

/// Fills in the texts of the empty blocks.
fn fill(
    dice: &mut Dice,
    network: &mut Network,
    given: &[String],
    block: &mut dyn FnMut(&mut Dice) -> String,
) {
    let mut given = given.to_vec();
    let places = network
        .iter()
        .flatten()
        .filter(|item| matches!(item, Item::Block(_)))
        .count();
    let mut left = places;
    for item in network.iter_mut().flatten() {
        let Item::Block(text) = item else { continue };
        let must = left <= given.len() || (!given.is_empty() && dice.one_in(left));
        left -= 1;
        *text = if must && !given.is_empty() {
            given.remove(0)
        } else {
            block(dice)
        };
    }
    if given.is_empty() {
        return;
    }
    // Too few places: the rest goes onto a rung of its own.
    let mut rung = vec![Item::Rail];
    rung.extend(given.into_iter().map(Item::Block));
    rung.push(Item::Rail);
    if places == 0 || network.len() > 1 {
        network.push(rung);
    } else {
        let at = network[0].len();
        let before_rail = network[0].last() == Some(&Item::Rail) && at > 1;
        network[0].splice(
            at - usize::from(before_rail)..at,
            rung.drain(1..).collect::<Vec<_>>(),
        );
    }
}
