//! Pictures that a person has looked at, and what is left to look at when a picture test fails.

use super::fixture;
use std::path::{Path, PathBuf};

/// RGBA bytes against the picture `name` of tests/fixtures: as it is seen, half a level on average and almost nowhere more
/// than 16. `REGENERATE=1` makes the picture anew: look at it then.
pub fn check(name: &str, width: usize, found: &[u8]) {
    let path = fixture(&format!("{name}.png"));
    if std::env::var_os("REGENERATE").is_some() {
        save(&path, width, found);
    }
    let expected = load(&path);
    assert_eq!(found.len(), expected.len(), "{name} has another size; {}", keep(name, width, found, &expected));
    // What is seen: colours as far as alpha lets them through.
    let seen = |pixels: &[u8], k: usize| {
        let alpha = f64::from(pixels[k | 3]);
        if k % 4 == 3 { alpha } else { f64::from(pixels[k]) * alpha / 255.0 }
    };
    let differences: Vec<f64> = (0..found.len()).map(|k| (seen(found, k) - seen(&expected, k)).abs()).collect();
    let mean = differences.iter().sum::<f64>() / differences.len() as f64;
    let far = differences.iter().filter(|&&difference| difference > 16.0).count();
    assert!(
        mean < 0.5 && far < found.len() / 500,
        "{mean:.2} levels on average, {far} bytes differ by more than 16; {}",
        keep(name, width, found, &expected)
    );
}

/// Writes what was found, what was expected and their difference (grey where they agree) under target/pictures, and says so.
pub fn keep(name: &str, width: usize, found: &[u8], expected: &[u8]) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/pictures");
    std::fs::create_dir_all(&folder).unwrap();
    let name: String = name.chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect();
    let file = |what: &str| -> PathBuf { folder.join(format!("{name}-{what}.png")) };
    save(&file("found"), width, found);
    save(&file("expected"), width, expected);
    let difference = |k: usize| {
        let apart = |k: usize| i32::from(found[k]) - i32::from(expected[k]);
        if k % 4 == 3 { 255 } else { (128 + 4 * (apart(k) + apart(k | 3)) / 2).clamp(0, 255) as u8 }
    };
    if found.len() == expected.len() {
        save(&file("difference"), width, &(0..found.len()).map(difference).collect::<Vec<u8>>());
    }
    format!("see {}", file("found").display())
}

/// The same of a truth that is not rounded.
pub fn keep_exact(name: &str, width: usize, found: &[u8], exact: &[[f64; 4]]) -> String {
    let expected: Vec<u8> = exact.iter().flatten().map(|value| value.round() as u8).collect();
    keep(name, width, found, &expected)
}

fn save(path: &Path, width: usize, pixels: &[u8]) {
    let file = std::fs::File::create(path).unwrap();
    let mut encoder = png::Encoder::new(file, width as u32, (pixels.len() / 4 / width) as u32);
    encoder.set_color(png::ColorType::Rgba);
    encoder.write_header().unwrap().write_image_data(pixels).unwrap();
}

fn load(path: &Path) -> Vec<u8> {
    let file = std::io::BufReader::new(std::fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    pixels
}
