//! OpenEXR.

use super::{Decoded, Profile, Samples, area};
use exr::prelude::*;

pub(super) fn decode(bytes: &[u8]) -> std::result::Result<Decoded, String> {
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .from_buffered(std::io::Cursor::new(bytes))
        .map_err(|e| e.to_string())?;
    let layer = &image.layer_data;
    let (width, height) = (layer.size.0, layer.size.1);
    let count = area(width, height)?;
    let channel = |name: &str| layer.channel_data.list.iter().find(|c| c.name.eq_case_insensitive(name));
    let grey = channel("Y");
    let Some(colors) =
        ["R", "G", "B"].map(|name| channel(name).or(grey)).into_iter().collect::<Option<Vec<_>>>()
    else {
        return Err("the file has no colors".to_owned());
    };
    let alpha = channel("A");
    let mut data = Vec::with_capacity(4 * count);
    for i in 0..count {
        data.extend(colors.iter().map(|c| c.sample_data.value_by_flat_index(i).to_f32()));
        data.push(alpha.map_or(1.0, |a| a.sample_data.value_by_flat_index(i).to_f32()));
    }
    let samples = Samples::Floats { channels: 4, data, premultiplied: alpha.is_some(), dim: false };
    Ok(Decoded { width, height, samples, profile: Profile::Light })
}
