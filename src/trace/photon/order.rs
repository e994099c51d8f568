//! The order of photons in their tree: halved again and again along the axis of the largest extent, the median
//! in the middle.

use crate::light::PackedPhoton;

/// Halves of more photons than this are ordered by two threads.
const ALONE: usize = 1 << 11;

/// Orders a range of photons: along the axis of its largest extent, the median in the middle.
pub fn ordered(photons: &mut [PackedPhoton]) {
    let count = photons.len();
    if count < 2 {
        photons.iter_mut().for_each(|p| p.axis = 0);
        return;
    }
    let axis = widest(photons);
    let middle = (count - 1) / 2;
    // Two photons stay as they are.
    if count > 2 {
        partition(photons, middle, axis);
    }
    photons[middle].axis = axis as u8;
    let (low, high) = photons.split_at_mut(middle);
    if count > ALONE {
        rayon::join(|| ordered(low), || ordered(&mut high[1..]));
    } else {
        ordered(low);
        ordered(&mut high[1..]);
    }
}

/// Of equal extents the first axis counts.
fn widest(photons: &[PackedPhoton]) -> usize {
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for p in photons {
        for a in 0..3 {
            low[a] = low[a].min(p.place[a]);
            high[a] = high[a].max(p.place[a]);
        }
    }
    let extent = [0, 1, 2].map(|a| high[a] - low[a]);
    (1..3).fold(0, |best, a| if extent[a] > extent[best] { a } else { best })
}

/// Quickselect with the median of three as pivot; which photon goes where is that of the reference, as
/// searches that overflow depend on it.
fn partition(p: &mut [PackedPhoton], middle: usize, axis: usize) {
    let (mut left, mut right) = (0, p.len() - 1);
    while left < right {
        p.swap((left + right) / 2, left + 1);
        let v = |p: &[PackedPhoton], i: usize| p[i].place[axis];
        if v(p, left + 1) > v(p, right) {
            p.swap(left + 1, right);
        }
        if v(p, left) > v(p, right) {
            p.swap(left, right);
        }
        if v(p, left + 1) > v(p, left) {
            p.swap(left + 1, left);
        }
        let pivot = v(p, left);
        let (mut j, mut k) = (left + 1, right);
        while j <= k {
            j += 1;
            while j <= right && v(p, j) < pivot {
                j += 1;
            }
            while k > left {
                k -= 1;
                if v(p, k) <= pivot {
                    break;
                }
            }
            if j < k {
                p.swap(j, k);
            }
        }
        p.swap(left, k);
        if middle < k && k > left {
            right = k - 1;
        } else if middle > k {
            left = k + 1;
        } else {
            return;
        }
    }
}
