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
        let mut slow = Slow { p, normal, square: 2.25, radius: 1.5, kept: Vec::new() };
        slow.visit(&map.photons, 0);
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

struct Slow {
    p: Vec3,
    normal: Option<Vec3>,
    square: f64,
    radius: f64,
    kept: Vec<(f64, u32)>,
}

impl Slow {
    fn visit(&mut self, range: &[PackedPhoton], first: u32) {
        if range.is_empty() {
            return;
        }
        let middle = (range.len() - 1) / 2;
        let away = range[middle].point() - self.p;
        let along = away[usize::from(range[middle].axis)];
        let d = away.length_squared() * (1.0 + self.normal.map_or(0.0, |n| (16.0 * n).dot(away).abs()));
        if along * along <= self.square && d < self.square {
            self.kept.push((d, first + middle as u32));
            if self.kept.len() > 40 {
                let old = &self.kept[..40];
                let far = (0..40).fold(0, |f, i| if old[i].0 > old[f].0 { i } else { f });
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
