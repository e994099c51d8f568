//! Stored photons against the reference's maps, photon by photon in the order of the tree.

use glint::interp::interpret_str;
use glint::light::PackedPhoton;
use glint::render::{Settings as Rendering, Unobserved, indirect};
use glint::trace::photon::PhotonMap;
use glint::trace::{Photons, Settings};
use glint::world::World;
use std::collections::BTreeMap;
use std::fs;
use std::sync::Arc;

fn data(name: &str) -> String {
    let path = format!("{}/tests/data/{name}", env!("CARGO_MANIFEST_DIR"));
    fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// Maps by scene; `scene:media` are those of media.
fn oracles() -> BTreeMap<String, Vec<PackedPhoton>> {
    let mut all: BTreeMap<String, Vec<PackedPhoton>> = BTreeMap::new();
    for line in data("3-photon-map-oracle.csv").lines().skip(2) {
        let f: Vec<&str> = line.split(',').collect();
        let whole = |i: usize| f[i].parse::<i16>().unwrap();
        all.entry(f[0].to_owned()).or_default().push(PackedPhoton {
            place: [2, 3, 4].map(|i| f[i].parse().unwrap()),
            energy: [5, 6, 7, 8].map(|i| whole(i) as u8),
            axis: whole(9) as u8,
            elevation: whole(10) as i8,
            azimuth: whole(11) as i8,
        });
    }
    all
}

fn photons(name: &str, threads: usize) -> Arc<Photons> {
    let text = data(&format!("3-oracle-scenes/{name}.pov"));
    let world =
        World::prepare(interpret_str(&text).scene.unwrap_or_else(|e| panic!("{name}: {}", e.message)));
    let settings = Settings { width: 4, height: 4, ..Settings::default() };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).stack_size(64 << 20).build().unwrap();
    let (light, _) = indirect(&world, &settings, &Rendering::new(4, 4), &pool, &Unobserved);
    light.photons.expect("the scene has photons")
}

/// The reference lets a photon go on as not-a-number after media so thin that none was left there; what it
/// stores from then on is black. Glint takes from it what the media take.
fn is_blackened(p: &PackedPhoton) -> bool {
    p.energy == [0, 0, 0, 250]
}

/// Places agree to 1e-6, energies and angles to one step: they are cut, not rounded, and the last bit of a
/// place decides.
fn agree(a: &PackedPhoton, b: &PackedPhoton) -> bool {
    let near = |i: usize| (a.place[i] - b.place[i]).abs() <= 1e-6 * (1.0 + a.place[i].abs());
    let energy = is_blackened(a) || (0..4).all(|i| a.energy[i].abs_diff(b.energy[i]) <= 1);
    let angles = a.elevation.abs_diff(b.elevation) <= 1 && a.azimuth.abs_diff(b.azimuth) <= 1;
    (0..3).all(near) && energy && angles
}

/// How many photons of `map` are those of `expected`, in whatever order.
fn matches(expected: &[PackedPhoton], map: &PhotonMap) -> usize {
    let mut left: Vec<&PackedPhoton> = map.photons().iter().collect();
    let mut count = 0;
    for e in expected {
        if let Some(i) = left.iter().position(|p| agree(e, p)) {
            left.swap_remove(i);
            count += 1;
        }
    }
    count
}

#[test]
fn maps_agree_photon_by_photon() {
    let mut report = Vec::new();
    let mut failed = false;
    for (name, expected) in &oracles() {
        let scene = name.trim_end_matches(":media");
        let photons = photons(scene, 1);
        let map = if scene == name { &photons.surface } else { &photons.media };
        let matched = matches(expected, map);
        let in_order =
            expected.iter().zip(map.photons()).filter(|(a, b)| agree(a, b) && a.axis == b.axis).count();
        failed |= matched != expected.len() || map.photons().len() != expected.len();
        report.push(format!(
            "{name}: {matched} of {} agree, {in_order} in the same place of the tree, {} stored",
            expected.len(),
            map.photons().len()
        ));
    }
    println!("{}", report.join("\n"));
    assert!(!failed, "{}", report.join("\n"));
}

#[test]
fn threads_do_not_matter() {
    for name in ["pm-two", "pm-both"] {
        let (one, three) = (photons(name, 1), photons(name, 3));
        assert_eq!(one.surface.photons(), three.surface.photons());
        assert_eq!(one.surface_radius, three.surface_radius);
    }
}
