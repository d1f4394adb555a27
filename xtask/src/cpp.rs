//! bindings/cpp/merev.hpp, made from include/merev.h and bindings/cpp/merev.hpp.in.
//!
//! The template is written by hand and says where methods go: `// @methods mvBody` is replaced by a method for each
//! function mvBody_... that the template does not mention. Only what needs a C++ form of its own is in the template, so a
//! new C function is a method without further work.

use crate::{Outcome, root};
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

fn path() -> PathBuf {
    root().join("bindings/cpp/merev.hpp")
}

/// Writes the C++ header.
#[cfg_attr(not(feature = "header"), allow(dead_code))]
pub fn write() -> Outcome {
    Ok(fs::write(path(), generate()?)?)
}

/// Fails unless the committed C++ header is what C header and template give.
#[cfg_attr(not(feature = "header"), allow(dead_code))]
pub fn check() -> Outcome {
    match fs::read_to_string(path())? == generate()? {
        true => Ok(()),
        false => Err("bindings/cpp/merev.hpp is stale: run `cargo xtask header`".into()),
    }
}

fn generate() -> Outcome<String> {
    let header = fs::read_to_string(root().join("include/merev.h"))?;
    let template = fs::read_to_string(root().join("bindings/cpp/merev.hpp.in"))?;
    fill(&template, &header)
}

/// A function of the C header.
struct Function {
    /// The first sentence of its documentation.
    doc: String,
    returns: String,
    name: String,
    /// Type and name of each parameter.
    parameters: Vec<(String, String)>,
}

fn functions(header: &str) -> Outcome<Vec<Function>> {
    let mut found = Vec::new();
    let mut before = "";
    for piece in header.split("\nMV_API").collect::<Vec<_>>() {
        if found.is_empty() && before.is_empty() {
            before = piece;
            continue;
        }
        let (declaration, _) = piece.split_once(';').ok_or("a declaration without an end")?;
        found.push(function(declaration, before).ok_or_else(|| format!("cannot read: {declaration}"))?);
        before = piece;
    }
    Ok(found)
}

fn function(declaration: &str, before: &str) -> Option<Function> {
    let (head, parameters) = declaration.trim().trim_end_matches(')').split_once('(')?;
    let split = |text: &str| {
        let at = text.rfind([' ', '*'])? + 1;
        Some((text[..at].trim().replace(" *", "*"), text[at..].to_owned()))
    };
    let (returns, name) = split(head)?;
    let parameters = parameters
        .split(',')
        .map(|p| p.split_whitespace().collect::<Vec<_>>().join(" "))
        .filter(|p| p != "void")
        .map(|p| split(&p))
        .collect::<Option<_>>()?;
    let comment = before.rsplit_once("/**")?.1.split("*/").next()?;
    let lines = comment.lines().map(|l| l.trim().trim_start_matches('*').trim());
    let paragraph: Vec<&str> =
        lines.skip_while(|l| l.is_empty()).take_while(|l| !l.is_empty() && !l.starts_with('@')).collect();
    let text = paragraph.join(" ");
    let doc = text.split_inclusive(". ").next().unwrap_or_default().trim().to_owned();
    Some(Function { doc, returns, name, parameters })
}

/// Replaces the marks of the template.
fn fill(template: &str, header: &str) -> Outcome<String> {
    let all = functions(header)?;
    let mut aliases: BTreeMap<&str, &str> = template
        .lines()
        .filter_map(|l| l.trim().strip_prefix("using ")?.strip_suffix(';')?.split_once(" = "))
        .filter(|(_, c)| c.starts_with("mv"))
        .map(|(alias, c)| (c, alias))
        .collect();
    aliases.extend([
        ("mvBodyId", "Body"),
        ("mvShapeId", "Shape"),
        ("mvJointId", "Joint"),
        ("mvWorldId", "WorldRef"),
    ]);
    let joints: Vec<&str> = all
        .iter()
        .filter_map(|f| f.name.strip_prefix("mvCreate"))
        .filter(|kind| kind.ends_with("Joint") && all.iter().any(|f| f.name == format!("mvDefault{kind}Def")))
        .collect();

    // What the template's code calls; its comments only talk about it.
    let by_hand: String = template.lines().filter(|l| !l.trim().starts_with("//")).collect();
    let methods = |class: &str, indent: &str| -> String {
        let prefix = format!("{class}_");
        let own = all.iter().filter(|f| f.name.starts_with(&prefix));
        // What takes no id of the class, as the bulk calls, stays a C function.
        let own = own
            .filter(|f| f.parameters.first().is_some_and(|(t, _)| t.starts_with("mv") && t.ends_with("Id")));
        own.filter(|f| !by_hand.contains(&format!("{}(", f.name)))
            .map(|f| method(f, &f.name[prefix.len()..], &aliases, indent))
            .collect()
    };
    let mut out = String::with_capacity(header.len());
    for line in template.split_inclusive('\n') {
        match line.trim().strip_prefix("// @") {
            None => out += line,
            Some("joint-defs") => {
                for kind in &joints {
                    out += &format!("using {kind}Def = Def<mv{kind}Def, mvDefault{kind}Def>;\n");
                }
            }
            Some("joint-classes") => {
                for kind in &joints {
                    let own = methods(&format!("mv{kind}"), "    ");
                    let gap = if own.is_empty() { "" } else { "\n" };
                    out += &format!(
                        "class {kind} : public Joint {{\npublic:\n    using Joint::Joint;\n{gap}{own}}};\n\n"
                    );
                }
            }
            Some("create-joints") => {
                for kind in &joints {
                    out += &format!("    {kind} create{kind}(const {kind}Def& def) const noexcept {{\n");
                    out += &format!("        return mvCreate{kind}(id(), &def);\n    }}\n");
                }
            }
            Some(mark) => match mark.strip_prefix("methods ") {
                Some(class) => out += &methods(class, "    "),
                None => return Err(format!("merev.hpp.in: no mark called {mark}").into()),
            },
        }
    }
    Ok(out)
}

/// A method that calls the function with its own id.
fn method(f: &Function, verb: &str, aliases: &BTreeMap<&str, &str>, indent: &str) -> String {
    let plain = |c: &str| {
        let (constant, name) = c.strip_prefix("const ").map_or(("", c), |rest| ("const ", rest));
        let (name, stars) = name.split_at(name.find('*').unwrap_or(name.len()));
        format!("{constant}{}{stars}", aliases.get(name).copied().unwrap_or(name))
    };
    let (mut parameters, mut arguments) = (Vec::new(), vec!["id()".to_owned()]);
    let mut rest = f.parameters[1..].iter().peekable();
    while let Some((c, name)) = rest.next() {
        let counted =
            c.ends_with('*') && rest.peek().is_some_and(|(_, next)| next == "capacity" || next == "count");
        if counted {
            rest.next();
            // Arrays hold C ids, not handles.
            let element = c.trim_end_matches('*');
            let element = if element.ends_with("Id") { element.to_owned() } else { plain(element) };
            parameters.push(format!("Span<{element}> {name}"));
            arguments.extend([format!("{name}.data()"), format!("{name}.size()")]);
        } else if c.starts_with("const mv") && c.ends_with('*') {
            parameters.push(format!("{}& {name}", plain(c.trim_end_matches('*'))));
            arguments.push(format!("&{name}"));
        } else if c.ends_with("Id*") {
            parameters.push(format!("{c} {name}"));
            arguments.push(name.clone());
        } else {
            parameters.push(format!("{} {name}", plain(c)));
            arguments.push(name.clone());
        }
    }
    let verb = verb[..1].to_lowercase() + &verb[1..];
    let result = if f.returns == "void" { "" } else { "return " };
    let head = format!("{} {verb}({}) const noexcept", plain(&f.returns), parameters.join(", "));
    let call = format!("{result}{}({});", f.name, arguments.join(", "));
    let one = format!("{indent}{head} {{ {call} }}\n");
    let doc = format!("{indent}/// {}\n", f.doc);
    match one.len() <= 121 {
        true => doc + &one,
        false => {
            let head = wrapped(&format!("{indent}{head} {{"), &format!("{indent}        "));
            format!(
                "{doc}{head}\n{}\n{indent}}}\n",
                wrapped(&format!("{indent}    {call}"), &format!("{indent}        "))
            )
        }
    }
}

/// Breaks a line after commas where it would be longer than the others.
fn wrapped(line: &str, indent: &str) -> String {
    let (mut out, mut column) = (String::new(), 0);
    for piece in line.split_inclusive(", ") {
        if column > 0 && column + piece.trim_end().len() > 120 {
            out.truncate(out.trim_end().len());
            out += &format!("\n{indent}");
            column = indent.len();
        }
        out += piece;
        column += piece.len();
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "\n/**\n * Get it. At once.\n *\n * @return it\n */\nMV_API mvVec3 mvBody_GetIt(mvBodyId bodyId);\n\
        \n/**\n * List them.\n */\nMV_API\nint mvBody_List(mvBodyId bodyId, const mvSphere *at,\n   mvShapeId *ids, int capacity);\n\
        /**\n * Odd.\n */\nMV_API void mvBody_Odd(mvBodyId bodyId);\n";

    #[test]
    fn functions_become_methods() {
        let template = "// mvBody_GetIt(body) is body.getIt()\nusing Vec3 = mvVec3;\n    // @methods mvBody\nvoid odd() { mvBody_Odd(id()); }\n";
        let expected = "// mvBody_GetIt(body) is body.getIt()\nusing Vec3 = mvVec3;\n    /// Get it.\n    Vec3 getIt() const noexcept { return mvBody_GetIt(id()); }\n    \
            /// List them.\n    int list(const mvSphere& at, Span<mvShapeId> ids) const noexcept { \
            return mvBody_List(id(), &at, ids.data(), ids.size()); }\nvoid odd() { mvBody_Odd(id()); }\n";
        // The long one breaks its line.
        let filled = fill(template, HEADER)
            .unwrap()
            .replace("{\n        return", "{ return")
            .replace(";\n    }", "; }");
        assert_eq!(filled, expected);
    }

    #[test]
    fn unknown_marks_are_refused() {
        assert!(fill("// @nothing\n", HEADER).is_err());
    }

    /// Every function that belongs to an object can be called from C++, as a method or by hand.
    #[test]
    fn nothing_is_left_out() {
        let header = fs::read_to_string(root().join("include/merev.h")).unwrap();
        let cpp = generate().unwrap();
        let all = functions(&header).unwrap();
        assert!(all.len() > 400);
        let objects = all.iter().filter(|f| f.name.contains('_') && f.name != "mvBody_SetTransforms");
        // The human is a struct of ids, used as in C.
        let missing: Vec<&str> = objects
            .map(|f| f.name.as_str())
            .filter(|n| !n.starts_with("mvHuman_") && !cpp.contains(&format!("{n}(")))
            .collect();
        assert_eq!(missing, ["mvContact_IsValid"]);
    }
}
