//! The process that started the server: when it dies without a word, the server goes too.
//!
//! The end of the input usually tells as much, but not when another process has inherited the pipe.

use std::time::Duration;

use sysinfo::{Pid, ProcessRefreshKind, ProcessStatus, ProcessesToUpdate, System};

/// How often the parent is checked.
const INTERVAL: Duration = Duration::from_secs(2);

/// Resolves when the process is gone. Its starting time is compared too, since the system
/// gives the number of a dead process to a new one.
pub(super) async fn gone(process: u32) {
    let mut system = System::new();
    let started = started(&mut system, process);
    loop {
        tokio::time::sleep(INTERVAL).await;
        let now = self::started(&mut system, process);
        if now.is_none() || now != started {
            return;
        }
    }
}

/// When the process was started, in seconds since 1970; `None` if it is not alive.
fn started(system: &mut System, process: u32) -> Option<u64> {
    let process = Pid::from_u32(process);
    system.refresh_processes_specifics(
        ProcessesToUpdate::Some(&[process]),
        true,
        ProcessRefreshKind::nothing(),
    );
    let found = system.process(process)?;
    (!matches!(found.status(), ProcessStatus::Zombie | ProcessStatus::Dead)).then(|| found.start_time())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tells_the_living_from_the_dead() {
        let mut system = System::new();
        let mut child = std::process::Command::new("sleep").arg("60").spawn().unwrap();
        assert!(started(&mut system, child.id()).is_some());
        child.kill().unwrap();
        // Not waited for yet, so that it is a zombie: as dead as any.
        std::thread::sleep(Duration::from_millis(100));
        assert_eq!(started(&mut system, child.id()), None);
        child.wait().unwrap();
        assert_eq!(started(&mut system, child.id()), None);
    }
}
