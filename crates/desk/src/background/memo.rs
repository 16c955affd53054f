//! Values that are computed once for each key: in the frame, and beside the window's thread.

use std::time::Duration;

use super::worker::{Running, Worker};
use crate::progress::Progress;
use crate::{Wake, clock};

/// Time that a frame waits for an answer that it can do without.
pub const MAX_WAIT: Duration = Duration::from_millis(4);

/// A value with its key. It's computed again only if the key changes.
#[derive(Clone, Debug)]
pub struct Memo<K, V> {
    last: Option<(K, V)>,
}

impl<K, V> Default for Memo<K, V> {
    fn default() -> Self {
        Self { last: None }
    }
}

impl<K: PartialEq, V> Memo<K, V> {
    /// The value of `key`.
    pub fn of(&mut self, key: K, make: impl FnOnce(&K) -> V) -> &V {
        let last = self.last.take().filter(|(of, _)| *of == key);
        let made = last.unwrap_or_else(|| {
            let value = make(&key);
            (key, value)
        });
        &self.last.insert(made).1
    }

    /// Forces the value to be computed again next time.
    pub fn forget(&mut self) {
        self.last = None;
    }
}

/// A question with its number.
type Asked<K> = (u64, K);

/// The number of a question, the question, and its answer.
type Answered<K, V> = (u64, K, V);

/// Answers questions beside the window's thread. A question that hasn't been started is dropped when the next comes,
/// and none is asked twice in a row.
#[derive(Debug)]
pub struct Latest<K, V> {
    worker: Worker<Asked<K>, Answered<K, V>>,
    /// The last question.
    asked: Option<K>,
    /// Its number: questions count from 1.
    number: u64,
    /// It may still be answered.
    waits: bool,
    /// Questions up to this number are given up. Their answers are ignored.
    given_up: u64,
    /// The answer that was received last.
    newest: Option<Answered<K, V>>,
}

impl<K: Clone + PartialEq + Send + 'static, V: Send + 'static> Latest<K, V> {
    /// `make` creates the function that answers, on the thread with this `name`, and again after a panic.
    pub fn new<A: AsyncFnMut(&K, &Progress) -> V + 'static>(
        name: &'static str,
        make: impl Fn() -> A + Send + Sync + 'static,
    ) -> Self {
        let work = move || {
            let mut answer = make();
            async move |(number, key): Asked<K>, progress: &Progress| {
                let value = answer(&key, progress).await;
                (number, key, value)
            }
        };
        let worker = Worker::new(name, clock::now, work);
        Self { worker, asked: None, number: 0, waits: false, given_up: 0, newest: None }
    }

    /// Asks, unless that was the last question. Requests a frame of `window` when there is an answer.
    pub fn ask(&mut self, window: &dyn Wake, key: K) {
        if self.asked.as_ref() != Some(&key) {
            self.ask_again(window, key);
        }
    }

    /// Asks, even if it's the last question again.
    pub fn ask_again(&mut self, window: &dyn Wake, key: K) {
        self.number += 1;
        self.worker.ask(window, 0, (self.number, key.clone()));
        (self.asked, self.waits) = (Some(key), true);
    }

    /// Gives up the question. Its answer will be ignored.
    pub fn give_up(&mut self) {
        (self.asked, self.waits, self.given_up) = (None, false, self.number);
    }

    /// Gives up the question, and the work on it, even if that hangs.
    pub fn leave(&mut self) {
        self.give_up();
        if self.worker.is_pending(0) {
            self.worker = self.worker.restarted();
        }
    }

    /// Ends the running work. Its result is an answer too, unless it's given up.
    pub fn stop(&self) {
        self.worker.cancel();
    }

    /// Receives an answer to the last question, or to one before it that hasn't been given up. Waits up to `patience`
    /// for it.
    pub fn poll(&mut self, patience: Duration) {
        if !self.receive(patience) && !self.worker.is_pending(0) {
            // The answer has arrived in between, or the answering function has panicked.
            self.receive(Duration::ZERO);
            self.waits = false;
        }
    }

    fn receive(&mut self, patience: Duration) -> bool {
        let [done] = self.worker.take(patience);
        let answered = done.and_then(|done| done.outcome).filter(|(number, ..)| *number > self.given_up);
        let Some(answered) = answered else { return false };
        self.waits &= answered.0 < self.number;
        self.newest = Some(answered);
        true
    }

    /// Receives an answer, and hands it on with its question.
    pub fn take(&mut self, patience: Duration) -> Option<(K, V)> {
        self.poll(patience);
        self.newest.take().map(|(_, key, value)| (key, value))
    }

    /// The answer to the last question, once it has been received.
    pub fn answer(&self) -> Option<&V> {
        let (number, _, value) = self.newest.as_ref()?;
        (self.asked.is_some() && *number == self.number).then_some(value)
    }

    /// The last received answer, with its question.
    pub fn newest(&self) -> Option<(&K, &V)> {
        self.newest.as_ref().map(|(_, key, value)| (key, value))
    }

    /// The last question, as long as it may still be answered because the answering function hasn't panicked.
    pub fn waiting(&self) -> Option<&K> {
        self.asked.as_ref().filter(|_| self.waits)
    }

    /// The running work.
    pub fn running(&self) -> Option<Running> {
        self.worker.running()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU32, Ordering};

    use super::*;

    const MINUTE: Duration = Duration::from_secs(60);

    #[test]
    fn the_same_is_not_made_twice_in_a_row() {
        let mut memo = Memo::default();
        let mut made = 0;
        let mut double = |memo: &mut Memo<u32, u32>, n| {
            let double = *memo.of(n, |n| {
                made += 1;
                2 * n
            });
            (double, made)
        };
        assert_eq!([1, 1, 2, 1].map(|n| double(&mut memo, n)), [(2, 1), (2, 1), (4, 2), (2, 3)]);
        memo.forget();
        assert_eq!(double(&mut memo, 1), (2, 4));
    }

    #[test]
    fn a_question_is_asked_once_and_answered_once() {
        static ANSWERED: AtomicU32 = AtomicU32::new(0);
        let mut latest = Latest::new("counting", || {
            async |n: &u32, _: &Progress| {
                ANSWERED.fetch_add(1, Ordering::Relaxed);
                2 * n
            }
        });
        for (n, answered) in [(2, 1), (2, 1), (3, 2), (2, 3)] {
            latest.ask(&(), n);
            assert_eq!(latest.waiting().is_some(), latest.answer().is_none());
            latest.poll(MINUTE);
            assert_eq!((latest.answer(), latest.waiting()), (Some(&(2 * n)), None));
            assert_eq!(ANSWERED.load(Ordering::Relaxed), answered);
        }
        latest.ask_again(&(), 2);
        assert_eq!((latest.answer(), latest.newest()), (None, Some((&2, &4))), "it may be another one now");
        assert_eq!(latest.take(MINUTE), Some((2, 4)));
        assert_eq!(ANSWERED.load(Ordering::Relaxed), 4);
    }

    #[test]
    fn a_cancelled_job_does_not_answer_the_same_question() {
        // The first answer comes when it's given up.
        let mut latest = Latest::new("waiting", || {
            let mut answers = 0;
            async move |n: &u32, progress: &Progress| {
                answers += 1;
                while answers == 1 && !progress.is_cancelled() {
                    std::thread::yield_now();
                }
                10 * answers + n
            }
        });
        latest.ask(&(), 7);
        while latest.running().is_none() {
            std::thread::yield_now();
        }
        latest.stop();
        latest.give_up();
        assert_eq!(latest.waiting(), None);
        latest.ask(&(), 7);
        while latest.waiting().is_some() {
            latest.poll(Duration::from_millis(1));
            assert!(latest.newest().is_none_or(|answer| answer == (&7, &27)));
        }
        assert_eq!(latest.answer(), Some(&27));
    }

    #[test]
    fn if_a_job_panics_there_is_no_answer_and_no_waiting() {
        let mut latest = Latest::new("dividing", || async |n: &u32, _: &Progress| 12 / n);
        latest.ask(&(), 0);
        assert_eq!((latest.take(MINUTE), latest.waiting(), latest.answer()), (None, None, None));
        latest.ask(&(), 0);
        assert_eq!(latest.waiting(), None, "it is not asked again and again");
        latest.ask(&(), 2);
        latest.poll(MINUTE);
        assert_eq!(latest.answer(), Some(&6));
        assert_eq!(latest.take(MINUTE), Some((2, 6)));
    }
}
