//! Types that a file uses and does not declare: those that every controller has, and those of modules. Their members are
//! those that the program uses; each has the type that the manuals tell (1756-RM003, General Instructions; 1756-RM006,
//! Process Control; MOTION-RM002), else that of its use.

use crate::mnemonic::Role;
use crate::operand::{Expr, Path, Step};
use crate::scope::Tags;
use crate::types::{Elem, Field, Ty, Types};
use ladder_notation::names::Names;

/// The members of types that every controller has.
const KNOWN: &[(&str, Elem, &str)] = &[
    ("MESSAGE", Elem::Bool, "EW ER DN ST EN TO EN_CC"),
    (
        "MESSAGE",
        Elem::Int,
        "FLAGS ERR DN_LEN REQ_LEN DestinationLink DestinationNode SourceLink Class Attribute",
    ),
    (
        "MESSAGE",
        Elem::Dint,
        "EXERR Instance LocalIndex RemoteIndex UnconnectedTimeout ConnectionRate",
    ),
    (
        "MESSAGE",
        Elem::Sint,
        "ERR_SRC Channel Rack Group Slot TimeoutMultiplier",
    ),
    ("MESSAGE", Elem::String(82), "Path RemoteElement"),
    (
        "PID",
        Elem::Bool,
        "EN CT CL PVT DOE SWM CA MO PE NDF NOBC NOZC INI SPOR OLL OLH EWD DVNA DVPA PVLA PVHA",
    ),
    (
        "PID",
        Elem::Real,
        "SP KP KI KD BIAS MAXS MINS DB SO MAXO MINO UPD PV ERR OUT PVH PVL DVP DVN PVDB DVDB MAXI MINI TIE MAXCV MINCV \
         MINTIE MAXTIE DATA",
    ),
    ("PID", Elem::Dint, "CTL"),
    (
        "FBD_TIMER",
        Elem::Bool,
        "EnableIn TimerEnable Reset EnableOut EN TT DN InstructFault PresetInv",
    ),
    ("FBD_TIMER", Elem::Dint, "PRE ACC Status"),
    (
        "FBD_COUNTER",
        Elem::Bool,
        "EnableIn CUEnable CDEnable Reset EnableOut CU CD DN OV UN InstructFault PresetInv",
    ),
    ("FBD_COUNTER", Elem::Dint, "PRE ACC Status"),
    ("FBD_ONESHOT", Elem::Bool, "EnableIn InputBit EnableOut OutputBit"),
    ("SCALE", Elem::Real, "In InRawMax InRawMin InEUMax InEUMin Out"),
    (
        "SCALE",
        Elem::Bool,
        "EnableIn Limiting EnableOut MaxAlarm MinAlarm InstructFault InRawRangeInv",
    ),
    ("SCALE", Elem::Dint, "Status"),
    (
        "MOTION_INSTRUCTION",
        Elem::Bool,
        "EN DN ER PC IP AC ACCEL DECEL TrackingMaster CalculatedDataAvailable",
    ),
    ("MOTION_INSTRUCTION", Elem::Dint, "FLAGS SEGMENT"),
    ("MOTION_INSTRUCTION", Elem::Int, "ERR"),
    ("MOTION_INSTRUCTION", Elem::Sint, "STATUS STATE EXERR"),
];

/// What numbers of an axis are reals end with.
const OF_AXIS: [&str; 9] = [
    "Position",
    "Velocity",
    "Acceleration",
    "Deceleration",
    "Jerk",
    "Torque",
    "Current",
    "Voltage",
    "Error",
];

/// Whether every controller has a type of that name.
pub(crate) fn is_built_in(name: &str) -> bool {
    KNOWN.iter().any(|(own, ..)| name.eq_ignore_ascii_case(own)) || is_axis(name)
}

/// Whether the tags of a type have parameters there, and no values.
pub(crate) fn has_parameters(name: &str) -> bool {
    name.eq_ignore_ascii_case("MESSAGE") || is_axis(name)
}

fn is_axis(name: &str) -> bool {
    let begin = name.get(..5);
    begin.is_some_and(|begin| begin.eq_ignore_ascii_case("AXIS_"))
}

/// The type that the manuals tell.
fn told(ty: &str, member: &str) -> Option<Elem> {
    let mut rows = KNOWN.iter().filter(|(own, ..)| ty.eq_ignore_ascii_case(own));
    let row = rows.find(|(.., members)| members.split(' ').any(|own| own.eq_ignore_ascii_case(member)));
    row.map(|(_, elem, _)| *elem)
}

/// How a path is used.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Use {
    pub(crate) role: Role,
    /// It is beside a real.
    pub(crate) is_real: bool,
}

impl Use {
    /// The type of a member of an undeclared type, of which these steps lead on. None: it is not known. The second: it is
    /// not guessed.
    fn elem(self, ty: &str, member: &str, rest: &[Step]) -> Option<(Elem, bool)> {
        if let Some(elem) = told(ty, member) {
            return Some((elem, true));
        }
        Some(match (rest.last(), self.role) {
            (Some(Step::Bit(_) | Step::ComputedBit(_)), _) => (Elem::Dint, false),
            (_, Role::Bit) => (Elem::Bool, true),
            (_, Role::Text) => (Elem::String(82), false),
            (_, Role::Value | Role::Formula) if is_axis(ty) => {
                let is_real = OF_AXIS.iter().any(|end| member.ends_with(end));
                (if is_real { Elem::Real } else { Elem::Dint }, is_real)
            }
            (_, Role::Value | Role::Formula) if self.is_real => (Elem::Real, false),
            (_, Role::Value | Role::Formula) => (Elem::Dint, false),
            _ => return None,
        })
    }
}

impl Types {
    /// The type of a name that the file does not declare.
    pub(crate) fn open(&mut self, name: &str, dimensions: &[u32]) -> Option<Ty> {
        if name.trim().is_empty() || name.contains('[') {
            return None;
        }
        if self.named(name, &[]).is_none() {
            let index = self.add(name);
            let structure = &mut self.all[index];
            structure.is_open = true;
            if structure.name != name || !is_built_in(name) {
                let told = "the file does not declare it; these members are used";
                structure.comment = Some(format!("{name}: {told}"));
            }
        }
        self.named(name, dimensions)
    }

    /// Whether a type, or what its elements are, is not declared.
    pub(crate) fn is_open(&self, ty: &Ty) -> bool {
        match ty {
            Ty::Structure(index) => self.all[*index].is_open,
            Ty::Array(of, _) => self.is_open(of),
            Ty::Elem(_) | Ty::Aoi(_) => false,
        }
    }

    /// Whether types of its members were guessed.
    pub(crate) fn is_guessed(&self, ty: &Ty) -> bool {
        match ty {
            Ty::Structure(index) => {
                let own = &self.all[*index];
                own.is_guessed
                    || own
                        .members
                        .iter()
                        .any(|field| self.is_open(&field.ty) && self.is_guessed(&field.ty))
            }
            Ty::Array(of, _) => self.is_guessed(of),
            Ty::Elem(_) | Ty::Aoi(_) => false,
        }
    }

    /// Whether a type of the file is not declared.
    pub(crate) fn has_open(&self) -> bool {
        self.all.iter().any(|structure| structure.is_open)
    }

    /// Adds the member of an undeclared type to which a path leads, or makes the array that it is larger.
    fn use_member(&mut self, structure: usize, member: &str, rest: &[Step], by: Use) {
        if let Some((number, field)) = self.member(structure, member) {
            if let (Ty::Array(_, sizes), Some(Step::Index(all))) = (&field.ty, rest.first())
                && let Some(larger) = sizes_for(all, sizes)
                && let Ty::Array(_, sizes) = &mut self.all[structure].members[number].ty
            {
                *sizes = larger;
            }
            return;
        }
        let of = self.all[structure].original.clone();
        let (sizes, rest) = match rest.split_first() {
            Some((Step::Index(all), rest)) => match sizes_for(all, &vec![1; all.len()]) {
                Some(sizes) => (sizes, rest),
                None => return,
            },
            _ => (Vec::new(), rest),
        };
        let ty = match rest.first() {
            Some(Step::Member(_)) => self.open(&format!("{of}_{member}"), &[]),
            Some(Step::Index(_)) => None,
            _ => match by.role {
                Role::Timer => self.named("TIMER", &[]),
                Role::Counter => self.named("COUNTER", &[]),
                Role::Control => self.named("CONTROL", &[]),
                _ => by.elem(&of, member, rest).map(|(elem, is_told)| {
                    self.all[structure].is_guessed |= !is_told;
                    Ty::Elem(elem)
                }),
            },
        };
        let Some(ty) = ty else { return };
        self.keep(&ty);
        let mut names = Names::default();
        for field in &self.all[structure].members {
            names.fresh(&field.name);
        }
        let ty = if sizes.is_empty() {
            ty
        } else {
            Ty::Array(Box::new(ty), sizes)
        };
        self.all[structure].members.push(Field {
            name: names.fresh(member),
            original: member.to_owned(),
            ty,
            comment: None,
        });
    }
}

/// The sizes of an array that has an element with these indices. None: an index is computed, or too large.
fn sizes_for(indices: &[Expr], sizes: &[u32]) -> Option<Vec<u32>> {
    /// No member is larger.
    const LARGEST: i64 = 100_000;
    if indices.len() != sizes.len() {
        return None;
    }
    let larger = indices.iter().zip(sizes).map(|(index, size)| match index {
        Expr::Int(index) if (0..LARGEST).contains(index) => Some((*size).max(*index as u32 + 1)),
        _ => None,
    });
    larger.collect()
}

impl Tags {
    /// Whether a path leads to a real.
    pub(crate) fn is_real(&mut self, scope: usize, path: &Path) -> bool {
        let Some((mut ty, steps)) = self.declared_type(scope, path) else {
            return false;
        };
        for step in &steps {
            let next = match (step, ty) {
                (Step::Member(name), Ty::Structure(index)) => {
                    self.types.member(index, name).map(|(_, field)| field.ty.clone())
                }
                (Step::Member(name), Ty::Aoi(aoi)) => self.parameter_type(aoi, name),
                (Step::Index(_), Ty::Array(ty, _)) => Some(*ty),
                _ => None,
            };
            let Some(next) = next else { return false };
            ty = next;
        }
        matches!(ty, Ty::Elem(elem) if elem.is_real())
    }

    /// Adds what a path leads to, where it is a member of a type that the file does not declare.
    pub(crate) fn use_path(&mut self, scope: usize, path: &Path, by: Use) {
        for step in &path.steps {
            match step {
                Step::Index(all) => all.iter().for_each(|index| self.use_paths(scope, index, by)),
                Step::ComputedBit(index) => self.use_paths(scope, index, by),
                Step::Member(_) | Step::Bit(_) => {}
            }
        }
        if path.steps.is_empty() || !self.types.has_open() {
            return;
        }
        let Some((mut ty, steps)) = self.declared_type(scope, path) else {
            return;
        };
        for (number, step) in steps.iter().enumerate() {
            ty = match (step, ty) {
                (Step::Member(name), Ty::Structure(index)) => {
                    if self.types.all[index].is_open {
                        self.types.use_member(index, name, &steps[number + 1..], by);
                    }
                    match self.types.member(index, name) {
                        Some((_, field)) => field.ty.clone(),
                        None => return,
                    }
                }
                (Step::Member(name), Ty::Aoi(aoi)) => match self.parameter_type(aoi, name) {
                    Some(ty) => ty,
                    None => return,
                },
                (Step::Index(_), Ty::Array(ty, _)) => *ty,
                _ => return,
            };
        }
    }

    /// The same for all paths of an operand.
    pub(crate) fn use_paths(&mut self, scope: usize, expr: &Expr, by: Use) {
        let inner = Use {
            role: Role::Value,
            ..by
        };
        match expr {
            Expr::Path(path) => self.use_path(scope, path, by),
            _ => expr.parts().for_each(|part| self.use_paths(scope, part, inner)),
        }
    }
}
