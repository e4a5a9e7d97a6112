#!/usr/bin/env python3
"""Asks HermiT for the class hierarchy of the ontologies given, merged: a second opinion on ours.

    hermit_hierarchy.py core.ttl furniture.ttl

Prints JSON: {"consistent": bool, "hierarchy": [[sub, super], ...], "unsatisfiable": [...]} with local names; the
hierarchy is its full transitive closure among named classes, without owl:Thing, owl:Nothing and pairs of a class with
itself. Needs the Python packages owlready2 (which brings HermiT) and rdflib, and java.
"""

import io
import json
import sys

import owlready2
import rdflib


def merged(paths):
    """The bytes of all files as one N-Triples document, which owlready2 reads; imports are dropped, since merging resolved them."""
    graph = rdflib.Graph()
    for path in paths:
        graph.parse(path, format="xml" if path.endswith((".owl", ".rdf", ".xml")) else "turtle")
    graph.remove((None, rdflib.OWL.imports, None))
    # owlready2 takes blank nodes for class expressions only when they say that they are classes.
    for word in (rdflib.OWL.intersectionOf, rdflib.OWL.unionOf, rdflib.OWL.complementOf):
        for node in list(graph.subjects(word)):
            if isinstance(node, rdflib.BNode):
                graph.add((node, rdflib.RDF.type, rdflib.OWL.Class))
    return graph.serialize(format="nt", encoding="utf-8")


def main():
    world = owlready2.World()
    ontology = world.get_ontology("http://merged/").load(fileobj=io.BytesIO(merged(sys.argv[1:])))
    answer = {"consistent": True, "hierarchy": [], "unsatisfiable": []}
    try:
        with ontology:
            owlready2.sync_reasoner_hermit(world, debug=0)
    except owlready2.OwlReadyInconsistentOntologyError:
        answer["consistent"] = False
        print(json.dumps(answer, indent=1))
        return
    broken = set(world.inconsistent_classes())
    classes = [c for c in world.classes() if c not in (owlready2.Thing, owlready2.Nothing)]
    answer["unsatisfiable"] = sorted(c.name for c in classes if c in broken)
    pairs = set()
    for c in classes:
        if c in broken:
            continue
        above = {s for s in c.ancestors() if isinstance(s, owlready2.ThingClass)}
        pairs |= {(c.name, s.name) for s in above if s not in (c, owlready2.Thing)}
    answer["hierarchy"] = sorted(list(pair) for pair in pairs)
    print(json.dumps(answer, indent=1))


if __name__ == "__main__":
    main()
