//! `bridge`: the serial port of a robot as a WebSocket, for the page and for programs on other computers.

mod clients;
mod gate;
mod robot_port;
mod service;

use super::{failure::Failure, output::say, signals::end_requested};
use clients::{Clients, Heard};
use gate::Gate;
use robot_port::RobotSerialPort;
pub use robot_port::cannot_open;
use roomba_bridge::{Bridge, ClientId, Ends, FromBridge, Full, Halted, Limits, MAX_CLIENTS};
use service::Service;
use std::{
    io,
    net::{SocketAddr, TcpListener, ToSocketAddrs},
    sync::{
        LazyLock,
        atomic::{AtomicBool, Ordering},
        mpsc::{SyncSender, sync_channel},
    },
    thread,
    time::{Duration, Instant},
};

/// Time between two attempts to open a serial port that is gone.
const AGAIN: Duration = Duration::from_millis(500);
/// Lines of the log that wait for a reader; later ones are dropped.
const MOST_LINES: usize = 256;
/// Time for the last messages to leave, and for the last stop to be repeated.
const LAST_WORDS: Duration = Duration::from_millis(400);

/// Connect a robot's serial port to the network, for the page's tab Robot. Stops the robot when the page is silent for
/// 0.2 s, when its connection ends, and when the bridge starts or ends. One page drives, others can watch
#[derive(clap::Args)]
pub struct Arguments {
    /// Serial port, such as /dev/ttyUSB0 or COM3 [default: the only USB serial port]
    #[arg(long)]
    port: Option<String>,
    /// Address and TCP port to listen on; 0.0.0.0:7626 for all networks of this computer
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1:7626")]
    listen: String,
    /// Secret that clients must give, at least 8 letters or digits. Without it, a token is made up and printed at every
    /// start; addresses that only this computer can reach need none
    #[arg(long, value_name = "SECRET", env = "ROBOVAC_TOKEN", hide_env_values = true, value_parser = parse_token)]
    token: Option<String>,
    /// Accept all clients without a token; only for a network that is yours alone
    #[arg(long, conflicts_with = "token")]
    no_token: bool,
    /// Also accept pages of this origin, such as `https://example.org`. Pages of localhost are always accepted
    #[arg(long = "origin", value_name = "ORIGIN", value_parser = parse_origin)]
    origins: Vec<String>,
    /// Baud rate of the robot at the start
    #[arg(long, default_value_t = 115_200, value_parser = parse_baud)]
    baud: u32,
}

fn parse_token(text: &str) -> Result<String, String> {
    let fits = text.len() >= 8 && text.bytes().all(|byte| byte.is_ascii_alphanumeric());
    fits.then(|| text.to_owned()).ok_or_else(|| "it needs at least 8 letters or digits, and nothing else".to_owned())
}

fn parse_origin(text: &str) -> Result<String, String> {
    let rest = text.strip_prefix("https://").or_else(|| text.strip_prefix("http://")).unwrap_or_default();
    let fits = !rest.is_empty() && !rest.contains(['/', '?', '#', ' ']);
    fits.then(|| text.to_ascii_lowercase())
        .ok_or_else(|| "an origin is a scheme and a host, such as https://example.org, without a path".to_owned())
}

fn parse_baud(text: &str) -> Result<u32, String> {
    let rates = roomba_oi::BAUD_RATES;
    text.parse()
        .ok()
        .filter(|baud| rates.contains(baud))
        .ok_or_else(|| format!("the Open Interface has {}", rates.map(|rate| rate.to_string()).join(", ")))
}

pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let is_over = end_requested()?;
    let listener = TcpListener::bind(&arguments.listen).map_err(|e| cannot_listen(&arguments.listen, &e))?;
    let address = listener.local_addr().map_err(|e| Failure::io(&arguments.listen, &e))?;
    let is_local = arguments.listen.to_socket_addrs().is_ok_and(|mut all| all.all(|one| one.ip().is_loopback()));
    let token = match &arguments.token {
        Some(token) => Some(token.clone()),
        None if is_local || arguments.no_token => None,
        None => Some(new_token()?),
    };
    // Before anybody is told that it is ready: a wrong port should be noticed at once.
    let port = RobotSerialPort::open(arguments.port.as_deref(), arguments.baud)?;
    let clients = Clients::new(listener, Gate::new(token.clone(), arguments.origins.clone()))?;
    say(&format!("ready {}", address_for_users(address, token.as_deref())));
    let bridge = Bridge::new(Limits::default(), arguments.baud);
    let service = Service::from_environment();
    BridgeHost { arguments, began: Instant::now(), clients, port: Some(port), bridge, service, halted: None }
        .run(&is_over);
    Ok(String::new())
}

fn cannot_listen(address: &str, error: &io::Error) -> Failure {
    let port = address.rsplit_once(':').map_or("", |(_, port)| port);
    match error.kind() {
        io::ErrorKind::AddrInUse => Failure::system(format!(
            "can't listen on {address}: another program does already, perhaps another bridge. End it, or use --listen \
             with a port other than {port}"
        )),
        io::ErrorKind::AddrNotAvailable => Failure::system(format!(
            "can't listen on {address}: this computer doesn't have that address. Use --listen with one that it has, or 0.0.0.0:{port} for all of them"
        )),
        io::ErrorKind::PermissionDenied => Failure::system(format!(
            "can't listen on {address}: permission denied. Use --listen with a port from 1024 on"
        )),
        _ => Failure::system(format!(
            "can't listen on {address}: {error}. Use --listen with an address of this computer and a port, such as 0.0.0.0:7626"
        )),
    }
}

/// 16 hexadecimal digits.
fn new_token() -> Result<String, Failure> {
    let mut bytes = [0; 8];
    getrandom::fill(&mut bytes)
        .map_err(|e| Failure::usage(format!("can't generate a token: {e}; give one with --token")))?;
    Ok(format!("{:016x}", u64::from_le_bytes(bytes)))
}

fn address_for_users(address: SocketAddr, token: Option<&str>) -> String {
    let host = if address.ip().is_unspecified() { "ADDRESS-OF-THIS-COMPUTER".to_owned() } else { ip_in_url(address) };
    let token = token.map(|token| format!("?token={token}")).unwrap_or_default();
    format!("ws://{host}:{}/{token}", address.port())
}

fn ip_in_url(address: SocketAddr) -> String {
    if address.is_ipv6() { format!("[{}]", address.ip()) } else { address.ip().to_string() }
}

/// The rules with what they are applied to.
struct BridgeHost<'a> {
    arguments: &'a Arguments,
    began: Instant,
    bridge: Bridge,
    clients: Clients,
    /// None while it is gone.
    port: Option<RobotSerialPort>,
    service: Service,
    /// Why the robot was stopped last, until that client or another one drives.
    halted: Option<Halted>,
}

/// What the rules act on.
struct BridgeWires<'a> {
    began: Instant,
    clients: &'a mut Clients,
    port: Option<&'a mut RobotSerialPort>,
    halted: &'a mut Option<Halted>,
}

impl Ends for BridgeWires<'_> {
    fn robot(&mut self, command: &[u8]) -> bool {
        self.port.as_mut().is_none_or(|port| port.queue(command))
    }

    fn stop(&mut self, bytes: &[u8]) {
        if let Some(port) = &mut self.port {
            port.stop(bytes);
        }
    }

    fn baud(&mut self, baud: u32) {
        if let Some(port) = &mut self.port {
            port.set_baud(baud);
        }
    }

    fn brc(&mut self, is_low: bool) {
        if let Some(port) = &mut self.port {
            port.set_brc(is_low);
        }
    }

    fn tell(&mut self, client: ClientId, word: FromBridge) {
        match word {
            FromBridge::Drive(_) => {
                report(self.began, &format!("client {client} may drive"));
                *self.halted = None;
            }
            // It is told to all clients.
            FromBridge::Halted(why) if self.halted.replace(why).is_none() => {
                report(self.began, &format!("the robot was stopped: {why}"));
            }
            FromBridge::Watch => report(self.began, &format!("client {client} watches")),
            _ => {}
        }
        self.clients.tell(client, &word.to_string());
    }

    fn close(&mut self, client: ClientId, why: &str) {
        report(self.began, &format!("client {client} is disconnected: {why}"));
        self.clients.close(client, why);
    }
}

/// Prints a line without ever waiting for whoever reads it: a terminal that stands still must not hold up a stop.
fn report(began: Instant, text: &str) {
    static PRINTER: LazyLock<SyncSender<String>> = LazyLock::new(|| {
        let (sender, lines) = sync_channel::<String>(MOST_LINES);
        thread::spawn(move || lines.into_iter().for_each(|line| say(&line)));
        sender
    });
    let _ = PRINTER.try_send(format!("{:9.3}  {text}", began.elapsed().as_secs_f64()));
}

impl BridgeHost<'_> {
    fn run(mut self, is_over: &AtomicBool) {
        self.opened();
        self.service.ready();
        let mut buffer = [0; 4096];
        while !is_over.load(Ordering::Relaxed) {
            match self.port.as_mut().map(|port| port.read(&mut buffer)) {
                Some(Ok(count)) => self.clients.send_all(buffer.get(..count).unwrap_or_default()),
                Some(Err(error)) => self.lost(&error.to_string()),
                None => self.find_again(),
            }
            self.round();
            let now_ms = self.now_ms();
            self.service.alive(now_ms);
        }
        let (ended, now_ms) = (Instant::now(), self.now_ms());
        let (bridge, mut wires) = self.parts();
        bridge.ended(now_ms, &mut wires);
        while (self.clients.is_closing() || self.bridge.is_stopping()) && ended.elapsed() < LAST_WORDS {
            // Whoever comes now comes too late.
            let now_ms = self.now_ms();
            self.clients.listen(now_ms);
            let (bridge, mut wires) = self.parts();
            bridge.tick(now_ms, &mut wires);
            thread::sleep(Duration::from_millis(2));
        }
        if let Some(port) = &mut self.port {
            port.finish();
        }
    }

    /// What has come from clients, and what is due.
    fn round(&mut self) {
        let now_ms = self.now_ms();
        for heard in self.clients.listen(now_ms) {
            self.take(heard);
        }
        let now_ms = self.now_ms();
        let (bridge, mut wires) = self.parts();
        bridge.tick(now_ms, &mut wires);
        if let Some(port) = &mut self.port {
            port.pump();
        }
    }

    fn parts(&mut self) -> (&mut Bridge, BridgeWires<'_>) {
        let Self { began, clients, port, halted, bridge, .. } = self;
        (bridge, BridgeWires { began: *began, clients, port: port.as_mut(), halted })
    }

    fn now_ms(&self) -> u64 {
        u64::try_from(self.began.elapsed().as_millis()).unwrap_or(u64::MAX)
    }

    fn take(&mut self, heard: Heard) {
        let now_ms = self.now_ms();
        let is_there = self.port.is_some();
        let began = self.began;
        let (bridge, mut wires) = self.parts();
        match heard {
            Heard::Joined(client, from) => {
                report(began, &format!("client {client} connects from {from}"));
                if !is_there {
                    wires.close(client, "the robot's serial port is gone: plug it in");
                } else if bridge.joined(client, now_ms, &mut wires) == Err(Full) {
                    wires.close(
                        client,
                        &format!("all {MAX_CLIENTS} connections are in use; close a page that only watches"),
                    );
                }
            }
            Heard::Bytes(client, bytes) => bridge.bytes(client, &bytes, now_ms, &mut wires),
            Heard::Text(client, text) => bridge.text(client, &text, now_ms, &mut wires),
            Heard::Left(client) => {
                bridge.left(client, now_ms, &mut wires);
                report(began, &format!("client {client} has left"));
            }
            Heard::Refused(from, why) => report(began, &format!("refused {from}: {why}")),
        }
    }

    fn opened(&mut self) {
        if let Some(port) = &mut self.port {
            report(self.began, &format!("{} is open; the robot is stopped and woken", port.name()));
        }
        let now_ms = self.now_ms();
        let (bridge, mut wires) = self.parts();
        bridge.opened(now_ms, &mut wires);
        if let Some(port) = &mut self.port {
            port.wake();
        }
    }

    fn lost(&mut self, why: &str) {
        let name = self.port.take().map(|port| port.name().to_owned()).unwrap_or_default();
        report(self.began, &format!("{name} is lost: {why}"));
        let (bridge, mut wires) = self.parts();
        bridge.closed("the robot's serial port is gone: plug it in", &mut wires);
    }

    fn find_again(&mut self) {
        thread::sleep(AGAIN);
        self.port = RobotSerialPort::open(self.arguments.port.as_deref(), self.arguments.baud).ok();
        if self.port.is_some() {
            self.opened();
        }
    }
}
