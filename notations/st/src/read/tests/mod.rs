//! Each construct of Structured Text, with the ladder text that it becomes.

mod enabled;
mod hostile;
mod parts;

use super::dialect::Dialect;
use super::program::read;
use super::token::{TokenKind, tokens};
use super::{Source, Type, read_body, units};
use expect_test::{Expect, expect};
use ladder_analysis::values::types::Scalar;
use ladder_format::program::{Path, ProgramSketch};
use ladder_notation::{Names, Outcome, UnreadParts};

fn check_tokens(text: &str, dialect: Dialect, expected: &Expect) {
    let shown = tokens(text, dialect)
        .tokens
        .into_iter()
        .filter(|token| token.kind != TokenKind::End);
    let shown: Vec<String> = shown
        .map(|token| format!("{:?} {}", token.kind, &text[token.span]))
        .collect();
    expected.assert_eq(&(shown.join("\n") + "\n"));
}

/// What a file becomes, with what is reported of it.
fn check_file(text: &str, expected: &Expect) {
    let reading = read(text, Dialect::Iec, &[]).expect("it is read");
    let mut shown = reading.program.write(&ladder_format::Options::default()).text;
    for entry in reading.report.remarks() {
        let (Outcome::Refused(why) | Outcome::Approximated(why)) = &entry.outcome else {
            continue;
        };
        shown.push_str(&format!("{}: {}: {why}\n", entry.place, entry.element));
    }
    for finding in &reading.findings {
        shown.push_str(&format!("{}: {}\n", finding.place, finding.message));
    }
    expected.assert_eq(&shown);
}

/// What a body becomes. Its tags: `a` to `d` are BOOL, `i` to `n` INT, `u` and `v` DINT, `r` and `s` REAL, `w` WORD,
/// `t` is a TON, `e` an R_TRIG, `x` an array of INT.
fn check(text: &str, dialect: Dialect, expected: &Expect) {
    let mut scope = super::Scope::default();
    let mut names = Names::default();
    let mut declare = |name: &str, ty: Type| {
        let spelled = names.spell(name).to_owned();
        scope.tag(name, Path::tag(spelled), ty, false);
    };
    for (all, ty) in [
        ("abcd", Scalar::Bool),
        ("ijklmn", Scalar::Int),
        ("uv", Scalar::Dint),
        ("rs", Scalar::Real),
        ("w", Scalar::Word),
        ("pq", Scalar::Time),
    ] {
        all.chars()
            .for_each(|name| declare(&name.to_string(), Type::Scalar(ty)));
    }
    declare("t", Type::Standard("TON"));
    declare("z", Type::Standard("CTU"));
    declare("e", Type::Trigger(super::Edge::Rising));
    declare("f", Type::Trigger(super::Edge::Falling));
    declare(
        "x",
        Type::Array(
            vec![("0".into(), "7".into())],
            Box::new(Type::Scalar(Scalar::Int)),
        ),
    );
    let source = Source {
        text,
        dialect,
        unit: "Main",
        scope: &scope,
        restarted: &[],
        instructions: None,
        first_origin: 0,
        first_label: 0,
    };
    let mut unread = UnreadParts::default();
    let (.., problems) = units::body(text, dialect);
    let shown = match read_body(&source, &mut names, &mut unread, |_| 1) {
        Err(_) if !problems.is_empty() => problems.iter().fold(String::new(), |told, problem| {
            told + &format!("{:?}: {}\n", problem.span, problem.message)
        }),
        Err(why) => format!("unread: {why}\n"),
        Ok(body) => {
            let mut tags = ladder_format::program::Section::new(ladder_format::program::SectionKind::Var);
            tags.declarations = body.tags;
            let mut items: Vec<_> = unread.items().collect();
            items.push(ladder_format::program::Item::Section(tags));
            items.extend(body.items);
            ProgramSketch { items }
                .write(&ladder_format::Options::default())
                .text
        }
    };
    expected.assert_eq(&shown);
}

#[test]
fn literals_are_one_token() {
    check_tokens(
        "T#-1.5s INT#16#7F D#2026-11-29 1..5 1.5e-3 16#F_F a.3.1 REAL#1.0e-3 INT#1..3 Phase#IDLE %IX0.0 w.%X3",
        Dialect::Iec,
        &expect![[r#"
            Typed T#-1.5s
            Typed INT#16#7F
            Typed D#2026-11-29
            Integer 1
            Sign("..") ..
            Integer 5
            Real 1.5e-3
            Integer 16#F_F
            Word a
            Sign(".") .
            Integer 3
            Sign(".") .
            Integer 1
            Typed REAL#1.0e-3
            Typed INT#1
            Sign("..") ..
            Integer 3
            Typed Phase#IDLE
            Address %IX0.0
            Word w
            Sign(".") .
            Address %X3
        "#]],
    );
}

#[test]
fn comments_nest_where_they_do() {
    check_tokens(
        "a (* x (* y *) z *) b // c\n d /* e */ f",
        Dialect::Iec,
        &expect![[r#"
        Word a
        Word b
        Word d
        Word f
    "#]],
    );
    check_tokens(
        "a (* x (* y *) b",
        Dialect::Logix,
        &expect![[r#"
        Word a
        Word b
    "#]],
    );
    check_tokens(
        "a (* x (* y *) b",
        Dialect::Iec,
        &expect![[r#"
        Word a
        Word b
    "#]],
    );
    check_tokens(
        "#region odd 'name\na [:=] 1; #endregion",
        Dialect::Logix,
        &expect![[r#"
        Word a
        Sign("[:=]") [:=]
        Integer 1
        Sign(";") ;
    "#]],
    );
    check_tokens(
        "REGION it's\n#a.\"odd name\" := \"Global\"; END_REGION",
        Dialect::Scl,
        &expect![[r#"
        Name #a
        Sign(".") .
        Name "odd name"
        Sign(":=") :=
        Name "Global"
        Sign(";") ;
    "#]],
    );
    check_tokens(
        "{attribute 'x'} x {IF defined(b)} 'it$'s' \"w\" '",
        Dialect::Codesys,
        &expect![[r#"
        Word x
        Stray {IF defined(b)}
        Text 'it$'s'
        Text "w"
        Stray '
    "#]],
    );
}

#[test]
fn assignments() {
    check(
        "a := b AND NOT c OR d; i := j; i := j + 1; r := s / 3.0; a := TRUE;",
        Dialect::Iec,
        &expect![[r#"
        +-----------------------------------------------[CALC]( a, b AND NOT c OR d )--+
        +---------------------------------------------------------------[MOV]( i, j )--+
        +----------------------------------------------------------[CALC]( i, j + 1 )--+
        +--------------------------------------------------------[CALC]( r, s / 3.0 )--+
        +------------------------------------------------------------[MOV]( a, TRUE )--+
    "#]],
    );
}

#[test]
fn a_bool_that_is_assigned_once_is_a_coil() {
    check(
        "a := b AND NOT (c OR i > 3);",
        Dialect::Iec,
        &expect![[r#"
        # a := b AND NOT (c OR i > 3) #
        +--[ ]( b )--[/]( c )--[LE]( i, 3 )----------------------------------( )( a )--+
    "#]],
    );
    check(
        "a := (b XOR c) = d; b := i / j > 3;",
        Dialect::Iec,
        &expect![[r#"
        VAR
            st1 : DINT;
        END_VAR

        +--------------------------------------------------[CALC]( a, (b XOR c) = d )--+

        # b := i / j > 3 #
        +----------------------------------[CALC]( st1, i / j )--[CALC]( b, st1 > 3 )--+
    "#]],
    );
}

#[test]
fn integers_are_exact_and_cut_where_they_are_assigned() {
    check(
        "i := (j + k) / 2; a := i + j = k; a := i MOD 2 = 1; u := i * j; i := u;",
        Dialect::Iec,
        &expect![[r#"
            VAR
                st1 : DINT;
                st2 : DINT;
            END_VAR

            # i := (j + k) / 2 #
            +--------------[CALC]( st1, j + k )--[CALC]( st2, st1 / 2 )--[WRAP]( i, st2 )--+

            # a := i + j = k #
            +----------------------------------[CALC]( st2, i + j )--[CALC]( a, st2 = k )--+
            +----------------------------------------------------[CALC]( a, i MOD 2 = 1 )--+
            +----------------------------------------------------------[CALC]( u, i * j )--+
            +--------------------------------------------------------------[WRAP]( i, u )--+
        "#]],
    );
    check(
        "i := (j + k) / 2; u := i * j;",
        Dialect::Scl,
        &expect![[r#"
        +----------------------------------------------------[CALC]( i, (j + k) / 2 )--+
        +----------------------------------------------------------[CALC]( u, i * j )--+
    "#]],
    );
    check(
        "r := i / j + 0.5; r := i * 1.5; a := i > 1.5; i := -32768; w := w AND 16#FF; u := i + 100000;",
        Dialect::Iec,
        &expect![[r#"
        VAR
            st1 : DINT;
            st2 : LREAL;
        END_VAR

        # r := i / j + 0.5 #
        +-------------[CALC]( st1, i / j )--[CALC]( st2, st1 + 0.5 )--[TYP]( r, st2 )--+
        +--------------------------------------------------------[CALC]( r, i * 1.5 )--+

        # a := i > 1.5 #
        +-------------------------------------[MOV]( st2, i )--[CALC]( a, st2 > 1.5 )--+
        +----------------------------------------------------------[MOV]( i, -32768 )--+
        +----------------------------------------------------[CALC]( w, w AND 16#FF )--+

        # u := i + 100000 #
        +----------------------------------[MOV]( st1, i )--[CALC]( u, st1 + 100000 )--+
    "#]],
    );
}

#[test]
fn conversions() {
    check(
        "i := DINT_TO_INT(u); u := INT_TO_DINT(i) * j; r := INT_TO_REAL(i) / 2.0; i := REAL_TO_INT(r); \
         i := TRUNC(r); a := INT_TO_BOOL(i); i := WORD_TO_INT(w); u := TIME_TO_DINT(p);",
        Dialect::Iec,
        &expect![[r#"
            VAR
                st2 : REAL;
                st3 : LINT;
                st4 : DINT;
            END_VAR

            +--------------------------------------------------------------[WRAP]( i, u )--+
            +----------------------------------------------------------[CALC]( u, i * j )--+

            # r := INT_TO_REAL(i) / 2.0 #
            +-------------------------------------[TYP]( st2, i )--[CALC]( r, st2 / 2.0 )--+

            # i := REAL_TO_INT(r) #
            +-------------------------------------------[TYP]( st3, r )--[WRAP]( i, st3 )--+

            # i := TRUNC(r) #
            +---------------------[TRUNC]( st3, r )--[WRAP]( st4, st3 )--[WRAP]( i, st4 )--+
            +---------------------------------------------------------[CALC]( a, i <> 0 )--+
            +--------------------------------------------------------------[WRAP]( i, w )--+
            +---------------------------------------------------------------[TYP]( u, p )--+
        "#]],
    );
}

#[test]
fn functions_are_instructions() {
    check(
        "i := MIN(j, k, 3); w := SHL(w, 3) OR 16#1; r := SEL(a, 1.5, LIMIT(0.0, s, 10.0)); i := SEL(G := a, IN0 := j, IN1 := k); \
         a := GT(i, j); r := SQRT(s); i := ADD(i, j, k); r := r ** 2.0;",
        Dialect::Iec,
        &expect![[r#"
            VAR
                st2 : WORD;
                st3 : REAL;
            END_VAR

            +---------------------------------------------------------[MIN]( i, j, k, 3 )--+

            # w := SHL(w, 3) OR 16|1 #
            +--------------------------------[SHL]( st2, w, 3 )--[CALC]( w, st2 OR 16#1 )--+

            # r := SEL(a, 1.5, LIMIT(0.0, s, 10.0)) #
            +-----------------------[LIMIT]( st3, 0.0, s, 10.0 )--[SEL]( r, a, 1.5, st3 )--+
            +---------------------------------------------------------[SEL]( i, a, j, k )--+
            +----------------------------------------------------------[CALC]( a, i > j )--+
            +--------------------------------------------------------------[SQRT]( r, s )--+
            +------------------------------------------------------[CALC]( i, i + j + k )--+
            +--------------------------------------------------------[CALC]( r, r ^ 2.0 )--+
        "#]],
    );
}

#[test]
fn branches() {
    check(
        "IF a THEN i := 1; END_IF; IF b THEN a := TRUE; END_IF; IF a AND i > 3 THEN i := 1; j := 2; END_IF;",
        Dialect::Iec,
        &expect![[r#"
        # IF a THEN i := 1; END_IF #
        +--[ ]( a )-----------------------------------------------------[MOV]( i, 1 )--+

        # IF b THEN a := TRUE; END_IF #
        +--[ ]( b )----------------------------------------------------------(S)( a )--+

        # IF a AND i > 3 THEN i := 1; j := 2; END_IF #
        +--[ ]( a )--[GT]( i, 3 )------------------------[MOV]( i, 1 )--[MOV]( j, 2 )--+
    "#]],
    );
    check(
        "IF a OR b THEN i := i + 1; j := i / 2; ELSIF c THEN i := 0; ELSE i := 7; END_IF;",
        Dialect::Iec,
        &expect![[r#"
        # IF a OR b THEN #
        +--[/]( a )--[/]( b )------------------------------------------<JMP>( else1 )--+
        +----------------------------------------------------------[CALC]( i, i + 1 )--+
        +----------------------------------------------------------[CALC]( j, i / 2 )--+
        +-------------------------------------------------------------<JMP>( endif1 )--+

        # ELSIF c THEN #
        +--<LBL>( else1 )--[ ]( c )--------------------[MOV]( i, 0 )--<JMP>( endif1 )--+

        # ELSE #
        +---------------------------------------------------------------[MOV]( i, 7 )--+
        +--<LBL>( endif1 )-------------------------------------------------------------+
    "#]],
    );
    check(
        "IF a THEN\n  IF b THEN i := 1; j := i + 1; END_IF;\nELSE\n  i := 7;\nEND_IF;\nIF a THEN RETURN; END_IF",
        Dialect::Codesys,
        &expect![[r#"
        # IF a THEN #
        +--[/]( a )----------------------------------------------------<JMP>( else1 )--+

        # IF b THEN #
        +--[/]( b )---------------------------------------------------<JMP>( endif2 )--+
        +---------------------------------------------------------------[MOV]( i, 1 )--+
        +----------------------------------------------------------[CALC]( j, i + 1 )--+
        +--<LBL>( endif2 )--------------------------------------------<JMP>( endif1 )--+

        # ELSE #
        +--<LBL>( else1 )-----------------------------------------------[MOV]( i, 7 )--+

        # IF a THEN RETURN; END_IF #
        +--<LBL>( endif1 )--[ ]( a )--------------------------------------------<RET>--+
    "#]],
    );
}

#[test]
fn cases() {
    check(
        "CASE i OF 1: j := 1; 2, 5..9: j := j + 1; k := 2; ELSE j := 0; END_CASE;",
        Dialect::Iec,
        &expect![[r#"
        # CASE i OF #
        # 1: #
        +--[EQ]( i, 1 )------------------------------[MOV]( j, 1 )--<JMP>( endcase1 )--+

        # 2, 5..9: #
        +--\--[EQ]( i, 2 )-----\--[NOT]---------------------------------<JMP>( arm1 )--+
        |  /--[LE]( 5, i, 9 )--/                                                       |
        +----------------------------------------------------------[CALC]( j, j + 1 )--+
        +---------------------------------------------------------------[MOV]( k, 2 )--+
        +-----------------------------------------------------------<JMP>( endcase1 )--+

        # ELSE #
        +--<LBL>( arm1 )------------------------------------------------[MOV]( j, 0 )--+
        +--<LBL>( endcase1 )-----------------------------------------------------------+
    "#]],
    );
    check(
        "CASE i + 1 OF 1, 2, 3, 4, 5: j := 1; END_CASE;",
        Dialect::Iec,
        &expect![[r#"
        VAR
            st1 : DINT;
            st2 : BOOL;
        END_VAR

        # CASE i + 1 OF #
        +--------[CALC]( st1, i + 1 )--[CALC]( st2, st1 = 1 OR st1 = 2 OR st1 = 3 OR st1 = 4 OR st1 = 5 )--+

        # 1, 2, 3, 4, 5: #
        +--[ ]( st2 )---------------------------------------------------[MOV]( j, 1 )--+
    "#]],
    );
}

#[test]
fn loops() {
    check(
        "FOR i := 1 TO 10 DO x[i - 1] := i; IF x[i] = 3 THEN EXIT; END_IF; END_FOR; j := i;",
        Dialect::Codesys,
        &expect![[r#"
        VAR
            st1 : BOOL;
        END_VAR

        # FOR i := 1 TO 10 DO #
        +---------------------------------------------------------<FOR>( 10, I => i )--+
        +--------------------------------------------------------[MOV]( x[i - 1], i )--+

        # IF x[i] = 3 THEN EXIT; END_IF #
        +--[CALC]( st1, x[i] = 3 )--[ ]( st1 )-----------------------<JMP>( endfor1 )--+
        +----------------------------------------------------------------------<NEXT>--+
        +----------------------------------------------------------[CALC]( i, i + 1 )--+
        +--<LBL>( endfor1 )---------------------------------------------[MOV]( j, i )--+
    "#]],
    );
    check(
        "FOR i := 7 TO 0 BY -1 DO j := j + i; END_FOR;",
        Dialect::Iec,
        &expect![[r#"
        VAR
            st1 : INT;
        END_VAR

        # FOR i := 7 TO 0 BY -1 DO #
        +--------------------------------------------------------<FOR>( 8, I => st1 )--+
        +--------------------------------------------------------[CALC]( i, 8 - st1 )--+
        +----------------------------------------------------------[CALC]( j, j + i )--+
        +----------------------------------------------------------------------<NEXT>--+
    "#]],
    );
    check(
        "FOR i := j TO k BY l DO IF a THEN CONTINUE; END_IF; m := m + i; END_FOR;",
        Dialect::Iec,
        &expect![[r#"
        VAR
            st1 : INT;
            st2 : INT;
        END_VAR

        # FOR i := j TO k BY l DO #
        +-----------------------------[MOV]( i, j )--[MOV]( st1, k )--[MOV]( st2, l )--+
        +--<LBL>( loop1 )--[GE]( st2, 0 )--[GT]( i, st1 )------------<JMP>( endfor1 )--+
        +--[LT]( st2, 0 )--[LT]( i, st1 )----------------------------<JMP>( endfor1 )--+

        # IF a THEN CONTINUE; END_IF #
        +--[ ]( a )----------------------------------------------------<JMP>( next1 )--+
        +----------------------------------------------------------[CALC]( m, m + i )--+
        +--<LBL>( next1 )----------------------------------------[CALC]( i, i + st2 )--+
        +--------------------------------------------------------------<JMP>( loop1 )--+
        +--<LBL>( endfor1 )------------------------------------------------------------+
    "#]],
    );
    check(
        "WHILE i < 10 DO i := i + 1; END_WHILE; REPEAT i := i - 1; UNTIL i = 0 END_REPEAT; WHILE TRUE DO EXIT; END_WHILE;",
        Dialect::Iec,
        &expect![[r#"
        # WHILE i < 10 DO #
        +--<LBL>( loop1 )--[GE]( i, 10 )---------------------------<JMP>( endwhile1 )--+
        +----------------------------------------------------------[CALC]( i, i + 1 )--+
        +--------------------------------------------------------------<JMP>( loop1 )--+

        # REPEAT #
        +--<LBL>( endwhile1 )--<LBL>( loop2 )----------------------[CALC]( i, i - 1 )--+

        # UNTIL i = 0 #
        +--[NE]( i, 0 )------------------------------------------------<JMP>( loop2 )--+

        # WHILE TRUE DO #
        +--<LBL>( loop3 )------------------------------------------<JMP>( endwhile2 )--+
        +--------------------------------------------------------------<JMP>( loop3 )--+
        +--<LBL>( endwhile2 )----------------------------------------------------------+
    "#]],
    );
}

#[test]
fn right_sides_that_may_fault_are_not_always_reached() {
    check(
        "a := i <> 0 AND j / i > 3;",
        Dialect::Iec,
        &expect![[r#"
        VAR
            st1 : BOOL;
            st2 : DINT;
        END_VAR

        +--[CALC]( st1, i <> 0 )--[/]( st1 )-------------------------<JMP>( enough1 )--+
        +--------------------------------[CALC]( st2, j / i )--[CALC]( st1, st2 > 3 )--+
        +--<LBL>( enough1 )-------------------------------------------[MOV]( a, st1 )--+
    "#]],
    );
    check(
        "IF a OR_ELSE x[i] > 3 THEN j := 1; END_IF;",
        Dialect::Codesys,
        &expect![[r#"
        VAR
            st1 : BOOL;
        END_VAR

        +--[CALC]( st1, a )--[ ]( st1 )------------------------------<JMP>( enough1 )--+
        +-----------------------------------------------------[CALC]( st1, x[i] > 3 )--+

        # IF a OR_ELSE x[i] > 3 THEN j := 1; END_IF #
        +--<LBL>( enough1 )--[ ]( st1 )---------------------------------[MOV]( j, 1 )--+
    "#]],
    );
}

#[test]
fn timers_counters_and_edges() {
    check(
        "t(IN := a AND b, PT := T#5s, Q => c); p := t.ET; z(CU := a, R := b, PV := 10); i := z.CV;",
        Dialect::Iec,
        &expect![[r#"
            +--[ ]( a )--[ ]( b )------------------------------[TON]( t, T#5s )--( )( c )--+
            +------------------------------------------------------------[MOV]( p, t.ET )--+
            +--[ ]( a )--------------------------------------------[CTU]( z, 10, R := b )--+
            +-----------------------------------------------------------[WRAP]( i, z.CV )--+
        "#]],
    );
    check(
        "t(IN := a, PT := T#5s); t(IN := b);",
        Dialect::Iec,
        &expect![[r#"
        +--[ ]( a )--------------------------------------------------[TON]( t, T#5s )--+

        # ladder: allow(duplicate-timer): several calls of t #
        +--[ ]( b )--------------------------------------------------[TON]( t, t.PT )--+
    "#]],
    );
    check(
        "t.PT := T#3s; t(IN := a); p := t.PT;",
        Dialect::Iec,
        &expect![[r#"
        VAR
            t_PT : TIME;
        END_VAR

        +---------------------------------------------------------[MOV]( t_PT, T#3s )--+
        +--[ ]( a )--------------------------------------------------[TON]( t, t_PT )--+
        +------------------------------------------------------------[MOV]( p, t_PT )--+
    "#]],
    );
    check(
        "e(CLK := a OR b); IF e.Q THEN i := i + 1; END_IF; f(CLK := a); c := f.Q;",
        Dialect::Iec,
        &expect![[r#"
        +--\--[ ]( a )--\--[OSR]---------------------------------------------( )( e )--+
        |  /--[ ]( b )--/                                                              |

        # IF e.Q THEN i := i + 1; END_IF #
        +--[ ]( e )------------------------------------------------[CALC]( i, i + 1 )--+
        +--[/]( a )--[OSR]---------------------------------------------------( )( f )--+
        +--[ ]( f )----------------------------------------------------------( )( c )--+
    "#]],
    );
    check(
        "IF a THEN e(CLK := b); ELSE e(CLK := c, Q => d); END_IF;",
        Dialect::Iec,
        &expect![[r#"
        VAR
            e_M : BOOL;
        END_VAR

        # IF a THEN #
        +--[/]( a )----------------------------------------------------<JMP>( else1 )--+
        +---------------------------------[CALC]( e, b AND NOT e_M )--[MOV]( e_M, b )--+
        +-------------------------------------------------------------<JMP>( endif1 )--+

        # ELSE #
        +--<LBL>( else1 )-----------------[CALC]( e, c AND NOT e_M )--[MOV]( e_M, c )--+
        +---------------------------------------------------------------[MOV]( d, e )--+
        +--<LBL>( endif1 )-------------------------------------------------------------+
    "#]],
    );
}

#[test]
fn dialects() {
    check(
        "a S= b; a R= c AND d; i := j := 3; IF a THEN i := 0; END_IF",
        Dialect::Codesys,
        &expect![[r#"
        +--[ ]( b )----------------------------------------------------------(S)( a )--+
        +--[ ]( c )--[ ]( d )------------------------------------------------(R)( a )--+

        # i := j := 3 #
        +------------------------------------------------[MOV]( j, 3 )--[MOV]( i, j )--+

        # IF a THEN i := 0; END_IF #
        +--[ ]( a )-----------------------------------------------------[MOV]( i, 0 )--+
    "#]],
    );
    check(
        "REGION one\n#i += 1;\nEND_REGION\n#t.TON(IN := #a, PT := T#1S); #b := #w.%X3; GOTO out; out: #j := 1;",
        Dialect::Scl,
        &expect![[r#"
        # one #
        +----------------------------------------------------------[CALC]( i, i + 1 )--+
        +--[ ]( a )--------------------------------------------------[TON]( t, T#1S )--+
        +--[ ]( w.3 )--------------------------------------------------------( )( b )--+
        +----------------------------------------------------------------<JMP>( out )--+
        +--<LBL>( out )-------------------------------------------------[MOV]( j, 1 )--+
    "#]],
    );
    check(
        "a [:=] 0; b := 1; // told\n w := 16#FF;",
        Dialect::Logix,
        &expect![[r#"
        +-----------------------------------------------------------[MOV]( a, FALSE )--+

        # told #
        +------------------------------------------------------------[MOV]( b, TRUE )--+
        +-----------------------------------------------------------[MOV]( w, 16#FF )--+
    "#]],
    );
}

#[test]
fn what_has_no_counterpart_is_an_unread_part_at_its_place() {
    check(
        "i := 1;\nj := ADR(i);\nMSG(a);\nIF ADR(i) > 3 THEN RETURN; END_IF;",
        Dialect::Iec,
        &expect![[r#"
        unread: `ADR`: it works on memory by address, which ladder text does not have
    "#]],
    );
    check(
        "i := 1;\nj := GETTIME(16#FF);\np^ := 3; k := 2;",
        Dialect::Iec,
        &expect![[r#"
            # line 2 of Main: `GETTIME` is not declared, and is not a function that is read; it is not run here. #
            FUNCTION_BLOCK [$line_2_of_Main]
            # ladder: unread #
            # j := GETTIME(16\hFF) #
            END_FUNCTION_BLOCK

            # line 3 of Main: a pointer works on memory by address, which ladder text does not have; it is not run here. #
            FUNCTION_BLOCK [$line_3_of_Main]
            # ladder: unread #
            # p^ := 3 #
            END_FUNCTION_BLOCK

            +---------------------------------------------------------------[MOV]( i, 1 )--+
            +-----------------------------------------------------------[$line_2_of_Main]--+
            +-----------------------------------------------------------[$line_3_of_Main]--+
            +---------------------------------------------------------------[MOV]( k, 2 )--+
        "#]],
    );
}

#[test]
fn mistakes_are_reported_at_their_places() {
    check(
        "i := ;\nIF a THEN j := 1 END_IF;\nFOR i = 1 TO 3 DO END_FOR;\n) x",
        Dialect::Iec,
        &expect![[r#"
        5..6: a value is expected here, not `;`
        38..39: `:=` is expected here, not `=`
        57..58: `:=` is expected here, not `;`
        59..60: a statement is expected here, not `)`
    "#]],
    );
    // In quotes a name of SCL, a text elsewhere.
    check(
        "FOR \"a\" := 1 TO 2 DO i := j; END_FOR;",
        Dialect::Codesys,
        &expect![[r#"
            4..7: a name is expected here, not `"a"`
            36..37: `:=` is expected here, not `;`
        "#]],
    );
}

#[test]
fn files() {
    check_file(
        "TYPE\n  Phase : (IDLE, RUN := 5);\n  Pump : STRUCT speed : INT := 3; on : BOOL; END_STRUCT;\nEND_TYPE\n\
         (* cuts *)\nFUNCTION Clamp : INT VAR_INPUT v, hi : INT; END_VAR VAR n : INT; END_VAR\n\
         n := n + 1; IF v > hi THEN Clamp := hi; ELSE Clamp := v; END_IF; END_FUNCTION\n\
         FUNCTION_BLOCK FB_Ramp VAR_INPUT go : BOOL; END_VAR VAR_OUTPUT y : INT := 2; END_VAR IF go THEN y := Clamp(y + 1, hi := 9); END_IF; END_FUNCTION_BLOCK\n\
         VAR_GLOBAL CONSTANT K : INT := 16#7; END_VAR\n\
         PROGRAM Main VAR step : Phase := RUN; p : Pump := (speed := 4); a AT %IX0.0 : BOOL; r : FB_Ramp; g : ARRAY[1..K] OF INT := [3(1), 2]; END_VAR\n\
         (* first *) CASE step OF IDLE: step := Phase.RUN; Phase#RUN: p.on := a; END_CASE; // told\n\
         r(go := a); g[2] := r.y; (* last *)\nEND_PROGRAM\n",
        &expect![[r#"
            TYPE
                Phase : (IDLE, RUN := 5);
                Pump  : STRUCT
                    speed : INT := 3;
                    on    : BOOL;
                END_STRUCT;
            END_TYPE

            # cuts #
            FUNCTION_BLOCK [$Clamp]
            VAR_INPUT
                v  : INT;
                hi : INT;
            END_VAR
            VAR
                n : INT;
            END_VAR
            VAR_OUTPUT
                Clamp : INT;  # what the function returns #
            END_VAR

            +-----------------------------------------------------------[MOV]( Clamp, 0 )--+
            +---------------------------------------------------------------[MOV]( n, 0 )--+
            +----------------------------------------------------------[CALC]( n, n + 1 )--+

            # IF v > hi THEN #
            +--[GT]( v, hi )--------------------------[MOV]( Clamp, hi )--<JMP>( endif1 )--+

            # ELSE #
            +-----------------------------------------------------------[MOV]( Clamp, v )--+
            +--<LBL>( endif1 )-------------------------------------------------------------+
            END_FUNCTION_BLOCK

            FUNCTION_BLOCK [$FB_Ramp]
            VAR_INPUT
                go : BOOL;
            END_VAR
            VAR_OUTPUT
                y : INT := 2;
            END_VAR
            VAR
                st1 : INT;
            END_VAR

            # IF go THEN #
            +--[/]( go )--------------------------------------------------<JMP>( endif1 )--+

            # y := Clamp(y + 1, hi := 9) #
            +-------------[CALC]( st1, y + 1 )--[$Clamp]( v := st1, hi := 9, Clamp => y )--+
            +--<LBL>( endif1 )-------------------------------------------------------------+
            END_FUNCTION_BLOCK

            VAR_GLOBAL CONSTANT
                K : INT := 16#7;
            END_VAR
            VAR
                step           : Phase              := RUN;
                p              : Pump               := (speed := 4);
                a    AT %IX0.0 : BOOL;
                r              : $FB_Ramp;
                g              : ARRAY[1..K] OF INT := [3(1), 2];
            END_VAR

            # first #
            # CASE step OF #
            # IDLE: #
            +--[EQ]( step, Phase.IDLE )-------[MOV]( step, Phase.RUN )--<JMP>( endcase1 )--+

            # Phase.RUN: #
            +--[EQ]( step, Phase.RUN )-----------------------------------[MOV]( p.on, a )--+

            # told #
            +--<LBL>( endcase1 )---------------------------------[$FB_Ramp]( r, go := a )--+

            # last #
            +----------------------------------------------------------[MOV]( g[2], r.y )--+
        "#]],
    );
}

#[test]
fn a_unit_that_does_not_parse_is_unread_as_a_whole() {
    check_file(
        "FUNCTION_BLOCK Odd VAR_INPUT a : BOOL; END_VAR a := ; END_FUNCTION_BLOCK\n\
         PROGRAM Main VAR o : Odd; p : POINTER TO INT; END_VAR o(a := TRUE); p^ := 3; END_PROGRAM\n",
        &expect![[r#"
            # line 2 of Main: a pointer works on memory by address, which ladder text does not have; it is not run here. #
            FUNCTION_BLOCK [$line_2_of_Main]
            # ladder: unread #
            # p^ := 3 #
            END_FUNCTION_BLOCK

            # Odd: line 1 does not parse: a value is expected here, not `;`; it is not run here. #
            FUNCTION_BLOCK [$Odd]
            VAR_INPUT
                a : BOOL;
            END_VAR
            # ladder: unread #
            # a := ; #
            END_FUNCTION_BLOCK

            VAR
                o : $Odd;
            END_VAR

            +------------------------------------------------------[$Odd]( o, a := TRUE )--+
            +-----------------------------------------------------------[$line_2_of_Main]--+
            1:1: Odd: line 1 does not parse: a value is expected here, not `;`
            2:27: variable p: a pointer works on memory by address, which ladder text does not have; it is not declared
            2:69: p^ := 3: a pointer works on memory by address, which ladder text does not have: it is not run
            1:53: a value is expected here, not `;`
        "#]],
    );
}

#[test]
fn charts() {
    check_file(
        "PROGRAM Main VAR go, lamp : BOOL; n : INT; END_VAR\n\
         INITIAL_STEP Idle: END_STEP\n\
         TRANSITION FROM Idle TO Run := go; END_TRANSITION\n\
         STEP Run: lamp(D, T#500ms); Count(P); END_STEP\n\
         TRANSITION FROM Run TO Idle := Run.T >= T#2s AND n / 2 > 3; END_TRANSITION\n\
         ACTION Count: n := n + 1; (* one more *) END_ACTION\n\
         END_PROGRAM\n",
        &expect![[r#"
            VAR
                go   : BOOL;
                lamp : BOOL;
                n    : INT;
            END_VAR
            VAR
                st1         : INT;
                Idle        : BOOL := TRUE;  # step Idle #
                Run         : BOOL;  # step Run #
                Run_T       : TIME;  # how long step Run is active #
                Idle_to_Run : BOOL;  # from Idle to Run #
                Run_to_Idle : BOOL;  # from Run to Idle #
                Count       : BOOL;  # action Count runs #
                Run_before  : BOOL;  # step Run in the scan before #
            END_VAR

            # steps in the scan before #
            +--[ ]( Run )---------( )( Run_before )--[ADD]( Run_T, Run_T, SYS.SCAN_TIME )--+

            # transitions #
            +--[ ]( Idle )--[ ]( go )---------------------( )( Idle_to_Run )--(R)( Idle )--+
            +--[ ]( Run )--[CALC]( st1, n / 2 )--[GT]( Run_T, T#2s )--[GT]( st1, 3 )---------------( )( Run_to_Idle )--(R)( Run )--+

            # the steps that they lead to #
            +--[ ]( Idle_to_Run )------------------------[MOV]( Run_T, T#0s )--(S)( Run )--+
            +--[ ]( Run_to_Idle )---------------------------------------------(S)( Idle )--+

            # action Count #
            +--[ ]( Run )--[/]( Run_before )---------------------------------( )( Count )--+

            # action lamp #
            +--[ ]( Run )--[GE]( Run_T, T#500ms )-----------------------------(S)( lamp )--+
            +--[/]( Run )--[ ]( Run_before )----------------------------------(R)( lamp )--+

            # action Count #
            # one more #
            +--[ ]( Count )--------------------------------------------[CALC]( n, n + 1 )--+
        "#]],
    );
}

#[test]
fn what_is_wrong_in_a_chart() {
    for part in [
        "STEP Run: lamp(N) END_STEP",
        "STEP Run: lamp(D); END_STEP",
        "STEP Run: lamp(); END_STEP",
        "STEP Run: n(N); END_STEP",
        "STEP Run: lamp(X); END_STEP",
        "TRANSITION FROM Idle TO Gone := lamp; END_TRANSITION",
        "TRANSITION FROM Idle TO Idle := Gone.X; END_TRANSITION",
        "TRANSITION FROM Idle TO Idle : LD lamp END_TRANSITION",
        "ACTION Set: Idle.X := TRUE; END_ACTION STEP Run: Set(N); END_STEP",
        "ACTION lamp: n := 1; END_ACTION",
        "STEP lamp: END_STEP",
        "lamp := TRUE;",
        "STEP Run:",
    ] {
        let text = format!(
            "PROGRAM Main VAR lamp : BOOL; n : INT; END_VAR\nINITIAL_STEP Idle: END_STEP\n{part}\nEND_PROGRAM\n"
        );
        let read = super::program::read(&text, Dialect::Iec, &[]).expect("it is Structured Text");
        let told = read
            .report
            .entries
            .iter()
            .filter(|entry| entry.outcome != ladder_notation::Outcome::Translated);
        assert!(told.count() > 0, "{part}");
    }
}
