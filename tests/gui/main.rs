//! The window, driven without a display.
#![cfg(feature = "gui")]
#![expect(clippy::expect_used, clippy::cast_possible_truncation, reason = "tests may fail")]

mod accidents;
mod asked;
mod cameras;
mod canvas;
mod canvas_keys;
mod canvas_objects;
mod canvas_probe;
mod choices;
mod coach;
mod commands;
mod compare;
mod conventions;
mod dialects;
mod dialogs;
mod exercise_answers;
mod exercise_fading;
mod exercise_fault;
mod exercises;
mod explain;
mod explain_steps;
mod explained;
mod files;
mod frames;
mod gallery;
mod guide_pictures;
mod hand_out;
mod handheld;
mod heavy;
mod homogeneous;
mod keyboard;
mod labels;
mod language;
mod lecturer;
mod lens;
mod lesson_writing;
mod lessons;
mod lost_work;
#[path = "../common/named_files.rs"]
mod named_files;
mod notes;
mod numerics;
mod order;
mod other_programs;
#[path = "../common/overdraw.rs"]
mod overdraw;
mod painter;
mod panels;
mod photograph;
mod pictures;
mod points;
mod predictions;
mod presentation;
mod reveal;
mod same_pixels;
mod scene;
mod sessions;
#[path = "../common/shot.rs"]
mod shot;
mod stages;
mod strip;
mod text_fields;
mod titles;
mod tooltips;
mod triangle;
mod window;
mod words;
