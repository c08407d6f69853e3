//! Points as JSON has them: `[[x, y], …]`.

use super::Complex64;

/// The points that the text lists, or what is wrong with it, in words.
pub(super) fn read(text: &str) -> Result<Vec<Complex64>, String> {
    let mut rest = Reader { text, at: 0 };
    let mut points = Vec::new();
    rest.list(|rest| {
        let mut coordinates = Vec::new();
        rest.list(|rest| {
            coordinates.push(rest.number()?);
            Ok(())
        })?;
        match coordinates[..] {
            [x, y] => points.push(Complex64::new(x, y)),
            _ => return Err(format!("a point has {} as its length, not 2", coordinates.len())),
        }
        Ok(())
    })?;
    match rest.peek() {
        None => Ok(points),
        Some(_) => Err(rest.expected("the end of the text")),
    }
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl Reader<'_> {
    /// What stands next behind white space.
    fn peek(&mut self) -> Option<u8> {
        let bytes = self.text.as_bytes();
        while bytes.get(self.at).is_some_and(u8::is_ascii_whitespace) {
            self.at += 1;
        }
        bytes.get(self.at).copied()
    }

    /// Whether it is this one, which is stepped over.
    fn take(&mut self, byte: u8) -> bool {
        let found = self.peek() == Some(byte);
        self.at += usize::from(found);
        found
    }

    /// `[item, …]`
    fn list(&mut self, mut item: impl FnMut(&mut Self) -> Result<(), String>) -> Result<(), String> {
        if !self.take(b'[') {
            return Err(self.expected("["));
        }
        if self.take(b']') {
            return Ok(());
        }
        loop {
            item(self)?;
            if self.take(b']') {
                return Ok(());
            }
            if !self.take(b',') {
                return Err(self.expected(", or ]"));
            }
        }
    }

    fn number(&mut self) -> Result<f64, String> {
        self.peek();
        let rest = &self.text[self.at..];
        let end = rest.find(|c: char| !c.is_ascii_digit() && !matches!(c, '-' | '+' | '.' | 'e' | 'E'));
        let digits = &rest[..end.unwrap_or(rest.len())];
        match digits.parse::<f64>() {
            Ok(number) if number.is_finite() => {
                self.at += digits.len();
                Ok(number)
            }
            Ok(_) => Err(format!("the number {digits} is too large")),
            Err(_) => Err(self.expected("a number")),
        }
    }

    fn expected(&mut self, what: &str) -> String {
        match self.peek() {
            None => format!("expected {what}, found the end of the text (EOF)"),
            Some(_) => {
                let found: String = self.text[self.at..].chars().take(12).collect();
                format!("expected {what}, found \"{found}\" at position {}", self.at)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_read_and_anything_else_is_refused_with_its_place() {
        let points = read(" [ [1, -2.5e1] ,\n[0.5,3] ] ").unwrap();
        assert_eq!(points, [Complex64::new(1.0, -25.0), Complex64::new(0.5, 3.0)]);
        assert_eq!(read("[]").unwrap(), []);
        for (text, words) in [
            ("[[1, 2], [3, 4]] x", "end of the text"),
            ("[[1, 2, 3]]", "length"),
            ("[[1 2]]", "position 4"),
            ("[[1, \"2\"]]", "a number"),
            ("[[1, nan]]", "a number"),
            ("[[1, inf]]", "a number"),
            ("[[1, 1e999]]", "too large"),
            ("[[1, 2],]", "expected ["),
            ("[[ü, 2]]", "a number"),
            ("[[1, 2", "EOF"),
        ] {
            let error = read(text).unwrap_err();
            assert!(error.contains(words), "{text}: {error}");
        }
    }
}
