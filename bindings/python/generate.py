"""Writes two files from include/merev.h.

merev_cffi.h: the declarations without directives, comments and inline functions, as cffi reads them.
python/merev/_generated.py: enumerations, records and, for every function that takes one object and plain values, a
property or a method with the header's words.

    python generate.py            write them
    python generate.py --check    fail unless they are what the header gives
"""

import re
import sys
import textwrap
from pathlib import Path

HERE = Path(__file__).resolve().parent
HEADER = HERE / "../../include/merev.h"
CLASSES = HERE / "python/merev/_generated.py"
DECLARATIONS = HERE / "merev_cffi.h"

# C enumerations: the constants that begin with this, and what is cut off at the end.
ENUMS = {
    "BodyType": ("mv_", "Body"),
    "ShapeType": ("mv_", "Shape"),
    "JointType": ("mv_", "Joint"),
    "AxisMode": ("mv_axis", ""),
    "SolverKind": ("mv_solver_", ""),
    "IntegratorKind": ("mv_integrator_", ""),
    "BroadPhaseKind": ("mv_broadPhase_", ""),
    "NarrowPhaseKind": ("mv_narrowPhase_", ""),
    "GjkKind": ("mv_gjk_", ""),
    "ManifoldKind": ("mv_manifold_", ""),
}

# Structures of plain values that become dataclasses.
RECORDS = [
    "Filter",
    "SurfaceMaterial",
    "MotionLocks",
    "ContactTuning",
    "MassData",
    "Sphere",
    "Capsule",
    "Plane",
    "SixDofAxis",
    "Profile",
    "Counters",
    "StepReport",
]

PLAIN = {
    "mvFloat": "float",
    "float": "float",
    "double": "float",
    "int": "int",
    "int32_t": "int",
    "int64_t": "int",
    "uint32_t": "int",
    "uint64_t": "int",
    "bool": "bool",
    "mvVec3": "Vector",
    "mvPos": "Vector",
    "mvQuat": "Quaternion",
    "mvTransform": "Transform",
    "mvWorldTransform": "Transform",
    "mvAABB": "Bounds",
    "mvMatrix3": "Matrix",
}

# Families of functions: prefix in C, the name of the first parameter, class.
FAMILIES = [
    ("World", "worldId", "WorldFunctions"),
    ("Body", "bodyId", "BodyFunctions"),
    ("Shape", "shapeId", "ShapeFunctions"),
    ("Joint", "jointId", "JointFunctions"),
] + [
    (kind + "Joint", "jointId", kind + "JointFunctions")
    for kind in "Distance Filter Gear Motor Parallel Prismatic Pulley RackPinion Revolute Screw SixDof Spherical "
    "Universal Weld Wheel".split()
]

# These have other forms in Python.
BY_HAND = {
    "mvWorld_Step",
    "mvWorld_IsValid",
    "mvBody_IsValid",
    "mvShape_IsValid",
    "mvJoint_IsValid",
    "mvBody_SetTransform",
    "mvBody_SetTargetTransform",
}

DEFAULTS = {"wake": "True", "updateBodyMass": "True", "wakeAttached": "True", "invokeContacts": "True"}


def snake(name):
    name = re.sub(r"AABB", "Aabb", name)
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


def words(comment):
    """The sentences of a comment, and what it says of parameters and of the result."""
    lines = [line.strip().lstrip("*").strip() for line in comment.strip().splitlines()]
    text, tags, current = [], [], None
    for line in lines:
        tag = re.match(r"@(param|return|note)\s*(.*)", line)
        if tag:
            current = [tag[1], tag[2]]
            tags.append(current)
        elif current is not None:
            current[1] += " " + line
        else:
            text.append(line)
    result = next((rest.strip() for kind, rest in tags if kind == "return"), "")
    parameters = dict(rest.split(" ", 1) for kind, rest in tags if kind == "param" and " " in rest)
    return " ".join(text).strip(), parameters, result


def doc(text, indent):
    text = text.replace("\\", "\\\\")
    text = re.sub(r"\bmv_(\w+?)(Body|Joint|Shape)\b", r"\1", text)
    text = re.sub(r"\bmv_[a-z]\w+_(\w+)\b", lambda m: snake(m[1]).upper(), text)
    text = re.sub(r"; (0|zero|false|null|nothing|none|a zero|the zero)[^;.]*\b(bad|another)\b[^;.]*(?=[;.]|$)", "", text)
    if text and not text.endswith((".", "?")):
        text += "."
    wrapped = textwrap.wrap(text, 110 - indent)
    pad = " " * indent
    if len(wrapped) == 1 and len(wrapped[0]) < 100 - indent:
        return f'{pad}"""{wrapped[0]}"""\n'
    return pad + '"""' + f"\n{pad}".join(wrapped) + f"\n{pad}" + '"""\n'


class Header:
    def __init__(self, text):
        end = text.index('}  // extern "C"')
        self.text = text[:end]
        self.constants = re.findall(r"/\*\*((?:(?!\*/).)*)\*/\n#define (mv_\w+) (\d+)", self.text, re.S)
        self.structs = {}
        for comment, name, body in re.findall(
            r"/\*\*((?:(?!\*/).)*)\*/\ntypedef struct mv(\w+) \{\n(.*?)\n\} mv\2;", self.text, re.S
        ):
            fields = re.findall(r"/\*\*((?:(?!\*/).)*)\*/\s*(\w+) (\w+)((?:\[\d+\])?);", body, re.S)
            self.structs[name] = (comment, fields)
        self.functions = []
        for comment, result, name, parameters in re.findall(
            r"/\*\*((?:(?!\*/).)*)\*/\nMV_API\s+([\w \*]+?)\s*\b(mv\w+)\(([^)]*)\);", self.text, re.S
        ):
            parameters = [] if parameters == "void" else [" ".join(p.split()) for p in parameters.split(",")]
            self.functions.append((comment, result.strip(), name, parameters))


class Writer:
    def __init__(self, header):
        self.header = header
        self.enums = {"mv" + name for name in ENUMS}
        self.records = {"mv" + name for name in RECORDS}
        self.out = []

    def type_of(self, c):
        if c in PLAIN:
            return PLAIN[c]
        if c in self.enums or c in self.records:
            return c[2:]
        return None

    def from_c(self, c, value):
        plain = PLAIN.get(c)
        if c in ("mvVec3", "mvPos"):
            return f"_vector({value})"
        if plain in ("Quaternion", "Transform", "Bounds", "Matrix"):
            return f"_{plain.lower()}({value})"
        if c in self.enums:
            return f"{c[2:]}({value})"
        if c in self.records:
            return f"{c[2:]}._from_c({value})"
        return value

    def to_c(self, c, value):
        plain = PLAIN.get(c)
        if c in ("mvVec3", "mvPos"):
            return f"_c_vector({value})"
        if plain in ("Quaternion", "Transform", "Bounds"):
            return f"_c_{plain.lower()}({value})"
        if c in self.enums:
            return f"_choice({c[2:]}, {value})"
        if c in self.records:
            return f"{value}._to_c()"
        if plain == "float":
            return f"float({value})"
        if plain == "bool":
            return f"bool({value})"
        return value

    def accepted(self, c):
        """The type of a parameter: wider than that of a result."""
        plain = self.type_of(c)
        wide = {"Vector": "VectorLike", "Quaternion": "QuaternionLike", "Transform": "TransformLike", "Bounds": "BoundsLike"}
        if c in self.enums:
            return f"Union[{plain}, int, str]"
        return wide.get(plain, plain)

    def write(self):
        self.out.append('"""Generated by generate.py from include/merev.h; do not edit."""\n\n')
        self.out.append("from __future__ import annotations\n\nimport enum\nfrom dataclasses import dataclass\n")
        self.out.append("from typing import Any, Union\n\n")
        self.out.append("import numpy as np\n\n")
        self.out.append("from ._library import call as _call\nfrom ._library import lib as _lib\n")
        self.out.append("from ._values import (\n    Bounds,\n    BoundsLike,\n    Matrix,\n    Quaternion,\n    QuaternionLike,\n")
        self.out.append("    Transform,\n    TransformLike,\n    Vector,\n    VectorLike,\n    _bounds,\n    _c_bounds,\n")
        self.out.append("    _c_quaternion,\n    _c_transform,\n    _c_vector,\n    _choice,\n    _matrix,\n    _quaternion,\n")
        self.out.append("    _transform,\n    _vector,\n)\n")
        for name in ENUMS:
            self.write_enum(name)
        for name in RECORDS:
            self.write_record(name)
        for family in FAMILIES:
            self.write_family(*family)
        return "".join(self.out)

    def write_enum(self, name):
        prefix, suffix = ENUMS[name]
        found = [(c, n, v) for c, n, v in self.header.constants if n.startswith(prefix) and n.endswith(suffix)]
        typedef = re.search(r"/\*\*((?:(?!\*/).)*)\*/\ntypedef int32_t mv%s;" % name, self.header.text, re.S)
        about = words(typedef[1])[0].split(":")[0] if typedef else name
        self.out.append(f"\n\nclass {name}(enum.IntEnum):\n{doc(about, 4)}\n")
        for comment, constant, value in found:
            short = constant[len(prefix) : len(constant) - len(suffix)]
            if not short or (suffix == "" and name == "AxisMode" and "_" in short):
                continue
            self.out.append(f"    {snake(short).upper()} = {value}\n{doc(words(comment)[0], 4)}")

    def write_record(self, name):
        comment, fields = self.header.structs[name]
        self.out.append(f"\n\n@dataclass\nclass {name}:\n{doc(words(comment)[0], 4)}\n")
        reads, writes, known = [], [], []
        for about, c, field, array in fields:
            if field == "padding":
                continue
            short = snake(field)
            kind = "Vector" if array else self.type_of(c)
            known.append((short, kind, about))
            read = f"_vector_of(c.{field})" if array else self.from_c(c, f"c.{field}")
            reads.append(f"            {short}={read},\n")
            writes.append(f'            "{field}": {self.to_c(c, "self." + short)},\n')
        for short, kind, about in known:
            self.out.append(f"    {short}: {kind}\n{doc(words(about)[0], 4)}")
        self.out.append("\n    @classmethod\n")
        self.out.append(f"    def _from_c(cls, c: Any) -> {name}:\n        return cls(\n{''.join(reads)}        )\n")
        if not any(array for *_, array in fields) and name not in ("Profile", "Counters", "MassData"):
            self.out.append(f"\n    def _to_c(self) -> Any:\n        return {{\n{''.join(writes)}        }}\n")
        elif name == "MassData":
            self.out.append(
                "\n    def _to_c(self) -> Any:\n        inertia = np.asarray(self.inertia, dtype=float)\n        return {\n"
                '            "mass": float(self.mass),\n            "center": _c_vector(self.center),\n'
                '            "inertia": tuple(_c_vector(inertia[:, k]) for k in range(3)),\n        }\n'
            )

    def write_family(self, prefix, first, cls):
        functions = {}
        for comment, result, name, parameters in self.header.functions:
            if name.startswith(f"mv{prefix}_") and name not in BY_HAND and parameters:
                head = parameters[0].split()
                rest = [p.rsplit(" ", 1) for p in parameters[1:]]
                plain = all(self.type_of(t) and self.accepted(t) != "Matrix" and "*" not in p for t, p in rest)
                if head[-1] in (first, "id") and plain and (result == "void" or self.type_of(result)):
                    functions[name.split("_", 1)[1]] = (comment, result, name, rest)
        self.out.append(f"\n\nclass {cls}:\n    _id: Any\n")
        done = set()
        for verb, (comment, result, name, rest) in functions.items():
            if verb in done:
                continue
            text, parameters, returned = words(comment)
            if result != "void" and not rest:
                setter = self.setter_of(verb, functions, result)
                subject = re.sub(r"^(Get|Compute)", "", verb)
                what = subject
                match = re.match(r"(?:Is|Are)(\w+?)(1|2)?Enabled$", verb)
                if match and setter is not None and setter.startswith("Enable"):
                    what = setter
                about = re.sub(r"^(Get|Ask) ", "", text)
                about = about[:1].upper() + about[1:]
                unit = re.search(r"\[[^\]]+\]", returned)
                if unit and unit[0] not in about:
                    about = re.sub(r"^([^.;]*)", lambda m: m[1] + " " + unit[0], about)
                self.out.append(f"\n    @property\n    def {snake(what)}(self) -> {self.type_of(result)}:\n{doc(about, 8)}")
                value = self.from_c(result, f"_call(_lib.{name}, self._id)")
                self.out.append(f"        return {value}\n")
                if setter is not None:
                    _, _, set_name, set_rest = functions[setter]
                    done.add(setter)
                    c = set_rest[0][0]
                    more = "".join(f", {DEFAULTS[p]}" for _, p in set_rest[1:])
                    self.out.append(f"\n    @{snake(what)}.setter\n    def {snake(what)}(self, value: {self.accepted(c)}) -> None:\n")
                    self.out.append(f"        _call(_lib.{set_name}, self._id, {self.to_c(c, 'value')}{more})\n")
            elif not any(self.setter_of(g, functions, functions[g][1]) == verb for g in functions if not functions[g][3]):
                args = "".join(
                    f", {snake(p)}: {self.accepted(t)}" + (f" = {DEFAULTS[p]}" if p in DEFAULTS else "") for t, p in rest
                )
                values = "".join(", " + self.to_c(t, snake(p)) for t, p in rest)
                returns = "None" if result == "void" else self.type_of(result)
                about = text
                notes = [f"{snake(p)}: {parameters[p]}" for _, p in rest if p in parameters]
                if notes:
                    about += ("" if about.endswith(".") else ".") + " " + "; ".join(notes)
                if returned:
                    about += ("" if about.endswith(".") else ".") + " Returns " + returned
                self.out.append(f"\n    def {snake(verb)}(self{args}) -> {returns}:\n{doc(about, 8)}")
                value = f"_call(_lib.{name}, self._id{values})"
                self.out.append(f"        {value}\n" if result == "void" else f"        return {self.from_c(result, value)}\n")

    def setter_of(self, verb, functions, result):
        """The function that sets what this one gets."""
        for pattern, form in [
            (r"Get(\w+)$", "Set{}"),
            (r"Is(\w+?)(1|2)?Enabled$", "Enable{}"),
            (r"Are(\w+)Enabled$", "Enable{}"),
            (r"Is(\w+)$", "Set{}"),
        ]:
            match = re.match(pattern, verb)
            if match:
                name = form.format("".join(g for g in match.groups() if g))
                if name == "EnableSleeping" or name in functions:
                    rest = functions[name][3] if name in functions else []
                    if rest and rest[0][0] == result and all(p in DEFAULTS for _, p in rest[1:]):
                        return name
        return None


def declarations(text):
    """What the header declares in single precision."""
    body = text[text.index("typedef float mvFloat;") : text.index('}  // extern "C"')]
    body = re.sub(r"/\*.*?\*/|//[^\n]*", "", body, flags=re.S)
    body = re.sub(r"#endif|#ifdef __cplusplus\s+extern \"C\" \{\s+#endif|\bMV_API\b", "", body)
    body = re.sub(r'extern "C" \{|#ifdef __cplusplus', "", body)
    lines = [line.rstrip() for line in body.splitlines()]
    return "\n".join(line for line in lines if line) + "\n"


def main():
    header = HEADER.read_text()
    classes = Writer(Header(header)).write()
    classes = classes.replace("_vector_of(", "np.array(list(").replace("linearMomentum),", "linearMomentum)),")
    classes = classes.replace("angularMomentum),", "angularMomentum)),")
    for target, text in ((CLASSES, classes), (DECLARATIONS, declarations(header))):
        if "--check" not in sys.argv[1:]:
            target.write_text(text)
        elif not target.exists() or target.read_text() != text:
            sys.exit(f"{target.name} is stale: run `python bindings/python/generate.py`")


if __name__ == "__main__":
    main()
