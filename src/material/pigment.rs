use crate::color::{Color, grey};
use crate::function::{Surroundings, VectorFunction, VectorKind};
use crate::math::Vec3;
use crate::pattern::image::{ImageMap, OUTSIDE};
use crate::pattern::{BlendMap, Blended, Changes, ColorMap, Context, Pattern, Setting, Signal};
use glam::DAffine3;
use std::cell::Cell;
use std::sync::Arc;

/// What helps to find a pigment's colours roughly, see [`Pigment::rough`].
#[derive(Clone, Debug)]
pub struct Rough {
    changes: Changes,
    /// To the pattern's own space but for turbulence, where that is a small thing beside the pattern.
    inward: Option<DAffine3>,
    /// Turbulence hardly ever changes the pattern's value by more than this.
    doubt: f64,
}

impl Rough {
    /// The same for points of another space, from which `inward` leads to the pigment's.
    pub fn seen_from(mut self, inward: &DAffine3) -> Self {
        self.inward = self.inward.map(|own| own * *inward);
        self
    }
}

/// More doubt does not pay.
const LARGEST_DOUBT: f64 = 0.1;

/// A colour at every point.
#[derive(Clone, Debug)]
pub struct Pigment {
    pub kind: PigmentKind,
    /// Pattern, warps and wave. A plain pigment keeps them for a pattern that is written over it.
    pub signal: Signal,
    /// The map or list that was written; `None` for the pattern's own colours.
    pub map: Option<PigmentMap>,
    /// Whether a colour, a pattern or an image was named; if not, the pigment is black and may still be given a map.
    pub typed: bool,
    /// Stands for the pigment at low quality.
    pub quick_color: Option<Color>,
    /// The pattern's own colours, where no map was written.
    own_colors: Option<ColorMap>,
    opaque: bool,
    asks_hit: bool,
    depth: u32,
    cost: f64,
}

#[derive(Clone, Debug)]
pub enum PigmentKind {
    Plain(Color),
    /// The map at the pattern's value.
    Patterned,
    /// The weighted mean of the map's items.
    Average,
    Image(ImageMap),
    /// The inner pigment at the surface's (u, v, 0).
    Uv(Arc<Pigment>),
}

#[derive(Clone, Debug)]
pub enum PigmentMap {
    Colors(ColorMap),
    Pigments(BlendMap<Arc<Pigment>>),
}

impl Default for Pigment {
    /// Opaque black.
    fn default() -> Self {
        Self { typed: false, ..Self::plain_color(Color::BLACK) }
    }
}

impl Pigment {
    pub fn plain_color(color: Color) -> Self {
        let mut pigment = Self {
            kind: PigmentKind::Plain(color),
            signal: Signal::default(),
            map: None,
            typed: true,
            quick_color: None,
            own_colors: None,
            opaque: true,
            asks_hit: false,
            depth: 0,
            cost: 1.0,
        };
        pigment.settle();
        pigment
    }

    /// Works out what later questions ask for. Call it after every change.
    pub fn settle(&mut self) {
        let patterned = matches!(self.kind, PigmentKind::Patterned);
        self.own_colors =
            (patterned && self.map.is_none()).then(|| BlendMap::new(self.signal.pattern.colors()));
        let opaque_map = |map: &ColorMap| map.items().all(|c| !c.is_transparent());
        self.depth = 1 + self.children().map(|p| p.depth).fold(self.signal.pattern.depth(), u32::max);
        let below = match (&self.kind, &self.map) {
            (PigmentKind::Patterned, Some(PigmentMap::Pigments(map))) => map.cost(|p| p.cost),
            _ => self.children().map(|p| p.cost).sum::<f64>(),
        };
        self.cost = 1.0 + self.signal.pattern.cost() + below;
        let asks = match self.kind {
            PigmentKind::Patterned => self.signal.pattern.asks_hit(),
            _ => matches!(self.kind, PigmentKind::Uv(_)),
        };
        self.asks_hit = asks || self.children().any(|p| p.asks_hit);
        self.opaque = match (&self.kind, &self.map) {
            (PigmentKind::Plain(color), _) => !color.is_transparent(),
            (PigmentKind::Patterned, None) => true,
            (PigmentKind::Image(map), _) => map.is_opaque(),
            (PigmentKind::Patterned | PigmentKind::Average, Some(PigmentMap::Colors(map))) => opaque_map(map),
            _ => self.children().all(|p| p.opaque),
        };
    }

    pub(super) fn children(&self) -> impl Iterator<Item = &Arc<Pigment>> {
        let (inner, map) = match (&self.kind, &self.map) {
            (PigmentKind::Uv(inner), _) => (Some(inner), None),
            (PigmentKind::Patterned | PigmentKind::Average, Some(PigmentMap::Pigments(map))) => {
                (None, Some(map))
            }
            _ => (None, None),
        };
        inner.into_iter().chain(map.into_iter().flat_map(BlendMap::items))
    }

    /// How deep pigments are nested in this one, itself included.
    pub fn depth(&self) -> u32 {
        self.depth
    }

    /// How many pigments are asked for one colour at most.
    pub fn cost(&self) -> f64 {
        self.cost
    }

    /// The colour at `p` in pigment space; `None` outside an image mapped `once`.
    pub fn color(&self, p: Vec3, context: &Context) -> Option<Color> {
        match &self.kind {
            PigmentKind::Plain(color) => Some(*color),
            PigmentKind::Patterned => Some(self.patterned(p, context)),
            PigmentKind::Average => self.average(p, context),
            PigmentKind::Image(map) => map.color(self.signal.warp_alone(p)),
            PigmentKind::Uv(inner) => {
                let uv = context.hit?.uv;
                inner.color(uv.extend(0.0), context)
            }
        }
    }

    /// The colour, with what shows outside an image: clear white.
    pub fn color_or_clear(&self, p: Vec3, context: &Context) -> Color {
        self.color(p, context).unwrap_or(OUTSIDE)
    }

    #[inline]
    fn patterned(&self, p: Vec3, context: &Context) -> Color {
        let q = self.signal.warp(p);
        let value = self.signal.value(q, context);
        match (&self.map, &self.own_colors) {
            (Some(PigmentMap::Colors(map)), _) | (None, Some(map)) => map.color(value),
            (Some(PigmentMap::Pigments(map)), _) => match map.at(value) {
                Blended::One(pigment) => pigment.color_or_clear(q, context),
                Blended::Two(t, low, high) => {
                    let (low, high) = (low.color_or_clear(q, context), high.color_or_clear(q, context));
                    low.toward(high, t)
                }
            },
            (None, None) => Color::BLACK,
        }
    }

    /// What [`Pigment::rough_color`] needs to know, for pigments with a map of colours.
    pub fn rough(&self) -> Option<Rough> {
        let (PigmentKind::Patterned, Some(PigmentMap::Colors(map))) = (&self.kind, &self.map) else {
            return None;
        };
        let mut rough = Rough { changes: Changes::new(map)?, inward: None, doubt: 0.0 };
        if let (Some(steepness), Some((inward, shift))) =
            (self.signal.pattern.steepness(), self.signal.calmed())
        {
            rough.doubt = 3.0 * steepness * shift;
            rough.inward = (0.0 < rough.doubt && rough.doubt < LARGEST_DOUBT).then_some(inward);
        }
        Some(rough)
    }

    /// The colour at `p` but for `tolerance` in red, green and blue, if that is found without turbulence. `p` is a
    /// place in the space that `rough` is seen from.
    pub fn calm_color(&self, rough: &Rough, p: Vec3, context: &Context, tolerance: f32) -> Option<Color> {
        let (Some(PigmentMap::Colors(map)), Some(inward)) = (&self.map, &rough.inward) else {
            return None;
        };
        let (doubt, told) = (rough.doubt, Cell::new(false));
        let settles = |low: f64, high: f64| {
            told.set(rough.changes.between(low - doubt, high + doubt) <= tolerance);
            told.get() || high - low < doubt
        };
        let value = self.signal.value_within(inward.transform_point3(p), context, &settles);
        told.get().then(|| map.color(value))
    }

    /// The colour at `p` in pigment space but for `tolerance` in red, green and blue.
    pub fn rough_color(&self, rough: &Rough, p: Vec3, context: &Context, tolerance: f32) -> Option<Color> {
        let Some(PigmentMap::Colors(map)) = &self.map else { return self.color(p, context) };
        let settles = |low: f64, high: f64| rough.changes.between(low, high) <= tolerance;
        Some(map.color(self.signal.value_within(self.signal.warp(p), context, &settles)))
    }

    /// The largest of red, green and blue that a plain pigment or one with a colour map has anywhere.
    pub fn brightest(&self) -> Option<f32> {
        match (&self.kind, &self.map) {
            (PigmentKind::Plain(color), _) => Some(color.rgb.max_element()),
            (PigmentKind::Patterned, Some(PigmentMap::Colors(map))) => {
                map.items().map(|c| c.rgb.max_element()).reduce(f32::max)
            }
            _ => None,
        }
    }

    fn average(&self, p: Vec3, context: &Context) -> Option<Color> {
        let q = self.signal.warp_alone(p);
        let (sum, total) = match self.map.as_ref()? {
            PigmentMap::Colors(map) => {
                (map.iter().fold(Color::BLACK, |sum, (w, &c)| sum + c * w as f32), map.total_weight())
            }
            PigmentMap::Pigments(map) => {
                let add = |sum, (w, c): (f64, &Arc<Pigment>)| sum + c.color_or_clear(q, context) * w as f32;
                (map.iter().fold(Color::BLACK, add), map.total_weight())
            }
        };
        Some(sum * (1.0 / total) as f32)
    }

    /// The colour if it is the same everywhere.
    #[inline]
    pub fn plain(&self) -> Option<Color> {
        match self.kind {
            PigmentKind::Plain(color) => Some(color),
            _ => None,
        }
    }

    /// Whether no point lets light through.
    #[inline]
    pub fn is_opaque(&self) -> bool {
        self.opaque
    }

    /// Whether colours hang on how a ray met the surface, not on the point alone.
    #[inline]
    pub fn asks_hit(&self) -> bool {
        self.asks_hit
    }

    /// Moves what the pigment shows.
    pub fn transform(&mut self, t: &crate::math::Transform) {
        self.signal.transform(t);
    }

    /// Turns `filter` into `transmit`, as old versions do in all layers but the lowest.
    pub fn unfilter(&mut self) {
        let clear = |c: &mut Color| {
            c.transmit += c.filter;
            c.filter = 0.0;
        };
        if let PigmentKind::Plain(color) = &mut self.kind {
            clear(color);
        }
        match &mut self.map {
            Some(PigmentMap::Colors(map)) => map.items_mut().for_each(clear),
            Some(PigmentMap::Pigments(map)) => map.items_mut().for_each(|p| Arc::make_mut(p).unfilter()),
            None => (),
        }
    }
}

/// The grey value of a pigment, as a pattern.
#[derive(Clone, Debug)]
pub struct GreyPigment(pub Arc<Pigment>);

impl Pattern for GreyPigment {
    #[inline]
    fn asks_hit(&self) -> bool {
        self.0.asks_hit()
    }

    fn depth(&self) -> u32 {
        1 + self.0.depth()
    }

    fn cost(&self) -> f64 {
        self.0.cost()
    }

    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        f64::from(grey(self.0.color_or_clear(p, setting.context).rgb))
    }
}

/// A pigment as a function of space, away from any surface.
#[derive(Clone, Debug)]
pub struct PigmentField {
    pub pigment: Arc<Pigment>,
    pub surroundings: Arc<Surroundings>,
}

impl PigmentField {
    pub fn color(&self, p: Vec3) -> Color {
        self.pigment.color_or_clear(p, &Context::away(&self.surroundings))
    }
}

impl VectorFunction for PigmentField {
    fn kind(&self) -> VectorKind {
        VectorKind::Color
    }

    fn depth(&self) -> u32 {
        1 + self.pigment.depth()
    }

    fn value(&self, arguments: &[f64]) -> [f64; 5] {
        self.color(Vec3::from_slice(arguments)).components().map(f64::from)
    }
}
