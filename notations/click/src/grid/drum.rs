//! Drums: `event_drum(outputs=[Y001],events=[X001],pattern=[[1]],..)`, with their pins below.

use super::super::drum::patterns;
use super::super::model::{Drum, Instruction, Steps, Unit};
use super::addresses::Addresses;
use super::contact;
use super::operand::{operand, operand_text, tag};
use super::token::{Token, parts};
use ladder_notation::LineColumn;

/// A drum of this token, whose steps events or times end.
pub(super) fn read(token: &mut Token<'_>, is_timed: bool) -> Result<Instruction, String> {
    let outputs = list(token.must("outputs")?)?.into_iter().map(tag);
    let outputs = outputs.collect::<Result<Vec<_>, _>>()?;
    let steps = if is_timed {
        let presets = list(token.must("presets")?)?.into_iter().map(operand);
        let unit = token.take("unit").unwrap_or("Tms");
        Steps::Times {
            presets: presets.collect::<Result<_, _>>()?,
            unit: Unit::named(unit)
                .ok_or_else(|| format!("`{unit}` is not a unit: Tms, Ts, Tm, Th and Td are"))?,
            accumulator: tag(token.must("accumulator")?)?,
        }
    } else {
        let events = list(token.must("events")?)?.into_iter();
        let read = |text| contact::read(text, LineColumn::START).map(|read| read.condition);
        Steps::Events(events.map(read).collect::<Result<_, _>>()?)
    };
    let rows = list(token.must("pattern")?)?.into_iter();
    let rows: Vec<Vec<bool>> = rows.map(row).collect::<Result<_, _>>()?;
    Ok(Instruction::Drum(Box::new(Drum {
        pattern: patterns(&rows, outputs.len())?,
        steps,
        outputs,
        current_step: tag(token.must("current_step")?)?,
        completion_flag: tag(token.must("completion_flag")?)?,
        reset: None,
        jump: None,
        jump_step: None,
        jog: None,
    })))
}

fn list(text: &str) -> Result<Vec<&str>, String> {
    let inside = text.strip_prefix('[').and_then(|text| text.strip_suffix(']'));
    inside
        .and_then(parts)
        .map(|parts| parts.into_iter().map(str::trim).collect())
        .ok_or_else(|| format!("`{text}` is not a list: `[Y001,Y002]` is"))
}

fn row(text: &str) -> Result<Vec<bool>, String> {
    let values = list(text)?.into_iter().map(|value| match value {
        "0" => Ok(false),
        "1" => Ok(true),
        other => Err(format!("`{other}` is not 0 or 1")),
    });
    values.collect()
}

/// The name of a drum's output, and what is given by name. None: the grid cannot say it.
pub(super) fn write(drum: &Drum, addresses: &Addresses) -> Option<(&'static str, Vec<(String, String)>)> {
    fn bracketed(parts: impl Iterator<Item = Option<String>>) -> Option<String> {
        Some(format!("[{}]", parts.collect::<Option<Vec<_>>>()?.join(",")))
    }
    let row = |pattern: &u16| {
        let bits = (0..drum.outputs.len()).map(|at| Some((pattern >> at & 1).to_string()));
        bracketed(bits)
    };
    let outputs = bracketed(drum.outputs.iter().map(|output| addresses.text(output)))?;
    let mut named = vec![("outputs", outputs)];
    let name = match &drum.steps {
        Steps::Events(events) => {
            let events = events.iter().map(|event| contact::write(event, addresses));
            named.push(("events", bracketed(events)?));
            "event_drum"
        }
        Steps::Times { presets, unit, .. } => {
            let presets = presets.iter().map(|preset| operand_text(preset, addresses));
            named.push(("presets", bracketed(presets)?));
            named.push(("unit", unit.name().to_owned()));
            "time_drum"
        }
    };
    named.push(("pattern", bracketed(drum.pattern.iter().map(row))?));
    named.push(("current_step", addresses.text(&drum.current_step)?));
    if let Steps::Times { accumulator, .. } = &drum.steps {
        named.push(("accumulator", addresses.text(accumulator)?));
    }
    named.push(("completion_flag", addresses.text(&drum.completion_flag)?));
    let named = named.into_iter().map(|(name, value)| (name.to_owned(), value));
    Some((name, named.collect()))
}
