//! Typed programs as texts.

use super::{Act, Index, Path, Span, Step, Ty, Typed};
use std::fmt;

const BLOCKS: &str = "\
FUNCTION_BLOCK [$Acc]
VAR_INPUT
    x  : BOOL;
    by : INT;
END_VAR
VAR_OUTPUT
    total : INT;
END_VAR
+--[ ]( x )--[OSR]--[ADD]( total, total, by )--+
END_FUNCTION_BLOCK

FUNCTION_BLOCK [$Poke]
VAR_IN_OUT
    s : Cell;
END_VAR
VAR_INPUT
    k : INT;
END_VAR
+--[ADD]( s.n, s.n, k )--[MOV]( s.row[k], s.n )--+

+--[ ]( s.on )--[TON]( s.t, T#20ms )--( )( s.done )--+

+--[$Acc]( s.acc, s.on, k, s.total )--+
END_FUNCTION_BLOCK
";

impl fmt::Display for Ty {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Ty::Bool => f.write_str("BOOL"),
            Ty::Int => f.write_str("INT"),
            Ty::Phase => f.write_str("Phase"),
            Ty::Structure(number) => f.write_str(["Item", "Line", "Cell"][*number]),
            Ty::Array(dimensions, element) => {
                let bounds = dimensions.iter().map(|(first, last)| format!("{first}..{last}"));
                write!(f, "ARRAY[{}] OF {element}", bounds.collect::<Vec<_>>().join(", "))
            }
            Ty::Ton => f.write_str("TON"),
            Ty::Ctu => f.write_str("CTU"),
            Ty::Acc => f.write_str("$Acc"),
        }
    }
}

impl fmt::Display for Index {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Index::Number(number) => write!(f, "{number}"),
            Index::Input(input, 0) => write!(f, "i{input}"),
            Index::Input(input, more @ ..0) => write!(f, "i{input} - {}", -more),
            Index::Input(input, more) => write!(f, "i{input} + {more}"),
        }
    }
}

fn list(indices: &[Index]) -> String {
    let indices = indices.iter().map(ToString::to_string);
    indices.collect::<Vec<_>>().join(", ")
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.tag.1)?;
        for step in &self.steps {
            match step {
                Step::Member(_, name) => write!(f, ".{name}")?,
                Step::Element(indices) => write!(f, "[{}]", list(indices))?,
            }
        }
        Ok(())
    }
}

impl fmt::Display for Span {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (others, first, last) = &self.indices;
        write!(f, "{}[", self.array)?;
        for index in others {
            write!(f, "{index}, ")?;
        }
        write!(f, "{first}..{last}]")
    }
}

impl fmt::Display for Act {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Act::Move(y, a) => write!(f, "[MOV]( {y}, {a} )"),
            Act::Select(to, by, [low, high]) => write!(f, "[SEL]( {to}, {by}, {low}, {high} )"),
            Act::Choose(to, by, [first, second, third]) => {
                write!(f, "[MUX]( {to}, {by}, {first}, {second}, {third} )")
            }
            Act::Add(y, a, b) => write!(f, "[ADD]( {y}, {a}, {b} )"),
            Act::ToPhase(y, a) | Act::ToNumber(y, a) => write!(f, "[TYP]( {y}, {a} )"),
            Act::Equal(a, b) => write!(f, "[EQ]( {a}, {b} )"),
            Act::Contact(a) => write!(f, "[ ]( {a} )"),
            Act::Coil(a) => write!(f, "( )( {a} )"),
            Act::Fill(y, a) => write!(f, "[FILL]( {y}, {a} )"),
            Act::Copy(y, a) => write!(f, "[BMOV]( {y}, {a} )"),
            Act::Ton(t) => write!(f, "[TON]( {t}, T#20ms )"),
            Act::Ctu(c) => write!(f, "[CTU]( {c}, 2 )"),
            Act::Acc(state, [x, by, total]) => write!(f, "[$Acc]( {state}, {x}, {by}, {total} )"),
            Act::Poke(cell, by) => write!(f, "[$Poke]( {cell}, {by} )"),
        }
    }
}

impl fmt::Display for Typed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let phases = self
            .phases
            .iter()
            .map(|(name, number)| format!("{name} := {number}"));
        writeln!(
            f,
            "TYPE\n    Phase : ({});",
            phases.collect::<Vec<_>>().join(", ")
        )?;
        for (number, members) in self.structures.iter().enumerate() {
            writeln!(f, "    {} : STRUCT", Ty::Structure(number))?;
            for (name, ty, start) in members {
                match start {
                    0 => writeln!(f, "        {name} : {ty};")?,
                    start => writeln!(f, "        {name} : {ty} := {start};")?,
                }
            }
            writeln!(f, "    END_STRUCT;")?;
        }
        writeln!(
            f,
            "END_TYPE\n\n{BLOCKS}\nVAR_INPUT\n    e0, e1, e2 : BOOL;\n    i0, i1, i2 : INT;\nEND_VAR\nVAR"
        )?;
        for (name, ty) in &self.tags {
            writeln!(f, "    {name} : {ty};")?;
        }
        for number in 0..self.rungs.len() {
            writeln!(f, "    ok{number} : BOOL;")?;
        }
        writeln!(f, "END_VAR\n")?;
        for (number, rung) in self.rungs.iter().enumerate() {
            let input = rung
                .input
                .map(|input| format!("[ ]( e{input} )--"))
                .unwrap_or_default();
            writeln!(f, "+--{input}{}--( )( ok{number} )--+\n", rung.act)?;
        }
        Ok(())
    }
}
