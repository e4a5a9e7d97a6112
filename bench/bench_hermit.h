#pragma once

namespace partonomy::bench {

/// Prints how long furniture takes from the ontology's file to the saved tree, beside a warm HermiT in one process that
/// classifies the same product of features; says so when HermiT or Java is absent.
void bench_hermit();

}  // namespace partonomy::bench
