//! The refinement of the boundary: one cyclic list of nodes on the outlines of both copies.

use super::correspondence::Correspondence;
use super::net;
use super::side::Outline;
use crate::plane::{BoundaryPoint, sort_by_number};
use crate::{Error, Result};
use std::f64::consts::TAU;

/// Nodes of one polygon closer than `closest` of the outline's length are moved apart. They come from parts of the other
/// copy that this one shrinks to nothing, so that the picture does not show the move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Room {
    closest: f64,
    /// What is shorter than this share of the source's outline is not refined: there, maps are no smoother than their errors.
    pub(super) finest: f64,
    /// Between two nodes, a curved edge turns by no more, in radians.
    pub(super) turn: f64,
}

impl Room {
    /// As little as double precision can do with: a corner that the other copy opens a long way is that near to a node.
    pub(super) const LEAST: Self = Self { closest: 1e-13, finest: 1e-10, turn: 0.5 };
    /// The same where chords of curves that lie close to each other would cross, and where they lie closer still.
    pub(super) const OF_CURVES: [Self; 2] = [Self { turn: 0.1, ..Self::LEAST }, Self { turn: 0.02, ..Self::LEAST }];
    /// Enough for whole pockets to be connected in what the nodes are moved to.
    pub(super) const AMPLE: Self = Self { closest: 1e-7, finest: 1e-6, turn: 0.02 };
}

/// The same on the circle, where three neighbours must still make a triangle: its height is a quarter of the square.
const CLOSEST_ON_CIRCLE: f64 = 1e-7;
/// An outline's own point gives way to a corner that is closer than this share of the spacing.
const CROWDED: f64 = 0.3;
/// Two corners, one of each outline, closer than this share of the spacing in both copies become one node.
const COINCIDENT: f64 = 1e-3;

/// Angles closer than this say nothing about which comes first.
const SAME_ANGLE: f64 = 1e-9;

/// A boundary node: a point of both outlines.
#[derive(Clone, Copy, Debug)]
pub(super) struct RingNode {
    pub(super) source: BoundaryPoint,
    pub(super) target: BoundaryPoint,
}

/// The boundary nodes of a joint triangulation, anticlockwise from the pair of `toward` points.
pub(super) struct Ring {
    pub(super) nodes: Vec<RingNode>,
    /// Nodes moved along an outline because the maps crowd them closer together than numbers can tell apart.
    pub(super) moved: usize,
}

/// Where a boundary node came from, which decides what may be done with it.
#[derive(Clone, Copy, PartialEq)]
enum Origin {
    /// A corner, or the `toward` point: must stay.
    Corner,
    /// A point between corners: may be dropped.
    Division,
}

/// A node while the ring is being made: distances along both outlines, and whether each is a given or a computed one.
#[derive(Clone, Copy)]
struct Candidate {
    angle: f64,
    origin: Origin,
    /// How far it lies from its neighbours along the source, and along the target, if it is there for that to be seen as a curve;
    /// infinite otherwise.
    steps: [f64; 2],
    source: Place,
    target: Place,
}

#[derive(Clone, Copy)]
struct Place {
    point: BoundaryPoint,
    distance: f64,
    /// The outline's own corner: cannot move.
    fixed: bool,
}

impl Place {
    /// The image of a point with this angle. Where rounding carries it across `toward`, the angle knows better.
    fn image(point: BoundaryPoint, angle: f64, outline: &Outline) -> Self {
        let distance = outline.distance(point);
        let slack = 1e-6 * outline.length();
        let distance = if angle < 1e-6 && distance > outline.length() - slack {
            0.0
        } else if angle > TAU - 1e-6 && distance < slack {
            outline.length()
        } else {
            distance
        };
        Self { point, distance, fixed: false }
    }
}

/// More along a boundary would take minutes, and memory that is not there.
const MOST_POINTS: f64 = 1e6;

impl Ring {
    /// The corners of both outlines, and points between them at most `spacing` apart along the source.
    ///
    /// # Errors
    /// [`Error::InvalidOption`] for a spacing that asks for millions of points; [`Error::Crowded`] where corners of one copy come so close together in the other that double precision
    /// cannot place them one after the other.
    pub(super) fn new(map: &dyn Correspondence, spacing: f64, room: Room) -> Result<Self> {
        let outlines = map.copies().map(Outline::new);
        if outlines[0].length() > MOST_POINTS * spacing {
            let expected = "large enough for at most a million points along the boundary";
            return Err(Error::InvalidOption { name: "spacing", expected, value: spacing });
        }
        let own = candidates_of_source(map, &outlines, outlines[0].divisions(spacing, room.turn));
        let others = candidates_of_target(map, &outlines, outlines[1].divisions(f64::INFINITY, room.turn));
        let reach = outlines[1].length() / outlines[0].length() * spacing;
        let mut list = merge(own, others, &outlines);
        unite_coincident(&mut list, COINCIDENT * spacing, COINCIDENT * reach);
        drop_crowded(&mut list, spacing, 1e-3 * reach);
        grade(&mut list, map, &outlines);
        let mut moved = vec![false; list.len()];
        spread(&mut list, |c| &mut c.source, &outlines[0], room, &mut moved)?;
        spread(&mut list, |c| &mut c.target, &outlines[1], room, &mut moved)?;
        let nodes = list.iter().map(|c| RingNode { source: c.source.point, target: c.target.point }).collect();
        Ok(Self { nodes, moved: moved.iter().filter(|&&m| m).count() })
    }
}

/// The pair of `toward` points, then the source's corners and divisions with their places on the target.
fn candidates_of_source(
    map: &dyn Correspondence,
    [own, other]: &[Outline; 2],
    divisions: Vec<(BoundaryPoint, f64)>,
) -> Vec<Candidate> {
    let [source, target] = map.copies();
    let toward = Candidate {
        angle: 0.0,
        origin: Origin::Corner,
        steps: [f64::INFINITY; 2],
        source: Place { point: source.toward(), distance: 0.0, fixed: true },
        target: Place { point: target.toward(), distance: 0.0, fixed: true },
    };
    let carried = |(point, origin, step): (BoundaryPoint, Origin, f64)| {
        let angle = source.angle(point);
        Candidate {
            angle,
            origin,
            steps: [step, f64::INFINITY],
            source: Place { point, distance: own.distance(point), fixed: origin == Origin::Corner },
            target: Place::image(map.boundary_forward(point), angle, other),
        }
    };
    let corners = own.corners().into_iter().map(|point| (point, Origin::Corner, f64::INFINITY));
    let divisions = divisions.into_iter().map(|(point, step)| (point, Origin::Division, step));
    let mut list = vec![toward];
    let again = |c: &Candidate| c.source.point.point == source.toward().point;
    list.extend(corners.chain(divisions).map(carried).filter(|c| !again(c)));
    sort_by_number(&mut list, |candidate| candidate.source.distance);
    keep_order(&mut list);
    list
}

/// The target's corners and divisions with their places on the source.
fn candidates_of_target(
    map: &dyn Correspondence,
    [own, other]: &[Outline; 2],
    divisions: Vec<(BoundaryPoint, f64)>,
) -> Vec<Candidate> {
    let [_, target] = map.copies();
    let carried = |(point, origin, step): (BoundaryPoint, Origin, f64)| {
        let angle = target.angle(point);
        Candidate {
            angle,
            origin,
            steps: [f64::INFINITY, step],
            source: Place::image(map.boundary_backward(point), angle, own),
            target: Place { point, distance: other.distance(point), fixed: origin == Origin::Corner },
        }
    };
    let corners = other.corners().into_iter().map(|point| (point, Origin::Corner, f64::INFINITY));
    let divisions = divisions.into_iter().map(|(point, step)| (point, Origin::Division, step));
    let again = |c: &Candidate| c.target.point.point == target.toward().point;
    let mut list: Vec<_> = corners.chain(divisions).map(carried).filter(|c| !again(c)).collect();
    sort_by_number(&mut list, |candidate| candidate.target.distance);
    keep_order(&mut list);
    list
}

/// Angles of points in their order along an outline rise; rounding may not say otherwise.
fn keep_order(list: &mut [Candidate]) {
    let mut largest: f64 = 0.0;
    for candidate in list {
        largest = largest.max(candidate.angle);
        candidate.angle = largest;
    }
}

/// Two lists, each in its order along the outlines → one. Where angles cannot tell which comes first, places do: charts
/// know those better than numbers on one circle.
fn merge(own: Vec<Candidate>, others: Vec<Candidate>, outlines: &[Outline; 2]) -> Vec<Candidate> {
    let first = |p: &Candidate, q: &Candidate| {
        let apart = p.angle - q.angle;
        let ahead = (p.source.distance - q.source.distance) / outlines[0].length()
            + (p.target.distance - q.target.distance) / outlines[1].length();
        if apart.abs() > SAME_ANGLE { apart <= 0.0 } else { ahead <= 0.0 }
    };
    let mut list = Vec::with_capacity(own.len() + others.len());
    let (mut own, mut others) = (own.into_iter().peekable(), others.into_iter().peekable());
    while let (Some(p), Some(q)) = (own.peek(), others.peek()) {
        list.extend(if first(p, q) { own.next() } else { others.next() });
    }
    list.extend(own.chain(others));
    keep_order(&mut list);
    list
}

/// A corner of one outline that falls onto a corner of the other makes one node with it.
fn unite_coincident(list: &mut Vec<Candidate>, source_reach: f64, target_reach: f64) {
    let mut kept: Vec<Candidate> = Vec::with_capacity(list.len());
    let mut last_corner: Option<usize> = None;
    for &next in list.iter() {
        if next.origin == Origin::Corner {
            if let Some(last) = last_corner.map(|k| &mut kept[k]) {
                let one_of_each = last.source.fixed != next.source.fixed && last.target.fixed != next.target.fixed;
                let close = (next.source.point.point - last.source.point.point).norm() <= source_reach
                    && (next.target.point.point - last.target.point.point).norm() <= target_reach;
                if one_of_each && close {
                    last.source = if last.source.fixed { last.source } else { next.source };
                    last.target = if last.target.fixed { last.target } else { next.target };
                    continue;
                }
            }
            last_corner = Some(kept.len());
        }
        kept.push(next);
    }
    *list = kept;
}

/// Drops divisions that are too close to a neighbour to be worth a node, in either copy.
fn drop_crowded(list: &mut Vec<Candidate>, spacing: f64, target_gap: f64) {
    let close = |p: &Candidate, q: &Candidate| {
        let [own, other] = [0, 1].map(|copy| p.steps[copy].min(q.steps[copy]));
        let here = (p.source.point.point - q.source.point.point).norm() < CROWDED * spacing.min(own);
        let gap = if other.is_finite() { CROWDED * other } else { target_gap };
        let there = (p.target.point.point - q.target.point.point).norm() < gap;
        // What is there for a curve is dropped where another stands in for it on that curve.
        match (own.is_finite(), other.is_finite()) {
            (false, false) => here || there,
            (true, false) => here,
            (false, true) => there,
            (true, true) => here && there,
        }
    };
    let mut kept: Vec<Candidate> = Vec::with_capacity(list.len());
    for &next in list.iter() {
        let crowds_last = kept.last().is_some_and(|last| close(last, &next));
        if next.origin == Origin::Division {
            if !crowds_last {
                kept.push(next);
            }
            continue;
        }
        while kept.last().is_some_and(|last| last.origin == Origin::Division && close(last, &next)) {
            kept.pop();
        }
        kept.push(next);
    }
    while kept.last().is_some_and(|last| last.origin == Origin::Division && close(last, &kept[0])) {
        kept.pop();
    }
    *list = kept;
}

/// Adds nodes so that neighbouring gaps on the circle are of comparable size.
fn grade(list: &mut Vec<Candidate>, map: &dyn Correspondence, [own, other]: &[Outline; 2]) {
    let [source, target] = map.copies();
    let angles: Vec<_> = list.iter().map(|c| c.angle).collect();
    list.extend(net::grading(&angles, source.error().max(target.error())).into_iter().map(|angle| {
        let point = source.at_angle(angle);
        Candidate {
            angle,
            origin: Origin::Division,
            steps: [f64::INFINITY; 2],
            source: Place::image(point, angle, own),
            target: Place::image(map.boundary_forward(point), angle, other),
        }
    }));
    sort_by_number(list, |candidate| candidate.angle);
}

/// Makes the distances along one outline rise strictly, moving only points that are not its own.
fn spread(
    list: &mut [Candidate],
    place: impl Fn(&mut Candidate) -> &mut Place,
    outline: &Outline,
    room: Room,
    moved: &mut [bool],
) -> Result<()> {
    let closest = if outline.is_circle() { CLOSEST_ON_CIRCLE } else { room.closest } * outline.length();
    let mut start = 0;
    while start < list.len() {
        let from = place(&mut list[start]).distance;
        let mut end = start + 1;
        while end < list.len() && !place(&mut list[end]).fixed {
            end += 1;
        }
        let to = if end < list.len() { place(&mut list[end]).distance } else { outline.length() };
        let between = end - start;
        let gap = closest.min(0.5 * (to - from) / between as f64);
        if gap <= 4.0 * f64::EPSILON * outline.length() {
            return Err(Error::Crowded { at: place(&mut list[start]).point.point });
        }
        for k in start + 1..end {
            let least = from + gap * (k - start) as f64;
            let most = to - gap * (end - k) as f64;
            let before = if k == start + 1 { from } else { place(&mut list[k - 1]).distance };
            let node = place(&mut list[k]);
            let distance = node.distance.clamp(least.max(before + gap).min(most), most);
            if distance != node.distance {
                *node = Place { point: outline.at_distance(distance), distance, fixed: false };
                moved[k] = true;
            }
        }
        start = end;
    }
    Ok(())
}
