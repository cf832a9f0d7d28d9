//! Work that takes long is given up once nobody waits for it.

use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// This many networks, tags or declarations are checked between two questions. What an edit usually concerns is less, and is never given up.
pub const BETWEEN: usize = 256;

/// Whether work that takes long may stop before its end. Clones are one: who cancels one of them cancels all.
pub struct Cancel {
    source: Arc<Source>,
    /// This many more networks, tags or declarations are checked before the next question. Each clone counts for itself.
    left: AtomicUsize,
}

#[derive(Default)]
struct Source {
    is_cancelled: AtomicBool,
    /// What cancels as well, for as long as it says so.
    condition: Option<Box<dyn Fn() -> bool + Send + Sync>>,
}

impl Cancel {
    /// Cancelled while this says so, too: it is asked now and then, from the thread that works.
    pub fn when(condition: impl Fn() -> bool + Send + Sync + 'static) -> Cancel {
        Cancel::of(Arc::new(Source {
            condition: Some(Box::new(condition)),
            ..Source::default()
        }))
    }

    fn of(source: Arc<Source>) -> Cancel {
        Cancel {
            source,
            left: AtomicUsize::new(BETWEEN),
        }
    }

    /// Whether the work may stop: its result would go nowhere.
    pub fn is_cancelled(&self) -> bool {
        let Source {
            is_cancelled,
            condition,
        } = &*self.source;
        is_cancelled.load(Ordering::Relaxed) || condition.as_ref().is_some_and(|condition| condition())
    }

    /// Tells the work to stop.
    pub fn cancel(&self) {
        self.source.is_cancelled.store(true, Ordering::Relaxed);
    }

    /// A guard that cancels when it is dropped: the task that awaits the work holds it.
    pub fn on_drop(&self) -> CancelOnDrop {
        CancelOnDrop(self.clone())
    }

    /// A network, a tag or a declaration is about to be checked; none if that is cancelled. It is asked rarely, for asking takes time.
    pub(crate) fn one_more(&self) -> Option<()> {
        let left = self.left.load(Ordering::Relaxed);
        if left > 0 {
            self.left.store(left - 1, Ordering::Relaxed);
            return Some(());
        }
        self.left.store(BETWEEN, Ordering::Relaxed);
        (!self.is_cancelled()).then_some(())
    }
}

impl Default for Cancel {
    /// Not cancelled yet.
    fn default() -> Cancel {
        Cancel::of(Arc::default())
    }
}

impl Clone for Cancel {
    fn clone(&self) -> Cancel {
        Cancel::of(self.source.clone())
    }
}

impl fmt::Debug for Cancel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Cancel")
    }
}

/// See [`Cancel::on_drop`].
#[derive(Debug)]
pub struct CancelOnDrop(Cancel);

impl Drop for CancelOnDrop {
    fn drop(&mut self) {
        self.0.cancel();
    }
}

#[cfg(test)]
mod tests {
    use super::{BETWEEN, Cancel};
    use crate::{AnalyzeOptions, Others, analyze, context};
    use ladder_syntax::parse;
    use std::fmt::Write as _;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicUsize, Ordering};

    /// All networks read one tag.
    fn program(networks: usize, ty: &str) -> String {
        let mut text = format!("VAR\n    enable : {ty};\nEND_VAR\n\n");
        for n in 0..networks {
            let _ = writeln!(text, "+--[ ]( enable )--( )( out_{n} )--+\n");
        }
        text
    }

    /// Cancelled when it has been asked more often, and how often it was.
    fn after(patience: usize) -> (Cancel, Arc<AtomicUsize>) {
        let asked = Arc::<AtomicUsize>::default();
        let counter = asked.clone();
        let cancel = Cancel::when(move || counter.fetch_add(1, Ordering::Relaxed) >= patience);
        (cancel, asked)
    }

    /// What is found, and how often it was asked whether that is cancelled: so often the answer is no.
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
        let (cancel, asked) = after(patience);
        let found = alone.after(before.as_ref()).check_unless(context, &cancel);
        (
            found.map(|found| found.findings().len()),
            asked.load(Ordering::Relaxed),
        )
    }

    /// Whether the names of a text are joined, and how often it was asked whether that is cancelled: so often the answer is no.
    fn joined(before: Option<&str>, text: &str, patience: usize) -> (bool, usize) {
        let others = Others::default();
        let options = AnalyzeOptions::new("main.clad").among(&others);
        let before = before.map(|before| context(&Arc::new(parse(before)), options));
        let parsed = Arc::new(match &before {
            Some(before) => before.parse.updated(&before.parse.to_string(), text),
            None => parse(text),
        });
        let (cancel, asked) = after(patience);
        let context = options
            .after_context(before.as_ref())
            .context_unless(&parsed, &cancel);
        (context.is_some(), asked.load(Ordering::Relaxed))
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
