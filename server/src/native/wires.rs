//! Controllers on the network, and clients on this computer.

use std::net::{Ipv4Addr, SocketAddr};
use std::time::Instant;

use ladder_analysis::values::value::Value;
use ladder_devices::modbus::{self, Image, Listening, Map, NOTHING, ToServe, Wrong, serve};
use ladder_devices::online::Controller;
use ladder_host::{Connection, Served, Wires};
use ladder_simulator::online::Online;
use ladder_simulator::{Point, Simulation};
use ladder_workspace::{Misfit, Online as Asked, ServeModbus, Settings};

/// The network that the machine has.
#[derive(Debug)]
pub(super) struct Network;

impl Wires for Network {
    fn watch(&self, asked: &Asked, stem: &str, program: &Online) -> Result<Connection, String> {
        let controller = Controller::of(asked)
            .ok_or("[online] in ladder.toml names no controller: write logix = \"192.168.1.10/0\" or modbus = \"192.168.1.20:502\"")?;
        // Who shows it looks by itself.
        let watch = controller
            .watch(stem, program, || {})
            .map_err(|wrong| sentence(wrong.into_iter().map(|wrong| wrong.message)))?;
        Ok((controller.to_string(), Box::new(watch)))
    }

    fn serve(&self, asked: &ServeModbus, simulation: &Simulation) -> Result<Box<dyn Served>, String> {
        let ToServe {
            address,
            map,
            hold,
            rules,
        } = to_serve(asked, simulation)?;
        let (all, written) = counts(&map);
        let image = Image::new(map, hold, simulation);
        // Whatever the settings say: an editor shows nothing to other machines.
        let address = SocketAddr::from((Ipv4Addr::LOCALHOST, address.port()));
        let listening = serve(address, &image, rules, |_| {}).map_err(|error| {
            format!("Modbus cannot be served on {address}: {error}; `listen` in [serve.modbus] of ladder.toml names another port")
        })?;
        Ok(Box::new(Clients {
            about: format!(
                "Modbus on {}: {all} tags, {written} can be written",
                listening.address
            ),
            asked: asked.clone(),
            image,
            _listening: listening,
        }))
    }

    fn misfits(&self, settings: &Settings, simulation: &Simulation) -> Vec<Misfit> {
        modbus::misfits(settings, simulation)
    }
}

/// Clients that are served.
#[derive(Debug)]
struct Clients {
    about: String,
    asked: ServeModbus,
    image: Image,
    _listening: Listening,
}

impl Served for Clients {
    fn about(&self) -> String {
        self.about.clone()
    }

    fn written(&self, simulation: &Simulation) -> Vec<(Point, Value)> {
        self.image.written(simulation, Instant::now())
    }

    fn show(&self, simulation: &Simulation) {
        self.image.take(simulation);
    }

    fn replace(&self, simulation: &Simulation) -> Result<(), String> {
        let served = to_serve(&self.asked, simulation)?;
        self.image
            .replace(&Image::new(served.map, served.hold, simulation));
        Ok(())
    }
}

fn to_serve(asked: &ServeModbus, simulation: &Simulation) -> Result<ToServe, String> {
    let served = ToServe::of(asked, simulation);
    let served =
        served.map_err(|wrong: Vec<Wrong>| sentence(wrong.into_iter().map(|wrong| wrong.message)))?;
    if served.map.is_empty() {
        return Err(NOTHING.to_owned());
    }
    Ok(served)
}

/// How many tags there are, and how many of them clients may write.
fn counts(map: &Map) -> (usize, usize) {
    (map.tags().count(), map.tags().filter(|tag| tag.2).count())
}

fn sentence(messages: impl Iterator<Item = String>) -> String {
    messages.collect::<Vec<_>>().join("; ")
}
