//! Enums whose variants are listed in one place.

/// An enum with `ALL`, its variants in their order. If a function of names follows, also with a name for each variant,
/// and `NAMED`.
///
/// ```
/// camera_lab_engine::listed! {
///     /// A side.
///     #[derive(Clone, Copy, Debug, PartialEq, Eq)]
///     pub enum Side {
///         /// On the left.
///         Left = "left",
///         /// On the right.
///         Right = "right",
///     }
///     /// Its name in files.
///     pub fn name
/// }
/// assert_eq!(Side::ALL.map(Side::name), ["left", "right"]);
/// assert_eq!(Side::NAMED[1], ("right", Side::Right));
/// ```
#[macro_export]
macro_rules! listed {
    ($(#[$meta:meta])* $vis:vis enum $name:ident { $($(#[$about:meta])* $variant:ident,)* }) => {
        $(#[$meta])*
        $vis enum $name { $($(#[$about])* $variant,)* }

        impl $name {
            /// All, in their order.
            $vis const ALL: [Self; [$(Self::$variant,)*].len()] = [$(Self::$variant,)*];
        }
    };
    (
        $(#[$meta:meta])* $vis:vis enum $name:ident { $($(#[$about:meta])* $variant:ident = $word:literal,)* }
        $($names:tt)*
    ) => {
        $crate::listed! { $(#[$meta])* $vis enum $name { $($(#[$about])* $variant,)* } }
        $crate::variant_names! { $name { $($variant = $word,)* } $($names)* }
    };
}

/// An enum with a name for each variant, as [`listed!`](crate::listed) has them, without `ALL`.
#[macro_export]
macro_rules! worded {
    (
        $(#[$meta:meta])* $vis:vis enum $name:ident { $($(#[$about:meta])* $variant:ident = $word:literal,)* }
        $($names:tt)*
    ) => {
        $(#[$meta])*
        $vis enum $name { $($(#[$about])* $variant,)* }
        $crate::variant_names! { $name { $($variant = $word,)* } $($names)* }
    };
}

/// The function of the names, for the macros above.
#[doc(hidden)]
#[macro_export]
macro_rules! variant_names {
    ($name:ident { $($variant:ident = $word:literal,)* } $(#[$doc:meta])* $vis:vis fn $function:ident) => {
        impl $name {
            /// The names and the variants, in their order.
            $vis const NAMED: &'static [(&'static str, Self)] = &[$(($word, Self::$variant)),*];

            $(#[$doc])*
            $vis const fn $function(self) -> &'static str {
                match self { $(Self::$variant => $word,)* }
            }
        }
    };
}
