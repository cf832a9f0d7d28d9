//! The words of the notation, each next to the instruction that says the same. Import, export and checks read this table.

use ladder_instructions::Op;

/// An element: the word that it begins with, and what it is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row {
    /// As it is written.
    pub(super) word: &'static str,
    /// Other spellings that are read.
    pub(super) also: &'static [&'static str],
    /// How its operands are to be taken.
    pub(super) form: Form,
}

/// What an element is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// `NO I1`: a variable is checked.
    Contact(Op),
    /// `OUT Q1`: a variable is written.
    Coil(Op),
    /// `RESET T1`, `RESET Q1`
    Reset,
    /// `TON T1 3 100`: preset, time base in milliseconds.
    Timer(Op),
    /// `CTD C1 3 5`: preset, initial count.
    Counter(Op),
    /// `EQ MI01 5`
    Compare(Op),
    /// `ADD MI01 MI01 1`: the result first.
    Calculate(Op),
    /// `NOT MI10 MI01`
    Not,
    /// `MOV MI01 7`
    Assign,
    /// `SCANTIME`: the scan time goes to the serial port.
    ScanTime,
}

const fn row(word: &'static str, form: Form) -> Row {
    Row {
        word,
        also: &[],
        form,
    }
}

impl Row {
    const fn also(self, also: &'static [&'static str]) -> Row {
        Row { also, ..self }
    }

    /// The fewest and the most operands.
    pub(super) const fn operands(&self) -> (usize, usize) {
        match self.form {
            Form::Contact(_) | Form::Coil(_) | Form::Reset => (1, 1),
            Form::Timer(_) => (1, 3),
            Form::Counter(_) => (1, 3),
            Form::Compare(_) | Form::Not | Form::Assign => (2, 2),
            Form::Calculate(_) => (3, 3),
            Form::ScanTime => (0, 0),
        }
    }

    /// What the operands are, for messages.
    pub(super) const fn usage(&self) -> &'static str {
        match self.form {
            Form::Contact(_) | Form::Coil(_) => "a variable",
            Form::Reset => "a timer, a counter or a variable",
            Form::Timer(_) => "a timer, its preset, and its time base in milliseconds",
            Form::Counter(_) => "a counter, its preset, and its initial count",
            Form::Compare(_) => "two variables or numbers",
            Form::Not | Form::Assign => "a variable for the result, and a variable or number",
            Form::Calculate(_) => "a variable for the result, and two variables or numbers",
            Form::ScanTime => "nothing",
        }
    }
}

/// All of them.
pub(super) const ROWS: &[Row] = &[
    row("NO", Form::Contact(Op::Contact)),
    row("NC", Form::Contact(Op::NegatedContact)),
    row("P", Form::Contact(Op::RisingContact)),
    row("N", Form::Contact(Op::FallingContact)),
    row("OUT", Form::Coil(Op::Coil)),
    row("NOUT", Form::Coil(Op::NegatedCoil)),
    row("SET", Form::Coil(Op::SetCoil)),
    row("RST", Form::Coil(Op::ResetCoil)),
    row("M", Form::Coil(Op::RetentiveCoil)),
    row("SM", Form::Coil(Op::RetentiveSet)),
    row("RM", Form::Coil(Op::RetentiveReset)),
    row("PC", Form::Coil(Op::RisingCoil)).also(&["PCOIL"]),
    row("NCOIL", Form::Coil(Op::FallingCoil)),
    row("RESET", Form::Reset),
    row("TON", Form::Timer(Op::Ton)),
    row("TOF", Form::Timer(Op::Tof)),
    row("CTU", Form::Counter(Op::Ctu)),
    row("CTD", Form::Counter(Op::Ctd)),
    row("EQ", Form::Compare(Op::Eq)),
    row("NEQ", Form::Compare(Op::Ne)),
    row("GT", Form::Compare(Op::Gt)),
    row("GE", Form::Compare(Op::Ge)).also(&["GEQ"]),
    row("LT", Form::Compare(Op::Lt)),
    row("LE", Form::Compare(Op::Le)).also(&["LEQ"]),
    row("MOV", Form::Assign).also(&["ASSIGNMENT"]),
    row("ADD", Form::Calculate(Op::Add)),
    row("SUB", Form::Calculate(Op::Sub)),
    row("MUL", Form::Calculate(Op::Mul)),
    row("DIV", Form::Calculate(Op::Div)),
    row("AND", Form::Calculate(Op::And)),
    row("OR", Form::Calculate(Op::Or)),
    row("XOR", Form::Calculate(Op::Xor)),
    row("NOT", Form::Not),
    row("SCANTIME", Form::ScanTime),
];

/// The row of a word, whatever its case.
pub(super) fn row_of(word: &str) -> Option<&'static Row> {
    let is = |spelling: &str| spelling.eq_ignore_ascii_case(word);
    ROWS.iter()
        .find(|row| is(row.word) || row.also.iter().any(|also| is(also)))
}
