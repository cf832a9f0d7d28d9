//! How the parts of a page look.

use crate::terminal::stdout_has_colours;
use anstyle::{AnsiColor, Style};

/// Styles; without effect where no colours are shown.
pub(super) struct Look {
    pub(super) heading: Style,
    pub(super) code: Style,
}

impl Look {
    pub(super) fn of_stdout() -> Look {
        if !stdout_has_colours() {
            return Look {
                heading: Style::new(),
                code: Style::new(),
            };
        }
        Look {
            heading: Style::new().bold(),
            code: AnsiColor::Cyan.on_default(),
        }
    }
}
