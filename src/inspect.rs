//! Every number of the contract, with its warnings.
