//! The vector instructions of this machine.

/// Runs an expression with `$simd`, the best set of vector instructions that the machine has: on x86 the AVX2 family or
/// none, since everything in between would be compiled for a few old machines.
macro_rules! with_vectors {
    ($level:expr, $simd:ident => $run:expr) => {{
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        {
            if let Some($simd) = $level.as_avx2() {
                fearless_simd::Simd::vectorize(
                    $simd,
                    #[inline(always)]
                    || $run,
                )
            } else {
                let $simd = fearless_simd::Fallback::new();
                $run
            }
        }
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        {
            fearless_simd::dispatch!($level, $simd => $run)
        }
    }};
}
pub(super) use with_vectors;
