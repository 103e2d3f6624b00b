//! What must not be in firmware, told by the names of functions.

/// Whether the checks follow calls from here: carom's own functions, and the `kernel_...` functions in which examples
/// wrap their calls into carom. Printing a value of carom is not its kernel's work.
pub fn is_root(name: &str) -> bool {
    let formats = name.contains(" as core::fmt::");
    (name.contains("carom::") && !formats) || name.split("::").any(|segment| segment.starts_with("kernel_"))
}

/// The start of a panic.
pub fn is_panic(name: &str) -> bool {
    const SIGNS: [&str; 9] = [
        "core::panicking",
        "panic_",
        "rust_begin_unwind",
        "rust_panic",
        "unwrap_failed",
        "expect_failed",
        "slice_index_fail",
        "slice_error_fail",
        "_mismatch_fail",
    ];
    SIGNS.iter().any(|sign| name.contains(sign))
}

/// Any part of an allocator.
pub fn is_allocator(name: &str) -> bool {
    const SIGNS: [&str; 6] = ["__rust_alloc", "__rust_dealloc", "__rust_realloc", "__rg_", "__rdl_", "alloc::alloc::"];
    let last = name.rsplit("::").next().unwrap_or(name);
    SIGNS.iter().any(|sign| name.contains(sign))
        || matches!(last, "malloc" | "calloc" | "realloc" | "free" | "__rust_no_alloc_shim_is_unstable")
}

/// Division of 64 bits or more, hundreds of instructions on any Cortex-M, and products of 128 bits.
pub fn is_wide_division(name: &str) -> bool {
    const NAMES: [&str; 15] = [
        "__aeabi_ldivmod",
        "__aeabi_uldivmod",
        "__divdi3",
        "__divmoddi4",
        "__moddi3",
        "__udivdi3",
        "__udivmoddi4",
        "__umoddi3",
        "__divti3",
        "__divmodti4",
        "__modti3",
        "__udivti3",
        "__udivmodti4",
        "__umodti3",
        "__multi3",
    ];
    NAMES.contains(&name) || name.contains("u64_div_rem") || name.contains("u128_div_rem")
}

/// Floating point in software: compiler support, roots, printing.
pub fn is_float_routine(name: &str) -> bool {
    const RUST: [&str; 5] =
        ["compiler_builtins::float", "compiler_builtins::math", "libm::", "core::num::flt2dec", "core::fmt::float"];
    RUST.iter().any(|part| name.contains(part)) || is_arm_float(name) || is_gcc_float(name)
}

/// `__aeabi_fadd`, `__aeabi_dcmplt`, `__aeabi_i2f`, ...: the names of Arm's run-time ABI.
fn is_arm_float(name: &str) -> bool {
    let Some(rest) = name.strip_prefix("__aeabi_") else {
        return false;
    };
    const OPERATIONS: [&str; 8] = ["add", "sub", "rsub", "mul", "div", "neg", "cmp", "rcmp"];
    let operation = rest.strip_prefix('c').unwrap_or(rest);
    let computes = operation
        .strip_prefix(['f', 'd'])
        .is_some_and(|operation| OPERATIONS.iter().any(|known| operation.starts_with(known)));
    // i2f, ul2d, f2iz, d2uiz, f2d, d2h, ...
    let converts = rest.split_once('2').is_some_and(|(from, to)| {
        matches!(from, "i" | "ui" | "l" | "ul" | "f" | "d" | "h")
            && matches!(to, "f" | "d" | "h" | "h_alt" | "iz" | "uiz" | "lz" | "ulz")
    });
    computes || converts
}

/// `__addsf3`, `__gedf2`, `__floatsisf`, ...: the names of libgcc.
fn is_gcc_float(name: &str) -> bool {
    const OPERATIONS: [&str; 19] = [
        "add", "sub", "mul", "div", "neg", "eq", "ne", "lt", "le", "gt", "ge", "cmp", "unord", "pow", "fix", "float",
        "extend", "trunc", "fma",
    ];
    let Some(rest) = name.strip_prefix("__") else {
        return false;
    };
    // Single, double, half and quadruple precision.
    let modes = ["sf", "df", "hf", "tf"];
    rest.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit())
        && OPERATIONS.iter().any(|known| rest.starts_with(known))
        && modes.iter().any(|mode| rest.contains(mode))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots() {
        for name in [
            "carom::impulse::collision_impulse",
            "<carom::body::Body<f32>>::dynamic",
            "<f32 as carom::scalar::Scalar>::sqrt",
            "quickstart::kernel_square",
            "state_hash::kernel_step::<fixed::FixedI32<typenum::U16>>",
        ] {
            assert!(is_root(name), "{name}");
        }
        for name in [
            "quickstart::run",
            "<carom::error::BodyError as core::fmt::Debug>::fmt",
            "core::fmt::write",
            "state_hash::the_kernel_step",
        ] {
            assert!(!is_root(name), "{name}");
        }
    }

    #[test]
    fn panics() {
        for name in [
            "core::panicking::panic_fmt",
            "core::panicking::panic_const::panic_const_add_overflow",
            "core::option::unwrap_failed",
            "core::slice::index::slice_index_fail",
            "__rustc::rust_begin_unwind",
        ] {
            assert!(is_panic(name), "{name}");
        }
        assert!(!is_panic("carom::impulse::collision_impulse"));
    }

    #[test]
    fn allocators() {
        for name in
            ["__rust_alloc", "__rustc::__rust_alloc", "__rg_alloc", "malloc", "alloc::alloc::handle_alloc_error"]
        {
            assert!(is_allocator(name), "{name}");
        }
        assert!(!is_allocator("freeze"));
    }

    #[test]
    fn divisions() {
        for name in ["__aeabi_uldivmod", "__udivmoddi4", "__multi3"] {
            assert!(is_wide_division(name), "{name}");
        }
        for name in ["__aeabi_uidivmod", "__aeabi_lmul", "__aeabi_idiv", "compiler_builtins::int::u32_div_rem"] {
            assert!(!is_wide_division(name), "{name}");
        }
    }

    #[test]
    fn floats() {
        for name in [
            "__aeabi_fadd",
            "__aeabi_dmul",
            "__aeabi_frsub",
            "__aeabi_fcmplt",
            "__aeabi_cdcmple",
            "__aeabi_cfrcmple",
            "__aeabi_i2f",
            "__aeabi_ul2d",
            "__aeabi_f2uiz",
            "__aeabi_d2lz",
            "__aeabi_h2f",
            "__addsf3",
            "__gedf2",
            "__floatundisf",
            "__fixunsdfsi",
            "__truncdfsf2",
            "compiler_builtins::float::add::__addsf3",
            "libm::math::sqrtf",
        ] {
            assert!(is_float_routine(name), "{name}");
        }
        for name in
            ["__aeabi_idiv", "__aeabi_ldivmod", "__aeabi_lmul", "__aeabi_memcpy4", "__clzsi2", "__ashldi3", "main"]
        {
            assert!(!is_float_routine(name), "{name}");
        }
    }
}
