//! The definitions of the blocks, network by network: what is between `--` is in series. They compute what the
//! fork's own code does, in the same order.

use super::{Count, Kind, Made, MadeCounter, MadeTimer, Segments};

/// What a block is made of.
pub(super) struct Definition {
    pub(super) says: String,
    /// `y, t : INT` that are changed, and inputs.
    pub(super) changed: &'static str,
    pub(super) inputs: &'static [&'static str],
    pub(super) own: &'static [&'static str],
    pub(super) networks: Vec<String>,
}

impl Definition {
    fn new(says: &str, changed: &'static str, networks: &[&str]) -> Definition {
        Definition {
            says: says.to_owned(),
            changed,
            inputs: &[],
            own: &[],
            networks: networks.iter().map(|network| (*network).to_owned()).collect(),
        }
    }

    fn inputs(self, inputs: &'static [&'static str]) -> Definition {
        Definition { inputs, ..self }
    }

    fn own(self, own: &'static [&'static str]) -> Definition {
        Definition { own, ..self }
    }
}

impl Made {
    pub(super) fn definition(self) -> Definition {
        match self {
            Made::Toggle => Definition::new(
                "Each time power comes, the tag changes over.",
                "q : BOOL",
                &["[ ]( EN )--[OSR]--[XOR]( q, q, TRUE )"],
            ),
            // No loader of the fork that is known reads it; this is what its name and that of `ODF` say.
            Made::OneDropRising => Definition::new(
                "When power comes, its own stays away for one scan; else it is there.",
                "",
                &["[ ]( EN )--[OSR]--( )( rose )", "[/]( rose )--( )( ENO )"],
            )
            .own(&["rose : BOOL"]),
            Made::OneShotLow => Definition::new(
                "When power goes, its own stays away for one scan.",
                "",
                &[
                    "[ ]( low )--[/]( EN )--(S)( ENO )",
                    "[/]( EN )--[ ]( seen )--( )( low )",
                    "[ ]( EN )--[MOV]( seen, TRUE )",
                ],
            )
            .own(&["low, seen : BOOL"]),
            Made::Oscillator => Definition::new(
                "While power is there, its own comes and goes with each scan.",
                "",
                &["[ ]( EN )--[/]( on )--( )( on )--( )( ENO )"],
            )
            .own(&["on : BOOL"]),
            Made::ShiftRight => Definition::new(
                "Shifts to the right; the sign stays.",
                "y : INT",
                &[
                    "[ ]( EN )--[GE]( a, 0 )--[SHR]( y, a, n )",
                    "[ ]( EN )--[LT]( a, 0 )--[NOT]( y, a )--[SHR]( y, y, n )--[NOT]( y, y )",
                ],
            )
            .inputs(&["a, n : INT"]),
            Made::ToBcd => Definition::new(
                "The last two digits of a number, a byte each.",
                "y : INT",
                &[
                    "[ ]( EN )--[CALC]( y, a MOD 10 + a / 10 MOD 10 * 256 )",
                ],
            )
            .inputs(&["a : INT"]),
            Made::FromBcd => Definition::new(
                "The number whose two digits are given, a byte each.",
                "y : INT",
                &[
                    "[ ]( EN )--[CALC]( y, (a AND 15) + (a SHR 8 AND 15) * 10 )",
                ],
            )
            .inputs(&["a : INT"]),
            Made::Swap => Definition::new(
                "The low byte of a number and its high one change places.",
                "y : INT",
                &["[ ]( EN )--[ROL]( y, a, 8 )"],
            )
            .inputs(&["a : INT"]),
            Made::Opposite => Definition::new(
                "The bits of a number in the opposite order.",
                "y : INT",
                &[
                    "[ ]( EN )--[CALC]( y, (a AND 16#5555) * 2 OR (a SHR 1 AND 16#5555) )--[CALC]( y, (y AND 16#3333) * 4 OR (y SHR 2 AND 16#3333) )--[CALC]( y, (y AND 16#0F0F) * 16 OR (y SHR 4 AND 16#0F0F) )--[ROL]( y, y, 8 )",
                ],
            )
            .inputs(&["a : INT"]),
            Made::SetBit => Definition::new(
                "Sets the bit of a number that another one says.",
                "y : INT",
                &["[ ]( EN )--[CALC]( y, y OR (1 SHL n) )"],
            )
            .inputs(&["n : INT"]),
            Made::ClearBit => Definition::new(
                "Clears the bit of a number that another one says.",
                "y : INT",
                &["[ ]( EN )--[CALC]( y, y AND NOT (1 SHL n) )"],
            )
            .inputs(&["n : INT"]),
            Made::IfBitSet => Definition::new(
                "Lets power through while the bit of a number that another one says is set.",
                "",
                &["[ ]( EN )--[CALC]( bit, a AND (1 SHL n) )--[NE]( bit, 0 )--( )( ENO )"],
            )
            .inputs(&["a, n : INT"])
            .own(&["bit : INT"]),
            Made::IfBitClear => Definition::new(
                "Lets power through while the bit of a number that another one says is not set.",
                "",
                &["[ ]( EN )--[CALC]( bit, a AND (1 SHL n) )--[EQ]( bit, 0 )--( )( ENO )"],
            )
            .inputs(&["a, n : INT"])
            .own(&["bit : INT"]),
            Made::TimeToCount => Definition::new(
                "A time, counted in scans.",
                "y : INT",
                &["[ ]( EN )--[MOV]( y, scans )"],
            )
            .inputs(&["scans : INT"]),
            Made::Segments(segments) => segments.definition(),
            Made::Timer(timer) => timer.definition(),
            Made::Counter(counter) => counter.definition(),
        }
    }
}

impl Segments {
    /// Numbers that stand for no character are blank; 176, the degree sign, is the last one.
    fn definition(self) -> Definition {
        let (changed, inputs): (_, &[&str]) = if self.fixed {
            ("y : INT", &["a : INT"])
        } else {
            ("y, a : INT", &[])
        };
        let character = if self.fixed { "k" } else { "a" };
        let last = CHARACTERS.len() - 1;
        let mut networks = vec![
            format!("[ ]( EN )--[EQ]( {character}, 176 )--[MOV]( {character}, {last} )"),
            format!("[ ]( EN )--[LT]( {character}, 0 )--[MOV]( {character}, 32 )"),
            format!("[ ]( EN )--[GT]( {character}, {last} )--[MOV]( {character}, 32 )"),
        ];
        if self.fixed {
            networks.insert(0, "[ ]( EN )--[MOV]( k, a )".to_owned());
        }
        let segments: Vec<String> = CHARACTERS.iter().map(u8::to_string).collect();
        networks.push(format!(
            "[ ]( EN )--[LUT]( y, {character}, {} )",
            segments.join(", ")
        ));
        if self.anode {
            networks.push("[ ]( EN )--[NOT]( y, y )".to_owned());
        }
        let how = if self.anode { "low" } else { "high" };
        Definition {
            says: format!(
                "The segments of a digit or an ASCII character, lit by {how} bits: a to g are bits 0 to 6, the point is 7."
            ),
            changed,
            inputs,
            own: if self.fixed { &["k : INT"] } else { &[] },
            networks,
        }
    }
}

/// The segments that LDmicro lights for 0 to F, the same with a point, the characters from blank on, and the degree sign.
const CHARACTERS: [u8; 129] = [
    0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07, 0x7F, 0x6F, 0x77, 0x7C, 0x39, 0x5E, 0x79, 0x71, 0xBF,
    0x86, 0xDB, 0xCF, 0xE6, 0xED, 0xFD, 0x87, 0xFF, 0xEF, 0xF7, 0xFC, 0xB9, 0xDE, 0xF9, 0xF1, 0x00, 0xB0,
    0x22, 0x4E, 0x6D, 0xD2, 0xDA, 0x20, 0x39, 0x0F, 0x72, 0x70, 0x0C, 0x40, 0x80, 0x52, 0x3F, 0x06, 0x5B,
    0x4F, 0x66, 0x6D, 0x7D, 0x07, 0x7F, 0x6F, 0x09, 0x0D, 0x61, 0x41, 0x43, 0xD3, 0x9F, 0x77, 0x7C, 0x39,
    0x5E, 0x79, 0x71, 0x3D, 0x74, 0x30, 0x1E, 0x75, 0x38, 0x55, 0x54, 0x5C, 0x73, 0x67, 0x33, 0x6D, 0x78,
    0x3E, 0x1C, 0x6A, 0x76, 0x6E, 0x5B, 0x39, 0x64, 0x0F, 0x23, 0x08, 0x20, 0x5F, 0x7C, 0x58, 0x5E, 0x7B,
    0x71, 0x6F, 0x74, 0x10, 0x0E, 0x75, 0x18, 0x55, 0x54, 0x5C, 0x73, 0x67, 0x50, 0x6D, 0x78, 0x3E, 0x1C,
    0x6A, 0x76, 0x6E, 0x5B, 0x39, 0x30, 0x0F, 0x01, 0x00, 0x63,
];

impl MadeTimer {
    fn definition(self) -> Definition {
        let definition = match self {
            MadeTimer::On => Definition::new(
                "Power comes once it has been there for p scans.",
                "t : INT",
                &[
                    "[ ]( EN )--[GE]( t, p )--( )( ENO )",
                    "[ ]( EN )--[/]( ENO )--[ADD]( t, t, 1 )",
                    "[/]( EN )--[MOV]( t, 0 )",
                ],
            ),
            MadeTimer::RetentiveLow => Definition::new(
                "Counts scans without power; its own comes after p of them, and stays.",
                "t : INT",
                &[
                    "[GE]( t, p )--( )( ENO )",
                    "[/]( EN )--[LT]( t, p )--[ADD]( t, t, 1 )",
                ],
            ),
            MadeTimer::Cyclic => Definition::new(
                "While power is there, its own changes over every p + 1 scans.",
                "t : INT",
                &[
                    "[ ]( EN )--[GE]( t, p )--( )( over )",
                    "[/]( EN )--[MOV]( t, 0 )",
                    "[ ]( over )--[MOV]( t, 0 )--[XOR]( on, on, TRUE )",
                    "[ ]( EN )--[/]( over )--[ADD]( t, t, 1 )",
                    "[ ]( EN )--[ ]( on )--( )( ENO )",
                ],
            )
            .own(&["on, over : BOOL"]),
            MadeTimer::High => Definition::new(
                "When power comes, its own is there for p scans.",
                "t : INT",
                &[
                    "[ ]( EN )--(S)( run )",
                    "[ ]( run )--[LT]( t, p )--( )( ENO )--[ADD]( t, t, 1 )",
                    "[ ]( run )--[/]( ENO )--[/]( EN )--[MOV]( t, 0 )--(R)( run )",
                ],
            )
            .own(&["run : BOOL"]),
            MadeTimer::Low => Definition::new(
                "When power goes, its own is away for p scans.",
                "t : INT",
                &[
                    "[/]( EN )--[ ]( seen )--(S)( run )",
                    "[ ]( EN )--[MOV]( seen, TRUE )",
                    "[ ]( run )--[LT]( t, p )--( )( low )--[ADD]( t, t, 1 )",
                    "[ ]( seen )--[/]( low )--( )( ENO )",
                    "[ ]( run )--[/]( low )--[ ]( EN )--[MOV]( t, 0 )--(R)( run )",
                ],
            )
            .own(&["seen, run, low : BOOL"]),
        };
        definition.inputs(&["p : INT"])
    }
}

impl MadeCounter {
    fn definition(self) -> Definition {
        let counts = self.kind.contacts();
        let mut networks = Vec::new();
        if self.from_variable {
            networks.push("[/]( begun )--[MOV]( c, init )--[MOV]( begun, TRUE )".to_owned());
        }
        let says = match self.count {
            Count::Up => {
                networks.push(format!("{counts}--[LT]( c, max )--[ADD]( c, c, 1 )"));
                networks.push("[GE]( c, max )--( )( ENO )".to_owned());
                "Counts up to max; there is power from then on."
            }
            Count::Down => {
                networks.push(format!("{counts}--[GT]( c, max )--[SUB]( c, c, 1 )"));
                networks.push("[GT]( c, max )--( )( ENO )".to_owned());
                "Counts down to max; there is power until then."
            }
            Count::Round => {
                networks.push(format!(
                    "{counts}--[ADD]( c, c, 1 )--[GT]( c, max )--( )( ENO )--[MOV]( c, init )"
                ));
                "Counts up; beyond max it begins again at init, with power for one scan."
            }
            Count::Reverse => {
                networks.push(format!(
                    "{counts}--[SUB]( c, c, 1 )--[LT]( c, max )--( )( ENO )--[MOV]( c, init )"
                ));
                "Counts down; below max it begins again at init, with power for one scan."
            }
        };
        let inputs: &[&str] = if self.count.returns() || self.from_variable {
            &["max, init : INT"]
        } else {
            &["max : INT"]
        };
        Definition {
            says: says.to_owned(),
            changed: "c : INT",
            inputs,
            own: if self.from_variable {
                &["begun : BOOL"]
            } else {
                &[]
            },
            networks,
        }
    }
}

impl Kind {
    /// The contacts that pass power in the scans that count.
    const fn contacts(self) -> &'static str {
        match self {
            Kind::Rising => "[ ]( EN )--[OSR]",
            Kind::Falling => "[ ]( EN )--[OSF]",
            Kind::High => "[ ]( EN )",
            Kind::Low => "[/]( EN )",
        }
    }
}
