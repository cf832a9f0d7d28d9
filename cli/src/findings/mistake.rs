//! Mistakes in scenario files, shown like findings in programs.

use super::source::Source;
use annotate_snippets::{AnnotationKind, Group, Level, Renderer};
use ladder_simulator::scenario::Mistake;

/// What stands where the name of a rule would.
pub(crate) const NAME: &str = "bad-scenario";

/// A mistake with its excerpt, without a line end behind it.
pub(crate) fn render(source: &Source, mistake: &Mistake, renderer: &Renderer) -> String {
    let excerpt = super::full::Excerpt::of(source, source.lines(mistake.range));
    let mut group = Group::with_title(Level::ERROR.primary_title(mistake.message.as_str()).id(NAME)).element(
        excerpt
            .snippet(source)
            .annotation(AnnotationKind::Primary.span(excerpt.span(mistake.range))),
    );
    if let Some(help) = &mistake.help {
        group = group.element(Level::HELP.message(help.as_str()));
    }
    renderer.render(&[group])
}
