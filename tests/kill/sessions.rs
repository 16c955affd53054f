//! Windows that are killed while they store their figures.

use camera_lab::gui::kit::frames;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use camera_lab::camera::Parameters;
use camera_lab_desk::document::{Document, Seen};
use camera_lab_desk::storage::session::{Kept, News, Sessions};
use eframe::egui;

use crate::disk::{fill, small_disk};
use crate::{Folder, Victim, moments, no_program_starts, time_to_kill, wait_for};

fn with_far(mut document: Document, far: f64) -> Document {
    document.set_parameters(Parameters { far, ..*document.draft() });
    document
}

fn fresh() -> Document {
    Document::new(camera_lab_desk::document::fresh(), None).expect("a camera")
}

fn keep(sessions: &mut Sessions, ctx: &egui::Context, document: &Document) {
    let seen = Seen::of(document.figure());
    sessions.keep(&frames(ctx), Kept { document, seen: &seen, is_work: document.is_changed(), text: None }, &[]);
}

pub(crate) fn keep_for_ever(folder: &Path) {
    let ctx = egui::Context::default();
    let (mut sessions, _) = Sessions::begin(folder, false);
    for number in 0_u32.. {
        let document = with_far(fresh(), 100.0 + f64::from(number));
        keep(&mut sessions, &ctx, &document);
        std::thread::sleep(Duration::from_micros(200));
    }
}

#[test]
fn figures_of_killed_windows_come_back_one_after_the_other() {
    let (since, mut kills) = (Instant::now(), 0);
    for moment in moments().take_while(|_| since.elapsed() < time_to_kill()) {
        let folder = Folder::new("sessions");
        let one = Victim::start("session", &folder.0);
        wait_for(&folder.file("session-0.json"));
        let other = Victim::start("session", &folder.0);
        wait_for(&folder.file("session-1.json"));
        std::thread::sleep(moment);
        drop((one, other));
        let _alone = no_program_starts();
        let mut windows = Vec::new();
        for left in [1, 0] {
            let (mut sessions, restored) = Sessions::begin(&folder.0, true);
            assert!(restored.expect("it comes back").document.figure().camera.far >= 100.0);
            let news = sessions.news();
            assert!(matches!(news[..], [News::Restored]), "{news:?}");
            assert_eq!(sessions.left().len(), left);
            windows.push(sessions);
        }
        kills += 1;
    }
    eprintln!("killed {kills} pairs of windows");
    assert!(kills > 0);
}

#[test]
fn on_a_full_disk_a_message_appears_and_saving_is_tried_again() {
    let Some(disk) = small_disk() else { return };
    let folder = disk.join("sessions");
    let ctx = egui::Context::default();
    let (mut sessions, _) = Sessions::begin(&folder, true);
    let filler = fill(&disk);
    let document = with_far(fresh(), 42.0);
    let since = Instant::now();
    let mut news = Vec::new();
    while news.is_empty() {
        assert!(since.elapsed() < Duration::from_secs(60));
        keep(&mut sessions, &ctx, &document);
        news = sessions.news();
        std::thread::sleep(Duration::from_millis(5));
    }
    assert!(matches!(news[..], [News::NotKept(_)]), "{news:?}");
    assert!(!folder.join("session-0.json").exists());
    fs::remove_file(filler).expect("removed");
    while !folder.join("session-0.json").exists() {
        assert!(since.elapsed() < Duration::from_secs(60));
        keep(&mut sessions, &ctx, &document);
        assert!(sessions.news().is_empty(), "it is said once");
        std::thread::sleep(Duration::from_millis(5));
    }
    sessions.forget();
    fs::remove_dir_all(folder).expect("removed");
}
