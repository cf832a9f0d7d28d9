//! From a program to its entries: each line of the text goes into one of them.

use crate::canonical::{self, Canonical};
use crate::outline::{Entry, Kind};
use ladder_analysis::asked::asked;
use ladder_analysis::context::{Body, Context};
use ladder_instructions::Op;
use ladder_syntax::ast::{AstNode, Declaration, NodeView, StructHeader, TokenView};
use ladder_syntax::{Item, LineKind, Name, TextRange, TextSize};
use std::ops::Range;
use std::sync::Arc;

/// For each network the tags that it writes.
fn written(context: &Context) -> Vec<Vec<&str>> {
    let mut written = vec![Vec::new(); context.networks.len()];
    for tag in context.scopes.iter().flat_map(|scope| &scope.tags) {
        for place in context.writers(tag) {
            let names: &mut Vec<&str> = &mut written[place.network];
            if names.last() != Some(&tag.name.as_str()) {
                names.push(&tag.name);
            }
        }
    }
    written
}

fn written_names<'t>(names: impl Iterator<Item = TokenView<'t>>) -> Vec<String> {
    names.map(|name| name.text().to_owned()).collect()
}

/// Reads the entries of a text.
struct Reader<'c> {
    context: &'c Context,
    written: Vec<Vec<&'c str>>,
    main: Arc<str>,
    /// The entries that were read so far, of the text and of each thing that is open in it.
    open: Vec<Vec<Entry>>,
    /// What is open.
    headers: Vec<Entry>,
    /// Comment, rail and blank lines that wait for what is below them.
    pending: Vec<usize>,
    /// All before this is in an entry.
    at: TextSize,
}

/// The entries of a program, and the blank lines at its end.
pub(crate) fn entries(context: &Context) -> (Vec<Entry>, TextRange) {
    let mut reader = Reader {
        context,
        written: written(context),
        main: "".into(),
        open: vec![Vec::new()],
        headers: Vec::new(),
        pending: Vec::new(),
        at: TextSize::new(0),
    };
    for item in &context.parse.structure().items {
        reader.item(*item);
    }
    while !reader.headers.is_empty() {
        let line = context.parse.lines().len();
        reader.close(line..line);
    }
    let end = reader.rest(context.parse.lines().len());
    (reader.open.pop().unwrap_or_default(), end)
}

impl Reader<'_> {
    fn item(&mut self, item: Item) {
        let context = self.context;
        match item {
            Item::Decoration(line) => self.pending.push(line),
            Item::Network(index) => self.network(index),
            Item::Section(index) => {
                let lines = context.parse.structure().sections[index].lines.clone();
                self.section(lines, context.parse.structure().sections[index].closed);
            }
            Item::BlockHeader(index) => {
                // One that was not closed ends where the next begins.
                while !self.headers.is_empty() {
                    let line = context.parse.structure().blocks[index].lines.start;
                    self.close(line..line);
                }
                let line = context.parse.structure().blocks[index].lines.start;
                let name = context
                    .user_blocks
                    .get(index)
                    .map(|block| String::from(block.name.as_str()))
                    .unwrap_or_default();
                let names = vec![Name::new(&name)];
                self.begin(Kind::Block, line, names, name);
            }
            Item::BlockEnd(line) if !self.headers.is_empty() => self.close(line..line + 1),
            Item::BlockEnd(line) | Item::Stray(line) => {
                self.leaf(Kind::Stray, line..line + 1);
            }
        }
    }

    fn network(&mut self, index: usize) {
        let context = self.context;
        let network = context.networks.at(index);
        let mut entry = self.entry(Kind::Network, network.lines());
        entry.told = canonical::network(&context.parse, network);
        entry.network = Some(index);
        let written = &self.written[index];
        entry.names = written.iter().map(|name| Name::new(name)).collect();
        entry.title = written.join(", ");
        // A label and the beginning of a function are names of a network, too.
        for block in network.blocks() {
            let mark = match block.op() {
                Some(Op::Lbl) => "label ",
                Some(Op::Fun) => "function ",
                _ => continue,
            };
            if let Some(operand) = block.facts.operands.first() {
                let name = context.parse.text_in(block.absolute(operand.value.range));
                entry.names.push(Name::new(&format!("{mark}{name}")));
            }
        }
        entry.place = match context.bodies.get(index) {
            Some(Body::Function(function)) => {
                format!("function {}", context.functions[*function].name).into()
            }
            Some(Body::Block(block)) => format!("block {}", context.user_blocks[*block].name).into(),
            Some(Body::Main) | None => Arc::clone(&self.main),
        };
        self.push(entry);
    }

    fn section(&mut self, lines: Range<usize>, closed: bool) {
        let parse = &self.context.parse;
        let title = parse.line_range(lines.start);
        let title = self.words_of(title);
        self.begin(Kind::Section, lines.start, Vec::new(), title);
        let last = if closed { lines.end - 1 } else { lines.end };
        let outer = self.headers.len();
        for line in lines.start + 1..last {
            match parse.lines()[line].kind {
                LineKind::Comment | LineKind::Blank | LineKind::Rail | LineKind::Conflict => {
                    self.pending.push(line);
                }
                LineKind::StructHeader => {
                    let tree = parse.lines()[line].tree();
                    let header = StructHeader::cast(NodeView::root(&tree));
                    let names = header.map_or_else(Vec::new, |header| written_names(header.names()));
                    let keys = names.iter().map(|name| Name::new(name)).collect();
                    self.begin(Kind::Structure, line, keys, names.join(", "));
                }
                LineKind::StructEnd if self.headers.len() > outer => self.close(line..line + 1),
                LineKind::Declaration => {
                    let tree = parse.lines()[line].tree();
                    let declaration = Declaration::cast(NodeView::root(&tree));
                    let names = declaration.map_or_else(Vec::new, |it| written_names(it.names()));
                    let mut entry = self.entry(Kind::Declaration, line..line + 1);
                    entry.names = names.iter().map(|name| Name::new(name)).collect();
                    entry.title = names.join(", ");
                    self.push(entry);
                }
                _ => self.leaf(Kind::Stray, line..line + 1),
            }
        }
        while self.headers.len() > outer {
            self.close(last..last);
        }
        self.close(last..lines.end);
    }

    /// Begins something that holds others.
    fn begin(&mut self, kind: Kind, line: usize, names: Vec<Name>, title: String) {
        let mut entry = self.entry(kind, line..line + 1);
        entry.names = names;
        entry.title = title;
        self.headers.push(entry);
        self.open.push(Vec::new());
    }

    /// Ends what was begun last, with these lines.
    fn close(&mut self, lines: Range<usize>) {
        self.comments_pending();
        let end = self.rest(lines.end);
        let inside = self.open.pop().unwrap_or_default();
        if let Some(mut entry) = self.headers.pop() {
            entry.inside = inside;
            entry.end = end;
            self.push(entry);
        }
    }

    fn leaf(&mut self, kind: Kind, lines: Range<usize>) {
        let entry = self.entry(kind, lines);
        self.push(entry);
    }

    fn push(&mut self, entry: Entry) {
        if let Some(open) = self.open.last_mut() {
            open.push(entry);
        }
    }

    /// An entry of some lines, with the comments right above it. What else waits becomes entries of its own.
    fn entry(&mut self, kind: Kind, lines: Range<usize>) -> Entry {
        let parse = &self.context.parse;
        let is_comment =
            |line: &&usize| parse.lines()[**line].kind == LineKind::Comment && !self.sets(**line);
        let mut attached = self.pending.iter().rev().take_while(is_comment).count();
        // What is right below the directive of an unread part is the text of that.
        let above = self.pending.len().checked_sub(attached + 1);
        if above.is_some_and(|above| self.is_unread(self.pending[above])) {
            attached = 0;
        }
        let attached = self.pending.split_off(self.pending.len() - attached);
        let first = attached.first().copied().unwrap_or(lines.start);
        self.comments_pending();
        let blank = self.at;
        self.pending.clear();
        let end = parse.line_range(lines.end - 1).end();
        self.at = end;
        let from = parse.line_start(first);
        let own = TextRange::new(parse.line_start(lines.start), end);
        let comments = match kind {
            // They are what it says.
            Kind::Comment | Kind::Setting | Kind::Unread => String::new(),
            _ => canonical::comments(parse, first..lines.end),
        };
        let told = match kind {
            Kind::Network => Canonical::default(),
            Kind::Comment | Kind::Setting | Kind::Unread => Canonical {
                key: canonical::comments(parse, first..lines.end),
                words: canonical::comments(parse, first..lines.end)
                    .split(' ')
                    .map(str::to_owned)
                    .collect(),
            },
            _ => canonical::lines(parse, lines.clone()),
        };
        Entry {
            kind,
            range: TextRange::new(blank, end),
            shown: TextRange::new(from, end),
            own,
            network: None,
            part: None,
            place: self.headers.last().map_or_else(
                || Arc::clone(&self.main),
                |header| match header.kind {
                    Kind::Block | Kind::Structure => {
                        format!("{} {}", header.kind.text(), header.title).into()
                    }
                    _ => Arc::clone(&header.place),
                },
            ),
            names: Vec::new(),
            title: String::new(),
            inside: Vec::new(),
            end: TextRange::empty(end),
            told,
            comments,
        }
    }

    /// The text up to a line that is in no entry yet.
    fn rest(&mut self, line: usize) -> TextRange {
        self.comments_pending();
        self.pending.clear();
        let parse = &self.context.parse;
        let end = match line.checked_sub(1) {
            Some(last) => parse.line_range(last).end().max(self.at),
            None => self.at,
        };
        let rest = TextRange::new(self.at, end);
        self.at = end;
        rest
    }

    /// Comments that wait and belong to nothing below them become entries; the blank lines after the last of them go on
    /// waiting.
    fn comments_pending(&mut self) {
        let waiting = std::mem::take(&mut self.pending);
        let mut at = 0;
        while at < waiting.len() {
            let line = waiting[at];
            at += 1;
            if self.context.parse.lines()[line].kind != LineKind::Comment {
                self.pending.push(line);
                continue;
            }
            self.pending.clear();
            let kind = match () {
                () if self.is_unread(line) => Kind::Unread,
                () if self.sets(line) => Kind::Setting,
                () => Kind::Comment,
            };
            let mut last = line;
            while kind != Kind::Setting
                && let Some(&next) = waiting.get(at)
                && next == last + 1
                && self.context.parse.lines()[next].kind == LineKind::Comment
                && !self.sets(next)
            {
                last = next;
                at += 1;
            }
            let mut entry = self.entry(kind, line..last + 1);
            entry.title = self.words_of(entry.own);
            if kind == Kind::Unread {
                entry.title = self.headers.last().map_or_else(String::new, about);
            }
            if kind == Kind::Setting {
                let title = entry.title.trim_matches('#').trim();
                // A profile is the same setting, whichever it names; a rule that is switched off is one by itself.
                let word = asked(&entry.title).map(|asked| asked.word.to_owned());
                let key = match word.as_deref() {
                    Some("profile" | "cycle") => word.unwrap_or_default(),
                    _ => title.to_owned(),
                };
                entry.names = vec![Name::new(&key)];
            }
            self.push(entry);
        }
    }

    /// Whether a comment line says something of the file, not of what is below it.
    fn sets(&self, line: usize) -> bool {
        let text = self.context.parse.lines()[line].text();
        asked(text.trim()).is_some_and(|asked| asked.word != "allow")
    }

    /// Whether a comment line says that its block is an unread part.
    fn is_unread(&self, line: usize) -> bool {
        let text = self.context.parse.lines()[line].text();
        asked(text.trim()).is_some_and(|asked| asked.word == "unread")
    }

    /// A stretch of the text on one line.
    fn words_of(&self, range: TextRange) -> String {
        let text = self.context.parse.text_in(range);
        let text = text.trim_start_matches('\u{feff}');
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    }
}

/// What the comment above the definition of an unread part says; without one its name.
fn about(block: &Entry) -> String {
    let comment = block.comments.trim_matches(['#', ' ']).trim_end_matches('.');
    if comment.is_empty() {
        format!("{} was not read", block.title)
    } else {
        comment.to_owned()
    }
}
