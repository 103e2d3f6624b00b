//! A Chromium of our own: started, spoken to, ended.

use anyhow::{Context, Result, bail};
use std::io::{BufRead, BufReader};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc;
use std::time::Duration;
use tempfile::TempDir;
use tungstenite::WebSocket;

const NAMES: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];
/// How long it may take to start, and to answer.
const PATIENCE: Duration = Duration::from_secs(60);

pub struct Chromium {
    child: Child,
    pub socket: WebSocket<TcpStream>,
    /// Its profile: it goes when the browser has gone.
    _profile: TempDir,
}

impl Chromium {
    /// Without a window, a graphics card, and anything that calls home.
    pub fn start() -> Result<Self> {
        let name = NAMES.into_iter().find(|name| {
            Command::new(name).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok()
        });
        let name = name.context("there is no Chromium: `cargo xtask test --only view` installs it")?;
        let profile = tempfile::tempdir()?;
        let mut chromium = Command::new(name);
        chromium.args(["--headless", "--no-sandbox", "--no-first-run", "--hide-scrollbars", "--mute-audio"]);
        chromium.args(["--disable-background-networking", "--disable-component-update", "--disable-sync"]);
        chromium.args(["--disable-dev-shm-usage", "--force-color-profile=srgb", "--remote-debugging-port=0"]);
        chromium.args(["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]);
        chromium.arg(format!("--user-data-dir={}", profile.path().display())).arg("about:blank");
        chromium.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
        let mut child = chromium.spawn().with_context(|| format!("cannot start {name}"))?;
        match connect(&mut child) {
            Ok(socket) => Ok(Self { child, socket, _profile: profile }),
            Err(error) => {
                end(&mut child);
                Err(error.context(format!("{name} cannot be spoken to")))
            }
        }
    }
}

impl Drop for Chromium {
    fn drop(&mut self) {
        end(&mut self.child);
    }
}

fn end(child: &mut Child) {
    let _ = child.kill();
    let _ = child.wait();
}

/// It says on standard error where it listens.
fn connect(child: &mut Child) -> Result<WebSocket<TcpStream>> {
    let errors = child.stderr.take().context("no standard error")?;
    let (sender, receiver) = mpsc::channel();
    // Read to the end, or a full pipe would block it.
    std::thread::spawn(move || {
        for line in BufReader::new(errors).lines().map_while(Result::ok) {
            let _ = sender.send(line);
        }
    });
    let mut said = String::new();
    loop {
        let Ok(line) = receiver.recv_timeout(PATIENCE) else {
            bail!("it did not say where it listens; it said:\n{said}")
        };
        if let Some(url) = line.strip_prefix("DevTools listening on ") {
            let host = url.trim_start_matches("ws://").split('/').next().unwrap_or_default();
            let stream = TcpStream::connect(host).with_context(|| format!("connecting to {host}"))?;
            stream.set_read_timeout(Some(PATIENCE))?;
            let (socket, _) = tungstenite::client(url, stream).map_err(|error| anyhow::anyhow!("{error}"))?;
            return Ok(socket);
        }
        said.push_str(&line);
        said.push('\n');
    }
}
