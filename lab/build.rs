//! Compiles the C programs of the main run against the library's header, and Box3D where peers are wanted.

use std::path::PathBuf;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    build_programs();
    if std::env::var_os("CARGO_FEATURE_PEERS").is_some() {
        build_box3d();
    }
    println!("cargo:rerun-if-changed=c/peer.h");
    if std::env::var_os("CARGO_FEATURE_ODE").is_some() {
        build_ode();
    }
    if std::env::var_os("CARGO_FEATURE_MUJOCO").is_some() {
        build_mujoco();
    }
    if std::env::var_os("CARGO_FEATURE_BULLET").is_some() {
        build_bullet();
    }
}

/// The shim of Bullet, which the system has installed.
fn build_bullet() {
    let package = Package::find("bullet", "Debian and its kin have it in the package libbullet-dev");
    println!("cargo:rerun-if-changed=c/bullet.cpp");
    let mut build = cc::Build::new();
    build.cpp(true).file("c/bullet.cpp").std("c++17").extra_warnings(true);
    // As Bullet's headers are the system's, their warnings are not ours.
    package.includes.iter().for_each(|folder| {
        build.flag("-isystem").flag(folder);
    });
    build.compile("lab_bullet");
    package.link();
}

/// The shim of MuJoCo. Its library is found at run time where it was found now.
fn build_mujoco() {
    println!("cargo:rerun-if-env-changed=MUJOCO_DIR");
    println!("cargo:rerun-if-changed=c/mujoco.c");
    let root = mujoco_root();
    let library = [root.clone(), root.join("lib")]
        .iter()
        .filter_map(|folder| std::fs::read_dir(folder).ok())
        .flat_map(|files| files.filter_map(|f| Some(f.ok()?.path())))
        .filter(|p| p.file_name().is_some_and(|n| n.to_string_lossy().starts_with("libmujoco.so")))
        .min();
    let library = library.unwrap_or_else(|| panic!("no libmujoco.so in {}: {MUJOCO_HINT}", root.display()));
    let mut build = cc::Build::new();
    build.file("c/mujoco.c").include(root.join("include")).std("c11").extra_warnings(true);
    build.compile("lab_mujoco");
    let folder = library.parent().expect("a folder");
    println!("cargo:rustc-link-arg={}", library.display());
    println!("cargo:rustc-link-arg=-Wl,-rpath,{}", folder.display());
}

const MUJOCO_HINT: &str = "`pip install mujoco` brings library and headers; MUJOCO_DIR names their folder if `python3` does not find them";

/// The folder of library and headers: MUJOCO_DIR, or where Python has its package.
fn mujoco_root() -> PathBuf {
    if let Some(root) = std::env::var_os("MUJOCO_DIR") {
        return root.into();
    }
    let ask = "import importlib.util as u; print(u.find_spec('mujoco').submodule_search_locations[0])";
    let output = std::process::Command::new("python3").args(["-c", ask]).output();
    let output = output.ok().filter(|o| o.status.success());
    let output = output.unwrap_or_else(|| panic!("MuJoCo is not found: {MUJOCO_HINT}"));
    String::from_utf8_lossy(&output.stdout).trim().into()
}

/// The shim of ODE, which the system has installed.
fn build_ode() {
    let package = Package::find("ode", "Debian and its kin have it in the package libode-dev");
    println!("cargo:rerun-if-changed=c/ode.c");
    let mut build = cc::Build::new();
    build.file("c/ode.c").includes(&package.includes).std("c11").extra_warnings(true).compile("lab_ode");
    package.link();
}

/// A library as pkg-config describes it.
struct Package {
    includes: Vec<PathBuf>,
    folders: Vec<String>,
    libraries: Vec<String>,
}

impl Package {
    fn find(name: &str, hint: &str) -> Self {
        let output = std::process::Command::new("pkg-config").args(["--cflags", "--libs", name]).output();
        let output = output.ok().filter(|o| o.status.success());
        let output = output.unwrap_or_else(|| panic!("pkg-config finds no library {name}: {hint}"));
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let flags = |flag: &str| -> Vec<String> {
            text.split_whitespace().filter_map(|w| w.strip_prefix(flag)).map(String::from).collect()
        };
        Self {
            includes: flags("-I").into_iter().map(PathBuf::from).collect(),
            folders: flags("-L"),
            libraries: flags("-l"),
        }
    }

    /// After the shim: it is what needs the library.
    fn link(&self) {
        self.folders.iter().for_each(|f| println!("cargo:rustc-link-search=native={f}"));
        self.libraries.iter().for_each(|l| println!("cargo:rustc-link-lib={l}"));
    }
}

/// The programs in `c`, against the library's header. They find the library itself in the merev crate.
fn build_programs() {
    let include = PathBuf::from("../include");
    for path in ["c/lab.h", "../include/merev.h"] {
        println!("cargo:rerun-if-changed={path}");
    }
    let mut build = cc::Build::new();
    for name in ["step", "bouncing_ball", "pyramid"] {
        let file = format!("c/{name}.c");
        println!("cargo:rerun-if-changed={file}");
        build.file(file);
    }
    if std::env::var_os("CARGO_FEATURE_F64").is_some() {
        build.define("MV_DOUBLE_PRECISION", None);
    }
    build.include(include).std("c99").extra_warnings(true).compile("lab_programs");
}

/// Box3D's C sources, as its own release build compiles them: -O3, without assertions, SIMD as it chooses.
/// The crate that carries the sources would compile them with assertions and -O2, which is unfair to Box3D.
fn build_box3d() {
    let root = crate_root("boxddd-sys").join("third-party/box3d");
    let sources = std::fs::read_dir(root.join("src")).expect("Box3D's sources");
    let mut sources: Vec<PathBuf> = sources
        .map(|entry| entry.expect("a directory entry").path())
        .filter(|path| path.extension().is_some_and(|e| e == "c"))
        .collect();
    sources.sort();
    let mut build = cc::Build::new();
    build.files(&sources).include(root.join("include")).include(root.join("src"));
    build.opt_level(3).define("NDEBUG", None).debug(false).warnings(false);
    build.flag_if_supported("-std=c17").flag_if_supported("-ffp-contract=off").flag_if_supported("-pthread");
    if std::env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "linux") {
        build.define("_POSIX_C_SOURCE", "199309L");
    }
    build.compile("box3d");
    if std::env::var_os("CARGO_CFG_UNIX").is_some() {
        println!("cargo:rustc-link-lib=m");
        println!("cargo:rustc-link-lib=pthread");
    }
}

/// Where Cargo has unpacked a dependency: it keeps the path to itself, but tells it when asked.
fn crate_root(name: &str) -> PathBuf {
    let cargo = std::env::var_os("CARGO").expect("CARGO");
    let output = std::process::Command::new(cargo)
        .args(["metadata", "--format-version=1", "--features=peers", "--filter-platform"])
        .arg(std::env::var("TARGET").expect("TARGET"))
        .output()
        .expect("cargo metadata");
    assert!(output.status.success(), "cargo metadata: {}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8_lossy(&output.stdout);
    let manifest = text
        .split("\"manifest_path\":\"")
        .skip(1)
        .filter_map(|rest| rest.split('"').next())
        .map(|path| PathBuf::from(path.replace("\\\\", "\\")))
        .find(|path| {
            let folder = path.parent().and_then(|p| p.file_name()).unwrap_or_default();
            folder.to_string_lossy().starts_with(&format!("{name}-"))
        });
    manifest
        .unwrap_or_else(|| panic!("{name} is not among the dependencies"))
        .parent()
        .expect("a folder")
        .into()
}
