#!/usr/bin/env python3
"""The furniture of Debian's package sweethome3d-furniture, through the whole program.

    bench/real_models.py extract FOLDER [--every N]       each model as FOLDER/<library>-<name>.obj, y up, in metres
    bench/real_models.py run PROGRAM FOLDER [--classes CSV] [--jobs N] [--limit SECONDS]
                                                          annotates them; prints failures, times, a confusion table

The package's own catalogue tells each model's file, how it is turned and its size; models are turned and stretched to
that size, as Sweet Home 3D does. CSV has the columns class and model (library/path in the package)."""

import argparse
import collections
import concurrent.futures
import csv
import json
import os
import pathlib
import re
import subprocess
import sys
import time
import zipfile

LIBRARIES = pathlib.Path("/usr/share/sweethome3d/furniture")
# The classes of furniture.ttl, most telling first, and the words of the CSV for them.
WORDS = [("Bed", "bed"), ("Couch", "sofa"), ("Chair", "chair"), ("Stool", "chair"), ("Bench", "bench"),
         ("Shelf", "shelf"), ("Table", "table")]


def catalogue(library):
    """Dictionaries with the properties of each model of a library, in the order of the catalogue."""
    entries = collections.defaultdict(dict)
    for line in library.read("PluginFurnitureCatalog.properties").decode("latin-1").splitlines():
        found = re.match(r"\s*(\w+)#(\d+)\s*=\s*(.*)", line)
        if found:
            entries[int(found[2])][found[1]] = found[3].strip()
    return [entries[number] for number in sorted(entries) if "model" in entries[number]]


def placed(obj, entry):
    """The OBJ text turned and stretched to the catalogue's size, in metres: vertices, faces and groups only."""
    turn = [float(x) for x in entry.get("modelRotation", "1 0 0 0 1 0 0 0 1").split()]
    lines = [line.strip() for line in obj.replace("\\\n", " ").replace("\\\r\n", " ").splitlines()]
    points = []
    for line in lines:
        if line.startswith("v "):
            p = [float(x) for x in line.split()[1:4]]
            points.append([sum(turn[3 * r + c] * p[c] for c in range(3)) for r in range(3)])
    used = set()
    for line in lines:
        if line.startswith("f "):
            for corner in line.split()[1:]:
                index = int(corner.split("/")[0])
                used.add(index - 1 if index > 0 else len(points) + index)
    if not used:
        return None
    low = [min(points[i][axis] for i in used) for axis in range(3)]
    high = [max(points[i][axis] for i in used) for axis in range(3)]
    size = [float(entry[name]) / 100 for name in ("width", "height", "depth")]
    stretch = [size[a] / (high[a] - low[a]) if high[a] > low[a] else 1 for a in range(3)]
    out = []
    number = 0
    for line in lines:
        if line.startswith("v "):
            p = points[number]
            number += 1
            out.append("v " + " ".join(f"{(p[a] - low[a]) * stretch[a]:.7g}" for a in range(3)))
        elif line.startswith("f "):
            out.append("f " + " ".join(corner.split("/")[0] for corner in line.split()[1:]))
        elif line.startswith(("g ", "usemtl ", "o ")):
            out.append(line)
    return "\n".join(out) + "\n"


def extract(arguments):
    folder = pathlib.Path(arguments.folder)
    folder.mkdir(parents=True, exist_ok=True)
    if not LIBRARIES.is_dir():
        sys.exit(f"{LIBRARIES}: no such folder; install the package sweethome3d-furniture")
    number = 0
    index = {}
    for path in sorted(LIBRARIES.glob("*.sh3f")):
        with zipfile.ZipFile(path) as library:
            for entry in catalogue(library):
                number += 1
                if (number - 1) % arguments.every:
                    continue
                model = entry["model"].lstrip("/")
                text = placed(library.read(model).decode("latin-1"), entry)
                name = f"{path.stem}-{pathlib.Path(model).stem}"
                while name in index:
                    name += "+"
                index[name] = f"{path.stem}/{model}"
                (folder / f"{name}.obj").write_text(text if text else "")
    (folder / "index.json").write_text(json.dumps(index, indent=1))
    print(f"{len(index)} models in {folder}")


def annotate(arguments, name):
    """(name, seconds, exit code or None after the limit, last line of standard error, classes)"""
    out = pathlib.Path(arguments.folder) / "out"
    command = [arguments.program, "annotate", f"{arguments.folder}/{name}.obj", "-o", str(out), "--up",
               arguments.up, "--unit", arguments.unit, "--ontology", arguments.ontology, "--threads", "1",
               "--format", "json,labels", "--quiet"]
    start = time.monotonic()
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=arguments.limit)
    except subprocess.TimeoutExpired:
        return name, time.monotonic() - start, None, "", []
    seconds = time.monotonic() - start
    classes = []
    if done.returncode in (0, 2):
        classes = json.loads((out / name / "annotation.json").read_text())["object"]["all_classes"]
    return name, seconds, done.returncode, (done.stderr.strip().splitlines() or [""])[-1], classes


def word_for(classes):
    return next((word for concept, word in WORDS if concept in classes), "-")


def run(arguments):
    index = json.loads((pathlib.Path(arguments.folder) / "index.json").read_text())
    truth = {}
    if arguments.classes:
        with open(arguments.classes, newline="") as file:
            truth = {row["model"]: row["class"] for row in csv.DictReader(file)}
    names = [n for n in index if not arguments.only_classes or index[n] in truth]
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        results = list(pool.map(lambda name: annotate(arguments, name), names))
    table = collections.Counter()
    bad = 0
    for name, seconds, code, error, classes in results:
        if code not in (0, 2):
            bad += 1
            what = "no answer in time" if code is None else f"killed by signal {-code}" if code < 0 else error
            print(f"{name}: {what} ({seconds:.1f} s)")
        said = word_for(classes)
        if index[name] in truth:
            table[truth[index[name]], said] += 1
            if arguments.verbose:
                print(f"{'right' if said == truth[index[name]] else 'WRONG'} {name}: {truth[index[name]]}, "
                      f"said {said} ({', '.join(classes)})")
        elif arguments.verbose:
            print(f"other {name}: said {said} ({', '.join(classes)})")
    times = sorted(r[1] for r in results)
    print(f"{len(results)} models, {bad} without an annotation; seconds a model: median {times[len(times) // 2]:.3f}, "
          f"longest {times[-1]:.2f}")
    print("said by the program: " +
          ", ".join(f"{word} {count}" for word, count in
                    sorted(collections.Counter(word_for(r[4]) for r in results).items())))
    if table:
        words = sorted({w for _, w in WORDS})
        print("\ntruth \\ said " + "".join(f"{w:>7}" for w in [*words, "-"]))
        for t in words:
            print(f"{t:<13}" + "".join(f"{table[t, w]:>7}" for w in [*words, "-"]))
        right = sum(table[w, w] for w in words)
        print(f"right: {right} of {sum(table.values())} ({100 * right / sum(table.values()):.1f} %)")
    return 1 if bad else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)
    one = commands.add_parser("extract")
    one.add_argument("folder")
    one.add_argument("--every", type=int, default=1, help="only each N-th model")
    one.set_defaults(work=extract)
    two = commands.add_parser("run")
    two.add_argument("program")
    two.add_argument("folder")
    two.add_argument("--classes", help="CSV with the columns class, model")
    two.add_argument("--only-classes", action="store_true", help="only the models in the CSV")
    two.add_argument("--jobs", type=int, default=os.cpu_count())
    two.add_argument("--limit", type=float, default=10, help="seconds a model may take")
    two.add_argument("--verbose", action="store_true")
    two.add_argument("--ontology", default=str(pathlib.Path(__file__).parent.parent / "ontologies/furniture.ttl"))
    two.add_argument("--up", default="y")
    two.add_argument("--unit", default="m")
    two.set_defaults(work=run)
    arguments = parser.parse_args()
    sys.exit(arguments.work(arguments))


if __name__ == "__main__":
    main()
