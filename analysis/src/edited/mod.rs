//! The context of a text behind a small edit, from the one before it.
//!
//! An edit that touches rungs, rails, comments and blank lines alone changes what a few networks
//! name, and with it the uses of a few tags. All else is taken over: networks and tags are shared with the context
//! before, and only the plain numbers that say where networks are get copied. What comes out is what reading the whole
//! text gives; where that is not certain there is no short way, and the whole text is read.

mod declarations;
mod lines;
mod may_settle;
mod names;
mod networks;
mod tags;

pub(crate) use may_settle::may_settle;

use crate::context::{self, Context};
use crate::others::Others;
use crate::scope::TagFacts;
use ladder_syntax::{Name, Parse};
use lines::{Change, change};
use networks::Edited;
use std::sync::Arc;

/// The context of a text that came from another one's by edits; none if it takes more than a look at what they touch.
pub(crate) fn edited(before: &Context, parse: &Arc<Parse>, name: &str, others: &Others) -> Option<Context> {
    if !before.settled || !before.is_called(name) {
        return None;
    }
    // What they say of functions and blocks is not followed one by one.
    if before.asks_others && !others.are_the_same(&before.others) {
        return None;
    }
    let news = others.news_since(&before.others)?;
    let is_outward = |name: &Name| {
        before
            .find_tag(&(0, name.clone()))
            .is_some_and(TagFacts::is_outward)
    };
    let is_named = |name: &Name| {
        is_outward(name) || before.named_in_bodies.contains(name) || before.wrong_globals.is_about(name)
    };
    if news.declared.iter().any(is_named) {
        return None;
    }
    let change = change(before, parse)?;
    let (Change::Networks(lines) | Change::Declarations(lines)) = &change;
    let mut next = Edited::networks(before, parse, lines)?;
    next.context.others = others.clone();
    next.places(before);
    let mut tags = match &change {
        Change::Networks(lines) => {
            declarations::move_declared(&mut next.context, before, lines)?;
            next.names()?
        }
        Change::Declarations(lines) => declarations::enter(&mut next.context, before, lines)?,
    };
    let concerned = tags.used.iter().chain(&tags.retyped);
    if concerned
        .map(|(_, name)| name)
        .any(|name| before.wrong_globals.is_about(name))
    {
        return None;
    }
    next.note_outward(&tags);
    let used = news.used.into_iter().filter(is_outward);
    tags.used.extend(used.map(|name| (0, name)));
    tags.namesakes_in_bodies(&next.context);
    let networks = next.looked_at(before);
    let Edited {
        mut context, removed, ..
    } = next;
    context.change = Some(context::Change {
        since: before.serial,
        networks,
        removed: removed.iter().map(|network| network.id).collect(),
        tags: tags.used,
        retyped: tags.retyped,
    });
    Some(context)
}
