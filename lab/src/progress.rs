//! A progress bar, shown on terminals only.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar of `length` units with a label.
pub fn bar(length: u64, label: &str) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg:<22} {bar:40} {percent:>3} %  {elapsed_precise}");
    let bar = ProgressBar::new(length).with_style(style.expect("a valid template"));
    bar.set_message(label.to_string());
    bar
}
