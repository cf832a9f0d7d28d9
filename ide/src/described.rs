//! What the comments in the definition of a user-defined block say of it and of its parameters.

use crate::comments;
use crate::markdown::escaped;
use ladder_analysis::Analysis;
use ladder_analysis::context::Context;
use ladder_analysis::library::{self, Source};
use ladder_analysis::written::user_block::{Parameter, UserBlockFacts};
use std::sync::Arc;

/// A definition whose text is at hand.
pub(crate) struct Described<'c> {
    place: Place<'c>,
    /// Which block of its file it is.
    item: usize,
}

enum Place<'c> {
    Here(&'c Context),
    Library(Arc<Analysis>, &'static Source),
}

impl<'c> Described<'c> {
    /// The definition of a block that a file knows. None for one of another file of the workspace: that text is not here.
    pub(crate) fn of(context: &'c Context, block: &UserBlockFacts) -> Option<Described<'c>> {
        let place = match block.file() {
            None => Place::Here(context),
            Some(file) => Place::Library(ladder_analysis::library_analysis(file)?, library::source(file)?),
        };
        let known = place.context();
        let own = &known.user_blocks[..known.own_blocks];
        let item = own.iter().position(|own| own.key == block.key)?;
        Some(Described { place, item })
    }

    /// The block of the library that it is.
    pub(crate) fn of_library(&self) -> Option<&'static Source> {
        match self.place {
            Place::Here(_) => None,
            Place::Library(_, source) => Some(source),
        }
    }

    /// What the comments right above it say, as Markdown.
    pub(crate) fn description(&self) -> Option<String> {
        let context = match &self.place {
            Place::Here(context) => context,
            Place::Library(_, source) => return Some(source.description()),
        };
        let parse = &context.parse;
        let (first, last) =
            comments::above(context, parse.line_at(context.user_blocks[self.item].at.start())?)?;
        let all = (first..=last).flat_map(|line| comments::of_line(parse, line));
        let paragraphs: Vec<String> = all.filter_map(|(_, comment)| comments::whole(&comment)).collect();
        (!paragraphs.is_empty()).then(|| self.markdown(paragraphs.join("\n\n")))
    }

    /// What the comment of a parameter says, as Markdown.
    pub(crate) fn parameter(&self, parameter: &Parameter) -> Option<String> {
        let context = self.place.context();
        let tag = context.scopes.get(self.item + 1)?.tags.get(parameter.tag)?;
        comments::of_declaration(context, tag).map(|text| self.markdown(text))
    }

    /// The library is written as Markdown, what anybody else wrote is not.
    fn markdown(&self, text: String) -> String {
        match self.place {
            Place::Here(_) => escaped(&text).into_owned(),
            Place::Library(..) => text,
        }
    }
}

impl Place<'_> {
    fn context(&self) -> &Context {
        match self {
            Place::Here(context) => context,
            Place::Library(analysis, _) => &analysis.context,
        }
    }
}
