//! The files of a folder as the programs of a new controller.

use super::orders::{First, Order, called, ordered};
use super::{Layout, ProgramAt, TagAt, bare, free_main};
use ladder_analysis::context::Body;
use ladder_notation::Project;
use ladder_syntax::Name;
use std::collections::{BTreeMap, HashMap, HashSet};

impl Layout {
    /// The files of a folder as programs. A file that others share functions with cannot be one: then all are one program.
    pub(in crate::write) fn of_files(project: &Project) -> Layout {
        let context = &project.analysis.context;
        let mut layout = Layout::default();
        if project.count() < 2 {
            return layout;
        }
        let home = |function: &str| project.home_of_function(function).map(|(file, _)| file);
        let firsts: Vec<First> = (0..project.count())
            .map(|file| First::of(project, file))
            .collect();
        let of_main = context
            .networks
            .iter()
            .filter(|network| context.bodies[network.index] == Body::Main);
        let orders = of_main.filter_map(|network| ordered(context, network));
        let is_of_another = |order: &Order| home(&order.function) != Some(0);
        let orders: Vec<Order> = orders
            .filter(|order| is_of_another(order) || matches!(firsts[0], First::Calls(_)))
            .collect();
        for order in &orders {
            layout.runs.orders.add_called(&order.function);
        }
        for (file, first) in firsts.iter().enumerate() {
            if let (First::Calls(_), Some(main)) = (first, project.main(file)) {
                layout.runs.orders.add_main(main);
            }
        }
        for network in &context.networks {
            let from = match context.bodies[network.index] {
                _ if layout.runs.orders.has(context, network) => continue,
                Body::Main => Some(0),
                Body::Function(function) => home(&context.functions[function].name),
                Body::Block(_) => continue,
            };
            if network
                .blocks()
                .filter_map(called)
                .any(|called| home(&called) != from)
            {
                return Layout::default();
            }
        }
        let mut routines: BTreeMap<usize, Vec<String>> = BTreeMap::new();
        for function in &context.functions {
            let file = home(&function.name).unwrap_or_default();
            routines.entry(file).or_default().push(function.name.to_string());
        }
        let has_main = matches!(firsts[0], First::Rungs);
        // What only orders the others is the controller.
        layout.controller = matches!(firsts[0], First::Nothing).then(|| project.stem(0).to_owned());
        let own = context.scopes[0].tags.iter();
        let with_tags: HashSet<usize> = own
            .filter_map(|tag| Some(project.home_of_tag(&tag.name)?.0))
            .collect();
        let mut numbers = HashMap::new();
        for file in 0..project.count() {
            let is_first = file == 0 && has_main;
            let has_tags = file > 0 && with_tags.contains(&file);
            if !(is_first || routines.contains_key(&file) || has_tags) {
                continue;
            }
            let number = layout.programs.len();
            numbers.insert(file, number);
            layout.programs.push(ProgramAt::of_file(project.stem(file)));
            let all = routines.remove(&file).unwrap_or_default();
            layout.add_routines(project, file, number, &all, is_first);
        }
        for order in &orders {
            layout.begin(&order.function, order.is_run);
        }
        let of_first = layout.runs.order.clone();
        for (file, first) in firsts.iter().enumerate().skip(1) {
            let Some(number) = numbers.get(&file) else {
                continue;
            };
            if !layout.programs[*number].begins.is_empty() {
                continue;
            }
            match (first, project.main(file)) {
                (First::Calls(calls), _) => calls.iter().for_each(|function| layout.begin(function, true)),
                (First::Rungs, Some(main)) => layout.begin(main.as_str(), true),
                _ => {}
            }
        }
        for tag in &context.scopes[0].tags {
            if let Some((file, own)) = project.home_of_tag(&tag.name)
                && let Some(number) = numbers.get(&file)
            {
                let at = TagAt {
                    program: Some(*number),
                    name: own.to_owned(),
                    is_original: false,
                };
                layout.tags.insert(Name::new(&tag.name), at);
            }
        }
        layout.add_tasks(project, |_, file| match file {
            0 => of_first.clone(),
            _ => numbers.get(&file).copied().into_iter().collect(),
        });
        layout
    }

    /// The functions of a file as the routines of a program. `is_first`: the networks outside of functions are one, too.
    fn add_routines(
        &mut self,
        project: &Project,
        file: usize,
        number: usize,
        all: &[String],
        is_first: bool,
    ) {
        let own = |function: &str| {
            let home = project.home_of_function(function);
            home.map_or_else(|| function.to_owned(), |(_, own)| own.to_owned())
        };
        let main = project.main(file);
        let is_main = |function: &str| main.is_some_and(|main| *main == Name::new(function));
        let program = self.programs[number].name.clone();
        let mut taken: Vec<String> = Vec::new();
        for function in all.iter().filter(|function| !is_main(function)) {
            let own = own(function);
            let bare = bare(&program, &own);
            let mut others = all.iter().filter(|other| *other != function);
            let is_free = !others.any(|other| other.eq_ignore_ascii_case(bare));
            let routine = if is_free { bare.to_owned() } else { own };
            taken.push(routine.clone());
            self.functions.insert(Name::new(function), (number, routine));
        }
        let name = free_main(|name| taken.iter().any(|taken| taken.eq_ignore_ascii_case(name)));
        match main.filter(|main| !self.runs.orders.is_main(main)) {
            Some(main) => {
                self.functions.insert(main.clone(), (number, name));
            }
            None if is_first => self.begin_with_main(number, name),
            None => {}
        }
    }
}
