//! A figure → the scene that each of the three pictures shows, and its observer.
