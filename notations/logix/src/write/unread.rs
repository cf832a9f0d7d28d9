//! Unread parts that the reader wrote: instructions and routines again.

use super::rung::{Series, it};
use super::{Result, Writer};
use crate::model::{Foreign, Language, Rung};
use crate::unread::LEFT;
use ladder_analysis::context::Context;
use ladder_analysis::program::{Block, BlockKind, Network};
use ladder_notation::{comments, foreign_text_of, unread_operands, xml};
use ladder_syntax::Name;

/// What the reader says of a part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct UnreadPart {
    /// The sentence above its definition: `MSG: it has no counterpart here; ..`
    about: String,
    /// What it is there, where that is in the definition.
    text: Option<String>,
}

impl UnreadPart {
    /// The part that a definition is, if it is one.
    pub(super) fn of(context: &Context, header: usize, definition: &str) -> Option<UnreadPart> {
        if !definition
            .lines()
            .any(|line| line.starts_with("# ladder: unread"))
        {
            return None;
        }
        let above = header.checked_sub(1);
        let about = above.and_then(|line| comments::on_line(&context.parse, line).pop());
        Some(UnreadPart {
            about: about.unwrap_or_default().trim().to_owned(),
            text: foreign_text_of(definition),
        })
    }

    /// What it is called there, and the rest of its comment.
    fn named(&self) -> Result<(&str, &str)> {
        let parted = self.about.split_once(": ");
        parted.ok_or_else(|| "the comment above its definition does not say what it is there".to_owned())
    }

    /// The routine that it is: in another language, or the rungs of one that is unread as a whole.
    fn routine(&self) -> Option<Result<Vec<Rung>>> {
        let (_, why) = self
            .named()
            .ok()
            .filter(|(name, _)| name.starts_with("routine "))?;
        let text = self.text.clone().unwrap_or_default();
        let is = |language: Language| why.starts_with(language.is());
        let elements = [
            (Language::FunctionBlocks, "<FBDContent"),
            (Language::Chart, "<SFCContent"),
            (Language::Protected, "<EncodedData"),
        ];
        let element = elements.into_iter().find(|(language, _)| is(*language));
        let whole = |language: Language, text: String| {
            let foreign = Some(Foreign { language, text });
            vec![Rung {
                foreign,
                ..Rung::default()
            }]
        };
        Some(match element {
            None if is(Language::StructuredText) => Ok(whole(Language::StructuredText, text)),
            None if why.contains(LEFT) => Ok(rungs(&text)),
            Some((language, begin)) if text.starts_with(begin) && xml::Xml::parse(&text).is_ok() => {
                Ok(whole(language, text))
            }
            _ => Err(format!(
                "`{}` is not read, and not known as an export has it",
                self.about
            )),
        })
    }
}

/// Rungs as lines: each ends with a semicolon.
fn rungs(text: &str) -> Vec<Rung> {
    let mut rungs: Vec<Rung> = Vec::new();
    let mut is_open = false;
    for line in text.lines() {
        match rungs.last_mut() {
            Some(last) if is_open => last.text.push_str(&format!("\n{line}")),
            _ => rungs.push(Rung {
                text: line.to_owned(),
                ..Rung::default()
            }),
        }
        is_open = !line.trim_end().ends_with(';');
    }
    rungs
}

impl Writer<'_> {
    /// The routine that was not read for which a network stands.
    pub(super) fn unread_routine(&mut self, network: &Network) -> Option<Result<Vec<Rung>>> {
        let [block] = &network.blocks[..] else { return None };
        let BlockKind::User(user) = block.kind else {
            return None;
        };
        let Some(super::native::Known::Unread(part)) = self.facts.known.get(&user) else {
            return None;
        };
        let at = network.location.range.start().into();
        let routine = part.routine()?;
        Some(routine.map(|mut rungs| {
            for rung in &mut rungs {
                rung.at = at;
            }
            rungs
        }))
    }

    /// Whether a network only says that a program runs at times of its own.
    pub(super) fn is_of_a_task(&self, network: &Network) -> bool {
        let [block] = &network.blocks[..] else {
            return false;
        };
        let BlockKind::User(user) = block.kind else {
            return false;
        };
        match self.facts.known.get(&user) {
            Some(super::native::Known::Unread(part)) => part.about.starts_with("program "),
            _ => false,
        }
    }

    /// An instruction that was not read.
    pub(super) fn unread_call(&mut self, part: &UnreadPart, block: &Block) -> Result<Series> {
        let (name, why) = part.named()?;
        if !ladder_syntax::is_identifier(name) {
            return Err(if name.starts_with("routine ") {
                "there a routine in another language has no rungs".to_owned()
            } else {
                format!("{name} is not written: it runs at times of its own there")
            });
        }
        let operands = match (&part.text, block.arguments.first()) {
            (Some(text), _) => text.lines().next().unwrap_or_default().to_owned(),
            (None, Some(bound)) => unread_operands(self.source(bound.range)),
            (None, None) => String::new(),
        };
        if name == "JSR" && why.starts_with("there is no routine") {
            let routine = operands.split(',').next().unwrap_or_default();
            if self
                .input
                .analysis
                .context
                .function(&Name::new(routine))
                .is_some()
            {
                return Err(format!(
                    "it would call the routine `{routine}`, and is not read here"
                ));
            }
            self.note(&format!(
                "there is no routine `{routine}`, as there was none where it was read"
            ));
        }
        Ok(vec![it(name, &[&operands])])
    }

    /// The rungs of a routine as they are, or the other language that it is in: it is all of the routine then.
    pub(super) fn in_one_language(&mut self, mut rungs: Vec<Rung>) -> (Vec<Rung>, Option<Foreign>) {
        if let [only] = &mut rungs[..]
            && let Some(foreign) = only.foreign.take()
        {
            return (Vec::new(), Some(foreign));
        }
        for rung in rungs.iter_mut().filter(|rung| rung.foreign.is_some()) {
            let why = "there a routine in another language has no rungs besides";
            self.report
                .refused(self.input.lines.place(self.input.text, rung.at), "network", why);
            "NOP();".clone_into(&mut rung.text);
            rung.comment = Some(format!("not written: {why}"));
            rung.foreign = None;
        }
        (rungs, None)
    }
}
