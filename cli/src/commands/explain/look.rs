//! How the parts of a page look.

use crate::terminal::{stdout_has_colours, width};
use anstyle::{AnsiColor, Style};

/// Lines that are wider are hard to read, even where there is room.
const WIDEST: usize = 100;

/// Styles, without effect where no colours are shown, and how wide lines may be.
pub(super) struct Look {
    pub(super) heading: Style,
    pub(super) code: Style,
    pub(super) columns: usize,
}

impl Look {
    pub(super) fn of_stdout() -> Look {
        let (heading, code) = if stdout_has_colours() {
            (Style::new().bold(), AnsiColor::Cyan.on_default())
        } else {
            (Style::new(), Style::new())
        };
        Look {
            heading,
            code,
            columns: width().min(WIDEST),
        }
    }
}
