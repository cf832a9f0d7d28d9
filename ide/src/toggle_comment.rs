//! Lines become comments, and comments lines again. A comment cannot hold a `#`, so an editor's own command would break a
//! rung with a duration in it: `T#5s` becomes `5s`, which means the same; a line with another `#` is refused.

use std::ops::Range;

use ladder_format::Edit;
use ladder_syntax::{TextRange, TextSize};

/// The edits that turn the lines in a stretch of a text into comments, each one of its own; where all of them are comments,
/// or blank, those that turn them back. The stretch begins and ends with whole lines.
///
/// # Errors
/// Where a line begins that holds another `#`, which would end the comment.
pub fn toggle_comment(text: &str, stretch: Range<usize>) -> Result<Vec<Edit>, usize> {
    let stretch = stretch.start.min(text.len())..stretch.end.min(text.len());
    let lines = lines_in(text, stretch);
    let stays = |line: &Range<usize>| {
        let line = text[line.clone()].trim();
        line.is_empty() || is_comment(line)
    };
    let mut edits = Vec::new();
    if lines.iter().all(stays) {
        for line in lines
            .iter()
            .filter(|line| !text[(*line).clone()].trim().is_empty())
        {
            uncomment(text, line.clone(), &mut edits);
        }
        return Ok(edits);
    }
    for line in lines.iter().filter(|line| !stays(line)) {
        comment(text, line.clone(), &mut edits).ok_or(line.start)?;
    }
    Ok(edits)
}

/// The lines of a stretch, without their ends.
fn lines_in(text: &str, stretch: Range<usize>) -> Vec<Range<usize>> {
    let mut lines = Vec::new();
    let mut start = stretch.start;
    for (at, _) in text[stretch.clone()].match_indices(['\n', '\r']) {
        let end = stretch.start + at;
        // Between the two bytes of an end there is no line.
        let is_within_end = end == start && text[..end].ends_with('\r') && text[end..].starts_with('\n');
        if !is_within_end {
            lines.push(start..end);
        }
        start = end + 1;
    }
    lines.push(start..stretch.end);
    lines
}

/// Whether a line, without white space around it, is one comment.
fn is_comment(line: &str) -> bool {
    let within = line.strip_prefix('#').and_then(|rest| rest.strip_suffix('#'));
    within.is_some_and(|within| !within.contains('#'))
}

fn uncomment(text: &str, line: Range<usize>, edits: &mut Vec<Edit>) {
    let indent = line.start + leading_blanks(&text[line.clone()]);
    let closing = line.start + text[line.clone()].trim_end().len() - 1;
    let within = &text[indent + 1..closing];
    let blank = |c: Option<char>| c.filter(|c| c.is_whitespace()).map_or(0, char::len_utf8);
    let before = blank(within.chars().next());
    let after = blank(within[before..].chars().next_back());
    edits.push(edit(indent..indent + 1 + before, ""));
    edits.push(edit(closing - after..line.end, ""));
}

/// None where a `#` is in the way.
fn comment(text: &str, line: Range<usize>, edits: &mut Vec<Edit>) -> Option<()> {
    let indent = line.start + leading_blanks(&text[line.clone()]);
    let end = line.start + text[line.clone()].trim_end().len();
    edits.push(edit(indent..indent, "# "));
    let mut at = indent;
    while let Some(c) = text[at..end].chars().next() {
        let rest = &text[at..end];
        let word_goes_on = text[indent..at].chars().next_back().is_some_and(is_of_word);
        if let Some(string) = string_at(rest) {
            if string.contains('#') {
                return None;
            }
            at += string.len();
        } else if let Some(prefix) = duration_prefix(rest).filter(|_| !word_goes_on) {
            edits.push(edit(at..at + prefix, ""));
            at += prefix;
        } else if c == '#' {
            return None;
        } else {
            at += c.len_utf8();
        }
    }
    edits.push(edit(end..line.end, " #"));
    Some(())
}

fn leading_blanks(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

fn is_of_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The string that begins here, with its quotes. A `$'` does not end it.
fn string_at(text: &str) -> Option<&str> {
    let within = text.strip_prefix('\'')?;
    let mut escaped = false;
    for (at, c) in within.char_indices() {
        match c {
            _ if escaped => escaped = false,
            '$' => escaped = true,
            '\'' => return Some(&text[..at + 2]),
            _ => {}
        }
    }
    None
}

/// The length of the `T#` that a duration begins with.
fn duration_prefix(text: &str) -> Option<usize> {
    let (word, number) = text.split_once('#')?;
    let is_time = word.eq_ignore_ascii_case("T") || word.eq_ignore_ascii_case("TIME");
    let digits = number.strip_prefix('-').unwrap_or(number);
    (is_time && digits.starts_with(|c: char| c.is_ascii_digit())).then_some(word.len() + 1)
}

fn edit(range: Range<usize>, text: &str) -> Edit {
    // A text is at most 24 MiB.
    let size = |at: usize| TextSize::try_from(at).unwrap_or_default();
    Edit {
        range: TextRange::new(size(range.start), size(range.end)),
        text: text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::toggle_comment;

    fn toggled(text: &str) -> Result<String, usize> {
        toggle_comment(text, 0..text.len()).map(|edits| ladder_format::apply(text, &edits))
    }

    #[test]
    fn lines_become_comments_and_come_back() {
        for (before, after, again) in [
            (
                "+--[ ]( a )--( )( b )--+",
                "# +--[ ]( a )--( )( b )--+ #",
                "+--[ ]( a )--( )( b )--+",
            ),
            // A comment cannot hold a `#`: a duration loses its prefix.
            (
                "+--[TON]( t, T#5s )--[TON]( u, time#-1h30m )--( )( b )--+",
                "# +--[TON]( t, 5s )--[TON]( u, -1h30m )--( )( b )--+ #",
                "+--[TON]( t, 5s )--[TON]( u, -1h30m )--( )( b )--+",
            ),
            // Blank lines and comments stay as they are.
            (
                "+--\\--( )( a )--+\n\n# known #\n   /--( )( b )  ",
                "# +--\\--( )( a )--+ #\n\n# known #\n   # /--( )( b ) #",
                "+--\\--( )( a )--+\n\nknown\n   /--( )( b )",
            ),
            (
                "+--( )( a )--+\r\n\r\n+--( )( b )--+\r\n",
                "# +--( )( a )--+ #\r\n\r\n# +--( )( b )--+ #\r\n",
                "+--( )( a )--+\r\n\r\n+--( )( b )--+\r\n",
            ),
            (
                "+--[MOV]( s, 'a $' b' )--[TON]( t, T#5s )--+",
                "# +--[MOV]( s, 'a $' b' )--[TON]( t, 5s )--+ #",
                "+--[MOV]( s, 'a $' b' )--[TON]( t, 5s )--+",
            ),
            ("Größe: ( )( ä )", "# Größe: ( )( ä ) #", "Größe: ( )( ä )"),
        ] {
            assert_eq!(toggled(before).as_deref(), Ok(after), "{before}");
            assert_eq!(toggled(after).as_deref(), Ok(again), "{after}");
        }
    }

    #[test]
    fn comments_of_any_spacing_become_lines() {
        for (comment, line) in [("#a#", "a"), ("##", ""), ("# #", ""), ("  #  a  #  ", "   a ")] {
            assert_eq!(toggled(comment).as_deref(), Ok(line), "{comment}");
        }
        assert_eq!(toggled(""), Ok(String::new()));
    }

    #[test]
    fn another_hash_is_refused() {
        for (text, line) in [
            ("+--( )( a )--+\n+--[GT]( x, 16#FF )--( )( a )--+", 15),
            // A comment inside a rung, and a text that is only like a duration.
            ("+--[ ]( a )--# why #--( )( b )--+", 0),
            ("+--[MOV]( s, 'T#5s' )--+", 0),
            ("+--[MOV]( s, AT#5s )--+", 0),
            ("+--[MOV]( s, T#x )--+", 0),
            // A comment of several lines.
            ("# a\nb #", 0),
        ] {
            assert_eq!(toggled(text), Err(line), "{text}");
        }
    }

    #[test]
    fn only_the_lines_of_the_stretch_change() {
        let text = "a\nb\nc\n";
        let edits = toggle_comment(text, 2..3).unwrap();
        assert_eq!(ladder_format::apply(text, &edits), "a\n# b #\nc\n");
    }
}
