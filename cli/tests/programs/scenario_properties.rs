//! `ladder test` watches the properties of its files

use crate::scenarios::check;
use expect_test::expect;

const VIOLATES: &str = "\
program motor.clad
step 20ms

assume not (start and stop)

property \"who lets go of start stops the motor\"
when run: start

within 30ms of rises(start): falls(start)

possible stop and run

scenario \"the seal-in holds\"
start   _-___
stop    ____-
run  => _---_

scenario \"it is pushed all the time\"
start   _--
run  => _--
";

const OUTSIDE: &str = "\
program motor.clad

assume not (start and stop)
property \"it runs with start\"
always run = start

scenario \"both at once, and then another thing that is not promised\"
start   _--_
stop    __-_
run  => _-__
";

#[test]
fn a_violated_property_fails_the_scenario_and_is_drawn() {
    check(
        &[("motor.ladder-test", VIOLATES)],
        &["test", "motor.ladder-test"],
        expect![[r#"
            exit status 1
            -- stdout
            motor.ladder-test
              FAIL  the seal-in holds
                    start  _-___
                    stop   ____-
                    run    _---_
                             ^^
                    the property "who lets go of start stops the motor" is violated in scan 4 (step 2, at 40ms); 4 scans violate it
                    at motor.ladder-test:13:10
              FAIL  it is pushed all the time
                    start  _--
                             ^
                    the property "within 30ms of rises(start): falls(start)" is violated in scan 5 (step 2, at 50ms)
                    at motor.ladder-test:18:10
                    3 properties watched; ladder prove motor.ladder-test decides them for all runs

            2 scenarios in 1 file: 0 passed, 2 failed, in T s.
        "#]],
    );
}

#[test]
fn machines_are_told_of_violated_properties() {
    let files = [("motor.ladder-test", VIOLATES)];
    check(
        &files,
        &["test", "motor.ladder-test", "--format", "json"],
        expect![[r#"
        exit status 1
        -- stdout
        {"files": [
        {"file":"motor.ladder-test","program":"motor.clad","seconds":T,"errors":[],"scenarios":[{"name":"the seal-in holds","line":13,"column":10,"passed":false,"steps":5,"scans":10,"seconds":T,"differences":[],"violations":[{"property":"who lets go of start stops the motor","line":6,"column":10,"scan":4,"steps":[2,3],"message":"the property \"who lets go of start stops the motor\" is violated in scan 4 (step 2, at 40ms); 4 scans violate it"}],"faults":[],"diagram":"start  _-___\nstop   ____-\nrun    _---_\n         ^^\nthe property \"who lets go of start stops the motor\" is violated in scan 4 (step 2, at 40ms); 4 scans violate it"},{"name":"it is pushed all the time","line":18,"column":10,"passed":false,"steps":3,"scans":6,"seconds":T,"differences":[],"violations":[{"property":"within 30ms of rises(start): falls(start)","line":9,"column":1,"scan":5,"steps":[2],"message":"the property \"within 30ms of rises(start): falls(start)\" is violated in scan 5 (step 2, at 50ms)"}],"faults":[],"diagram":"start  _--\n         ^\nthe property \"within 30ms of rises(start): falls(start)\" is violated in scan 5 (step 2, at 50ms)"}]}
        ],
        "summary": {"files":1,"passed":0,"failed":2,"not_run":0,"seconds":T}}
    "#]],
    );
    check(
        &files,
        &["test", "motor.ladder-test", "--format", "junit"],
        expect![[r#"
        exit status 1
        -- stdout
        <?xml version="1.0" encoding="UTF-8"?>
        <testsuites name="ladder test" tests="2" failures="2" errors="0" time="T">
          <testsuite name="motor.ladder-test" tests="2" failures="2" errors="0" skipped="0" time="T" file="motor.ladder-test">
            <testcase name="the seal-in holds" classname="motor.ladder-test" time="T" file="motor.ladder-test" line="13">
              <failure message="the property &quot;who lets go of start stops the motor&quot; is violated in scan 4 (step 2, at 40ms); 4 scans violate it" type="scenario">start  _-___
        stop   ____-
        run    _---_
                 ^^
        the property &quot;who lets go of start stops the motor&quot; is violated in scan 4 (step 2, at 40ms); 4 scans violate it</failure>
            </testcase>
            <testcase name="it is pushed all the time" classname="motor.ladder-test" time="T" file="motor.ladder-test" line="18">
              <failure message="the property &quot;within 30ms of rises(start): falls(start)&quot; is violated in scan 5 (step 2, at 50ms)" type="scenario">start  _--
                 ^
        the property &quot;within 30ms of rises(start): falls(start)&quot; is violated in scan 5 (step 2, at 50ms)</failure>
            </testcase>
          </testsuite>
        </testsuites>
    "#]],
    );
    check(
        &files,
        &["test", "motor.ladder-test", "--format", "github"],
        expect![[r#"
        exit status 1
        -- stdout
        ::error file=motor.ladder-test,line=13,col=10,endColumn=29,title=the seal-in holds::the property "who lets go of start stops the motor" is violated in scan 4 (step 2, at 40ms); 4 scans violate it%0A%0Astart  _-___%0Astop   ____-%0Arun    _---_%0A         ^^%0Athe property "who lets go of start stops the motor" is violated in scan 4 (step 2, at 40ms); 4 scans violate it
        ::error file=motor.ladder-test,line=18,col=10,endColumn=37,title=it is pushed all the time::the property "within 30ms of rises(start): falls(start)" is violated in scan 5 (step 2, at 50ms)%0A%0Astart  _--%0A         ^%0Athe property "within 30ms of rises(start): falls(start)" is violated in scan 5 (step 2, at 50ms)
        2 scenarios in 1 file: 0 passed, 2 failed
    "#]],
    );
}

#[test]
fn what_is_outside_of_what_is_assumed_is_said_and_not_watched() {
    let files = [("motor.ladder-test", OUTSIDE)];
    check(
        &files,
        &["test", "motor.ladder-test"],
        expect![[r#"
        exit status 0
        -- stdout
        motor.ladder-test
          ok    both at once, and then another thing that is not promised
                outside of what is assumed from scan 2 (at 20ms) on, where `not (start and stop)` does not hold: the properties are not watched from there
                1 property watched; ladder prove motor.ladder-test decides it for all runs

        1 scenario in 1 file: 1 passed, in T s.
    "#]],
    );
    check(
        &files,
        &["test", "motor.ladder-test", "--format", "json"],
        expect![[r#"
        exit status 0
        -- stdout
        {"files": [
        {"file":"motor.ladder-test","program":"motor.clad","seconds":T,"errors":[],"scenarios":[{"name":"both at once, and then another thing that is not promised","line":7,"column":10,"passed":true,"steps":4,"scans":4,"seconds":T,"differences":[],"outside":"outside of what is assumed from scan 2 (at 20ms) on, where `not (start and stop)` does not hold: the properties are not watched from there","faults":[]}]}
        ],
        "summary": {"files":1,"passed":1,"failed":0,"not_run":0,"seconds":T}}
    "#]],
    );
    check(
        &files,
        &["test", "motor.ladder-test", "--format", "junit"],
        expect![[r#"
        exit status 0
        -- stdout
        <?xml version="1.0" encoding="UTF-8"?>
        <testsuites name="ladder test" tests="1" failures="0" errors="0" time="T">
          <testsuite name="motor.ladder-test" tests="1" failures="0" errors="0" skipped="0" time="T" file="motor.ladder-test">
            <testcase name="both at once, and then another thing that is not promised" classname="motor.ladder-test" time="T" file="motor.ladder-test" line="7">
              <system-err>outside of what is assumed from scan 2 (at 20ms) on, where `not (start and stop)` does not hold: the properties are not watched from there</system-err>
            </testcase>
          </testsuite>
        </testsuites>
    "#]],
    );
    check(
        &files,
        &["test", "motor.ladder-test", "--format", "github"],
        expect![[r#"
        exit status 0
        -- stdout
        ::warning file=motor.ladder-test,line=7,col=10,endColumn=69,title=both at once%2C and then another thing that is not promised::outside of what is assumed from scan 2 (at 20ms) on, where `not (start and stop)` does not hold: the properties are not watched from there
        1 scenario in 1 file: 1 passed, 0 failed
    "#]],
    );
}
