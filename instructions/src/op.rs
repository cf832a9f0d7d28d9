//! The identity of each instruction, so that other crates can match exhaustively.

/// One variant for each row of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum Op {
    // §5.1
    Contact,
    NegatedContact,
    RisingContact,
    FallingContact,
    Inverter,
    OneShotRising,
    OneShotFalling,
    Eq,
    Ne,
    Gt,
    Ge,
    Lt,
    Le,
    // §5.2
    Mov,
    Typ,
    Wrap,
    Add,
    Mul,
    Sub,
    Div,
    Mod,
    Exp,
    Not,
    And,
    Or,
    Xor,
    Shl,
    Shr,
    Rol,
    Ror,
    Abs,
    Neg,
    Trunc,
    Sqrt,
    Ln,
    Log,
    Expe,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Rad,
    Deg,
    Min,
    Max,
    Limit,
    Sel,
    Mux,
    Calc,
    Len,
    Left,
    Right,
    Mid,
    Concat,
    Insert,
    Delete,
    Replace,
    Find,
    Bmov,
    Fill,
    Pack,
    Unpack,
    Shift,
    Search,
    Lut,
    Pwl,
    // §5.3
    Ton,
    Tof,
    Tp,
    Rto,
    Rtof,
    Ctu,
    Ctd,
    Ctud,
    Ctc,
    Sr,
    Rs,
    // §5.4
    Coil,
    NegatedCoil,
    SetCoil,
    ResetCoil,
    RisingCoil,
    FallingCoil,
    RetentiveCoil,
    RetentiveSet,
    RetentiveReset,
    Res,
    // §5.5
    Lbl,
    Jmp,
    Fun,
    Call,
    Ret,
    End,
    For,
    Next,
    Mcr,
    // §5.6
    Adc,
    Pwm,
    Usnd,
    Urcv,
    Fmt,
    Persist,
    Scantime,
}

impl Op {
    /// How many instructions there are.
    pub const COUNT: usize = Op::Scantime as usize + 1;

    /// The instructions that every system has that computes as C does, see
    /// [`Arithmetic::OfOperands`](crate::Arithmetic).
    pub const fn is_plain_arithmetic(self) -> bool {
        matches!(
            self,
            Op::Mov | Op::Add | Op::Sub | Op::Mul | Op::Div | Op::And | Op::Or | Op::Xor | Op::Not
        )
    }
}
