//! Whether anything waits for what is being read or looked for: what takes long is given up when a newer text is there.

use std::cell::Cell;

/// This many networks, tags or declarations are checked between two questions. What an edit usually concerns is less, and is never given up.
pub const BETWEEN: usize = 256;

/// Asks again and again while something is being read or looked for.
pub(crate) struct StillWanted<'a> {
    ask: &'a dyn Fn() -> bool,
    /// This many more are checked before the next question.
    left: Cell<usize>,
}

impl<'a> StillWanted<'a> {
    pub(crate) fn new(ask: &'a dyn Fn() -> bool) -> StillWanted<'a> {
        StillWanted {
            ask,
            left: Cell::new(BETWEEN),
        }
    }

    /// A network, a tag or a declaration is about to be checked; none if nobody wants that any longer.
    pub(crate) fn one_more(&self) -> Option<()> {
        let left = self.left.get();
        if left > 0 {
            self.left.set(left - 1);
            return Some(());
        }
        self.left.set(BETWEEN);
        (self.ask)().then_some(())
    }
}

#[cfg(test)]
mod tests {
    use super::BETWEEN;
    use crate::{AnalyzeOptions, Others, analyze, context};
    use ladder_syntax::parse;
    use std::cell::Cell;
    use std::fmt::Write as _;
    use std::sync::Arc;

    /// All networks read one tag.
    fn program(networks: usize, ty: &str) -> String {
        let mut text = format!("VAR\n    enable : {ty};\nEND_VAR\n\n");
        for n in 0..networks {
            let _ = writeln!(text, "+--[ ]( enable )--( )( out_{n} )--+\n");
        }
        text
    }

    /// What is found, and how often it was asked whether that is wanted: so often the answer is yes.
    fn asked(before: Option<&str>, text: &str, patience: usize) -> (Option<usize>, usize) {
        let read = |text: &str| Arc::new(parse(text));
        let others = Others::default();
        let alone = AnalyzeOptions::new("main.clad").among(&others);
        let before = before.map(|before| analyze(&read(before), alone));
        let known = before.as_ref().map(|before| &*before.context);
        let parsed = match known {
            Some(known) => Arc::new(known.parse.updated(&known.parse.to_string(), text)),
            None => read(text),
        };
        let context = Arc::new(context(&parsed, alone.after(before.as_ref())));
        let asked = Cell::new(0);
        let wanted = || {
            asked.set(asked.get() + 1);
            asked.get() <= patience
        };
        let found = alone.after(before.as_ref()).check_while(context, &wanted);
        (found.map(|found| found.findings().len()), asked.get())
    }

    /// Whether the names of a text are joined, and how often it was asked whether that is wanted: so often the answer is yes.
    fn joined(before: Option<&str>, text: &str, patience: usize) -> (bool, usize) {
        let others = Others::default();
        let options = AnalyzeOptions::new("main.clad").among(&others);
        let before = before.map(|before| context(&Arc::new(parse(before)), options));
        let parsed = Arc::new(match &before {
            Some(before) => before.parse.updated(&before.parse.to_string(), text),
            None => parse(text),
        });
        let asked = Cell::new(0);
        let wanted = || {
            asked.set(asked.get() + 1);
            asked.get() <= patience
        };
        let context = options
            .after_context(before.as_ref())
            .context_while(&parsed, &wanted);
        (context.is_some(), asked.get())
    }

    #[test]
    fn names_are_given_up() {
        let networks = 4 * BETWEEN;
        let text = program(networks, "BOOL");
        // The declaration; each network when it is read and when its names are joined; each coil for its type.
        let times = (1 + 3 * networks) / (BETWEEN + 1);
        assert_eq!(joined(None, &text, usize::MAX), (true, times));
        for patience in [0, 1, networks / BETWEEN, times - 1] {
            assert_eq!(joined(None, &text, patience), (false, patience + 1));
        }
        // After an edit, too.
        let edited = text.replace("out_700 ", "out_700_a ");
        assert_eq!(joined(Some(&text), &edited, usize::MAX), (true, times));
        assert_eq!(joined(Some(&text), &edited, 1), (false, 2));
    }

    #[test]
    fn a_long_section_is_given_up() {
        let declarations =
            (0..4 * BETWEEN).fold(String::new(), |text, n| format!("{text}    tag_{n} : BOOL;\n"));
        let text = format!("VAR\n{declarations}END_VAR\n");
        assert_eq!(joined(None, &text, usize::MAX), (true, 3));
        assert_eq!(joined(None, &text, 1), (false, 2));
    }

    #[test]
    fn rules_are_given_up() {
        let networks = 4 * BETWEEN;
        let text = program(networks, "BOOL");
        let (found, times) = asked(None, &text, usize::MAX);
        assert!(found.is_some());
        // Each network twice, and each tag once.
        assert_eq!(times, 3 * networks / (BETWEEN + 1));
        assert_eq!(asked(None, &text, 0), (None, 1));
        assert_eq!(asked(None, &text, 3), (None, 4));
        let other_type = program(networks, "DINT");
        let (found, _) = asked(Some(&text), &other_type, usize::MAX);
        assert!(found.is_some_and(|found| found >= networks), "{found:?}");
        assert_eq!(asked(Some(&text), &other_type, 1), (None, 2));
    }
}
