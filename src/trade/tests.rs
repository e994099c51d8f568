use super::sweep::{Plan, sweep};
use super::*;
use crate::color::Gamma;
use crate::picture::light;
use crate::render::adaptive::{self, Adaptive};
use crate::render::synthetic::{MEDLEY, Painted};
use crate::render::{Antialias, Region, Sampler, Settings, Unobserved};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

/// A painted picture; time passes while samples are taken.
struct Painting {
    light: Light,
    clock: Invented,
    pool: rayon::ThreadPool,
    axes: Axes,
}

/// Microseconds.
struct Invented(AtomicU64);

impl Clock for Invented {
    fn seconds(&self) -> f64 {
        self.0.load(Ordering::Relaxed) as f64 * 1e-6
    }
}

impl Stopwatch for Invented {
    fn cpu_seconds(&self) -> f64 {
        2.0 * self.seconds()
    }
}

/// What a sample costs.
const MICROSECONDS: u64 = 20;

impl Painting {
    fn new(axes: Axes) -> Self {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
        Self { light: Light::new(Gamma::Power(1.0)), clock: Invented(AtomicU64::new(0)), pool, axes }
    }

    fn spend(&self, samples: u64) {
        self.clock.0.fetch_add(samples * MICROSECONDS, Ordering::Relaxed);
    }

    fn adaptive(&self, settings: &Adaptive, size: Size) -> (Picture, adaptive::Outcome<Painted>) {
        let canvas = Mutex::new(Picture::new(size.width, size.height));
        let painted = || Painted::new(MEDLEY.formula);
        let outcome = adaptive::render(settings, &self.pool, &canvas, &Unobserved, &self.clock, painted);
        self.spend(outcome.samples);
        (canvas.into_inner().unwrap(), outcome)
    }

    fn settings(&self, size: Size) -> Adaptive {
        Adaptive::new(Region::whole(size.width, size.height), self.light.clone())
    }
}

impl Subject for Painting {
    fn prepare(&self, _size: Size) -> Result<(), String> {
        Ok(())
    }

    fn render(&self, size: Size, knobs: &Knobs, until: f64) -> Option<Picture> {
        let antialias = match knobs.sampling {
            Sampling::Adaptive { max_error } => {
                let settings = Adaptive { target: Some(max_error), ..self.settings(size) };
                return Some(self.adaptive(&settings, size).0).filter(|_| self.clock.seconds() <= until);
            }
            Sampling::Centre => None,
            Sampling::Fixed { method, threshold, depth } => {
                Some(Antialias { threshold, depth, ..Antialias::new(method, Gamma::Power(1.0)) })
            }
        };
        let settings = Settings { antialias, ..Settings::new(size.width, size.height) };
        let canvas = Mutex::new(Picture::new(size.width, size.height));
        let painted = || Painted::new(MEDLEY.formula);
        let samplers = crate::render::render(&settings, &self.pool, &canvas, &Unobserved, painted);
        self.spend(samplers.iter().map(Sampler::rays).sum());
        Some(canvas.into_inner().unwrap()).filter(|_| self.clock.seconds() <= until)
    }

    fn reference(&self, size: Size, target: f64, until: f64) -> Option<Reference> {
        let spare = (until - self.clock.seconds()) / (MICROSECONDS as f64 * 1e-6);
        let limited = Adaptive {
            target: Some(target),
            max_samples: Some(spare.max(0.0) as u64),
            seed: 9,
            ..self.settings(size)
        };
        let (picture, outcome) = self.adaptive(&limited, size);
        Some(Reference { picture, samples: outcome.samples, rmse: outcome.rmse? })
    }

    fn light(&self) -> &Light {
        &self.light
    }

    fn encoding(&self) -> Encoding {
        Encoding::new(Gamma::Power(1.0))
    }

    fn command(&self, size: Size, knobs: &Knobs) -> String {
        format!("glint medley -W{} -H{} {}", size.width, size.height, knobs.words().join(" "))
    }
}

fn measured(subject: &Painting, size: Size, budget: f64) -> Result<sweep::Measurement, String> {
    let knobs = grid(&subject.axes, true);
    sweep(subject, &subject.clock, &Plan { size, begin: 0.0, end: budget, knobs }, &|_| ())
}

const SIZE: Size = Size { width: 96, height: 72 };

#[test]
fn a_sweep_measures_every_way_of_the_grid() {
    let subject = Painting::new(Axes::default());
    let m = measured(&subject, SIZE, 260.0).unwrap();
    assert_eq!((m.size, m.reduced, m.rows.len(), m.left_out.len()), (SIZE, false, 18, 0));
    // Each row's numbers are those of its picture and its time.
    for row in &m.rows {
        let error = light::compare(&row.picture, &m.reference_picture, subject.light());
        assert_eq!((row.rmse, row.psnr_db), (error.rmse, error.psnr_db), "{}", row.name);
        assert!(row.rmse <= row.worst_tile_rmse && row.perceptual.unwrap() <= 1.0);
        assert!((row.cpu_s - 2.0 * row.wall_s).abs() < 1e-9);
    }
    let plain = &m.rows[0];
    assert_eq!(plain.settings, Knobs::new(Sampling::Centre));
    assert!((plain.wall_s - SIZE.pixels() * 20e-6).abs() < 1e-9);
    // Adaptive rows are as good as they were meant to be, and make up the better part of the front.
    for row in &m.rows {
        if let Sampling::Adaptive { max_error } = row.settings.sampling {
            assert!(row.rmse < 1.5 * max_error, "{} {}", row.name, row.rmse);
        }
    }
    assert!(m.reference.rmse_estimate < 0.002, "{}", m.reference.rmse_estimate);
    assert!(m.rows[m.knee.unwrap()].on_front);
    let finest = m.rows.iter().min_by(|a, b| a.rmse.total_cmp(&b.rmse)).unwrap();
    assert!(matches!(finest.settings.sampling, Sampling::Adaptive { .. }), "{}", finest.name);
}

/// The budget is kept within a fifth, whatever it is; too small a budget makes pictures smaller, and says so.
#[test]
fn budgets_are_kept() {
    for budget in [4.0, 12.0, 100.0] {
        let subject = Painting::new(Axes { trace_level: Some(10), lamps: Some(25), ..Axes::default() });
        let size = Size { width: 200, height: 150 };
        let m = measured(&subject, size, budget).unwrap();
        let spent = subject.clock.seconds();
        assert!(spent < 1.2 * budget, "{spent} of {budget}");
        assert!(spent > 0.4 * budget, "{spent} of {budget}");
        assert_eq!(m.reduced, m.size != size);
        assert!(budget > 50.0 || m.reduced, "{budget}");
    }
    assert!(measured(&Painting::new(Axes::default()), SIZE, 0.01).is_err());
}

#[test]
fn the_report_stands_alone() {
    let subject = Painting::new(Axes::default());
    let m = measured(&subject, Size { width: 96, height: 72 }, 30.0).unwrap();
    let html = report::page("<medley>.pov", &m, &subject.encoding());
    for part in
        ["&lt;medley&gt;.pov", "<svg id=\"plot\"", "<table id=\"rows\">", "data:image/png;base64,", "knee"]
    {
        assert!(html.contains(part), "{part}");
    }
    assert_eq!(html.matches("class=\"point\"").count(), m.rows.len());
    assert!(
        !html.contains("http:") && !html.contains("https:") && !html.contains("src=\"/"),
        "nothing is fetched"
    );
    let json = serde_json::to_value(&m).unwrap();
    assert_eq!(json["rows"].as_array().unwrap().len(), m.rows.len());
    assert_eq!(json["rows"][0]["settings"]["aa_method"], "none");
    assert!(json["rows"][0]["picture"].is_null());
}
