//! The sentences of LANGUAGE §5.7, one by one; `user_blocks.rs` has the larger cases.

use crate::support::check;
use expect_test::expect;
use ladder_analysis::analyze;
use ladder_simulator::{Options, Simulation};
use std::sync::Arc;

/// The rules that find something wrong in a text.
fn found(text: &str) -> Vec<String> {
    let analysis = analyze(&Arc::new(ladder_syntax::parse(text)), "test.clad");
    let rules = analysis.diagnostics().iter();
    rules.map(|found| found.rule.to_string()).collect()
}

#[test]
fn the_header_shows_the_shape_and_one_name_has_one() {
    for (header, use_) in [("[$B]", "[$B]"), ("($B)", "($B)"), ("<$B>", "<$B>")] {
        let text = format!(
            "FUNCTION_BLOCK {header}\nVAR_GLOBAL n : INT; END_VAR\n+--[ADD]( n, n, 1 )--+\nEND_FUNCTION_BLOCK\n+--{use_}--+\n"
        );
        check(
            &text,
            "3",
            "n",
            expect![[r#"
            n  1 2 3
        "#]],
        );
    }
    let two = "FUNCTION_BLOCK [$B]\n+--(S)( ENO )--+\nEND_FUNCTION_BLOCK\nFUNCTION_BLOCK ($B)\n+--(S)( ENO )--+\nEND_FUNCTION_BLOCK\n";
    assert_eq!(found(two), ["duplicate-block"]);
    let other = "FUNCTION_BLOCK [$B]\n+--(S)( ENO )--+\nEND_FUNCTION_BLOCK\n+--($B)--+\n";
    assert_eq!(found(other), ["wrong-shape"]);
}

#[test]
fn operands_stand_in_the_order_of_their_declaration_whatever_their_kind() {
    check(
        "FUNCTION_BLOCK [$B]\nVAR_OUTPUT sum : INT; END_VAR\nVAR_IN_OUT n : INT; END_VAR\n\
         VAR_INPUT a : INT; END_VAR\nVAR_OUTPUT twice : INT; END_VAR\n\
         +--[ADD]( sum, a, n )--[MUL]( twice, sum, 2 )--[ADD]( n, n, 1 )--+\nEND_FUNCTION_BLOCK\n\
         VAR s, m, t : INT; END_VAR\n\
         +--[$B]( s, m, 10, t )--+\n",
        "3",
        "s m t",
        expect![[r#"
            s  10 11 12
            m  1 2 3
            t  20 22 24
        "#]],
    );
}

#[test]
fn inputs_with_defaults_are_left_out_from_the_right_or_all_given_by_name() {
    check(
        "FUNCTION_BLOCK [$B]\nVAR_INPUT a : INT := 1; b : INT := 20; c : INT := 300; END_VAR\nVAR_OUTPUT s : INT; END_VAR\n\
         +--[ADD]( s, a, b, c )--+\nEND_FUNCTION_BLOCK\n\
         VAR w, x, y, z : INT; END_VAR\n\
         +--[$B]( s => w )--[$B]( 2, s => x )--[$B]( 2, 30, s => y )--[$B]( c := 0, s => z )--+\n",
        "1",
        "w x y z",
        expect![[r#"
            w  321
            x  322
            y  332
            z  21
        "#]],
    );
    let needed = "FUNCTION_BLOCK [$B]\nVAR_INPUT a : INT; b : INT := 2; END_VAR\n+--[EQ]( a, b )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n";
    assert_eq!(
        found(&format!("{needed}+--[$B]( b := 3 )--( )( y )--+\n")),
        ["bad-arity"]
    );
    assert_eq!(found(&format!("{needed}+--[$B]( 3 )--( )( y )--+\n")), [""; 0]);
}

#[test]
fn the_body_runs_whenever_the_block_is_reached() {
    check(
        "FUNCTION_BLOCK [$B]\nVAR_OUTPUT runs, under : INT; END_VAR\n\
         +--[ADD]( runs, runs, 1 )--+\n+--[ ]( EN )--[ADD]( under, under, 1 )--+\nEND_FUNCTION_BLOCK\n\
         VAR_INPUT en, over : BOOL; END_VAR\nVAR r, u : INT; END_VAR\n\
         +--[ ]( over )--<JMP>( after )--+\n\
         +--[ ]( en )--[$B]( r, u )--+\n\
         +--<LBL>( after )--+\n",
        "en _--_\nover __-_",
        "r u",
        expect![[r#"
            r  1 2 2 3
            u  0 1 1 1
        "#]],
    );
}

#[test]
fn eno_is_en_before_the_body_and_what_the_body_leaves_in_it_is_the_power() {
    check(
        "FUNCTION_BLOCK [$Keep]\nVAR n : INT; END_VAR\n+--[ADD]( n, n, 1 )--+\nEND_FUNCTION_BLOCK\n\
         FUNCTION_BLOCK [$High]\n+--(S)( ENO )--+\nEND_FUNCTION_BLOCK\n\
         FUNCTION_BLOCK [$Not]\n+--[/]( EN )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\
         VAR_INPUT en : BOOL; END_VAR\nVAR k, h, n : BOOL; END_VAR\n\
         +--[ ]( en )--[$Keep]--( )( k )--+\n+--[ ]( en )--[$High]--( )( h )--+\n+--[ ]( en )--[$Not]--( )( n )--+\n",
        "en _-_",
        "k h n",
        expect![[r#"
            k  _-_
            h  ---
            n  -_-
        "#]],
    );
}

#[test]
fn state_belongs_to_each_place_also_in_a_loop_or_a_function() {
    check(
        "FUNCTION_BLOCK [$Count]\nVAR n : INT; END_VAR\nVAR_OUTPUT o : INT; END_VAR\n\
         +--[ADD]( n, n, 1 )--[MOV]( o, n )--+\nEND_FUNCTION_BLOCK\n\
         VAR a, b, c : INT; END_VAR\n\
         +--[$Count]( a )--<FOR>( 2 )--+\n+--[$Count]( b )--<NEXT>--+\n+--<CALL>( f )--<CALL>( f )--+\n\
         +--<FUN>( f )--[$Count]( c )--+\n",
        "3",
        "a b c",
        expect![[r#"
            a  1 2 3
            b  2 4 6
            c  2 4 6
        "#]],
    );
}

#[test]
fn a_body_sees_its_own_tags_globals_system_tags_and_addresses_nothing_else() {
    check(
        "VAR_GLOBAL shared : INT := 5; END_VAR\nVAR own : INT := 7; END_VAR\n\
         FUNCTION_BLOCK [$B]\nVAR own : INT; END_VAR\nVAR_OUTPUT o, s : INT; END_VAR\n\
         +--[ADD]( own, own, 1 )--[MOV]( o, own )--[MOV]( s, shared )--[MOV]( %MW3, 9 )--+\n\
         +--[ ]( SYS.FIRST_SCAN )--[ ]( %IX0.0 )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\
         VAR o, s, w : INT; y : BOOL; END_VAR\n\
         +--[$B]( o, s )--( )( y )--+\n+--[MOV]( w, %MW3 )--+\n",
        "%IX0.0 --",
        "o s w own y",
        expect![[r#"
            o    1 2
            s    5 5
            w    9 9
            own  7 7
            y    -_
        "#]],
    );
    let hidden = "VAR hidden : BOOL; END_VAR\nFUNCTION_BLOCK [$B]\n+--[ ]( hidden )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n";
    assert_eq!(found(hidden), ["undeclared-tag"]);
}

#[test]
fn a_global_that_a_body_introduces_is_one_tag_for_all_places() {
    check(
        "FUNCTION_BLOCK [$B]\nVAR_GLOBAL n : INT := 10; END_VAR\n+--[ADD]( n, n, 1 )--+\nEND_FUNCTION_BLOCK\n\
         FUNCTION_BLOCK [$C]\nVAR_GLOBAL n : INT := 10; END_VAR\n+--[ADD]( n, n, 100 )--+\nEND_FUNCTION_BLOCK\n\
         VAR m : INT; END_VAR\n\
         +--[$B]--[$B]--[$C]--[MOV]( m, n )--+\n",
        "2",
        "n m",
        expect![[r#"
            n  112 214
            m  112 214
        "#]],
    );
}

#[test]
fn a_block_never_uses_itself_not_even_through_others() {
    let direct = "FUNCTION_BLOCK [$A]\n+--[$A]--( )( ENO )--+\nEND_FUNCTION_BLOCK\n";
    assert_eq!(found(direct), ["recursive-block"]);
    let others = "FUNCTION_BLOCK [$A]\n+--[$B]--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\
                  FUNCTION_BLOCK [$B]\n+--[$A]--( )( ENO )--+\nEND_FUNCTION_BLOCK\n";
    assert_eq!(found(others), ["recursive-block"]);
}

#[test]
fn every_body_may_hold_labels_jumps_and_calls() {
    for shape in ["[$B]", "($B)", "<$B>"] {
        let text = format!(
            "FUNCTION_BLOCK {shape}\nVAR_GLOBAL n : INT; END_VAR\n\
             +--<JMP>( here )--+\n+--[ADD]( n, n, 1000 )--+\n+--<LBL>( here )--<CALL>( f )--[ADD]( n, n, 1 )--+\n\
             END_FUNCTION_BLOCK\n\
             +--{shape}--+\n+--<LBL>( here )--[ADD]( n, n, 100 )--+\n+--<FUN>( f )--[ADD]( n, n, 10 )--+\n"
        );
        check(
            &text,
            "1",
            "n",
            expect![[r#"
            n  111
        "#]],
        );
    }
}

#[test]
fn in_logical_and_coil_bodies_end_and_fun_are_errors_and_so_is_a_jump_outward() {
    for shape in ["[$B]", "($B)"] {
        let body = |rung: &str| {
            format!(
                "FUNCTION_BLOCK {shape}\n{rung}\nEND_FUNCTION_BLOCK\n+--{shape}--( )( y )--+\n+--<LBL>( out )--( )( z )--+\n"
            )
        };
        assert_eq!(found(&body("+--[ ]( EN )--<END>--+")), ["wrong-place"], "{shape}");
        assert_eq!(
            found(&body("+--<FUN>( f )--(S)( ENO )--+")),
            ["wrong-place"],
            "{shape}"
        );
        assert_eq!(
            found(&body("+--[ ]( EN )--<JMP>( out )--+")),
            ["unknown-label"],
            "{shape}"
        );
        // <RET> ends the body.
        let text = body("+--[ ]( EN )--<RET>--+\n+--(R)( ENO )--+");
        check(
            &text,
            "1",
            "y z",
            expect![[r#"
            y  -
            z  -
        "#]],
        );
    }
}

#[test]
fn outputs_are_copied_out_before_a_jump_a_return_or_an_end_takes_effect() {
    for flow in ["<JMP>( out )", "<RET>", "<END>"] {
        let text = format!(
            "FUNCTION_BLOCK <$B>\nVAR_OUTPUT o : INT; END_VAR\n\
             +--[ADD]( o, o, 1 )--{flow}--[ADD]( o, o, 10 )--+\nEND_FUNCTION_BLOCK\n\
             VAR s, n, m : INT; END_VAR\n\
             +--<$B>( s )--[ADD]( n, n, 1 )--+\n+--[ADD]( n, n, 10 )--+\n+--<LBL>( out )--[MOV]( m, s )--+\n"
        );
        let expected = match flow {
            "<JMP>( out )" => expect![[r#"
                s  1 2
                n  0 0
                m  1 2
            "#]],
            "<RET>" => expect![[r#"
                s  1 2
                n  0 0
                m  0 0
            "#]],
            _ => expect![[r#"
                s  1
                n  0
                m  0
            "#]],
        };
        check(&text, "2", "s n m", expected);
    }
}

#[test]
fn fun_in_the_body_of_a_function_shape_defines_a_function_of_the_workspace() {
    check(
        "FUNCTION_BLOCK <$Kit>\nVAR inner : INT; END_VAR\nVAR_OUTPUT o : INT; END_VAR\n\
         +--[ADD]( inner, inner, 1 )--[MOV]( o, inner )--<CALL>( bump )--+\n\
         +--<FUN>( bump )--[ADD]( total, total, 10 )--+\n\
         +--[ ]( on )--<RET>--+\n\
         +--[ADD]( total, total, 100 )--+\n\
         END_FUNCTION_BLOCK\n\
         VAR_INPUT on : BOOL; END_VAR\nVAR total, k : INT; END_VAR\n\
         +--<$Kit>( k )--<CALL>( bump )--+\n\
         +--[ADD]( total, total, 1 )--+\n",
        "on __-",
        "total k",
        expect![[r#"
            total  221 442 463
            k      1 2 3
        "#]],
    );
    // It ends with the body; what is after the definition is the program's.
    let after = "FUNCTION_BLOCK <$Kit>\n+--<FUN>( f )--( )( x )--+\nEND_FUNCTION_BLOCK\n+--( )( y )--+\n";
    check(
        after,
        "1",
        "y x",
        expect![[r#"
        y  -
        x  _
    "#]],
    );
}

#[test]
fn blocks_that_multiply_are_counted_before_they_are_compiled() {
    let refused = |levels: usize| {
        let mut text = "FUNCTION_BLOCK [$B0]\n+--[ ]( EN )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n".to_owned();
        for level in 1..=levels {
            let inner = level - 1;
            text +=
                &format!("FUNCTION_BLOCK [$B{level}]\n+--[$B{inner}]--[$B{inner}]--+\nEND_FUNCTION_BLOCK\n");
        }
        text += &format!("+--[$B{levels}]--+\n");
        let analysis = analyze(&Arc::new(ladder_syntax::parse(&text)), "test.clad");
        let program = analysis.program().expect("no errors").clone();
        let made = Simulation::new(program, Options::default());
        made.err().map(|error| error.message)
    };
    assert_eq!(refused(10), None);
    for levels in [20, 64, 99] {
        let message = refused(levels).expect("it is too large");
        assert!(message.contains("blocks inside blocks multiply"), "{message}");
    }
}
