//! Small exports, put together from tags and rungs.

/// The tags and rungs of a whole controller with one program as L5X. A tag is its name, its type and its value: a
/// number, or the elements inside of `Data`.
pub(crate) fn controller(tags: &[(&str, &str, &str)], rungs: &[&str]) -> String {
    let routine = ("Main", rungs);
    whole("", tags, &[routine])
}

/// The same with what is before the tags, and several routines.
pub(crate) fn whole(before: &str, tags: &[(&str, &str, &str)], routines: &[(&str, &[&str])]) -> String {
    let mut out = String::from(
        "\u{feff}<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n<RSLogix5000Content SchemaRevision=\"1.0\" \
         SoftwareRevision=\"33.00\" TargetType=\"Controller\">\n<Controller Use=\"Target\" Name=\"Cell\">\n",
    );
    out.push_str(before);
    out.push_str("<Tags>\n");
    for tag in tags {
        out.push_str(&self::tag(*tag));
    }
    out.push_str(
        "</Tags>\n<Programs>\n<Program Name=\"MainProgram\" MainRoutineName=\"Main\">\n<Tags/>\n<Routines>\n",
    );
    for (name, rungs) in routines {
        out.push_str(&routine(name, rungs));
    }
    out.push_str("</Routines>\n</Program>\n</Programs>\n</Controller>\n</RSLogix5000Content>\n");
    out
}

/// A routine of ladder logic.
pub(crate) fn routine(name: &str, rungs: &[&str]) -> String {
    let mut out = format!("<Routine Name=\"{name}\" Type=\"RLL\">\n<RLLContent>\n");
    for (number, rung) in rungs.iter().enumerate() {
        out.push_str(&format!(
            "<Rung Number=\"{number}\" Type=\"N\">\n<Text>\n<![CDATA[{rung}]]>\n</Text>\n</Rung>\n"
        ));
    }
    out.push_str("</RLLContent>\n</Routine>\n");
    out
}

fn tag((name, ty, value): (&str, &str, &str)) -> String {
    if let Some(target) = ty.strip_prefix("= ") {
        return format!("<Tag Name=\"{name}\" TagType=\"Alias\" AliasFor=\"{target}\"/>\n");
    }
    let (ty, sizes) = match ty.split_once('[') {
        Some((ty, sizes)) => (ty, format!(" Dimensions=\"{}\"", sizes.trim_end_matches(']'))),
        None => (ty, String::new()),
    };
    let data = match value {
        "" => String::new(),
        value if value.starts_with('<') => value.to_owned(),
        value => format!("<DataValue DataType=\"{ty}\" Value=\"{value}\"/>"),
    };
    let data = match data.as_str() {
        "" => String::new(),
        data => format!("<Data Format=\"Decorated\">{data}</Data>"),
    };
    format!("<Tag Name=\"{name}\" TagType=\"Base\" DataType=\"{ty}\"{sizes}>{data}</Tag>\n")
}
