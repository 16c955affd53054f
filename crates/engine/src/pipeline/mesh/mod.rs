//! Tools on meshes that several stages share: bounds, cutting, new meshes from old ones, outlines; and long arrays in
//! pieces, for all threads.

pub(crate) mod bounds;
pub(crate) mod cut;
pub(crate) mod outline;
pub(crate) mod resample;

use rayon::prelude::*;

/// Vertices or triangles that are worked on as one piece.
pub(crate) const CHUNK: usize = 4096;

/// Calls `work` for all stretches of `values`, with the index of the first value. Long ones over all threads.
pub(crate) fn each_chunk<T: Send>(values: &mut [T], work: impl Fn(&mut [T], usize) + Sync + Send) {
    let count = values.len();
    each(count, values.chunks_mut(CHUNK).enumerate(), |(k, chunk)| work(chunk, k * CHUNK));
}

/// Calls `work` for each chunk of the vertices or triangles, on all threads if there are many.
pub(crate) fn each<T: Send>(count: usize, chunks: impl Iterator<Item = T>, work: impl Fn(T) + Sync + Send) {
    if count > 2 * CHUNK {
        chunks.collect::<Vec<_>>().into_par_iter().for_each(work);
    } else {
        chunks.for_each(work);
    }
}
