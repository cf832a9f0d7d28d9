//! What a copy between numbers and characters does, as it is read and written: `convert=to_text(..)`.

/// What turns into what.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Convert {
    /// A digit into its number.
    Value,
    /// A character into its code.
    Ascii,
    /// A code into its character.
    Binary,
    /// A number into characters, one address for each.
    Text {
        /// Without zeros in front.
        suppress_zero: bool,
        /// Reals with an exponent.
        exponential: bool,
        /// The code of a character after the last one.
        termination: Option<u8>,
    },
}

impl Convert {
    /// A number as characters when nothing else is reported.
    pub(super) const TEXT: Convert = Convert::Text {
        suppress_zero: true,
        exponential: false,
        termination: None,
    };

    /// By its name, `to_value`.
    pub(super) fn named(name: &str) -> Option<Convert> {
        Some(match name {
            "to_value" => Convert::Value,
            "to_ascii" => Convert::Ascii,
            "to_binary" => Convert::Binary,
            "to_text" => Convert::TEXT,
            _ => return None,
        })
    }

    pub(super) const fn name(self) -> &'static str {
        match self {
            Convert::Value => "to_value",
            Convert::Ascii => "to_ascii",
            Convert::Binary => "to_binary",
            Convert::Text { .. } => "to_text",
        }
    }

    /// Sets an option of [`Convert::Text`] by its name.
    ///
    /// # Errors
    ///
    /// What it takes instead.
    pub(super) fn set(&mut self, option: &str, value: &str) -> Result<(), String> {
        let Convert::Text {
            suppress_zero,
            exponential,
            termination,
        } = self
        else {
            return Err(format!("`{}` has no options", self.name()));
        };
        let switch = || match value {
            "1" | "True" => Ok(true),
            "0" | "False" => Ok(false),
            other => Err(format!("`{option}` is on or off, not `{other}`")),
        };
        match option {
            "suppress_zero" => *suppress_zero = switch()?,
            "exponential" => *exponential = switch()?,
            "termination_code" if matches!(value, "none" | "None") => *termination = None,
            "termination_code" => {
                let code = code(value).ok_or_else(|| {
                    format!("`{value}` is not the code of a character: `$0D` and `none` are")
                })?;
                *termination = Some(code);
            }
            _ => return Err(format!("`to_text` has no option `{option}`")),
        }
        Ok(())
    }

    /// As the grid writes it.
    pub(super) fn grid(self) -> String {
        match self {
            Convert::Text {
                suppress_zero,
                exponential,
                termination,
            } => format!(
                "to_text(suppress_zero={},exponential={},termination_code={})",
                u8::from(suppress_zero),
                u8::from(exponential),
                termination.map_or("none".to_owned(), |code| format!("${code:02X}"))
            ),
            other => other.name().to_owned(),
        }
    }

    /// As Python writes it: without what goes without saying.
    pub(super) fn dsl(self) -> String {
        let Convert::Text {
            suppress_zero,
            exponential,
            termination,
        } = self
        else {
            return self.name().to_owned();
        };
        let mut options = Vec::new();
        if !suppress_zero {
            options.push("suppress_zero=False".to_owned());
        }
        if exponential {
            options.push("exponential=True".to_owned());
        }
        if let Some(code) = termination {
            options.push(format!("termination_code=\"${code:02X}\""));
        }
        format!("to_text({})", options.join(", "))
    }
}

/// `$0D`, `13`, or a character in itself. None: it is not a character of ASCII.
fn code(value: &str) -> Option<u8> {
    let code = match (
        value.strip_prefix('$').filter(|hex| !hex.is_empty()),
        value.as_bytes(),
    ) {
        (Some(hex), _) => u8::from_str_radix(hex, 16).ok()?,
        (None, [one]) if !one.is_ascii_digit() => *one,
        _ => value.parse().ok()?,
    };
    code.is_ascii().then_some(code)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_of_characters_are_read() {
        for (text, expected) in [
            ("$0D", Some(13)),
            ("13", Some(13)),
            (";", Some(b';')),
            ("$", Some(b'$')),
            ("$80", None),
            ("200", None),
            ("", None),
            ("ab", None),
        ] {
            assert_eq!(code(text), expected, "{text}");
        }
    }
}
