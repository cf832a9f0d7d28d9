//! The programs that are measured.
#![allow(
    clippy::many_single_char_names,
    reason = "contacts are a, b, c in every drawing"
)]

use crate::sketch::{Dice, Sketch, Type};

/// Rungs that hold themselves, and one timer for every ten of them.
pub(crate) fn seal_ins(rungs: usize) -> Sketch {
    let mut sketch = Sketch::default();
    let s = &mut sketch;
    for n in 0..rungs {
        let run = seal_in(s, n);
        if n % 10 == 9 {
            on_delay(s, n, &run);
        }
    }
    sketch
}

/// Twenty kinds of networks in turn: branches, comparisons, arithmetic, timers, counters, moves, some flow. They read
/// each other's tags, of this turn and of some earlier one.
pub(crate) fn mixed(networks: usize) -> Sketch {
    let mut sketch = Sketch::default();
    let s = &mut sketch;
    let dice = &mut Dice(1);
    let calls = s.tag("calls", Type::Dint);
    let mut earlier = Vec::new();
    let mut n = 0;
    while s.networks() + 1 < networks {
        let run = seal_in(s, n);
        let any = |dice: &mut Dice, earlier: &[String]| match earlier.len() {
            0 => run.clone(),
            len => earlier[dice.roll(len)].clone(),
        };
        let [a, b, c, d] = std::array::from_fn(|_| any(dice, &earlier));
        let guarded = two_ways(s, n, [&a, &b, &c, &d]);
        let ready = on_delay(s, n, &run);
        let (level, within) = window(s, n);
        count_up_level(s, n, &level, &guarded);
        let sum = arithmetic(s, n, &ready);
        let full = counter(s, n, &run, &ready);
        move_when(s, &sum, &full);
        let latch = latch(s, n, &a, &full);
        let (lamp, bell) = two_coils(s, n, [&run, &guarded, &ready, &within, &latch]);
        real(s, n, &within);
        off_delay(s, n, &lamp);
        differs(s, n, &sum, &level);
        jump_over(s, n, &b, &bell);
        side_by_side(s, n, [&run, &c, &latch, &d]);
        call(s, &calls, &guarded);
        inverted(s, n, &bell, &within);
        earlier.extend([run, guarded, ready, within, full, latch, lamp, bell]);
        n += 1;
    }
    s.draw("+--<FUN>( count )--[ADD]( calls, calls, 1 )--+");
    sketch
}

fn seal_in(s: &mut Sketch, n: usize) -> String {
    let (start, stop) = (s.input(format!("start{n}")), s.input(format!("stop{n}")));
    let run = s.tag(format!("run{n}"), Type::Bool);
    let a = s.power(&start);
    let b = s.power(&run);
    let joined = s.power(&format!("{a} | {b}"));
    let power = s.power(&format!("{joined} & !{stop}"));
    s.act(&format!("{run} = {power};"));
    s.draw(&format!(
        "+--\\--[ ]( {start} )--\\--[/]( {stop} )--( )( {run} )--+\n|  /--[ ]( {run} )--/"
    ));
    run
}

fn on_delay(s: &mut Sketch, n: usize, input: &str) -> String {
    let timer = s.tag(format!("t{n}"), Type::Ton);
    let ready = s.tag(format!("ready{n}"), Type::Bool);
    let time = n % 7 * 30 + 20;
    let en = s.power(input);
    let q = s.power(&format!("ton(&{timer}, {en}, {time} * MS)"));
    s.act(&format!("{ready} = {q};"));
    s.draw(&format!(
        "+--[ ]( {input} )--[TON]( {timer}, T#{time}ms )--( )( {ready} )--+"
    ));
    ready
}

fn off_delay(s: &mut Sketch, n: usize, input: &str) {
    let timer = s.tag(format!("u{n}"), Type::Tof);
    let fan = s.tag(format!("fan{n}"), Type::Bool);
    let time = n % 5 * 40 + 10;
    let en = s.power(input);
    let q = s.power(&format!("tof(&{timer}, {en}, {time} * MS)"));
    s.act(&format!("{fan} = {q};"));
    s.draw(&format!(
        "+--[ ]( {input} )--[TOF]( {timer}, T#{time}ms )--( )( {fan} )--+"
    ));
}

/// Two branches of two contacts each, after each other's tags.
fn two_ways(s: &mut Sketch, n: usize, [a, b, c, d]: [&str; 4]) -> String {
    let out = s.tag(format!("guarded{n}"), Type::Bool);
    let p = s.power(a);
    let p = s.power(&format!("{p} & !{b}"));
    let q = s.power(c);
    let q = s.power(&format!("{q} & {d}"));
    let joined = s.power(&format!("{p} | {q}"));
    s.act(&format!("{out} = {joined};"));
    s.draw(&format!(
        "+--\\--[ ]( {a} )--[/]( {b} )--\\--( )( {out} )--+\n|  /--[ ]( {c} )--[ ]( {d} )--/"
    ));
    out
}

fn window(s: &mut Sketch, n: usize) -> (String, String) {
    let level = s.tag(format!("level{n}"), Type::Dint);
    let within = s.tag(format!("within{n}"), Type::Bool);
    let (low, high) = (n % 50, n % 50 + 40);
    let p = s.power(&format!("{level} >= {low}"));
    let p = s.power(&format!("{p} & ({level} < {high})"));
    s.act(&format!("{within} = {p};"));
    s.draw(&format!(
        "+--[GE]( {level}, {low} )--[LT]( {level}, {high} )--( )( {within} )--+"
    ));
    (level, within)
}

fn count_up_level(s: &mut Sketch, n: usize, level: &str, guarded: &str) {
    let step = n % 3 + 1;
    let p = s.power(guarded);
    let eno = s.power(&p);
    s.act(&format!("if ({eno}) {level} = {level} + {step};"));
    s.draw(&format!(
        "+--[ ]( {guarded} )--[ADD]( {level}, {level}, {step} )--+"
    ));
}

fn arithmetic(s: &mut Sketch, n: usize, ready: &str) -> String {
    let (sum, product) = (
        s.tag(format!("sum{n}"), Type::Dint),
        s.tag(format!("product{n}"), Type::Dint),
    );
    let p = s.power(ready);
    let add = s.power(&p);
    s.act(&format!("if ({add}) {sum} = {sum} + 3;"));
    let mul = s.power(&add);
    s.act(&format!("if ({mul}) {product} = {sum} * {product} + {n};"));
    s.draw(&format!(
        "+--[ ]( {ready} )--[ADD]( {sum}, {sum}, 3 )--[CALC]( {product}, {sum} * {product} + {n} )--+"
    ));
    sum
}

fn counter(s: &mut Sketch, n: usize, run: &str, ready: &str) -> String {
    let counter = s.tag(format!("c{n}"), Type::Ctu);
    let full = s.tag(format!("full{n}"), Type::Bool);
    let most = n % 4 + 2;
    let p = s.power(run);
    let q = s.power(&format!("ctu(&{counter}, {p}, {ready}, {most})"));
    s.act(&format!("{full} = {q};"));
    s.draw(&format!(
        "+--[ ]( {run} )--[CTU]( {counter}, {most}, R := {ready} )--( )( {full} )--+"
    ));
    full
}

fn move_when(s: &mut Sketch, sum: &str, full: &str) {
    let p = s.power(full);
    let q = s.power(&p);
    s.act(&format!("if ({q}) {sum} = 0;"));
    s.draw(&format!("+--[ ]( {full} )--[MOV]( {sum}, 0 )--+"));
}

fn latch(s: &mut Sketch, n: usize, set: &str, reset: &str) -> String {
    let latch = s.tag(format!("latch{n}"), Type::Bool);
    let p = s.power(set);
    s.act(&format!("if ({p}) {latch} = true;"));
    s.draw(&format!("+--[ ]( {set} )--(S)( {latch} )--+"));
    let p = s.power(reset);
    s.act(&format!("if ({p}) {latch} = false;"));
    s.draw(&format!("+--[ ]( {reset} )--(R)( {latch} )--+"));
    latch
}

/// Five contacts; one coil taps the wire on the way.
fn two_coils(s: &mut Sketch, n: usize, [a, b, c, d, e]: [&str; 5]) -> (String, String) {
    let (lamp, bell) = (
        s.tag(format!("lamp{n}"), Type::Bool),
        s.tag(format!("bell{n}"), Type::Bool),
    );
    let p = s.power(a);
    let p = s.power(&format!("{p} & {b}"));
    let p = s.power(&format!("{p} & !{c}"));
    let q = s.power(&format!("{p} & {d}"));
    s.act(&format!("{bell} = {q};"));
    let r = s.power(&format!("{p} & {e}"));
    s.act(&format!("{lamp} = {r};"));
    s.draw(&format!(
        "+--[ ]( {a} )--[ ]( {b} )--[/]( {c} )--\\--[ ]( {e} )--( )( {lamp} )--+\n|  /--[ ]( {d} )--( )( {bell} )--+"
    ));
    (lamp, bell)
}

fn real(s: &mut Sketch, n: usize, within: &str) {
    let x = s.tag(format!("x{n}"), Type::Lreal);
    let p = s.power(within);
    let q = s.power(&p);
    s.act(&format!("if ({q}) {x} = {x} * 0.5 + 1.25;"));
    s.draw(&format!("+--[ ]( {within} )--[CALC]( {x}, {x} * 0.5 + 1.25 )--+"));
}

fn differs(s: &mut Sketch, n: usize, a: &str, b: &str) {
    let differs = s.tag(format!("differs{n}"), Type::Bool);
    let distance = s.tag(format!("distance{n}"), Type::Dint);
    let p = s.power(&format!("{a} != {b}"));
    let q = s.power(&p);
    s.act(&format!("if ({q}) {distance} = {a} - {b};"));
    s.act(&format!("{differs} = {q};"));
    s.draw(&format!(
        "+--[NE]( {a}, {b} )--[SUB]( {distance}, {a}, {b} )--( )( {differs} )--+"
    ));
}

fn jump_over(s: &mut Sketch, n: usize, when: &str, what: &str) {
    let (skipped, shown) = (
        s.tag(format!("skipped{n}"), Type::Dint),
        s.tag(format!("shown{n}"), Type::Bool),
    );
    let p = s.power(when);
    s.act(&format!("if (!{p}) {{"));
    s.draw(&format!("+--[ ]( {when} )--<JMP>( over{n} )--+"));
    let eno = s.power("true");
    s.act(&format!("if ({eno}) {skipped} = {skipped} + 1; }}"));
    s.draw(&format!("+--[ADD]( {skipped}, {skipped}, 1 )--+"));
    let p = s.power(what);
    s.act(&format!("{shown} = {p};"));
    s.draw(&format!("+--<LBL>( over{n} )--[ ]( {what} )--( )( {shown} )--+"));
}

/// Two pairs of branches in a row.
fn side_by_side(s: &mut Sketch, n: usize, [a, b, c, d]: [&str; 4]) {
    let out = s.tag(format!("both{n}"), Type::Bool);
    let p = s.power(a);
    let q = s.power(b);
    let first = s.power(&format!("{p} | {q}"));
    let p = s.power(&format!("{first} & {c}"));
    let q = s.power(&format!("{first} & !{d}"));
    let second = s.power(&format!("{p} | {q}"));
    s.act(&format!("{out} = {second};"));
    s.draw(&format!(
        "+--\\--[ ]( {a} )--\\--\\--[ ]( {c} )--\\--( )( {out} )--+\n|  /--[ ]( {b} )--/  /--[/]( {d} )--/"
    ));
}

fn call(s: &mut Sketch, calls: &str, when: &str) {
    let p = s.power(when);
    s.act(&format!("if ({p}) {calls} = {calls} + 1;"));
    s.draw(&format!("+--[ ]( {when} )--<CALL>( count )--+"));
}

fn inverted(s: &mut Sketch, n: usize, a: &str, b: &str) {
    let out = s.tag(format!("neither{n}"), Type::Bool);
    let p = s.power(a);
    let p = s.power(&format!("{p} & {b}"));
    let q = s.power(&format!("!{p}"));
    s.act(&format!("{out} = {q};"));
    s.draw(&format!("+--[ ]( {a} )--[ ]( {b} )--[NOT]--( )( {out} )--+"));
}
