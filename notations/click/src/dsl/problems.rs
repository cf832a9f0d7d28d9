//! What is not in the DSL, with its place.

use super::super::address::{Address, Tag, Which};
use super::super::model::Nickname;
use ladder_notation::{LineColumn, Lines, ReadError};
use ruff_python_ast::{Expr, Stmt};
use ruff_text_size::Ranged;

/// A text, and what in it is not the DSL.
pub(super) struct Problems<'t> {
    text: &'t str,
    lines: Lines,
    all: Vec<(LineColumn, String)>,
    /// What the address picker says.
    nicknames: &'t [Nickname],
}

/// What could not be read. What it is has been noted.
#[derive(Debug, Clone, Copy)]
pub(super) struct Unread;

impl<'t> Problems<'t> {
    pub(super) fn new(text: &'t str, nicknames: &'t [Nickname]) -> Problems<'t> {
        Problems {
            text,
            nicknames,
            lines: Lines::of(text),
            all: Vec::new(),
        }
    }

    pub(super) fn text(&self) -> &'t str {
        self.text
    }

    /// What is at a part of the program.
    pub(super) fn source(&self, of: &impl Ranged) -> &'t str {
        self.text
            .get(usize::from(of.start())..usize::from(of.end()))
            .unwrap_or("")
    }

    pub(super) fn place(&self, of: &impl Ranged) -> LineColumn {
        self.lines.place(self.text, of.start().into())
    }

    /// The address of a tag, if it is known.
    pub(super) fn address(&self, tag: &Tag) -> Option<Address> {
        let Which::Nickname(name) = &tag.which else {
            return tag.address();
        };
        let is_it = |nickname: &&Nickname| nickname.address.bank == tag.bank && nickname.name == *name;
        self.nicknames.iter().find(is_it).map(|nickname| nickname.address)
    }

    pub(super) fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Notes that something is not in the DSL.
    pub(super) fn note(&mut self, of: &impl Ranged, message: impl Into<String>) -> Unread {
        let place = self.place(of);
        self.all.push((place, message.into()));
        Unread
    }

    /// All of them as one error, if there are any: nothing of the file is read then.
    pub(super) fn into_error(mut self) -> Option<ReadError> {
        self.all.sort_by_key(|(place, _)| *place);
        let mut all = self.all.into_iter();
        let (place, message) = all.next()?;
        Some(ReadError {
            more: all.collect(),
            ..ReadError::at(place, message)
        })
    }
}

/// What a statement is, in words.
pub(super) fn statement(statement: &Stmt) -> &'static str {
    match statement {
        Stmt::FunctionDef(_) => "a function inside another",
        Stmt::ClassDef(_) => "a class",
        Stmt::Return(_) => "`return`",
        Stmt::Delete(_) => "`del`",
        Stmt::TypeAlias(_) => "`type`",
        Stmt::Assign(_) | Stmt::AugAssign(_) | Stmt::AnnAssign(_) => "an assignment",
        Stmt::For(_) => "`for`",
        Stmt::While(_) => "`while`",
        Stmt::If(_) => "`if`",
        Stmt::With(_) => "`with`",
        Stmt::Match(_) => "`match`",
        Stmt::Raise(_) => "`raise`",
        Stmt::Try(_) => "`try`",
        Stmt::Assert(_) => "`assert`",
        Stmt::Import(_) | Stmt::ImportFrom(_) => "an import",
        Stmt::Global(_) => "`global`",
        Stmt::Nonlocal(_) => "`nonlocal`",
        Stmt::Expr(_) => "an expression by itself",
        Stmt::Pass(_) => "`pass`",
        Stmt::Break(_) => "`break`",
        Stmt::Continue(_) => "`continue`",
        Stmt::IpyEscapeCommand(_) => "a command of IPython",
    }
}

/// What an expression is, in words.
pub(super) fn expression(expression: &Expr) -> &'static str {
    match expression {
        Expr::BoolOp(_) => "`and` or `or`",
        Expr::Named(_) => "`:=`",
        Expr::BinOp(_) => "a calculation",
        Expr::UnaryOp(_) => "a sign or `not`",
        Expr::Lambda(_) => "a lambda",
        Expr::If(_) => "a conditional expression",
        Expr::Dict(_) => "a dictionary",
        Expr::Set(_) => "a set",
        Expr::List(_) => "a list",
        Expr::Tuple(_) => "a tuple",
        Expr::ListComp(_) | Expr::SetComp(_) | Expr::DictComp(_) | Expr::Generator(_) => "a comprehension",
        Expr::Await(_) => "`await`",
        Expr::Yield(_) | Expr::YieldFrom(_) => "`yield`",
        Expr::Compare(_) => "a comparison",
        Expr::Call(_) => "a call",
        Expr::FString(_) => "an f-string",
        Expr::TString(_) => "a t-string",
        Expr::StringLiteral(_) => "a string",
        Expr::BytesLiteral(_) => "a bytes literal",
        Expr::NumberLiteral(_) => "a number",
        Expr::BooleanLiteral(_) => "a truth value",
        Expr::NoneLiteral(_) => "`None`",
        Expr::EllipsisLiteral(_) => "`...`",
        Expr::Attribute(_) => "an attribute",
        Expr::Subscript(_) => "an index",
        Expr::Starred(_) => "`*`",
        Expr::Name(_) => "a name",
        Expr::Slice(_) => "a slice",
        Expr::IpyEscapeCommand(_) => "a command of IPython",
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    /// What is reported about a statement that is where none of its kind can, at its place.
    fn told(text: &str) -> String {
        let error = super::super::read(text).expect_err(text);
        let (_, message) = error.all().next().expect("something is wrong");
        message.to_owned()
    }

    #[test]
    fn every_statement_is_named() {
        let statements = [
            "def a(): pass",
            "class A: pass",
            "return",
            "del x",
            "type A = int",
            "x = 1",
            "x += 1",
            "x: int = 1",
            "for _ in range(3): pass",
            "while True: pass",
            "if c.A: pass",
            "with x: pass",
            "match x:\n            case 1: pass",
            "raise x",
            "try: pass\n        except: pass",
            "assert x",
            "import os",
            "from os import path",
            "global x",
            "nonlocal x",
            "5",
            "break",
            "continue",
        ];
        let mut shown = String::new();
        for statement in statements {
            let first = statement.split('\n').next().unwrap_or_default();
            let outside = statement.replace("\n        ", "\n");
            let next_to = statement.replace("\n        ", "\n    ");
            for (place, text) in [
                ("outside", format!("{outside}\ndef main():\n    pass\n")),
                (
                    "next to the rungs",
                    format!("def main():\n    if True:\n        end()\n    {next_to}\n"),
                ),
                (
                    "in a rung",
                    format!("def main():\n    if c.A:\n        {statement}\n"),
                ),
            ] {
                // What may be there is no error.
                if super::super::read(&text).is_err() {
                    shown.push_str(&format!("{first} {place}: {}\n", told(&text)));
                }
            }
        }
        expect![[r#"
            def a(): pass outside: `a` is not `main`, so it is a subroutine and has @sub above it
            def a(): pass next to the rungs: a function inside another is not in the DSL: a function has rungs, each under an `if`
            def a(): pass in a rung: a function inside another is not in the DSL
            class A: pass outside: a class outside a function is not in the DSL
            class A: pass next to the rungs: a class is not in the DSL: a function has rungs, each under an `if`
            class A: pass in a rung: a class is not in the DSL
            return outside: `return` outside a function is not in the DSL
            return next to the rungs: `return` is under an `if`: write `if True:` above it
            del x outside: `del` outside a function is not in the DSL
            del x next to the rungs: `del` is not in the DSL: a function has rungs, each under an `if`
            del x in a rung: `del` is not in the DSL
            type A = int outside: `type` outside a function is not in the DSL
            type A = int next to the rungs: `type` is not in the DSL: a function has rungs, each under an `if`
            type A = int in a rung: `type` is not in the DSL
            x = 1 outside: an assignment outside a function is not in the DSL
            x = 1 next to the rungs: an assignment is not in the DSL: a function has rungs, each under an `if`
            x = 1 in a rung: an assignment is not in the DSL
            x += 1 outside: an assignment outside a function is not in the DSL
            x += 1 next to the rungs: an assignment is not in the DSL: a function has rungs, each under an `if`
            x += 1 in a rung: an assignment is not in the DSL
            x: int = 1 outside: an assignment outside a function is not in the DSL
            x: int = 1 next to the rungs: an assignment is not in the DSL: a function has rungs, each under an `if`
            x: int = 1 in a rung: an assignment is not in the DSL
            for _ in range(3): pass outside: `for` outside a function is not in the DSL
            for _ in range(3): pass next to the rungs: `for` is under an `if`: write `if True:` above it
            while True: pass outside: `while` outside a function is not in the DSL
            while True: pass next to the rungs: `while` is not in the DSL: a function has rungs, each under an `if`
            while True: pass in a rung: `while` is not in the DSL
            if c.A: pass outside: `if` outside a function is not in the DSL
            if c.A: pass in a rung: an `if` inside another is not in the DSL: write all(..) with both
            with x: pass outside: `with` outside a function is not in the DSL
            with x: pass next to the rungs: `with` is not in the DSL: a function has rungs, each under an `if`
            with x: pass in a rung: `with` is not in the DSL
            match x: outside: `match` outside a function is not in the DSL
            match x: next to the rungs: `match` is not in the DSL: a function has rungs, each under an `if`
            match x: in a rung: `match` is not in the DSL
            raise x outside: `raise` outside a function is not in the DSL
            raise x next to the rungs: `raise` is not in the DSL: a function has rungs, each under an `if`
            raise x in a rung: `raise` is not in the DSL
            try: pass outside: `try` outside a function is not in the DSL
            try: pass next to the rungs: `try` is not in the DSL: a function has rungs, each under an `if`
            try: pass in a rung: `try` is not in the DSL
            assert x outside: `assert` outside a function is not in the DSL
            assert x next to the rungs: `assert` is not in the DSL: a function has rungs, each under an `if`
            assert x in a rung: `assert` is not in the DSL
            import os outside: an import outside a function is not in the DSL
            import os next to the rungs: an import is not in the DSL: a function has rungs, each under an `if`
            import os in a rung: an import is not in the DSL
            from os import path outside: an import outside a function is not in the DSL
            from os import path next to the rungs: an import is not in the DSL: a function has rungs, each under an `if`
            from os import path in a rung: an import is not in the DSL
            global x outside: `global` outside a function is not in the DSL
            global x next to the rungs: `global` is not in the DSL: a function has rungs, each under an `if`
            global x in a rung: `global` is not in the DSL
            nonlocal x outside: `nonlocal` outside a function is not in the DSL
            nonlocal x next to the rungs: `nonlocal` is not in the DSL: a function has rungs, each under an `if`
            nonlocal x in a rung: `nonlocal` is not in the DSL
            5 outside: an expression by itself outside a function is not in the DSL
            5 next to the rungs: a number outside a rung is not in the DSL
            5 in a rung: a number is not an action of the DSL
            break outside: `break` outside a function is not in the DSL
            break next to the rungs: `break` is not in the DSL: a function has rungs, each under an `if`
            break in a rung: `break` is not in the DSL
            continue outside: `continue` outside a function is not in the DSL
            continue next to the rungs: `continue` is not in the DSL: a function has rungs, each under an `if`
            continue in a rung: `continue` is not in the DSL
        "#]]
        .assert_eq(&shown);
    }

    #[test]
    fn every_expression_is_named() {
        let expressions = [
            "a and b",
            "(a := b)",
            "1 + 2",
            "not a",
            "lambda: a",
            "a if b else c",
            "{a: b}",
            "{a}",
            "[a]",
            "(a, b)",
            "[a for a in b]",
            "{a for a in b}",
            "{a: b for a in c}",
            "(a for a in b)",
            "await a",
            "(yield a)",
            "(yield from a)",
            "1 < 2 < 3",
            "f(x)",
            "f'{a}'",
            "t'{a}'",
            "'a'",
            "b'a'",
            "5",
            "False",
            "None",
            "...",
            "c.A.B",
            "c[1][2]",
            "*a",
            "a",
        ];
        let mut shown = String::new();
        for expression in expressions {
            let condition = format!("def main():\n    if all({expression}, c.A):\n        out(c.B)\n");
            let value = format!("def main():\n    if c.A:\n        copy({expression}, ds.B)\n");
            for (place, text) in [("as a condition", condition), ("as a value", value)] {
                if super::super::read(&text).is_err() {
                    shown.push_str(&format!("{expression} {place}: {}\n", told(&text)));
                }
            }
        }
        expect![[r#"
            a and b as a condition: `and` is not in the DSL: write all(a, b)
            a and b as a value: `and` or `or` is not a value of the DSL: it has numbers, texts and addresses
            (a := b) as a condition: `:=` is not a condition of the DSL
            (a := b) as a value: `:=` is not a value of the DSL: it has numbers, texts and addresses
            1 + 2 as a condition: a calculation is not a condition of the DSL
            1 + 2 as a value: a calculation is not a value of the DSL: it has numbers, texts and addresses
            not a as a condition: `not` is not in the DSL: write nc(a) for a normally closed contact
            not a as a value: a sign or `not` is not a value of the DSL: it has numbers, texts and addresses
            lambda: a as a condition: a lambda is not a condition of the DSL
            lambda: a as a value: a lambda is not a value of the DSL: it has numbers, texts and addresses
            a if b else c as a condition: a conditional expression is not a condition of the DSL
            a if b else c as a value: a conditional expression is not a value of the DSL: it has numbers, texts and addresses
            {a: b} as a condition: a dictionary is not a condition of the DSL
            {a: b} as a value: a dictionary is not a value of the DSL: it has numbers, texts and addresses
            {a} as a condition: a set is not a condition of the DSL
            {a} as a value: a set is not a value of the DSL: it has numbers, texts and addresses
            [a] as a condition: a list is not a condition of the DSL
            [a] as a value: a list is not a value of the DSL: it has numbers, texts and addresses
            (a, b) as a condition: a tuple is not a condition of the DSL
            (a, b) as a value: a tuple is not a value of the DSL: it has numbers, texts and addresses
            [a for a in b] as a condition: a comprehension is not a condition of the DSL
            [a for a in b] as a value: a comprehension is not a value of the DSL: it has numbers, texts and addresses
            {a for a in b} as a condition: a comprehension is not a condition of the DSL
            {a for a in b} as a value: a comprehension is not a value of the DSL: it has numbers, texts and addresses
            {a: b for a in c} as a condition: a comprehension is not a condition of the DSL
            {a: b for a in c} as a value: a comprehension is not a value of the DSL: it has numbers, texts and addresses
            (a for a in b) as a condition: a comprehension is not a condition of the DSL
            (a for a in b) as a value: a comprehension is not a value of the DSL: it has numbers, texts and addresses
            await a as a condition: `await` is not a condition of the DSL
            await a as a value: `await` is not a value of the DSL: it has numbers, texts and addresses
            (yield a) as a condition: `yield` is not a condition of the DSL
            (yield a) as a value: `yield` is not a value of the DSL: it has numbers, texts and addresses
            (yield from a) as a condition: `yield` is not a condition of the DSL
            (yield from a) as a value: `yield` is not a value of the DSL: it has numbers, texts and addresses
            1 < 2 < 3 as a condition: chained comparisons are not in the DSL: write all(a < b, b < c)
            1 < 2 < 3 as a value: a comparison is not a value of the DSL: it has numbers, texts and addresses
            f(x) as a condition: `f` is not a condition of the DSL: it has all, any, nc, re and fe
            f(x) as a value: a call is not a value of the DSL: it has numbers, texts and addresses
            f'{a}' as a condition: an f-string is not a condition of the DSL
            f'{a}' as a value: an f-string is not a value of the DSL: it has numbers, texts and addresses
            t'{a}' as a condition: a t-string is not a condition of the DSL
            t'{a}' as a value: a t-string is not a value of the DSL: it has numbers, texts and addresses
            'a' as a condition: a string is not a condition of the DSL
            b'a' as a condition: a bytes literal is not a condition of the DSL
            b'a' as a value: a bytes literal is not a value of the DSL: it has numbers, texts and addresses
            5 as a condition: a number is not a condition of the DSL
            False as a condition: `False` is not a condition: a rung is under `if True:` or a real one
            None as a condition: `None` is not a condition of the DSL
            None as a value: `None` is not a value of the DSL: it has numbers, texts and addresses
            ... as a condition: `...` is not a condition of the DSL
            ... as a value: `...` is not a value of the DSL: it has numbers, texts and addresses
            c.A.B as a condition: an attribute is not an address of the DSL: addresses are c[1] or c.Start
            c.A.B as a value: an attribute is not an address of the DSL: addresses are c[1] or c.Start
            c[1][2] as a condition: an index is not an address of the DSL: addresses are c[1] or c.Start
            c[1][2] as a value: an index is not an address of the DSL: addresses are c[1] or c.Start
            *a as a condition: `*` is not a condition of the DSL
            *a as a value: `*` is not in the DSL: give the arguments one by one
            a as a condition: a name is not a condition of the DSL
            a as a value: a name is not a value of the DSL: it has numbers, texts and addresses
        "#]]
        .assert_eq(&shown);
    }
}
