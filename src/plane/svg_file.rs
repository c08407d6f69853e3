//! An SVG file → the curves that it draws, in the user units of its outermost `svg`.

use super::affine::Affine;
use super::svg_path::{self, Chain};
use super::{Complex64, Edge, EllipticArc};
use roxmltree::{Document, Node, ParsingOptions};
use std::f64::consts::PI;
use std::str::FromStr;
use svgtypes::{Length, LengthUnit, Transform, ViewBox};

/// How many elements a file may have, copies by `use` counted, and how deep these may be nested.
const MOST_ELEMENTS: u32 = 200_000;
const DEEPEST: usize = 100;

/// A file's text → its curves, exactly, with all transforms applied.
///
/// Paths and basic shapes, copies by `use`, nested `svg`s. Not drawn, and so not read: `defs`, clip paths, masks, patterns
/// and symbols, what is hidden, and what has neither fill nor stroke. Style sheets are not read, only `style` attributes.
///
/// # Errors
/// What is wrong, in words, for text that is no SVG file.
pub fn read(text: &str) -> Result<Vec<Chain>, String> {
    let options = ParsingOptions { allow_dtd: true, nodes_limit: 5 * MOST_ELEMENTS, ..ParsingOptions::default() };
    let document =
        Document::parse_with_options(text, options).map_err(|error| format!("the file is no XML: {error}"))?;
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        return Err(format!("the file's first element is “{}”, and an SVG file's is “svg”", root.tag_name().name()));
    }
    let size = view_box(root).map_or([100.0, 100.0], |view| [view.w, view.h]);
    let mut reader = Reader { document: &document, chains: Vec::new(), elements: 0 };
    let painted = Look { filled: true, stroked: false, to_root: Affine::IDENTITY, size, depth: 0 };
    reader.children(root, painted.of(root))?;
    Ok(reader.chains)
}

/// What an element inherits.
#[derive(Clone, Copy)]
struct Look {
    filled: bool,
    stroked: bool,
    to_root: Affine,
    /// Size of the nearest viewport, which percentages mean.
    size: [f64; 2],
    depth: usize,
}

impl Look {
    /// The inherited style with the element's own fill and stroke.
    fn of(self, node: Node<'_, '_>) -> Self {
        let is_set = |name| property(node, name).map(|value| value != "none" && value != "transparent");
        Self {
            filled: is_set("fill").unwrap_or(self.filled),
            stroked: is_set("stroke").unwrap_or(self.stroked),
            depth: self.depth + 1,
            ..self
        }
    }

    fn then(self, inner: Affine) -> Self {
        Self { to_root: self.to_root * inner, ..self }
    }
}

struct Reader<'a, 'text> {
    document: &'a Document<'text>,
    chains: Vec<Chain>,
    elements: u32,
}

impl<'a, 'text> Reader<'a, 'text> {
    fn children(&mut self, node: Node<'a, 'text>, look: Look) -> Result<(), String> {
        node.children().filter(Node::is_element).try_for_each(|child| self.element(child, look))
    }

    fn element(&mut self, node: Node<'a, 'text>, look: Look) -> Result<(), String> {
        self.elements += 1;
        if self.elements > MOST_ELEMENTS || look.depth > DEEPEST {
            return Err(format!(
                "the file has more than {MOST_ELEMENTS} elements, or more than {DEEPEST} inside each other"
            ));
        }
        if property(node, "display") == Some("none") || property(node, "visibility") == Some("hidden") {
            return Ok(());
        }
        let look = look.of(node).then(transform(node)?);
        match node.tag_name().name() {
            "g" | "a" | "switch" => self.children(node, look),
            "svg" => {
                let (viewport, size) = viewport(node, look.size)?;
                self.children(node, Look { size, ..look.then(viewport) })
            }
            "use" => self.copy(node, look),
            _ if look.filled || look.stroked => self.shape(node, look),
            _ => Ok(()),
        }
    }

    fn copy(&mut self, node: Node<'a, 'text>, look: Look) -> Result<(), String> {
        let name = node.attributes().find(|a| a.name() == "href").and_then(|a| a.value().strip_prefix('#'));
        let Some(name) = name else { return Ok(()) };
        let found = self.document.descendants().find(|other| other.attribute("id") == Some(name));
        let Some(found) = found else { return Err(format!("the file uses “#{name}”, which it does not have")) };
        let [x, y] = [("x", 0), ("y", 1)].map(|(name, axis)| length(node, name, look.size[axis]));
        let look = look.then(Affine::translate(x?.unwrap_or(0.0), y?.unwrap_or(0.0)));
        if found.tag_name().name() == "symbol" {
            self.children(found, look.of(found))
        } else {
            self.element(found, look)
        }
    }

    fn shape(&mut self, node: Node<'a, 'text>, look: Look) -> Result<(), String> {
        let chains = outline(node, look.size)?;
        self.chains.extend(chains.iter().map(|chain| chain.iter().map(|edge| look.to_root.edge(edge)).collect()));
        Ok(())
    }
}

/// The curves of a path or basic shape, in its own coordinates; none for other elements.
fn outline(node: Node<'_, '_>, size: [f64; 2]) -> Result<Vec<Chain>, String> {
    let diagonal = size[0].hypot(size[1]) / std::f64::consts::SQRT_2;
    let x = |name| Ok::<_, String>(length(node, name, size[0])?.unwrap_or(0.0));
    let y = |name| Ok::<_, String>(length(node, name, size[1])?.unwrap_or(0.0));
    Ok(match node.tag_name().name() {
        "path" => svg_path::read(node.attribute("d").unwrap_or_default())?,
        "polygon" | "polyline" => {
            let points = node.attribute("points").unwrap_or_default().trim();
            if points.is_empty() { Vec::new() } else { svg_path::read(&format!("M{points}"))? }
        }
        "line" => {
            let [from, to] = [(x("x1")?, y("y1")?), (x("x2")?, y("y2")?)].map(|(x, y)| Complex64::new(x, y));
            vec![vec![Edge::line(from, to)]]
        }
        "circle" => {
            let radius = length(node, "r", diagonal)?.unwrap_or(0.0);
            ellipse([x("cx")?, y("cy")?], [radius, radius])
        }
        "ellipse" => {
            let (rx, ry) = (length(node, "rx", size[0])?, length(node, "ry", size[1])?);
            ellipse([x("cx")?, y("cy")?], [rx.or(ry).unwrap_or(0.0), ry.or(rx).unwrap_or(0.0)])
        }
        "rect" => {
            let ([left, top], [width, height]) = ([x("x")?, y("y")?], [x("width")?, y("height")?]);
            // Sizes that are not positive draw nothing, and would leave no room for the corners' radii.
            if width.is_nan() || height.is_nan() || width <= 0.0 || height <= 0.0 {
                return Ok(Vec::new());
            }
            let (rx, ry) = (length(node, "rx", size[0])?, length(node, "ry", size[1])?);
            let (rx, ry) = (rx.or(ry).unwrap_or(0.0), ry.or(rx).unwrap_or(0.0));
            rectangle([left, top], [width, height], [rx.clamp(0.0, width / 2.0), ry.clamp(0.0, height / 2.0)])
        }
        _ => Vec::new(),
    })
}

/// An ellipse as two halves; without positive radii it draws nothing.
fn ellipse([x, y]: [f64; 2], [rx, ry]: [f64; 2]) -> Vec<Chain> {
    if rx.is_nan() || ry.is_nan() || rx <= 0.0 || ry <= 0.0 {
        return Vec::new();
    }
    let half =
        |start: f64| Edge::Arc(EllipticArc::new(Complex64::new(x, y), rx.into(), Complex64::new(0.0, ry), start, PI));
    vec![vec![half(0.0), half(PI)]]
}

/// A rectangle with quarters of ellipses at its corners, if their radii are positive.
fn rectangle([left, top]: [f64; 2], [width, height]: [f64; 2], [rx, ry]: [f64; 2]) -> Vec<Chain> {
    let rounded = rx > 0.0 && ry > 0.0;
    let [rx, ry] = if rounded { [rx, ry] } else { [0.0, 0.0] };
    let (right, bottom) = (left + width, top + height);
    // Each corner's center, and its ends along the way.
    let inner = |right_side: bool, bottom_side: bool| {
        let x = if right_side { right - rx } else { left + rx };
        Complex64::new(x, if bottom_side { bottom - ry } else { top + ry })
    };
    let (across, down) = (Complex64::new(rx, 0.0), Complex64::new(0.0, ry));
    let corners = [
        (inner(true, false), -down, across),
        (inner(true, true), across, down),
        (inner(false, true), down, -across),
        (inner(false, false), -across, -down),
    ];
    let mut chain = Chain::new();
    let mut at = corners[3].0 + corners[3].2;
    for (center, first, second) in corners {
        if center + first != at {
            chain.push(Edge::line(at, center + first));
        }
        if rounded {
            chain.push(Edge::Arc(EllipticArc::new(center, first, second, 0.0, 0.5 * PI)));
        }
        at = center + second;
    }
    vec![chain]
}

/// An attribute, or what `style` says in its stead.
fn property<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    let styled = node.attribute("style").and_then(|style| {
        let pairs = style.split(';').filter_map(|pair| pair.split_once(':'));
        pairs.map(|(key, value)| (key.trim(), value.trim())).find_map(|(key, value)| (key == name).then_some(value))
    });
    styled.or_else(|| node.attribute(name).map(str::trim))
}

/// A length in user units of 1/96 inch; `whole` is what 100 % are.
fn length(node: Node<'_, '_>, name: &str, whole: f64) -> Result<Option<f64>, String> {
    let Some(text) = node.attribute(name).map(str::trim).filter(|text| *text != "auto") else { return Ok(None) };
    let Length { number, unit } = Length::from_str(text).map_err(|_| format!("{name}=\"{text}\" is no length"))?;
    let factor = match unit {
        LengthUnit::None | LengthUnit::Px => 1.0,
        LengthUnit::Em => 16.0,
        LengthUnit::Ex => 8.0,
        LengthUnit::In => 96.0,
        LengthUnit::Cm => 96.0 / 2.54,
        LengthUnit::Mm => 96.0 / 25.4,
        LengthUnit::Pt => 4.0 / 3.0,
        LengthUnit::Pc => 16.0,
        LengthUnit::Percent => whole / 100.0,
    };
    Ok(Some(number * factor))
}

fn transform(node: Node<'_, '_>) -> Result<Affine, String> {
    let Some(text) = node.attribute("transform") else { return Ok(Affine::IDENTITY) };
    let Transform { a, b, c, d, e, f } =
        Transform::from_str(text).map_err(|error| format!("transform=\"{text}\": {error}"))?;
    Ok(Affine::matrix([a, b, c, d, e, f]))
}

fn view_box(node: Node<'_, '_>) -> Option<ViewBox> {
    ViewBox::from_str(node.attribute("viewBox")?).ok()
}

/// Coordinates inside a nested `svg` → those around it, and the size that percentages mean inside.
fn viewport(node: Node<'_, '_>, around: [f64; 2]) -> Result<(Affine, [f64; 2]), String> {
    let [x, y] = [("x", 0), ("y", 1)].map(|(name, axis)| length(node, name, around[axis]));
    let corner = Affine::translate(x?.unwrap_or(0.0), y?.unwrap_or(0.0));
    let [w, h] = [("width", 0), ("height", 1)].map(|(name, axis)| length(node, name, around[axis]));
    let (width, height) = (w?.unwrap_or(around[0]), h?.unwrap_or(around[1]));
    let Some(view) = view_box(node) else { return Ok((corner, [width, height])) };
    let (across, down) = (width / view.w, height / view.h);
    let keeps = !node.attribute("preserveAspectRatio").is_some_and(|text| text.trim().starts_with("none"));
    let (across, down) = if keeps { (across.min(down), across.min(down)) } else { (across, down) };
    let margin = Affine::translate((width - across * view.w) / 2.0, (height - down * view.h) / 2.0);
    let fit = corner * margin * Affine::scale(across, down);
    Ok((fit * Affine::translate(-view.x, -view.y), [view.w, view.h]))
}
