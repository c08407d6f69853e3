//! Tokens → postfix steps: a Pratt parser.
//!
//! Written by hand because the grammar is small and particular: multiplication that is not written, bars that open and
//! close, names bound by `sum` and `iterate`, UTF-16 positions, a message that says what was expected, bounded
//! depth. Expression crates have none of these (and `exmex`, the best kept of them, brings a regex engine into
//! the wasm file).
//!
//! | binds | |
//! |---|---|
//! | weakest | `+` `−` |
//! | | `*` `/` and multiplication that is not written, left to right: `1/2z` is `(1/2)·z` |
//! | | a leading sign: `−z^2` is `−(z²)` |
//! | | `^`, right to left: `z^w^2` is `z^(w²)`; raised digits |
//! | strongest | `√` before and a bar over a letter (z̄) |

use super::lexer::{Placed, Token, tokens};
use super::names::{self, Call, Fallback, Loop};
use super::operation::{Binary, Real, Unary};
use super::special::Special;
use crate::plane::Complex64;
use crate::{Error, Result};

/// Deepest nesting of parentheses, powers and signs.
pub const DEEPEST: usize = 200;

/// One step of a stack machine: postfix order, so that no formula makes a deep tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// Pushes a number.
    Constant(Complex64),
    /// Pushes z.
    Variable,
    /// Pushes a parameter, by index.
    Parameter(usize),
    /// Pushes the variable of the enclosing loop at that depth.
    Bound(usize),
    /// Replaces the top.
    Unary(Unary),
    /// Replaces the two topmost.
    Binary(Binary),
    /// Replaces the arguments.
    Call(Call, usize),
    /// Replaces one argument, or the two of which one is the parameter, at that place in the text.
    Special(Special, usize, usize),
    /// Pops the two bounds (or start and count) and runs the `body` next steps repeatedly.
    Loop {
        /// Which one.
        kind: Loop,
        /// Number of steps that follow.
        body: usize,
        /// Positions of the two arguments, for messages.
        positions: [usize; 2],
    },
}

/// Text → steps. `parameters` are names in addition to the built-in ones.
pub fn parse(text: &str, parameters: &[String]) -> Result<Vec<Step>> {
    let mut parser =
        Parser { tokens: tokens(text)?, at: 0, parameters, bound: Vec::new(), steps: Vec::new(), depth: 0, bars: 0 };
    parser.skip_head();
    parser.expression(Power::Sum)?;
    match parser.peek() {
        Token::End => Ok(parser.steps),
        Token::Comma if parser.is_decimal_comma() => Err(parser.expected("a point in a decimal number, as in 0.5")),
        _ => Err(parser.expected("an operator or the end")),
    }
}

/// The names that a formula uses without their having a meaning, each a letter and digits after it, in the order in which
/// they first appear: its parameters, if it is to have any.
pub fn parameters(text: &str) -> Result<Vec<String>> {
    let mut names: Vec<String> = Vec::new();
    for Placed { token, .. } in tokens(text)? {
        if let Token::Word(name) = token
            && name.chars().skip(1).all(|c| c.is_ascii_digit())
            && !names::is_taken(&name)
            && names::fallback(&name).is_none()
            && !names.contains(&name)
        {
            names.push(name);
        }
    }
    let mut used = vec![false; names.len()];
    for step in parse(text, &names)? {
        if let Step::Parameter(index) = step {
            used[index] = true;
        }
    }
    let mut used = used.into_iter();
    names.retain(|_| used.next().unwrap_or_default());
    Ok(names)
}

/// The step of a function whose arguments stand at those places.
fn applied(call: Call, count: usize, positions: [usize; 3]) -> Step {
    match call {
        Call::Special(special) => Step::Special(special, count, positions[special.place_of_parameter()]),
        _ => Step::Call(call, count),
    }
}

/// Binding powers, weakest first.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Power {
    Sum,
    Product,
    Sign,
    Exponent,
}

struct Parser<'a> {
    tokens: Vec<Placed>,
    at: usize,
    parameters: &'a [String],
    /// Names bound by the loops around, outermost first.
    bound: Vec<String>,
    steps: Vec<Step>,
    depth: usize,
    /// Bars open within the innermost parentheses.
    bars: usize,
}

impl Parser<'_> {
    fn peek(&self) -> &Token {
        &self.tokens[self.at].token
    }

    /// Passes over `f(z) =` or `w =`.
    fn skip_head(&mut self) {
        let kinds: Vec<&Token> = self.tokens.iter().take(5).map(|placed| &placed.token).collect();
        self.at = match kinds[..] {
            [Token::Word(_), Token::Open, Token::Word(argument), Token::Close, Token::Equals]
                if argument.to_lowercase() == names::VARIABLE =>
            {
                5
            }
            [Token::Word(_), Token::Equals, ..] => 2,
            _ => 0,
        };
    }

    /// Whether the comma that is next stands between digits.
    fn is_decimal_comma(&self) -> bool {
        let number = |at: usize| self.tokens.get(at).is_some_and(|placed| matches!(placed.token, Token::Number(_)));
        self.at > 0 && number(self.at - 1) && number(self.at + 1)
    }

    fn position(&self) -> usize {
        self.tokens[self.at].position
    }

    /// The end token is never passed.
    fn advance(&mut self) {
        self.at = (self.at + 1).min(self.tokens.len() - 1);
    }

    fn accept(&mut self, token: &Token) -> bool {
        let accepted = self.peek() == token;
        if accepted {
            self.advance();
        }
        accepted
    }

    fn require(&mut self, token: &Token, expected: &str) -> Result<()> {
        if self.accept(token) { Ok(()) } else { Err(self.expected(expected)) }
    }

    fn expected(&self, expected: impl Into<String>) -> Error {
        let placed = &self.tokens[self.at];
        let found = match placed.token {
            Token::End => "the end".to_string(),
            _ => format!("“{}”", placed.spelling),
        };
        Error::Syntax { position: placed.position, expected: expected.into(), found }
    }

    /// Every recursion passes here, and is counted.
    fn nested(&mut self, parse: impl FnOnce(&mut Self) -> Result<()>) -> Result<()> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(Error::FormulaTooLarge { what: "levels of nesting", limit: DEEPEST });
        }
        parse(self)?;
        self.depth -= 1;
        Ok(())
    }

    /// An operand and all operators after it that bind at least as strongly as `least`.
    fn expression(&mut self, least: Power) -> Result<()> {
        self.nested(|parser| {
            parser.operand()?;
            while parser.operator(least)? {}
            Ok(())
        })
    }

    /// One operator with what stands to its right, if it binds strongly enough.
    fn operator(&mut self, least: Power) -> Result<bool> {
        let (binary, power, right) = match *self.peek() {
            Token::Plus => (Binary::Add, Power::Sum, Power::Product),
            Token::Minus => (Binary::Subtract, Power::Sum, Power::Product),
            Token::Times => (Binary::Multiply, Power::Product, Power::Sign),
            Token::Divide => (Binary::Divide, Power::Product, Power::Sign),
            Token::Power => (Binary::Power, Power::Exponent, Power::Sign),
            Token::Raised(exponent) => {
                self.advance();
                self.push(Step::Constant(f64::from(exponent).into()));
                self.push(Step::Binary(Binary::Power));
                return Ok(true);
            }
            Token::Overline => {
                self.advance();
                self.push(Step::Unary(Unary::Conjugate));
                return Ok(true);
            }
            _ => return self.unwritten_product(least),
        };
        if power < least {
            return Ok(false);
        }
        self.advance();
        self.expression(right)?;
        self.push(Step::Binary(binary));
        Ok(true)
    }

    /// Multiplication by a name, a parenthesis, a root or a bar that follows an operand. A number must not follow.
    fn unwritten_product(&mut self, least: Power) -> Result<bool> {
        let starts_operand = match self.peek() {
            Token::Word(_) | Token::Open | Token::Root => true,
            Token::Bar => self.bars == 0,
            _ => false,
        };
        if !starts_operand || Power::Product < least {
            return Ok(false);
        }
        self.expression(Power::Sign)?;
        self.push(Step::Binary(Binary::Multiply));
        Ok(true)
    }

    fn operand(&mut self) -> Result<()> {
        match self.peek().clone() {
            Token::Number(value) => {
                self.advance();
                self.push(Step::Constant(value.into()));
                Ok(())
            }
            Token::Word(word) => self.word(&word),
            Token::Minus => {
                self.advance();
                self.expression(Power::Sign)?;
                self.push(Step::Unary(Unary::Negate));
                Ok(())
            }
            Token::Plus => {
                self.advance();
                self.expression(Power::Sign)
            }
            Token::Root => {
                self.advance();
                self.nested(Self::operand)?;
                self.push(Step::Call(Call::Sqrt, 1));
                Ok(())
            }
            Token::Open => {
                self.advance();
                self.enclosed(0)?;
                self.require(&Token::Close, "an operator or “)”")
            }
            Token::Bar => {
                self.advance();
                self.enclosed(self.bars + 1)?;
                self.push(Step::Unary(Unary::Real(Real::Modulus)));
                self.require(&Token::Bar, "an operator or “|”")
            }
            _ => Err(self.expected("a number, a name, “(” or “|”")),
        }
    }

    /// An expression with `bars` open around it.
    fn enclosed(&mut self, bars: usize) -> Result<()> {
        let outside = std::mem::replace(&mut self.bars, bars);
        self.expression(Power::Sum)?;
        self.bars = outside;
        Ok(())
    }

    fn word(&mut self, word: &str) -> Result<()> {
        if let Some(step) = self.value_named(word) {
            self.advance();
            self.push(step);
            return Ok(());
        }
        if let Some(call) = names::function(word) {
            self.advance();
            return self.call(word, call);
        }
        if self.split(word) {
            return self.operand();
        }
        if let Some(fallback) = names::fallback(word) {
            self.advance();
            self.fall_back(fallback);
            return Ok(());
        }
        Err(self.expected(match names::suggestion(word) {
            Some(function) => format!("a name that formulas know, perhaps {function}"),
            None => self.known_names(),
        }))
    }

    fn fall_back(&mut self, fallback: Fallback) {
        match fallback {
            Fallback::Part(part) => {
                self.push(Step::Variable);
                self.push(Step::Unary(Unary::Real(part)));
            }
            Fallback::Variable => self.push(Step::Variable),
            Fallback::Constant(value) => self.push(Step::Constant(value)),
        }
    }

    /// What follows a function's name: arguments in parentheses, or for functions of one argument what textbooks write:
    /// `sin z`, `sin 2πz`, `sin²(z)`, `sin^2 z`.
    fn call(&mut self, word: &str, call: Call) -> Result<()> {
        let exponent = if call.arguments().0 == 1 { self.exponent_of_call(word)? } else { None };
        if self.accept(&Token::Open) {
            let outside = std::mem::replace(&mut self.bars, 0);
            match call {
                Call::Loop(kind) => self.repetition(kind)?,
                _ => self.arguments(call)?,
            }
            self.bars = outside;
            self.require(&Token::Close, "an operator or “)”")?;
        } else if call.arguments().0 == 1 && self.starts_bare_argument() {
            let position = self.position();
            self.bare_argument()?;
            self.push(applied(call, 1, [position; 3]));
        } else {
            return Err(self.expected(format!("“(” after {word}")));
        }
        if let Some(exponent) = exponent {
            self.push(Step::Constant(exponent.into()));
            self.push(Step::Binary(Binary::Power));
        }
        Ok(())
    }

    /// The exponent between a function's name and its argument. −1 would mean the inverse function to some, the reciprocal
    /// to others.
    fn exponent_of_call(&mut self, word: &str) -> Result<Option<f64>> {
        let positive = format!("a positive whole exponent after {word}; the inverse function has a name of its own");
        let exponent = match *self.peek() {
            Token::Raised(exponent) => f64::from(exponent),
            Token::Power => {
                self.advance();
                match *self.peek() {
                    Token::Number(exponent) if exponent.fract() == 0.0 => exponent,
                    _ => return Err(self.expected(positive)),
                }
            }
            _ => return Ok(None),
        };
        if exponent < 1.0 {
            return Err(self.expected(positive));
        }
        self.advance();
        Ok(Some(exponent))
    }

    /// Whether an operand comes that may be an argument without parentheses.
    fn starts_bare_argument(&self) -> bool {
        match self.peek() {
            Token::Number(_) | Token::Word(_) | Token::Root => true,
            Token::Bar => self.bars == 0,
            _ => false,
        }
    }

    /// Factors up to the next operator, parenthesis or function: `sin 2πz cos z` is `sin(2πz)·cos(z)`.
    fn bare_argument(&mut self) -> Result<()> {
        self.expression(Power::Sign)?;
        while let Token::Word(word) = self.peek() {
            if names::function(word).is_some() {
                break;
            }
            self.expression(Power::Sign)?;
            self.push(Step::Binary(Binary::Multiply));
        }
        Ok(())
    }

    fn value_named(&self, name: &str) -> Option<Step> {
        if name == names::VARIABLE {
            return Some(Step::Variable);
        }
        if let Some(value) = names::constant(name) {
            return Some(Step::Constant(value));
        }
        if let Some(slot) = self.bound.iter().rposition(|bound| bound == name) {
            return Some(Step::Bound(slot));
        }
        self.parameters.iter().position(|parameter| parameter == name).map(Step::Parameter)
    }

    fn known_names(&self) -> String {
        let own: Vec<&str> = self.bound.iter().chain(self.parameters).map(String::as_str).collect();
        let own = if own.is_empty() { String::new() } else { format!("{}, ", own.join(", ")) };
        format!("z, i, e, pi, tau, {own}or a function such as sin")
    }

    fn arguments(&mut self, call: Call) -> Result<()> {
        let (fewest, most) = call.arguments();
        let mut count = 0;
        let mut positions = [0; 3];
        loop {
            positions[count] = self.position();
            self.expression(Power::Sum)?;
            count += 1;
            if count == most || *self.peek() != Token::Comma {
                break;
            }
            self.advance();
        }
        if count < fewest {
            return Err(self.expected("“,” and another argument"));
        }
        self.push(applied(call, count, positions));
        Ok(())
    }

    /// `n, from, to, body` or `w, start, count, body`.
    fn repetition(&mut self, kind: Loop) -> Result<()> {
        let name = match self.peek() {
            Token::Word(name) if !names::is_taken(name) => name.clone(),
            _ => return Err(self.expected("a name for the running variable, such as n or w")),
        };
        self.advance();
        let mut positions = [0; 2];
        for position in &mut positions {
            self.require(&Token::Comma, "“,”")?;
            *position = self.position();
            self.expression(Power::Sum)?;
        }
        self.require(&Token::Comma, "“,” and the expression to repeat")?;
        let start = self.steps.len();
        self.push(Step::Loop { kind, body: 0, positions });
        self.bound.push(name);
        self.expression(Power::Sum)?;
        self.bound.pop();
        self.steps[start] = Step::Loop { kind, body: self.steps.len() - start - 1, positions };
        Ok(())
    }

    /// Replaces a word that is not a name by the names it is made of ("iz", "2πi", "zsin(z)"), the longest first.
    /// A function can only be the last of them, and only before a parenthesis.
    fn split(&mut self, word: &str) -> bool {
        const LONGEST_WORD: usize = 64;
        let letters: Vec<char> = word.chars().collect();
        let n = letters.len();
        if n > LONGEST_WORD {
            return false;
        }
        let before_open = matches!(self.tokens[self.at + 1].token, Token::Open);
        // ends[k]: where the first name of the rest from letter k ends, if the rest can be split.
        let mut ends: Vec<Option<usize>> = vec![None; n + 1];
        ends[n] = Some(n);
        for start in (0..n).rev() {
            ends[start] = (start + 1..=n).rev().find(|&end| {
                let piece: String = letters[start..end].iter().collect();
                let function = end == n && before_open && names::function(&piece).is_some();
                ends[end].is_some() && (function || self.value_named(&piece).is_some())
            });
        }
        let mut pieces = Vec::new();
        let mut position = self.position();
        let mut start = 0;
        while start < n {
            let Some(end) = ends[start] else { return false };
            let piece: String = letters[start..end].iter().collect();
            let next = position + piece.encode_utf16().count();
            pieces.push(Placed { token: Token::Word(piece.clone()), position, spelling: piece });
            (start, position) = (end, next);
        }
        self.tokens.splice(self.at..=self.at, pieces);
        true
    }

    fn push(&mut self, step: Step) {
        self.steps.push(step);
    }
}
