//! The solved map as a function, both ways, and between regions.

mod apart;
mod between;
mod both_ways;
mod closed;
mod compose;
mod exact;
mod faults;
mod margins;
mod recentred;
