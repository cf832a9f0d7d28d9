//! The tasks of a project, as the settings of a workspace have them.

/// A task that runs programs of a project.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ProjectTask {
    /// What it is called.
    pub name: String,
    /// The time from one run to the next, in nanoseconds.
    pub interval: i64,
    /// The smallest runs first; none is below 0.
    pub priority: i64,
    /// The files of its programs, in their order.
    pub programs: Vec<String>,
}

/// `[[task]]` for each task that runs something (LANGUAGE §9).
pub(super) fn task_settings(tasks: &[ProjectTask]) -> String {
    let mut settings = String::new();
    for task in tasks.iter().filter(|task| !task.programs.is_empty()) {
        let programs: Vec<String> = task.programs.iter().map(|name| quoted(name)).collect();
        settings.push_str(&format!(
            "\n[[task]]\nname = {}\ninterval = {}\npriority = {}\nprograms = [{}]\n",
            quoted(&task.name),
            quoted(&duration(task.interval)),
            task.priority.max(0),
            programs.join(", "),
        ));
    }
    settings
}

/// A time in the largest unit of which it is a whole number: `5ms`.
fn duration(nanoseconds: i64) -> String {
    let units = [(1_000_000_000, "s"), (1_000_000, "ms"), (1_000, "us"), (1, "ns")];
    let whole = units.iter().find(|(size, _)| nanoseconds % size == 0);
    let (size, unit) = whole.copied().unwrap_or((1, "ns"));
    format!("{}{unit}", nanoseconds / size)
}

/// A text as TOML has it.
fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if c.is_control() => out.push_str(&format!("\\u{:04X}", u32::from(c))),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}
