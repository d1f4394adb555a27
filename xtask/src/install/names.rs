//! What the installed files are called, and the templates that name them.

/// The names of one precision. Both may be installed beside each other; they share the headers.
pub struct Names {
    /// "merev", or "merev_f64" in double precision.
    pub name: &'static str,
    pub double: bool,
    /// "0.1.0".
    pub version: String,
}

impl Names {
    pub fn new(double: bool, version: &str) -> Self {
        Self { name: if double { "merev_f64" } else { "merev" }, double, version: version.into() }
    }

    /// Major, minor and revision number.
    fn numbers(&self) -> Vec<&str> {
        self.version.split('.').collect()
    }

    /// The shared library itself.
    pub fn file(&self) -> String {
        format!("lib{}.so.{}", self.name, self.version)
    }

    /// What programs look for at run time: it changes with the binary interface, so before 1.0 with the minor number.
    pub fn soname(&self) -> String {
        match self.numbers()[..] {
            ["0", minor, ..] => format!("lib{}.so.0.{minor}", self.name),
            [major, ..] => format!("lib{}.so.{major}", self.name),
            [] => unreachable!("split gives at least one piece"),
        }
    }

    pub fn component(&self) -> &'static str {
        if self.double { "f64" } else { "f32" }
    }

    /// Fills a template. `up` leads from the file to the prefix.
    pub fn fill(&self, template: &str, libdir: &str, up: &str, system: &[&str], file: &str) -> String {
        let pc = file.ends_with(".pc.in");
        let define = match (self.double, pc) {
            (false, _) => "",
            (true, true) => " -DMV_DOUBLE_PRECISION",
            (true, false) => "MV_DOUBLE_PRECISION",
        };
        let system = match pc {
            true => system.iter().map(|l| format!("-l{l}")).collect::<Vec<_>>().join(" "),
            false => system.join(";"),
        };
        let numbers = self.numbers();
        [
            ("NAME", self.name),
            ("VERSION", &self.version),
            ("MAJOR", numbers[0]),
            ("MINOR", numbers[1]),
            ("FILE", &self.file()),
            ("SONAME", &self.soname()),
            ("COMPONENT", self.component()),
            ("PRECISION", if self.double { ", double precision" } else { "" }),
            ("LIBDIR", libdir),
            ("UP", up),
            ("DEFINE", define),
            ("SYSTEM_LIBS", &system),
        ]
        .iter()
        .fold(template.to_owned(), |text, (key, value)| text.replace(&format!("@{key}@"), value))
    }
}

/// What a program linked with the static library needs besides. It is what `rustc --print native-static-libs` says,
/// without libc and the unwinder: the C compiler adds those itself, the right ones for -static as well.
pub fn system_libraries(clipper2: bool) -> Vec<&'static str> {
    let runtime = clipper2.then_some("stdc++");
    runtime.into_iter().chain(["util", "rt", "pthread", "m", "dl"]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_soname_follows_the_binary_interface() {
        assert_eq!(Names::new(false, "0.1.7").soname(), "libmerev.so.0.1");
        assert_eq!(Names::new(false, "2.3.4").soname(), "libmerev.so.2");
        assert_eq!(Names::new(true, "0.1.7").soname(), "libmerev_f64.so.0.1");
        assert_eq!(Names::new(true, "0.1.7").file(), "libmerev_f64.so.0.1.7");
    }

    #[test]
    fn every_template_is_filled() {
        let cmake = crate::root().join("cmake");
        for entry in std::fs::read_dir(cmake).unwrap().map(|e| e.unwrap().path()) {
            let file = entry.file_name().unwrap().to_str().unwrap().to_owned();
            let text = std::fs::read_to_string(&entry).unwrap();
            for double in [false, true] {
                let names = Names::new(double, "0.1.0");
                let filled = names.fill(&text, "lib", "../..", &system_libraries(true), &file);
                assert!(!filled.contains('@'), "{file}: {filled}");
                if file == "merev.pc.in" {
                    assert_eq!(filled.contains("-DMV_DOUBLE_PRECISION"), double);
                    assert!(filled.contains("Libs.private: -lstdc++ -lutil"), "{filled}");
                    assert!(filled.contains("prefix=${pcfiledir}/../..\n"), "{filled}");
                }
            }
        }
    }
}
