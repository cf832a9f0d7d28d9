//! The outputs of column AF: `name(first,second,key=value)`, and pins `.name(..)`.

/// How deep brackets nest in one output.
const MOST_DEPTH: usize = 32;

/// An output as it is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Token<'t> {
    /// With its dot, if it is a pin.
    pub(super) name: &'t str,
    /// What is given by its place.
    pub(super) values: Vec<&'t str>,
    /// What is given by name.
    pub(super) named: Vec<(&'t str, &'t str)>,
}

impl<'t> Token<'t> {
    /// A name alone.
    pub(super) const fn named(name: &'t str) -> Token<'t> {
        Token {
            name,
            values: Vec::new(),
            named: Vec::new(),
        }
    }

    /// What an output says.
    ///
    /// # Errors
    ///
    /// Why it says nothing.
    pub(super) fn read(text: &'t str) -> Result<Token<'t>, String> {
        let shape = || {
            let shown: String = text.chars().take(40).collect();
            format!("`{shown}` is not an output: it has the form `name(value,name=value)`")
        };
        let (name, rest) = text.split_once('(').ok_or_else(shape)?;
        let inside = rest.strip_suffix(')').ok_or_else(shape)?;
        let bare = name.strip_prefix('.').unwrap_or(name);
        if bare.is_empty()
            || !bare
                .bytes()
                .all(|byte| byte.is_ascii_alphanumeric() || byte == b'_')
        {
            return Err(shape());
        }
        let mut token = Token::named(name);
        for part in parts(inside).ok_or_else(shape)? {
            match name_of(part) {
                Some(pair) => token.named.push(pair),
                None => token.values.push(part.trim()),
            }
        }
        Ok(token)
    }

    /// What is given by name, once.
    pub(super) fn take(&mut self, name: &str) -> Option<&'t str> {
        let at = self.named.iter().position(|(own, _)| *own == name)?;
        Some(self.named.remove(at).1)
    }

    /// What must be given by name.
    pub(super) fn must(&mut self, name: &str) -> Result<&'t str, String> {
        let given = self.take(name);
        given.ok_or_else(|| format!("`{}` has no `{name}`", self.name))
    }

    /// A switch: 1 or 0, off if it is not given.
    pub(super) fn switch(&mut self, name: &str) -> Result<bool, String> {
        match self.take(name) {
            None | Some("0") => Ok(false),
            Some("1") => Ok(true),
            Some(other) => Err(format!("`{name}` is 0 or 1, not `{other}`")),
        }
    }
}

/// `name=value`, but not a comparison.
fn name_of(part: &str) -> Option<(&str, &str)> {
    let (name, value) = part.split_once('=')?;
    let is_name = !name.trim().is_empty()
        && name
            .trim()
            .bytes()
            .all(|byte| byte.is_ascii_lowercase() || byte == b'_');
    (is_name && !value.starts_with('=')).then(|| (name.trim(), value.trim()))
}

/// What is between commas outside of brackets and quotes. None: they do not match.
pub(super) fn parts(text: &str) -> Option<Vec<&str>> {
    if text.trim().is_empty() {
        return Some(Vec::new());
    }
    let mut open = Vec::new();
    let mut quoted = false;
    let mut start = 0;
    let mut parts = Vec::new();
    for (at, c) in text.char_indices() {
        match c {
            '"' => quoted = !quoted,
            _ if quoted => {}
            '(' | '[' if open.len() == MOST_DEPTH => return None,
            '(' => open.push(')'),
            '[' => open.push(']'),
            ')' | ']' if open.pop() != Some(c) => return None,
            ',' if open.is_empty() => {
                parts.push(&text[start..at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(&text[start..]);
    (open.is_empty() && !quoted).then_some(parts)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outputs_are_taken_apart() {
        let token = Token::read("search(\">=\",DS3,TXT1..TXT8,calc(a,b),[1,[2,3]],continuous=1)").unwrap();
        assert_eq!(token.name, "search");
        assert_eq!(
            token.values,
            ["\">=\"", "DS3", "TXT1..TXT8", "calc(a,b)", "[1,[2,3]]"]
        );
        assert_eq!(token.named, [("continuous", "1")]);
        assert_eq!(Token::read(".reset()").unwrap().values, [""; 0]);
        assert_eq!(
            Token::read("call(\"a,\"\"b\"\")\")").unwrap().values,
            ["\"a,\"\"b\"\")\""]
        );
        for text in [
            "",
            "out",
            "out(",
            "out(]",
            "out((])",
            "(Y1)",
            "o ut(Y1)",
            "out(\"Y1)",
            "out(Y1))",
        ] {
            assert!(Token::read(text).is_err(), "{text}");
        }
        assert!(Token::read(&format!("f({}{})", "(".repeat(99), ")".repeat(99))).is_err());
    }
}
