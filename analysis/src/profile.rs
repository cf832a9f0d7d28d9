//! The profile that a file selects for itself: `# ladder: profile ldmicro #` before its first network (LANGUAGE §5.8).

use ladder_instructions::Profile;
use ladder_syntax::{Item, NodeOrToken, Parse};

/// The name that a comment selects, if it selects a profile.
pub(crate) fn selected(comment: &str) -> Option<&str> {
    let words = comment.trim_matches('#').trim().strip_prefix("ladder:")?;
    let name = words.trim_start().strip_prefix("profile")?;
    name.starts_with([' ', '\t']).then(|| name.trim())
}

/// The profile of a file: what the first such comment before its first network selects, else `iec`.
pub(crate) fn profile(parse: &Parse) -> Profile {
    let before = parse
        .structure()
        .items
        .iter()
        .take_while(|item| !matches!(item, Item::Network(_)));
    for item in before {
        let Item::Decoration(line) = *item else { continue };
        for child in parse.lines()[line].green().children() {
            let NodeOrToken::Token(token) = child else {
                continue;
            };
            if let Some(profile) = selected(token.text()).and_then(Profile::from_name) {
                return profile;
            }
        }
    }
    Profile::Iec
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
}
