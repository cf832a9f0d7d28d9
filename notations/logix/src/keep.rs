//! An export in which only what was changed in its ladder text is written again.

use crate::mnemonic::{instruction, operands_in_ascii};
use crate::names::Originals;
use crate::renamed::with_new_names;
use crate::{in_outs, l5x, model, repeated, text, write};
use ladder_drawings::neutral::{self, Part};
use ladder_notation::kept::{Rules, merge, merge_lists};
use ladder_notation::{Kept, LineColumn, Project, WriteError, WrittenProject, without_known};
use roxmltree::Node;
use std::collections::HashMap;

/// How elements of an export are known again.
const RULES: Rules = Rules {
    key,
    says,
    is_whole,
    text: text_of_rung,
    number: "Number",
    together: &["Radix", "Value"],
    repeats,
    used_by,
};

/// Writes the files of a folder into the export that they come from.
pub(crate) fn write(project: &Project, kept: &Kept<'_>) -> Result<WrittenProject, WriteError> {
    let broken = |error: ladder_notation::ReadError| WriteError::new(error.to_string());
    let original = text(kept.source).map_err(broken)?;
    let mut read = l5x::read(original).map_err(broken)?;
    repeated::refuse_repeated(&mut read);
    in_outs::size_in_outs(&mut read);
    let names = Originals::of(&read, original);
    let before = write::write_again(kept.before, &names, kept.before)?;
    let mut after = write::write_again(project, &names, kept.before)?;
    let [old, new] = [&before, &after].map(|writing| String::from_utf8_lossy(&writing.bytes).into_owned());
    let renamed = with_new_names(original, &old, &new);
    let [own, old] = match &renamed {
        Some(renamed) => renamed.each_ref().map(String::as_str),
        None => [original, &old],
    };
    let merged = merge(own, old, &new, &RULES).map_err(broken)?;
    without_known(
        &mut after.report,
        &project.analysis,
        &before.report,
        &kept.before.analysis,
    );
    for (routine, was) in drawn(
        &l5x::read(original).map_err(broken)?,
        &l5x::read(&merged).map_err(broken)?,
    ) {
        let why = format!("{was}, of which something is changed: it is ladder logic there now");
        after
            .report
            .approximated(LineColumn::START, format!("routine {routine}"), why);
    }
    Ok(WrittenProject {
        bytes: merged.into_bytes(),
        reports: project.reports(&after.report),
    })
}

/// The routines that were in another language, each with what it was.
fn drawn(was: &model::Project, is: &model::Project) -> Vec<(String, &'static str)> {
    let routines = |project: &model::Project| -> Vec<(String, Option<&'static str>)> {
        let all = project
            .programs
            .iter()
            .map(|program| (&program.name, &program.routines));
        let all = all.chain(project.aois.iter().map(|aoi| (&aoi.name, &aoi.routines)));
        let all = all.flat_map(|(owner, routines)| {
            routines.iter().map(move |routine| {
                let language = routine.foreign.as_ref().map(|foreign| foreign.language.is());
                (format!("{} of {owner}", routine.name), language)
            })
        });
        all.collect()
    };
    let now: HashMap<String, Option<&str>> = routines(is).into_iter().collect();
    let was = routines(was).into_iter();
    was.filter_map(|(name, language)| {
        let is_drawn = now.get(&name) == Some(&None);
        language.filter(|_| is_drawn).map(|language| (name, language))
    })
    .collect()
}

fn key(node: Node<'_, '_>) -> Option<String> {
    let attribute = match node.tag_name().name() {
        "Element" => "Index",
        "Data" | "DefaultData" => "Format",
        "Controller" => return None,
        _ => "Name",
    };
    node.attribute(attribute).map(str::to_owned)
}

/// What a rung or a line of structured text says.
fn says(node: Node<'_, '_>) -> Option<String> {
    let text = match node.tag_name().name() {
        "Rung" => node.children().find(|child| child.has_tag_name("Text")),
        "Line" => Some(node),
        _ => return None,
    };
    let words = text
        .into_iter()
        .flat_map(|text| text.children())
        .filter_map(|part| part.text());
    let words: String = words.collect();
    if node.has_tag_name("Line") {
        return Some(words.trim().to_owned());
    }
    Some(pieces(&words).into_iter().map(said).collect())
}

/// The text of a rung with other instructions: those that are not changed stay as they are spelled.
fn text_of_rung(node: Node<'_, '_>, own: &str, written: &str, now: &str) -> Option<String> {
    if !node.has_tag_name("Text") {
        return Some(now.to_owned());
    }
    let [own, old, new] = [own, written, now].map(pieces);
    let branches = |pieces: &[&str]| -> Vec<String> {
        let signs = pieces.iter().map(|piece| said(piece));
        signs
            .filter(|said| ["[", ",", "]"].contains(&said.as_str()))
            .collect()
    };
    if branches(&own) != branches(&old) {
        return Some(now.to_owned());
    }
    let merged = merge_lists(&own, &old, &new, said).concat();
    neutral::parse(&merged, &operands_in_ascii).ok()?;
    Some(merged.trim().to_owned())
}

/// The instructions and signs of a rung, each with the blanks after it.
fn pieces(text: &str) -> Vec<&str> {
    let mut pieces = Vec::new();
    let (mut start, mut depth, mut is_text, mut ends) = (0, 0u32, false, false);
    for (at, c) in text.char_indices() {
        if ends && !c.is_whitespace() {
            pieces.push(&text[start..at]);
            start = at;
            ends = false;
        }
        match c {
            '\'' => is_text = !is_text,
            _ if is_text => {}
            '(' => depth += 1,
            ')' => {
                depth = depth.saturating_sub(1);
                ends |= depth == 0;
            }
            '[' | ',' | ']' | ';' => ends |= depth == 0,
            _ => {}
        }
    }
    pieces.push(&text[start..]);
    pieces.retain(|piece| !piece.is_empty());
    pieces
}

/// What an instruction says, whichever of its names it has. What a timer or counter begins with is said by its tag.
fn said(piece: &str) -> String {
    let bare: String = piece.chars().filter(|c| !c.is_whitespace()).collect();
    let rung = format!("{bare};");
    let Ok(parts) = neutral::parse(&rung, &operands_in_ascii) else {
        return bare;
    };
    let [Part::Instruction(it)] = &parts[..] else {
        return bare;
    };
    let op = instruction(it.name, it.operands.len());
    let name = op.map_or_else(|| it.name.to_ascii_uppercase(), |op| format!("{op:?}"));
    let given = match (&it.operands[..], it.name.to_ascii_uppercase().as_str()) {
        ([state, _, _], "TON" | "TOF" | "RTO" | "CTU" | "CTD") => &[*state][..],
        (all, _) => all,
    };
    format!("{name}({})", given.join(",").to_ascii_uppercase())
}

/// A diagram, or a routine that was in another language.
fn is_whole(own: Node<'_, '_>, written: Node<'_, '_>) -> bool {
    match own.tag_name().name() {
        "Routine" => own.attribute("Type") != written.attribute("Type"),
        "FBDContent" | "SFCContent" | "EncodedData" => true,
        _ => false,
    }
}

/// The value of a tag is there in several forms.
fn repeats(of: Node<'_, '_>, changed: Node<'_, '_>) -> bool {
    let name = changed.tag_name().name();
    matches!(name, "Data" | "DefaultData")
        && of.has_tag_name(name)
        && of.attribute("Format") != changed.attribute("Format")
}

/// Types, Add-On Instructions and tags are used by their names.
fn used_by(node: Node<'_, '_>) -> Option<String> {
    match node.tag_name().name() {
        "DataType" | "AddOnInstructionDefinition" | "Tag" => node.attribute("Name").map(str::to_owned),
        _ => None,
    }
}
