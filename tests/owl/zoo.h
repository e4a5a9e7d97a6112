#pragma once

// One ontology with every kind of class expression, data range, axiom and rule, as files in five syntaxes under zoo/.
// All but zoo.ttl and zoo.rdf are laid out as the OWL API, and so Protégé, writes them.

#include <string>

#include "base/files.h"

namespace partonomy::owl::zoo {

/// The text of the zoo in a syntax: "ttl", "rdf", "owx", "ofn" or "omn".
inline std::string text(const std::string& syntax) {
    return read_file(PARTONOMY_SOURCE_DIR "/tests/owl/zoo/zoo." + syntax);
}

/// Line and wording of each axiom of zoo.ttl.
inline const char* const axioms[] = {
    "15 A SubClassOf: B",
    "16 A SubClassOf: B and C and (C or D)",
    "17 A SubClassOf: not C",
    "18 A SubClassOf: {x, y}",
    "19 A SubClassOf: p some B",
    "20 A SubClassOf: p only (not D)",
    "21 A SubClassOf: p value x",
    "22 A SubClassOf: p Self",
    "23 A SubClassOf: p min 2 Thing",
    "24 A SubClassOf: p max 3 C",
    "25 A SubClassOf: inverse (p) exactly 1 D",
    "26 A SubClassOf: d some xsd:double[>= 0.4, <= 0.48]",
    "28 A SubClassOf: d only {1, 2}",
    "29 A SubClassOf: d value \"red\"@en",
    "30 A SubClassOf: d min 1 xsd:string",
    "31 A SubClassOf: d max 4 rdfs:Literal",
    "32 A SubClassOf: d exactly 5 rdfs:Literal",
    "33 B EquivalentTo: C",
    "34 B DisjointWith: D",
    "35 D DisjointUnionOf: B, C",
    "36 DisjointClasses: A, B, C",
    "37 p SubPropertyOf: q",
    "38 r SubPropertyChain: p o inverse (q)",
    "39 p EquivalentTo: q",
    "40 p InverseOf: r",
    "41 p DisjointWith: r",
    "42 DisjointProperties: p, q, r",
    "43 p Domain: A",
    "44 p Range: B",
    "45 p Characteristics: Functional",
    "46 p Characteristics: InverseFunctional",
    "47 p Characteristics: Symmetric",
    "48 p Characteristics: Asymmetric",
    "49 p Characteristics: Transitive",
    "50 p Characteristics: Reflexive",
    "51 p Characteristics: Irreflexive",
    "52 d SubPropertyOf: e",
    "53 d EquivalentTo: e",
    "54 d DisjointWith: e",
    "55 d Domain: A",
    "56 d Range: xsd:double",
    "57 d Characteristics: Functional",
    "58 x Types: A",
    "59 x Facts: p y",
    "60 x Facts: not p z",
    "61 x Facts: d 0.5",
    "62 x SameAs: y",
    "63 x DifferentFrom: z",
    "64 DifferentIndividuals: x, y, z",
    "67 B SubClassOf: A",
    "69 q some Thing SubClassOf: C",
    "70 C EquivalentTo: A or B",
    "71 A HasKey: p, d",
    "72 Datatype: small EquivalentTo: xsd:double[< 0.1]",
    "73 e Range: (small and not xsd:integer and (xsd:double or {\"a\", \"b\"@en, 3}))",
    "75 e Range: xsd:string[maxLength 5, pattern \"a[\\\"\\\\\\\\]*\"]",
    "76 x Facts: not d 7",
    "77 x Facts: p _:someone",
    "78 _:someone Types: B",
    "79 _:someone Facts: d true",
    "80 inverse (p) Domain: D",
    "81 inverse (q) Characteristics: Functional",
    "82 q SubPropertyOf: inverse (r)",
    "84 A(?u), p(?u, ?v), d(?u, ?w), lessThan(?w, 5), add(?w, 2, 3), xsd:double(?w), differentFrom(?u, x) -> "
    "sameAs(?u, "
    "?v), (p some B)(y)",
    "94 B SubClassOf: q some B",
};

}  // namespace partonomy::owl::zoo
