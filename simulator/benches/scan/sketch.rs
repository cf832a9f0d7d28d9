//! A program that is written as ladder text and as C at the same time.

use std::fmt::Write;

/// A type that the programs use.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Type {
    Bool,
    Dint,
    Lreal,
    Ton,
    Tof,
    Ctu,
}

impl Type {
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Type::Bool => "BOOL",
            Type::Dint => "DINT",
            Type::Lreal => "LREAL",
            Type::Ton => "TON",
            Type::Tof => "TOF",
            Type::Ctu => "CTU",
        }
    }
}

/// A tag.
#[derive(Debug, Clone)]
pub(crate) struct Tag {
    pub(crate) name: String,
    pub(crate) ty: Type,
}

/// The program so far.
#[derive(Debug, Default)]
pub(crate) struct Sketch {
    pub(crate) tags: Vec<Tag>,
    /// Tags that change from outside, by their place among all.
    pub(crate) inputs: Vec<usize>,
    /// The drawing of the main program.
    pub(crate) drawing: String,
    /// The C of each network.
    pub(crate) c: Vec<String>,
    /// How many powers there are to keep.
    pub(crate) powers: usize,
    /// The network that is being written.
    current: String,
}

impl Sketch {
    /// A tag of the program; gives its name.
    pub(crate) fn tag(&mut self, name: impl Into<String>, ty: Type) -> String {
        let name = name.into();
        self.tags.push(Tag {
            name: name.clone(),
            ty,
        });
        name
    }

    /// A BOOL that changes from outside.
    pub(crate) fn input(&mut self, name: impl Into<String>) -> String {
        self.inputs.push(self.tags.len());
        self.tag(name, Type::Bool)
    }

    /// How many networks there are.
    pub(crate) fn networks(&self) -> usize {
        self.c.len()
    }

    /// C for a power that a block or join gives. The variable that holds it.
    pub(crate) fn power(&mut self, expression: &str) -> String {
        let number = self.powers;
        self.powers += 1;
        let _ = writeln!(self.current, "  bool p{number} = {expression}; KEEP({number})");
        format!("p{number}")
    }

    /// C for what a block does.
    pub(crate) fn act(&mut self, statement: &str) {
        let _ = writeln!(self.current, "  {statement}");
    }

    /// Ends a network: this is how it is drawn.
    pub(crate) fn draw(&mut self, drawing: &str) {
        self.drawing.push_str(drawing);
        self.drawing.push('\n');
        self.c.push(std::mem::take(&mut self.current));
    }
}

/// The same numbers in every run and in C.
#[derive(Debug)]
pub(crate) struct Dice(pub(crate) u32);

impl Dice {
    pub(crate) fn roll(&mut self, below: usize) -> usize {
        self.0 = self.0.wrapping_mul(1_103_515_245).wrapping_add(12_345);
        (self.0 >> 8) as usize % below
    }
}
