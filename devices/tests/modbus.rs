//! A server next to a client that others wrote, and bytes that no client sends.

use ladder_devices::modbus::{Hold, Image, Listening, Map, Named, Places, Rules, serve};
use ladder_simulator::{Options, Simulation};
use std::io::{Read, Write};
use std::net::{Ipv4Addr, SocketAddr, TcpStream};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use tokio_modbus::client::{Context, tcp};
use tokio_modbus::prelude::{Client as _, ExceptionCode, Reader as _, Request, Slave, Writer as _};

const PUMP: &str = "VAR_INPUT\n    go AT %IX0.0 : BOOL;\n    wanted : REAL;\nEND_VAR\nVAR_OUTPUT\n    on AT %QX0.3 : BOOL;\n    got : REAL;\nEND_VAR\n\
    +--[GT]( wanted, 1.0 )--( )( on )--+\n+--[MOV]( got, wanted )--+\n";

struct Served {
    image: Image,
    simulation: Simulation,
    address: SocketAddr,
    told: Arc<Mutex<Vec<String>>>,
    /// It is served as long as this is there.
    listening: Listening,
}

impl Served {
    fn new(rules: Rules) -> Served {
        Served::of(rules, |map| map)
    }

    /// With another map than the one of the settings.
    fn of(rules: Rules, changed: impl Fn(Map) -> Map) -> Served {
        let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(PUMP)), "pump");
        let program = analysis.program().unwrap().clone();
        let simulation = Simulation::new(program, Options::default()).unwrap();
        let named = [("holding 10", "wanted"), ("holding 12", "got")].map(|(place, tag)| Named {
            place: place.to_owned(),
            tag: tag.to_owned(),
            at: 0..0,
        });
        let places = Places {
            named: named.to_vec(),
            write: vec![("wanted".to_owned(), 0..0)],
            ..Places::default()
        };
        let map = changed(Map::new(&places, &simulation).unwrap());
        let image = Image::new(map, Hold::Last, &simulation);
        let told = Arc::<Mutex<Vec<String>>>::default();
        let keep = told.clone();
        let tell = move |line: &str| keep.lock().unwrap().push(line.to_owned());
        let any = SocketAddr::from((Ipv4Addr::LOCALHOST, 0));
        let listening = serve(any, &image, rules, tell).unwrap();
        Served {
            image,
            simulation,
            address: listening.address,
            told,
            listening,
        }
    }

    fn scan(&mut self) {
        self.image.give(&mut self.simulation, Instant::now());
        self.simulation.scan();
        self.image.take(&self.simulation);
    }

    async fn client(&self, unit: u8) -> Context {
        tcp::connect_slave(self.address, Slave(unit)).await.unwrap()
    }
}

/// A runtime for a client: the tests are plain functions, as the scans are.
fn with_client<T>(asks: impl Future<Output = T>) -> T {
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
    runtime.unwrap().block_on(asks)
}

#[test]
fn a_server_ends_with_its_handle() {
    let Served {
        address, listening, ..
    } = Served::new(Rules::default());
    drop(listening);
    let end = Instant::now() + Duration::from_secs(30);
    while TcpStream::connect(address).is_ok() {
        assert!(Instant::now() < end);
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn a_client_reads_and_writes() {
    let mut served = Served::new(Rules::default());
    with_client(async {
        let mut client = served.client(1).await;
        let word = client.read_holding_registers(12, 2).await.unwrap();
        assert_eq!(word, Ok(vec![0, 0]));
        // 1.2, the high word first.
        client
            .write_multiple_registers(10, &[16281, 39322])
            .await
            .unwrap()
            .unwrap();
        served.scan();
        assert_eq!(
            client.read_holding_registers(12, 2).await.unwrap(),
            Ok(vec![16281, 39322])
        );
        assert_eq!(client.read_coils(3, 1).await.unwrap(), Ok(vec![true]));
        assert_eq!(client.read_discrete_inputs(0, 1).await.unwrap(), Ok(vec![false]));
        for (request, exception) in [
            (
                Request::ReadInputRegisters(0, 1),
                ExceptionCode::IllegalDataAddress,
            ),
            (
                Request::ReadHoldingRegisters(10, 5),
                ExceptionCode::IllegalDataAddress,
            ),
            (
                Request::WriteSingleCoil(3, true),
                ExceptionCode::IllegalDataAddress,
            ),
            (
                Request::WriteSingleRegister(10, 7),
                ExceptionCode::IllegalDataValue,
            ),
            (
                Request::MaskWriteRegister(10, 0, 0),
                ExceptionCode::IllegalFunction,
            ),
        ] {
            let shown = format!("{request:?}");
            assert_eq!(client.call(request).await.unwrap(), Err(exception), "{shown}");
        }
    });
    let told = served.told.lock().unwrap().join("\n");
    assert_eq!(
        told,
        "Modbus client 127.0.0.1 is connected\nModbus client 127.0.0.1 writes\nModbus client 127.0.0.1 writes what it may not"
    );
}

#[test]
fn another_unit_is_not_here_and_nothing_is_written_where_nobody_may() {
    let served = Served::of(Rules::default(), Map::read_only);
    with_client(async {
        let mut other = served.client(7).await;
        assert_eq!(
            other.read_coils(3, 1).await.unwrap(),
            Err(ExceptionCode::GatewayTargetDevice)
        );
        let mut client = served.client(255).await;
        let written = client.write_multiple_registers(10, &[0, 0]).await.unwrap();
        assert_eq!(written, Err(ExceptionCode::IllegalDataAddress));
    });
}

/// Whether the other end has closed a connection: within the time that a busy machine needs.
fn is_closed(stream: &mut TcpStream) -> bool {
    stream.set_read_timeout(Some(Duration::from_secs(30))).unwrap();
    let mut byte = [0];
    matches!(stream.read(&mut byte), Ok(0)) || stream.read(&mut byte).is_ok_and(|read| read == 0)
}

#[test]
fn connections_are_few_and_do_not_wait_for_ever() {
    let served = Served::new(Rules {
        connections: 2,
        idle: Duration::from_millis(200),
        ..Rules::default()
    });
    let connect = || TcpStream::connect(served.address).unwrap();
    // Half a frame, and nothing at all: both are closed after a while.
    let mut half = connect();
    half.write_all(&[0, 1, 0, 0, 0, 6, 1, 3]).unwrap();
    let mut silent = connect();
    assert!(is_closed(&mut connect()), "the third is closed at once");
    assert!(is_closed(&mut half) && is_closed(&mut silent));
    with_client(async {
        let mut client = served.client(1).await;
        assert_eq!(client.read_coils(3, 1).await.unwrap(), Ok(vec![false]));
    });
    assert!(
        served
            .told
            .lock()
            .unwrap()
            .iter()
            .any(|line| line.ends_with("finds all connections taken"))
    );
}

#[test]
fn who_is_not_allowed_is_closed() {
    let served = Served::new(Rules {
        allow: vec![ladder_devices::modbus::Subnet::parse("192.168.1.0/24").unwrap()],
        ..Rules::default()
    });
    assert!(is_closed(&mut TcpStream::connect(served.address).unwrap()));
}

/// Whatever bytes come, others are served.
#[test]
fn garbage_ends_its_own_connection() {
    let served = Served::new(Rules::default());
    let frames: [&[u8]; 7] = [
        b"GET / HTTP/1.1\r\n\r\n",
        &[0, 1, 0, 0, 0, 0, 1, 3],
        &[0, 1, 0, 9, 0, 6, 1, 3, 0, 0, 0, 1],
        // Functions cut off, counts that lie.
        &[0, 1, 0, 0, 0, 2, 1, 3],
        &[0, 1, 0, 0, 0, 7, 1, 15, 0, 0, 0xFF, 0xFF, 1],
        &[0, 1, 0, 0, 0, 8, 1, 16, 0, 10, 0, 2, 4, 1],
        &[0xFF; 300],
    ];
    for frame in frames {
        let mut stream = TcpStream::connect(served.address).unwrap();
        stream.write_all(frame).unwrap();
        let _ = stream.shutdown(std::net::Shutdown::Write);
        let mut rest = Vec::new();
        stream.set_read_timeout(Some(Duration::from_secs(30))).unwrap();
        let _ = stream.read_to_end(&mut rest);
        // At most an exception.
        assert!(rest.len() <= 9, "{frame:?}: {rest:?}");
    }
    with_client(async {
        let mut client = served.client(1).await;
        assert_eq!(client.read_coils(3, 1).await.unwrap(), Ok(vec![false]));
    });
}
