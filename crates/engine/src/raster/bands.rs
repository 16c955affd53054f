//! The bands of a picture, for all threads.

use std::sync::Mutex;

use crate::progress::Progress;

/// Paints all bands, each a number of rows and a job, with as many threads as there are `scratches`. Each row is a step
/// of the progress. One thread pauses after each band.
pub(super) async fn each_band<S: Send, J: Send>(
    scratches: &mut [S],
    jobs: impl Iterator<Item = (usize, J)> + Send,
    progress: &Progress,
    paint: impl Fn(&mut S, J) + Sync,
) {
    if let [only] = scratches {
        for (rows, job) in jobs.take_while(|_| !progress.is_cancelled()) {
            paint(only, job);
            progress.advance_and_pause(rows).await;
        }
        return;
    }
    let (queue, paint) = (&Mutex::new(jobs), &paint);
    rayon::scope(|scope| {
        for scratch in scratches {
            scope.spawn(move |_| {
                while let Some((rows, job)) = queue.lock().ok().and_then(|mut jobs| jobs.next()) {
                    if progress.is_cancelled() {
                        return;
                    }
                    paint(scratch, job);
                    progress.advance(rows);
                }
            });
        }
    });
}
