//! Reads from an ELF file what the checks need: the functions with their code, and every symbol's name.

use anyhow::{Context, Result, bail};
use object::{Object, ObjectSection, ObjectSymbol, SectionKind, SymbolKind};
use std::collections::BTreeMap;

/// A linked program.
pub struct Image {
    /// By address, ascending; no two at the same address.
    pub functions: Vec<Function>,
    /// The names of all symbols, functions or not, as people read them.
    pub names: Vec<String>,
}

/// A function.
pub struct Function {
    pub address: u32,
    /// All its names: one function may go by several.
    pub names: Vec<String>,
    /// Its instructions and literals.
    pub code: Vec<u8>,
    /// The offset of each stretch of instructions or literals in `code`, and whether it is instructions.
    pub stretches: Vec<(u32, bool)>,
}

impl Function {
    /// The address behind its last byte.
    pub fn end(&self) -> u32 {
        self.address + self.code.len() as u32
    }

    /// The name to print.
    pub fn name(&self) -> &str {
        self.names.first().map_or("?", String::as_str)
    }
}

impl Image {
    /// Reads an ELF file that has been read into memory.
    pub fn parse(bytes: &[u8]) -> Result<Self> {
        let file = object::File::parse(bytes).context("not an ELF file")?;
        let mut names = Vec::new();
        // Address -> names and size; and where code and literals begin ("mapping symbols" $t and $d).
        let mut found: BTreeMap<u32, (Vec<String>, u32)> = BTreeMap::new();
        let mut marks: BTreeMap<u32, bool> = BTreeMap::new();
        for symbol in file.symbols() {
            let raw = symbol.name().unwrap_or_default();
            let address = symbol.address() as u32;
            match raw.get(..2) {
                Some("$t") => drop(marks.insert(address, true)),
                Some("$d") => drop(marks.insert(address, false)),
                _ if raw.is_empty() || symbol.is_undefined() => {}
                _ => {
                    let name = readable(raw);
                    if symbol.kind() == SymbolKind::Text {
                        // The lowest bit says "Thumb".
                        let entry = found.entry(address & !1).or_default();
                        entry.0.push(name.clone());
                        entry.1 = entry.1.max(symbol.size() as u32);
                    }
                    names.push(name);
                }
            }
        }
        if found.is_empty() {
            bail!("the ELF file has no function symbols: was it stripped?");
        }

        let mut functions = Vec::new();
        let mut following: Vec<u32> = found.keys().skip(1).copied().collect();
        following.push(u32::MAX);
        for ((address, (names, size)), next) in found.into_iter().zip(following) {
            // Hand-written assembly may come without a size: it ends where the next function begins.
            let code = code_at(&file, address, size, next)?;
            let stretches = stretches(&marks, address, code.len() as u32);
            functions.push(Function { address, names, code, stretches });
        }
        Ok(Image { functions, names })
    }

    /// The function that an address lies in.
    pub fn function_at(&self, address: u32) -> Option<usize> {
        let after = self.functions.partition_point(|function| function.address <= address);
        let index = after.checked_sub(1)?;
        let inside = address < self.functions[index].end().max(self.functions[index].address + 1);
        inside.then_some(index)
    }

    /// The function that begins at an address.
    pub fn function_from(&self, address: u32) -> Option<usize> {
        self.functions.binary_search_by_key(&address, |function| function.address).ok()
    }
}

fn readable(symbol: &str) -> String {
    // The alternate form leaves the hash out.
    format!("{:#}", rustc_demangle::demangle(symbol))
}

fn code_at(file: &object::File<'_>, address: u32, size: u32, next: u32) -> Result<Vec<u8>> {
    for section in file.sections().filter(|section| section.kind() == SectionKind::Text) {
        let start = section.address() as u32;
        let data = section.data()?;
        let end = start + data.len() as u32;
        if (start..end).contains(&address) {
            let size = if size == 0 { next.min(end) - address } else { size };
            let from = (address - start) as usize;
            return Ok(data.get(from..from + size as usize).context("a function leaves its section")?.to_vec());
        }
    }
    // A symbol of the linker script, beside all code.
    Ok(Vec::new())
}

fn stretches(marks: &BTreeMap<u32, bool>, address: u32, size: u32) -> Vec<(u32, bool)> {
    let before = marks.range(..=address).next_back().is_none_or(|(_, code)| *code);
    let mut stretches = vec![(0, before)];
    let inside = marks.range(address + 1..(address + size).max(address + 1));
    stretches.extend(inside.map(|(at, code)| (at - address, *code)));
    stretches
}
