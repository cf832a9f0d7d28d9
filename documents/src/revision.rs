//! One state of one open document.

mod text;

use std::borrow::Cow;
use std::path::Path;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use ladder_analysis::context::Context;
use ladder_analysis::program::Program;
use ladder_analysis::{AnalyzeOptions, Cancel, Linked, NotWhole, Others, RuleSettings, analyze, link_files};
use ladder_format::{Edit, Options, format};
use ladder_notations::{ReadError, of_workspaces};
use ladder_syntax::{MAX_OPEN_BYTES, MAX_OPEN_LINES, Parse, TextRange, TextSize, parse};
use ladder_workspace::Member;
use ropey::Rope;

use crate::byte_edit::{ByteEdit, EditLog, Since};
use crate::kind::Kind;
use crate::language::Analysis;
use crate::library_source;
use crate::membership::Membership;
use crate::neighbours::Affected;
use crate::opened::Opened;
use crate::position::Encoding;

/// What was made of a text.
#[derive(Debug, Default)]
struct Made {
    /// With the serial number of the revision.
    context: Option<(u64, Arc<Context>)>,
    analysis: Option<Analysis>,
    /// What has changed since the names were made.
    since: EditLog,
}

/// What changes have done to a text.
#[derive(Debug, Clone)]
pub(crate) struct Edited {
    /// The stretches that were replaced, one after the other; none if the whole text was.
    pub(crate) edits: Option<Vec<ByteEdit>>,
    /// Where the last of them begins, in bytes.
    pub(crate) at: usize,
}

/// A document as it was between two changes. It never changes, so a thread that holds one can work on it undisturbed
/// while the editor types on; whether it is still what the editor shows is for the store to say.
#[derive(Debug)]
pub struct Revision {
    /// The document's address, as the editor spells it.
    pub uri: Arc<str>,
    /// The editor's number for this state.
    pub version: i32,
    kind: Kind,
    /// Which opening of the document this belongs to: a file that is closed and opened again begins again, and
    /// may use the same versions for other texts.
    pub(crate) opening: u64,
    /// Unique over all revisions.
    serial: u64,
    encoding: Encoding,
    rope: Rope,
    /// Where the text was changed last, in bytes; its beginning if it never was.
    edited: usize,
    /// Where the file lies, if it is one.
    place: Option<Membership>,
    context: OnceLock<Arc<Context>>,
    /// The names without what large files show that are not read yet.
    first: OnceLock<Option<Arc<Context>>>,
    /// Held by who joins the names.
    joining: Mutex<()>,
    /// This many wait for the names and cannot do without.
    waiting: Arc<AtomicUsize>,
    analysis: OnceLock<Analysis>,
    /// Held by who looks for what is wrong.
    looking: Mutex<()>,
    /// What the text becomes, if it is a program of another system.
    opened: OnceLock<Result<Opened, ReadError>>,
    /// What was made last of any revision of the document: the next one begins with its names.
    latest: Arc<Mutex<Made>>,
}

impl Revision {
    pub(crate) fn new(
        uri: Arc<str>,
        kind: Kind,
        version: i32,
        opening: u64,
        encoding: Encoding,
        rope: Rope,
        place: Option<Membership>,
    ) -> Self {
        static SERIAL: AtomicU64 = AtomicU64::new(0);
        let serial = SERIAL.fetch_add(1, Ordering::Relaxed);
        Revision {
            uri,
            version,
            kind,
            opening,
            serial,
            encoding,
            rope,
            edited: 0,
            place,
            context: OnceLock::new(),
            first: OnceLock::new(),
            joining: Mutex::default(),
            waiting: Arc::default(),
            analysis: OnceLock::new(),
            looking: Mutex::default(),
            opened: OnceLock::new(),
            latest: Arc::default(),
        }
    }

    /// The document with another text, or to be analysed again.
    pub(crate) fn followed_by(&self, version: i32, rope: Rope, edited: Edited) -> Self {
        let place = self.place.as_ref().map(Membership::again);
        let next = Revision::new(
            self.uri.clone(),
            self.kind,
            version,
            self.opening,
            self.encoding,
            rope,
            place,
        );
        self.latest().since.push(next.serial, edited.edits);
        Revision {
            edited: edited.at,
            latest: Arc::clone(&self.latest),
            ..next
        }
    }

    /// The text of a file that no editor shows, at version 0 of nothing.
    pub fn on_disk(uri: &str, encoding: Encoding, text: &str, place: Membership) -> Self {
        let rope = Rope::from_str(text);
        let kind = of_workspaces(&place.path).map_or(Kind::Program, Kind::Foreign);
        Revision::new(Arc::from(uri), kind, 0, 0, encoding, rope, Some(place))
    }

    /// The names, networks and blocks of the text, read at the first call, or `None` for a text over [`MAX_OPEN_BYTES`] or
    /// [`MAX_OPEN_LINES`]; of a program of another system those of its ladder text. Takes milliseconds on a large file: for a blocking thread.
    pub fn context(&self) -> Option<&Arc<Context>> {
        if self.kind.notation().is_some() {
            return Some(&self.analysis()?.whole().context);
        }
        if let Some(known) = self.context.get() {
            return Some(known);
        }
        // Who joins them already does not give up now.
        self.waiting.fetch_add(1, Ordering::Relaxed);
        let context = self.context_unless(&Cancel::default());
        self.waiting.fetch_sub(1, Ordering::Relaxed);
        context
    }

    /// The names for a person who looks at the text while large files of its workspace are still to be read: without what those
    /// show, and false. As [`Revision::context`], and true, where there are none.
    pub fn first_context(&self) -> Option<(&Arc<Context>, bool)> {
        let early = (self.context.get().is_none() && self.fits()).then_some(self.place.as_ref());
        let early = early
            .flatten()
            .and_then(|place| place.neighbours.first_view(&place.path));
        let Some((name, others)) = early else {
            return Some((self.context()?, true));
        };
        let first = self.first.get_or_init(|| {
            let parse = self.parse(None, Since::Unknown);
            let options = AnalyzeOptions::new(&name).among(&others);
            Some(Arc::new(ladder_analysis::context(&parse, options)))
        });
        Some((first.as_ref()?, false))
    }

    /// What is found among the small files while large files of the workspace are still to be read; nothing where none are.
    pub fn first_analysis(&self) -> Option<Analysis> {
        let (context, false) = self.first_context()? else {
            return None;
        };
        let place = self.place.as_ref()?;
        let rules = place.neighbours.rules(&place.path);
        Analysis::of(context, None, &rules, &Cancel::default())
    }

    /// Whether anything was shown of the text while large files of its workspace were still to be read.
    pub fn was_shown_early(&self) -> bool {
        self.first.get().is_some()
    }

    /// The same unless that is cancelled and no thread waits in [`Revision::context`]: where the names of the whole file are joined
    /// again that is given up then.
    fn context_unless(&self, cancel: &Cancel) -> Option<&Arc<Context>> {
        // Offsets of the inner crates are 32 bits wide; they read slices, not ropes.
        if !self.fits() {
            return None;
        }
        if let Some(known) = self.context.get() {
            return Some(known);
        }
        // Who comes while another joins them gets what that one makes, or makes it if that one gives up.
        let _joining = self.joining.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = self.context.get() {
            return Some(known);
        }
        let (waiting, cancel) = (self.waiting.clone(), cancel.clone());
        let cancel = Cancel::when(move || cancel.is_cancelled() && waiting.load(Ordering::Relaxed) == 0);
        let context = self.join(&cancel)?;
        Some(self.context.get_or_init(|| context))
    }

    /// Joins the names; none if that is given up.
    fn join(&self, cancel: &Cancel) -> Option<Arc<Context>> {
        let (before, since) = {
            let latest = self.latest();
            (latest.context.clone(), latest.since.until(self.serial))
        };
        let since = match &before {
            Some((serial, _)) if *serial <= self.serial => since,
            _ => Since::Unknown,
        };
        let known = before.as_ref().map(|(_, context)| &**context);
        let parse = self.parse(known, since);
        let read = |name: &str, others: &Others| {
            let options = AnalyzeOptions::new(name).among(others).after_context(known);
            options.context_unless(&parse, cancel).map(Arc::new)
        };
        let context = match &self.place {
            Some(place) => {
                let (name, others) = place.view();
                read(&name, &others)?
            }
            None => read(self.name(), &Others::alone())?,
        };
        let mut latest = self.latest();
        if latest
            .context
            .as_ref()
            .is_none_or(|(serial, _)| *serial <= self.serial)
        {
            latest.context = Some((self.serial, Arc::clone(&context)));
            latest.since.begin_at(self.serial);
        }
        Some(context)
    }

    /// The lines of the text. What an earlier text has in common with it is taken over: `since` is what leads from there to
    /// here.
    fn parse(&self, before: Option<&Context>, since: Since) -> Arc<Parse> {
        let before = before.map(|context| &context.parse);
        Arc::new(match (before, since) {
            (Some(before), Since::Same) => return Arc::clone(before),
            (Some(before), Since::Edited(edit)) => {
                let size = |bytes: usize| TextSize::new(bytes as u32);
                let old = TextRange::new(size(edit.old.start), size(edit.old.end));
                let stretch = |range| self.stretch(range);
                before.edited_in(self.len(), stretch, old, size(edit.new_len))
            }
            (Some(before), Since::Unknown) => before.updated(&before.to_string(), &self.text()),
            (None, _) => parse(&self.text()),
        })
    }

    /// The same with all that is found in it: for those who cannot do without.
    pub fn analysis(&self) -> Option<&Analysis> {
        if self.kind.notation().is_some() {
            return Some(self.opened()?.as_ref().ok()?.analysis());
        }
        self.context()?;
        self.analysis_unless(&Cancel::default())
    }

    /// The same unless it is cancelled: work that concerns a large part of the text is given up then.
    pub fn analysis_unless(&self, cancel: &Cancel) -> Option<&Analysis> {
        let context = self.context_unless(cancel)?;
        if let Some(known) = self.analysis.get() {
            return Some(known);
        }
        // Who comes while another looks waits for what that one finds.
        let _looking = self.looking.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = self.analysis.get() {
            return Some(known);
        }
        let rules = match &self.place {
            Some(place) => place.neighbours.rules(&place.path),
            None => RuleSettings::default(),
        };
        let before = self.latest().analysis.clone();
        let analysis = Analysis::of(context, before.as_ref(), &rules, cancel)?;
        self.latest().analysis = Some(analysis.clone());
        Some(self.analysis.get_or_init(|| analysis))
    }

    /// Whether an editor shows it.
    pub const fn is_open(&self) -> bool {
        self.opening > 0
    }

    /// What the text is.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// What a program of another system becomes, computed at the first call; `None` for any other text, or one that is
    /// too large. For a blocking thread.
    pub fn opened(&self) -> Option<&Result<Opened, ReadError>> {
        let notation = self.kind.notation()?;
        self.fits().then(|| {
            self.opened.get_or_init(|| {
                let file = self.place.as_ref();
                let file = file.map(|place| (place.neighbours.foreign(), &*place.path));
                Opened::read(notation, &self.stem(), &self.text(), file, |parse| {
                    match &self.place {
                        Some(place) => {
                            let (name, others) = place.neighbours.view(&place.path);
                            let rules = place.neighbours.rules(&place.path);
                            analyze(
                                parse,
                                AnalyzeOptions::new(&name).among(&others).with_rules(&rules),
                            )
                        }
                        None => analyze(parse, self.name()),
                    }
                })
            })
        })
    }

    /// The ladder text that runs: of a program of another system what it becomes, of settings what their tasks run, else the text
    /// itself. Of what cannot be read it is the text itself, too.
    pub fn in_ladder(self: &Arc<Revision>) -> Arc<Revision> {
        let of = |text: &str| {
            let place = self.place.as_ref().map(Membership::again);
            let (uri, rope) = (self.uri.clone(), Rope::from_str(text));
            Revision::new(
                uri,
                Kind::Program,
                self.version,
                self.opening,
                self.encoding,
                rope,
                place,
            )
        };
        if let Some(Ok(opened)) = self.opened() {
            let made = of(opened.foreign().ladder());
            let _ = made.context.set(Arc::clone(&opened.analysis().whole().context));
            let _ = made.analysis.set(opened.analysis().clone());
            return Arc::new(made);
        }
        let settings = self.place.as_ref().filter(|_| self.kind == Kind::Settings);
        let text = settings.and_then(|place| place.neighbours.text_on_disk(&place.path).ok());
        text.map_or_else(|| Arc::clone(self), |text| Arc::new(of(&text)))
    }

    /// Whether the text is small enough to be read.
    pub fn fits(&self) -> bool {
        self.len() <= MAX_OPEN_BYTES && self.rope.len_lines() <= MAX_OPEN_LINES
    }

    fn latest(&self) -> MutexGuard<'_, Made> {
        self.latest.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Tells the other files of the workspace what this one says now. Returns, once, who sees something else than before.
    /// As costly as [`Revision::analysis`].
    pub fn tell_neighbours(&self) -> Affected {
        let Some(place) = &self.place else {
            return Affected::default();
        };
        if self.kind.notation().is_some() {
            return match self.opened().filter(|_| of_workspaces(&place.path).is_some()) {
                Some(Ok(opened)) => place.tell(opened.analysis().whole(), Some(opened.foreign())),
                _ => Affected::default(),
            };
        }
        match self.analysis() {
            Some(analysis) => place.tell(analysis.whole(), None),
            None => Affected::default(),
        }
    }

    /// Whether a finding that is known of it names a place in a file.
    pub fn relates_to(&self, file: &str) -> bool {
        let mut findings = self
            .analysis
            .get()
            .into_iter()
            .flat_map(|known| known.whole().findings());
        findings.any(|found| found.relates_to(file))
    }

    /// Where the file lies, if it is one.
    pub fn place(&self) -> Option<&Membership> {
        self.place.as_ref()
    }

    /// What runs: the program with what it uses of other files; `None` for a text that is too large.
    pub fn program(&self) -> Option<Result<Arc<Program>, NotWhole>> {
        Some(self.linked()?.map(|linked| linked.program))
    }

    /// The same with those files.
    pub fn linked(&self) -> Option<Result<Linked, NotWhole>> {
        let analysis = self.analysis()?.whole();
        Some(match &self.place {
            Some(place) => place.neighbours.link(&place.path, analysis),
            None => link_files(analysis, &|_| None),
        })
    }

    /// What a simulation of it runs: the program beside the models of its machine that the settings name, if it has to do with them.
    /// In their place what is wrong with them, in words.
    pub fn running(&self) -> Option<Result<Result<Arc<Program>, String>, NotWhole>> {
        let alone = || Some(self.program()?.map(Ok));
        let Some(place) = &self.place else { return alone() };
        let settings = place.neighbours.simulate(&place.path);
        let plants = settings.plants_of(&place.path).iter();
        let plants: Vec<_> = plants
            .map(|plant| (plant.file.path(), plant.name.clone()))
            .collect();
        if plants.is_empty() {
            return alone();
        }
        let analysis = self.analysis()?.whole();
        let linked = place
            .neighbours
            .link_beside(&place.path, analysis, &plants, &settings.connects);
        Some(match linked {
            Err(why) => Err(why),
            Ok((linked, _)) if !linked.program.is_connected() => return alone(),
            Ok((linked, errors)) => Ok(match errors.first() {
                None => Ok(linked.program),
                Some(error) => Err(format!("ladder.toml, plant: {}: {}", error.message, error.help)),
            }),
        })
    }

    /// The same of an earlier text of the file, among the other files as they are now.
    pub fn earlier(&self, text: &str) -> (Arc<ladder_analysis::Analysis>, Result<Linked, NotWhole>) {
        let parse = Arc::new(ladder_syntax::parse(text));
        let Some(place) = &self.place else {
            let analysis = Arc::new(analyze(&parse, self.name()));
            let linked = link_files(&analysis, &|_| None);
            return (analysis, linked);
        };
        let (name, others) = place.neighbours.view(&place.path);
        let analysis = Arc::new(analyze(&parse, AnalyzeOptions::new(&name).among(&others)));
        let linked = place.neighbours.link(&place.path, &analysis);
        (analysis, linked)
    }

    /// How the workspace has its programs run.
    pub fn simulate(&self) -> ladder_workspace::Simulate {
        let place = self.place.as_ref();
        place.map_or_else(Default::default, |place| place.neighbours.simulate(&place.path))
    }

    /// The controller that its workspace watches.
    pub fn online(&self) -> Option<ladder_workspace::Online> {
        let place = self.place.as_ref()?;
        place.neighbours.online(&place.path)
    }

    /// What its workspace serves on Modbus.
    pub fn served(&self) -> Option<ladder_workspace::ServeModbus> {
        let place = self.place.as_ref()?;
        place.neighbours.served(&place.path)
    }

    /// The edits that bring the text into the layout that its workspace asks for.
    pub fn format(&self) -> Option<Vec<Edit>> {
        Some(format(&self.context()?.parse, &self.format_options()))
    }

    /// The layout that its workspace asks for.
    pub fn format_options(&self) -> Options {
        match &self.place {
            Some(place) => place.neighbours.format_options(&place.path),
            None => Options::default(),
        }
    }

    /// What messages call the file: the last part of its address.
    pub fn name(&self) -> &str {
        self.uri.rsplit('/').next().unwrap_or(&self.uri)
    }

    /// Where the file lies; the name, where it is none.
    pub fn path(&self) -> &Path {
        self.place
            .as_ref()
            .map_or_else(|| Path::new(self.name()), |place| &place.path)
    }

    /// The name of the file, as the disk has it.
    pub fn file_name(&self) -> Cow<'_, str> {
        let name = self.place.as_ref().and_then(|place| place.path.file_name());
        name.map_or(Cow::Borrowed(self.name()), |name| name.to_string_lossy())
    }

    /// The name without its ending, which names the program of another system.
    pub fn stem(&self) -> Cow<'_, str> {
        let stem = self.place.as_ref().and_then(|place| place.path.file_stem());
        stem.unwrap_or_else(|| Path::new(self.name()).file_stem().unwrap_or_default())
            .to_string_lossy()
    }

    /// Address and text of another file of the workspace or of the library, by the name that findings and programs know it by.
    pub fn text_next_to(&self, file: &str) -> Option<(String, Member)> {
        if let Some((address, text)) = library_source::file(file) {
            return Some((address, Member::Ladder(text.to_owned())));
        }
        let place = self.place.as_ref()?;
        let (path, text) = place.neighbours.text_of(&place.path, file)?;
        Some((super::address::uri_of(&path), text))
    }

    /// The ladder texts of a program's files, this one's own first.
    pub fn texts(&self, files: &[String]) -> Vec<String> {
        let others = files.iter().skip(1).map(|name| {
            let found = self.text_next_to(name);
            found.map_or_else(String::new, |(_, text)| text.ladder().to_owned())
        });
        let own = match self.opened() {
            Some(Ok(opened)) => opened.foreign().ladder().to_owned(),
            _ => self.rope.to_string(),
        };
        std::iter::once(own).chain(others).collect()
    }

    /// Whether both are the same state of the same document.
    pub fn is(&self, other: &Revision) -> bool {
        self.serial == other.serial
    }

    /// Where the person works: where the text was changed last, in bytes.
    pub fn edited(&self) -> TextSize {
        TextSize::try_from(self.edited).unwrap_or_default()
    }

    /// The unit of positions.
    pub fn encoding(&self) -> Encoding {
        self.encoding
    }

    pub(crate) fn rope(&self) -> &Rope {
        &self.rope
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::position::{Position, Range};
    use crate::store::Documents;
    use std::thread::{JoinHandle, spawn};

    #[test]
    fn who_asks_for_names_waits_for_no_rule() {
        let documents = Documents::default();
        let text = "+--[ ]( a )--( )( b )--+\n";
        let revision = documents.open_at("file:///a.clad", Kind::Program, 1, Encoding::Utf8, text, None);
        assert_eq!(revision.context().unwrap().networks.len(), 1);
        assert!(revision.analysis.get().is_none());
        assert!(revision.analysis().is_some());
    }

    #[test]
    fn large_work_is_given_up_when_the_text_is_another_one() {
        let documents = Arc::<Documents>::default();
        let uri = "file:///a.clad";
        let text = "+--[ ]( a )--( )( b )--+\n".repeat(2 * ladder_analysis::BETWEEN);
        let first = documents.open_at(uri, Kind::Program, 1, Encoding::Utf8, &text, None);
        let unless_shown = |revision: &Arc<Revision>| {
            let (documents, revision) = (documents.clone(), revision.clone());
            Cancel::when(move || !documents.is_current(&revision))
        };
        let text = text.replacen("a )", "c )", 1);
        let second = documents
            .change(uri, 2, &[crate::edit::Change::Whole(text.clone())])
            .unwrap();
        assert!(first.context().is_some());
        assert!(first.analysis_unless(&unless_shown(&first)).is_none());
        let found = |revision: &Arc<Revision>| {
            let analysis = revision.analysis_unless(&unless_shown(revision)).unwrap();
            let all = analysis.findings().iter();
            all.map(|found| (found.rule, found.range)).collect::<Vec<_>>()
        };
        let from_scratch = documents.open_at("file:///b.clad", Kind::Program, 1, Encoding::Utf8, &text, None);
        let expected = from_scratch.analysis().unwrap().findings().iter();
        let expected: Vec<_> = expected.map(|found| (found.rule, found.range)).collect();
        assert!(!expected.is_empty());
        assert_eq!(found(&second), expected);
    }

    /// A text, and which tags it names, how often, and whether it declares them.
    fn told(context: &Context) -> (String, Vec<(String, usize, bool)>) {
        let tags = context.scopes[0].tags.iter();
        let tags = tags.map(|tag| (tag.name.to_string(), context.uses(tag).count(), tag.is_declared()));
        (context.parse.to_string(), tags.collect())
    }

    /// A text, and the same after an edit that has its names joined again.
    fn opened_and_edited(documents: &Documents) -> [Arc<Revision>; 2] {
        let uri = "file:///a.clad";
        let text = "+--[ ]( a )--( )( b )--+\n\n".repeat(2 * ladder_analysis::BETWEEN);
        let first = documents.open_at(uri, Kind::Program, 1, Encoding::Utf8, &text, None);
        let start = Position {
            line: 0,
            character: 0,
        };
        let change = crate::edit::Change::Part {
            range: Range { start, end: start },
            text: "VAR\n    a : BOOL;\nEND_VAR\n\n".to_owned(),
        };
        let edited = documents.change(uri, 2, &[change]).unwrap();
        [first, edited]
    }

    #[test]
    fn names_that_were_given_up_are_whole_when_a_request_asks_for_them() {
        for known in [false, true] {
            let documents = Documents::default();
            let [first, edited] = opened_and_edited(&documents);
            if known {
                assert!(first.context().is_some());
            }
            assert!(edited.analysis_unless(&Cancel::when(|| true)).is_none());
            assert!(edited.context.get().is_none() && edited.latest().context.is_some() == known);
            let uri = "file:///b.clad";
            let from_scratch = documents.open_at(uri, Kind::Program, 1, Encoding::Utf8, &edited.text(), None);
            assert_eq!(
                told(edited.context().unwrap()),
                told(from_scratch.context().unwrap())
            );
            assert!(edited.analysis().is_some());
        }
    }

    #[test]
    fn names_that_a_request_waits_for_are_not_given_up() {
        let documents = Documents::default();
        let [_, edited] = opened_and_edited(&documents);
        let request = Arc::<OnceLock<JoinHandle<()>>>::default();
        let (text, coming) = (edited.clone(), request.clone());
        // The text is no longer shown, and a request for its names comes in.
        let cancel = Cancel::when(move || {
            let asking = text.clone();
            coming.get_or_init(|| spawn(move || assert!(asking.context().is_some())));
            while text.waiting.load(Ordering::Relaxed) == 0 {
                std::thread::yield_now();
            }
            true
        });
        assert!(edited.context_unless(&cancel).is_some());
        drop(cancel);
        let request = Arc::into_inner(request).and_then(OnceLock::into_inner);
        request.expect("it was asked").join().unwrap();
        assert_eq!(edited.waiting.load(Ordering::Relaxed), 0);
    }
}
