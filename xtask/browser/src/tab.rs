//! A page in the browser, by Chromium's debugging protocol.

use crate::chromium::Chromium;
use crate::picture::Picture;
use anyhow::{Context, Result, bail};
use base64::Engine;
use serde_json::{Value, json};
use std::time::{Duration, Instant};
use tungstenite::Message;

pub struct Tab<'a> {
    browser: &'a mut Chromium,
    session: String,
    number: u64,
    /// Errors that the page has told of, and requests that leave this machine.
    pub complaints: Vec<String>,
}

impl<'a> Tab<'a> {
    pub fn open(browser: &'a mut Chromium, [width, height]: [u32; 2]) -> Result<Self> {
        let mut tab = Self { browser, session: String::new(), number: 0, complaints: Vec::new() };
        let target = tab.call("Target.createTarget", json!({ "url": "about:blank" }))?;
        let attached = tab.call("Target.attachToTarget", json!({ "targetId": target["targetId"], "flatten": true }))?;
        tab.session = attached["sessionId"].as_str().context("no session")?.to_owned();
        for domain in ["Runtime", "Log", "Page", "Network"] {
            tab.call(&format!("{domain}.enable"), json!({}))?;
        }
        let size = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
        tab.call("Emulation.setDeviceMetricsOverride", size)?;
        Ok(tab)
    }

    /// Sends a command and waits for its answer; notes what is told meanwhile.
    pub fn call(&mut self, method: &str, parameters: Value) -> Result<Value> {
        self.number += 1;
        let mut message = json!({ "id": self.number, "method": method, "params": parameters });
        if !self.session.is_empty() {
            message["sessionId"] = json!(self.session);
        }
        self.browser.socket.send(Message::text(message.to_string()))?;
        loop {
            let Message::Text(text) = self.browser.socket.read().context("the browser does not answer")? else {
                continue;
            };
            let answer: Value = serde_json::from_str(&text)?;
            if answer["id"] == json!(self.number) {
                if let Some(error) = answer.get("error") {
                    bail!("{method}: {error}");
                }
                return Ok(answer["result"].clone());
            }
            self.note(&answer);
        }
    }

    fn note(&mut self, event: &Value) {
        let told = &event["params"];
        match event["method"].as_str().unwrap_or_default() {
            "Runtime.exceptionThrown" => self.complaints.push(told["exceptionDetails"].to_string()),
            "Runtime.consoleAPICalled" if told["type"] == "error" => self.complaints.push(told["args"].to_string()),
            "Log.entryAdded" if told["entry"]["level"] == "error" => self.complaints.push(told["entry"].to_string()),
            "Network.requestWillBeSent" => {
                let url = told["request"]["url"].as_str().unwrap_or_default();
                if !(url.starts_with("file:") || url.starts_with("data:") || url.starts_with("about:")) {
                    self.complaints.push(format!("a request to {url}"));
                }
            }
            _ => {}
        }
    }

    /// What an expression comes to in the page.
    pub fn ask(&mut self, expression: &str) -> Result<Value> {
        let asked = json!({ "expression": expression, "returnByValue": true, "awaitPromise": true });
        let answer = self.call("Runtime.evaluate", asked)?;
        if let Some(thrown) = answer.get("exceptionDetails") {
            bail!("`{expression}` throws {thrown}");
        }
        Ok(answer["result"]["value"].clone())
    }

    pub fn number(&mut self, expression: &str) -> Result<f64> {
        let value = self.ask(expression)?;
        value.as_f64().with_context(|| format!("`{expression}` is {value}, and no number"))
    }

    /// Waits until the expression is true.
    pub fn wait(&mut self, expression: &str, limit: Duration) -> Result<()> {
        let start = Instant::now();
        while self.ask(expression)? != json!(true) {
            if start.elapsed() > limit {
                bail!("`{expression}` is not true after {} s; the page says {:?}", limit.as_secs(), self.complaints);
            }
            std::thread::sleep(Duration::from_millis(30));
        }
        Ok(())
    }

    /// The middle of an element, or another part of it.
    pub fn place(&mut self, id: &str, [across, down]: [f64; 2]) -> Result<[f64; 2]> {
        let part = |side: &str| format!("document.getElementById('{id}').getBoundingClientRect().{side}");
        let x = self.number(&format!("{} + {across} * {}", part("left"), part("width")))?;
        let y = self.number(&format!("{} + {down} * {}", part("top"), part("height")))?;
        Ok([x, y])
    }

    pub fn mouse(&mut self, kind: &str, [x, y]: [f64; 2]) -> Result<()> {
        let buttons = u8::from(kind != "mouseReleased");
        let event = json!({ "type": kind, "x": x, "y": y, "button": "left", "buttons": buttons, "clickCount": 1 });
        self.call("Input.dispatchMouseEvent", event).map(|_| ())
    }

    pub fn click(&mut self, id: &str, at: [f64; 2]) -> Result<()> {
        let place = self.place(id, at)?;
        self.mouse("mousePressed", place)?;
        self.mouse("mouseReleased", place)
    }

    pub fn touch(&mut self, kind: &str, fingers: &[[f64; 2]]) -> Result<()> {
        let points: Vec<Value> =
            fingers.iter().enumerate().map(|(id, [x, y])| json!({ "x": x, "y": y, "id": id })).collect();
        self.call("Input.dispatchTouchEvent", json!({ "type": kind, "touchPoints": points })).map(|_| ())
    }

    /// What is seen, once everything asked for has been drawn.
    pub fn picture(&mut self) -> Result<Picture> {
        self.ask("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))")?;
        let shot = self.call("Page.captureScreenshot", json!({ "format": "png" }))?;
        let text = shot["data"].as_str().context("no picture")?;
        Picture::decode(base64::engine::general_purpose::STANDARD.decode(text)?)
    }
}
