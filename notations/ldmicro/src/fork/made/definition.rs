//! The definitions of the blocks, network by network: what is between `--` is in series. They compute what the
//! fork's own code does, in the same order.

use super::{Count, Kind, Made, MadeCounter, MadeTimer};

/// What a block is made of.
pub(super) struct Definition {
    pub(super) says: &'static str,
    /// `y, t : INT` that are changed, and inputs.
    pub(super) changed: &'static str,
    pub(super) inputs: &'static [&'static str],
    pub(super) own: &'static [&'static str],
    pub(super) networks: Vec<String>,
}

impl Definition {
    fn new(says: &'static str, changed: &'static str, networks: &[&str]) -> Definition {
        Definition {
            says,
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
                "The digits of a number, four bits each.",
                "y : INT",
                &[
                    "[ ]( EN )--[CALC]( y, a MOD 10 + a / 10 MOD 10 * 16 + a / 100 MOD 10 * 256 + a / 1000 MOD 10 * 4096 )",
                ],
            )
            .inputs(&["a : INT"]),
            Made::FromBcd => Definition::new(
                "The number whose digits are given, four bits each.",
                "y : INT",
                &[
                    "[ ]( EN )--[CALC]( y, (a AND 15) + (a SHR 4 AND 15) * 10 + (a SHR 8 AND 15) * 100 + (a SHR 12 AND 15) * 1000 )",
                ],
            )
            .inputs(&["a : INT"]),
            Made::Timer(timer) => timer.definition(),
            Made::Counter(counter) => counter.definition(),
        }
    }
}

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
            says,
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
