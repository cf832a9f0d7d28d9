//! The rows of scenarios.

use super::check;
use expect_test::expect;

#[test]
fn scenarios_follow() {
    let plant = "%% lib.clad\nVAR_GLOBAL total : DINT; END_VAR\n+--<FUN>( f )--( )( lamp )--+\n\
        %% main.clad\n+--[ ]( start )-------<CALL>( f )--[TON]( t, 5s )--( )( run )--+\n\
        %% motor.ladder-test\nprogram main.clad\nstep 100ms\n\nscenario \"starts\"\nstart     _-_\nrun    => _--\nt.ET   => 0s 1s 2s\n\
        lib.lamp => _-_\n\nscenario \"other\"\ntotal => 1 2 3\n\
        %% other.ladder-test\nprogram other.clad\nscenario \"x\"\nrun => _-\n";
    let at = |place: &str| plant.replacen(place, &format!("{place}$0"), 1);
    check(
        &at("( )( run"),
        "motor_runs",
        expect![[r#"
        %% main.clad
        +--[ ]( start )----------------<CALL>( f )--[TON]( t, 5s )--( )( motor_runs )--+
        %% motor.ladder-test
        program main.clad
        step 100ms

        scenario "starts"
        start         _-_
        motor_runs => _--
        t.ET       => 0s 1s 2s
        lib.lamp     => _-_

        scenario "other"
        total => 1 2 3
    "#]],
    );
    check(
        &at("[TON]( t"),
        "q",
        expect![[r#"
        %% main.clad
        +--[ ]( start )-------<CALL>( f )--[TON]( q, 5s )--( )( run )--+
        %% motor.ladder-test
        program main.clad
        step 100ms

        scenario "starts"
        start     _-_
        run    => _--
        q.ET   => 0s 1s 2s
        lib.lamp => _-_

        scenario "other"
        total => 1 2 3
    "#]],
    );
    check(
        &at("( )( lamp"),
        "l",
        expect![[r#"
            %% lib.clad
            VAR_GLOBAL total : DINT; END_VAR
            +--<FUN>( f )--------------------------------------------------------( )( l )--+
            %% motor.ladder-test
            program main.clad
            step 100ms

            scenario "starts"
            start     _-_
            run    => _--
            t.ET   => 0s 1s 2s
            lib.l    => _-_

            scenario "other"
            total => 1 2 3
        "#]],
    );
    check(
        &at("VAR_GLOBAL total"),
        "a_longer_name",
        expect![[r#"
        %% lib.clad
        VAR_GLOBAL a_longer_name : DINT; END_VAR
        +--<FUN>( f )--( )( lamp )--+
        %% motor.ladder-test
        program main.clad
        step 100ms

        scenario "starts"
        start     _-_
        run    => _--
        t.ET   => 0s 1s 2s
        lib.lamp => _-_

        scenario "other"
        a_longer_name => 1 2 3
    "#]],
    );
}
