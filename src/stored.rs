//! Maps as bytes: what is written once can be read back by every later version that knows its format, or is refused in words.
//!
//! ```text
//! "conformW" · format (u16) · kind (u16) · length of the content (u64) · content · sum over all before (u64)
//! ```
//! Numbers are little-endian, counts u32, texts UTF-8 behind their length. Nothing is taken from the bytes that they do not
//! have: a count is checked against what follows before room is made for it.

use crate::{Error, Result};
use num_complex::Complex64;

const MARK: &[u8; 8] = b"conformW";
/// The newest: raised when the content of any kind changes its form. What an older one can hold is written in that, for older
/// versions to read.
const FORMAT: u16 = RECENTRED;
/// The first format: maps of regions as they were solved.
pub const SOLVED: u16 = 1;
/// Before each map of a region, whether it was solved for its own center.
pub const RECENTRED: u16 = 2;
/// Bytes before the content, and after it.
const HEAD: usize = MARK.len() + 2 + 2 + 8;
const SUM: usize = 8;

/// What bytes hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A [`RiemannMap`](crate::RiemannMap).
    Riemann = 1,
    /// A [`RegionMap`](crate::RegionMap).
    Region = 2,
    /// A [`FormulaMap`](crate::FormulaMap).
    Formula = 3,
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::Riemann => "a RiemannMap",
            Self::Region => "a RegionMap",
            Self::Formula => "a FormulaMap",
        }
    }

    fn of(number: u16) -> Option<Self> {
        [Self::Riemann, Self::Region, Self::Formula].into_iter().find(|kind| *kind as u16 == number)
    }
}

/// The bytes of a map, whose content `write` writes.
#[must_use]
pub fn written(kind: Kind, write: impl FnOnce(&mut Writer)) -> Vec<u8> {
    written_in(SOLVED, kind, write)
}

/// [`written`] in one of the formats.
#[must_use]
pub fn written_in(format: u16, kind: Kind, write: impl FnOnce(&mut Writer)) -> Vec<u8> {
    let mut writer = Writer(Vec::new(), format);
    writer.0.extend_from_slice(MARK);
    writer.0.extend_from_slice(&format.to_le_bytes());
    writer.0.extend_from_slice(&(kind as u16).to_le_bytes());
    writer.0.extend_from_slice(&[0; 8]);
    write(&mut writer);
    let Writer(mut bytes, _) = writer;
    let length = (bytes.len() - HEAD) as u64;
    bytes[HEAD - 8..HEAD].copy_from_slice(&length.to_le_bytes());
    let sum = sum_of(&bytes);
    bytes.extend_from_slice(&sum.to_le_bytes());
    bytes
}

/// What `read` reads from the content of bytes that hold a map of the given kind, whole and unchanged.
///
/// # Errors
/// [`Error::NotStored`], [`Error::OtherFormat`], [`Error::Damaged`], and those of `read`.
pub fn read<T>(kind: Kind, bytes: &[u8], read: impl FnOnce(&mut Reader) -> Result<T>) -> Result<T> {
    let not = |found| Error::NotStored { expected: kind.name(), found };
    let rest = bytes.strip_prefix(MARK).ok_or(not("something else"))?;
    let mut head = Reader(rest, FORMAT);
    let format = head.u16()?;
    if !(SOLVED..=FORMAT).contains(&format) {
        return Err(Error::OtherFormat { found: format, known: FORMAT });
    }
    let found = head.u16()?;
    let length = head.u64()?;
    let Reader(after, _) = head;
    if length.checked_add(SUM as u64) != Some(after.len() as u64) {
        return Err(Error::Damaged { reason: "it is shorter or longer than it says" });
    }
    let (content, sum) = bytes.split_at(bytes.len() - SUM);
    if Reader(sum, FORMAT).u64()? != sum_of(content) {
        return Err(Error::Damaged { reason: "its bytes have changed since it was stored" });
    }
    if found != kind as u16 {
        return Err(not(Kind::of(found).map_or("something else", Kind::name)));
    }
    let mut content = Reader(&content[HEAD..], format);
    let value = read(&mut content)?;
    if content.0.is_empty() { Ok(value) } else { Err(Error::Damaged { reason: "there is more in it than a map" }) }
}

/// FNV-1a: one changed byte always shows, and more of them all but always.
fn sum_of(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}

/// Appends numbers, in a format.
#[derive(Debug)]
pub struct Writer(Vec<u8>, u16);

impl Writer {
    /// The format.
    #[must_use]
    pub fn format(&self) -> u16 {
        self.1
    }

    /// One of a few cases.
    pub fn case(&mut self, number: u8) {
        self.0.push(number);
    }

    /// How many follow: fewer than 2³², as nothing in memory beside its bytes has more.
    pub fn count(&mut self, count: usize) {
        self.0.extend_from_slice(&(count as u32).to_le_bytes());
    }

    /// A number.
    pub fn number(&mut self, number: f64) {
        self.0.extend_from_slice(&number.to_le_bytes());
    }

    /// Numbers, without their count.
    pub fn numbers(&mut self, numbers: &[f64]) {
        numbers.iter().for_each(|number| self.number(*number));
    }

    /// A point.
    pub fn point(&mut self, z: Complex64) {
        self.numbers(&[z.re, z.im]);
    }

    /// Points behind their count.
    pub fn points(&mut self, points: &[Complex64]) {
        self.count(points.len());
        points.iter().for_each(|z| self.point(*z));
    }

    /// A text behind its length.
    pub fn text(&mut self, text: &str) {
        self.count(text.len());
        self.0.extend_from_slice(text.as_bytes());
    }
}

/// Takes numbers from the front, in a format.
#[derive(Debug)]
pub struct Reader<'a>(&'a [u8], u16);

const SHORT: Error = Error::Damaged { reason: "it ends too soon" };

impl<'a> Reader<'a> {
    /// The format.
    #[must_use]
    pub fn format(&self) -> u16 {
        self.1
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N]> {
        let (array, rest) = self.0.split_first_chunk().ok_or(SHORT)?;
        self.0 = rest;
        Ok(*array)
    }

    fn u16(&mut self) -> Result<u16> {
        self.array().map(u16::from_le_bytes)
    }

    fn u64(&mut self) -> Result<u64> {
        self.array().map(u64::from_le_bytes)
    }

    /// One of a few cases.
    ///
    /// # Errors
    /// [`Error::Damaged`].
    pub fn case(&mut self) -> Result<u8> {
        self.array().map(|[number]| number)
    }

    /// How many follow, of which each takes `each` bytes or more.
    ///
    /// # Errors
    /// [`Error::Damaged`] if there cannot be so many.
    pub fn count(&mut self, each: usize) -> Result<usize> {
        let count = self.array().map(u32::from_le_bytes)? as usize;
        if count <= self.0.len() / each { Ok(count) } else { Err(SHORT) }
    }

    /// A number as [`Writer::count`] writes it, of something that there are `count` of.
    ///
    /// # Errors
    /// [`Error::Damaged`].
    pub fn index(&mut self, count: usize) -> Result<usize> {
        let index = self.array().map(u32::from_le_bytes)? as usize;
        if index < count { Ok(index) } else { Err(Error::Damaged { reason: "it names what it does not have" }) }
    }

    /// A finite number.
    ///
    /// # Errors
    /// [`Error::Damaged`].
    pub fn number(&mut self) -> Result<f64> {
        let number = self.array().map(f64::from_le_bytes)?;
        if number.is_finite() { Ok(number) } else { Err(Error::Damaged { reason: "a number in it is not finite" }) }
    }

    /// So many finite numbers.
    ///
    /// # Errors
    /// [`Error::Damaged`].
    pub fn numbers(&mut self, count: usize) -> Result<Vec<f64>> {
        if count > self.0.len() / size_of::<f64>() {
            return Err(SHORT);
        }
        (0..count).map(|_| self.number()).collect()
    }

    /// A finite point.
    ///
    /// # Errors
    /// [`Error::Damaged`].
    pub fn point(&mut self) -> Result<Complex64> {
        Ok(Complex64::new(self.number()?, self.number()?))
    }

    /// Points behind their count.
    ///
    /// # Errors
    /// [`Error::Damaged`].
    pub fn points(&mut self) -> Result<Vec<Complex64>> {
        let count = self.count(size_of::<Complex64>())?;
        (0..count).map(|_| self.point()).collect()
    }

    /// A text behind its length.
    ///
    /// # Errors
    /// [`Error::Damaged`].
    pub fn text(&mut self) -> Result<&'a str> {
        let length = self.count(1)?;
        let (text, rest) = self.0.split_at(length);
        self.0 = rest;
        std::str::from_utf8(text).map_err(|_| Error::Damaged { reason: "a text in it is not UTF-8" })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn content(reader: &mut Reader) -> Result<(Vec<Complex64>, String)> {
        Ok((reader.points()?, reader.text()?.to_string()))
    }

    #[test]
    fn what_is_written_is_read_and_nothing_else() {
        let points = [Complex64::new(1.0, -0.0), Complex64::new(f64::MIN_POSITIVE, 1e300)];
        let bytes = written(Kind::Formula, |writer| {
            writer.points(&points);
            writer.text("z²");
        });
        let (found, text) = read(Kind::Formula, &bytes, content).unwrap();
        assert_eq!((found.as_slice(), text.as_str()), (points.as_slice(), "z²"));
        assert_eq!(read(Kind::Riemann, &bytes, content).unwrap_err().code(), "not-stored");
        assert_eq!(read(Kind::Formula, b"PNG", content).unwrap_err().code(), "not-stored");
        for end in 0..bytes.len() {
            assert!(read(Kind::Formula, &bytes[..end], content).is_err(), "{end} bytes");
        }
        for bit in 0..8 * bytes.len() {
            let mut damaged = bytes.clone();
            damaged[bit / 8] ^= 1 << (bit % 8);
            assert!(read(Kind::Formula, &damaged, content).is_err(), "bit {bit}");
        }
        let longer = [bytes.as_slice(), &[0]].concat();
        assert_eq!(read(Kind::Formula, &longer, content).unwrap_err().code(), "damaged");
    }

    #[test]
    fn counts_are_believed_only_as_far_as_bytes_follow() {
        let bytes = written(Kind::Formula, |writer| writer.count(u32::MAX as usize));
        assert_eq!(read(Kind::Formula, &bytes, content).unwrap_err(), SHORT);
    }
}
