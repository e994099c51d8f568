use super::*;
use crate::color::Gamma;
use crate::picture::light::compare;
use crate::render::synthetic::*;
use crate::render::{Antialias, Method, Settings, Unobserved};
use std::sync::atomic::{AtomicU64, Ordering};

const WIDTH: u32 = 96;
const HEIGHT: u32 = 72;

fn light() -> Light {
    Light::new(Gamma::Power(1.0))
}

fn pool(threads: usize) -> rayon::ThreadPool {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap()
}

fn settings(target: f64) -> Adaptive {
    let settings = Adaptive::new(Region::whole(WIDTH, HEIGHT), light());
    Adaptive { target: Some(target), ..settings }
}

fn run(
    settings: &Adaptive,
    threads: usize,
    clock: &dyn Clock,
    formula: Formula,
) -> (Picture, Outcome<Painted>) {
    let canvas = Mutex::new(Picture::new(WIDTH, HEIGHT));
    let outcome = render(settings, &pool(threads), &canvas, &Unobserved, clock, || Painted::new(formula));
    (canvas.into_inner().unwrap(), outcome)
}

/// The picture's integrals, finely enough for errors of 0.01.
fn truth(painting: &Painting) -> Picture {
    painting.truth(WIDTH, HEIGHT, 32)
}

/// A clock that goes on a little whenever it is read.
struct Ticks {
    read: AtomicU64,
    step: f64,
}

impl Ticks {
    fn new(step: f64) -> Self {
        Self { read: AtomicU64::new(0), step }
    }
}

impl Clock for Ticks {
    fn seconds(&self) -> f64 {
        self.read.fetch_add(1, Ordering::Relaxed) as f64 * self.step
    }
}

/// The promise of a target, for every kind of picture: for five in six the true error lies between two thirds of the
/// estimate and one and a half of it, and it is never more than twice the estimate.
#[test]
fn estimates_are_what_errors_are() {
    let (mut all, mut outside) = (0, Vec::new());
    for painting in ALL {
        let (name, truth) = (painting.name, truth(painting));
        for (target, sparse) in [(0.02, false), (0.01, false), (0.02, true), (0.01, true)] {
            let settings = Adaptive { sparse, ..settings(target) };
            let (picture, outcome) = run(&settings, 2, &NoClock, painting.formula);
            let (estimate, error) = (outcome.rmse.unwrap(), compare(&picture, &truth, &light()).rmse);
            assert_eq!(outcome.ended, Ended::Converged, "{name} {target}");
            assert!(estimate <= target, "{name} {target}");
            let (ratio, spp) = (error / estimate, outcome.samples as f64 / f64::from(WIDTH * HEIGHT));
            let line = format!(
                "{name} {target} {sparse}: estimate {estimate:.5} error {error:.5} ratio {ratio:.2} {spp:.2} spp"
            );
            println!("{line}");
            assert!(ratio < 2.0, "{line}");
            all += 1;
            if !(1.0 / 1.5..1.5).contains(&ratio) {
                outside.push(line);
            }
        }
    }
    assert!(6 * outside.len() <= all, "{outside:#?}");
}

/// The estimate does not grade itself: an independent picture (other random numbers, as many samples in
/// every pixel) says the same.
#[test]
fn an_independent_uniform_render_agrees() {
    let uniform = Adaptive {
        target: None,
        base: 1024,
        seed: 77,
        max_samples: Some(1024 * u64::from(WIDTH * HEIGHT)),
        ..settings(1.0)
    };
    let (reference, outcome) = run(&uniform, 2, &NoClock, horizon);
    assert_eq!(outcome.samples, 1024 * u64::from(WIDTH * HEIGHT));
    let own = compare(&reference, &truth(&HORIZON), &light()).rmse;
    assert!(own < 0.0025 && outcome.rmse.unwrap() < 0.0025, "{own} {:?}", outcome.rmse);
    let (picture, outcome) = run(&settings(0.01), 2, &NoClock, horizon);
    let ratio = compare(&picture, &reference, &light()).rmse / outcome.rmse.unwrap();
    assert!((1.0 / 1.5..1.5).contains(&ratio), "{ratio}");
}

/// No setting of methods 1 and 2 comes nearer for as many samples.
#[test]
fn methods_1_and_2_are_beaten() {
    for (painting, target) in [(HORIZON, 0.02), (PENUMBRA, 0.02), (SPECKS, 0.005)] {
        let (name, formula, truth) = (painting.name, painting.formula, truth(&painting));
        let (picture, outcome) = run(&settings(target), 2, &NoClock, formula);
        let error = compare(&picture, &truth, &light()).rmse;
        for method in [Method::Grid, Method::Recursive] {
            for (threshold, depth) in [(0.0, 2), (0.0, 3), (0.03, 3), (0.1, 2), (0.1, 4), (0.3, 3), (0.3, 5)]
            {
                let antialias = Antialias { threshold, depth, ..Antialias::new(method, Gamma::Power(1.0)) };
                let settings = Settings { antialias: Some(antialias), ..Settings::new(WIDTH, HEIGHT) };
                let canvas = Mutex::new(Picture::new(WIDTH, HEIGHT));
                let samplers = crate::render::render(&settings, &pool(2), &canvas, &Unobserved, || {
                    Painted::new(formula)
                });
                let rays: u64 = samplers.iter().map(Sampler::rays).sum();
                let other = compare(&canvas.into_inner().unwrap(), &truth, &light()).rmse;
                assert!(
                    rays > outcome.samples || other > 1.1 * error,
                    "{name}: {method:?} {threshold} {depth}: {other} for {rays}, adaptive {error} for {}",
                    outcome.samples
                );
            }
        }
    }
}

#[test]
fn pictures_are_the_same_for_all_thread_counts() {
    let (one, a) = run(&settings(0.01), 1, &NoClock, medley);
    let (three, b) = run(&settings(0.01), 3, &NoClock, medley);
    assert!(one == three);
    assert_eq!((a.samples, a.rounds, a.rmse), (b.samples, b.rounds, b.rmse));
    assert!(a.rounds > 3);
}

/// What time ended is repeated by allowing as many samples, on any number of threads.
#[test]
fn a_render_that_time_ended_can_be_repeated() {
    for deadline in [0.7, 5.0, 30.0] {
        let timed = Adaptive { deadline: Some(deadline), ..settings(1e-4) };
        let (picture, a) = run(&timed, 2, &Ticks::new(0.001), balls);
        assert_eq!(a.ended, Ended::Time);
        let counted = Adaptive { max_samples: Some(a.samples), ..settings(1e-4) };
        let (again, b) = run(&counted, 3, &NoClock, balls);
        assert!(picture == again, "{deadline}");
        assert_eq!((a.samples, a.rounds), (b.samples, b.rounds));
        if b.ended == Ended::Samples {
            assert_eq!(a.rmse, b.rmse);
        }
    }
}

/// Too little time for one sample a pixel: a coarser picture, without an estimate.
#[test]
fn there_is_always_a_picture() {
    let short = Adaptive { deadline: Some(0.05), ..settings(0.01) };
    let (picture, outcome) = run(&short, 2, &Ticks::new(0.001), waves);
    assert_eq!((outcome.ended, outcome.rmse), (Ended::Time, None));
    assert!(outcome.samples < u64::from(WIDTH * HEIGHT) / 4);
    assert!(picture.pixels.iter().all(|p| p.transmit == 0.0));
    assert!(compare(&picture, &truth(&WAVES), &light()).rmse < 0.35);
    // Even when time was up before it began.
    let (picture, outcome) = run(&Adaptive { deadline: Some(-1.0), ..short }, 2, &NoClock, waves);
    assert!((1..100).contains(&outcome.samples), "{}", outcome.samples);
    assert!(picture.pixels.iter().all(|p| p.transmit == 0.0));
}

/// Nothing to see is seen quickly.
#[test]
fn an_empty_picture_needs_one_sample_a_pixel() {
    let (picture, outcome) = run(&settings(0.001), 2, &NoClock, |_, _, _| 0.4);
    assert_eq!((outcome.samples, outcome.rounds), (u64::from(WIDTH * HEIGHT), 0));
    assert!(picture.pixels.iter().all(|p| p.rgb.x == 0.4));
}

/// A region of a larger picture has the samples that it has in the whole: places decide, not order.
#[test]
fn regions_lie_where_they_are() {
    let mut part = settings(0.3);
    part.region = Region { x0: 20, y0: 10, x1: 60, y1: 50 };
    let (picture, _) = run(&part, 2, &NoClock, shapes);
    let (whole, _) = run(&settings(0.3), 2, &NoClock, shapes);
    for y in 0..HEIGHT {
        for x in 0..WIDTH {
            let inside = (20..60).contains(&x) && (10..50).contains(&y);
            let inner = (21..59).contains(&x) && (11..49).contains(&y);
            assert_eq!(picture.get(x, y) != crate::picture::Pixel::NONE, inside);
            assert!(!inner || picture.get(x, y) == whole.get(x, y));
        }
    }
}
