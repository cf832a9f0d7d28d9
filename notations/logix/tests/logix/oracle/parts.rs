//! Neutral text as parts of rungs.

/// A part of a rung.
#[derive(Debug, Clone)]
pub(super) enum Part {
    It(String, Vec<String>),
    Branch(Vec<Vec<Part>>),
}

/// The parts of a rung.
pub(super) fn parse(text: &str) -> Vec<Part> {
    let (parts, rest) = series(text.trim());
    assert_eq!(rest.trim(), ";", "{text}");
    parts
}

fn series(mut text: &str) -> (Vec<Part>, &str) {
    let mut parts = Vec::new();
    loop {
        text = text.trim_start();
        if let Some(mut rest) = text.strip_prefix('[') {
            let mut legs = Vec::new();
            loop {
                let (leg, after) = series(rest);
                legs.push(leg);
                let after = after.trim_start();
                match after.strip_prefix(',') {
                    Some(next) => rest = next,
                    None => {
                        text = after.strip_prefix(']').expect("a branch ends");
                        break;
                    }
                }
            }
            parts.push(Part::Branch(legs));
        } else if text.starts_with(|c: char| c.is_alphabetic()) {
            let open = text.find('(').expect("operands");
            let mut depth = 0;
            let mut operands = vec![String::new()];
            let mut end = open;
            for (at, c) in text.char_indices().skip(open) {
                match c {
                    '(' | '[' => depth += 1,
                    ')' | ']' => depth -= 1,
                    _ => {}
                }
                if depth == 0 {
                    end = at;
                    break;
                }
                match c {
                    '(' if at == open => {}
                    ',' if depth == 1 => operands.push(String::new()),
                    c => operands.last_mut().expect("one").push(c),
                }
            }
            parts.push(Part::It(text[..open].to_owned(), operands));
            text = &text[end + 1..];
        } else {
            return (parts, text);
        }
    }
}
