#pragma once

namespace partonomy::knowledge {

/// How the next question is chosen.
enum class SplitCriterion {
    dichotomy,      ///< splits the configurations most evenly (paper §3.3.1)
    entropy,        ///< most information about the wanted labels
    gain_per_cost,  ///< most information about the wanted labels per unit of cost
};

}  // namespace partonomy::knowledge
