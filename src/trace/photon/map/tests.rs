use super::*;
use crate::color::Rgb;

/// A grid, with many equal distances.
pub fn on_a_plane(count: u32) -> Vec<PackedPhoton> {
    let side = f64::from(count).sqrt().ceil() as u32;
    let place = |i: u32| 0.125 * Vec3::new(f64::from(i % side) - 40.0, 0.0, f64::from(i / side) - 24.0);
    (0..count).map(|i| PackedPhoton::new(place(i), Rgb::ONE, Vec3::Y)).collect()
}

pub fn scattered(count: u32) -> Vec<PackedPhoton> {
    let place = |i: u32| {
        let f = f64::from(i);
        Vec3::new((f * 0.71).sin() * 5.0, (f * 0.37).cos(), (f * 1.93).sin() * 3.0)
    };
    (0..count).map(|i| PackedPhoton::new(place(i), Rgb::ONE, Vec3::Y)).collect()
}

#[test]
fn nearly_all_within_the_radius_are_found() {
    let photons = scattered(700);
    let map = PhotonMap::new(photons.clone());
    assert_eq!(map.photons().len(), 700);
    let mut found = Nearby::default();
    for i in 0..40 {
        let p = Vec3::new(f64::from(i) * 0.2 - 4.0, 0.1, 0.5);
        map.gather(p, 0.8, 10_000, None, &mut found);
        let expected = photons.iter().filter(|q| (q.point() - p).length() < 0.8).count();
        let n = found.members.len();
        assert!(n <= expected && n + expected / 4 + 1 >= expected, "{n} of {expected}");
        assert_eq!(found.radius, 0.8);
    }
}

/// More than there is room for: the search shrinks to about the nearest ones.
#[test]
fn a_full_search_keeps_near_photons() {
    let map = PhotonMap::new(scattered(700));
    let mut found = Nearby::default();
    map.gather(Vec3::new(1.0, 0.2, 0.0), 5.0, 30, None, &mut found);
    assert_eq!(found.members.len(), 30);
    assert!(found.radius < 2.0 && found.members.iter().all(|m| m.0 <= found.radius.powi(2) * 1.000001));
}

/// The rule of the reference, photon by photon.
#[test]
fn a_full_search_is_that_of_the_reference() {
    let map = PhotonMap::new(scattered(3000));
    let (mut found, mut others) = (Nearby::default(), 0);
    // Of the photons that are nearest in truth, how many are passed by.
    let mut passed_by = [0, 0];
    for i in 0..600 {
        let p = Vec3::new(f64::from(i) * 0.015 - 4.0, 0.1, 0.5);
        let normal = (i % 2 == 0).then_some(Vec3::Y);
        map.gather(p, 1.5, 40, normal, &mut found);
        let metric = Metric::new(p, normal);
        let slow = Slow::search(&map, &metric, 1.5, 40);
        assert_eq!(found.members.len(), slow.kept.len());
        let is_kept = |m: &&(f64, u32)| slow.kept.iter().any(|k| k.1 == m.1);
        let same = found.members.iter().filter(is_kept).count();
        others += slow.kept.len() - same;
        assert!((found.radius - slow.radius).abs() < 0.1 * slow.radius);
        assert!(same < slow.kept.len() || found.radius == slow.radius);
        assert!(found.radius <= slow.radius, "{} {}", found.radius, slow.radius);
        let nearest = nearest(&map, &Metric::new(p, normal), 1.5, 40);
        for (count, kept) in passed_by.iter_mut().zip([&found.members, &slow.kept]) {
            *count += nearest.iter().filter(|n| !kept.iter().any(|k| k.1 == **n)).count();
        }
    }
    // Where the two differ, Glint's are the nearer ones.
    assert!(passed_by[0] < passed_by[1], "{passed_by:?}");
    assert!(others <= 80, "{others} of 24000");
}

/// The nearest photons of all, one by one.
fn nearest(map: &PhotonMap, metric: &Metric, radius: f64, most: usize) -> Vec<u32> {
    let square = |i: u32| metric.square(map.away(i as usize, metric.point));
    let mut all: Vec<u32> = (0..map.photons.len() as u32).filter(|&i| square(i) < radius * radius).collect();
    all.sort_by(|&a, &b| square(a).total_cmp(&square(b)));
    all.truncate(most);
    all
}

/// What was asked before does not matter.
#[test]
fn searches_do_not_hang_on_those_before() {
    let (kept, mut found) = (PhotonMap::new(scattered(3000)), Nearby::default());
    for i in 0..100 {
        let f = f64::from(i);
        let p = Vec3::new((f * 0.9).sin() * 6.0, 0.2 * (f * 1.7).cos(), (f * 2.3).sin() * 4.0);
        let mut fresh = Nearby::default();
        PhotonMap::new(scattered(3000)).gather(p, 1.5, 40, Some(Vec3::Y), &mut fresh);
        kept.gather(p, 1.5, 40, Some(Vec3::Y), &mut found);
        assert_eq!((&found.members, found.radius), (&fresh.members, fresh.radius));
    }
}

/// Another way to search; tests of a thread change it for that thread.
#[derive(Clone, Copy, PartialEq)]
pub enum Rule {
    Own,
    /// The reference's, as far as it is known.
    Reference,
    /// The nearest photons of all.
    Nearest,
}

thread_local! {
    pub static RULE: std::cell::Cell<Rule> = const { std::cell::Cell::new(Rule::Own) };
}

impl PhotonMap {
    /// Whether another rule holds, by which `found` is then filled.
    pub(in crate::trace::photon) fn gathers_otherwise(
        &self,
        metric: &Metric,
        radius: f64,
        most: usize,
        found: &mut Nearby,
    ) -> bool {
        found.radius = radius;
        match RULE.get() {
            Rule::Own => return false,
            Rule::Reference => {
                let slow = Slow::search(self, metric, radius, most);
                (found.members, found.radius) = (slow.kept, slow.radius);
            }
            Rule::Nearest => {
                let all = nearest(self, metric, radius, most + 1);
                let square = |i: u32| metric.square(self.away(i as usize, metric.point));
                found.members = all.iter().take(most).map(|&i| (square(i), i)).collect();
                if all.len() > most {
                    found.radius = found.members[most - 1].0.sqrt();
                }
            }
        }
        true
    }
}

struct Slow<'a> {
    metric: &'a Metric,
    most: usize,
    square: f64,
    radius: f64,
    kept: Vec<(f64, u32)>,
}

impl<'a> Slow<'a> {
    fn search(map: &PhotonMap, metric: &'a Metric, radius: f64, most: usize) -> Self {
        let mut slow = Slow { metric, most, square: radius * radius, radius, kept: Vec::new() };
        slow.visit(&map.photons, 0);
        slow
    }

    fn visit(&mut self, range: &[PackedPhoton], first: u32) {
        if range.is_empty() {
            return;
        }
        let middle = (range.len() - 1) / 2;
        let away = range[middle].point() - self.metric.point;
        let along = away[usize::from(range[middle].axis)];
        let d = self.metric.square(away);
        if along * along <= self.square && d < self.square {
            self.kept.push((d, first + middle as u32));
            if self.kept.len() > self.most {
                let old = &self.kept[..self.most];
                let far = (0..self.most).fold(0, |f, i| if old[i].0 > old[f].0 { i } else { f });
                self.kept.swap_remove(far);
                self.square = self.kept.iter().map(|m| m.0).fold(0.0, f64::max);
                self.radius = self.square.sqrt();
            }
        }
        let (low, high) = (&range[..middle], &range[middle + 1..]);
        let after = first + middle as u32 + 1;
        if along > 0.0 {
            self.visit(low, first);
            if along < self.radius {
                self.visit(high, after);
            }
        } else {
            self.visit(high, after);
            if -along < self.radius {
                self.visit(low, first);
            }
        }
    }
}

#[test]
fn photons_off_the_plane_count_as_farther() {
    let above = PackedPhoton::new(Vec3::new(0.0, 0.5, 0.0), Rgb::ONE, Vec3::Y);
    let beside = PackedPhoton::new(Vec3::new(0.5, 0.0, 0.0), Rgb::ONE, Vec3::Y);
    let map = PhotonMap::new(vec![above, beside]);
    let mut found = Nearby::default();
    map.gather(Vec3::ZERO, 1.0, 9, Some(Vec3::Y), &mut found);
    assert_eq!(found.members.len(), 1);
    assert_eq!(map.photons()[found.members[0].1 as usize].point(), beside.point());
}
