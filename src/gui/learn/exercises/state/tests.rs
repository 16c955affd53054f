use super::*;

fn typed(text: &str) -> Typed {
    let answers = [("u".to_owned(), vec![text.to_owned()])].into();
    Typed { answers, ..Typed::default() }
}

#[test]
fn a_list_without_brackets_is_a_whole_vector() {
    let exercise = exercises::entry("basis").map(|entry| entry.exercise(0, &Free::new()));
    let ask = exercise.as_ref().and_then(|exercise| exercise.asks.first());
    let whole = |first: &str, second: &str| {
        let fields = [first, second, ""].map(str::to_owned);
        ask.is_some_and(|ask| is_whole(ask, &fields))
    };
    assert!(whole("-3/7,6/7,2/7", "") && whole("0,5; 1; 2", "") && whole("[1, 2]", "3"));
    assert!(!whole("0,5", "") && !whole("1,2,3", "4") && !whole("0,5;1", ""));
}

#[test]
fn the_next_exercise_is_not_the_open_one_and_keeps_typed_answers() {
    let mut state = Exercises::default();
    let next = |state: &Exercises| state.next(1_000).map(|(chosen, why)| (chosen.id, chosen.seed, why));
    // In the order of the lessons.
    assert_eq!(next(&state), Some(("match-picture".to_owned(), 0, Why::NotSolved)));
    state.open = Some(Chosen { id: "match-picture".to_owned(), seed: 0 });
    assert_eq!(next(&state), Some(("place-camera".to_owned(), 0, Why::NotSolved)));
    state.open = None;
    for entry in exercises::entries().filter(|entry| entry.id != "basis") {
        state.note(Done::WasSolved(entry.id.clone().into_owned()));
    }
    state.typed.insert(Chosen { id: "basis".to_owned(), seed: 7 }, typed("1"));
    assert_eq!(state.stage("basis"), Stage::Begun);
    assert_eq!(next(&state), Some(("basis".to_owned(), 7, Why::NotSolved)));
    state.typed.insert(Chosen { id: "basis".to_owned(), seed: 7 }, typed(" "));
    assert_eq!((state.stage("basis"), state.stage("window")), (Stage::Untouched, Stage::Solved));
    state.forget();
    assert_eq!((state.stage("window"), state.unwritten.len()), (Stage::Untouched, 0));
}

#[test]
fn fields_are_joined_and_brackets_in_the_first_are_the_whole_answer() {
    let chosen = Chosen { id: "view-matrix".to_owned(), seed: 1 };
    let mut state = Exercises { open: Some(chosen), ..Exercises::default() };
    let exercise = state.exercise().map(|(_, exercise)| exercise);
    let ask = exercise.iter().flat_map(|e| &e.asks).find(|ask| ask.kind == Kind::Matrix(4, 4));
    let Some(ask) = ask else { panic!("a matrix is asked for") };
    assert_eq!(joined(ask, state.fields(ask)), "");
    let mut fields = state.fields(ask).to_vec();
    fields[5] = "0,5".to_owned();
    state.type_into(ask, fields.clone());
    assert_eq!(joined(ask, state.fields(ask)), "[[?; ?; ?; ?]; [?; 0,5; ?; ?]; [?; ?; ?; ?]; [?; ?; ?; ?]]");
    fields[0] = " [[1, 2], [3, 4]]".to_owned();
    state.type_into(ask, fields);
    assert_eq!(joined(ask, state.fields(ask)), "[[1, 2], [3, 4]]");
}
