use super::gathering::gathered;
use super::{Observer, Settings, blocks};
use crate::trace::photon::Landed;
use crate::trace::{self, Counters, Indirect, Photons, Pretrace, Shooting, Tracer};
use crate::world::World;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

/// Shots that a thread takes at once.
const SHOTS: usize = 128;

/// Spreads light over the scene before the picture is traced: photons, then diffuse light between surfaces,
/// each if the scene asks for it. Also gives back what was counted.
pub fn indirect(
    world: &World,
    tracing: &trace::Settings,
    settings: &Settings,
    pool: &rayon::ThreadPool,
    observer: &dyn Observer,
) -> (Indirect, Counters) {
    let mut counters = Counters::default();
    let photons =
        Shooting::new(world, tracing).map(|shooting| shoot(shooting, pool, observer, &mut counters));
    let tiles = blocks(settings.region, settings.block_size).into_iter().map(|b| {
        let r = b.region;
        [r.x0, r.y0, r.x1, r.y1]
    });
    let radiosity = Pretrace::new(world, tracing, photons.clone(), tiles).and_then(|pretrace| {
        let (lighting, counted) = gathered(&pretrace, pool, observer);
        counters += counted;
        lighting
    });
    (Indirect { photons, radiosity }, counters)
}

/// All photons, salvo by salvo.
fn shoot(
    mut shooting: Shooting,
    pool: &rayon::ThreadPool,
    observer: &dyn Observer,
    counters: &mut Counters,
) -> Arc<Photons> {
    let mut tracers: Vec<Mutex<Tracer>> =
        (0..pool.current_num_threads()).map(|_| Mutex::new(shooting.tracer())).collect();
    // One of the pool's threads plans the salvos: it need not be woken for each.
    pool.install(|| {
        while let Some(shots) = shooting.aim() {
            if observer.cancelled() {
                break;
            }
            let landed = if shooting.is_serial() {
                let tracer = tracers[0].get_mut().unwrap_or_else(|poisoned| poisoned.into_inner());
                shooting.follow_serially(tracer)
            } else {
                follow(&shooting, &tracers, shots, pool)
            };
            shooting.land(landed);
        }
    });
    for tracer in tracers {
        *counters += tracer.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner()).counters();
    }
    pool.install(|| shooting.finish())
}

/// One salvo over all threads, in the order of the shots.
fn follow(
    shooting: &Shooting,
    tracers: &[Mutex<Tracer>],
    shots: usize,
    pool: &rayon::ThreadPool,
) -> Vec<(usize, Landed)> {
    let next = AtomicUsize::new(0);
    let all = Mutex::new(Vec::new());
    pool.broadcast(|thread| {
        let mut tracer = tracers[thread.index()].lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        loop {
            let first = next.fetch_add(SHOTS, Ordering::Relaxed);
            if first >= shots {
                return;
            }
            let landed = shooting.follow(&mut tracer, first..shots.min(first + SHOTS));
            all.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).push((first, landed));
        }
    });
    let mut all = all.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner());
    all.sort_by_key(|&(first, _)| first);
    all.into_iter().flat_map(|(_, landed)| landed).collect()
}
