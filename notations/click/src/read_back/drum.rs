//! Calls of the blocks that drums become.

use super::Back;
use super::value::Refusal;
use crate::drum::Shape;
use crate::model::{Constant, Drum, Instruction, Operand, Steps, Unit};
use ladder_analysis::program::{Block, BlockKind, Bound};

impl Back<'_> {
    /// A call of a user-defined block as the drum that it was.
    pub(super) fn drum(&self, block: &Block) -> Result<Instruction, Refusal> {
        let unknown = || "Click has no blocks of one's own".to_owned();
        let BlockKind::User(number) = block.kind else {
            return Err(unknown());
        };
        let definition = self.program.blocks.get(number).ok_or_else(unknown)?;
        let shape = Shape::named(&definition.name).ok_or_else(unknown)?;
        let given = |name: &str| -> Option<&Bound> {
            block.arguments.iter().find(|bound| {
                let parameter = bound
                    .parameter
                    .and_then(|number| definition.parameters.get(number));
                parameter.is_some_and(|(tag, _)| self.program.tags[tag.0 as usize].name == name)
            })
        };
        let must = |name: &str| given(name).ok_or_else(|| format!("the drum has no `{name}`"));
        let pin = |name: &str| given(name).map(|bound| self.pin(bound)).transpose();
        let each = |letter: char, count: usize| (1..=count).map(move |number| format!("{letter}{number}"));
        let steps = if shape.is_timed {
            let presets = each('t', shape.steps).map(|name| self.operand(must(&name)?));
            let unit = super::pins::time(must("unit")?).and_then(Unit::lasting);
            Steps::Times {
                presets: presets.collect::<Result<_, _>>()?,
                unit: unit.ok_or("the unit of a drum is a millisecond, second, minute, hour or day")?,
                accumulator: self.tag(must("acc")?)?,
            }
        } else {
            let events = each('e', shape.steps).map(|name| self.pin(must(&name)?));
            Steps::Events(events.collect::<Result<_, _>>()?)
        };
        let pattern = each('p', shape.steps).map(|name| match self.operand(must(&name)?)? {
            Operand::Constant(Constant::Int(bits)) => u16::try_from(bits).map_err(|_| unknown()),
            Operand::Constant(Constant::Hex(bits)) => u16::try_from(bits).map_err(|_| unknown()),
            _ => Err("the pattern of a drum is fixed".to_owned()),
        });
        let outputs = each('q', shape.outputs).map(|name| self.tag(must(&name)?));
        Ok(Instruction::Drum(Box::new(Drum {
            steps,
            outputs: outputs.collect::<Result<_, _>>()?,
            pattern: pattern.collect::<Result<_, _>>()?,
            current_step: self.tag(must("step")?)?,
            completion_flag: self.tag(must("done")?)?,
            reset: pin("reset")?,
            jump: pin("jump")?,
            jump_step: given("jump_to").map(|step| self.operand(step)).transpose()?,
            jog: pin("jog")?,
        })))
    }
}
