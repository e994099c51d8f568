//! What textures are made of, for reports.

use super::{Finish, Layer, Media, Normal, NormalKind, PatternedKind, Pigment, PigmentKind, Texture};
use crate::pattern::Signal;
use std::collections::{BTreeMap, HashSet};
use std::sync::Arc;

/// How often each thing occurs; what is shared counts once.
#[derive(Clone, Debug, Default)]
pub struct Ingredients {
    pub pigments: BTreeMap<String, usize>,
    pub normals: BTreeMap<String, usize>,
    /// Patterns that choose between textures.
    pub texture_patterns: BTreeMap<String, usize>,
    pub layers: usize,
    pub transparent_layers: usize,
    pub reflecting_layers: usize,
    pub iridescent_layers: usize,
    pub subsurface_layers: usize,
    pub highlight_layers: usize,
    seen: HashSet<usize>,
}

impl Ingredients {
    pub fn add_texture(&mut self, texture: &Arc<Texture>) {
        if self.seen.insert(Arc::as_ptr(texture) as usize) {
            self.texture(texture);
        }
    }

    fn texture(&mut self, texture: &Texture) {
        match texture {
            Texture::Layers(layers) => layers.iter().for_each(|l| self.layer(l)),
            Texture::Patterned(patterned) => {
                let name = match &patterned.kind {
                    PatternedKind::Blended => name(&patterned.signal),
                    PatternedKind::Average => "average".into(),
                    PatternedKind::Material(_) => "material_map".into(),
                    PatternedKind::Uv => "uv_mapping".into(),
                };
                *self.texture_patterns.entry(name).or_default() += 1;
                patterned.map.items().for_each(|t| self.texture(t));
            }
        }
    }

    fn layer(&mut self, layer: &Layer) {
        self.layers += 1;
        self.transparent_layers += usize::from(!layer.pigment.is_opaque());
        self.pigment(&layer.pigment);
        if let Some(normal) = &layer.normal {
            self.normal(normal);
        }
        self.finish(&layer.finish);
    }

    fn finish(&mut self, finish: &Finish) {
        let r = &finish.reflection;
        self.reflecting_layers += usize::from(r.min.max_element() > 0.0 || r.max.max_element() > 0.0);
        self.iridescent_layers += usize::from(finish.irid > 0.0);
        self.subsurface_layers += usize::from(finish.subsurface.is_some());
        self.highlight_layers += usize::from(finish.phong > 0.0 || finish.specular > 0.0);
    }

    pub fn pigment(&mut self, pigment: &Arc<Pigment>) {
        if !self.seen.insert(Arc::as_ptr(pigment) as usize) {
            return;
        }
        let name = match &pigment.kind {
            PigmentKind::Plain(_) => "plain".into(),
            PigmentKind::Patterned => name(&pigment.signal),
            PigmentKind::Average => "average".into(),
            PigmentKind::Image(_) => "image_map".into(),
            PigmentKind::Uv(_) => "uv_mapping".into(),
        };
        *self.pigments.entry(name).or_default() += 1;
        pigment.children().for_each(|p| self.pigment(p));
    }

    fn normal(&mut self, normal: &Arc<Normal>) {
        if !self.seen.insert(Arc::as_ptr(normal) as usize) {
            return;
        }
        let name = match &normal.kind {
            NormalKind::Flat => return,
            NormalKind::Patterned => name(&normal.signal),
            NormalKind::Average => "average".into(),
            NormalKind::Image(_) => "bump_map".into(),
            NormalKind::Uv(inner) => {
                self.normal(inner);
                "uv_mapping".into()
            }
        };
        *self.normals.entry(name).or_default() += 1;
        normal.map.iter().flat_map(|m| m.items()).for_each(|n| self.normal(n));
    }

    pub fn media(&mut self, media: &Media) {
        media.densities.iter().for_each(|density| self.pigment(density));
    }
}

/// A pattern's word in the scene language, as far as its type's name tells.
fn name(signal: &Signal) -> String {
    let mut word = String::new();
    for (i, c) in signal.pattern.name().char_indices() {
        if c.is_uppercase() && i > 0 {
            word.push('_');
        }
        word.extend(c.to_lowercase());
    }
    word
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interp::interpret_str;

    #[test]
    fn shared_things_count_once() {
        let text = "
            #version 3.7; global_settings { assumed_gamma 1 }
            #declare T = texture {
              pigment { checker pigment { rgb 1 }, pigment { bozo } }
              normal { bumps 0.3 }
              finish { reflection 0.2 phong 1 }
            }
            sphere { 0, 1 texture { T } }
            box { 2, 3 texture { T } }
            plane { y, -1 pigment { gradient x color_map { [0 rgbt 1] [1 rgb 0] } } }";
        let scene = interpret_str(text).scene.unwrap();
        let mut all = Ingredients::default();
        scene.objects.iter().flat_map(|o| &o.textures).for_each(|t| all.add_texture(&t.value));
        for pattern in ["checker", "bozo", "plain", "gradient"] {
            assert_eq!(all.pigments.get(pattern), Some(&1), "{pattern} in {:?}", all.pigments);
        }
        assert_eq!(all.normals.get("bumps"), Some(&1));
        assert_eq!((all.layers, all.reflecting_layers, all.highlight_layers), (2, 1, 1));
        assert_eq!(all.transparent_layers, 1);
    }
}
