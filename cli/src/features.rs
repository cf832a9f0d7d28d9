//! Parts that a build can leave out, and what a command says that would need one.

use crate::outcome::Failure;

/// A cargo feature of this package.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(dead_code, reason = "each is named only by a build without it")]
pub(crate) enum Feature {
    Server,
    Screen,
    Run,
    Mcp,
    Png,
    Pdf,
    Pages,
}

/// The arguments of a command that is left out: whatever is given.
#[cfg(not(all(feature = "mcp", feature = "pages", feature = "run")))]
#[derive(Debug, clap::Args)]
pub(crate) struct LeftOut {
    #[arg(hide = true, trailing_var_arg = true, allow_hyphen_values = true)]
    _given: Vec<std::ffi::OsString>,
}

impl Feature {
    /// What to say where this part would be needed.
    pub(crate) fn left_out(self) -> Failure {
        let (part, name) = match self {
            Feature::Server => ("the language server", "server"),
            Feature::Screen => ("the interactive screen", "screen"),
            Feature::Run => ("programs in real time", "run"),
            Feature::Mcp => ("the server for assistants", "mcp"),
            Feature::Png => ("PNG pictures", "png"),
            Feature::Pdf => ("PDF pictures", "pdf"),
            Feature::Pages => ("completions and manual pages", "pages"),
        };
        Failure::new(format!(
            "this `ladder` was built without {part}; build it with `--features {name}`, or install it whole with \
             `cargo install --path cli`"
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::Feature;
    use expect_test::expect;

    #[test]
    fn what_was_left_out_and_how_to_get_it() {
        let messages = [
            Feature::Server,
            Feature::Screen,
            Feature::Run,
            Feature::Mcp,
            Feature::Png,
            Feature::Pdf,
            Feature::Pages,
        ]
        .map(|feature| feature.left_out().to_string());
        expect![[r#"
            this `ladder` was built without the language server; build it with `--features server`, or install it whole with `cargo install --path cli`
            this `ladder` was built without the interactive screen; build it with `--features screen`, or install it whole with `cargo install --path cli`
            this `ladder` was built without programs in real time; build it with `--features run`, or install it whole with `cargo install --path cli`
            this `ladder` was built without the server for assistants; build it with `--features mcp`, or install it whole with `cargo install --path cli`
            this `ladder` was built without PNG pictures; build it with `--features png`, or install it whole with `cargo install --path cli`
            this `ladder` was built without PDF pictures; build it with `--features pdf`, or install it whole with `cargo install --path cli`
            this `ladder` was built without completions and manual pages; build it with `--features pages`, or install it whole with `cargo install --path cli`"#]].assert_eq(&messages.join("\n"));
    }
}
