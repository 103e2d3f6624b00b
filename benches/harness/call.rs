//! A function with its arguments, as assembly calls it.

/// An `extern "C"` function of up to four pointers. Laid out as the assembly beside this file reads it.
#[repr(C)]
pub struct Call {
    arguments: [usize; 4],
    function: usize,
}

impl Call {
    /// `function` is the address of an `extern "C"` function that takes these pointers.
    pub fn new<const N: usize>(function: *const (), pointers: [*mut (); N]) -> Self {
        let mut arguments = [0; 4];
        arguments.iter_mut().zip(pointers).for_each(|(slot, pointer)| *slot = pointer.expose_provenance());
        Self { arguments, function: function.expose_provenance() }
    }
}

/// A call of an `extern "C"` function with pointers to these places.
macro_rules! call {
    ($function:ident $(, $place:expr)*) => {
        $crate::harness::Call::new($function as *const (), [$((&raw mut $place).cast()),*])
    };
}

pub(crate) use call;
