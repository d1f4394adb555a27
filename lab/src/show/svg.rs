//! Pictures as SVG: a canvas that takes shapes and keeps them well formed.
//!
//! Colours stand in attributes, so that a picture is whole by itself; classes stand beside them, so that the page
//! can set others in the dark (a style sheet wins over attributes).

use std::fmt::Write;

/// The family that pictures are set in: what a reader has; PNGs take the font that comes with the lab.
pub const FONT: &str = "Ubuntu, 'DejaVu Sans', 'Segoe UI', Roboto, Helvetica, Arial, sans-serif";

pub const INK: &str = "#1d2125";
pub const FAINT: &str = "#6a7178";
pub const GRID: &str = "#d9dde1";

/// Where a text is held.
#[derive(Clone, Copy)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

/// A picture in the making; the origin is at the upper left, lengths are pixels.
pub struct Svg {
    pub width: f64,
    pub height: f64,
    /// What it shows, for those who do not see it.
    label: String,
    body: String,
}

impl Svg {
    pub fn new(width: f64, height: f64, label: &str) -> Self {
        Self { width, height, label: label.to_owned(), body: String::new() }
    }

    pub fn rect(&mut self, [x, y, w, h]: [f64; 4], fill: &str, class: &str) {
        let (x, y, w, h) = (num(x), num(y), num(w.max(0.0)), num(h.max(0.0)));
        let _ = writeln!(
            self.body,
            r#"<rect x="{x}" y="{y}" width="{w}" height="{h}" fill="{}"{}/>"#,
            escape(fill),
            of_class(class)
        );
    }

    pub fn line(&mut self, [x1, y1, x2, y2]: [f64; 4], stroke: &str, width: f64, dash: &str, class: &str) {
        let dash = if dash.is_empty() { String::new() } else { format!(r#" stroke-dasharray="{dash}""#) };
        let _ = writeln!(
            self.body,
            r#"<line x1="{}" y1="{}" x2="{}" y2="{}" stroke="{}" stroke-width="{width}"{dash}{}/>"#,
            num(x1),
            num(y1),
            num(x2),
            num(y2),
            escape(stroke),
            of_class(class)
        );
    }

    /// A path with attributes as they are given.
    pub fn path(&mut self, d: &str, attributes: &str) {
        let _ = writeln!(self.body, r#"<path d="{d}" {attributes}/>"#);
    }

    pub fn text(&mut self, x: f64, y: f64, anchor: Anchor, size: f64, fill: &str, text: &str) {
        self.text_of_class(x, y, anchor, size, fill, class_of(fill), text);
    }

    #[expect(clippy::too_many_arguments, reason = "each is an attribute of the element")]
    pub fn text_of_class(
        &mut self,
        x: f64,
        y: f64,
        anchor: Anchor,
        size: f64,
        fill: &str,
        class: &str,
        text: &str,
    ) {
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => r#" text-anchor="middle""#,
            Anchor::End => r#" text-anchor="end""#,
        };
        let _ = writeln!(
            self.body,
            r#"<text x="{}" y="{}" font-size="{size}" fill="{}"{anchor}{}>{}</text>"#,
            num(x),
            num(y),
            escape(fill),
            of_class(class),
            escape(text)
        );
    }

    /// A text that runs upwards, its middle at (x, y).
    pub fn upright_text(&mut self, x: f64, y: f64, size: f64, text: &str) {
        let (x, y) = (num(x), num(y));
        let _ = writeln!(
            self.body,
            r#"<text transform="translate({x} {y}) rotate(-90)" font-size="{size}" fill="{INK}" class="ink" text-anchor="middle">{}</text>"#,
            escape(text)
        );
    }

    /// Opens a group with attributes as they are given; [`Self::close`] ends it.
    pub fn open(&mut self, attributes: &str) {
        let _ = writeln!(self.body, "<g {attributes}>");
    }

    pub fn close(&mut self) {
        self.body += "</g>\n";
    }

    /// Puts another picture at (x, y).
    pub fn place(&mut self, x: f64, y: f64, other: &Self) {
        self.open(&format!(r#"transform="translate({} {})""#, num(x), num(y)));
        self.body += &other.body;
        self.close();
    }

    /// As part of a page.
    pub fn inline(&self) -> String {
        self.document("", "")
    }

    /// As a file of its own, on white.
    pub fn file(&self) -> String {
        self.document(r##"<rect width="100%" height="100%" fill="#ffffff"/>"##, "")
    }

    fn document(&self, before: &str, after: &str) -> String {
        let (w, h) = (num(self.width), num(self.height));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\" \
             font-family=\"{FONT}\" role=\"img\" aria-label=\"{}\">\n{before}{}{after}</svg>\n",
            escape(&self.label),
            self.body
        )
    }
}

/// The class that goes with one of the three greys.
pub fn class_of(fill: &str) -> &'static str {
    match fill {
        INK => "ink",
        FAINT => "faint",
        GRID => "grid",
        _ => "",
    }
}

fn of_class(class: &str) -> String {
    if class.is_empty() { String::new() } else { format!(r#" class="{}""#, escape(class)) }
}

/// A coordinate with a tenth of a pixel. Whatever is not a number must have been left out before.
pub fn num(x: f64) -> String {
    debug_assert!(x.is_finite(), "a coordinate is {x}");
    let text = format!("{:.1}", if x.is_finite() { x } else { 0.0 });
    let text = text.strip_suffix(".0").unwrap_or(&text);
    if text == "-0" { "0".into() } else { text.to_owned() }
}

/// A text as XML and HTML take it. Control characters, which XML does not have, are left out.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out += "&amp;",
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '"' => out += "&quot;",
            '\'' => out += "&#39;",
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// About how wide a text is set.
pub fn text_width(text: &str, size: f64) -> f64 {
    0.56 * size * text.chars().count() as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_well_formed_whatever_it_says() {
        let mut svg = Svg::new(100.0, 50.0, "a < b & \"c\"");
        svg.text(1.0, 2.0, Anchor::Middle, 10.0, INK, "x > 'y' & <z>\u{1}");
        svg.open(r#"class="a""#);
        svg.rect([0.0, 0.0, 3.0, -1.0], "#fff", "paper");
        svg.close();
        for text in [svg.inline(), svg.file()] {
            let tree = roxmltree::Document::parse(&text).unwrap();
            let said = tree.descendants().find(|n| n.has_tag_name("text")).and_then(|n| n.text());
            assert_eq!(said, Some("x > 'y' & <z> "));
        }
    }

    #[test]
    fn coordinates_are_short() {
        assert_eq!([num(1.04), num(-0.01), num(2.25)], ["1", "0", "2.2"]);
    }
}
