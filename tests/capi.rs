//! The C library, seen from C and C++: programs in tests/capi, tests/cpp, examples-c and bindings, built by the system's
//! compiler against the library and headers of this very build.
//!
//! `MEREV_RUNNER`, e.g. "valgrind -q --error-exitcode=9", runs the programs under that tool.
#![cfg(target_os = "linux")]

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Where cargo put the libraries that belong to this test.
fn library_dir() -> PathBuf {
    let dir = std::env::current_exe().unwrap().parent().unwrap().to_owned();
    assert!(dir.join("libmerev.so").exists(), "no libmerev.so in {}", dir.display());
    dir
}

fn out_dir() -> PathBuf {
    let dir = Path::new(env!("CARGO_TARGET_TMPDIR")).join("capi");
    std::fs::create_dir_all(&dir).unwrap();
    dir
}

/// The compiler, told to accept nothing but this standard and to dislike everything.
fn compiler(standard: &str) -> Command {
    let target = format!("{}-unknown-linux-gnu", std::env::consts::ARCH);
    let mut command = cc::Build::new()
        .cpp(standard.starts_with("c++"))
        .cargo_metadata(false)
        .target(&target)
        .host(&target)
        .out_dir(out_dir())
        .opt_level(1)
        .debug(true)
        .get_compiler()
        .to_command();
    command.arg(format!("-std={standard}")).args(["-Wall", "-Wextra", "-Wpedantic", "-Werror"]);
    command.arg("-I").arg(root().join("include"));
    if standard.starts_with("c++") {
        command.arg("-I").arg(root().join("bindings/cpp")).args(["-fno-exceptions", "-fno-rtti"]);
    }
    if cfg!(feature = "f64") {
        command.arg("-DMV_DOUBLE_PRECISION");
    }
    command
}

fn succeed(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|e| panic!("{command:?}: {e}"));
    let text =
        format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{command:?}: {}\n{text}", output.status);
    text
}

fn sources(dir: &str) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = std::fs::read_dir(root().join(dir))
        .unwrap()
        .map(|f| f.unwrap().path())
        .filter(|p| p.extension().is_some_and(|e| e == "c" || e == "cpp"))
        .collect();
    files.sort();
    assert!(!files.is_empty());
    files
}

/// What the preprocessor makes of a source, without what it includes from elsewhere: calls that macros make count.
fn preprocessed(source: &Path) -> String {
    let output = succeed(compiler("c99").arg("-E").arg(source));
    let (mut own, mut text) = (false, String::new());
    for line in output.lines() {
        // A marker, # 12 "file" flags, says where the lines after it come from.
        if let Some(file) = line.strip_prefix("# ").and_then(|rest| rest.split('"').nth(1)) {
            own = Path::new(file).starts_with(root().join("tests/capi"));
        } else if own {
            text += line;
            text.push('\n');
        }
    }
    text
}

/// Builds a program, shared or static.
fn build(source: &Path, shared: bool) -> PathBuf {
    let kind = if shared { "shared" } else { "static" };
    let program = out_dir().join(format!("{}-{kind}", source.file_name().unwrap().to_str().unwrap()));
    let mut command = compiler(if source.extension().is_some_and(|e| e == "cpp") { "c++17" } else { "c99" });
    command.arg(source).arg("-o").arg(&program).arg("-pthread");
    if shared {
        command.arg("-L").arg(library_dir()).arg("-lmerev").arg("-lm");
        command.arg(format!("-Wl,-rpath,{}", library_dir().display()));
    } else {
        command.arg(library_dir().join("libmerev.a")).args(["-lm", "-ldl"]);
        // Clipper2, a part of the library, is C++.
        if cfg!(feature = "clipper2") {
            command.arg("-lstdc++");
        }
    }
    succeed(&mut command);
    program
}

/// Runs a program; says what was wrong, if anything.
fn run(program: &Path) -> Option<String> {
    output(program).err()
}

/// What a program prints, or what was wrong.
fn output(program: &Path) -> Result<String, String> {
    let runner = std::env::var("MEREV_RUNNER").unwrap_or_default();
    let mut words = runner.split_whitespace();
    let mut command = match words.next() {
        Some(tool) => {
            let mut command = Command::new(tool);
            command.args(words).arg(program);
            command
        }
        None => Command::new(program),
    };
    // Cargo's own search path knows older libraries of the same name.
    let output = command.env("LD_LIBRARY_PATH", library_dir()).output().unwrap();
    let text =
        format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    print!("{text}");
    match output.status.success() {
        true => Ok(text),
        false => Err(format!("{}: {}\n{text}", program.display(), output.status)),
    }
}

#[test]
fn the_c_tests_pass() {
    let wrong: Vec<String> = sources("tests/capi").iter().filter_map(|s| run(&build(s, true))).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_examples_pass_shared_and_static() {
    for source in sources("examples-c") {
        for shared in [true, false] {
            assert_eq!(run(&build(&source, shared)), None);
        }
        let lines = std::fs::read_to_string(&source).unwrap().lines().count();
        assert!(lines < 120, "{} has {lines} lines", source.display());
    }
}

#[test]
fn the_cpp_tests_pass() {
    let hello = root().join("bindings/cpp/hello.cpp");
    let wrong: Vec<String> =
        sources("tests/cpp").iter().chain([&hello]).filter_map(|s| run(&build(s, true))).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The C++ header, by every compiler that is there.
#[test]
fn the_cpp_header_is_clean() {
    let source = root().join("tests/cpp/world.cpp");
    for standard in ["c++17", "c++20"] {
        for precision in ["-DMV_DOUBLE_PRECISION", "-UMV_DOUBLE_PRECISION"] {
            let own = compiler(standard);
            let clang = Command::new("clang++").arg("--version").output().is_ok().then(|| {
                let mut clang = Command::new("clang++");
                clang.args(own.get_args().filter(|a| a.to_str().is_some_and(|a| !a.starts_with("--target"))));
                clang
            });
            for mut command in [own].into_iter().chain(clang) {
                command.arg(precision).arg("-Wconversion").arg("-fsyntax-only").arg(&source);
                assert_eq!(succeed(&mut command), "");
            }
        }
    }
}

/// A method is the C function and nothing else.
#[test]
fn a_method_is_the_same_machine_code() {
    let instructions = |extension: &str, standard: &str, text: &str| -> Vec<String> {
        let source = out_dir().join(format!("getter.{extension}"));
        std::fs::write(&source, text).unwrap();
        let mut command = compiler(standard);
        let listing = succeed(command.args(["-O2", "-g0", "-S", "-o", "-"]).arg(&source));
        let code = listing.lines().map(str::trim).filter(|l| !l.is_empty() && !l.starts_with(['.', '#']));
        code.map(|l| l.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
    };
    let c = instructions(
        "c",
        "c99",
        "#include \"merev.h\"\nmvVec3 velocity(mvBodyId b);\nmvFloat angle(mvJointId j);\n\
         mvVec3 velocity(mvBodyId b) { return mvBody_GetLinearVelocity(b); }\n\
         mvFloat angle(mvJointId j) { return mvRevoluteJoint_GetAngle(j); }\n",
    );
    let cpp = instructions(
        "cpp",
        "c++17",
        "#include \"merev.hpp\"\nextern \"C\" {\n\
         mvVec3 velocity(merev::Body b) { return b.getLinearVelocity(); }\n\
         mvFloat angle(merev::RevoluteJoint j) { return j.getAngle(); }\n}\n",
    );
    assert!(c.iter().any(|l| l.contains("mvBody_GetLinearVelocity")), "{c:?}");
    assert_eq!(c, cpp);
}

/// One scene (bindings/README.md) gives one hash in C and in C++, shared and static, in every profile.
#[test]
fn the_same_hash_in_every_language() {
    let programs = sources("bindings/same_hash");
    assert_eq!(programs.len(), 2);
    let hashes: Vec<String> = programs
        .iter()
        .flat_map(|source| [true, false].map(|shared| output(&build(source, shared)).unwrap()))
        .collect();
    assert!(hashes.iter().all(|hash| *hash == hashes[0]), "{hashes:?}");
    let known = std::fs::read_to_string(root().join("bindings/same_hash/golden.txt")).unwrap();
    let mine = if cfg!(feature = "f64") { "f64 " } else { "f32 " };
    let golden = known.lines().find_map(|line| line.strip_prefix(mine)).unwrap();
    assert_eq!(hashes[0].trim(), golden);
}

/// The header alone, as C and as C++, in both precisions.
#[test]
fn the_header_is_clean() {
    let include = "#include \"merev.h\"\nint main(void) { return mvDot(mvVec3_one, mvVec3_axisX) < 0; }\n";
    for (extension, standards) in [("c", ["c99", "c11"]), ("cpp", ["c++11", "c++17"])] {
        let source = out_dir().join(format!("only_header.{extension}"));
        std::fs::write(&source, include).unwrap();
        for standard in standards {
            for precision in ["-DMV_DOUBLE_PRECISION", "-UMV_DOUBLE_PRECISION"] {
                let mut command = compiler(standard);
                command.arg(precision).arg("-Wconversion").arg("-fsyntax-only").arg(&source);
                assert_eq!(succeed(&mut command), "");
            }
        }
    }
}

#[test]
fn the_header_is_fresh() {
    succeed(
        Command::new(env!("CARGO"))
            .args(["run", "-q", "-p", "xtask", "--", "header", "--check"])
            .current_dir(root()),
    );
}

/// What the header declares and defines: the library's functions and the inline ones.
fn declared() -> (BTreeSet<String>, BTreeSet<String>) {
    let text = std::fs::read_to_string(root().join("include/merev.h")).unwrap();
    let names = |marker: &str| {
        let pieces = text.split(marker).skip(1).filter(|p| p.starts_with([' ', '\n']));
        let head = |p: &str| p.split('(').next().unwrap().to_owned();
        pieces
            .map(head)
            .filter_map(|h| h.split_whitespace().last().map(|w| w.trim_start_matches('*').to_owned()))
            .filter(|n| n.starts_with("mv"))
            .collect()
    };
    (names("MV_API"), names("MV_INLINE"))
}

#[test]
fn exported_symbols_are_the_declared_functions() {
    let library = library_dir().join("libmerev.so");
    let listing = succeed(Command::new("nm").args(["-D", "--defined-only"]).arg(library));
    let exported: BTreeSet<String> =
        listing.lines().filter_map(|l| l.split_whitespace().last()).map(str::to_owned).collect();
    let (api, _) = declared();
    assert!(api.len() > 200, "the header was read: {}", api.len());
    assert_eq!(exported.symmetric_difference(&api).collect::<Vec<_>>(), Vec::<&String>::new());
}

/// Every function of the header, inline ones too, is called by a C test.
#[test]
fn every_function_is_called() {
    let mut text = String::new();
    for source in sources("tests/capi") {
        text += &preprocessed(&source);
    }
    let (api, inline) = declared();
    let called = |name: &&String| text.contains(&format!("{name}("));
    let missing: Vec<_> = api.union(&inline).filter(|n| !called(n)).collect();
    assert!(missing.is_empty(), "never called: {missing:?}");
}
