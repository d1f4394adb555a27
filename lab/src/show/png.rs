//! Pictures as PNG, the same on every machine: drawn by resvg, set in a font that comes with the lab.

use resvg::{tiny_skia, usvg};
use std::sync::Arc;

/// Draws a picture `scale` times as large as it says.
///
/// # Errors
/// What is wrong with the picture.
pub fn png(svg: &str, scale: f32) -> Result<Vec<u8>, String> {
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_font_data(epaint_default_fonts::UBUNTU_LIGHT.to_vec());
    let family = fonts.faces().next().and_then(|face| face.families.first().cloned()).map(|f| f.0);
    let family = family.ok_or("the font that comes with the lab does not load")?;
    fonts.set_sans_serif_family(&family);
    let options = usvg::Options { fontdb: Arc::new(fonts), font_family: family, ..usvg::Options::default() };
    let tree = usvg::Tree::from_str(svg, &options).map_err(|e| e.to_string())?;
    let size = tree.size();
    let (width, height) = ((size.width() * scale).ceil() as u32, (size.height() * scale).ceil() as u32);
    let mut pixels = tiny_skia::Pixmap::new(width, height).ok_or("the picture has no size")?;
    resvg::render(&tree, tiny_skia::Transform::from_scale(scale, scale), &mut pixels.as_mut());
    pixels.encode_png().map_err(|e| e.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::show::svg::{Anchor, INK, Svg};

    /// A text leaves ink, whatever fonts the machine has.
    #[test]
    fn text_is_drawn() {
        let picture = |text: &str| {
            let mut svg = Svg::new(60.0, 20.0, "");
            svg.text(2.0, 15.0, Anchor::Start, 14.0, INK, text);
            png(&svg.file(), 1.0).unwrap()
        };
        assert!(picture("merev ρ(τ)").len() > picture("").len() + 200);
        assert!(picture("").starts_with(b"\x89PNG"));
    }

    #[test]
    fn what_is_no_picture_is_an_error() {
        assert!(png("<svg", 1.0).is_err());
    }
}
