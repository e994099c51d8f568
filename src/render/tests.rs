use super::*;
use crate::color::{Gamma, Rgb};
use std::sync::atomic::AtomicU64;

/// A picture known at every place, that keeps the places asked for.
struct Painted<F> {
    color: F,
    asked: Vec<(f64, f64)>,
}

impl<F: Fn(f64, f64) -> f32> Painted<F> {
    fn new(color: F) -> Self {
        Self { color, asked: Vec::new() }
    }
}

impl<F: Fn(f64, f64) -> f32> Sampler for Painted<F> {
    fn seed(&mut self, _x: u32, _y: u32, _sample: u32) {}

    fn sample(&mut self, x: f64, y: f64) -> Pixel {
        self.asked.push((x, y));
        Pixel::new(Rgb::splat((self.color)(x, y)), 0.0)
    }

    fn rays(&self) -> u64 {
        self.asked.len() as u64
    }
}

fn pool(threads: usize) -> rayon::ThreadPool {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap()
}

fn settings(width: u32, height: u32, method: Option<Method>) -> Settings {
    let antialias = method.map(|m| Antialias { jitter: 0.0, ..Antialias::new(m, Gamma::Power(1.0)) });
    Settings { antialias, ..Settings::new(width, height) }
}

/// Black left of `edge`, white right of it.
fn edge(edge: f64) -> impl Fn(f64, f64) -> f32 + Copy + Sync + Send {
    move |x, _| if x < edge { 0.0 } else { 1.0 }
}

/// Renders on one thread; the picture's red values and the places asked for.
fn picture_of(
    settings: &Settings,
    color: impl Fn(f64, f64) -> f32 + Copy + Sync + Send,
) -> (Vec<f32>, Vec<(f64, f64)>) {
    let canvas = Mutex::new(Picture::new(settings.region.x1, settings.region.y1));
    let samplers = render(settings, &pool(1), &canvas, &Unobserved, || Painted::new(color));
    let asked = samplers.into_iter().flat_map(|s| s.asked).collect();
    (canvas.into_inner().unwrap().pixels.iter().map(|p| p.rgb.x).collect(), asked)
}

#[test]
fn without_antialiasing_pixels_are_sampled_in_their_centres() {
    let (values, asked) = picture_of(&settings(3, 2, None), |x, y| (x + 10.0 * y) as f32);
    assert_eq!(values, [0.0, 1.0, 2.0, 10.0, 11.0, 12.0]);
    assert_eq!(asked.len(), 6);
}

/// An edge at 2.2 between the centres of pixels 2 and 3: both are divided in 3x3 samples (at -1/3, 0, 1/3),
/// of which a third lies right of the edge in pixel 2. The white centre of 3 joins nine white samples.
#[test]
fn grid_divides_both_pixels_at_an_edge() {
    let (values, asked) = picture_of(&settings(5, 1, Some(Method::Grid)), edge(2.2));
    assert_eq!(values, [0.0, 0.0, 0.3, 1.0, 1.0]);
    // A row above, a column to the left, five centres, two grids.
    assert_eq!(asked.len(), 5 + 1 + 5 + 18);
    let near = |p: &(f64, f64)| (p.0 - 7.0 / 3.0).abs() < 1e-9 && (p.1 + 1.0 / 3.0).abs() < 1e-9;
    assert_eq!(asked.iter().filter(|p| near(p)).count(), 1);
}

/// Neighbours above are divided by rows below them.
#[test]
fn grid_looks_up_too() {
    let (values, _) = picture_of(&settings(1, 4, Some(Method::Grid)), |_, y| if y < 1.6 { 1.0 } else { 0.0 });
    assert_eq!(values, [1.0, 1.0, 0.0, 0.0]);
    let (values, _) = picture_of(&settings(1, 4, Some(Method::Grid)), |_, y| if y < 1.3 { 1.0 } else { 0.0 });
    assert_eq!(values, [1.0, 0.7, 0.0, 0.0]);
}

/// The last column of a block is not divided by the first of the next.
#[test]
fn grid_does_not_look_across_blocks() {
    let small = Settings { block_size: 4, ..settings(8, 1, Some(Method::Grid)) };
    let (values, _) = picture_of(&small, edge(3.2));
    assert_eq!(values, [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0]);
    let (values, _) = picture_of(&small, edge(3.7));
    assert_eq!(values[3..5], [0.0, 0.7]);
}

#[test]
fn recursive_averages_corners() {
    let depth_one = |color: fn(f64, f64) -> f32| {
        let mut s = settings(2, 1, Some(Method::Recursive));
        s.antialias.as_mut().unwrap().depth = 1;
        picture_of(&s, color)
    };
    let (values, asked) = depth_one(|x, _| if x < 0.2 { 0.0 } else { 1.0 });
    assert_eq!(values, [0.5, 1.0]);
    // Six corners, two of them shared.
    assert_eq!(asked.len(), 6);
}

/// Depth 3 divides twice: an edge at 0.2 of pixel 0 (0.7 from its left side) leaves quarters of quarters;
/// sixteenths in the third column of four have two of four corners beyond the edge.
#[test]
fn recursive_divides_where_corners_differ() {
    let (values, _) = picture_of(&settings(2, 1, Some(Method::Recursive)), edge(0.2));
    // Columns of sixteenths end at -.25, 0, .25, .5: 0, 0, 1/2, 1.
    assert_eq!(values, [(0.0 + 0.0 + 0.5 + 1.0) / 4.0, 1.0]);
}

/// Differences are summed over the channels and encoded with gamma 2.5.
#[test]
fn threshold_is_reached_by_the_encoded_sum() {
    let antialias = Antialias::new(Method::Grid, Gamma::Power(1.0));
    let seen = |v: f32| antialias.seen(Pixel::new(Rgb::splat(v), 0.0));
    // 3 * |0.5^0.4 - c^0.4| is 0.3 at c = 0.357^...
    let c = (0.5f32.powf(0.4) - 0.1).powf(2.5);
    assert!(antialias.differ(&seen(0.5), &seen(c * 0.999)));
    assert!(!antialias.differ(&seen(0.5), &seen(c * 1.001)));
    let clear = antialias.seen(Pixel::new(Rgb::ZERO, 0.3));
    assert!(antialias.differ(&antialias.seen(Pixel::new(Rgb::ZERO, 0.0)), &clear));
}

#[test]
fn pictures_are_the_same_for_all_thread_counts() {
    let color = |x: f64, y: f64| ((x * 12.9898 + y * 78.233).sin() * 43758.5453).fract() as f32;
    for method in [None, Some(Method::Grid), Some(Method::Recursive)] {
        let mut s = settings(70, 45, method);
        if let Some(a) = &mut s.antialias {
            a.jitter = 1.0;
        }
        let picture = |threads| {
            let canvas = Mutex::new(Picture::new(70, 45));
            render(&s, &pool(threads), &canvas, &Unobserved, || Painted::new(color));
            canvas.into_inner().unwrap()
        };
        assert!(picture(1) == picture(3), "{method:?}");
    }
}

#[test]
fn a_region_leaves_the_rest_alone() {
    let mut s = settings(4, 4, None);
    s.region = Region { x0: 1, y0: 2, x1: 3, y1: 4 };
    let canvas = Mutex::new(Picture::new(4, 4));
    render(&s, &pool(2), &canvas, &Unobserved, || Painted::new(|_, _| 1.0));
    let canvas = canvas.into_inner().unwrap();
    for y in 0..4 {
        for x in 0..4 {
            let inside = (1..3).contains(&x) && (2..4).contains(&y);
            assert_eq!(canvas.get(x, y) != Pixel::NONE, inside, "{x} {y}");
        }
    }
}

struct StopsAfter {
    asked: AtomicU64,
    limit: u64,
}

impl Observer for StopsAfter {
    fn cancelled(&self) -> bool {
        self.asked.fetch_add(1, Ordering::Relaxed) >= self.limit
    }
}

#[test]
fn a_cancelled_render_keeps_what_it_has() {
    for method in [None, Some(Method::Grid), Some(Method::Recursive)] {
        let canvas = Mutex::new(Picture::new(64, 64));
        let stop = StopsAfter { asked: AtomicU64::new(0), limit: 100 };
        render(&settings(64, 64, method), &pool(1), &canvas, &stop, || Painted::new(|_, _| 1.0));
        let canvas = canvas.into_inner().unwrap();
        let done = canvas.pixels.iter().filter(|p| **p != Pixel::NONE).count();
        assert!((90..=100).contains(&done), "{method:?}: {done}");
    }
}
