//! Jumps, calls, loops, zones.

use super::{Emitter, MOST_TURNS, width};
use crate::header::comment;
use ladder_simulator::compiled::{Bit, CALL_DEPTH, Instr, NOTHING_SAVED};
use std::fmt::Write;

/// The innermost loop that runs.
const INNERMOST: &str = "frame.loop[frame.loops - 1]";

impl Emitter<'_> {
    pub(super) fn flow(&mut self, at: u32, instr: Instr) {
        match instr {
            Instr::Mcr { en } => self.line(format!("frame.rail = {};", self.whole(en))),
            Instr::Jump { en, to, .. } => {
                let mut actions = String::new();
                if self.loops {
                    let _ = write!(
                        actions,
                        "frame.noted = 0; while (frame.loops > 0 && ({to} < {INNERMOST}.body || {to} >= {INNERMOST}.after)) frame.loops--; "
                    );
                }
                if to <= at {
                    let _ = write!(actions, "if (++turns > {MOST_TURNS}) goto stopped; ");
                }
                self.line(format!("if ({}) {{ {actions}goto L{to}; }}", self.whole(en)));
            }
            Instr::Call { en, to, saved } => {
                let mut actions =
                    format!("if (depth == {CALL_DEPTH} || ++turns > {MOST_TURNS}) goto stopped; depth++; ");
                if saved != NOTHING_SAVED {
                    for power in &self.code.saved[saved as usize] {
                        let _ = write!(actions, "saved[kept++] = b[{}]; ", power.0);
                    }
                }
                let _ = write!(
                    actions,
                    "frames[open++] = frame; frame = fresh; frame.back = {}; ",
                    at + 1
                );
                self.line(format!("if ({}) {{ {actions}goto L{to}; }}", self.whole(en)));
            }
            Instr::Return { en, .. } => {
                let target = self.back();
                self.line(format!("if ({}) goto {target};", self.whole(en)));
            }
            Instr::Finish => {
                let target = self.back();
                self.line(format!("goto {target};"));
            }
            Instr::End { en, .. } => {
                self.line(format!(
                    "if ({}) {{ self->ended = true; goto done; }}",
                    self.whole(en)
                ));
            }
            Instr::For { en, turns } => {
                self.line(format!("frame.noted = {} ? {} : 0;", self.b(en), self.w(turns)));
            }
            Instr::Enter { body, after } => {
                self.line(format!(
                    "if (frame.noted <= 0) {{ frame.noted = 0; goto L{after}; }}"
                ));
                self.line(format!(
                    "frame.loops++; {INNERMOST}.body = {body}; {INNERMOST}.after = {after}; {INNERMOST}.left = frame.noted - 1; {INNERMOST}.turn = 1; frame.noted = 0;"
                ));
            }
            Instr::Turn { to, width: wide } => {
                self.uses("wrap");
                self.line(format!(
                    "{} = wrap({}, {INNERMOST}.turn);",
                    self.w(to),
                    width(wide)
                ));
            }
            Instr::Again { body } => {
                self.line(format!("if (frame.loops > 0 && {INNERMOST}.body == {body}) {{"));
                self.line(format!(
                    "    if ({INNERMOST}.left > 0) {{ if (++turns > {MOST_TURNS}) goto stopped; {INNERMOST}.left--; {INNERMOST}.turn++; frame.noted = 0; goto L{body}; }}"
                ));
                self.line("    frame.loops--;");
                self.line("}");
            }
            Instr::EnterBody if self.loops || self.zones => {
                self.line("frames[open++] = frame; frame = fresh;");
            }
            Instr::LeaveBody if self.loops || self.zones => self.line("frame = frames[--open];"),
            Instr::EnterBody | Instr::LeaveBody => {}
            // What is shown of a scan: C shows nothing.
            Instr::Network { .. } | Instr::Left { .. } => {}
            Instr::Unread { at } => self.unread(at),
            _ => self.body.missing.push((at, "a counterpart of it")),
        }
    }

    /// Nothing is known of an unread part: it is for a person to write.
    fn unread(&mut self, number: u32) {
        let part = &self.code.unread[number as usize];
        if part.power.is_some() {
            self.line(format!(
                "/* the unread part {} is not in it */",
                comment(&part.name)
            ));
        }
    }

    pub(super) fn back(&mut self) -> &'static str {
        self.goes_back |= self.calls;
        if self.calls { "go_back" } else { "done" }
    }

    /// Where calls come back: places that are known only while a scan runs.
    pub(super) fn going_back(&self) -> String {
        let mut text = String::from(
            "\ngo_back:\n    if (depth == 0) goto done;\n    depth--;\n    to = frame.back;\n    frame = frames[--open];\n",
        );
        let callers: Vec<(u32, &Vec<Bit>)> = (0..)
            .zip(&self.code.instrs)
            .filter_map(|(at, instr)| match *instr {
                Instr::Call { saved, .. } if saved != NOTHING_SAVED => {
                    Some((at + 1, &self.code.saved[saved as usize]))
                }
                _ => None,
            })
            .collect();
        if !callers.is_empty() {
            text.push_str("    switch (to) {\n");
            for (back, powers) in callers {
                let _ = write!(text, "    case {back}:");
                for power in powers.iter().rev() {
                    let _ = write!(text, " b[{}] = saved[--kept];", power.0);
                }
                text.push_str(" break;\n");
            }
            text.push_str("    default: break;\n    }\n");
        }
        text.push_str("    switch (to) {\n");
        let calls = (0_u32..).zip(&self.code.instrs);
        let calls = calls.filter(|(_, instr)| matches!(instr, Instr::Call { .. }));
        for target in calls.map(|(at, _)| at + 1) {
            let _ = writeln!(text, "    case {target}: goto L{target};");
        }
        text.push_str("    default: goto done;\n    }\n");
        text
    }
}
