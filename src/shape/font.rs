//! Letters of TrueType fonts and how they stand in a line. Outlines, metrics and kerning are read by the
//! `ttf-parser` crate; lengths are parts of the em.

use super::glyph::Segment;
use crate::math::Vec2;
use ttf_parser::cmap::{Format, Subtable};
use ttf_parser::{Face, GlyphId, PlatformId};

/// Which character tables of a font are preferred.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Charset {
    /// The Macintosh table, then Windows', then Unicode's.
    Ascii,
    /// Unicode's, then Windows', then the Macintosh one.
    Unicode,
}

/// One letter in its place.
#[derive(Clone, Debug)]
pub struct Letter {
    pub outline: Vec<Segment>,
}

/// The letters of `text` (16-bit units) in a line that begins at the origin; `offset` is added after each.
/// A blank has an empty outline. `None` if the font cannot be read.
pub fn letters(font: &[u8], text: &[u16], offset: Vec2, charset: Charset) -> Option<Vec<Letter>> {
    let face = Face::parse(font, 0).ok()?;
    let em = 1.0 / f64::from(face.units_per_em());
    let table = character_table(&face, charset);
    let mut letters = Vec::new();
    let mut pen = Vec2::ZERO;
    let mut previous: Option<GlyphId> = None;
    for &code in text {
        let id = table.as_ref().map_or(GlyphId(0), |t| glyph_of(t, code));
        let mut outline = Outline::new(em);
        if code != 32 {
            face.outline_glyph(id, &mut outline);
            outline.close_contour();
        }
        let least = if code == 32 { 0.0 } else { least_x(&face, id, &outline, em) };
        let advance = f64::from(face.glyph_hor_advance(id).unwrap_or(0)) * em;
        let bearing = f64::from(face.glyph_hor_side_bearing(id).unwrap_or(0)) * em;
        let place = match previous {
            None => {
                let place = Vec2::new(-least, 0.0);
                pen.x = advance - bearing;
                place
            }
            Some(before) => {
                let kern = kerning(&face, before, id, em);
                let place = Vec2::new(pen.x + bearing - least, pen.y) + kern;
                pen.x += advance + kern.x;
                place
            }
        };
        pen += offset;
        previous = Some(id);
        letters.push(Letter { outline: outline.moved(place) });
    }
    Some(letters)
}

/// The first table that can be read of the preferred platform that has one.
fn character_table<'a>(face: &Face<'a>, charset: Charset) -> Option<Subtable<'a>> {
    let platforms = match charset {
        Charset::Ascii => [PlatformId::Macintosh, PlatformId::Windows, PlatformId::Unicode],
        Charset::Unicode => [PlatformId::Unicode, PlatformId::Windows, PlatformId::Macintosh],
    };
    let tables = face.tables().cmap?.subtables;
    let readable = |t: &Subtable| {
        matches!(
            t.format,
            Format::ByteEncodingTable(_)
                | Format::SegmentMappingToDeltaValues(_)
                | Format::TrimmedTableMapping(_)
        )
    };
    platforms.iter().find_map(|&p| tables.into_iter().find(|t| t.platform_id == p && readable(t)))
}

fn glyph_of(table: &Subtable, code: u16) -> GlyphId {
    let found = |c: u32| table.glyph_index(c).filter(|g| g.0 != 0);
    // Symbol fonts keep their characters at 0xF000.
    let symbol = || match table.format {
        Format::SegmentMappingToDeltaValues(_) if code < 256 => found(u32::from(code) + 0xF000),
        _ => None,
    };
    found(u32::from(code)).or_else(symbol).unwrap_or(GlyphId(0))
}

/// The least x of a glyph: its header's, or that of a point further left. For composite glyphs the points
/// count by whole ems, so that a positive value becomes 0.
fn least_x(face: &Face, id: GlyphId, outline: &Outline, em: f64) -> f64 {
    let header = face.glyph_bounding_box(id).map_or(0.0, |b| f64::from(b.x_min) * em);
    if is_composite(face, id) {
        let below = |least: f64, x: f64| if x < least { least.min(x.trunc()) } else { least };
        let trimmed = outline.xs().fold(header, below);
        return if header > 0.0 { trimmed.min(0.0) } else { trimmed };
    }
    outline.xs().fold(header, f64::min)
}

/// Whether a glyph is put together from others: its number of contours is negative.
fn is_composite(face: &Face, id: GlyphId) -> bool {
    let raw = face.raw_face();
    let table = |tag: &[u8; 4]| raw.table(ttf_parser::Tag::from_bytes(tag));
    let (Some(places), Some(glyphs)) = (table(b"loca"), table(b"glyf")) else { return false };
    let index = usize::from(id.0);
    let start = match face.tables().head.index_to_location_format {
        ttf_parser::head::IndexToLocationFormat::Short => {
            places.get(2 * index..2 * index + 2).map(|b| 2 * usize::from(u16::from_be_bytes([b[0], b[1]])))
        }
        ttf_parser::head::IndexToLocationFormat::Long => places
            .get(4 * index..4 * index + 4)
            .map(|b| u32::from_be_bytes([b[0], b[1], b[2], b[3]]) as usize),
    };
    start.and_then(|s| glyphs.get(s)).is_some_and(|b| b & 0x80 != 0)
}

/// What moves the right one of a pair of letters, from the `kern` table: along x, or along y where the first
/// subtable says "cross-stream". Used if that subtable is horizontal. At least -1 em.
///
/// Pairs are read in the order of the file up to the first with a later left letter: fonts that are not
/// sorted lose pairs, as they always have.
fn kerning(face: &Face, left: GlyphId, right: GlyphId, em: f64) -> Vec2 {
    let Some(table) = face.raw_face().table(ttf_parser::Tag::from_bytes(b"kern")) else { return Vec2::ZERO };
    let word = |at: usize| table.get(at..at + 2).map(|b| u16::from_be_bytes([b[0], b[1]]));
    if word(0) != Some(0) {
        return Vec2::ZERO;
    }
    let (mut sum, mut at, mut first) = (0.0, 4, None);
    for _ in 0..word(2).unwrap_or(0) {
        let (Some(length), Some(coverage)) = (word(at + 2), word(at + 4)) else { break };
        let rules = *first.get_or_insert(coverage);
        if rules & HORIZONTAL == 0 {
            return Vec2::ZERO;
        }
        if coverage >> 8 == 0
            && let Some(value) = pair(&word, at + 6, left, right)
        {
            let value = f64::from(value) * em;
            sum = if rules & OVERRIDE != 0 {
                value
            } else if rules & MINIMUM != 0 {
                value.min(sum)
            } else {
                sum + value
            };
        }
        at += usize::from(length).max(6);
    }
    let sum = f64::max(sum, -1.0);
    if first.unwrap_or(0) & CROSS_STREAM != 0 { Vec2::new(0.0, sum) } else { Vec2::new(sum, 0.0) }
}

/// Bits of a kerning subtable's coverage.
const HORIZONTAL: u16 = 1;
const MINIMUM: u16 = 2;
const CROSS_STREAM: u16 = 4;
const OVERRIDE: u16 = 8;

/// The value of a pair in the ordered list that begins at `at`.
fn pair(word: &impl Fn(usize) -> Option<u16>, at: usize, left: GlyphId, right: GlyphId) -> Option<i16> {
    let count = usize::from(word(at)?);
    let entries = (0..count).map(|i| at + 8 + 6 * i);
    let mut entries = entries.map_while(|e| Some((word(e)?, word(e + 2)?, word(e + 4)?)));
    let found = entries.find(|&(l, r, _)| l > left.0 || (l == left.0 && r == right.0))?;
    (found.0 == left.0).then_some(found.2 as i16)
}

/// Collects a glyph's contours.
struct Outline {
    em: f64,
    segments: Vec<Segment>,
    start: Vec2,
    at: Vec2,
}

impl Outline {
    fn new(em: f64) -> Self {
        Self { em, segments: Vec::new(), start: Vec2::ZERO, at: Vec2::ZERO }
    }

    fn point(&self, x: f32, y: f32) -> Vec2 {
        Vec2::new(f64::from(x), f64::from(y)) * self.em
    }

    fn close_contour(&mut self) {
        if self.at != self.start {
            self.segments.push(Segment::Line(self.at, self.start));
            self.at = self.start;
        }
    }

    fn xs(&self) -> impl Iterator<Item = f64> + '_ {
        self.segments.iter().flat_map(|s| match *s {
            Segment::Line(a, b) => [a.x, b.x, b.x],
            Segment::Curve(a, c, b) => [a.x, c.x, b.x],
        })
    }

    fn moved(self, by: Vec2) -> Vec<Segment> {
        let shift = |s: Segment| match s {
            Segment::Line(a, b) => Segment::Line(a + by, b + by),
            Segment::Curve(a, c, b) => Segment::Curve(a + by, c + by, b + by),
        };
        self.segments.into_iter().map(shift).collect()
    }
}

impl ttf_parser::OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.close_contour();
        self.start = self.point(x, y);
        self.at = self.start;
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let to = self.point(x, y);
        if to != self.at {
            self.segments.push(Segment::Line(self.at, to));
        }
        self.at = to;
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let (control, to) = (self.point(x1, y1), self.point(x, y));
        self.segments.push(Segment::Curve(self.at, control, to));
        self.at = to;
    }

    /// TrueType outlines have no cubic curves; fonts that have them are not accepted.
    fn curve_to(&mut self, _: f32, _: f32, _: f32, _: f32, x: f32, y: f32) {
        self.line_to(x, y);
    }

    fn close(&mut self) {
        self.close_contour();
    }
}
