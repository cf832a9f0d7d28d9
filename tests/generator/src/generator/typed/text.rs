//! Typed programs as texts.

use super::{Act, CELL, Declared, Index, Initial, Path, Span, Step, Ty, Typed};
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
    s : @;
END_VAR
VAR_INPUT
    k : INT;
END_VAR
+--[ADD]( s.n, s.n, k )--[MOV]( s.row[k], s.n )--+

+--[ ]( s.on )--[TON]( s.t, T#20ms )--( )( s.done )--+

+--[$Acc]( s.acc, s.on, k, s.total )--+
END_FUNCTION_BLOCK
";

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
        f.write_str(&self.tag)?;
        for step in &self.steps {
            match step {
                Step::Member(name) => write!(f, ".{name}")?,
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

impl Typed {
    fn spelled(&self, ty: &Ty) -> String {
        match ty {
            Ty::Bool => "BOOL".to_owned(),
            Ty::Int => "INT".to_owned(),
            Ty::Range(low, high) => format!("INT({low}..{high})"),
            Ty::Phase => self.phase.name.clone(),
            Ty::Structure(number) => self.structures[*number].name.clone(),
            Ty::Alias(number) => self.aliases[*number].name.clone(),
            Ty::Array(dimensions, element) => {
                let bounds = dimensions.iter().map(|(first, last)| format!("{first}..{last}"));
                let bounds = bounds.collect::<Vec<_>>().join(", ");
                format!("ARRAY[{bounds}] OF {}", self.spelled(element))
            }
            Ty::Ton => "TON".to_owned(),
            Ty::Ctu => "CTU".to_owned(),
            Ty::Acc => "$Acc".to_owned(),
        }
    }

    fn value(&self, ty: &Ty, initial: &Initial) -> String {
        let list = |parts: Vec<String>| parts.join(", ");
        match (self.real(ty), initial) {
            (Ty::Bool, Initial::Number(number)) => ["FALSE", "TRUE"][usize::from(*number != 0)].to_owned(),
            (_, Initial::Number(number)) => number.to_string(),
            (_, Initial::Value(name)) => name.clone(),
            (Ty::Structure(number), Initial::Members(members)) => {
                let members = members.iter().map(|(name, initial)| {
                    let ty = self.member(number, name).map_or(Ty::Int, |it| it.1.ty.clone());
                    format!("{name} := {}", self.value(&ty, initial))
                });
                format!("({})", list(members.collect()))
            }
            (Ty::Array(_, element), Initial::Elements(elements)) => {
                let elements = elements.iter().map(|(count, initial)| match initial {
                    Some(initial) if *count == 1 => self.value(&element, initial),
                    Some(initial) => format!("{count}({})", self.value(&element, initial)),
                    None => format!("{count}()"),
                });
                format!("[{}]", list(elements.collect()))
            }
            _ => String::new(),
        }
    }

    fn declaration(&self, declared: &Declared) -> String {
        let ty = self.spelled(&declared.ty);
        let initial = declared.initial.as_ref();
        let initial = initial.map(|initial| format!(" := {}", self.value(&declared.ty, initial)));
        format!("{} : {ty}{};", declared.name, initial.unwrap_or_default())
    }
}

impl fmt::Display for Typed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let values = self.phase.values.iter();
        let values = values.map(|(name, number)| format!("{name} := {number}"));
        let values = values.collect::<Vec<_>>().join(", ");
        let initial = self.phase.initial.iter().map(|name| format!(" := {name}"));
        let initial: String = initial.collect();
        writeln!(f, "TYPE\n    {} : ({values}){initial};", self.phase.name)?;
        for alias in &self.aliases {
            writeln!(f, "    {}", self.declaration(alias))?;
        }
        for structure in &self.structures {
            writeln!(f, "    {} : STRUCT", structure.name)?;
            for member in &structure.members {
                writeln!(f, "        {}", self.declaration(member))?;
            }
            writeln!(f, "    END_STRUCT;")?;
        }
        let blocks = BLOCKS.replace('@', &self.structures[CELL].name);
        writeln!(
            f,
            "END_TYPE\n\n{blocks}\nVAR_INPUT\n    e0, e1, e2 : BOOL;\n    i0, i1, i2 : INT;\nEND_VAR\nVAR"
        )?;
        for tag in &self.tags {
            writeln!(f, "    {}", self.declaration(tag))?;
        }
        for rung in &self.rungs {
            writeln!(f, "    ok{} : BOOL;", rung.number)?;
        }
        writeln!(f, "END_VAR\n")?;
        for rung in &self.rungs {
            let input = rung
                .input
                .map(|input| format!("[ ]( e{input} )--"))
                .unwrap_or_default();
            writeln!(f, "+--{input}{}--( )( ok{} )--+\n", rung.act, rung.number)?;
        }
        Ok(())
    }
}
