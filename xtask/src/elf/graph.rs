//! Who calls whom in a linked program.

use super::image::{Function, Image};
use super::thumb::{Op, decode};
use std::collections::{BTreeSet, VecDeque};

/// The call graph: one node per function of the image, in the same order.
pub struct Graph {
    nodes: Vec<Node>,
}

/// What a function does.
#[derive(Default)]
pub struct Node {
    /// The functions that it calls, jumps to, or holds the address of.
    pub callees: BTreeSet<usize>,
    /// It jumps to where no function is, or calls through a pointer while it holds no address of a function.
    pub calls_unknown: bool,
    /// It has instructions of the FPU that compute.
    pub computes_floats: bool,
}

impl Graph {
    /// Reads the code of every function.
    pub fn new(image: &Image) -> Self {
        let nodes = image.functions.iter().map(|function| read(image, function)).collect();
        Graph { nodes }
    }

    /// What function number `index` does.
    pub fn node(&self, index: usize) -> &Node {
        &self.nodes[index]
    }

    /// Every function that is reached from `roots`, with the one it was first reached from, nearest first. Does not go
    /// on from functions at which it is to `stop`.
    pub fn reach(&self, roots: &[usize], stop: impl Fn(usize) -> bool) -> Vec<(usize, Option<usize>)> {
        let mut seen: BTreeSet<usize> = roots.iter().copied().collect();
        let mut reached: Vec<(usize, Option<usize>)> = seen.iter().map(|&root| (root, None)).collect();
        let mut queue: VecDeque<usize> = seen.iter().copied().collect();
        while let Some(index) = queue.pop_front() {
            if stop(index) {
                continue;
            }
            for &callee in &self.nodes[index].callees {
                if seen.insert(callee) {
                    reached.push((callee, Some(index)));
                    queue.push_back(callee);
                }
            }
        }
        reached
    }
}

fn read(image: &Image, function: &Function) -> Node {
    let mut node = Node::default();
    let mut calls_register = false;
    let size = function.code.len() as u32;
    let own = function.address..function.end().max(function.address + 1);
    let ends = function.stretches.iter().skip(1).map(|(start, _)| *start).chain([size]);
    for (&(start, is_code), end) in function.stretches.iter().zip(ends) {
        if !is_code {
            // Literals: an address of a function has its lowest bit set.
            for at in (start.next_multiple_of(4)..end).step_by(4) {
                node.callees.extend(word(function, at).and_then(|word| entry(image, word)));
            }
            continue;
        }
        // The lower halves of the constants that are being put together in registers.
        let mut low = [0_u16; 16];
        let mut at = start;
        while at < end {
            let (op, step) = decode(function.address + at, half(function, at), half(function, at + 2));
            match op {
                Op::Jump(to) if !own.contains(&to) => match image.function_at(to) {
                    Some(callee) => drop(node.callees.insert(callee)),
                    None => node.calls_unknown = true,
                },
                Op::CallRegister => calls_register = true,
                Op::LowHalf { register, value } => low[usize::from(register)] = value,
                Op::HighHalf { register, value } => {
                    let word = (u32::from(value) << 16) | u32::from(low[usize::from(register)]);
                    node.callees.extend(entry(image, word));
                }
                Op::Float => node.computes_floats = true,
                Op::Jump(_) | Op::Other => {}
            }
            at += step;
        }
    }
    node.calls_unknown |= calls_register && node.callees.is_empty();
    node
}

/// The function that a word points to, if it is a pointer to one.
fn entry(image: &Image, word: u32) -> Option<usize> {
    (word & 1 == 1).then(|| image.function_from(word & !1)).flatten()
}

fn half(function: &Function, at: u32) -> u16 {
    let byte = |at: u32| function.code.get(at as usize).copied().unwrap_or_default();
    u16::from_le_bytes([byte(at), byte(at + 1)])
}

fn word(function: &Function, at: u32) -> Option<u32> {
    let bytes = function.code.get(at as usize..at as usize + 4)?;
    Some(u32::from_le_bytes(bytes.try_into().ok()?))
}
