//! What is given next to a breakpoint: how often it must be met, and what it writes instead of stopping.

/// A condition on how often a breakpoint was met, the time that counts included.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum HitCondition {
    /// At that time alone.
    Is(u64),
    /// `> n`, and `>= n` as `> n - 1`.
    Above(u64),
    /// `< n`, and `<= n` as `< n + 1`.
    Below(u64),
    /// `% n`: every n-th time.
    Every(u64),
}

impl HitCondition {
    /// Reads `5`, `= 5`, `> 5`, `>= 5`, `< 5`, `<= 5`, `% 5`. A bare number stops from that time on only once, as
    /// editors have it.
    pub(crate) fn read(text: &str) -> Result<HitCondition, String> {
        let text = text.trim();
        let end = text.find(|c: char| c.is_ascii_digit()).unwrap_or(text.len());
        let (sign, number) = text.split_at(end);
        let wrong = || format!("`{text}` is not a count of hits: write a number such as 5, or >= 5, or % 5");
        let number: u64 = number.trim().parse().map_err(|_| wrong())?;
        match sign.trim() {
            "" | "=" | "==" => Ok(HitCondition::Is(number)),
            ">" => Ok(HitCondition::Above(number)),
            ">=" if number > 0 => Ok(HitCondition::Above(number - 1)),
            "<" => Ok(HitCondition::Below(number)),
            "<=" => Ok(HitCondition::Below(number.saturating_add(1))),
            "%" if number > 0 => Ok(HitCondition::Every(number)),
            _ => Err(wrong()),
        }
    }

    /// Whether the breakpoint counts when it is met the n-th time.
    pub(crate) fn holds(self, hits: u64) -> bool {
        match self {
            HitCondition::Is(number) => hits == number,
            HitCondition::Above(number) => hits > number,
            HitCondition::Below(number) => hits < number,
            HitCondition::Every(number) => hits.is_multiple_of(number),
        }
    }
}

/// The parts of a log message: text, and expressions in braces. `{{` and `}}` are braces.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Piece {
    Text(String),
    Expression(String),
}

/// Takes a log message apart.
pub(crate) fn pieces(message: &str) -> Result<Vec<Piece>, String> {
    let mut pieces = Vec::new();
    let mut text = String::new();
    let mut letters = message.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '{' if letters.next_if_eq(&'{').is_some() => text.push('{'),
            '}' => {
                letters.next_if_eq(&'}');
                text.push('}');
            }
            '{' => {
                let mut expression = String::new();
                loop {
                    match letters.next() {
                        Some('}') => break,
                        Some(letter) => expression.push(letter),
                        None => {
                            return Err(format!(
                                "`{message}`: a brace is not closed; `{{{{` is a brace itself"
                            ));
                        }
                    }
                }
                if !text.is_empty() {
                    pieces.push(Piece::Text(std::mem::take(&mut text)));
                }
                pieces.push(Piece::Expression(expression));
            }
            letter => text.push(letter),
        }
    }
    if !text.is_empty() {
        pieces.push(Piece::Text(text));
    }
    Ok(pieces)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_of_hits() {
        let met = |text: &str| {
            let condition = HitCondition::read(text)?;
            Ok::<Vec<u64>, String>((1..=6).filter(|&hits| condition.holds(hits)).collect())
        };
        assert_eq!(met("3"), Ok(vec![3]));
        assert_eq!(met(" == 3"), Ok(vec![3]));
        assert_eq!(met(">=5"), Ok(vec![5, 6]));
        assert_eq!(met("> 5"), Ok(vec![6]));
        assert_eq!(met("<= 2"), Ok(vec![1, 2]));
        assert_eq!(met("< 2"), Ok(vec![1]));
        assert_eq!(met("%2"), Ok(vec![2, 4, 6]));
        for wrong in [
            "",
            "many",
            "% 0",
            ">= 0",
            "-1",
            "5 times",
            "99999999999999999999999",
        ] {
            assert!(met(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn messages_with_expressions() {
        use Piece::{Expression, Text};
        let text = |text: &str| Text(text.into());
        assert_eq!(
            pieces("n is {n + 1}, {{n}}{t.Q}"),
            Ok(vec![
                text("n is "),
                Expression("n + 1".into()),
                text(", {n}"),
                Expression("t.Q".into())
            ])
        );
        assert_eq!(pieces(""), Ok(Vec::new()));
        assert_eq!(pieces("}"), Ok(vec![text("}")]));
        assert!(pieces("n is {n").is_err());
    }
}
