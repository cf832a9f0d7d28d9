//! A run of lines without a blank one: its networks, or only text.

use crate::block;
use crate::element::{self, Labels};
use crate::frame::{self, Frame};
use crate::marks::{Mark, Marks};
use crate::network::{self, Network};
use crate::operand::Operands;
use crate::sheet::{Sheet, WIDEST, is_wire};
use crate::symbol::{self, Symbol, SymbolKind};
use crate::text::{self, Phrase};
use crate::wires::{self, Wires};

/// What was made of the lines.
#[derive(Debug, Default)]
pub(crate) struct Part {
    pub(crate) symbols: Vec<Element>,
    pub(crate) networks: Vec<Drawn>,
    /// What is written in lines without a rung.
    pub(crate) texts: Vec<Phrase>,
}

/// A contact, coil or box.
#[derive(Debug)]
pub(crate) struct Element {
    pub(crate) line: usize,
    pub(crate) column: usize,
    /// How much it tells of itself that it is drawn, and no ladder text.
    pub(crate) form: Form,
    /// As it is drawn, with what is written about it.
    pub(crate) shown: String,
    /// As a block of ladder text, or why it is none.
    pub(crate) written: Result<String, String>,
}

/// In which form an element is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// As ladder text has it too.
    Own,
    /// With brackets and no name: it may be either.
    Nameless,
    /// With bars or inverse brackets and no name. `|/|` may be a slip in ladder text.
    Bare,
    /// With its name inside its brackets.
    Inside,
    /// With its name above it or between bars, or as a box.
    Drawn,
}

/// A network, with the lines that belong to it.
#[derive(Debug)]
pub(crate) struct Drawn {
    pub(crate) network: Network,
    /// The last line that belongs to it.
    pub(crate) end: usize,
    /// What is written next to it.
    pub(crate) texts: Vec<Phrase>,
    /// Why its wires cannot be followed.
    pub(crate) problems: Vec<network::Problem>,
}

/// Reads lines.
pub(crate) fn read(sheet: &Sheet, operands: &mut Operands) -> Part {
    let mut marks = Marks::new(sheet.len());
    let frames = frame::find(sheet, &mut marks);
    let mut sides: Vec<Sides> = frames
        .iter()
        .map(|frame| Sides::of(sheet, &mut marks, frame))
        .collect();
    let mut symbols = symbol::find(sheet, &mut marks);
    let power: Vec<Option<(usize, usize)>> = sides
        .iter()
        .zip(symbols.len()..)
        .map(|(sides, symbol)| sides.power.map(|line| (line, symbol)))
        .collect();
    for (number, frame) in frames.iter().enumerate() {
        symbols.push(Symbol {
            line: sides[number].power.unwrap_or(frame.top),
            from: frame.left,
            to: frame.right + 1,
            kind: SymbolKind::Frame(number),
        });
    }
    let mut wires = wires::find(sheet, &marks, &power);
    let is_drawn = wires
        .runs
        .iter()
        .any(|run| run.things.iter().any(|thing| !thing.is_joint()));
    let mut phrases: Vec<Vec<Phrase>> = (0..sheet.len())
        .map(|line| text::phrases(sheet, &marks, line))
        .collect();
    if !is_drawn {
        let whole = |line: usize| Phrase {
            line,
            from: 0,
            to: sheet.width(line),
            text: sheet.text(line, 0, sheet.width(line)),
        };
        return Part {
            texts: (0..sheet.len()).map(whole).collect(),
            ..Part::default()
        };
    }
    let labels = labels(&symbols, &frames, &mut phrases, &marks);
    for (frame, sides) in frames.iter().zip(&mut sides) {
        sides.take_contacts(frame, &mut wires, |symbol| {
            let SymbolKind::Contact(inside) = &symbols[symbol].kind else {
                return None;
            };
            let name = match (inside.trim(), &labels[symbol].0) {
                ("", Some(name)) => name.text.as_str(),
                (name, None) => name,
                _ => return None,
            };
            name.starts_with(|c: char| c.is_alphabetic() || c == '%')
                .then(|| name.to_owned())
        });
    }
    let acts = |symbol: usize| match &symbols[symbol].kind {
        SymbolKind::Contact(inside) => block::row(inside.split(' ').next().unwrap_or("")).is_some_and(acts),
        SymbolKind::Coil(_) | SymbolKind::Flow(_) | SymbolKind::Frame(_) => true,
        SymbolKind::Own => {
            sheet.at(symbols[symbol].line, symbols[symbol].from) != '[' || {
                let text = sheet.text(symbols[symbol].line, symbols[symbol].from + 1, symbols[symbol].to);
                block::row(text.split(']').next().unwrap_or("")).is_some_and(acts)
            }
        }
    };
    let (networks, mut problems) = network::networks(&wires, &acts);
    problems.extend(sheet.cut().map(|line| {
        (
            (line, WIDEST - 1),
            format!("a line is read up to column {WIDEST}"),
        )
    }));
    for phrase in phrases.iter().flatten() {
        let touches = |run: &wires::Run| {
            let before = phrase.to == run.from && is_wire(sheet.at(run.line, run.from));
            let after = run.to == phrase.from && is_wire(sheet.at(run.line, phrase.from.saturating_sub(1)));
            run.is_rung() && (before || after)
        };
        if wires.next_to(phrase.line, phrase.from).any(touches) {
            let why = format!(
                "`{}` is in the wire: a name belongs above its contact, or inside it",
                phrase.text
            );
            problems.push(((phrase.line, phrase.from), why));
        }
    }
    let elements = symbols.iter().zip(&labels).map(|(symbol, label)| {
        let label = Labels {
            above: label.0.as_ref().map(|phrase| phrase.text.as_str()),
            below: label.1.as_ref().map(|phrase| phrase.text.as_str()),
        };
        let drawn = sheet.text(symbol.line, symbol.from, symbol.to);
        let written = match &symbol.kind {
            SymbolKind::Contact(inside) => element::contact(inside, label, operands),
            SymbolKind::Coil(inside) => element::coil(inside, label, operands),
            SymbolKind::Flow(inside) => element::flow(inside, operands),
            SymbolKind::Own => Ok(drawn.clone()),
            SymbolKind::Frame(number) => sides[*number].written(&frames[*number], label.above, operands),
        };
        Element {
            line: symbol.line,
            column: symbol.from,
            form: form(
                &symbol.kind,
                label.above.is_some(),
                "[(".contains(sheet.at(symbol.line, symbol.from)),
            ),
            shown: match label.above {
                Some(above) => format!("{} {above}", drawn.trim()),
                None => drawn.trim().to_owned(),
            },
            written: written.and_then(whole),
        }
    });
    let elements = elements.collect();
    Part {
        symbols: elements,
        networks: shared(networks, phrases, problems, sheet.len()),
        texts: Vec::new(),
    }
}

/// A block that has no error on a rung.
fn whole(block: String) -> Result<String, String> {
    match ladder_syntax::parse(&format!("+--{block}--+"))
        .errors()
        .is_empty()
    {
        true => Ok(block),
        false => Err("what is between its brackets is not known".to_owned()),
    }
}

fn form(kind: &SymbolKind, has_name_above: bool, has_bracket: bool) -> Form {
    match kind {
        SymbolKind::Own | SymbolKind::Flow(_) => Form::Own,
        SymbolKind::Frame(_) => Form::Drawn,
        _ if has_name_above => Form::Drawn,
        SymbolKind::Contact(inside) | SymbolKind::Coil(inside) => {
            let letters: String = inside.chars().filter(|c| c.is_alphanumeric()).collect();
            let says = letters.len() > 1 || (!letters.is_empty() && !"PNSRLUM".contains(&letters));
            match (says, has_bracket) {
                (true, true) => Form::Inside,
                (true, false) => Form::Drawn,
                (false, true) => Form::Nameless,
                (false, false) => Form::Bare,
            }
        }
    }
}

fn acts(row: &'static ladder_instructions::Instruction) -> bool {
    row.role == ladder_instructions::Role::Acting
}

/// The name of a contact is no more lines above it.
const HIGHEST: usize = 10;

/// What is written above and below each symbol. It is no longer among the phrases then.
type Label = (Option<Phrase>, Option<Phrase>);

fn labels(symbols: &[Symbol], frames: &[Frame], phrases: &mut [Vec<Phrase>], marks: &Marks) -> Vec<Label> {
    let mut found: Vec<Label> = vec![(None, None); symbols.len()];
    // Those whose name is above a line, in the order of their columns.
    let mut over: Vec<Vec<usize>> = vec![Vec::new(); phrases.len() + 1];
    for (number, symbol) in symbols.iter().enumerate() {
        let top = match &symbol.kind {
            SymbolKind::Frame(frame) if wants_name(&frames[*frame]) => frames[*frame].top,
            SymbolKind::Contact(inside) if element::contact_wants_name(inside) => symbol.line,
            SymbolKind::Coil(inside) if element::coil_wants_name(inside) => symbol.line,
            _ => continue,
        };
        over[top].push(number);
    }
    for (line, mut named) in over.into_iter().enumerate() {
        named.sort_by_key(|&number| symbols[number].from);
        // The lines of a box may be between a contact and its name.
        for above in (0..line).rev().take(HIGHEST) {
            let spans: Vec<(usize, usize)> = named.iter().map(|&number| span(&symbols[number])).collect();
            let about = text::about(&spans, &phrases[above]);
            let taken = about.iter().flatten().cloned().collect();
            take(&mut phrases[above], taken);
            for (&number, phrase) in named.iter().zip(about) {
                found[number].0 = phrase;
            }
            named.retain(|&number| found[number].0.is_none());
            if named.is_empty() || !marks.has_frame(above) || marks.has_symbol(above) {
                break;
            }
        }
    }
    // What is above another symbol is not below this one.
    for (number, symbol) in symbols.iter().enumerate() {
        let SymbolKind::Contact(inside) = &symbol.kind else {
            continue;
        };
        if !element::wants_below(inside, found[number].0.is_some()) || symbol.line + 1 >= phrases.len() {
            continue;
        }
        let about = text::about(&[(symbol.from, symbol.to)], &phrases[symbol.line + 1]);
        if let [Some(phrase)] = &about[..] {
            take(&mut phrases[symbol.line + 1], vec![phrase.clone()]);
            found[number].1 = Some(phrase.clone());
        }
    }
    found
}

/// Whether what is above a box is its instance, or which block it is.
fn wants_name(frame: &Frame) -> bool {
    let boxed = block::boxed(&frame.edge, &frame.inside);
    boxed.map_or(true, |boxed| boxed.row.state().is_some())
}

/// The columns over which a name may begin or end. That of a box is over the box itself.
fn span(symbol: &Symbol) -> (usize, usize) {
    match symbol.kind {
        SymbolKind::Frame(_) => (symbol.from + text::NEAR, symbol.to - text::NEAR),
        _ => (symbol.from, symbol.to),
    }
}

/// Takes phrases out of those of a line; of one that was taken apart the rest stays.
fn take(phrases: &mut Vec<Phrase>, taken: Vec<Phrase>) {
    for taken in taken {
        let Some(at) = phrases
            .iter()
            .position(|phrase| phrase.from <= taken.from && taken.to <= phrase.to)
        else {
            continue;
        };
        let whole = phrases.remove(at);
        let rest = |from: usize, to: usize| {
            let text: String = whole
                .text
                .chars()
                .skip(from - whole.from)
                .take(to - from)
                .collect();
            let blanks = text.len() - text.trim_start().len();
            Phrase {
                line: whole.line,
                from: from + blanks,
                to,
                text: text.trim().to_owned(),
            }
        };
        let rests = [rest(whole.from, taken.from), rest(taken.to, whole.to)];
        phrases.splice(at..at, rests.into_iter().filter(|rest| !rest.text.is_empty()));
    }
}

/// Gives each network the lines up to its last rung, and what is written and wrong there; the last one has the rest.
fn shared(
    networks: Vec<Network>,
    phrases: Vec<Vec<Phrase>>,
    problems: Vec<network::Problem>,
    lines: usize,
) -> Vec<Drawn> {
    let mut phrases = phrases.into_iter().flatten().peekable();
    let mut problems = problems;
    problems.sort_unstable();
    let mut problems = problems.into_iter().peekable();
    let networks: Vec<Network> = networks.into_iter().filter(has_symbol).collect();
    let count = networks.len();
    let mut drawn = Vec::new();
    for (number, network) in networks.into_iter().enumerate() {
        let is_last = number + 1 == count;
        let last_rung = network.lines.last().copied().unwrap_or(0);
        let end = if is_last {
            lines.saturating_sub(1)
        } else {
            last_rung
        };
        drawn.push(Drawn {
            network,
            end,
            texts: std::iter::from_fn(|| phrases.next_if(|phrase| phrase.line <= end)).collect(),
            problems: std::iter::from_fn(|| problems.next_if(|((line, _), _)| *line <= end)).collect(),
        });
    }
    drawn
}

fn has_symbol(network: &Network) -> bool {
    network.symbols().next().is_some()
}

/// What is next to a box.
#[derive(Debug, Default)]
struct Sides {
    /// The line on which power comes to it.
    power: Option<usize>,
    /// Other lines on which a wire comes to it.
    wired: Vec<usize>,
    /// Why it cannot be read, apart from what it says.
    problem: Option<String>,
    /// What is written left and right of it, line by line from its upper edge on.
    values: Vec<(Option<String>, Option<String>)>,
}

/// What other systems draw next to a box to show its bits.
const BITS: [&str; 9] = ["EN", "DN", "TT", "CU", "CD", "OV", "UN", "ER", "UA"];

/// Wire next to a box with a value at its end is no longer.
const LONGEST: usize = 40;

impl Sides {
    fn of(sheet: &Sheet, marks: &mut Marks, frame: &Frame) -> Sides {
        let mut sides = Sides::default();
        let mut leaves = Vec::new();
        for line in frame.top..=frame.bottom {
            let left = value_before(sheet, marks, line, frame.left);
            if left.is_none()
                && frame
                    .left
                    .checked_sub(1)
                    .is_some_and(|before| comes(sheet, line, before))
            {
                match sides.power {
                    None => sides.power = Some(line),
                    Some(_) => sides.wired.push(line),
                }
            }
            let right = value_after(sheet, marks, line, frame.right, sides.power == Some(line));
            if right.is_none() && comes(sheet, line, frame.right + 1) {
                leaves.push(line);
            }
            sides.values.push((left, right.filter(|value| !value.is_empty())));
        }
        if let Some(line) = sides.power
            && leaves.iter().any(|leaving| *leaving != line)
        {
            sides.problem = Some("the wire leaves the box on another line than it comes on".to_owned());
        }
        sides
    }

    /// Takes the wires that bring a pin nothing but the contact of one tag from the left rail: the tag is given to it then.
    fn take_contacts(&mut self, frame: &Frame, wires: &mut Wires, tag: impl Fn(usize) -> Option<String>) {
        if self.wired.is_empty() {
            return;
        }
        let left = wires.left();
        self.wired.retain(|&line| {
            let mut runs = wires.on(line).iter_mut();
            let run = runs.find(|run| run.to == frame.left && Some(run.from) == left);
            let contact = run.as_ref().and_then(|run| run.only_symbol());
            let (Some(run), Some(tag)) = (run, contact.and_then(&tag)) else {
                return true;
            };
            run.things.clear();
            self.values[line - frame.top].0 = Some(tag);
            false
        });
    }

    /// The block that a box is.
    fn written(&self, frame: &Frame, name: Option<&str>, operands: &mut Operands) -> Result<String, String> {
        if let Some(problem) = &self.problem {
            return Err(problem.clone());
        }
        if !self.wired.is_empty() {
            return Err(
                "wires lead to more than one pin of the box: write a tag at all but the first".to_owned(),
            );
        }
        // A type above the box, where the box itself has none.
        let boxed = block::boxed(&frame.edge, &frame.inside);
        let (boxed, name) = match (boxed, name.and_then(block::row)) {
            (Err(_), Some(row)) => (block::boxed(row.mnemonic, &frame.inside)?, None),
            (boxed, _) => (boxed?, name),
        };
        let mut given = Vec::new();
        for (number, pins) in boxed.given.into_iter().enumerate() {
            let (left, right) = self.values.get(number + 1).cloned().unwrap_or_default();
            let last = pins.len().saturating_sub(1);
            for (at, mut pin) in pins.into_iter().enumerate() {
                let next_to = match (&left, &right) {
                    (Some(value), _) if at == 0 => Some(value),
                    (_, Some(value)) if at == last => Some(value),
                    _ => None,
                };
                if let Some(value) = next_to {
                    if !pin.value.is_empty() {
                        return Err(format!(
                            "`{value}` is next to the box where it has `{}` already",
                            pin.value
                        ));
                    }
                    pin.value.clone_from(value);
                }
                given.push(pin);
            }
        }
        block::written(boxed.row, name, given, operands)
    }
}

/// Whether a wire or contact reaches a box in a column next to it.
fn comes(sheet: &Sheet, line: usize, column: usize) -> bool {
    is_wire(sheet.at(line, column)) || matches!(sheet.at(line, column), ')' | ']' | '(' | '[')
}

fn is_value(c: char) -> bool {
    c.is_alphanumeric() || "_#.:%/".contains(c)
}

/// The value at the left of a box, with its wire: `5s──┤PT`.
fn value_before(sheet: &Sheet, marks: &mut Marks, line: usize, left: usize) -> Option<String> {
    let wire = (0..left)
        .rev()
        .take_while(|&column| is_wire(sheet.at(line, column)))
        .count();
    let end = left - wire;
    let long = (0..end)
        .rev()
        .take(LONGEST)
        .take_while(|&column| is_value(sheet.at(line, column)))
        .count();
    let from = end - long;
    let is_free = from
        .checked_sub(1)
        .is_none_or(|before| !is_wire(sheet.at(line, before)) && !"([])".contains(sheet.at(line, before)));
    if long == 0 || !is_free {
        return None;
    }
    marks.set(line, from..left, Mark::Read);
    Some(sheet.text(line, from, end))
}

/// The value at the right of a box; or one of its bits, `(DN)`, which is passed by.
fn value_after(
    sheet: &Sheet,
    marks: &mut Marks,
    line: usize,
    right: usize,
    is_power: bool,
) -> Option<String> {
    let wire = (right + 1..sheet.width(line))
        .take_while(|&column| is_wire(sheet.at(line, column)))
        .count();
    let from = right + 1 + wire;
    let bits = BITS
        .iter()
        .find(|bit| sheet.text(line, from, from + bit.len() + 2) == format!("({bit})"));
    if let Some(bit) = bits {
        let to = from + bit.len() + 2;
        marks.set(
            line,
            right + 1..to,
            if is_power { Mark::Wire } else { Mark::Read },
        );
        // The wire from there to the rail shows nothing either.
        if !is_power {
            let more = (to..sheet.width(line))
                .take_while(|&column| is_wire(sheet.at(line, column)))
                .count();
            marks.set(line, to..to + more, Mark::Read);
            return Some(String::new());
        }
        return None;
    }
    let long = (from..sheet.width(line))
        .take(LONGEST)
        .take_while(|&column| is_value(sheet.at(line, column)))
        .count();
    if long == 0
        || wire == 0
        || is_wire(sheet.at(line, from + long))
        || "([".contains(sheet.at(line, from + long))
    {
        return None;
    }
    marks.set(line, right + 1..from + long, Mark::Read);
    Some(sheet.text(line, from, from + long))
}
