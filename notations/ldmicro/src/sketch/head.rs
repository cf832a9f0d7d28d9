//! What is above the networks: the header and the lists of the file in comments, and the declarations.

use super::{Importer, name_of};
use crate::kept::head_line;
use crate::model::{DEFAULT_CYCLE, Encoding};
use ladder_format::program::{Declaration, Item, Section, SectionKind};
use ladder_notation::LineColumn;

impl Importer<'_> {
    pub(super) fn head(&mut self) {
        let mut lines = vec![self.file.version.line().to_owned()];
        let Encoding { crlf, latin1 } = self.file.encoding;
        lines.extend(crlf.then(|| "lines end in CR LF".to_owned()));
        lines.extend(latin1.then(|| "Latin-1".to_owned()));
        lines.extend(self.file.header.iter().cloned());
        lines.extend(self.file.passed.iter().map(|line| format!("HEADER {line}")));
        for (title, entries) in &self.file.lists {
            lines.push(title.clone());
            lines.extend(entries.iter().cloned());
            lines.push("END".to_owned());
        }
        let sections = self.sections();
        let listed = sections.iter().flat_map(|section| &section.declarations);
        let listed: Vec<&str> = listed
            .filter(|d| d.comment.is_some())
            .map(|d| d.names[0].as_str())
            .collect();
        let given: Vec<&str> = self.file.io.iter().map(|(_, entry)| name_of(entry)).collect();
        let spelled: Vec<&str> = given.iter().filter_map(|name| self.tags.listed(name)).collect();
        // Where the declarations cannot show the list as it is, it is kept next to them.
        if spelled != listed || spelled.len() != given.len() {
            lines.extend(self.file.io.iter().map(|(_, entry)| format!("IO {entry}")));
        }
        for (tag, name) in self.tags.renamed() {
            lines.push(format!("NAME {tag} = {name}"));
            let why = format!("it is spelled `{tag}` here");
            self.reading.report.approximated(LineColumn::START, name, why);
        }
        for (name, number) in &self.tags.pulses {
            if *name != format!("P{number}") {
                lines.push(format!("PULSES {number} = {name}"));
            }
        }
        self.sizes();
        let items = &mut self.reading.program.items;
        items.extend(
            lines
                .into_iter()
                .map(|line| Item::Comment(format!("ldmicro: {}", head_line(&line)))),
        );
        items.push(Item::Directive("profile ldmicro".to_owned()));
        if self.file.cycle() != DEFAULT_CYCLE {
            items.push(Item::Directive(format!(
                "cycle {}",
                plain_duration(self.file.cycle())
            )));
        }
        items.push(Item::Blank);
        items.extend(sections.into_iter().map(Item::Section));
    }

    /// Variables that do not have 16 bits in the fork.
    fn sizes(&mut self) {
        let entries = self.file.lists.iter().filter(|(title, _)| title == "VAR LIST");
        for entry in entries.flat_map(|(_, entries)| entries) {
            let words: Vec<&str> = entry.split_whitespace().collect();
            // The sizes of timers and counters suit their limits.
            if let [size @ ("1" | "3" | "4"), "bytes", name] = words[..]
                && !name.starts_with(['T', 'C'])
            {
                let why = format!("it has {size} bytes in LDmicro, and 16 bits here");
                self.reading.report.approximated(LineColumn::START, name, why);
            }
        }
    }

    fn sections(&mut self) -> Vec<Section> {
        let mut inputs = Section::new(SectionKind::VarInput);
        let mut outputs = Section::new(SectionKind::VarOutput);
        let mut others = Section::new(SectionKind::Var);
        let tags = self.tags;
        for (name, tag) in &tags.bits {
            let declaration = self.declaration(name, tag, "BOOL".to_owned(), name.starts_with(['X', 'Y']));
            let section = match name.chars().next() {
                Some('X') => &mut inputs,
                Some('Y') => &mut outputs,
                _ => &mut others,
            };
            section.declarations.push(declaration);
        }
        for (name, tag) in &tags.variables {
            let declaration = self.declaration(name, tag, tags.ty(name), name.starts_with('A'));
            others.declarations.push(declaration);
        }
        for (tag, stages) in tags.registers.values().filter(|(_, stages)| *stages > 0) {
            let ty = format!("ARRAY[0..{}] OF INT", stages - 1);
            others.declarations.push(Declaration::new(tag, ty));
        }
        vec![inputs, outputs, others]
    }

    fn declaration(&mut self, name: &str, tag: &str, ty: String, may_have_pin: bool) -> Declaration {
        let mut declaration = Declaration::new(tag, ty);
        if let Some((line, pin)) = self.pins.get(name).copied().filter(|_| may_have_pin) {
            declaration.origin = Some(self.reading.origin(LineColumn::line(line)));
            declaration.comment = Some(match pin {
                "0" => "no pin".to_owned(),
                pin => format!("pin {pin}"),
            });
        }
        if self.tags.begins_high(name) && declaration.ty == "BOOL" {
            declaration.initial = Some("TRUE".to_owned());
        }
        if let Some(initial) = self.tags.initial(name).filter(|_| declaration.ty == "INT") {
            declaration.initial = Some(initial.to_string());
        }
        declaration
    }
}

/// The same as comments have it, where a `#` would end them.
pub(super) fn plain_duration(microseconds: u64) -> String {
    match microseconds {
        us if us % 1_000_000 == 0 => format!("{}s", us / 1_000_000),
        us if us % 1_000 == 0 => format!("{}ms", us / 1_000),
        us => format!("{us}us"),
    }
}
