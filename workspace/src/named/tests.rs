use super::*;
use std::fs;
use tempfile::TempDir;

/// `plant/` with a settings file, two programs and a folder of tests; a file next to it.
fn plant() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir_all(folder.path().join("plant/tests")).unwrap();
    for (name, text) in [
        ("plant/ladder.toml", ""),
        ("plant/motor.clad", "motor"),
        ("plant/tests/pump.clad", "pump"),
        ("secret.clad", "secret"),
    ] {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

/// What a file of scenarios in `plant/tests` reads when it names a program.
fn read(folder: &TempDir, name: &str) -> String {
    let scenarios = folder.path().join("plant/tests/a.ladder-test");
    match Named::in_file(&scenarios, name).read() {
        Ok(text) => text,
        Err(error) => error.problem.to_string(),
    }
}

const OUTSIDE: &str = "this leads out of the workspace, the folder of ladder.toml (without one: the file's own folder); an empty ladder.toml in a folder above both makes them one";
const NOT_RELATIVE: &str =
    "a path in a workspace is relative: write it as it is seen from the file that names it";

#[test]
fn names_inside() {
    let folder = plant();
    for (name, text) in [
        ("pump.clad", "pump"),
        ("./pump.clad", "pump"),
        ("../motor.clad", "motor"),
        ("../tests/../motor.clad", "motor"),
        ("not/there/../../pump.clad", "pump"),
        ("gone.clad", "no such file or folder"),
        ("", "this is a folder; name a file in it"),
        ("..", "this is a folder; name a file in it"),
        ("../tests", "this is a folder; name a file in it"),
    ] {
        assert_eq!(read(&folder, name), text, "{name}");
    }
}

#[test]
fn names_outside() {
    let folder = plant();
    let absolute = folder.path().join("plant/motor.clad");
    assert_eq!(read(&folder, absolute.to_str().unwrap()), NOT_RELATIVE);
    for name in [
        "/etc/passwd",
        "\\\\host\\share\\a.clad",
        "\\a.clad",
        "//host/share/a.clad",
        "C:\\a.clad",
        "c:a.clad",
    ] {
        assert_eq!(read(&folder, name), NOT_RELATIVE, "{name}");
    }
    for name in [
        "../../secret.clad",
        "../../plant/motor.clad",
        "../tests/../../secret.clad",
        "../.git/config",
    ] {
        assert_eq!(read(&folder, name), OUTSIDE, "{name}");
    }
}

#[test]
fn without_a_settings_file_the_own_folder_is_all() {
    let folder = plant();
    fs::remove_file(folder.path().join("plant/ladder.toml")).unwrap();
    assert_eq!(read(&folder, "pump.clad"), "pump");
    assert_eq!(read(&folder, "../motor.clad"), OUTSIDE);
}

#[test]
fn the_path_of_the_file_itself_may_climb() {
    let folder = plant();
    let climbing = folder.path().join("plant/tests/../../plant/tests/a.ladder-test");
    for (name, expected) in [
        ("pump.clad", "pump"),
        ("../motor.clad", "motor"),
        ("../../secret.clad", OUTSIDE),
    ] {
        let read = Named::in_file(&climbing, name).read();
        let read = read.unwrap_or_else(|error| error.problem.to_string());
        assert_eq!(read, expected, "{name}");
    }
}

#[cfg(unix)]
mod unix {
    use super::*;
    use std::os::unix::fs::symlink;

    #[test]
    fn links() {
        let folder = plant();
        let at = |name: &str| folder.path().join("plant/tests").join(name);
        symlink("../motor.clad", at("inside.clad")).unwrap();
        symlink("../../secret.clad", at("outside.clad")).unwrap();
        symlink(folder.path().join("plant/motor.clad"), at("whole.clad")).unwrap();
        symlink(folder.path().join("secret.clad"), at("whole-outside.clad")).unwrap();
        symlink("../..", at("up")).unwrap();
        symlink("outside.clad", at("twice.clad")).unwrap();
        symlink("round.clad", at("round.clad")).unwrap();
        symlink("/dev/zero", at("zero.clad")).unwrap();
        symlink("/proc/self/environ", at("environ.clad")).unwrap();
        for (name, text) in [
            ("inside.clad", "motor"),
            ("whole.clad", "motor"),
            ("outside.clad", OUTSIDE),
            ("whole-outside.clad", OUTSIDE),
            ("twice.clad", OUTSIDE),
            ("up/secret.clad", OUTSIDE),
            ("round.clad", "cannot be read: too many links lead on from it"),
            ("zero.clad", OUTSIDE),
            ("environ.clad", OUTSIDE),
        ] {
            assert_eq!(read(&folder, name), text, "{name}");
        }
    }

    #[test]
    fn a_workspace_that_is_reached_through_a_link() {
        let folder = plant();
        symlink("plant", folder.path().join("other")).unwrap();
        let scenarios = folder.path().join("other/tests/a.ladder-test");
        assert_eq!(
            Named::in_file(&scenarios, "../motor.clad").read().unwrap(),
            "motor"
        );
    }

    #[test]
    fn what_is_no_regular_file() {
        let folder = plant();
        let pipe = folder.path().join("plant/tests/pipe.clad");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        assert!(made.unwrap().success());
        let _socket =
            std::os::unix::net::UnixListener::bind(folder.path().join("plant/tests/socket.clad")).unwrap();
        let big = fs::File::create(folder.path().join("plant/tests/big.clad")).unwrap();
        big.set_len(ladder_syntax::MAX_FILE_BYTES as u64 + 1).unwrap();
        // Nothing writes into the pipe: to wait for that would be to wait for ever.
        assert_eq!(
            read(&folder, "pipe.clad"),
            "this is a pipe, and only a regular file is used here"
        );
        assert_eq!(
            read(&folder, "socket.clad"),
            "this is a socket, and only a regular file is used here"
        );
        assert_eq!(
            read(&folder, "big.clad"),
            "the file is larger than 64 MiB, the most that is read"
        );
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_workspace_that_holds_the_whole_disk_does_not_hold_the_system() {
        let named = |name: &str| {
            Named::in_settings(Path::new("/"), name)
                .read()
                .unwrap_err()
                .problem
                .to_string()
        };
        assert_eq!(
            named("dev/null"),
            "this is a device, and only a regular file is used here"
        );
        assert_eq!(
            named("proc/self/status"),
            "this is a file of the operating system itself, and only a regular file is used here"
        );
    }
}
