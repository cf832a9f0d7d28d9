//! Devices at the other end of a wire: the server of this crate, and one that does everything wrong.

use expect_test::expect;
use ladder_analysis::values::value::Value;
use ladder_devices::modbus::{Device, Devices, Hold, Image, Map, Named, Places, Rules, bind, serve};
use ladder_simulator::{Options, Simulation};
use std::io::{Read, Write};
use std::net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Longer than the slowest machine needs.
const PATIENCE: Duration = Duration::from_secs(30);

const CONTROLLER: &str = "VAR_INPUT\n    rio_ok : BOOL;\n    rio_age : TIME;\n    level : REAL;\nEND_VAR\n\
    VAR_OUTPUT\n    speed : DINT := 7;\nEND_VAR\n\
    +--[ ]( %IX10.1 )--( )( %QX10.0 )--+\n+--[GT]( level, 1.0 )--[MOV]( speed, 70000 )--+\n";

fn simulation(text: &str) -> Simulation {
    let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(text)), "controller");
    Simulation::new(analysis.program().unwrap().clone(), Options::default()).unwrap()
}

fn named(list: &[(&str, &str)]) -> Vec<Named> {
    let named = list.iter().map(|(place, tag)| Named {
        place: (*place).to_owned(),
        tag: (*tag).to_owned(),
        at: 0..0,
    });
    named.collect()
}

/// A controller whose inputs and outputs are at an address.
struct Controller {
    simulation: Simulation,
    devices: Devices,
    told: Arc<Mutex<Vec<String>>>,
}

impl Controller {
    fn new(address: SocketAddr) -> Controller {
        let simulation = simulation(CONTROLLER);
        let device = Device {
            poll: Duration::from_millis(5),
            timeout: Duration::from_millis(500),
            repeat: Duration::from_secs(3600),
            ok: Some(("rio_ok".to_owned(), 0..0)),
            age: Some(("rio_age".to_owned(), 0..0)),
            read: named(&[("discrete 0..7", "%IX10.0"), ("input 200", "level")]),
            write: named(&[("coil 0..7", "%QX10.0"), ("holding 4", "speed")]),
            ..Device::new("rio", address.to_string())
        };
        let wired = bind(&[device], None, &simulation).unwrap();
        let told = Arc::<Mutex<Vec<String>>>::default();
        let keep = told.clone();
        let tell = move |line: &str| keep.lock().unwrap().push(line.to_owned());
        let devices = Devices::connect(wired, tell).unwrap();
        Controller {
            simulation,
            devices,
            told,
        }
    }

    fn scan(&mut self) {
        self.devices.give(&mut self.simulation, Instant::now());
        self.simulation.scan();
        self.devices.take(&self.simulation);
    }

    fn value(&self, tag: &str) -> Value {
        self.simulation.value(&self.simulation.resolve(tag).unwrap())
    }

    fn is_high(&self, tag: &str) -> bool {
        self.value(tag) == Value::Bool(true)
    }

    /// Scans until that is so.
    fn until(&mut self, is_so: impl Fn(&Controller) -> bool) {
        let end = Instant::now() + PATIENCE;
        while !is_so(self) {
            assert!(Instant::now() < end, "{:?}", self.told.lock().unwrap());
            self.scan();
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    fn told(&self) -> String {
        self.told.lock().unwrap().join("\n")
    }
}

#[test]
fn the_server_of_another_program_is_a_device() {
    let remote = "VAR_INPUT\n    lamp : BOOL;\n    speed : DINT;\nEND_VAR\nVAR_OUTPUT\n    switch AT %QX0.1 : BOOL;\n    level : REAL;\nEND_VAR\n\
        +--[/]( lamp )--( )( switch )--+\n+--[MOV]( level, 2.5 )--+\n";
    let mut remote = simulation(remote);
    let places = Places {
        named: named(&[
            ("discrete 1", "switch"),
            ("input 200", "level"),
            ("coil 0", "lamp"),
            ("holding 4", "speed"),
        ]),
        write: ["lamp", "speed"].map(|tag| (tag.to_owned(), 0..0)).to_vec(),
        ..Places::default()
    };
    let image = Image::new(Map::new(&places, &remote).unwrap(), Hold::Last, &remote);
    let any = SocketAddr::from((Ipv4Addr::LOCALHOST, 0));
    let listening = serve(any, &image, Rules::default(), |_: &str| {}).unwrap();
    let mut controller = Controller::new(listening.address);
    let speed = remote.resolve("speed").unwrap();
    let end = Instant::now() + PATIENCE;
    // The switch is on while the lamp is off, which the switch turns on: both are seen in both states.
    let mut seen = [false; 2];
    while seen != [true; 2] || remote.value(&speed) != Value::Int(70000) {
        assert!(Instant::now() < end, "{seen:?} {}", controller.told());
        controller.scan();
        image.give(&mut remote, Instant::now());
        remote.scan();
        image.take(&remote);
        seen[usize::from(controller.is_high("%IX10.1"))] |= controller.is_high("rio_ok");
        std::thread::sleep(Duration::from_millis(1));
    }
    assert_eq!(controller.value("level"), Value::Real(2.5));
    expect!["device rio answers"].assert_eq(&controller.told());
}

/// What the other end does with a request.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Manner {
    Works,
    Refuses,
    Closes,
    Silent,
    /// Answers with fewer registers than it is asked for.
    Short,
    /// Answers to another request.
    Confused,
    /// Sends bytes that mean nothing.
    Garbage,
    /// Sends the beginning of an answer.
    Half,
}

/// A device whose bits are high and whose registers are 0x4000, and which remembers what it is asked.
struct Fake {
    address: SocketAddr,
    manner: Arc<Mutex<Manner>>,
    asked: Arc<Mutex<Vec<Vec<u8>>>>,
}

impl Fake {
    fn new(manner: Manner) -> Fake {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).unwrap();
        let address = listener.local_addr().unwrap();
        let manner = Arc::new(Mutex::new(manner));
        let asked = Arc::<Mutex<Vec<Vec<u8>>>>::default();
        let fake = Fake {
            address,
            manner: manner.clone(),
            asked: asked.clone(),
        };
        std::thread::spawn(move || {
            for stream in listener.incoming() {
                let (manner, asked) = (manner.clone(), asked.clone());
                std::thread::spawn(move || answer_all(stream.unwrap(), &manner, &asked));
            }
        });
        fake
    }

    fn set(&self, manner: Manner) {
        *self.manner.lock().unwrap() = manner;
    }

    /// Waits for some more exchanges.
    fn is_asked_again(&self) {
        let before = self.asked.lock().unwrap().len();
        let end = Instant::now() + PATIENCE;
        while self.asked.lock().unwrap().len() < before + 10 {
            assert!(Instant::now() < end);
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    /// The requests to write that came since this was last asked.
    fn writes(&self) -> Vec<Vec<u8>> {
        let asked = std::mem::take(&mut *self.asked.lock().unwrap());
        asked
            .into_iter()
            .filter(|request| matches!(request[0], 5 | 6 | 15 | 16))
            .collect()
    }
}

/// None: the connection is at its end.
fn answer_all(mut stream: TcpStream, manner: &Mutex<Manner>, asked: &Mutex<Vec<Vec<u8>>>) -> Option<()> {
    loop {
        let mut header = [0; 7];
        stream.read_exact(&mut header).ok()?;
        let mut request = vec![0; usize::from(header[5]) - 1];
        stream.read_exact(&mut request).ok()?;
        asked.lock().unwrap().push(request.clone());
        let function = request[0];
        let count = usize::from(u16::from_be_bytes([request[3], request[4]]));
        let mut answer = match function {
            1 | 2 => [
                vec![function, count.div_ceil(8) as u8],
                vec![0xFF; count.div_ceil(8)],
            ]
            .concat(),
            3 | 4 => [vec![function, count as u8 * 2], [0x40, 0].repeat(count)].concat(),
            _ => request[..5].to_vec(),
        };
        match *manner.lock().unwrap() {
            Manner::Works => {}
            Manner::Refuses => answer = vec![function | 0x80, 2],
            Manner::Closes => return None,
            Manner::Silent => continue,
            Manner::Short => answer = vec![function, 2, 0, 0],
            Manner::Confused => header[1] ^= 1,
            Manner::Garbage => header[2] = 9,
            Manner::Half => {
                stream.write_all(&header[..5]).ok()?;
                continue;
            }
        }
        header[5] = answer.len() as u8 + 1;
        stream.write_all(&[&header[..], &answer].concat()).ok()?;
    }
}

#[test]
fn outputs_are_written_after_a_scan_and_at_the_end_as_before_it() {
    let fake = Fake::new(Manner::Works);
    let mut controller = Controller::new(fake.address);
    fake.is_asked_again();
    assert_eq!(fake.writes(), [[0_u8; 0]; 0]);
    controller.until(|controller| controller.is_high("rio_ok") && controller.is_high("%QX10.0"));
    fake.is_asked_again();
    // The coil alone, and the speed of two words.
    assert_eq!(
        fake.writes(),
        [vec![5, 0, 0, 0xFF, 0], vec![16, 0, 4, 0, 2, 4, 0, 1, 0x11, 0x70]]
    );
    // Nothing that has not changed is written a second time.
    fake.is_asked_again();
    assert_eq!(fake.writes(), [[0_u8; 0]; 0]);
    let Controller {
        devices, simulation, ..
    } = controller;
    devices.finish(&simulation);
    assert_eq!(
        fake.writes(),
        [vec![5, 0, 0, 0, 0], vec![16, 0, 4, 0, 2, 4, 0, 0, 0, 7]]
    );
}

#[test]
fn a_device_that_is_lost_is_told_and_comes_back() {
    let fake = Fake::new(Manner::Works);
    let mut controller = Controller::new(fake.address);
    controller.until(|controller| controller.is_high("rio_ok"));
    let last = controller.value("level");
    fake.set(Manner::Silent);
    controller.until(|controller| !controller.is_high("rio_ok"));
    assert!(matches!(controller.value("rio_age"), Value::Int(age) if age > 100_000_000));
    // The last values are kept.
    assert_eq!(controller.value("level"), last);
    assert!(controller.is_high("%IX10.1"));
    fake.writes();
    fake.set(Manner::Works);
    controller.until(|controller| controller.is_high("rio_ok"));
    controller.until(|_| fake.asked.lock().unwrap().iter().any(|request| request[0] == 16));
    expect![[r#"
        device rio answers
        device rio does not answer within 500ms; it is tried again
        device rio answers"#]]
    .assert_eq(&controller.told());
}

#[test]
fn what_is_wrong_with_a_device_is_a_sentence() {
    let told = |manner| {
        let fake = Fake::new(manner);
        let mut controller = Controller::new(fake.address);
        controller.until(|controller| !controller.told().is_empty());
        controller.scan();
        assert!(!controller.is_high("rio_ok"));
        assert_eq!(fake.writes(), [[0_u8; 0]; 0]);
        format!("{manner:?}: {}\n", controller.told())
    };
    let manners = [
        Manner::Refuses,
        Manner::Closes,
        Manner::Silent,
        Manner::Short,
        Manner::Confused,
        Manner::Garbage,
        Manner::Half,
    ];
    expect![[r#"
        Refuses: device rio refuses discrete 1: it has no such places; numbers count from 0 here (exception 2); it is tried again
        Closes: device rio has closed the connection; it is tried again
        Silent: device rio does not answer within 500ms; it is tried again
        Short: device rio answers with 1 of the 2 places of input 200..201; it is tried again
        Confused: device rio does not answer what it is asked for discrete 1; it is tried again
        Garbage: device rio answers what is not Modbus: Invalid protocol identifier: expected = 0, actual = 2304; it is tried again
        Half: device rio does not answer within 500ms; it is tried again
    "#]].assert_eq(&manners.map(told).concat());
    let nobody = TcpListener::bind((Ipv4Addr::LOCALHOST, 0))
        .unwrap()
        .local_addr()
        .unwrap();
    let mut controller = Controller::new(nobody);
    controller.until(|controller| !controller.told().is_empty());
    let told = controller.told().replace(&nobody.to_string(), "ADDRESS");
    assert!(
        told.starts_with("device rio cannot be reached at ADDRESS: "),
        "{told}"
    );
    // The end is not waited for.
    let began = Instant::now();
    controller.devices.finish(&controller.simulation);
    assert!(began.elapsed() < Duration::from_millis(900));
}
