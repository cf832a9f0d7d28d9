//! Programs for which verdicts are asked: few networks of few tags, so that much is decided, with inputs of every kind.

use super::case::{Case, Other};
use ladder_generator::constants::literals;
use ladder_generator::generator::Dice;

/// A tag that conditions read: how it is written, its type, and the name of the input that it is, if it is one.
struct Source {
    operand: String,
    ty: &'static str,
}

/// The program of a seed.
pub(crate) fn case(seed: u64) -> Case {
    let mut maker = Maker {
        dice: Dice::new(seed),
        case: Case::default(),
        sources: Vec::new(),
        count: 0,
    };
    maker.begin();
    for _ in 0..2 + maker.dice.below(4) {
        maker.input();
    }
    maker.internal();
    let part = maker.dice.one_in(4).then(|| maker.unread_part());
    for _ in 0..2 + maker.dice.below(5) {
        let network = maker.network();
        maker.case.networks.push(network);
    }
    if let Some(part) = part {
        let at = maker.dice.below(maker.case.networks.len());
        maker.case.networks.insert(at, part);
    }
    maker.case
}

/// Of a type that tags without a declaration have: a stem of names, and the type.
const UNDECLARED: [(&str, &str); 9] = [
    ("lever", "BOOL"),
    ("level", "DINT"),
    ("weight", "LREAL"),
    ("pause", "TIME"),
    ("word", "STRING"),
    ("day", "DATE"),
    ("hour", "TOD"),
    ("moment", "DT"),
    ("phase", "Phase"),
];

/// Names and addresses that say their types.
const FORMS: [(&str, &str); 14] = [
    ("I", "BOOL"),
    // Not the names that are declared below: m0, m1.
    ("M1", "BOOL"),
    ("MI", "DINT"),
    ("MF", "LREAL"),
    ("%IX1.", "BOOL"),
    ("%IB", "BYTE"),
    ("%IW", "WORD"),
    ("%ID", "DWORD"),
    ("%IL", "LWORD"),
    ("%MX2.", "BOOL"),
    ("%MB", "BYTE"),
    ("%MW", "WORD"),
    ("%MD", "DWORD"),
    ("%ML", "LWORD"),
];

const DECLARED: [&str; 20] = [
    "BOOL", "BYTE", "WORD", "DWORD", "LWORD", "SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT",
    "ULINT", "REAL", "LREAL", "TIME", "DATE", "TOD", "DT", "Phase",
];

/// What is before the declaration of an input that has parts.
pub(crate) const PARTS: &str = "VAR_INPUT # of parts #";
/// The block whose instances keep a state.
pub(crate) const INSTANCE: &str = "[$Count]";

const HEAD: &str = "TYPE
    Phase : (IDLE, RUNNING, DONE := 7);
    Recipe : STRUCT
        speed : INT;
        on : BOOL;
        pause : TIME;
        phase : Phase;
        list : ARRAY[1..2] OF INT;
    END_STRUCT;
END_TYPE
FUNCTION_BLOCK [$Count]
VAR_INPUT
    part : BOOL;
    most : INT := 2;
END_VAR
VAR_OUTPUT
    full : BOOL;
END_VAR
VAR
    n : INT;
END_VAR
+--[ ]( part )--[ADD]( n, n, 1 )--+
+--[GT]( n, most )--( )( full )--[MOV]( n, 0 )--+
+--[ ]( full )--( )( ENO )--+
END_FUNCTION_BLOCK
";

struct Maker {
    dice: Dice,
    case: Case,
    sources: Vec<Source>,
    count: usize,
}

impl Maker {
    fn number(&mut self) -> usize {
        self.count += 1;
        self.count
    }

    fn begin(&mut self) {
        if self.dice.one_in(8) {
            let profile = self.dice.of(&["ldmicro", "click", "iot", "logix"]);
            self.case.head = format!("# ladder: profile {profile} #\n");
        }
        self.case.head.push_str(HEAD);
    }

    fn source(&mut self, operand: impl Into<String>, ty: &'static str) {
        let operand = operand.into();
        self.sources.push(Source { operand, ty });
    }

    /// An elementary input that conditions read by its name.
    fn given(&mut self, name: String, ty: &'static str) {
        self.case.inputs.push(name.clone());
        self.source(name, ty);
    }

    fn declare(&mut self, section: &'static str, declaration: String) {
        self.case.declared.push((section, declaration));
    }

    fn input(&mut self) {
        let number = self.number();
        match self.dice.below(12) {
            0..=2 => {
                let (stem, ty) = self.dice.of(&UNDECLARED);
                let name = format!("{stem}_{number}");
                self.case.undeclared.push(format!("{name} : {ty};"));
                self.given(name, ty);
            }
            3 => {
                let (form, ty) = self.dice.of(&FORMS);
                let name = format!("{form}{number}");
                if form.starts_with('M') {
                    self.case.undeclared.push(format!("{name} : {ty};"));
                }
                self.given(name, ty);
            }
            4 | 5 => {
                let ty = self.dice.of(&DECLARED);
                let name = format!("in_{number}");
                self.declare("VAR_INPUT", format!("{name} : {ty};"));
                self.given(name, ty);
            }
            6 => {
                let (size, ty) = self.dice.of(&[
                    ("X1.", "BOOL"),
                    ("W", "INT"),
                    ("W", "UINT"),
                    ("D", "DINT"),
                    ("D", "REAL"),
                    ("L", "LINT"),
                ]);
                let name = format!("at_{number}");
                self.declare("VAR", format!("{name} AT %I{size}{number} : {ty};"));
                self.given(name, ty);
            }
            7 => {
                let ty = self.dice.of(&["BOOL", "INT", "TIME"]);
                let name = format!("row_{number}");
                self.declare(PARTS, format!("{name} : ARRAY[0..2] OF {ty};"));
                self.case
                    .inputs
                    .extend((0..3).map(|index| format!("{name}[{index}]")));
                let index = self.dice.of(&["0", "1", "2", "k", "k + 1"]);
                self.source(format!("{name}[{index}]"), ty);
            }
            8 => {
                let name = format!("mix_{number}");
                self.declare(PARTS, format!("{name} : Recipe;"));
                let parts = [
                    ("speed", "INT"),
                    ("on", "BOOL"),
                    ("pause", "TIME"),
                    ("phase", "Phase"),
                    ("list[1]", "INT"),
                    ("list[2]", "INT"),
                ];
                self.case
                    .inputs
                    .extend(parts.iter().map(|(part, _)| format!("{name}.{part}")));
                for _ in 0..2 {
                    let (part, ty) = self.dice.of(&parts);
                    self.source(format!("{name}.{part}"), ty);
                }
            }
            9 => self.global(number),
            10 => {
                // What is never written keeps its value.
                let name = format!("fixed_{number}");
                let section = self.dice.of(&["VAR", "VAR CONSTANT"]);
                self.declare(section, format!("{name} : INT := 3;"));
                self.source(name, "INT");
            }
            _ => {
                let name = format!("bits_{number}");
                self.declare("VAR_INPUT", format!("{name} : WORD;"));
                self.case.inputs.push(name.clone());
                let bit = self.dice.below(3);
                self.source(format!("{name}.{bit}"), "BOOL");
            }
        }
    }

    /// A VAR_GLOBAL tag that another file writes.
    fn global(&mut self, number: usize) {
        let (name, ty) = (format!("shared_{number}"), self.dice.of(&["BOOL", "INT", "TIME"]));
        let networks = match ty {
            "BOOL" => format!("+--[ ]( I1 )--( )( {name} )--+\n"),
            _ => format!("+--[ ]( I1 )--[MOV]( {name}, {} )--+\n", literals(ty)[1]),
        };
        let (declares, own) = if self.dice.one_in(2) {
            (
                format!("VAR_GLOBAL\n    {name} : {ty};\nEND_VAR\n"),
                "VAR_EXTERNAL",
            )
        } else {
            (String::new(), "VAR_GLOBAL")
        };
        self.declare(own, format!("{name} : {ty};"));
        let names = [
            "other.clad",
            "another.clad",
            "third.clad",
            "fourth.clad",
            "fifth.clad",
        ];
        let name_of_file = names[self.case.others.len().min(4)];
        match self
            .case
            .others
            .iter_mut()
            .find(|other| other.name == name_of_file)
        {
            Some(other) => {
                other.declares.push_str(&declares);
                other.networks.push_str(&networks);
            }
            None => self.case.others.push(Other {
                name: name_of_file,
                declares,
                networks,
            }),
        }
        self.given(name, ty);
    }

    /// The tags that the program writes.
    fn internal(&mut self) {
        for declaration in [
            "m0, m1 : BOOL;",
            "n0, k : INT;",
            "n1 : DINT;",
            "list : ARRAY[0..3] OF INT;",
        ] {
            self.declare("VAR", declaration.to_owned());
        }
        self.declare("VAR_OUTPUT", "y0, y1, y2 : BOOL;".to_owned());
        self.declare("VAR_OUTPUT", "y3 : DINT;".to_owned());
        for (name, ty) in [
            ("m0", "BOOL"),
            ("m1", "BOOL"),
            ("n0", "INT"),
            ("n1", "DINT"),
            ("list[k]", "INT"),
        ] {
            self.source(name, ty);
        }
    }

    /// A network with an unread part. What the controller runs in its place writes whatever goes into that.
    fn unread_part(&mut self) -> String {
        let directive = self.dice.of(&[
            "unread",
            "unread, writes m0, n0, filled",
            "unread, at any time, writes m0, n0, filled",
        ]);
        self.case.head.push_str(&format!(
            "FUNCTION_BLOCK [$PART]\n# ladder: {directive} #\nEND_FUNCTION_BLOCK\n"
        ));
        let (conditions, coil) = (self.conditions(), self.coil());
        // Nothing else writes it, and no file declares it.
        self.source("filled", "BOOL");
        self.case
            .inputs
            .extend(["part_writes", "part_bit", "part_number", "part_power"].map(str::to_owned));
        let part = format!("+--{conditions}[$PART]( )--{coil}--+\n");
        let real = format!(
            "+--{conditions}( )( part_in )--+
+--[ ]( part_writes )--[MOV]( n0, part_number )--+
+--[ ]( part_writes )--[ ]( part_bit )--(S)( m0 )--+
+--[ ]( part_writes )--[ ]( part_bit )--(S)( filled )--+
+--[ ]( part_writes )--[/]( part_bit )--(R)( m0 )--(R)( filled )--+
+--[ ]( part_power )--{coil}--+
VAR_INPUT
    part_writes, part_bit, part_power : BOOL;
    part_number : INT;
END_VAR
VAR
    part_in : BOOL;
END_VAR
"
        );
        self.case.parts.push((part.clone(), real));
        part
    }

    /// A condition.
    fn condition(&mut self) -> String {
        let at = self.dice.below(self.sources.len());
        let Source { operand, ty } = &self.sources[at];
        match *ty {
            "BOOL" => {
                let contact = self.dice.of(&["[ ]", "[ ]", "[/]", "[/]", "[P]", "[N]"]);
                format!("{contact}( {operand} )")
            }
            ty => {
                let is_plain = matches!(ty, "Phase" | "STRING" | "BYTE" | "WORD" | "DWORD" | "LWORD");
                let compare = if is_plain {
                    self.dice.of(&["EQ", "NE"])
                } else {
                    self.dice.of(&["EQ", "NE", "GT", "GE", "LT", "LE"])
                };
                format!("[{compare}]( {operand}, {} )", self.dice.of(literals(ty)))
            }
        }
    }

    fn conditions(&mut self) -> String {
        let count = 1 + self.dice.below(2);
        (0..count).map(|_| self.condition() + "--").collect()
    }

    fn bool(&mut self) -> String {
        let bools: Vec<&str> = (self.sources.iter())
            .filter(|source| source.ty == "BOOL")
            .map(|source| source.operand.as_str())
            .collect();
        self.dice.of(&bools).to_owned()
    }

    /// An integer that fits an INT.
    fn integer(&mut self) -> String {
        let integers: Vec<&str> = (self.sources.iter())
            .filter(|source| source.ty == "INT")
            .map(|source| source.operand.as_str())
            .collect();
        if self.dice.one_in(3) {
            self.dice.of(literals("INT")).to_owned()
        } else {
            self.dice.of(&integers).to_owned()
        }
    }

    fn coil(&mut self) -> String {
        let coil = self.dice.of(&["( )", "( )", "( )", "(/)", "(S)", "(R)", "(P)"]);
        let tag = self.dice.of(&["y0", "y0", "y1", "y2", "m0", "m1"]);
        format!("{coil}( {tag} )")
    }

    /// A block that writes a number.
    fn computing(&mut self) -> String {
        let (a, b) = (self.integer(), self.integer());
        let to = self.dice.of(&["n0", "n0", "list[k]", "k"]);
        match self.dice.below(8) {
            6 => format!("[WRAP]( {}, {a} )", self.dice.of(&["n1", "y3", "n0"])),
            0 => format!("[MOV]( {to}, {a} )"),
            1 => format!("[ADD]( {to}, {to}, 1 )"),
            2 => format!("[SUB]( n1, {a}, {b} )"),
            3 => format!("[CALC]( y3, {a} + {b} )"),
            4 => format!("[SEL]( {to}, {}, {a}, {b} )", self.bool()),
            5 => format!("[LIMIT]( {to}, 0, {a}, 3 )"),
            _ => format!("[MOV]( k, {} )", self.dice.of(&["0", "1", "2", "3", "4"])),
        }
    }

    /// A network, or several that belong together.
    fn network(&mut self) -> String {
        let conditions = self.conditions();
        let number = self.number();
        let coil = self.coil();
        match self.dice.below(14) {
            0..=4 => format!("+--{conditions}{coil}--+\n"),
            5 | 6 => format!("+--{conditions}{}--+\n", self.computing()),
            7 => {
                let kind = self.dice.of(&["TON", "TOF", "TP", "RTO"]);
                self.declare("VAR", format!("t{number} : {kind};"));
                let preset = self.dice.of(&["T#30ms", "T#10ms", "T#50ms"]);
                if self.dice.one_in(3) {
                    let second = self.conditions();
                    return format!(
                        "+--{conditions}[{kind}]( t{number}, {preset} )--{coil}--+
# ladder: allow(duplicate-timer): one instance #
+--{second}[{kind}]( t{number}, T#20ms )--( )( m1 )--+\n"
                    );
                }
                format!("+--{conditions}[{kind}]( t{number}, {preset} )--{coil}--+\n")
            }
            8 => {
                let kind = self.dice.of(&["CTU", "CTD", "CTC"]);
                self.declare("VAR", format!("c{number} : {kind};"));
                let (preset, reset) = (self.dice.of(&["1", "2", "3"]), self.bool());
                if self.dice.one_in(3) {
                    let second = self.conditions();
                    return format!(
                        "+--{conditions}[{kind}]( c{number}, {preset}, R := {reset} )--{coil}--+
# ladder: allow(duplicate-counter): one instance #
+--{second}[{kind}]( c{number}, 3 )--( )( m1 )--+\n"
                    );
                }
                format!("+--{conditions}[{kind}]( c{number}, {preset}, R := {reset} )--{coil}--+\n")
            }
            9 => {
                let (one, two) = (self.computing(), self.computing());
                let turns = self.dice.of(&["2", "3", "n0"]);
                if self.dice.one_in(3) && !self.case.head.contains("profile click") {
                    let (inner, out) = (self.dice.of(&["1", "2", "n0"]), self.condition());
                    return format!(
                        "+--{conditions}<FOR>( {turns}, I := k )--+\n+--{one}--<FOR>( {inner} )--+\n+--{two}--+\n+--{out}--<JMP>( out_{number} )--+\n+--<NEXT>--+\n+--<NEXT>--+\n+--<LBL>( out_{number} )--{coil}--+\n"
                    );
                }
                format!(
                    "+--{conditions}<FOR>( {turns}, I := k )--+\n+--{one}--+\n+--{two}--+\n+--<NEXT>--+\n"
                )
            }
            10 => {
                let (over, coil) = (self.conditions(), self.coil());
                let after = self.conditions();
                format!(
                    "+--{conditions}<JMP>( to_{number} )--+\n+--{over}{coil}--+\n+--<LBL>( to_{number} )--{after}{}--+\n",
                    self.coil()
                )
            }
            11 => {
                let (name, part) = (format!("f_{number}"), self.computing());
                let coil_of_it = self.coil();
                self.case
                    .tail
                    .push_str(&format!("+--<FUN>( {name} )--{part}--{coil_of_it}--+\n"));
                format!("+--{conditions}<CALL>( {name} )--+\n")
            }
            _ => {
                let part = self.bool();
                let out = self.dice.of(&["y0", "y1", "m0"]);
                if self.dice.one_in(2) {
                    self.declare("VAR", format!("i{number} : $Count;"));
                    if self.dice.one_in(2) {
                        let (most, given) = (self.integer(), self.conditions());
                        return format!(
                            "+--{given}( )( i{number}.part )--[MOV]( i{number}.most, {most} )--+
+--{conditions}{INSTANCE}( i{number}, full => {out} )--{coil}--+\n"
                        );
                    }
                    return format!(
                        "+--{conditions}{INSTANCE}( i{number}, part := {part}, full => {out} )--{coil}--+\n"
                    );
                }
                if self.dice.one_in(2) {
                    format!("+--{conditions}{INSTANCE}( part := {part}, full => {out} )--{coil}--+\n")
                } else {
                    format!(
                        "+--{conditions}{INSTANCE}( {part}, {}, {out} )--{coil}--+\n",
                        self.integer()
                    )
                }
            }
        }
    }
}
