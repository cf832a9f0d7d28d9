//! Operands as accesses: a variable, a constant, an address, a label.

use crate::model::{Role, Unit};
use crate::operand::{Step, indices_of, split};
use ladder_notation::xml::XmlText;

/// What is read or written. `id`: none within another access. `ty` is the type of a constant.
///
/// # Errors
///
/// If it has no form there.
pub(super) fn access(
    xml: &mut XmlText,
    (operand, ty): (&str, &str),
    id: Option<&str>,
    unit: &Unit,
) -> Result<(), String> {
    let scope = match operand.chars().next() {
        Some('#') if constant(unit, operand).is_some() => "LocalConstant",
        Some('#') => "LocalVariable",
        Some('"') if ty == LABEL => "Label",
        Some('"') => "GlobalVariable",
        Some('%') => "Address",
        _ if is_typed(operand) => "TypedConstant",
        _ => "LiteralConstant",
    };
    let mut attributes = vec![("Scope", scope)];
    attributes.extend(id.map(|id| ("UId", id)));
    let mut done = Ok(());
    xml.around("Access", &attributes, |xml| match scope {
        "LocalConstant" => {
            let name = constant(unit, operand).unwrap_or_default();
            xml.empty("Constant", &[("Name", name)]);
        }
        "LocalVariable" | "GlobalVariable" => {
            xml.around("Symbol", &[], |xml| done = components(xml, operand, unit));
        }
        "Label" => xml.empty("Label", &[("Name", operand.trim_matches('"'))]),
        "Address" => done = address(xml, operand),
        _ => xml.around("Constant", &[], |xml| {
            if scope == "LiteralConstant" {
                xml.words("ConstantType", &[], ty);
            }
            xml.words("ConstantValue", &[], operand);
        }),
    });
    done
}

/// In the place of the type of a constant: it is the name of a label.
pub(super) const LABEL: &str = "Label";

/// The constant of a block that an operand is.
fn constant<'u>(unit: &'u Unit, operand: &str) -> Option<&'u str> {
    let name = operand.strip_prefix("#\"")?.strip_suffix('"')?;
    let mut constants = unit.variables.iter().filter(|own| own.role == Role::Constant);
    let found = constants.find(|own| own.name.eq_ignore_ascii_case(name))?;
    Some(&found.name)
}

/// Whether a constant says its own type: `T#5s`, and not `16#FF`.
fn is_typed(operand: &str) -> bool {
    operand.contains('#') && operand.starts_with(|c: char| c.is_ascii_alphabetic())
}

/// The components of a path, with their indices.
///
/// # Errors
///
/// If it is not one.
pub(super) fn components(xml: &mut XmlText, path: &str, unit: &Unit) -> Result<(), String> {
    let none = || format!("`{path}` has no form there");
    let (root, steps) = split(path.trim_start_matches('#')).ok_or_else(none)?;
    let mut all: Vec<(String, Option<String>, Option<u32>)> = vec![(root, None, None)];
    for step in steps {
        match (step, all.last_mut()) {
            (Step::Member(name), _) => all.push((name, None, None)),
            (Step::Index(text), Some((_, indices @ None, None))) => *indices = Some(text),
            (Step::Bit(number), Some((.., bit @ None))) => *bit = Some(number),
            _ => return Err(none()),
        }
    }
    for (name, indices, bit) in &all {
        let mut attributes = vec![("Name", name.as_str())];
        let slice = bit.map(|bit| format!("x{bit}"));
        attributes.extend(slice.as_deref().map(|slice| ("SliceAccessModifier", slice)));
        attributes.extend(indices.as_ref().map(|_| ("AccessModifier", "Array")));
        let mut done = Ok(());
        xml.around("Component", &attributes, |xml| {
            let mut indices = indices.iter().flat_map(|text| indices_of(text));
            done = indices.try_for_each(|index| access(xml, (index, "DInt"), None, unit));
        });
        done?;
    }
    Ok(())
}

/// `%IW4`
fn address(xml: &mut XmlText, operand: &str) -> Result<(), String> {
    let none = || format!("the address `{operand}` has no form there");
    let mut rest = operand[1..].chars();
    let area = match rest.next() {
        Some('I') => "Input",
        Some('Q') => "Output",
        Some('M') => "Memory",
        _ => return Err(none()),
    };
    let number = rest
        .as_str()
        .trim_start_matches(|c: char| c.is_ascii_alphabetic());
    let ty = match rest.next() {
        Some('B') => "Byte",
        Some('W') => "Word",
        Some('D') => "DWord",
        Some('0'..='9') => "Bool",
        _ => return Err(none()),
    };
    let (byte, bit) = number.split_once('.').unwrap_or((number, "0"));
    let (byte, bit): (u32, u32) = match (byte.parse(), bit.parse()) {
        (Ok(byte), Ok(bit)) => (byte, bit),
        _ => return Err(none()),
    };
    let offset = byte
        .checked_mul(8)
        .and_then(|bits| bits.checked_add(bit))
        .ok_or_else(none)?;
    let offset = offset.to_string();
    xml.empty("Address", &[("Area", area), ("Type", ty), ("BitOffset", &offset)]);
    Ok(())
}
