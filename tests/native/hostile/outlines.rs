//! Texts that look like outlines.

use super::{report, rounds};
use crate::support::random::Random;
use conformal_warp::parse_outline;

const PIECES: &[&str] = &[
    "M0 0",
    "m",
    "L10,0",
    "l-3 4",
    "h20",
    "v10",
    "H0",
    "V0",
    "z",
    "Z",
    "c1 2 3 4 5 6",
    "s1 2 3 4",
    "q5 5 10 0",
    "t3 3",
    "a5 3 30 0 1 9 9",
    "A1 1 0 11 2 2",
    "1e999",
    "-",
    ".",
    "1e",
    "−5",
    "\u{a0}",
    "😀",
    ",",
    ";",
    "[[0,0],",
    "[1,2]",
    "]",
    "{",
    "NaN",
    "<svg>",
    "<svg viewBox='0 0 1 1'>",
    "</svg>",
    "<path d='M0 0h1v1z'/>",
    "<path d='",
    "'/>",
    "<g transform='scale(0)'>",
    "<g transform='matrix(1 0 0 1e308 1e308 0)'>",
    "</g>",
    "<rect width='5' height='-3' rx='9'/>",
    "<circle r='1e300'/>",
    "<use href='#a'/>",
    "<svg id='a' width='0' viewBox='0 0 0 0'>",
    "<polygon points='0,0 1,1 2'/>",
    "&lt;",
    "<!--",
    "-->",
    "<!DOCTYPE svg [<!ENTITY a 'b'>]>",
];

#[test]
fn every_text_is_an_outline_or_refused_in_words() {
    let tried = 20_000 * rounds();
    let mut read = 0;
    for seed in 0..tried {
        let mut random = Random::new(seed);
        let starts = ["M0 0", "M0 0 L9 1 4 7", "<svg>", "[", ""];
        let mut text = random.pick(&starts).to_string();
        for _ in 0..random.below(9) {
            text += random.pick(PIECES);
        }
        if text.starts_with("<svg>") && random.below(2) == 0 {
            text += "</svg>";
        }
        let tolerance = [1e-9, 0.1, 1e6][random.below(3)];
        match parse_outline(&text, 1.0, tolerance) {
            Ok(vertices) => {
                read += 1;
                assert!(vertices.iter().all(|z| z.is_finite()), "seed {seed}: {text}");
                assert!(vertices.len() < 1_000_000, "seed {seed}: {} vertices from {text}", vertices.len());
            }
            Err(error) => {
                assert_eq!(error.code(), "invalid-outline", "seed {seed}: {text}");
                assert!(error.to_string().chars().count() < 400, "seed {seed}: {error}");
            }
        }
    }
    report(&format!("outlines: {tried} texts, {read} read, the others refused in words"));
    assert!(read > tried / 200, "only {read} of {tried} texts are outlines");
}
