//! Scenes on the command line: `ladder render`, `ladder check`, and the pictures of `ladder test`.

use crate::harness::Folder;
use expect_test::expect;

const PROGRAM: &str = "\
VAR_INPUT  low, high : BOOL;  END_VAR
VAR_OUTPUT pump      : BOOL;  END_VAR

+--[/]( low )-----------------------------------------------------(S)( pump )--+
+--[ ]( high )----------------------------------------------------(R)( pump )--+
";

const TANK: &str = "\
VAR_INPUT  pump      : BOOL;  END_VAR
VAR_OUTPUT low, high : BOOL;  END_VAR
VAR        level     : INT;   END_VAR

+--[ ]( pump )-----------------------------------------[ADD]( level, level, 1 )--+
+--[GE]( level, 2 )------------------------------------------------( )( low )--+
+--[GE]( level, 6 )-----------------------------------------------( )( high )--+
";

const SCENE: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" xmlns:l="https://ladder.example/scene" viewBox="0 0 9 9" l:plant="tank.clad">
  <title>Tank</title>
  <desc>A tank with a pump</desc>
  <rect height="6" l:scale-y="plant.level / 6.0" l:alt="water"/>
  <circle r="1" fill="grey" l:fill="pump: green; grey" l:alt="pump"/>
  <text l:text="plant.level" l:unit="l">0</text>
</svg>
"#;

fn tank() -> Folder {
    Folder::with(&[
        ("pump.clad", PROGRAM),
        ("tank.clad", TANK),
        ("pump.scene.svg", SCENE),
    ])
}

#[test]
fn a_still_at_the_start_with_values_and_after_scans() {
    let folder = tank();
    let rest = folder.ladder(&["render", "pump.scene.svg"]);
    expect![[r#"
        exit status 0
        -- stdout
        <?xml version="1.0" encoding="UTF-8"?>
        <!-- drawn by ladder -->
        <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9" role="group" aria-label="Tank">
        <title>Tank</title>
        <desc>A tank with a pump</desc>
        <g aria-label="water" role="img" transform="translate(0 0) scale(1 0) translate(0 0)">
        <rect height="6"></rect></g>
        <circle r="1" fill="grey" aria-label="pump, off" role="img"></circle>
        <text>0 l</text></svg>
    "#]]
    .assert_eq(&rest.to_string());
    folder.write("values.csv", b"name,value\nplant.level,3\npump,1\nnobody,1\n");
    let tags = folder.ladder(&[
        "render",
        "pump.scene.svg",
        "--tags",
        "values.csv",
        "-o",
        "still.svg",
    ]);
    expect![[r#"
        exit status 0
        -- stderr
        note: values.csv: line 4: the program has no nobody
    "#]]
    .assert_eq(&tags.to_string());
    let still = folder.read("still.svg");
    assert!(
        still.contains("scale(1 0.5)") && still.contains("fill=\"green\"") && still.contains(">3 l<"),
        "{still}"
    );
    // One that a command has made is replaced.
    let scans = folder.ladder(&["render", "pump.scene.svg", "--scans", "5", "-o", "still.svg"]);
    assert_eq!(scans.status, Some(0), "{scans}");
    assert!(
        folder.read("still.svg").contains(">4 l<"),
        "{}",
        folder.read("still.svg")
    );
    let pixels = folder.ladder(&["render", "pump.scene.svg", "-o", "still.png"]);
    assert_eq!(pixels.status, Some(0), "{pixels}");
}

#[test]
fn what_has_no_effect_is_refused() {
    let folder = tank();
    for (arguments, message) in [
        (
            &["render", "pump.scene.svg", "-o", "a.pdf"][..],
            "drawn as SVG or PNG",
        ),
        (&["render", "pump.clad", "--tags", "a.csv"], "about a scene"),
        (
            &["render", "pump.scene.svg", "--tags", "a.csv", "--scans", "3"],
            "give one of the two",
        ),
        (
            &["render", "pump.scene.svg", "-o", "pump.scene.svg"],
            "belongs to a program",
        ),
        (&["render", "pump.scene.svg", "--set", "low=1"], "about a run"),
        (&["render", "none.scene.svg"], "none.scene.svg"),
    ] {
        let run = folder.ladder(arguments);
        assert_eq!(run.status, Some(2), "{run}");
        assert!(run.stderr.contains(message), "{run}");
    }
    assert_eq!(folder.read("pump.scene.svg"), SCENE);
}

#[test]
fn what_is_wrong_is_checked_and_drawn_as_far_as_it_goes() {
    let folder = tank();
    let wrong = SCENE
        .replace("plant.level / 6.0", "plant.height")
        .replace("<circle", "<script/><circle");
    folder.write("pump.scene.svg", wrong.as_bytes());
    let check = folder.ladder(&["check", "--format", "concise", "pump.scene.svg"]);
    expect![[r#"
        exit status 1
        -- stdout
        pump.scene.svg:4:31: error[bad-scene] plant has no tag `height`
        pump.scene.svg:5:3: warning[bad-scene] `script` is left out, with what is in it
        Checked 1 file: 1 error, 1 warning.
    "#]]
    .assert_eq(&check.to_string());
    let render = folder.ladder(&["render", "pump.scene.svg", "-o", "still.svg"]);
    assert_eq!(render.status, Some(1), "{render}");
    assert!(folder.read("still.svg").contains(">0 l<"));

    folder.write(
        "pump.scene.svg",
        SCENE.replace("tank.clad", "../tank.clad").as_bytes(),
    );
    let outside = folder.ladder(&["check", "--format", "concise", "pump.scene.svg"]);
    assert_eq!(outside.status, Some(2), "{outside}");
    assert!(outside.stdout.contains("leads out of the workspace"), "{outside}");
}

/// The sketch that scenes were designed with, and the machine that the playground begins with.
#[test]
fn the_scenes_of_the_project_hold_no_errors() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for (machine, scene) in [
        ("tests/corpus/plants/conveyor", "conveyor.scene.svg"),
        ("playground/machines/water_tank", "water_tank.scene.svg"),
    ] {
        let folder = Folder::with(&[]);
        for entry in std::fs::read_dir(root.join(machine)).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy();
            folder.write(&name, &std::fs::read(&path).unwrap());
        }
        let check = folder.ladder(&["check", "--deny", "warnings", scene]);
        assert_eq!(check.status, Some(0), "{check}");
        let still = folder.ladder(&["render", scene, "--scans", "100"]);
        assert_eq!(still.status, Some(0), "{still}");
    }
    let folder = root.join("playground/machines/water_tank");
    let tests = Folder::with(&[]).ladder(&["test", &folder.display().to_string()]);
    assert_eq!(tests.status, Some(0), "{tests}");
}

#[test]
fn the_plant_of_the_settings_is_that_of_scenes() {
    let folder = tank();
    folder.write(
        "pump.scene.svg",
        SCENE.replace(" l:plant=\"tank.clad\"", "").as_bytes(),
    );
    let alone = folder.ladder(&["check", "pump.scene.svg"]);
    assert_eq!(alone.status, Some(1), "{alone}");
    folder.write("ladder.toml", b"[simulate]\nplant = \"tank.clad\"\n");
    let check = folder.ladder(&["check", "pump.scene.svg"]);
    assert_eq!(check.status, Some(0), "{check}");
}

#[test]
fn a_failed_scenario_shows_the_machine_in_its_step() {
    let folder = tank();
    let scenarios = "program pump.clad\nplant tank.clad\n\nscenario \"it fills\"\npump => _------__\n\nscenario \"well\"\npump => .-\n";
    folder.write("pump.ladder-test", scenarios.as_bytes());
    let run = folder.ladder(&["test", "pump.ladder-test", "--pictures", "failed"]);
    assert_eq!(run.status, Some(1), "{run}");
    assert!(run.stdout.contains("picture: failed/pump.1.pump.svg"), "{run}");
    assert_eq!(folder.names_in("failed"), ["pump.1.pump.svg"]);
    let still = folder.read("failed/pump.1.pump.svg");
    assert!(still.contains(">0 l<"), "{still}");
    for (format, named) in [
        ("json", "\"failed/pump.1.pump.svg\""),
        (
            "junit",
            "<system-out>[[ATTACHMENT|failed/pump.1.pump.svg]]</system-out>",
        ),
    ] {
        let run = [
            "test",
            "pump.ladder-test",
            "--pictures",
            "failed",
            "--format",
            format,
        ];
        let run = folder.ladder(&run);
        assert!(run.stdout.contains(named), "{run}");
    }
}
