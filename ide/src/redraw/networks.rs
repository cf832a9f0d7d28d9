//! Networks come, go, move, part and join.

use super::change::{Done, NO_WIRE, Work, first_unknown};
use super::editable::drawing;
use super::fragment::Given;
use super::layout::{self, formatted};
use super::lines::{self, Place, line_at, network_at, range_of, with_heading};
use super::piece::Piece;
use crate::drawing::gap::Gap;
use crate::drawing::merge;
use crate::drawing::rows::{Drawing, comments, lines_text};
use crate::refactor::flow::{is_flow, is_mark, leaves};
use crate::refactor::place::Selected;
use crate::refactor::split_network;
use ladder_analysis::context::Body;
use ladder_analysis::names::declaring::line_end;
use ladder_analysis::networks::NetworkAt;
use ladder_analysis::networks::network::BoundBlock;
use ladder_syntax::{TextRange, TextSize, parse};

impl Work<'_> {
    pub(super) fn delete_network(&self, place: TextSize) -> Done {
        let network = network_at(self.context, place)?;
        let lines = with_heading(self.context, network);
        let piece = Piece::gone(lines::gone(self.context, lines));
        Ok((vec![piece], "Network deleted".to_owned(), None))
    }

    pub(super) fn network(&self, near: Option<TextSize>, is_above: bool, given: &Given) -> Done {
        let place = match near {
            None => lines::at_end(self.context),
            Some(near) => self.place_near(near, is_above),
        };
        let fragment = self.fragment(place.scope, given)?;
        let mut pieces = vec![self.put(&place, &fragment.rungs)];
        // A new file of an editor is a blank line.
        pieces.extend(lines::all_blank(self.context).map(|blank| Piece::plain(blank, "")));
        Ok((pieces, "Network added".to_owned(), Some(fragment)))
    }

    fn place_near(&self, near: TextSize, is_above: bool) -> Place {
        let line = line_at(self.context, near).unwrap_or(0);
        match lines::network_on(self.context, line) {
            Some(network) if is_above => lines::above(
                self.context,
                with_heading(self.context, network).start,
                network.scope,
            ),
            Some(network) => lines::below(self.context, network.lines().end, network.scope),
            None if self.context.parse.lines().is_empty() => lines::at_end(self.context),
            None => lines::near(self.context, line),
        }
    }

    /// Networks at a place between others.
    fn put(&self, place: &Place, rungs: &str) -> Piece {
        let line_end = line_end(&self.context.parse);
        let text = formatted(rungs.trim_end(), place.scope > 0, self.options);
        let text = text
            .trim_end()
            .split('\n')
            .map(|line| line.trim_end_matches('\r'));
        let text = text.collect::<Vec<_>>().join(line_end);
        let start = TextSize::of(place.before.as_str());
        let parsed = parse(&text);
        let first = parsed.structure().networks.first();
        let first = first.and_then(|network| Drawing::of_text(&parsed, network).ok());
        let first = first.and_then(|drawing| layout::things(&drawing).next().map(|item| item.at.start()));
        Piece {
            range: TextRange::empty(place.at),
            new: vec![TextRange::at(start, TextSize::of(text.as_str()))],
            focus: Some(start + first.unwrap_or_default()),
            text: format!("{}{text}{}", place.before, place.behind),
        }
    }

    pub(super) fn move_network(&self, place: TextSize, before: Option<TextSize>) -> Done {
        let context = self.context;
        let network = network_at(context, place)?;
        let own = with_heading(context, network);
        let body = context.bodies[network.index];
        let (to, target) = match before {
            Some(before) => {
                let target = network_at(context, before)?;
                let first = with_heading(context, target).start;
                (
                    lines::above(context, first, target.scope),
                    context.bodies[target.index],
                )
            }
            None => {
                let is_last = |index: &usize| context.bodies[*index] == body;
                let last = (0..context.networks.len())
                    .rev()
                    .find(is_last)
                    .unwrap_or(network.index);
                let last = context.networks.at(last);
                (lines::below(context, last.lines().end, last.scope), body)
            }
        };
        let range = range_of(context, own.clone());
        let gone = lines::gone(context, own.clone());
        if gone.contains_inclusive(to.at) || range.contains_inclusive(to.at) {
            return Err("the network is there already".to_owned());
        }
        let unknown = (network.scope != to.scope)
            .then(|| first_unknown(context, network.blocks(), to.scope))
            .flatten();
        if let Some(name) = unknown {
            return Err(format!("`{name}` is not known there: declare it there first"));
        }
        let text = lines_text(&context.parse, own);
        let text = text.trim_start_matches('\u{feff}').trim_end_matches(['\r', '\n']);
        let start = TextSize::of(to.before.as_str());
        let piece = Piece {
            range: TextRange::empty(to.at),
            new: vec![TextRange::at(start, TextSize::of(text))],
            focus: Some(start),
            text: format!("{}{text}{}", to.before, to.behind),
        };
        let said = match target {
            _ if target == body => "Network moved".to_owned(),
            Body::Function(number) => {
                format!(
                    "Network moved; it is in the function `{}` now",
                    context.functions[number].name
                )
            }
            Body::Block(number) => {
                format!(
                    "Network moved; it is in the block `{}` now",
                    context.user_blocks[number].name
                )
            }
            Body::Main => "Network moved; it is in the main program now".to_owned(),
        };
        Ok((vec![Piece::plain(gone, ""), piece], said, None))
    }

    pub(super) fn duplicate(&self, place: TextSize) -> Done {
        let context = self.context;
        let network = network_at(context, place)?;
        if let Some(mark) = network.blocks().find(|block| is_mark(block)) {
            return Err(format!("{} would be there twice", mark.head_text()));
        }
        if let Some(why) = drawing(context, network).err().filter(|_| network.broken) {
            return Err(why);
        }
        let given = Given {
            text: lines_text(&context.parse, with_heading(context, network)),
            copied: true,
            declare: None,
        };
        let fragment = self.fragment(network.scope, &given)?;
        let place = lines::below(context, network.lines().end, network.scope);
        let piece = self.put(&place, &fragment.rungs);
        Ok((vec![piece], "Network duplicated".to_owned(), Some(fragment)))
    }

    pub(super) fn split(&self, at: TextSize) -> Done {
        let (network, drawing) = self.drawn(at)?;
        let gap = Gap::at(&drawing, at).ok_or(NO_WIRE)?;
        let selected = Selected::in_context(self.context, TextRange::empty(at));
        let on = selected.on.as_ref().ok_or(NO_WIRE)?;
        let split = split_network::at(self.context, on, (gap.row, gap.index))?;
        let said = match &split.carries {
            Some(tag) => format!("Network split; {tag} carries the power"),
            None => "Network split".to_owned(),
        };
        let mut pieces = vec![layout::piece(
            network.scope,
            &[split.first, split.second],
            None,
            self.options,
        )?];
        // The tag is declared as any new one.
        let fragment = match &split.carries {
            Some(tag) => {
                let given = Given {
                    text: format!("+--[ ]( {tag} )--( )( {tag} )--+"),
                    declare: None,
                    copied: false,
                };
                Some(self.fragment(network.scope, &given)?)
            }
            None => None,
        };
        if let Some(piece) = pieces.first_mut() {
            piece.range = drawing.range();
        }
        Ok((pieces, said, fragment))
    }

    pub(super) fn merge(&self, networks: &[TextSize]) -> Done {
        const NOT_NEXT: &str = "only a network and the one below it can be joined";
        let [first, second] = networks else {
            return Err(NOT_NEXT.to_owned());
        };
        let ((one, upper), (two, lower)) = (self.drawn(*first)?, self.drawn(*second)?);
        let context = self.context;
        let is_next = one.index + 1 == two.index && context.bodies[one.index] == context.bodies[two.index];
        let between = one.lines().end..two.lines().start;
        let is_aside = |line: usize| context.parse.lines()[line].kind.is_decoration();
        if !is_next || !between.clone().all(is_aside) {
            return Err(NOT_NEXT.to_owned());
        }
        let all = |network: NetworkAt<'_>, allowed: fn(&BoundBlock) -> bool| {
            network.blocks().all(|block| !is_flow(&block) || allowed(&block))
        };
        if !all(one, is_mark) || !all(two, leaves) {
            return Err("a block of program flow would do something else then".to_owned());
        }
        let lines: Vec<String> = between
            .map(|line| context.parse.lines()[line].text().to_owned())
            .collect();
        if lines.iter().any(|line| line.contains("ladder:")) {
            return Err("a directive is above the second network".to_owned());
        }
        let lines = lines
            .into_iter()
            .filter(|line| !comments(std::slice::from_ref(line)).is_empty());
        let new = merge::merged(&upper, &lower, lines.collect())?;
        let piece = layout::piece(one.scope, &[new], None, self.options)?;
        Ok((vec![piece], "Networks joined".to_owned(), None))
    }
}
