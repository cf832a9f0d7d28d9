//! Where instructions go on, and which of them may fault.

use super::Instr;

impl Instr {
    /// Whether it may end in a fault that the scan survives.
    pub const fn can_fault(&self) -> bool {
        matches!(
            self,
            Instr::Index { .. }
                | Instr::Integer { .. }
                | Instr::IntegerWhen { .. }
                | Instr::Real { .. }
                | Instr::RealWhen { .. }
                | Instr::RealFunction { .. }
                | Instr::Convert { .. }
                | Instr::Routine { .. }
        )
    }

    /// The instructions that it may go on at, other than the one after it.
    pub fn for_each_target(mut self, mut target: impl FnMut(u32)) {
        self.for_each_target_mut(|to| target(*to));
    }

    /// The same, to change them.
    pub fn for_each_target_mut(&mut self, mut target: impl FnMut(&mut u32)) {
        match self {
            Instr::Powered { end, .. } => target(end),
            Instr::Jump { to, .. } | Instr::Call { to, .. } | Instr::Again { body: to } => target(to),
            Instr::Enter { body, after } => {
                target(body);
                target(after);
            }
            _ => {}
        }
    }
}
