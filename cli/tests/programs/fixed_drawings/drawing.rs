//! Rungs as people draw them, in the language and in what other notations have, each with what it says.

use std::collections::BTreeMap;

/// What a contact, a timer or a block on the way says of the power after it.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Says {
    /// A contact: its tag, and whether it is a closed one.
    Contact(&'static str, bool),
    /// 1 <= n <= 5.
    InRange,
    /// Nothing comes out while the test runs.
    Late,
    /// It is not said, or nobody knows: a program must not run with it.
    Unknown,
}

/// What a coil does with its tag.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Does {
    Writes,
    WritesInverse,
    Sets,
    Resets,
    Unknown,
}

#[derive(Debug, Clone)]
pub(super) struct Rung {
    /// Alternatives, each a row of conditions; then what follows them.
    pub(super) branches: Vec<Vec<Says>>,
    pub(super) series: Vec<Says>,
    pub(super) coil: (&'static str, Does),
    /// Whether it is drawn from a `+`: without it the language says that there is no power.
    pub(super) has_rail: bool,
}

#[derive(Debug, Clone, Default)]
pub(super) struct Drawing {
    pub(super) text: String,
    pub(super) rungs: Vec<Rung>,
}

impl Drawing {
    /// Whether something in it is not said, so that nothing may run.
    pub(super) fn is_unknown(&self) -> bool {
        self.rungs.iter().any(|rung| {
            let mut says = rung.branches.iter().flatten().chain(&rung.series);
            rung.coil.1 == Does::Unknown || says.any(|says| *says == Says::Unknown)
        })
    }

    /// One scan, on the values of all tags. `everywhere`: rungs without a rail have power as well.
    pub(super) fn scan(&self, tags: &mut BTreeMap<&'static str, i64>, everywhere: bool) {
        for rung in &self.rungs {
            let value = |tag: &str| tags.get(tag).copied().unwrap_or(0);
            let passes = |says: &Says| match says {
                Says::Contact(tag, closed) => (value(tag) != 0) != *closed,
                Says::InRange => (1..=5).contains(&value("n")),
                Says::Late | Says::Unknown => false,
            };
            let power = (rung.has_rail || everywhere)
                && rung.branches.iter().any(|branch| branch.iter().all(passes))
                && rung.series.iter().all(passes);
            let (tag, does) = rung.coil;
            let bit = tags.entry(tag).or_default();
            match does {
                Does::Writes => *bit = i64::from(power),
                Does::WritesInverse => *bit = i64::from(!power),
                Does::Sets if power => *bit = 1,
                Does::Resets if power => *bit = 0,
                _ => {}
            }
        }
    }
}

/// Numbers that look random, the same in every run.
pub(super) struct Dice(u32);

impl Dice {
    pub(super) fn new(seed: u32) -> Dice {
        Dice(seed.wrapping_mul(2_654_435_761).wrapping_add(97))
    }

    pub(super) fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.0 >> 8) as usize % limit
    }

    pub(super) fn one_of<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())]
    }
}

/// Tags that contacts read, some of which look like instructions, and those that coils write.
pub(super) const READ: [&str; 7] = ["Go", "pb", "halt", "Lim1", "Sel", "Max", "jog"];
pub(super) const WRITTEN: [&str; 3] = ["fan", "Out2", "q"];

/// Ways to draw an open and a closed contact of the tag `@`, and whether the tag is in it.
const CONTACTS: &[(&str, bool, bool)] = &[
    ("[ ]( @ )", false, true),
    ("[/]( @ )", true, true),
    ("[@]", false, true),
    ("[ @ ]", false, true),
    ("[/@]", true, true),
    ("[/ @]", true, true),
    ("| |", false, false),
    ("||", false, false),
    ("|  |", false, false),
    ("|/|", true, false),
    ("|\\|", true, false),
    ("| |( @ )", false, true),
    ("|/|( @ )", true, true),
    ("|/|(@)", true, true),
    ("|@|", false, true),
    ("|/@|", true, true),
    ("| @ |", false, true),
    ("] [", false, false),
    ("]/[", true, false),
    ("] [( @ )", false, true),
    ("]/[( @ )", true, true),
    ("[XIC]( @ )", false, true),
    ("[XIO]( @ )", true, true),
    ("[XIC @]", false, true),
    ("[XIO @]", true, true),
    ("[NO]( @ )", false, true),
    ("[NC]( @ )", true, true),
    ("[\\]( @ )", true, true),
    ("[|]( @ )", false, true),
    ("[!@]", true, true),
    ("[NOT @]", true, true),
    ("[ ]@", false, true),
    ("[/]@", true, true),
    ("[ ]", false, false),
    ("[/]", true, false),
    ("[ ( @ )", false, true),
    ("[/( @ )", true, true),
    ("[ ]( @", false, true),
    ("[/] @ )", true, true),
    ("┤ ├", false, false),
    ("┤/├", true, false),
    ("┤/├( @ )", true, true),
    ("│/│( @ )", true, true),
    ("{ }( @ )", false, true),
    ("-/-", true, false),
    ("-|/-", true, false),
    ("-/|-", true, false),
];

/// Other conditions.
const OTHERS: &[(&str, Says)] = &[
    ("[LIM]( 1, n, 5 )", Says::InRange),
    ("[LE]( 1, n, 5 )", Says::InRange),
    ("[TON]( t1, 5 s )", Says::Late),
    ("[TON]( t1, 5 sec )", Says::Late),
    ("[TON]( t1, 5s )", Says::Late),
    ("[TMR]( t1, 5s )", Says::Late),
    ("[TMR]( t1, 5 )", Says::Unknown),
    ("[TON]( t1, 5, s )", Says::Unknown),
    ("[TON]( t1 5 s )", Says::Unknown),
    ("[TON]( t1 )", Says::Unknown),
    ("[TON]", Says::Unknown),
    ("[TMR]", Says::Unknown),
    ("[LIM]( n, 1, 5 )", Says::Unknown),
    ("[LIM]( 5, n, 1 )", Says::Unknown),
    ("[LIM]( 1, n )", Says::Unknown),
    ("[PID]( a, b, c, d )", Says::Unknown),
    ("[NAND]( w, a, b )", Says::Unknown),
    ("[SUM]( w, a, b )", Says::Unknown),
    ("[XNOR]( w, a, b )", Says::Unknown),
    ("[DEC]( w, a )", Says::Unknown),
    ("[SINH]( w, a )", Says::Unknown),
    ("[MVN]( w, a )", Says::Unknown),
    ("[MOVB]( w, a )", Says::Unknown),
    ("[TOM]( t1, 5s )", Says::Unknown),
    ("[CTX]( c1, 5 )", Says::Unknown),
    ("[X]( Go )", Says::Unknown),
    ("[O]( Go )", Says::Unknown),
    ("[GO]( pb )", Says::Unknown),
    ("[EQ]", Says::Unknown),
    ("[GT]( n )", Says::Unknown),
    ("[ ]( Go, pb )", Says::Unknown),
    ("[ ]( Go pb )", Says::Unknown),
    ("[/]( Go, pb )", Says::Unknown),
    ("[MOV]( w )", Says::Unknown),
    ("[MOV]( w, 1, 2 )", Says::Unknown),
    ("[END]", Says::Unknown),
    ("[NOT]( pb )", Says::Unknown),
    ("(XIC)( pb )", Says::Unknown),
    ("(EQ)( n, 5 )", Says::Unknown),
    ("?(((i y))", Says::Unknown),
];

/// Ways to draw a coil of the tag `@`, and whether the tag is in it.
const COILS: &[(&str, Does, bool)] = &[
    ("( )( @ )", Does::Writes, true),
    ("()( @ )", Does::Writes, true),
    ("(@)", Does::Writes, true),
    ("( @ )", Does::Writes, true),
    ("( )", Does::Writes, false),
    ("(/)( @ )", Does::WritesInverse, true),
    ("(/@)", Does::WritesInverse, true),
    ("(/)", Does::WritesInverse, false),
    ("(NOT)( @ )", Does::WritesInverse, true),
    ("(NC)( @ )", Does::WritesInverse, true),
    ("(S)( @ )", Does::Sets, true),
    ("(S)(@)", Does::Sets, true),
    ("(SET)( @ )", Does::Sets, true),
    ("(SET)(@)", Does::Sets, true),
    ("(SET @)", Does::Sets, true),
    ("( SET @ )", Does::Sets, true),
    ("(SET)", Does::Sets, false),
    ("(L)( @ )", Does::Sets, true),
    ("(L @)", Does::Sets, true),
    ("(L)", Does::Sets, false),
    ("(OTL)( @ )", Does::Sets, true),
    ("[OTL]( @ )", Does::Sets, true),
    ("[SET]( @ )", Does::Sets, true),
    ("(R)( @ )", Does::Resets, true),
    ("(RST)( @ )", Does::Resets, true),
    ("(RESET)( @ )", Does::Resets, true),
    ("(RST @)", Does::Resets, true),
    ("(U)( @ )", Does::Resets, true),
    ("(U)", Does::Resets, false),
    ("[OTU]( @ )", Does::Resets, true),
    ("[RST]( @ )", Does::Resets, true),
    ("(OTE)( @ )", Does::Writes, true),
    ("[OTE]( @ )", Does::Writes, true),
    ("[OUT]( @ )", Does::Writes, true),
    ("(OUT @)", Does::Writes, true),
    ("(OUT)( @ )", Does::Writes, true),
    ("( ( @ )", Does::Writes, true),
    ("( ) @", Does::Writes, true),
    ("(SET( @ )", Does::Sets, true),
    ("( )( fan, q )", Does::Unknown, true),
    ("(SET)( fan, q )", Does::Unknown, true),
    ("(END)", Does::Unknown, false),
    ("[PID]( q )", Does::Unknown, true),
];

/// A row of blocks as it grows: their text, and the names that are missing in it, with the column of each.
#[derive(Default)]
struct Row {
    text: String,
    names: Vec<(usize, &'static str)>,
}

impl Row {
    fn push(&mut self, text: &str) {
        self.text.push_str(text);
    }

    /// Draws a block, and takes its name for the line above if it is not in it.
    fn block(&mut self, written: &str, name: &'static str, holds_name: bool) {
        let width = written.chars().count();
        if !holds_name {
            let middle = self.text.chars().count() + width / 2;
            self.names.push((middle.saturating_sub(name.len() / 2), name));
        }
        self.push(&written.replace('@', name));
    }

    /// The line of names above it. None: they are in each other's way.
    fn names(&self) -> Option<String> {
        let mut line = String::new();
        for (column, name) in &self.names {
            let missing = column.checked_sub(line.chars().count())?;
            if missing == 0 && !line.is_empty() {
                return None;
            }
            line.push_str(&" ".repeat(missing));
            line.push_str(name);
        }
        Some(line)
    }
}

fn condition(dice: &mut Dice, row: &mut Row) -> Says {
    if dice.below(6) == 0 {
        let (written, says) = &OTHERS[dice.below(OTHERS.len())];
        row.push(written);
        return says.clone();
    }
    let plain = dice.below(3) == 0;
    let (written, closed, holds_name) = CONTACTS[dice.below(if plain { 2 } else { CONTACTS.len() })];
    let name = dice.one_of(&READ);
    row.block(written, name, holds_name);
    Says::Contact(name, closed)
}

fn wire(dice: &mut Dice) -> &'static str {
    dice.one_of(&["--", "--", "---", "-----", "-"])
}

/// A drawing of one to three rungs.
pub(super) fn drawing(dice: &mut Dice) -> Drawing {
    let mut drawing = Drawing::default();
    for _ in 0..=dice.below(3) {
        rung(dice, &mut drawing);
    }
    drawing
}

fn rung(dice: &mut Dice, drawing: &mut Drawing) {
    let start = dice.one_of(&["+", "+", "+", "|", ""]);
    let end = if start == "+" {
        "+"
    } else {
        dice.one_of(&["+", "|", ""])
    };
    let mut rows = vec![Row::default()];
    rows[0].push(start);
    rows[0].push(wire(dice));
    let mut rung = Rung {
        branches: Vec::new(),
        series: Vec::new(),
        coil: (dice.one_of(&WRITTEN), Does::Unknown),
        has_rail: start == "+",
    };
    let corners = dice.one_of(&[
        ["\\", "\\", "/", "/"],
        ["+", "+", "+", "+"],
        ["|", "|", "|", "|"],
        ["+", "+", "|", "|"],
        ["", "+", "", "+"],
    ]);
    let count = if dice.below(2) == 0 { 1 } else { 2 + dice.below(2) };
    let (mut open, mut close) = (0, 0);
    for branch in 0..count {
        if count > 1 && branch == 0 {
            open = rows[0].text.chars().count();
            rows[0].push(corners[0]);
            rows[0].push("--");
        }
        if branch > 0 {
            let mut row = Row::default();
            row.push(start);
            let blanks = open - row.text.chars().count();
            if corners[2].is_empty() {
                // From the rail, as the first.
                row.push(&"-".repeat(blanks));
            } else {
                row.push(&" ".repeat(blanks));
                row.push(corners[2]);
            }
            row.push("--");
            rows.push(row);
        }
        let row = rows.last_mut().expect("there is one");
        let mut says = vec![condition(dice, row)];
        if dice.below(3) == 0 {
            row.push(wire(dice));
            says.push(condition(dice, row));
        }
        rung.branches.push(says);
        close = close.max(row.text.chars().count());
    }
    if count > 1 {
        for (number, row) in rows.iter_mut().enumerate() {
            let missing = close - row.text.chars().count();
            row.push(&"-".repeat(missing + 2));
            row.push(if number == 0 { corners[1] } else { corners[3] });
        }
    }
    rows[0].push(wire(dice));
    while dice.below(3) == 0 {
        let says = condition(dice, &mut rows[0]);
        rung.series.push(says);
        rows[0].push(wire(dice));
    }
    let plain = dice.below(3) == 0;
    let (written, does, holds_name) = COILS[dice.below(if plain { 2 } else { COILS.len() })];
    rows[0].block(written, rung.coil.0, holds_name);
    rung.coil.1 = does;
    rows[0].push(wire(dice));
    rows[0].push(end);
    let names_are_drawn = dice.below(3) > 0;
    let first = drawing.text.len();
    for row in &rows {
        let names = row.names().filter(|_| names_are_drawn);
        let is_said = names.is_some() || row.names.is_empty();
        if !is_said {
            rung.series.push(Says::Unknown);
        }
        if let Some(names) = names.filter(|names| !names.is_empty()) {
            drawing.text.push_str(&names);
            drawing.text.push('\n');
        }
        drawing.text.push_str(&row.text);
        drawing.text.push('\n');
    }
    if dice.below(2) == 0 && first > 0 {
        drawing.text.insert(first, '\n');
    }
    drawing.rungs.push(rung);
}
