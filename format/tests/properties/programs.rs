//! Texts that look like programs, made from a row of choices.

/// Choices from which a text is made; when they run out, every choice is the first.
pub(crate) struct Choices<'c> {
    bytes: std::slice::Iter<'c, u8>,
}

impl<'c> Choices<'c> {
    pub(crate) fn new(bytes: &'c [u8]) -> Self {
        Choices { bytes: bytes.iter() }
    }

    fn below(&mut self, n: usize) -> usize {
        self.bytes.next().map_or(0, |&b| usize::from(b) % n)
    }

    fn of(&mut self, texts: &[&str]) -> String {
        texts[self.below(texts.len())].to_owned()
    }

    fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == n - 1
    }
}

const BLOCKS: &[&str] = &[
    "[ ]( a )",
    "[/](b )",
    "( )( y )",
    "(S)(run)",
    "[ton]( t, T#5s )",
    "[TON](t,5s,r:=reset)",
    "<JMP>( l )",
    "<RET>",
    "[OSR]",
    "[osr]( )",
    "[GT](level,-5)",
    "[CALC]( y, a+b*-sqrt( c ) )",
    "[CALC](y,- (a) + not b)",
    "[SEARCH](k,eq,5,t[ 1 .. 9 ],NEXT:=m,found=>h)",
    "[NOT]",
    "[NOT](y,a)",
    "[$Block](in, value := sys.scan )",
    "[ ]( a[ 3 ] . Q )",
    "[MOV]( cell[ 2 ].zone[ k+1,3 ] . open,g[ 1,2 .. 3 ] )",
    "[ ]( %IX0.3 )",
    "[ ]( w # bit # .3 )",
    "[MOV]( s, 'it$'s' )",
    "[ ]( 温度 )",
    "[UNKNOWN]( a )",
    "[TON]( t, )",
    "( )",
    "(  )",
    "[ ] (en)",
    "<LBL>( x )",
];

const COMMENTS: &[&str] = &[
    "# c #",
    "##",
    "# 温 #",
    "# a\tb #",
    "#--#",
    "# ladder: fmt off #",
    "# two\nlines #",
];

/// A file: sections, networks, comments, block definitions, blank and rail lines.
pub(crate) fn file(c: &mut Choices<'_>) -> String {
    let end = c.of(&["\n", "\n", "\n", "\r\n", "\r"]);
    let mut text = String::new();
    if c.one_in(8) {
        text.push('\u{feff}');
    }
    let things = c.below(7);
    for _ in 0..=things {
        match c.below(16) {
            0..=7 => network(c, &mut text, &end),
            8 => section(c, &mut text, &end),
            9 => line(
                &mut text,
                &["# a comment #", "  # a comment #  # another #"],
                c,
                &end,
            ),
            10 => line(&mut text, &["", "  ", "\t"], c, &end),
            11 => line(&mut text, &["|", "|      |", "  |"], c, &end),
            12 => line(
                &mut text,
                &[
                    "# ladder: fmt off #",
                    "# ladder: fmt on #",
                    "|  # ladder: fmt off #  |",
                ],
                c,
                &end,
            ),
            13 => line(
                &mut text,
                &["FUNCTION_BLOCK [$Block]", "function_block  ( $Block )# c #"],
                c,
                &end,
            ),
            14 => line(
                &mut text,
                &["END_FUNCTION_BLOCK", "end_function_block # c #"],
                c,
                &end,
            ),
            _ => line(
                &mut text,
                &["stray", "|  # a comment #  |", "| # two\nlines # |", "END_VAR"],
                c,
                &end,
            ),
        }
    }
    if c.one_in(3) {
        text.truncate(text.trim_end_matches(['\n', '\r']).len());
    }
    text
}

fn line(text: &mut String, of: &[&str], c: &mut Choices<'_>, end: &str) {
    text.push_str(&c.of(of));
    text.push_str(end);
}

/// Rungs whose connectors pair up, in any order between the other elements.
fn network(c: &mut Choices<'_>, text: &mut String, end: &str) {
    let rungs = 1 + [0, 0, 1, 1, 2, 3][c.below(6)];
    let mut ups = 0;
    for rung in 0..rungs {
        let downs = if rung + 1 < rungs { 1 + c.below(3) } else { 0 };
        self::rung(c, text, ups, downs);
        text.push_str(end);
        if rung + 1 < rungs && c.one_in(4) {
            line(
                text,
                &["", "|", "|   |", "  # between #", "|  # between #  |", "\t"],
                c,
                end,
            );
        }
        ups = downs;
    }
}

fn rung(c: &mut Choices<'_>, text: &mut String, mut ups: usize, mut downs: usize) {
    text.push_str(&c.of(&["", "", "", "  ", "|", "| ", "# lead #", "|  # lead # "]));
    if !c.one_in(4) {
        text.push('+');
    }
    text.push_str(&gap(c));
    let mut blocks = c.below(4);
    while ups + downs + blocks > 0 {
        match c.below(ups + downs + blocks) {
            n if n < ups => {
                text.push('/');
                ups -= 1;
            }
            n if n < ups + downs => {
                text.push('\\');
                downs -= 1;
            }
            _ => {
                text.push_str(&c.of(BLOCKS));
                blocks -= 1;
            }
        }
        text.push_str(&gap(c));
        if c.one_in(12) {
            text.push_str(&c.of(COMMENTS));
            text.push_str(&gap(c));
        }
    }
    if !c.one_in(3) {
        text.push('+');
    }
    text.push_str(&c.of(&[
        "",
        "",
        "",
        "",
        "|",
        "  |",
        " # after #",
        "  # after #  # more #  ",
    ]));
}

fn gap(c: &mut Choices<'_>) -> String {
    c.of(&[
        "--", "--", "--", "-", "-----", "", "  ", "--  --", "--|--", "--|", "|--", " | ", "--+--", "\t",
        "  --  ",
    ])
}

fn section(c: &mut Choices<'_>, text: &mut String, end: &str) {
    text.push_str(&c.of(&["VAR", "var_input", "VAR retain", "VAR CONSTANT  # c #", "type"]));
    text.push_str(&c.of(&[end, " "]));
    for _ in 0..c.below(4) {
        text.push_str(&c.of(&[
            "a : BOOL;",
            "start,stop:bool;",
            "x AT %IW3 : INT := 5 ;",
            "list : array [ 1 .. 3 ] of int := [ 1,2( 0 ) ];",
            "s : string[ 80 ] := 'a  b';",
            "温度 : REAL := -1.0e-3;",
            "b : SomeType;",
            "Motor:STRUCT",
            "END_STRUCT ;",
            "end_struct:=( a:=1,b :=[ 2( 0 ) ] );",
            "Phase : ( idle,Run:= 5 ):=Run;",
            "g:array[1..3,0..n]of $Motor:=[ (a:=1) ];",
            "r : int( 0 .. 9 );",
            "c # inside # : INT;",
            "broken : ;",
            "split :\nINT;",
            "  # own line #",
            "",
            "d := 3",
        ]));
        text.push_str(&c.of(&[end, end, " ", "  # after #\n"]));
    }
    text.push_str(&c.of(&["END_VAR", "end_var", "END_VAR", "END_VAR # c #", "", "end_type"]));
    text.push_str(end);
}
