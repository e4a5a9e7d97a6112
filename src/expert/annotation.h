#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace partonomy {

/// One named part of an annotated object.
struct AnnotatedPart {
    int id = 0;                                   ///< 1, 2, … in the order of `Annotation::parts`
    std::vector<std::string> concepts;            ///< local names, most specific first; empty when no concept is known
    std::vector<std::int32_t> triangles;          ///< of the loaded mesh, ascending
    std::int64_t faces = 0;                       ///< input faces that carry the part's label
    double area = 0;                              ///< square metres, or squared file units when the unit is unknown
    double score = 0;                             ///< [0, 1]
    std::map<std::string, std::string> features;  ///< range concept -> value, for what is known or inferred
    std::map<std::string, double> measurements;   ///< metres and degrees
    std::string color;                            ///< "#rrggbb" to draw it in; empty: choose one
    std::vector<std::string> names = {};          ///< the most specific of `concepts` that are no diagnoses
    /// Of a part without a name: what it came nearest to, and the answers that refuse it that, in words.
    std::string nearest = {};
    std::vector<std::string> refusals = {};
    bool is_piece = false;  ///< only helpers hold of it: `concepts` are of the whole it belongs to
};

/// A part made of parts, of a layer between parts and object.
struct AnnotatedComposite {
    int id = 0;                           ///< 1, 2, … in the order of `Annotation::composites`
    std::vector<std::string> concepts;    ///< local names, most specific first; at least one
    std::vector<int> parts;               ///< ids of the parts that it consists of, ascending
    std::vector<int> composites;          ///< ids of the composite parts of lower layers within it, ascending
    std::vector<std::string> names = {};  ///< as of a part
};

/// One question that the expert system asked, as in the paper's Fig. 13.
struct TraceEntry {
    std::string kind;                        ///< "SF", "SI", "T", "TF", or "known": former answers decided it
    std::string question;                    ///< "find all Board in the mesh", "is part 2 Vertical"
    std::string region;                      ///< what it was asked about: "mesh", "rest", "part 3"
    std::string answer;                      ///< "4 regions", "yes", "no"
    double score = 0;                        ///< of the answer
    std::vector<std::string> inferred = {};  ///< what followed from it: "part 3 is a Leg", "the object is a Chair"
    double ms = 0;
    std::string measured = {};  ///< of an `is a`: "l0/l1 1.02 (wanted <= 2)"; empty in objects of very many parts
};

/// Why the object is incompatible, and the cheapest way out.
struct Diagnosis {
    std::string concept_name;  ///< local name of the incompatible concept, or "contradiction"
    std::string comment = {};  ///< what the expert says of it (rdfs:comment)
    std::vector<int> parts;    ///< ids to blame
    /// Of the minimal explanation, in words: first those that this rule rests on, then `answers_of_given`, by which the
    /// object, or the part, is what the rule is a case of.
    std::vector<std::string> answers;
    std::size_t answers_of_given = 0;
    std::vector<std::string> given = {};  ///< local names of what it is a case of: "Wheelbarrow"
    /// Of the minimal explanation: Manchester syntax, file and line; the definition first, then those of its names.
    std::vector<std::string> axioms;
    /// Where the rule misses parts of a name: which parts come nearest to it, and the answers that refuse it, in words.
    struct NearPart {
        int part = 0;  ///< id
        std::string concept_name;
        std::vector<std::string> refused_by;
    };
    std::vector<NearPart> nearest = {};
    std::vector<std::string> corrections;  ///< in words, cheapest first; one may change several answers
    /// The same as answers to turn round (indices into Annotation::answers), or as parts to add or to take away; and
    /// what that costs.
    struct Change {
        std::vector<std::size_t> answers;
        double cost = 0;
        std::string part = {};               ///< name of the parts to add or take away; empty: answers are turned
        int count = 0;                       ///< of them to add; negative: to take away
        std::vector<std::string> lost = {};  ///< local names of what the object is and would not be then
    };
    std::vector<Change> changes = {};
    /// How many parts of a name its definition asks for.
    struct Count {
        std::string part;
        std::optional<std::uint32_t> at_least, at_most;
        std::vector<std::vector<int>> bearers = {};  ///< ids: of each part that has the name, or of its pieces
    };
    std::vector<Count> counts = {};
    bool counts_are_all = true;  ///< the definition says nothing else of parts
};

/// A class that an object which is not recognised comes near to.
struct NearClass {
    std::string concept_name;           ///< local name
    std::vector<std::string> lacks;     ///< "1 Seat", "2 Leg (part 3 may be one)"
    std::vector<std::string> too_many;  ///< "1 Backrest"
};

/// One answer that was learned, by names that outlive the program.
struct LearnedAnswer {
    int part = 0;         ///< id
    std::string feature;  ///< IRI of the range concept or measured property; a relation as written
    std::string value;    ///< word of the value: "Board", "<= 0.55"
    bool yes = true;
    double score = 1;           ///< [0.5, 1]
    bool accepted = false;      ///< a person said so
    std::string measured = {};  ///< what it rests on, as the trace words it; empty in objects of very many parts
    double off = 0;             ///< how far that is from where the answer would turn (in_numbers.h)
};

/// All that is known about one object at the end; every output file is written from this one value.
struct Annotation {
    std::string mesh_file, mesh_sha256;
    std::int64_t mesh_faces = 0;          ///< input faces
    std::vector<std::string> mesh_notes;  ///< what cleaning found
    std::string ontology_iri, ontology_file, ontology_sha256;
    std::string up, unit;                           ///< as used: "z", "m"; unit "unknown" when not known
    double up_confidence = 1, unit_confidence = 1;  ///< [0, 1]; 1 when the user told it
    std::string strategy;
    std::vector<std::string> classes;      ///< most specific object classes, incompatible ones included
    std::vector<std::string> all_classes;  ///< every class that holds
    std::vector<std::string> perhaps;      ///< incompatible concepts that hold if the assumed names of parts are right
    std::vector<NearClass> nearest;  ///< where no class holds that is no diagnosis: the likest first, at most three
    bool consistent = true;
    double score = 0;
    std::vector<AnnotatedPart> parts;
    std::vector<AnnotatedComposite> composites;  ///< lower layers first
    std::vector<std::int32_t> part_of_triangle;  ///< #T index into `parts`, or -1
    std::vector<std::string> labels;             ///< one per input face: concept, or "-"
    std::vector<int> part_of_face;               ///< one per input face: part id, 0 for none
    std::vector<float> score_of_face;            ///< one per input face
    std::map<std::string, int> questions;        ///< "SF", "SI", "T", "TF" -> algorithms asked; "read_off"
    std::vector<TraceEntry> trace;
    std::vector<LearnedAnswer> answers;
    bool is_complete = false;                    ///< there are no other parts
    std::vector<std::pair<int, int>> connected;  ///< ids of parts that touch, where composite parts asked for it
    std::vector<Diagnosis> diagnosis;
    std::vector<std::string> open_questions;  ///< what stayed unanswered, and why
    std::vector<std::pair<std::string, double>> timings_ms;
};

}  // namespace partonomy
