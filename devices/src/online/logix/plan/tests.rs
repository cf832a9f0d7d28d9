//! What is found of wanted names, and what is asked for them.

use super::*;
use ciplink::logix::types::{MemberInfo, TemplateMakeup, TypeClass};
use expect_test::{Expect, expect};
use ladder_simulator::{Options, Simulation};

/// A member: its name, its type, and how many there are of it or, of a BOOL, which bit it is.
fn structure(name: &str, members: &[(&str, TypeRef, u16)]) -> TypeRef {
    let members = members.iter().map(|(name, ty, number)| {
        let is_bool = *ty == TypeRef::Atomic(Some(Elementary::Bool));
        let member = MemberInfo {
            offset: 0,
            data_type: ty.clone(),
            bit: is_bool.then_some(*number),
            array: (!is_bool).then_some(*number),
            type_class: TypeClass::Unknown,
        };
        ((*name).to_owned(), member)
    });
    let structure = DataType {
        name: Some(name.to_owned()),
        internal_tags: members.collect(),
        attributes: Vec::new(),
        template: TemplateMakeup {
            object_definition_size: 0,
            structure_size: 0,
            member_count: 0,
            structure_handle: 0,
        },
        string: None,
        members: Vec::new(),
        bit_members: [].into_iter().collect(),
        private_members: ["CTL".to_owned()].into_iter().collect(),
    };
    TypeRef::Struct(Arc::new(structure))
}

fn atomic(ty: Elementary) -> TypeRef {
    TypeRef::Atomic(Some(ty))
}

fn definitions(tags: &[(&str, TypeRef, &[u32])]) -> Definitions {
    let tags = tags.iter().map(|(name, ty, lengths)| {
        let mut dimensions = [0; 3];
        dimensions[..lengths.len()].copy_from_slice(lengths);
        let tag = TagDef {
            tag_name: (*name).to_owned(),
            dim: lengths.len() as u8,
            alias: false,
            instance_id: 1,
            symbol_address: 0,
            symbol_object_address: 0,
            software_control: 0,
            external_access: "Read/Write".to_owned(),
            dimensions,
            template_instance_id: None,
            data_type: ty.clone(),
            bit_position: None,
            type_class: None,
        };
        ((*name).to_owned(), tag)
    });
    Definitions {
        version: 1,
        tags_generation: 1,
        tags_from: 0,
        tags: tags.collect(),
        data_types: [].into_iter().collect(),
        probes: Vec::new(),
    }
}

/// Values of a type by names in the controller.
fn wanted(ty: &str, names: &[&str]) -> Vec<Wanted> {
    let program = format!("VAR\n    v : {ty};\nEND_VAR\n+--[ ]( a )--( )( b )--+\n");
    let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(&program)), "program");
    let program = analysis.program().expect("a program without errors").clone();
    let simulation = Simulation::new(program, Options::default()).expect("a program that runs");
    let point = simulation.resolve("v").expect("a tag");
    let wanted = names.iter().map(|name| Wanted {
        point: point.clone(),
        name: (*name).to_owned(),
    });
    wanted.collect()
}

/// Found things, then requests with the steps to each wanted value.
fn check(
    tags: &[(&str, TypeRef, &[u32])],
    program: Option<&str>,
    ty: &str,
    names: &[&str],
    expected: Expect,
) {
    let (found, asks) = plan(&definitions(tags), program, &wanted(ty, names));
    let mut text = String::new();
    for (name, found) in names.iter().zip(found) {
        text += &format!("{name}: {found:?}\n");
    }
    for ask in asks {
        text += &format!("ask {}\n", ask.request);
        for part in ask.parts {
            text += &format!("    {}: {:?}\n", names[part.wanted], part.steps);
        }
    }
    expected.assert_eq(&text);
}

#[test]
fn a_program_is_asked_before_the_controller() {
    let tags = [
        ("run", atomic(Elementary::Bool), &[][..]),
        ("stop", atomic(Elementary::Bool), &[]),
        ("Program:Main.Run", atomic(Elementary::Bool), &[]),
    ];
    let names = [
        "RUN",
        "stop",
        "program:main.RUN",
        "Program:Other.run",
        "other",
        "no name",
    ];
    check(
        &tags,
        Some("main"),
        "BOOL",
        &names,
        expect![[r#"
        RUN: Here
        stop: Here
        program:main.RUN: Here
        Program:Other.run: Missing
        other: Missing
        no name: Missing
        ask Program:Main.Run
            RUN: []
        ask stop
            stop: []
        ask Program:Main.Run
            program:main.RUN: []
    "#]],
    );
    check(
        &tags,
        None,
        "BOOL",
        &names[..1],
        expect![[r#"
        RUN: Here
        ask run
            RUN: []
    "#]],
    );
}

#[test]
fn types_and_parts() {
    let timer = structure(
        "TIMER",
        &[
            ("CTL", atomic(Elementary::DInt), 0),
            ("PRE", atomic(Elementary::DInt), 0),
            ("DN", atomic(Elementary::Bool), 5),
            ("far", atomic(Elementary::Bool), 29),
        ],
    );
    let tags = [
        ("t", timer, &[][..]),
        ("n", atomic(Elementary::DInt), &[]),
        ("a", atomic(Elementary::DInt), &[10]),
        ("bits", atomic(Elementary::DWord), &[64]),
        ("strange", TypeRef::Atomic(None), &[]),
    ];
    let names = [
        "t",
        "t.Q",
        "t.dn",
        "t.far",
        "t.PT",
        "t.nothing",
        "t.CTL.3",
        "n",
        "n.31",
        "n.32",
        "n.x",
        "a",
        "a[9]",
        "a[9].31",
        "a[10]",
        "a[1,2]",
        "bits[40]",
        "bits",
        "n[0]",
        "strange",
    ];
    check(
        &tags,
        None,
        "BOOL",
        &names,
        expect![[r#"
        t: OtherType("TIMER")
        t.Q: Here
        t.dn: Here
        t.far: Here
        t.PT: OtherType("DINT")
        t.nothing: Missing
        t.CTL.3: Here
        n: OtherType("DINT")
        n.31: Here
        n.32: Missing
        n.x: Missing
        a: OtherType("array of DINT")
        a[9]: OtherType("DINT")
        a[9].31: Here
        a[10]: Missing
        a[1,2]: Missing
        bits[40]: Here
        bits: OtherType("array of BOOL")
        n[0]: Missing
        strange: OtherType("a type that is not known")
        ask t.far
            t.far: []
        ask t.CTL.3
            t.CTL.3: []
        ask a[9]{1}
            a[9].31: [Bit(31)]
        ask bits[32]{9}
            bits[40]: [Element(8)]
        ask n
            n.31: [Bit(31)]
        ask t
            t.Q: [Member("DN")]
            t.dn: [Member("DN")]
    "#]],
    );
    check(
        &tags,
        None,
        "DINT",
        &["t.PT", "t.pre", "n", "a[4]", "bits[4]", "t.CTL"],
        expect![[r#"
            t.PT: Here
            t.pre: Here
            n: Here
            a[4]: Here
            bits[4]: OtherType("BOOL")
            t.CTL: Here
            ask n
                n: []
            ask t.CTL
                t.CTL: []
            ask a[4]{1}
                a[4]: []
            ask t
                t.PT: [Member("PRE")]
                t.pre: [Member("PRE")]
        "#]],
    );
    check(
        &tags,
        None,
        "TIME",
        &["t.PT", "t.DN"],
        expect![[r#"
        t.PT: Here
        t.DN: OtherType("BOOL")
        ask t
            t.PT: [Member("PRE")]
    "#]],
    );
    check(
        &tags,
        None,
        "INT",
        &["n"],
        expect![[r#"
        n: OtherType("DINT")
    "#]],
    );
}

#[test]
fn arrays_are_read_from_the_first_wanted_element_to_the_last() {
    let tags = [
        ("a", atomic(Elementary::DInt), &[1000][..]),
        ("one", atomic(Elementary::DInt), &[1]),
        ("grid", atomic(Elementary::DInt), &[2, 3, 4]),
        ("vast", atomic(Elementary::DInt), &[1000, 1000]),
    ];
    check(
        &tags,
        None,
        "DINT",
        &["a[7]", "a[5]", "one[0]", "grid[1, 2, 3]", "vast[1,1]"],
        expect![[r#"
            a[7]: Here
            a[5]: Here
            one[0]: Here
            grid[1, 2, 3]: Here
            vast[1,1]: Here
            ask a[5]{3}
                a[7]: [Element(2)]
                a[5]: [Element(0)]
            ask grid{24}
                grid[1, 2, 3]: [Element(23)]
            ask one[0]{1}
                one[0]: []
            ask vast[1,1]
                vast[1,1]: []
        "#]],
    );
    let bits = [("bits", atomic(Elementary::DWord), &[128][..])];
    check(
        &bits,
        None,
        "BOOL",
        &["bits[70]", "bits[40]"],
        expect![[r#"
        bits[70]: Here
        bits[40]: Here
        ask bits[32]{39}
            bits[70]: [Element(38)]
            bits[40]: [Element(8)]
    "#]],
    );
}

/// A few hundred bytes of types can stand for more values than there is memory.
#[test]
fn values_out_of_nothing() {
    let mut ty = structure("T0", &[("n", atomic(Elementary::DInt), 0)]);
    for depth in 1..100 {
        ty = structure(
            &format!("T{depth}"),
            &[
                ("n", atomic(Elementary::DInt), 0),
                ("a", ty.clone(), 65535),
                ("b", ty, 65535),
            ],
        );
    }
    check(
        &[("bomb", ty, &[])],
        None,
        "DINT",
        &["bomb.n", "bomb.a[7].n"],
        expect![[r#"
            bomb.n: Here
            bomb.a[7].n: Here
            ask bomb.n
                bomb.n: []
            ask bomb.a[7].n
                bomb.a[7].n: []
        "#]],
    );
}
