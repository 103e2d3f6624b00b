//! One page with everything in it: it needs no network and no server.

use crate::replay::Replay;
use anyhow::Result;

const FRAME: &str = include_str!("../page/index.html");
const STYLE: &str = include_str!("../page/style.css");
/// In the order in which they need each other.
const SCRIPTS: [(&str, &str); 7] = [
    ("algebra.js", include_str!("../page/algebra.js")),
    ("camera.js", include_str!("../page/camera.js")),
    ("shaders.js", include_str!("../page/shaders.js")),
    ("scene.js", include_str!("../page/scene.js")),
    ("plot.js", include_str!("../page/plot.js")),
    ("player.js", include_str!("../page/player.js")),
    ("app.js", include_str!("../page/app.js")),
];

/// The page.
pub fn page(replay: &Replay) -> Result<String> {
    // In a script element `</` would end it.
    let data = serde_json::to_string(replay)?.replace("</", "<\\/");
    let scripts: Vec<String> = SCRIPTS.iter().map(|(name, text)| format!("// {name}\n{text}")).collect();
    let title = format!("{} in {}", replay.words.example, replay.scalar);
    Ok(FRAME
        .replace("{{title}}", &escape(&title))
        .replace("/*{{style}}*/", STYLE)
        .replace("{{data}}", &data)
        .replace("/*{{scripts}}*/", &scripts.join("\n")))
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
