#pragma once

namespace partonomy::bench {

/// Prints how long furniture takes from the ontology's file to the saved tree, beside a warm HermiT in one process that
/// classifies the same product of features; says so when HermiT or Java is absent. The
/// product of furniture.ttl is for HermiT `with_all` only: it takes it minutes.
void bench_hermit(bool with_all);

}  // namespace partonomy::bench
