use super::{Observer, Settings, blocks};
use crate::trace::{self, Counters, Gathered, Lighting, Pretrace};
use crate::world::World;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Gathers diffuse light for the picture before it is traced; `None` if the scene asks for none. Also
/// gives back what was counted.
pub fn pretrace(
    world: &World,
    tracing: &trace::Settings,
    settings: &Settings,
    pool: &rayon::ThreadPool,
    observer: &dyn Observer,
) -> (Option<Lighting>, Counters) {
    let tiles = blocks(settings.region, settings.block_size).into_iter().map(|b| {
        let r = b.region;
        [r.x0, r.y0, r.x1, r.y1]
    });
    let mut counters = Counters::default();
    let Some(mut pretrace) = Pretrace::new(world, tracing, tiles) else { return (None, counters) };
    for pass in 0..pretrace.passes() {
        let (gathered, counted) = trace_pass(&pretrace, pass, pool, observer);
        counters += counted;
        if observer.cancelled() {
            break;
        }
        pretrace.merge(gathered);
    }
    (Some(pretrace.finish()), counters)
}

/// All tiles of one pass, in the order of the tiles.
fn trace_pass(
    pretrace: &Pretrace,
    pass: usize,
    pool: &rayon::ThreadPool,
    observer: &dyn Observer,
) -> (Vec<Gathered>, Counters) {
    let next = AtomicUsize::new(0);
    let all = Mutex::new(Vec::with_capacity(pretrace.tiles()));
    let counted = pool.broadcast(|_| {
        let mut tracer = pretrace.tracer();
        loop {
            let tile = next.fetch_add(1, Ordering::Relaxed);
            if tile >= pretrace.tiles() || observer.cancelled() {
                return tracer.counters();
            }
            let gathered = pretrace.trace(&mut tracer, pass, tile);
            all.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).push((tile, gathered));
        }
    });
    let mut all = all.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner());
    all.sort_by_key(|&(tile, _)| tile);
    let mut counters = Counters::default();
    counted.into_iter().for_each(|c| counters += c);
    (all.into_iter().map(|(_, gathered)| gathered).collect(), counters)
}
