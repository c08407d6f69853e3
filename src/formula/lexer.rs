//! Text → tokens with their positions.

use crate::{Error, Result};

/// Longest formula accepted, in UTF-16 units.
pub const LONGEST_TEXT: usize = 10_000;

/// What a formula is spelled with.
#[derive(Clone, Debug, PartialEq)]
pub enum Token {
    /// A decimal number.
    Number(f64),
    /// Letters and digits that start with a letter.
    Word(String),
    /// `+`
    Plus,
    /// `-`
    Minus,
    /// `*`
    Times,
    /// `/`
    Divide,
    /// `^`
    Power,
    /// A whole exponent in raised digits, as in z².
    Raised(i32),
    /// A bar over what stands before it: the conjugate.
    Overline,
    /// `√`
    Root,
    /// `(`
    Open,
    /// `)`
    Close,
    /// `|`
    Bar,
    /// `,`
    Comma,
    /// `=`
    Equals,
    /// The end of the text.
    End,
}

/// A token and where it starts, in UTF-16 units.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// The token.
    pub token: Token,
    /// Its first UTF-16 unit, as JavaScript's `text[position]` counts.
    pub position: usize,
    /// How the text spells it.
    pub spelling: String,
}

/// Splits a formula into tokens; the last one is [`Token::End`].
pub fn tokens(text: &str) -> Result<Vec<Placed>> {
    // A UTF-16 unit takes at most three bytes.
    if text.len() > 3 * LONGEST_TEXT {
        return Err(Error::FormulaTooLarge { what: "characters", limit: LONGEST_TEXT });
    }
    let mut lexer = Lexer { characters: text.chars().collect(), at: 0, position: 0 };
    let mut tokens = Vec::new();
    loop {
        lexer.skip_spaces();
        if lexer.position > LONGEST_TEXT {
            return Err(Error::FormulaTooLarge { what: "characters", limit: LONGEST_TEXT });
        }
        let (start, position) = (lexer.at, lexer.position);
        let token = lexer.token()?;
        let spelling = lexer.characters[start..lexer.at].iter().collect();
        let end = token == Token::End;
        tokens.push(Placed { token, position, spelling });
        if end {
            return Ok(tokens);
        }
    }
}

struct Lexer {
    characters: Vec<char>,
    at: usize,
    position: usize,
}

impl Lexer {
    fn peek(&self) -> Option<char> {
        self.peek_at(0)
    }

    fn peek_at(&self, ahead: usize) -> Option<char> {
        self.characters.get(self.at + ahead).copied()
    }

    fn advance(&mut self) {
        if let Some(c) = self.peek() {
            self.at += 1;
            self.position += c.len_utf16();
        }
    }

    fn advance_while(&mut self, wanted: impl Fn(char) -> bool) {
        while self.peek().is_some_and(&wanted) {
            self.advance();
        }
    }

    fn skip_spaces(&mut self) {
        // Invisible joiners come along when formulas are copied from pages.
        self.advance_while(|c| c.is_whitespace() || matches!(c, '\u{200b}'..='\u{200d}' | '\u{2060}'..='\u{2062}'));
    }

    fn token(&mut self) -> Result<Token> {
        let Some(c) = self.peek() else { return Ok(Token::End) };
        if c.is_ascii_digit() || (c == '.' && self.peek_at(1).is_some_and(|next| next.is_ascii_digit())) {
            return self.number();
        }
        if raised(c).is_some() {
            return self.raised_number();
        }
        if c.is_alphabetic() {
            return Ok(self.word());
        }
        let token = match c {
            '+' => Token::Plus,
            '-' | '−' | '–' | '﹣' | '－' => Token::Minus,
            '*' if self.peek_at(1) == Some('*') => {
                self.advance();
                Token::Power
            }
            '*' | '·' | '×' | '⋅' | '∙' | '∗' => Token::Times,
            '/' | '÷' | '∕' | '⁄' => Token::Divide,
            '^' => Token::Power,
            '\u{304}' | '\u{305}' => Token::Overline,
            '√' => Token::Root,
            // A letter to mathematicians, not to Unicode.
            '℘' => Token::Word(c.into()),
            '(' | '[' => Token::Open,
            ')' | ']' => Token::Close,
            '|' | '∣' => Token::Bar,
            ',' | ';' => Token::Comma,
            '=' => Token::Equals,
            other => {
                return Err(Error::Syntax {
                    position: self.position,
                    expected: "a number, a name or an operator".into(),
                    found: format!("“{other}”"),
                });
            }
        };
        self.advance();
        Ok(token)
    }

    /// Digits with at most one point and an exponent. In `2e` and `2e-z` the e is Euler's number.
    fn number(&mut self) -> Result<Token> {
        let (start, position) = (self.at, self.position);
        let digit = |c: char| c.is_ascii_digit();
        self.advance_while(digit);
        if self.peek() == Some('.') {
            self.advance();
            self.advance_while(digit);
        }
        let sign = usize::from(matches!(self.peek_at(1), Some('+' | '-')));
        if matches!(self.peek(), Some('e' | 'E')) && self.peek_at(1 + sign).is_some_and(digit) {
            (0..=sign).for_each(|_| self.advance());
            self.advance_while(digit);
        }
        let spelling: String = self.characters[start..self.at].iter().collect();
        match spelling.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(Token::Number(value)),
            _ => Err(Error::Syntax { position, expected: "a number below 1.8e308".into(), found: spelling }),
        }
    }

    fn raised_number(&mut self) -> Result<Token> {
        let position = self.position;
        let negative = self.peek() == Some('⁻');
        let mut value: i32 = 0;
        let mut digits = 0;
        while let Some(digit) = self.peek().and_then(raised) {
            match (digit, digits) {
                (Raised::Digit(d), 0..6) => {
                    value = 10 * value + d;
                    digits += 1;
                }
                (Raised::Sign, 0) if self.position == position => {}
                _ => break,
            }
            self.advance();
        }
        if digits == 0 {
            return Err(Error::Syntax {
                position,
                expected: "raised digits".into(),
                found: "a raised sign alone".into(),
            });
        }
        Ok(Token::Raised(if negative { -value } else { value }))
    }

    fn word(&mut self) -> Token {
        let start = self.at;
        self.advance_while(|c| (c.is_alphanumeric() && raised(c).is_none()) || c == '_');
        Token::Word(self.characters[start..self.at].iter().collect())
    }
}

enum Raised {
    Sign,
    Digit(i32),
}

fn raised(c: char) -> Option<Raised> {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    match c {
        '⁻' | '⁺' => Some(Raised::Sign),
        _ => DIGITS.iter().position(|&d| d == c).map(|d| Raised::Digit(d as i32)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kinds(text: &str) -> Vec<Token> {
        tokens(text).unwrap().into_iter().map(|placed| placed.token).collect()
    }

    #[test]
    fn euler_and_exponents_are_told_apart() {
        use Token::{End, Minus, Number, Word};
        assert_eq!(kinds("2e3"), [Number(2000.0), End]);
        assert_eq!(kinds("2e-3"), [Number(0.002), End]);
        assert_eq!(kinds("2e-z"), [Number(2.0), Word("e".into()), Minus, Word("z".into()), End]);
        assert_eq!(kinds(".5"), [Number(0.5), End]);
        assert_eq!(kinds("z⁻¹²"), [Word("z".into()), Token::Raised(-12), End]);
    }

    #[test]
    fn positions_count_utf16_units() {
        let placed = tokens("𝜏 − z").unwrap();
        assert_eq!(placed.iter().map(|p| p.position).collect::<Vec<_>>(), [0, 3, 5, 6]);
        assert_eq!(
            tokens("z + $").unwrap_err(),
            Error::Syntax { position: 4, expected: "a number, a name or an operator".into(), found: "“$”".into() }
        );
    }

    #[test]
    fn numbers_and_texts_have_limits() {
        assert_eq!(tokens("1e999").unwrap_err().code(), "syntax");
        assert_eq!(tokens(&"+".repeat(LONGEST_TEXT + 10)).unwrap_err().code(), "formula-too-large");
    }
}
