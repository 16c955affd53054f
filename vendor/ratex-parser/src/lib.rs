pub mod environments;
pub mod error;
pub(crate) mod expansion_budget;
pub mod functions;
pub mod macro_expander;
pub mod parse_node;
pub mod parser;
pub(crate) mod stack_safety;
pub mod unicode_sup_sub;

pub use error::{ParseError, ParseResult};
pub use parse_node::{Mode, ParseNode};
pub use parser::{parse, Parser};
