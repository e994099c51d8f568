//! Who is beaten by whom.

/// Which of the points (time, error) no other beats in both.
pub fn front(points: &[(f64, f64)]) -> Vec<bool> {
    let beats = |a: &(f64, f64), b: &(f64, f64)| a.0 <= b.0 && a.1 <= b.1 && a != b;
    // Of equal points the first counts.
    let beaten =
        |i: usize| points.iter().enumerate().any(|(j, p)| beats(p, &points[i]) || (j < i && *p == points[i]));
    (0..points.len()).map(|i| !beaten(i)).collect()
}

/// The point of the front from which on more time buys clearly less: the one furthest below the straight
/// line between the front's ends, both axes logarithmic. Of two ends alone it is the more exact one.
///
/// Reference: V. Satopaa et al., "Finding a Kneedle in a Haystack", 2011.
pub fn knee(points: &[(f64, f64)]) -> Option<usize> {
    let on_front = front(points);
    let place = |i: usize| {
        let log = |v: f64| v.max(1e-12).ln();
        (log(points[i].0), log(points[i].1))
    };
    let mut order: Vec<usize> = (0..points.len()).filter(|&i| on_front[i]).collect();
    order.sort_by(|&a, &b| points[a].0.total_cmp(&points[b].0));
    let (&first, &last) = (order.first()?, order.last()?);
    let ((x0, y0), (x1, y1)) = (place(first), place(last));
    // Both spans as one, so that neither axis' length decides.
    let (wide, high) = ((x1 - x0).max(1e-12), (y0 - y1).max(1e-12));
    let depth = |i: usize| {
        let (x, y) = place(i);
        1.0 - (x - x0) / wide - (y - y1) / high
    };
    let best = order.iter().copied().max_by(|&a, &b| depth(a).total_cmp(&depth(b)))?;
    Some(if depth(best) > 1e-9 { best } else { last })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_is_what_nobody_beats() {
        let points = [(1.0, 0.5), (2.0, 0.1), (2.5, 0.3), (4.0, 0.1), (3.0, 0.05), (1.0, 0.5), (0.5, 0.9)];
        assert_eq!(front(&points), [true, true, false, false, true, false, true]);
    }

    /// Error falls steeply up to 2 seconds and hardly afterwards.
    #[test]
    fn the_knee_is_where_time_stops_paying() {
        let points = [(1.0, 0.1), (1.4, 0.03), (2.0, 0.005), (6.0, 0.004), (20.0, 0.003), (3.0, 0.05)];
        assert_eq!(knee(&points), Some(2));
    }

    #[test]
    fn short_fronts_have_knees() {
        assert_eq!(knee(&[]), None);
        assert_eq!(knee(&[(1.0, 0.1)]), Some(0));
        assert_eq!(knee(&[(1.0, 0.1), (2.0, 0.01)]), Some(1));
        assert_eq!(knee(&[(1.0, 0.1), (2.0, 0.0)]), Some(1));
    }
}
