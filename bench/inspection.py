"""Judges brackets, sound ones and ones with a defect: python3 bench/inspection.py BUILD [NUMBER [FIRST_SEED]]

Makes NUMBER (200) of each with BUILD/examples/make_brackets, runs BUILD/partonomy annotate on each, and prints how many
sound ones passed (exit code 0, a Bracket), in how many of the others the defect was named with a region (exit code 2),
how many diagnoses there were besides, and the time a part.
"""

import collections
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

build, *numbers = sys.argv[1:]
ontology = pathlib.Path(__file__).resolve().parent.parent / "ontologies" / "inspection.omn"
right, all_of, besides, seconds = collections.Counter(), collections.Counter(), collections.Counter(), []
with tempfile.TemporaryDirectory() as folder:
    subprocess.run([f"{build}/examples/make_brackets", folder, *numbers], check=True)
    for mesh in sorted(pathlib.Path(folder).glob("*.off")):
        defect = mesh.stem.split("-")[2] if mesh.stem.startswith("bad") else "sound"
        start = time.time()
        run = subprocess.run([f"{build}/partonomy", "annotate", mesh, "--ontology", ontology, "--up", "z", "-o",
                              f"{folder}/out"], capture_output=True)
        seconds.append(time.time() - start)
        annotation = json.loads((pathlib.Path(folder) / "out" / mesh.stem / "annotation.json").read_text())
        named = {each["concept"] for each in annotation["diagnosis"] if each["parts"]}
        if defect == "sound":
            is_right = run.returncode == 0 and annotation["object"]["classes"] == ["Bracket"] and not named
        else:
            is_right = run.returncode == 2 and defect in named
        if named - {defect}:
            besides[defect] += 1
        all_of[defect] += 1
        right[defect] += is_right
        if not is_right or named - {defect}:
            print(f"{mesh.stem}: exit code {run.returncode}, {sorted(named)}, {annotation['object']['classes']}")
for defect in all_of:
    print(f"{defect:16} {right[defect]} of {all_of[defect]} right, another diagnosis besides in {besides[defect]}")
print(f"seconds a part: median {statistics.median(seconds):.2f}, longest {max(seconds):.2f}")
