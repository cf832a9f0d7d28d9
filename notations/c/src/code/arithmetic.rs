//! Whole numbers, reals, conversions.

use super::{Emitter, width};
use ladder_simulator::compiled::{Bit, Conversion, IntegerOp, RealFunction, RealOp, Width, Word};

impl Emitter<'_> {
    pub(super) fn integer(
        &mut self,
        at: u32,
        when: Option<Bit>,
        op: IntegerOp,
        wide: Width,
        [to, a, other]: [Word; 3],
    ) {
        let bits = width(wide);
        let (to, a, other) = (self.w(to), self.number(a), self.number(other));
        let plain = match op {
            IntegerOp::Add => Some(("plus", format!("plus({a}, {other})"))),
            IntegerOp::Sub => Some(("minus", format!("minus({a}, {other})"))),
            IntegerOp::Mul => Some(("multiplied", format!("multiplied({a}, {other})"))),
            IntegerOp::And => Some(("", format!("{a} & {other}"))),
            IntegerOp::Or => Some(("", format!("{a} | {other}"))),
            IntegerOp::Xor => Some(("", format!("{a} ^ {other}"))),
            IntegerOp::Min => Some(("i_min", format!("i_min({bits}, {a}, {other})"))),
            IntegerOp::Max => Some(("i_max", format!("i_max({bits}, {a}, {other})"))),
            IntegerOp::Abs => Some(("i_abs", format!("i_abs({bits}, {a})"))),
            _ => None,
        };
        if let Some((piece, value)) = plain {
            if !piece.is_empty() {
                self.uses(piece);
            }
            self.uses("wrap");
            let when = when.map_or(String::new(), |out| format!("if ({}) ", self.slot(out)));
            self.line(format!("{when}{to} = wrap({bits}, {value});"));
            return;
        }
        let piece = self.uses(match op {
            IntegerOp::Div => "i_div",
            IntegerOp::Mod => "i_mod",
            IntegerOp::Power => "i_power",
            IntegerOp::Shl => "i_shl",
            IntegerOp::Shr => "i_shr",
            IntegerOp::Rol => "i_rol",
            _ => "i_ror",
        });
        let call = format!("{piece}({bits}, &{to}, {a}, {other})");
        self.faulting(at, &self.guarded(when, &call));
    }

    pub(super) fn real(
        &mut self,
        at: u32,
        when: Option<Bit>,
        op: RealOp,
        single: bool,
        [to, a, other]: [Word; 3],
    ) {
        self.uses("to_real");
        let to = self.w(to);
        let (a, other) = (
            format!("to_real({})", self.w(a)),
            format!("to_real({})", self.w(other)),
        );
        let sign = |op| match op {
            RealOp::Add | RealOp::RawAdd => Some('+'),
            RealOp::Sub | RealOp::RawSub => Some('-'),
            RealOp::Mul | RealOp::RawMul => Some('*'),
            RealOp::RawDiv => Some('/'),
            _ => None,
        };
        if matches!(
            op,
            RealOp::RawAdd | RealOp::RawSub | RealOp::RawMul | RealOp::RawDiv
        ) {
            self.uses("to_word");
            let value = format!("{a} {} {other}", sign(op).unwrap_or('+'));
            let value = if single {
                format!("(double)(float)({value})")
            } else {
                value
            };
            let when = when.map_or(String::new(), |out| format!("if ({}) ", self.slot(out)));
            self.line(format!("{when}{to} = to_word({value});"));
            return;
        }
        let call = match op {
            RealOp::Div | RealOp::Mod | RealOp::Power => {
                let piece = self.uses(match op {
                    RealOp::Div => "r_div",
                    RealOp::Mod => "r_mod",
                    _ => "r_power",
                });
                format!("{piece}({single}, &{to}, {a}, {other})")
            }
            _ => {
                self.uses("put_real");
                let value = match op {
                    RealOp::Min => format!("{other} < {a} ? {other} : {a}"),
                    RealOp::Max => format!("{other} > {a} ? {other} : {a}"),
                    _ => format!("{a} {} {other}", sign(op).unwrap_or('+')),
                };
                format!("put_real(&{to}, {value}, {single})")
            }
        };
        self.faulting(at, &self.guarded(when, &call));
    }

    fn guarded(&self, when: Option<Bit>, call: &str) -> String {
        match when {
            Some(out) => format!("({} ? {call} : 0)", self.slot(out)),
            None => call.to_owned(),
        }
    }

    pub(super) fn function(&mut self, at: u32, function: RealFunction, single: bool, to: Word, a: Word) {
        self.uses("to_real");
        self.uses("put_real");
        let a = format!("to_real({})", self.w(a));
        let (outside, value) = match function {
            RealFunction::Abs => ("", format!("fabs({a})")),
            RealFunction::Neg => ("", format!("-{a}")),
            RealFunction::Trunc => ("", format!("trunc({a})")),
            RealFunction::Sqrt => ("< 0.0", format!("sqrt({a})")),
            RealFunction::Ln => ("<= 0.0", format!("log({a})")),
            RealFunction::Log => ("<= 0.0", format!("log10({a})")),
            RealFunction::Expe => ("", format!("exp({a})")),
            RealFunction::Sin => ("", format!("sin({a})")),
            RealFunction::Cos => ("", format!("cos({a})")),
            RealFunction::Tan => ("", format!("tan({a})")),
            RealFunction::Asin => ("one", format!("asin({a})")),
            RealFunction::Acos => ("one", format!("acos({a})")),
            RealFunction::Atan => ("", format!("atan({a})")),
            RealFunction::Rad => ("", format!("{a} * (3.14159265358979323846 / 180.0)")),
            RealFunction::Deg => ("", format!("{a} * (180.0 / 3.14159265358979323846)")),
        };
        let inside = format!("put_real(&{}, {value}, {single})", self.w(to));
        let call = match outside {
            "" => inside,
            "one" => format!("(fabs({a}) > 1.0 ? FAULT_DOMAIN : {inside})"),
            test => format!("({a} {test} ? FAULT_DOMAIN : {inside})"),
        };
        self.faulting(at, &call);
    }

    pub(super) fn convert(&mut self, at: u32, conversion: Conversion, to: Word, from: Word) {
        let (to, from) = (self.w(to), self.w(from));
        let mut need = |pieces: &[&'static str]| self.body.used.extend(pieces);
        let plain = match conversion {
            Conversion::Wrap(wide) => {
                need(&["wrap"]);
                Some(format!("wrap({}, {from})", width(wide)))
            }
            Conversion::RawSingle => {
                need(&["to_real", "to_word"]);
                Some(format!("to_word((double)(float)to_real({from}))"))
            }
            Conversion::Saturate(wide) => {
                need(&["to_real", "saturate"]);
                let (least, most) = ends(wide);
                Some(format!("saturate(to_real({from}), {least}, {most})"))
            }
            Conversion::Preset(wide) => {
                need(&["preset"]);
                Some(format!("preset({from}, {})", width(wide)))
            }
            Conversion::DayOf => {
                need(&["mod_floor"]);
                Some(format!("{from} - mod_floor({from}, INT64_C(86400000000000))"))
            }
            Conversion::TimeOfDayOf => {
                need(&["mod_floor"]);
                Some(format!("mod_floor({from}, INT64_C(86400000000000))"))
            }
            _ => None,
        };
        if let Some(value) = plain {
            self.line(format!("{to} = {value};"));
            return;
        }
        let call = match conversion {
            Conversion::Fit {
                from: narrow,
                to: wide,
            } => {
                need(&["fits"]);
                // What does not fit is not written.
                format!(
                    "(fits({}, {}, {from}, &held) ? ({to} = held, 0) : FAULT_RANGE)",
                    width(narrow),
                    width(wide)
                )
            }
            Conversion::IntegerToReal { from: wide, single } => {
                need(&["put_real"]);
                let value = if wide == Width::U64 {
                    format!("(double)(uint64_t){from}")
                } else {
                    format!("(double){from}")
                };
                format!("put_real(&{to}, {value}, {single})")
            }
            Conversion::Round(wide) => {
                need(&["to_real", "whole"]);
                format!("whole(&{to}, nearbyint(to_real({from})), {})", width(wide))
            }
            Conversion::Truncate(wide) => {
                need(&["to_real", "whole"]);
                format!("whole(&{to}, trunc(to_real({from})), {})", width(wide))
            }
            Conversion::Single => {
                need(&["to_real", "put_real"]);
                format!("(put_real(&{to}, to_real({from}), true) ? FAULT_RANGE : 0)")
            }
            Conversion::Milliseconds(wide) => {
                need(&["milliseconds"]);
                format!("milliseconds(&{to}, {from}, {})", width(wide))
            }
            Conversion::ToMilliseconds(wide) => {
                need(&["half_even", "fits"]);
                format!(
                    "(fits(64, {}, half_even({from}, 1000000), &held) ? ({to} = held, 0) : FAULT_RANGE)",
                    width(wide)
                )
            }
            Conversion::RealToTime => {
                need(&["to_real", "whole"]);
                format!("whole(&{to}, nearbyint(to_real({from}) * 1e6), 64)")
            }
            Conversion::TimeToReal { single } => {
                need(&["put_real"]);
                format!("put_real(&{to}, (double){from} / 1e6, {single})")
            }
            _ => return,
        };
        self.faulting(at, &call);
    }
}

fn ends(wide: Width) -> (String, String) {
    let bits = width(wide);
    match bits {
        -64 | 64 => ("INT64_MIN".into(), "INT64_MAX".into()),
        ..0 => ("0".into(), format!("UINT{}_MAX", -bits)),
        _ => (format!("INT{bits}_MIN"), format!("INT{bits}_MAX")),
    }
}
