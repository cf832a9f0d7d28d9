//! What `ladder test` writes for other programs.

use crate::harness::{Folder, MOTOR};
use crate::scenarios::{FAILS, PASSES, SHARE, check, without_times};
use expect_test::expect;

#[test]
fn junit() {
    check(
        &[
            ("fails.ladder-test", FAILS),
            ("passes.ladder-test", PASSES),
            ("wrong.ladder-test", "program motor.clad\n"),
        ],
        &["test", ".", "--format", "junit"],
        expect![[r#"
            exit status 1
            -- stdout
            <?xml version="1.0" encoding="UTF-8"?>
            <testsuites name="ladder test" tests="4" failures="1" errors="1" time="T">
              <testsuite name="fails.ladder-test" tests="2" failures="1" errors="0" skipped="0" time="T" file="fails.ladder-test">
                <testcase name="start runs it" classname="fails.ladder-test" time="T" file="fails.ladder-test" line="3"/>
                <testcase name="stop does nothing" classname="fails.ladder-test" time="T" file="fails.ladder-test" line="7">
                  <failure message="run is FALSE in step 3 (at 30ms), TRUE was expected; 3 of 6 steps differ" type="scenario">start            _-____
            stop             ___-__
            run    expected  _-----
                   got       _--___
                                ^^^
            run is FALSE in step 3 (at 30ms), TRUE was expected; 3 of 6 steps differ</failure>
                </testcase>
              </testsuite>
              <testsuite name="passes.ladder-test" tests="1" failures="0" errors="0" skipped="0" time="T" file="passes.ladder-test">
                <testcase name="the seal-in holds after start is let go" classname="passes.ladder-test" time="T" file="passes.ladder-test" line="4"/>
              </testsuite>
              <testsuite name="wrong.ladder-test" tests="1" failures="0" errors="1" skipped="0" time="T" file="wrong.ladder-test">
                <testcase name="wrong.ladder-test:2:1" classname="wrong.ladder-test" time="T" file="wrong.ladder-test" line="2">
                  <error message="there is no scenario in this file" type="bad-scenario">error[bad-scenario]: there is no scenario in this file
             --&gt; wrong.ladder-test:2:1
              |
            2 |
              | ^
              |
              = help: begin one, as in: scenario &quot;the pump starts&quot;</error>
                </testcase>
              </testsuite>
            </testsuites>
        "#]],
    );
}

#[test]
fn json() {
    let folder = Folder::with(&[
        ("motor.clad", MOTOR),
        ("fails.ladder-test", FAILS),
        ("wrong.ladder-test", "program motor.clad\n"),
    ]);
    let run = folder.ladder(&["test", ".", "--format", "json", "--coverage"]);
    assert_eq!((run.status, run.stderr.as_str()), (Some(1), ""));
    let json: serde_json::Value = serde_json::from_str(&run.stdout).expect("JSON");
    let pretty = serde_json::to_string_pretty(&json).expect("JSON");
    expect![[r#"
        {
          "coverage": [
            {
              "coils": {
                "all": 1,
                "exercised": 1
              },
              "contacts": {
                "all": 3,
                "exercised": 3
              },
              "file": "motor.clad",
              "networks": {
                "all": 1,
                "exercised": 1
              },
              "parts": [
                {
                  "column": 7,
                  "kind": "contact",
                  "line": 1,
                  "off": true,
                  "on": true
                },
                {
                  "column": 24,
                  "kind": "contact",
                  "line": 1,
                  "off": true,
                  "on": true
                },
                {
                  "column": 68,
                  "kind": "coil",
                  "line": 1,
                  "off": true,
                  "on": true
                },
                {
                  "column": 7,
                  "kind": "contact",
                  "line": 2,
                  "off": true,
                  "on": true
                }
              ],
              "rungs": [
                {
                  "line": 1,
                  "scans": 9
                },
                {
                  "line": 2,
                  "scans": 9
                }
              ]
            }
          ],
          "files": [
            {
              "errors": [],
              "file": "fails.ladder-test",
              "program": "motor.clad",
              "scenarios": [
                {
                  "column": 10,
                  "differences": [],
                  "faults": [],
                  "line": 3,
                  "name": "start runs it",
                  "passed": true,
                  "scans": 3,
                  "seconds":T,
                  "steps": 3
                },
                {
                  "column": 10,
                  "diagram": "start            _-____\nstop             ___-__\nrun    expected  _-----\n       got       _--___\n                    ^^^\nrun is FALSE in step 3 (at 30ms), TRUE was expected; 3 of 6 steps differ",
                  "differences": [
                    {
                      "column": 12,
                      "line": 10,
                      "message": "run is FALSE in step 3 (at 30ms), TRUE was expected; 3 of 6 steps differ",
                      "places": [
                        {
                          "column": 12,
                          "end_column": 15,
                          "line": 10
                        }
                      ],
                      "steps": [
                        3,
                        4,
                        5
                      ],
                      "tag": "run"
                    }
                  ],
                  "faults": [],
                  "line": 7,
                  "name": "stop does nothing",
                  "passed": false,
                  "scans": 6,
                  "seconds":T,
                  "steps": 6
                }
              ],
              "seconds":T
            },
            {
              "errors": [
                {
                  "column": 1,
                  "end_column": 1,
                  "end_line": 2,
                  "file": "wrong.ladder-test",
                  "help": "begin one, as in: scenario \"the pump starts\"",
                  "line": 2,
                  "message": "there is no scenario in this file",
                  "rule": "bad-scenario",
                  "severity": "error"
                }
              ],
              "file": "wrong.ladder-test",
              "program": "motor.clad",
              "scenarios": [],
              "seconds":T
            }
          ],
          "summary": {
            "failed": 1,
            "files": 2,
            "not_run": 1,
            "passed": 1,
            "seconds":T
          }
        }"#]].assert_eq(&without_times(&pretty.replace("\"seconds\": ", "\"seconds\":")));
}

#[test]
fn github() {
    check(
        &[
            ("fails.ladder-test", FAILS),
            ("share.clad", SHARE),
            (
                "share.ladder-test",
                "program share.clad\nscenario \"a\"\nparts 0\nshare => 0\n",
            ),
            ("wrong.ladder-test", "program motor.clad\n"),
        ],
        &["test", ".", "--format", "github"],
        expect![[r#"
            exit status 1
            -- stdout
            ::error file=fails.ladder-test,line=10,col=12,endColumn=13,title=stop does nothing::run is FALSE in step 3 (at 30ms), TRUE was expected; 3 of 6 steps differ%0A%0Astart            _-____%0Astop             ___-__%0Arun    expected  _-----%0A       got       _--___%0A                    ^^^%0Arun is FALSE in step 3 (at 30ms), TRUE was expected; 3 of 6 steps differ
            ::warning file=share.clad,line=3,col=4,endColumn=29,title=fault in "a"::division by zero: nothing was written; check the divisor before this block
            ::error file=wrong.ladder-test,line=2,col=1,endColumn=1,title=bad-scenario::there is no scenario in this file%0Abegin one, as in: scenario "the pump starts"
            3 scenarios in 3 files: 2 passed, 1 failed, 1 file not run for errors
        "#]],
    );
}
