use super::*;

#[test]
fn names_are_those_of_the_files() {
    let names: Vec<_> = ManifoldKind::ALL.iter().map(|k| k.name()).collect();
    assert_eq!(names, ["auto", "sutherland_hodgman", "clipper2"]);
}
