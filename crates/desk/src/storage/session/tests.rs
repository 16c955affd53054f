#![expect(clippy::unwrap_used, reason = "a test may fail")]

use std::fs;

use super::*;
use crate::testing::Stall;
use camera_lab_files::{Carried, SourceFile};

/// A folder that exists for one test.
struct TempFolder(PathBuf);

impl TempFolder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("camera-lab-session-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        let _ = fs::remove_file(&folder);
        Self(folder)
    }

    fn begin(&self, restore: bool) -> (Sessions, Option<Document>) {
        let (sessions, restored) = Sessions::begin(&self.0, restore);
        (sessions, restored.map(|restored| restored.document))
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap());
        let mut names: Vec<String> = entries.filter(|name| !name.ends_with(".lock")).collect();
        names.sort();
        names
    }

    /// Leaves the session of a window that doesn't close.
    fn crash(&self, document: &Document) {
        let (mut sessions, _) = self.begin(false);
        sessions.write(document);
    }

    fn edit(&self, name: &str, change: impl FnOnce(&mut serde_json::Value)) {
        let mut value = serde_json::from_slice(&fs::read(self.0.join(name)).unwrap()).unwrap();
        change(&mut value);
        fs::write(self.0.join(name), value.to_string()).unwrap();
    }
}

impl Drop for TempFolder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
        let _ = fs::remove_file(&self.0);
    }
}

impl Sessions {
    /// Stores the document and waits for it.
    fn write(&mut self, document: &Document) {
        self.write_all(document, &[]);
    }

    /// Stores documents, the displayed one and others, and waits for them.
    fn write_all(&mut self, document: &Document, others: &[&Document]) {
        let seen = Seen::of(document.figure());
        let kept = Kept { document, seen: &seen, is_work: document.is_changed(), text: None };
        self.keep(&(), kept, others);
        self.others.iter().map(|(_, writer)| writer).chain(&self.own).for_each(Writer::wait);
        self.keep(&(), kept, others);
    }

    /// Restores a slot, as the user asks for.
    fn restored(&mut self, slot: usize) -> Option<Document> {
        self.restore(slot).map(|restored| restored.document)
    }
}

fn change(mut document: Document, far: f64) -> Document {
    document.set_parameters(crate::camera::Parameters { far, ..*document.draft() });
    document
}

fn changed() -> Document {
    change(Document::new(fresh(), None).unwrap(), 42.0)
}

fn fresh() -> crate::figure::Figure {
    crate::document::fresh()
}

fn of_file(path: &Path, text: &str, is_picture: bool) -> Document {
    let file = SourceFile { path: path.to_owned(), text: text.to_owned(), is_picture, ..SourceFile::default() };
    change(Document::new(crate::figure::read::parse(text).unwrap(), Some(file)).unwrap(), 42.0)
}

#[test]
fn a_crash_loses_nothing() {
    let place = TempFolder::new("crash");
    let (mut sessions, left) = place.begin(true);
    assert!(left.is_none());
    sessions.write(&changed());
    // The lock goes with the program, and the file stays.
    drop(sessions);
    let (mut sessions, left) = place.begin(true);
    let left = left.unwrap();
    assert_eq!(left.figure().camera.far, 42.0);
    assert!(left.is_changed() && sessions.left().is_empty());
    assert!(matches!(sessions.news()[..], [News::Restored]));
    assert!(sessions.news().is_empty());
}

#[test]
fn a_second_window_has_its_own_slot_and_a_saved_one_leaves_nothing() {
    let place = TempFolder::new("slots");
    let (mut first, _) = place.begin(true);
    first.write(&changed());
    let (mut second, left) = place.begin(true);
    assert!(left.is_none() && second.left().is_empty());
    second.write(&changed());
    assert_eq!(place.names(), ["session-0.json", "session-1.json"]);
    first.forget();
    second.write(&Document::new(fresh(), None).unwrap());
    assert!(place.names().is_empty());
}

#[test]
fn left_sessions_stay_until_the_user_has_decided() {
    let place = TempFolder::new("list");
    for _ in 0..3 {
        place.crash(&changed());
    }
    let (mut sessions, left) = place.begin(false);
    assert!(left.is_none());
    let slots: Vec<usize> = sessions.left().iter().map(|left| left.slot).collect();
    assert_eq!(slots, [0, 1, 2]);
    sessions.write(&changed());
    sessions.discard(1);
    assert_eq!(place.names(), ["session-0.json", "session-2.json", "session-3.json"]);
    // Another window takes one, and this one gets a message.
    let (other, taken) = place.begin(true);
    assert!(taken.is_some());
    assert_eq!(other.left().len(), 1);
    for slot in [0, 2] {
        let restored = sessions.restored(slot);
        let news = sessions.news();
        match restored {
            Some(document) => {
                assert_eq!(document.figure().camera.far, 42.0);
                assert!(matches!(news[..], [News::Restored]));
            }
            None => assert!(matches!(news[..], [News::Taken])),
        }
    }
    assert!(sessions.left().is_empty());
    // The earlier session of this window was given up with the question for it.
    assert_eq!(place.names(), ["session-0.json", "session-2.json"]);
}

#[test]
fn unreadable_sessions_are_set_aside() {
    let place = TempFolder::new("damaged");
    fs::create_dir_all(&place.0).unwrap();
    for number in ["", "-1"] {
        fs::write(place.0.join("session-0.json"), b"{\"path\":").unwrap();
        let (mut sessions, left) = place.begin(true);
        assert!(left.is_none());
        let aside = place.0.join(format!("session-0{number}.damaged"));
        assert!(matches!(&sessions.news()[..], [News::Damaged(path)] if *path == aside));
        assert_eq!(fs::read(aside).unwrap(), b"{\"path\":");
    }
    // An invalid figure.
    place.crash(&changed());
    place.edit("session-0.json", |kept| kept["figure"] = "[camera]\nnear = \"?\"\n".into());
    let (mut sessions, left) = place.begin(true);
    assert!(left.is_none());
    assert!(matches!(&sessions.news()[..], [News::Damaged(path)] if path.ends_with("session-0-2.damaged")));
    assert!(!place.names().contains(&"session-0.json".to_owned()));
}

#[test]
fn keys_of_a_later_version_lose_nothing() {
    let place = TempFolder::new("later");
    let path = place.0.join("a.toml");
    place.crash(&of_file(&path, "# Mine.\n[camera]\nnear = 0.5\n", false));
    place.edit("session-0.json", |kept| kept["of a later version"] = 1.into());
    let (mut sessions, left) = place.begin(true);
    assert!(matches!(sessions.news()[..], [News::Restored]));
    assert_eq!(left.unwrap().path(), Some(&path));
    drop(sessions);

    place.edit("session-0.json", |kept| {
        let figure = kept["figure"].as_str().unwrap().replace("near", "later = 1\nnear");
        kept["figure"] = format!("future = true\n{figure}").into();
        kept["restoring"] = false.into();
    });
    let before = fs::read(place.0.join("session-0.json")).unwrap();
    let (mut sessions, left) = place.begin(true);
    let left = left.unwrap();
    assert_eq!((left.figure().camera.near, left.figure().camera.far), (0.5, 42.0));
    // The later version may have written the file too, so it's left alone.
    assert_eq!(left.path(), None);
    assert_eq!(left.folder(), path.parent());
    assert!(left.source().starts_with("# Mine."));
    let news = sessions.news();
    let [News::RestoredInPart(keys, aside)] = &news[..] else { panic!("{news:?}") };
    assert_eq!(keys, &["future", "[camera] later"]);
    assert_eq!(fs::read(aside).unwrap(), before);
}

#[test]
fn a_figure_that_ends_the_program_is_not_restored_by_itself_again() {
    let place = TempFolder::new("loop");
    place.crash(&changed());
    let (sessions, left) = place.begin(true);
    assert!(left.is_some());
    // The program ends before anything else is written.
    drop(sessions);
    for restore in [true, false] {
        let (mut sessions, left) = place.begin(restore);
        assert!(left.is_none());
        assert!(sessions.left()[0].did_not_survive);
        // The session of this window has another slot.
        sessions.write(&changed());
        assert_eq!(place.names(), ["session-0.json", "session-1.json"]);
        sessions.forget();
    }
    // On request it comes back. It dies again, also after an edit.
    let (mut sessions, _) = place.begin(true);
    let left = sessions.restored(0).unwrap();
    sessions.write(&change(left, 43.0));
    drop(sessions);
    let (mut sessions, left) = place.begin(true);
    assert!(left.is_none() && sessions.left()[0].did_not_survive);
    // With time we trust it.
    let left = sessions.restored(0).unwrap();
    assert_eq!(left.figure().camera.far, 43.0);
    sessions.restored_at = clock::now().checked_sub(SURVIVED).or(Some(Duration::ZERO));
    if clock::now() < SURVIVED {
        sessions.restored_at = None;
    }
    sessions.write(&left);
    drop(sessions);
    assert!(place.begin(true).1.is_some());
}

#[test]
fn a_session_that_cannot_be_written_is_reported_once_and_retried() {
    let place = TempFolder::new("full");
    // A file takes the folder's place.
    fs::write(&place.0, "").unwrap();
    let (mut sessions, left) = place.begin(true);
    assert!(left.is_none());
    sessions.write(&changed());
    sessions.write(&change(changed(), 43.0));
    assert!(
        matches!(&sessions.news()[..], [News::NotKept(NotKept { path, error: FileError::Write(_), .. })] if *path == place.0)
    );
    fs::remove_file(&place.0).unwrap();
    sessions.failed_at = Some(Duration::ZERO);
    std::thread::sleep(RETRY.saturating_sub(clock::now()));
    sessions.write(&changed());
    assert_eq!(place.names(), ["session-0.json"]);

    // The folder goes while the window is open.
    fs::remove_dir_all(&place.0).unwrap();
    fs::write(&place.0, "").unwrap();
    sessions.write(&change(changed(), 44.0));
    sessions.write(&change(changed(), 45.0));
    assert!(matches!(sessions.news()[..], [News::NotKept(_)]));
    fs::remove_file(&place.0).unwrap();
    fs::create_dir_all(&place.0).unwrap();
    // Nothing has changed since, so the write is repeated after some seconds.
    sessions.failed_at = Some(Duration::ZERO);
    sessions.write(&change(changed(), 45.0));
    assert_eq!(place.names(), ["session-0.json"]);
    assert!(sessions.news().is_empty());
}

#[test]
fn a_window_without_a_slot_says_so_and_gets_the_first_that_is_decided_about() {
    let place = TempFolder::new("sixteen");
    for _ in 0..MAX_SESSIONS {
        place.crash(&changed());
    }
    let (mut sessions, _) = place.begin(false);
    assert_eq!(sessions.left().len(), MAX_SESSIONS);
    sessions.write(&changed());
    assert!(matches!(sessions.news()[..], [News::NoSlot]));
    sessions.discard(3);
    assert!(!place.names().contains(&"session-3.json".to_owned()));
    sessions.write(&changed());
    assert!(place.names().contains(&"session-3.json".to_owned()));
    assert!(sessions.news().is_empty());
}

#[test]
fn a_figure_out_of_a_picture_keeps_its_comments_and_its_folder() {
    let place = TempFolder::new("picture");
    let path = place.0.join("view.png");
    let before = of_file(&path, "# Mine.\n[camera]\nnear = 0.5\n", true);
    place.crash(&before);
    let left = place.begin(true).1.unwrap();
    assert_eq!((left.path(), left.folder()), (None, Some(&*place.0)));
    assert_eq!(left.source(), before.source());
    assert_eq!(left.reach(), before.reach());
    assert!(left.is_changed());
}

#[test]
fn a_path_that_says_nothing_is_not_saved_to() {
    let place = TempFolder::new("relative");
    place.crash(&of_file(Path::new("/a.toml"), "# Mine.\n", false));
    place.edit("session-0.json", |kept| kept["path"] = "a.toml".into());
    let left = place.begin(true).1.unwrap();
    assert_eq!(left.path(), None);
    assert_eq!(left.source(), "# Mine.\n");
}

#[cfg(unix)]
#[test]
fn a_path_that_is_no_text_comes_back() {
    use std::os::unix::ffi::OsStringExt as _;
    let place = TempFolder::new("bytes");
    let path = PathBuf::from(std::ffi::OsString::from_vec(b"/tmp/f\xe9.toml".to_vec()));
    place.crash(&of_file(&path, "# Mine.\n", false));
    let (sessions, left) = place.begin(true);
    assert_eq!(left.unwrap().path(), Some(&path));
    drop(sessions);
    assert_eq!(place.begin(false).0.left()[0].path.as_ref(), Some(&path));
}

#[test]
fn a_folder_in_place_of_a_session_is_reported_and_left() {
    let place = TempFolder::new("folder");
    fs::create_dir_all(place.0.join("session-0.json")).unwrap();
    let (mut sessions, left) = place.begin(true);
    assert!(left.is_none());
    assert!(matches!(sessions.news()[..], [News::Unusable(_, FileError::Directory)]));
    sessions.write(&changed());
    assert_eq!(place.names(), ["session-0.json", "session-1.json"]);
}

#[test]
fn a_session_that_is_far_too_large_is_put_aside_unread() {
    let place = TempFolder::new("large");
    fs::create_dir_all(&place.0).unwrap();
    fs::File::create(place.0.join("session-0.json")).unwrap().set_len(MAX_SESSION_BYTES + 1).unwrap();
    let (mut sessions, left) = place.begin(true);
    assert!(left.is_none());
    assert!(matches!(&sessions.news()[..], [News::Damaged(path)] if path.ends_with("session-0.damaged")));
}

#[test]
fn held_documents_have_a_slot_each_and_closed_ones_leave_nothing() {
    let folder = TempFolder::new("left-in-window");
    let (one, two) = (changed(), change(changed(), 50.0));
    let (mut sessions, _) = folder.begin(false);
    sessions.write(&one);
    sessions.write_all(&two, &[&one]);
    // Both would be there after a crash.
    let files = || folder.names().len();
    assert_eq!(files(), 2);
    sessions.write_all(&one, &[&two]);
    assert_eq!(files(), 2, "each in its own");
    let far = |name: &str| fs::read_to_string(folder.0.join(name)).unwrap().contains("far = 42");
    assert!(far("session-0.json") && !far("session-1.json"));
    sessions.write(&one);
    assert_eq!(folder.names(), ["session-0.json"]);
    sessions.forget();
    assert_eq!(files(), 0);
}

#[test]
fn the_files_that_a_picture_carries_come_back_with_its_figure() {
    let place = TempFolder::new("carried");
    let (mut sessions, _) = place.begin(true);
    let (text, carried) = Carried::from_text(b"near = 1\n#camera-lab-file \"m.obj\" AAAA\n".to_vec());
    assert!(text == b"near = 1\n" && !carried.is_empty());
    let text = "[camera]\nnear = 0.5\n";
    let file =
        SourceFile { path: place.0.join("a.png"), text: text.to_owned(), is_picture: true, carried: carried.clone() };
    let document = Document::new(crate::figure::read::parse(text).unwrap(), Some(file)).unwrap();
    sessions.write(&change(document, 42.0));
    drop(sessions);
    let (_, left) = place.begin(true);
    let left = left.unwrap();
    assert_eq!((left.carried(), left.source()), (&carried, text));
}

#[test]
fn a_stalled_folder_holds_up_no_window_and_the_session_is_stored_afterwards() {
    let work = || {
        files::limit_waiting(Duration::from_millis(100));
        let (place, document) = (TempFolder::new("stalled"), changed());
        let (mut sessions, _) = place.begin(true);
        let stall = Stall::of(&place.0.join("session-0.json"));
        let begin = std::time::Instant::now();
        let seen = Seen::of(document.figure());
        sessions.keep(&(), Kept { document: &document, seen: &seen, is_work: true, text: None }, &[]);
        // Another window begins, and closes again.
        place.begin(true).0.forget();
        assert!(begin.elapsed() < Duration::from_secs(2), "{:?}", begin.elapsed());
        drop(stall);
        sessions.write(&document);
        assert!(place.names().contains(&"session-0.json".to_owned()));
    };
    std::thread::spawn(work).join().unwrap();
}
