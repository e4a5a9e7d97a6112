#pragma once

namespace partonomy::bench {

/// Prints the time of TF for each relation of core.ttl on `count` regions, and that of T asked of all of them.
void print_relations(int count);

}  // namespace partonomy::bench
