//! `cargo xtask licences`: what the library depends on, in all its features, has a licence that `deny.toml` allows.

use crate::process;
use crate::toolchain::own_cargo;
use crate::workspace;
use anyhow::{Context, Result, bail};
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};

/// The part of `deny.toml` that is read.
#[derive(Deserialize)]
struct Deny {
    licenses: Licenses,
}

#[derive(Deserialize)]
struct Licenses {
    allow: Vec<String>,
}

/// The part of cargo's metadata that is read.
#[derive(Deserialize)]
struct Metadata {
    packages: Vec<Package>,
    resolve: Resolve,
}

#[derive(Deserialize)]
struct Package {
    id: String,
    name: String,
    version: String,
    license: Option<String>,
}

#[derive(Deserialize)]
struct Resolve {
    nodes: Vec<Node>,
}

#[derive(Deserialize)]
struct Node {
    id: String,
    deps: Vec<Dependency>,
}

#[derive(Deserialize)]
struct Dependency {
    pkg: String,
    dep_kinds: Vec<Kind>,
}

#[derive(Deserialize)]
struct Kind {
    /// `dev`, `build`, or none of an ordinary one.
    kind: Option<String>,
}

/// Checks them all and names what is not allowed.
pub fn run() -> Result<()> {
    let text = std::fs::read_to_string(workspace::root().join("deny.toml")).context("reading deny.toml")?;
    let allowed = toml::from_str::<Deny>(&text).context("deny.toml")?.licenses.allow;
    let mut cargo = own_cargo();
    let text = process::stdout_of(cargo.args(["metadata", "--format-version=1", "--all-features", "--locked"]))
        .with_context(|| format!("`{}` failed: is Cargo.lock up to date?", process::show(&cargo)))?;
    let metadata: Metadata = serde_json::from_str(&text).context("cargo's metadata")?;
    let packages = of_library(&metadata)?;
    let refused: Vec<String> =
        packages.iter().filter_map(|package| refusal(package, &allowed).transpose()).collect::<Result<_>>()?;
    if !refused.is_empty() {
        bail!("these licences are not among those of deny.toml ({}):\n  {}", allowed.join(", "), refused.join("\n  "));
    }
    println!("licences: {} packages, each under {}", packages.len(), allowed.join(", "));
    Ok(())
}

/// Why a package may not be used.
fn refusal(package: &Package, allowed: &[String]) -> Result<Option<String>> {
    let Package { name, version, license, .. } = package;
    let Some(license) = license else { return Ok(Some(format!("{name} {version}: none stated"))) };
    // Old manifests divide with a slash.
    let expression = spdx::Expression::parse_mode(license, spdx::ParseMode::LAX)
        .with_context(|| format!("{name} {version} states `{license}`"))?;
    let is_allowed = |id: &str| allowed.iter().any(|one| one == id);
    let fits = expression.evaluate(|wanted| wanted.license.id().is_some_and(|id| is_allowed(id.name)));
    Ok((!fits).then(|| format!("{name} {version}: {license}")))
}

/// The library and what it needs to be built, without what its tests use.
fn of_library(metadata: &Metadata) -> Result<Vec<&Package>> {
    let packages: BTreeMap<&str, &Package> = metadata.packages.iter().map(|one| (one.id.as_str(), one)).collect();
    let nodes: BTreeMap<&str, &Node> = metadata.resolve.nodes.iter().map(|one| (one.id.as_str(), one)).collect();
    let carom =
        metadata.packages.iter().find(|package| package.name == "carom").context("there is no package carom")?;
    let (mut seen, mut left) = (BTreeSet::new(), vec![carom.id.as_str()]);
    while let Some(id) = left.pop() {
        if seen.insert(id) {
            let node = nodes.get(id).with_context(|| format!("cargo does not resolve {id}"))?;
            let needed = |dep: &&Dependency| dep.dep_kinds.iter().any(|kind| kind.kind.as_deref() != Some("dev"));
            left.extend(node.deps.iter().filter(needed).map(|dep| dep.pkg.as_str()));
        }
    }
    seen.into_iter().map(|id| packages.get(id).copied().with_context(|| format!("cargo does not know {id}"))).collect()
}

#[cfg(test)]
mod tests {
    use super::{Package, refusal};

    #[test]
    fn expressions_are_weighed() {
        let allowed = ["MIT", "Apache-2.0"].map(str::to_owned);
        let refused = |license: Option<&str>| {
            let (id, name, version) = (String::new(), "a".to_owned(), "1.0.0".to_owned());
            let package = Package { id, name, version, license: license.map(str::to_owned) };
            refusal(&package, &allowed).expect("an expression").is_some()
        };
        for fine in ["MIT", "MIT OR GPL-3.0-only", "MIT/Apache-2.0", "(MIT OR Zlib) AND Apache-2.0"] {
            assert!(!refused(Some(fine)), "{fine}");
        }
        for bad in ["GPL-3.0-only", "MIT AND GPL-3.0-only", "Apache-2.0 WITH LLVM-exception AND Zlib"] {
            assert!(refused(Some(bad)), "{bad}");
        }
        assert!(refused(None));
    }
}
