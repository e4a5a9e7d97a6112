#pragma once

namespace partonomy::bench {

/// Prints how compiling and counting configurations grows with the number of concepts, beside BuDDy in the same run.
void bench_knowledge();

}  // namespace partonomy::bench
