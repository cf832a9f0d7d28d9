//! Rows of the table of declarations come, change and go.

use super::change::{Done, Work};
use super::declaring::laid_out;
use super::fragment::Fragment;
use super::piece::Piece;
use crate::declarations::{Row, comment_of};
use crate::refactor::declared::{DeclaredTag, at, parts, replaced, uses};
use ladder_analysis::names::declaring::{Places, header_of};
use ladder_format::Edit;
use ladder_syntax::{LineKind, Name, TextRange, is_identifier, parse};

impl Work<'_> {
    /// Declares a tag in the file or in the body of a block.
    pub(super) fn declare(&self, block: Option<&str>, row: &Row) -> Done {
        let scope = match block {
            None => 0,
            Some(block) => self.scope_of(block)?,
        };
        let declaration = declaration(row)?;
        if self.context.scopes[scope]
            .find(&Name::new(&row.name))
            .is_some_and(|tag| self.context.scopes[scope].tags[tag].is_declared())
        {
            return Err(format!("`{}` is declared already: choose another name", row.name));
        }
        let edits = self.declared(scope, &row.section, declaration)?;
        Ok(self.done(scope, edits, format!("{} declared", row.name)))
    }

    /// Another declaration of a tag, by the place of its name; none takes it away.
    pub(super) fn redeclare(&self, what: TextRange, row: Option<&Row>) -> Done {
        let tag = at(self.context, what).ok_or("nothing is declared there")?;
        let Some(row) = row else {
            let count = uses(self.context, &tag).len();
            if count > 0 {
                let places = if count == 1 {
                    "one place".to_owned()
                } else {
                    format!("{count} places")
                };
                return Err(format!(
                    "`{}` is used in {places}: take it out there first",
                    tag.name
                ));
            }
            let edits = replaced(self.context, std::slice::from_ref(&tag), &[])?;
            return Ok(self.done(tag.scope, edits, format!("{} deleted", tag.name)));
        };
        if row.name != tag.name {
            return Err(format!("rename `{}`, so that its uses keep it", tag.name));
        }
        let mut new = declaration(row)?;
        let section = &self.context.parse.frame().sections[tag.section];
        let stays = header_of(&self.context.parse, section).as_ref() == Some(&row.section);
        if let Some(comments) = self.comments_of(&tag, &row.comment) {
            new = declaration(&Row {
                comment: String::new(),
                ..row.clone()
            })? + &comments;
        }
        let edits = if stays {
            replaced(self.context, std::slice::from_ref(&tag), &[new])?
        } else {
            let mut edits = replaced(self.context, std::slice::from_ref(&tag), &[])?;
            edits.extend(self.declared(tag.scope, &row.section, new)?);
            edits
        };
        Ok(self.done(tag.scope, edits, format!("{} changed", tag.name)))
    }

    fn scope_of(&self, block: &str) -> Result<usize, String> {
        let key = Name::new(block);
        let mut blocks = self.context.user_blocks.iter();
        let found = blocks.position(|known| Name::new(&known.name) == key);
        found
            .map(|index| index + 1)
            .ok_or_else(|| format!("`{block}` is not defined in this file"))
    }

    fn declared(&self, scope: usize, section: &str, declaration: String) -> Result<Vec<Edit>, String> {
        let places = Places::new(self.context, scope);
        let edits = places.put(&[(section.to_owned(), declaration)]);
        edits.ok_or_else(|| "a section of declarations is not closed: put that right first".to_owned())
    }

    /// The comments of a declaration as they are, if they still say what the row does: their form is the writer's.
    fn comments_of(&self, tag: &DeclaredTag<'_>, wanted: &str) -> Option<String> {
        let stays = !wanted.is_empty() && comment_of(self.context, tag.line) == wanted;
        let parts = parts(self.context, tag.line).filter(|_| stays)?;
        let from = parts.says.find(';')? + 1;
        Some(parts.says[from..].to_owned())
    }

    fn done(&self, scope: usize, edits: Vec<Edit>, said: String) -> (Vec<Piece>, String, Option<Fragment>) {
        (laid_out(self.context, scope, edits, self.options), said, None)
    }
}

/// A row as text, which is a declaration of one tag and nothing else.
///
/// # Errors
/// What of it is not.
fn declaration(row: &Row) -> Result<String, String> {
    if row.comment.contains('#') {
        return Err("a comment cannot hold a `#`: write it without".to_owned());
    }
    let mut text = row.name.clone();
    for (word, part) in [(" AT ", &row.address), (" : ", &row.ty), (" := ", &row.initial)] {
        if !part.is_empty() || word == " : " {
            text.push_str(word);
            text.push_str(part);
        }
    }
    text.push(';');
    let read = parse(&format!("{}\n{text}\nEND_VAR\n", row.section));
    let is_one = matches!(
        read.lines().iter().map(|line| line.kind).collect::<Vec<_>>()[..],
        [
            LineKind::SectionHeader,
            LineKind::Declaration,
            LineKind::SectionEnd
        ]
    );
    if !is_identifier(&row.name) {
        return Err(format!(
            "`{}` is not a name: letters, digits and `_`, a letter first",
            row.name
        ));
    }
    if !is_one || text.contains('#') || !read.errors().is_empty() {
        return Err(format!(
            "`{text}` cannot be read: check the address, the type and the initial value"
        ));
    }
    if !row.comment.is_empty() {
        let words: Vec<&str> = row.comment.split_whitespace().collect();
        text.push_str(&format!("  # {} #", words.join(" ")));
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use crate::declarations::Row;
    use crate::redraw::{Change, change};
    use expect_test::{Expect, expect};
    use ladder_format::{Options, apply};
    use ladder_syntax::{TextRange, TextSize};
    use std::sync::Arc;

    /// A row as it is typed: section, name, address, type, initial value, comment.
    fn row(cells: [&str; 6]) -> Row {
        let [section, name, address, ty, initial, comment] = cells.map(str::to_owned);
        Row {
            section,
            name,
            address,
            ty,
            initial,
            comment,
        }
    }

    fn done(text: &str, wanted: &Change) -> String {
        let context = ladder_analysis::context(&Arc::new(ladder_syntax::parse(text)), "plant.clad");
        match change(&context, wanted, &Options::default()) {
            Ok(done) => format!("{}-- {}\n", apply(text, &done.edits), done.said),
            Err(why) => format!("refused: {why}\n"),
        }
    }

    fn declared(text: &str, block: Option<&str>, cells: [&str; 6], expected: Expect) {
        let block = block.map(str::to_owned);
        expected.assert_eq(&done(
            text,
            &Change::Declare {
                block,
                row: row(cells),
            },
        ));
    }

    fn redeclared(text: &str, name: &str, cells: Option<[&str; 6]>, expected: Expect) {
        let at = text.find(name).expect("the name") as u32;
        let what = TextRange::at(TextSize::new(at), TextSize::of(name));
        let row = cells.map(row);
        expected.assert_eq(&done(text, &Change::Redeclare { what, row }));
    }

    const PLANT: &str = "\
# The pump. #
VAR_INPUT
    start, stop : BOOL;  # buttons #
    level       : INT;   # of the tank #
END_VAR

VAR
    idle : BOOL;
END_VAR

+--[ ]( start )--[/]( stop )--[GT]( level, 5 )-----------------------( )( run )--+
";

    #[test]
    fn a_row_goes_into_its_section_or_a_new_one() {
        declared(
            PLANT,
            None,
            ["VAR_INPUT", "high", "%IW3", "INT", "-5", "too high"],
            expect![[r#"
                # The pump. #
                VAR_INPUT
                    start, stop         : BOOL;  # buttons #
                    level               : INT;  # of the tank #
                    high        AT %IW3 : INT := -5;  # too high #
                END_VAR

                VAR
                    idle : BOOL;
                END_VAR

                +--[ ]( start )--[/]( stop )--[GT]( level, 5 )-----------------------( )( run )--+
                -- high declared
            "#]],
        );
        declared(
            PLANT,
            None,
            ["VAR RETAIN", "total", "", "DINT", "", ""],
            expect![[r#"
                # The pump. #
                VAR_INPUT
                    start, stop : BOOL;  # buttons #
                    level       : INT;   # of the tank #
                END_VAR

                VAR
                    idle : BOOL;
                END_VAR
                VAR RETAIN
                    total : DINT;
                END_VAR

                +--[ ]( start )--[/]( stop )--[GT]( level, 5 )-----------------------( )( run )--+
                -- total declared
            "#]],
        );
        declared(
            "",
            None,
            ["VAR_OUTPUT", "run", "", "BOOL", "", ""],
            expect![[r#"
            VAR_OUTPUT
                run : BOOL;
            END_VAR

            -- run declared
        "#]],
        );
        let block = "+--[ ]( a )--+\n\nFUNCTION_BLOCK [$Motor]\nVAR_INPUT\n    go : BOOL;\nEND_VAR\n+--[ ]( go )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n";
        declared(
            block,
            Some("$Motor"),
            ["VAR_OUTPUT", "run", "", "BOOL", "", ""],
            expect![[r#"
                +--[ ]( a )--+

                FUNCTION_BLOCK [$Motor]
                VAR_INPUT
                    go : BOOL;
                END_VAR
                VAR_OUTPUT
                    run : BOOL;
                END_VAR
                +--[ ]( go )--( )( ENO )--+
                END_FUNCTION_BLOCK
                -- run declared
            "#]],
        );
    }

    #[test]
    fn a_cell_changes_and_the_rest_is_kept() {
        redeclared(
            PLANT,
            "level",
            Some(["VAR_INPUT", "level", "%IW3", "INT", "", "of the tank"]),
            expect![[r#"
                # The pump. #
                VAR_INPUT
                    start, stop         : BOOL;  # buttons #
                    level       AT %IW3 : INT;  # of the tank #
                END_VAR

                VAR
                    idle : BOOL;
                END_VAR

                +--[ ]( start )--[/]( stop )--[GT]( level, 5 )-----------------------( )( run )--+
                -- level changed
            "#]],
        );
        redeclared(
            PLANT,
            "stop",
            Some(["VAR_INPUT", "stop", "", "BOOL", "TRUE", "buttons"]),
            expect![[r#"
                # The pump. #
                VAR_INPUT
                    start : BOOL;  # buttons #
                    stop  : BOOL := TRUE;  # buttons #
                    level : INT;  # of the tank #
                END_VAR

                VAR
                    idle : BOOL;
                END_VAR

                +--[ ]( start )--[/]( stop )--[GT]( level, 5 )-----------------------( )( run )--+
                -- stop changed
            "#]],
        );
        redeclared(
            PLANT,
            "start",
            Some(["VAR_OUTPUT", "start", "", "BOOL", "", ""]),
            expect![[r#"
                # The pump. #
                VAR_INPUT
                    stop  : BOOL;  # buttons #
                    level : INT;  # of the tank #
                END_VAR

                VAR
                    idle : BOOL;
                END_VAR
                VAR_OUTPUT
                    start : BOOL;
                END_VAR

                +--[ ]( start )--[/]( stop )--[GT]( level, 5 )-----------------------( )( run )--+
                -- start changed
            "#]],
        );
        redeclared(
            PLANT,
            "idle",
            Some(["VAR RETAIN", "idle", "", "BOOL", "", ""]),
            expect![[r#"
                # The pump. #
                VAR_INPUT
                    start, stop : BOOL;  # buttons #
                    level       : INT;   # of the tank #
                END_VAR

                VAR RETAIN
                    idle : BOOL;
                END_VAR

                +--[ ]( start )--[/]( stop )--[GT]( level, 5 )-----------------------( )( run )--+
                -- idle changed
            "#]],
        );
    }

    #[test]
    fn a_row_goes_if_nothing_uses_its_tag() {
        redeclared(
            PLANT,
            "idle",
            None,
            expect![[r#"
                # The pump. #
                VAR_INPUT
                    start, stop : BOOL;  # buttons #
                    level       : INT;   # of the tank #
                END_VAR

                +--[ ]( start )--[/]( stop )--[GT]( level, 5 )-----------------------( )( run )--+
                -- idle deleted
            "#]],
        );
        redeclared(
            PLANT,
            "stop",
            None,
            expect![[r#"
                refused: `stop` is used in one place: take it out there first
            "#]],
        );
    }

    #[test]
    fn what_cannot_be_read_is_refused() {
        declared(
            PLANT,
            None,
            ["VAR", "level", "", "INT", "", ""],
            expect![[r#"
            refused: `level` is declared already: choose another name
        "#]],
        );
        declared(
            PLANT,
            None,
            ["VAR", "1st", "", "INT", "", ""],
            expect![[r#"
            refused: `1st` is not a name: letters, digits and `_`, a letter first
        "#]],
        );
        declared(
            PLANT,
            None,
            ["VAR", "a", "", "INT; b : INT", "", ""],
            expect![[r#"
                refused: `a : INT; b : INT;` cannot be read: check the address, the type and the initial value
            "#]],
        );
        declared(
            PLANT,
            None,
            ["VAR", "a", "", "", "", ""],
            expect![[r#"
            refused: `a : ;` cannot be read: check the address, the type and the initial value
        "#]],
        );
        declared(
            PLANT,
            None,
            ["VAR", "a", "", "INT", "", "no # more"],
            expect![[r#"
                refused: a comment cannot hold a `#`: write it without
            "#]],
        );
        redeclared(
            PLANT,
            "stop",
            Some(["VAR_INPUT", "halt", "", "BOOL", "", ""]),
            expect![[r#"
                refused: rename `stop`, so that its uses keep it
            "#]],
        );
        redeclared(
            PLANT,
            "The",
            None,
            expect![[r#"
            refused: nothing is declared there
        "#]],
        );
    }
}
