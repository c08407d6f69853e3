//! Sorting by one code for all kinds of items: the standard library's is compiled anew for each, into kilobytes.

use std::cmp::Ordering;

/// Sorts stably.
pub(crate) fn sort_by<T: Copy>(items: &mut [T], mut compare: impl FnMut(&T, &T) -> Ordering) {
    let order = order(items.len(), &mut |a, b| compare(&items[a as usize], &items[b as usize]));
    let sorted: Vec<T> = order.iter().map(|&k| items[k as usize]).collect();
    items.copy_from_slice(&sorted);
}

/// Sorts stably by numbers.
pub(crate) fn sort_by_number<T: Copy>(items: &mut [T], number: impl Fn(&T) -> f64) {
    sort_by(items, |a, b| number(a).total_cmp(&number(b)));
}

/// The numbers below `count` in the order of the items that they stand for.
#[inline(never)]
fn order(count: usize, compare: &mut dyn FnMut(u32, u32) -> Ordering) -> Vec<u32> {
    let mut order: Vec<u32> = (0..count as u32).collect();
    order.sort_by(|&a, &b| compare(a, b));
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_items_keep_their_order() {
        let mut items: Vec<(i32, usize)> = (0..1000).map(|k| ((k as i32 * 7919) % 10, k)).collect();
        let mut expected = items.clone();
        expected.sort();
        sort_by(&mut items, |a, b| a.0.cmp(&b.0));
        assert_eq!(items, expected);
        sort_by_number(&mut items, |item| -(item.1 as f64));
        assert!(items.iter().map(|item| item.1).eq((0..1000).rev()));
    }
}
