//! What a file says of itself before its first network: its profile, `# ladder: profile ldmicro #` (LANGUAGE §5.8), and
//! the time from one scan to the next that it is made for, `# ladder: cycle 5ms #`.

use crate::asked::asked;
use crate::values::literal::{Literal, literal};
use ladder_instructions::Profile;
use ladder_syntax::{LineKind, NodeOrToken, Parse};

/// The profile of a file: what the first such comment before its first network selects, else `iec`.
pub(crate) fn profile(parse: &Parse) -> Profile {
    told(parse, "profile", Profile::from_name).unwrap_or_default()
}

/// The time from one scan to the next that a file is made for, in nanoseconds, where it says so.
pub(crate) fn cycle(parse: &Parse) -> Option<i64> {
    told(parse, "cycle", cycle_time)
}

/// A time that scans can follow each other in: more than nothing, and a day at most.
pub(crate) fn cycle_time(text: &str) -> Option<i64> {
    const DAY: i64 = 86_400_000_000_000;
    match literal(&format!("T#{text}")) {
        Ok(Literal::Time(nanoseconds)) if (1..=DAY).contains(&nanoseconds) => Some(nanoseconds),
        _ => None,
    }
}

/// The first answer to a word that a comment before the first network gives.
fn told<T>(parse: &Parse, word: &str, answer: impl Fn(&str) -> Option<T>) -> Option<T> {
    let lines = parse.lines();
    let end = lines.first_network().unwrap_or(lines.len());
    let mut sections = parse.frame().sections.iter().map(|section| section.lines.clone());
    let mut next = 0;
    while next < end {
        let section = sections.next().unwrap_or(end..end);
        let outside = next..section.start.min(end);
        next = section.end;
        for line in lines.range(outside) {
            if !matches!(line.kind, LineKind::Comment | LineKind::Rail) || !line.text().contains('#') {
                continue;
            }
            for child in line.tree().children() {
                let NodeOrToken::Token(token) = child else {
                    continue;
                };
                let asked = asked(token.text()).filter(|asked| asked.word == word);
                if let Some(found) = asked.and_then(|asked| answer(asked.after)) {
                    return Some(found);
                }
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_comment_before_the_first_network() {
        for (text, expected) in [
            ("", Profile::Iec),
            ("# ladder: profile iot #\n+--( )( y )--+\n", Profile::Iot),
            (
                "# ladder:profile ldmicro #  # ladder: profile iot #\n",
                Profile::Ldmicro,
            ),
            (
                "\nVAR a : BOOL; END_VAR\n|\n# ladder: profile click #\n",
                Profile::Click,
            ),
            ("# ladder: profiles iot #\n", Profile::Iec),
            ("# ladder: profile none #\n", Profile::Iec),
            ("+--( )( y )--+\n# ladder: profile iot #\n", Profile::Iec),
        ] {
            assert_eq!(profile(&ladder_syntax::parse(text)), expected, "{text}");
        }
    }

    #[test]
    fn the_cycle() {
        for (text, expected) in [
            ("", None),
            ("# ladder: cycle 5ms #\n+--( )( y )--+\n", Some(5_000_000)),
            ("# ladder: cycle 1s500ms #\n", Some(1_500_000_000)),
            ("# ladder: cycle 0ms #\n# ladder: cycle x #\n", None),
            ("+--( )( y )--+\n# ladder: cycle 5ms #\n", None),
        ] {
            assert_eq!(cycle(&ladder_syntax::parse(text)), expected, "{text}");
        }
    }
}
