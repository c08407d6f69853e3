//! Campaigns of random and broken input: seeded, bounded, and counted. `npm test` runs a share of each, and
//! `npm run test:hostile` twenty times as much, with its figures: those of docs/RELIABILITY.md.

mod estimate;
mod icons;
mod long;
mod metamorphic;
mod outlines;
mod polygons;
mod smooth;
mod stored;
mod walkers;

/// How many times the share of `npm test` is tried.
fn rounds() -> u64 {
    std::env::var("HOSTILE").map_or(1, |text| text.parse().expect("HOSTILE is a whole number"))
}

/// A campaign's figures, printed when it runs at length.
fn report(line: &str) {
    if rounds() > 1 {
        println!("{line}");
    }
}
