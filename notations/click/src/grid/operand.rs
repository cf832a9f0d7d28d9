//! Values as the grid writes them: `DS1`, `DS[DS1+99]`, `-5`, `00FFh`, `"AB"`.

use super::super::address::{Address, Span, Tag};
use super::super::bank::Bank;
use super::super::model::{Constant, Operand, Pointer};
use super::addresses::Addresses;
use super::contact::exists;

/// A value or a place.
///
/// # Errors
///
/// Why it is none.
pub(super) fn operand(text: &str) -> Result<Operand, String> {
    let text = text.trim();
    if let Some(pointer) = pointer(text)? {
        return Ok(Operand::Pointer(pointer));
    }
    match Address::parse(text) {
        Some(address) => Ok(Operand::Tag(exists(address)?)),
        None => constant(text).map(Operand::Constant).ok_or_else(|| unknown(text)),
    }
}

fn unknown(text: &str) -> String {
    let shown: String = text.chars().take(40).collect();
    format!("`{shown}` is neither an address nor a value")
}

/// `DS[DS1+99]`
fn pointer(text: &str) -> Result<Option<Pointer>, String> {
    let Some((bank, inside)) = text.strip_suffix(']').and_then(|text| text.split_once('[')) else {
        return Ok(None);
    };
    let Some(bank) = Bank::named(bank) else {
        return Ok(None);
    };
    let at = inside.find(['+', '-']).unwrap_or(inside.len());
    let (by, offset) = inside.split_at(at);
    let offset = match offset.replace(' ', "").as_str() {
        "" => 0,
        offset => offset.parse().map_err(|_| unknown(text))?,
    };
    let by = exists(Address::parse(by.trim()).ok_or_else(|| unknown(text))?)?;
    Ok(Some(Pointer { bank, by, offset }))
}

/// A constant.
pub(super) fn constant(text: &str) -> Option<Constant> {
    if let Some(quoted) = text.strip_prefix('"') {
        return Some(Constant::Text(quoted.strip_suffix('"')?.replace("\"\"", "\"")));
    }
    if let Some(code) = text.strip_prefix('$') {
        let code = u8::from_str_radix(code, 16).ok().filter(u8::is_ascii)?;
        return Some(Constant::Text(char::from(code).to_string()));
    }
    if let Some(bit) = text.strip_suffix('b').filter(|bit| matches!(*bit, "0" | "1")) {
        return Some(Constant::Bit(bit == "1"));
    }
    let hex = text.strip_suffix(['h', 'H']).or_else(|| text.strip_prefix("0x"));
    if let Some(hex) = hex {
        let is_number = hex.len() <= 8 && hex.bytes().all(|byte| byte.is_ascii_hexdigit());
        return u32::from_str_radix(hex, 16)
            .ok()
            .filter(|_| is_number)
            .map(Constant::Hex);
    }
    let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
    if !digits.starts_with(|c: char| c.is_ascii_digit()) {
        return None;
    }
    if digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return text.parse().ok().map(Constant::Int);
    }
    let number: Option<f64> = text.parse().ok();
    number.filter(|number| number.is_finite()).map(Constant::Float)
}

/// A range, or one address as a range of itself.
pub(super) fn span(text: &str) -> Result<Span, String> {
    let one = || {
        let Address { bank, number } = Address::parse(text)?;
        Some(Span {
            bank,
            first: number,
            last: number,
        })
    };
    let span = Span::parse(text).or_else(one).ok_or_else(|| {
        let shown: String = text.chars().take(40).collect();
        format!("`{shown}` is not a range of addresses: `DS1..DS4` is")
    })?;
    if !span.exists() {
        return Err(format!(
            "there is no {span}: {} has {}",
            span.bank.row().name,
            span.bank.extent()
        ));
    }
    Ok(span)
}

/// One address.
pub(super) fn tag(text: &str) -> Result<Tag, String> {
    match operand(text)? {
        Operand::Tag(tag) => Ok(tag),
        _ => Err(format!("`{text}` is not an address")),
    }
}

/// As the grid writes it. None: an address has only a nickname.
pub(super) fn operand_text(operand: &Operand, addresses: &Addresses) -> Option<String> {
    Some(match operand {
        Operand::Constant(constant) => constant_text(constant),
        Operand::Tag(tag) => addresses.text(tag)?,
        Operand::Pointer(Pointer { bank, by, offset }) => {
            let by = addresses.text(by)?;
            match offset {
                0 => format!("{}[{by}]", bank.row().name),
                offset => format!("{}[{by}{offset:+}]", bank.row().name),
            }
        }
    })
}

/// As the grid writes it.
pub(super) fn constant_text(constant: &Constant) -> String {
    match constant {
        Constant::Bit(bit) => format!("{}b", u8::from(*bit)),
        Constant::Int(number) => number.to_string(),
        Constant::Hex(number) => format!("{number:04X}h"),
        Constant::Float(number) => format!("{number:?}"),
        Constant::Text(text) => format!("\"{}\"", text.replace('"', "\"\"")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_read_and_written() {
        for text in [
            "DS1",
            "X001",
            "DS[DS1]",
            "DS[DS1+99]",
            "DD[DS2-1]",
            "-5",
            "0",
            "00FFh",
            "12345678h",
            "1.5",
            "-0.25",
            "1e30",
            "\"A\"\"B\"",
            "1b",
        ] {
            assert_eq!(
                operand(text).map(|operand| operand_text(&operand, &Addresses::default())),
                Ok(Some(text.to_owned()))
            );
        }
        for (text, why) in [
            ("DS5000", "there is no DS5000: DS has 1 to 4500"),
            ("DS[5]", "`DS[5]` is neither an address nor a value"),
            ("", "`` is neither an address nor a value"),
            ("x", "`x` is neither an address nor a value"),
            ("1e999", "`1e999` is neither an address nor a value"),
            ("\"A", "`\"A` is neither an address nor a value"),
        ] {
            assert_eq!(operand(text), Err(why.to_owned()));
        }
        assert_eq!(
            operand("0x1F").map(|operand| operand_text(&operand, &Addresses::default())),
            Ok(Some("001Fh".to_owned()))
        );
        assert_eq!(
            operand("$41").map(|operand| operand_text(&operand, &Addresses::default())),
            Ok(Some("\"A\"".to_owned()))
        );
    }
}
