"""The paper's Table 3 for every domain: python3 bench/planner.py BUILD

Makes the example meshes of each domain with BUILD/examples, annotates them with each strategy, and prints the questions
asked and what they cost in sum (costs of core:cost and `partonomy catalogue`; a TF is four T), as the table of
docs/domains.md; and in how many meshes a strategy ends with other classes than the expert one.
"""

import collections
import json
import pathlib
import re
import subprocess
import sys
import tempfile

build = pathlib.Path(sys.argv[1]).resolve()
ontologies = pathlib.Path(__file__).resolve().parent.parent / "ontologies"
strategies = ["expert", "naive", "segment-then-identify"]


def run(*words):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True)


def question_costs(names):
    """Cost by wording; an ontology's blocks are parted by blank lines, one-line classes by line ends."""
    costs = {}
    for name in names:
        for block in re.split(r"\n\s*\n|\n(?=core:\w+ a owl:Class ; rdfs:label)", (ontologies / name).read_text()):
            relation = re.search(r"core:Relation\b", block) is not None
            for wording in re.findall(r'core:question "([^"]*)"', block):
                cost = re.search(r"core:cost (\d+)", block)
                costs[wording] = float(cost[1]) if cost else (2.0 if relation else 1.0)
    return costs


def find_all_costs(ontology):
    listed = json.loads(run(build / "partonomy", "catalogue", ontology, "--json").stdout)["algorithms"]
    return {each["concept"]: each["cost"] for each in listed if each["signature"] == "SF"}


def cost_of(entry, costs, find_all):
    kind, text = entry["kind"], entry["question"]
    if kind == "SF":
        return find_all[re.match(r"find all (\S+)", text)[1]]
    wording = max((w for w in costs if w in text), key=len, default=None)
    return costs.get(wording, 1.0) * (4 if kind == "TF" else 1)


def measure(domain, ontology, imports, meshes, options):
    path = ontologies / ontology
    costs, find_all = question_costs(["core.ttl", ontology, *imports]), find_all_costs(path)
    classes = {}
    for strategy in strategies:
        counts, cost, others = collections.Counter(), 0.0, 0
        for mesh in meshes:
            with tempfile.TemporaryDirectory() as out:
                done = run(build / "partonomy", "annotate", mesh, "--ontology", path, "--strategy", strategy, "-o", out,
                           "--format", "json", *options)
                if done.returncode == 1:
                    sys.exit(done.stderr)
                annotation = json.loads((pathlib.Path(out) / mesh.stem / "annotation.json").read_text())
            counts.update(annotation["questions"])
            cost += sum(cost_of(e, costs, find_all) for e in annotation["trace"] if e["kind"] in ("SF", "SI", "T", "TF"))
            told = sorted(annotation["object"]["classes"])
            others += classes.setdefault(mesh, told) != told
        row = " | ".join(str(counts[kind]) for kind in ("SF", "SI", "T", "TF"))
        print(f"| {domain} | {len(meshes)} | {strategy} | {row} | {cost:,.0f} | {others} |", flush=True)


with tempfile.TemporaryDirectory() as folder:
    root = pathlib.Path(folder)
    run(build / "examples/make_objects", root / "objects")
    run(build / "examples/make_street", root / "street", "street", "seed=1", "triangles=20000")
    run(build / "examples/make_brackets", root / "brackets", 10)
    run(build / "examples/make_signs", root / "signs")
    run(build / "examples/make_lamps", root / "lamps")

    def made(name, *endings):
        return sorted(mesh for ending in endings for mesh in (root / name).rglob("*" + ending))

    objects = made("objects", ".off")
    paper = [mesh for mesh in objects if not mesh.name.startswith("headrest")]
    print("| domain | meshes | strategy | SF | SI | T | TF | cost | other classes |\n|---|---|---|---|---|---|---|---|---|")
    measure("furniture", "furniture.ttl", [], paper, [])
    measure("headrest", "furniture-headrest.omn", ["furniture.ttl"], objects, [])
    measure("furniture with relations", "furniture-relations.omn", ["furniture.ttl"], paper, [])
    measure("street", "street.ttl", [], made("street", ".off"), [])
    measure("inspection", "inspection.omn", [], made("brackets", ".off"), ["--up", "z"])
    measure("signs", "traffic-signs.omn", [], made("signs", ".glb"), [])
    measure("lamps", "lamps.omn", [], made("lamps", ".off"), [])
