//! What one operation takes of the flash: it alone is linked, from the object file that the measured firmware was linked
//! from, and the linker leaves out what it does not reach.

use super::image::Image;
use crate::process;
use crate::toolchain::Toolchain;
use anyhow::{Context, Result, bail};
use object::{Object, ObjectSection, SectionFlags, SectionKind, elf};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Bytes of memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Size {
    /// Code and constants, and what variables begin with.
    pub flash: u32,
    /// Variables.
    pub ram: u32,
}

/// Links the operations of one image.
pub struct Linker {
    program: PathBuf,
    image: PathBuf,
    /// The compiler's own functions: memcpy, division, floating point.
    builtins: PathBuf,
    output: PathBuf,
}

impl Linker {
    pub fn new(toolchain: &Toolchain, target: &str, image: &Image) -> Result<Self> {
        let linker = Self {
            program: toolchain.linker()?,
            image: image.object.clone(),
            builtins: toolchain.library(target, "compiler_builtins")?,
            output: image.object.with_extension("operation"),
        };
        let nothing = linker.link(None)?;
        if nothing != Size::default() {
            bail!("linking no operation at all takes {nothing:?}");
        }
        Ok(linker)
    }

    /// The size of a function and all that it reaches.
    pub fn size(&self, function: &str) -> Result<Size> {
        self.link(Some(function))
    }

    fn link(&self, function: Option<&str>) -> Result<Size> {
        let mut lld = Command::new(&self.program);
        lld.args(["-flavor", "gnu", "--gc-sections", "--strip-debug", "-o"]).arg(&self.output);
        match function {
            Some(function) => lld.args(["--entry", function, "--undefined", function]),
            // Any address will do.
            None => lld.args(["--entry", "0"]),
        };
        process::run(lld.arg(&self.image).arg(&self.builtins))?;
        Size::of(&self.output)
    }
}

impl Size {
    /// What a linked file takes.
    pub fn of(path: &Path) -> Result<Self> {
        let bytes = std::fs::read(path)?;
        let file = object::File::parse(&*bytes).context("the linker wrote no ELF file")?;
        let mut size = Self::default();
        for section in file.sections() {
            let SectionFlags::Elf { sh_flags, .. } = section.flags() else { continue };
            // Tables for unwinding are not linked into firmware.
            if !sh_flags.contains(elf::SHF_ALLOC) || section.name()?.starts_with(".ARM.ex") {
                continue;
            }
            let bytes = section.size() as u32;
            if section.kind() != SectionKind::UninitializedData {
                size.flash += bytes;
            }
            if sh_flags.contains(elf::SHF_WRITE) {
                size.ram += bytes;
            }
        }
        Ok(size)
    }
}
