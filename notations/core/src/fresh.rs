//! Names for what a pass adds.

use ladder_analysis::context::Context;
use std::collections::HashSet;

/// Names that a program does not have: `part_1`, `part_2`, and so on. None is part of a longer name of it.
pub(crate) struct Fresh {
    /// `part_`
    like: &'static str,
    /// The numbers after it that the text has, and what these begin with.
    taken: HashSet<String>,
    number: usize,
}

impl Fresh {
    /// Those that begin so, in small letters.
    pub(crate) fn of(context: &Context, like: &'static str) -> Fresh {
        let text = context.parse.to_string().to_lowercase();
        let mut taken = HashSet::new();
        for (at, _) in text.match_indices(like) {
            let after = &text[at + like.len()..];
            let digits = after.bytes().take_while(u8::is_ascii_digit).count();
            taken.extend((1..=digits).map(|end| after[..end].to_owned()));
        }
        Fresh {
            like,
            taken,
            number: 0,
        }
    }

    pub(crate) fn next(&mut self) -> String {
        loop {
            self.number += 1;
            let number = self.number.to_string();
            if !self.taken.contains(&number) {
                return format!("{}{number}", self.like);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_name_is_part_of_one_that_is_there() {
        let text = "VAR part_12, my_PART_3x : BOOL; END_VAR\n";
        let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "test.clad");
        let mut names = Fresh::of(&analysis.context, "part_");
        assert_eq!(
            [names.next(), names.next(), names.next()],
            ["part_2", "part_4", "part_5"]
        );
    }
}
