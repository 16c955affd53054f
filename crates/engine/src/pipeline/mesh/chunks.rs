//! Long arrays in pieces, for all threads.

use rayon::prelude::*;

/// Vertices or triangles that are worked on as one piece.
pub(crate) const CHUNK: usize = 4096;

/// Calls `work` for all stretches of `values`, with the index of the first value. Long ones over all threads.
pub(crate) fn each_chunk<T: Send>(values: &mut [T], work: impl Fn(&mut [T], usize) + Sync + Send) {
    if values.len() > 2 * CHUNK {
        values.par_chunks_mut(CHUNK).enumerate().for_each(|(k, chunk)| work(chunk, k * CHUNK));
    } else {
        work(values, 0);
    }
}
