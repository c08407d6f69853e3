//! The JavaScript interface: convert, call, convert.
