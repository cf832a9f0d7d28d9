//! Click programs that people had trouble with: what `convert` says of each, and that what it writes has no errors that it does
//! not tell.

use crate::harness::Folder;
use expect_test::{Expect, expect};
use std::fs;
use std::path::{Path, PathBuf};

fn field(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../tests/corpus/field")
        .join(name)
}

/// The Python files of the field whose names begin so, and what is reported about each.
#[track_caller]
fn check(expected: Expect) {
    let entries = fs::read_dir(field("")).expect("the folder can be read");
    let names = entries.map(|entry| {
        entry
            .expect("an entry")
            .file_name()
            .into_string()
            .expect("a name")
    });
    let mut names: Vec<String> = names
        .filter(|name| name.starts_with("click_") && Path::new(name).extension().is_some_and(|it| it == "py"))
        .collect();
    names.sort_unstable();
    let mut told = String::new();
    for name in names {
        let text = fs::read_to_string(field(&name)).expect("the file can be read");
        let folder = Folder::with(&[(&name, &text)]);
        let run = folder.ladder(&["convert", &name, "-o", "out.clad"]);
        told.push_str(&format!("{} {}", run.status.unwrap_or(-1), run.stderr));
        if run.status == Some(2) {
            continue;
        }
        let checked = folder.ladder(&["check", "out.clad"]);
        assert!(
            checked.status == Some(0) || run.status == Some(1),
            "{name}: {run}{checked}"
        );
        // No finding is about a line of the importer's own.
        for file in ["out.clad", &name] {
            let checked = folder.ladder(&["check", file, "--format", "concise"]);
            assert!(!checked.stdout.contains("suppression-unused"), "{checked}");
        }
    }
    expected.assert_eq(&told);
}

#[test]
fn python() {
    check(expect![[r#"
        0 click_block_ds_dd.py: 3 translated, 0 approximated, 0 refused
        0 click_compare_mixed.py:2:8: warning: click-compare: `df[1] >= ds[1]` compares float32 with int16, and the DSL asks for one type; Click itself compares them as numbers
        click_compare_mixed.py: 3 translated, 0 approximated, 0 refused
        0 click_ds_2_5.py:2:8: warning: click-compare: `ds[1] >= 2.5` compares int16 with float32, and the DSL asks for one type; Click itself compares them as numbers
        click_ds_2_5.py: 3 translated, 0 approximated, 0 refused
        0 click_fill_td.py: 5 translated, 0 approximated, 0 refused
        2 error: click_for_i_unknown.py:3:13: a loop of the DSL counts with `_`: for _ in range(n):
        2 error: click_nested_if_unknown.py:3:9: an `if` inside another is not in the DSL: write all(..) with both
        1 click_nine_parens.py:3:9: refused: calc("(((((((((ds[1] + 1) + 1) + 1) + 1) + 1) + 1) + 1) + 1) + 1)", ds[2]): Click has no more than eight parentheses in one another
        click_nine_parens.py: 2 translated, 0 approximated, 1 refused
        0 click_noise_out_c.py: 3 translated, 0 approximated, 0 refused
        0 click_noise_search.py: 3 translated, 0 approximated, 0 refused
        0 click_pack_ct_dh.py: 5 translated, 0 approximated, 0 refused
        0 click_pack_df_bits.py: 3 translated, 0 approximated, 0 refused
        0 click_pack_df_words.py: 3 translated, 0 approximated, 0 refused
        0 click_pack_t_dh.py: 5 translated, 0 approximated, 0 refused
        0 click_pointer_td.py: 5 translated, 0 approximated, 0 refused
        1 click_pointer_x.py:3:9: error: click-pointer: a pointer does not lead into the bank x
        click_pointer_x.py: 3 translated, 0 approximated, 0 refused
        0 click_search_td.py: 5 translated, 0 approximated, 0 refused
        0 click_setpoint_ctu_big.py:3:9: warning: click-setpoint: 100000 is wider than a set point of the DSL, an int16 or an address of ds; Click's own counters take it
        click_setpoint_ctu_big.py: 3 translated, 0 approximated, 0 refused
        0 click_setpoint_ctu_dd.py:3:9: warning: click-setpoint: dd[1] is wider than a set point of the DSL, an int16 or an address of ds; Click's own counters take it
        click_setpoint_ctu_dd.py: 3 translated, 0 approximated, 0 refused
        0 click_sub_only_unknown.py: 1 translated, 0 approximated, 0 refused
        0 click_sum_ctd.py: 3 translated, 0 approximated, 0 refused
        0 click_sum_td.py: 4 translated, 0 approximated, 0 refused
        0 click_unpack_df_c.py: 3 translated, 0 approximated, 0 refused
        0 click_unpack_df_ds.py: 3 translated, 0 approximated, 0 refused
        1 click_x17.py:2:8: error: click-address: x[17] does not exist: x has 1 to 16, 21 to 36, and 101 to 116 up to 801 to 816
        click_x17.py: 3 translated, 0 approximated, 0 refused
    "#]]);
}

/// A program of the field, in a folder of its own.
fn folder_of(name: &str, files: &[&str]) -> Folder {
    let texts: Vec<String> = files
        .iter()
        .map(|file| fs::read_to_string(field(name).join(file)).expect("the file can be read"))
        .collect();
    let files: Vec<(&str, &str)> = files
        .iter()
        .copied()
        .zip(texts.iter().map(String::as_str))
        .collect();
    Folder::with(&files)
}

/// What is written of a Python file, without the wires.
#[track_caller]
fn written(name: &str, program: &str, expected: Expect) {
    let folder = folder_of(name, &[program]);
    let run = folder.ladder(&["convert", program, "-o", "main.csv"]);
    assert_eq!(run.status, Some(0), "{run}");
    let text = folder.read("main.csv").replace(",-", "");
    let rows: Vec<&str> = text.lines().skip(1).collect();
    expected.assert_eq(&rows.join("\n"));
}

#[test]
fn formulas_and_searches_are_written_as_the_tools_read_them() {
    written(
        "click_csv_formula_written",
        "p.py",
        expect![[r#"
        R,X001,T,"math(DS1 * 2,DS2,mode=decimal)"
        ,,T,"math(DH1 AND 00FFh,DH2,mode=hex)"
        ,,"math(SUM ( DS1 : DS5 ),DS9,mode=decimal)"
        R,end()"#]],
    );
    written(
        "click_csv_search_written",
        "p.py",
        expect![[r#"
        R,X001,"search(DS1..DS9 >= 5,result=DS20,found=C1)"
        R,end()"#]],
    );
}

#[test]
fn grids_of_other_tools_are_read() {
    for (name, files) in [
        ("click_csv_search_read", &["main.csv"][..]),
        ("click_csv_indexed_marker", &["main.csv"]),
        (
            "click_csv_subroutines_folder",
            &["main.csv", "subroutines/Fill Tank.csv"],
        ),
        ("click_nicknames_xd0u", &["main.csv", "nicknames.csv"]),
    ] {
        let folder = folder_of(name, files);
        let run = folder.ladder(&["convert", "main.csv"]);
        assert_eq!(run.status, Some(0), "{name}: {run}");
        assert!(run.stderr.contains(" 0 refused"), "{name}: {run}");
    }
}

#[test]
fn subroutines_are_written_into_their_folder() {
    let folder = folder_of("click_csv_subroutines_folder", &["two.py"]);
    let run = folder.ladder(&["convert", "two.py", "-o", "main.csv"]);
    assert_eq!(run.status, Some(0), "{run}");
    assert!(folder.read("subroutines/fill.csv").contains("out(Y001)"));
    let run = folder.ladder(&["convert", "main.csv"]);
    assert!(run.stdout.contains("<FUN>( fill )"), "{run}");
}

#[test]
fn a_lone_rung_needs_no_end() {
    let grid = fs::read_to_string(field("click_csv_indexed_marker/main.csv")).expect("the file can be read");
    let lines: Vec<&str> = grid.lines().take(2).collect();
    let folder = Folder::with(&[("rung.csv", &format!("{}\n", lines.join("\n")))]);
    let run = folder.ladder(&["convert", "rung.csv"]);
    assert_eq!(run.status, Some(0), "{run}");
}

/// The reset of a register sees its bits as they were before the shift: the last one is on for a scan.
#[test]
fn a_register_is_reset_by_its_own_bit() {
    let folder = folder_of("click_shift_reset_by_own_bit", &["main.py", "main.csv", "in.csv"]);
    for file in ["main.py", "main.csv"] {
        let run = folder.ladder(&[
            "sim",
            file,
            "--scans",
            "8",
            "--inputs",
            "in.csv",
            "--watch",
            "C[1],C[2],C[3]",
        ]);
        let bits: Vec<String> = run
            .stdout
            .lines()
            .skip(1)
            .map(|line| line.splitn(3, ',').nth(2).unwrap_or_default().replace(',', ""))
            .collect();
        // As pyrung 0.15.2 has it.
        assert_eq!(
            bits,
            ["000", "100", "100", "010", "010", "001", "000", "000"],
            "{file}: {run}"
        );
    }
}

/// The page's table: what timers hold as ranges, blocks between kinds, the bits of reals, numbers of unlike types compared.
const TABLE: &str = "\
def main():
    if x[1]:
        ton(t[1], 2, Ts)
        ton(t[2], 9, Ts)
    if x[2]:
        calc('SUM(td[1:4])', ds[1])
        copy_pack(t[1:3], dh[1])
        search('ge', 3, td[1], td[2], ds[2], c[1])
        copy(td[ds[9]], ds[3])
        copy_block(ds[1:3], dd[1])
        copy_block(dd[1:3], df[1])
        copy_block(td[1:3], dd[5])
    if re(x[3]):
        copy_fill(7, td[1:3])
    if re(x[4]):
        copy(4, td[ds[9]])
    if True:
        copy_pack(ds[20:22], df[9])
        copy_unpack(df[9], ds[30:32])
        copy_unpack(df[9], c[101:133])
    if ds[1] >= 2.5:
        out(c[2])
    if dd[1] >= 2.5:
        out(c[3])
    if df[1] >= dd[1]:
        out(c[4])
    if True:
        end()
";

#[test]
fn what_goes_into_what_is_as_the_table_says() {
    let inputs = "X[3],X[4],DS[20],DS[21],DS[9]\n0,0,0,16256,2\n\n\n1,,,,\n0,1,,,\n";
    let folder = Folder::with(&[("table.py", TABLE), ("in.csv", inputs)]);
    let watched =
        "T1.ACC,T2.ACC,DS[1],DH[1],DS[2],C[1],DS[3],DD[1],DF[1],DD[6],DF[9],DS[31],C[131],C[2],C[3],C[4]";
    let simulated = |file: &str| {
        let run = folder.ladder(&[
            "sim", file, "--scans", "6", "--dt", "1s", "--inputs", "in.csv", "--set", "X[1]=1", "--set",
            "X[2]=1", "--watch", watched,
        ]);
        assert_eq!(run.status, Some(0), "{run}");
        run.stdout
    };
    let trace = simulated("table.py");
    expect![[r#"
        scan,time_ms,T1.ACC,T2.ACC,DS[1],DH[1],DS[2],C[1],DS[3],DD[1],DF[1],DD[6],DF[9],DS[31],C[131],C[2],C[3],C[4]
        0,0,1,1,2,0,-1,0,1,2,2.0,1,1.0,16256,0,0,0,1
        1,1000,2,2,4,1,-1,0,2,4,4.0,2,1.0,16256,0,1,1,1
        2,2000,3,3,6,1,1,1,3,6,6.0,3,1.0,16256,0,1,1,1
        3,3000,7,7,8,1,1,1,4,8,8.0,4,1.0,16256,0,1,1,1
        4,4000,8,4,16,1,1,1,8,16,16.0,8,1.0,16256,0,1,1,1
        5,5000,9,5,14,1,1,1,5,14,14.0,5,1.0,16256,0,1,1,1
    "#]].assert_eq(&trace);
    // Through ladder text and back it does the same, and says it with the same words.
    let run = folder.ladder(&["convert", "table.py", "-o", "table.clad"]);
    assert_eq!(run.status, Some(0), "{run}");
    let run = folder.ladder(&["convert", "table.clad", "-o", "again.py"]);
    assert_eq!(run.status, Some(0), "{run}");
    assert_eq!(simulated("again.py"), trace);
    let again = folder.read("again.py");
    for action in TABLE
        .lines()
        .filter(|line| line.contains("copy_") || line.contains("td["))
    {
        assert!(
            again.contains(&action.trim().replace('\'', "\"").replace("'ge'", "\"ge\"")),
            "{action}\n{again}"
        );
    }
}

#[test]
fn a_search_is_between_nicknames() {
    let program = "def main():\n    if x[1]:\n        search('eq', 5, ds.First, ds.Last, ds.At, c.Hit)\n    if True:\n        end()\n";
    let nicknames = "Address,Nickname\nDS11,First\nDS19,Last\n";
    let folder = Folder::with(&[("main.py", program), ("nicknames.csv", nicknames)]);
    let run = folder.ladder(&["convert", "main.py"]);
    assert_eq!(run.status, Some(0), "{run}");
    assert!(run.stdout.contains("DS[11..19]"), "{run}");
    let alone = Folder::with(&[("main.py", program)]);
    let run = alone.ladder(&["convert", "main.py"]);
    assert_eq!(run.status, Some(1), "{run}");
    assert!(
        run.stderr.contains("no nickname file says where its bounds are"),
        "{run}"
    );
}
